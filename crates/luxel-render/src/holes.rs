//! Where a covered sample is nevertheless not hit: texels cut away, surfaces that are wholly
//! transparent, the space between wires.

use crate::edges::{EdgeFlags, edge_distance};
use crate::view::Edges;
use luxel_math::SUBPIXELS;
use luxel_scene::{AlphaMode, Scene};
use luxel_visibility::{Frame, TriangleId, TriangleOf};

/// Answers for one frame.
pub(crate) struct Holes<'a> {
    pub(crate) scene: &'a Scene,
    /// Wires, if only they are drawn.
    pub(crate) wires: Option<Edges>,
    /// The edges of polygons of each instance, if wires are drawn; points and lines have none.
    pub(crate) edge_flags: &'a [Option<&'a EdgeFlags>],
}

impl Holes<'_> {
    /// Whether the sample at `position`, in steps of 1/256 pixel, goes through.
    pub(crate) fn hole(&self, frame: &Frame<'_>, id: TriangleId, position: [i32; 2]) -> bool {
        let Some(of) = frame.triangle(id) else { return true };
        if let Some(wires) = self.wires
            && self.beside_wires(frame, of, position, wires.width)
        {
            return true;
        }
        let mesh = frame.instances()[of.instance].mesh;
        let material = &self.scene.materials[mesh.parts[of.part].material.index()];
        if material.alpha_mode == AlphaMode::Opaque {
            return false;
        }
        let barycentric = frame.forms(of).barycentric(frame.rays(), position);
        self.scene.is_hole(mesh, of.triangle, barycentric, material)
    }

    /// Whether a sample is farther than half a wire's width from every edge of its polygon.
    fn beside_wires(
        &self,
        frame: &Frame<'_>,
        of: TriangleOf,
        [x, y]: [i32; 2],
        width: f32,
    ) -> bool {
        let pixels = |steps: i32| f64::from(steps) / f64::from(SUBPIXELS);
        let Some(flags) = self.edge_flags[of.instance] else { return false };
        edge_distance(&frame.forms(of), flags.of(of.triangle), pixels(x), pixels(y)) > width * 0.5
    }
}
