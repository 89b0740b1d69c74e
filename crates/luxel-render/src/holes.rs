//! Where a covered sample is nevertheless not hit: texels cut away, surfaces that are wholly
//! transparent, the space between wires.

use crate::edges::{EdgeFlags, edge_distance};
use crate::view::Edges;
use luxel_math::SUBPIXELS;
use luxel_scene::{AlphaMode, Scene, SceneMaterial, TextureUse};
use luxel_visibility::{BLOCK, Frame, TriangleId, TriangleOf};

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
        match material.alpha_mode {
            AlphaMode::Opaque => false,
            AlphaMode::Mask { cutoff } => self.alpha(frame, of, position, material) < cutoff,
            AlphaMode::Blend => self.alpha(frame, of, position, material) <= 0.0,
        }
    }

    /// The alpha of a surface at a sample, by the textures' finest level.
    fn alpha(
        &self,
        frame: &Frame<'_>,
        of: TriangleOf,
        position: [i32; 2],
        material: &SceneMaterial,
    ) -> f32 {
        let mesh = frame.instances()[of.instance].mesh;
        let corners = mesh.attribute_corners()[of.triangle as usize].map(|corner| corner as usize);
        let weights = frame.forms(of).barycentric(frame.rays(), position);
        let mix = |at: [f32; 3]| at[0] * weights[0] + at[1] * weights[1] + at[2] * weights[2];
        let sample = |used: TextureUse| {
            let uvs = &mesh.uvs[usize::from(used.uv_set & 1)];
            let [u, v] = [0, 1]
                .map(|axis| mix(corners.map(|corner| uvs.get(corner).map_or(0.0, |uv| uv[axis]))));
            let [u, v] = transformed(&used, [u, v]);
            self.scene.textures[used.texture.index()].sample_base(u, v)
        };
        let mut alpha = material.opacity;
        if !mesh.colors.is_empty() {
            alpha *= mix(corners.map(|corner| mesh.colors[corner][3]));
        }
        if let Some(used) = material.base_color {
            alpha *= sample(used)[3];
        }
        if let Some(used) = material.opacity_map {
            alpha *= sample(used)[0];
        }
        alpha
    }

    /// Whether a sample is farther than half a wire's width from every edge of its polygon.
    fn beside_wires(
        &self,
        frame: &Frame<'_>,
        of: TriangleOf,
        [x, y]: [i32; 2],
        width: f32,
    ) -> bool {
        let side = BLOCK * SUBPIXELS;
        let (block_x, block_y) = (x.div_euclid(side) * BLOCK, y.div_euclid(side) * BLOCK);
        let inside = |steps: i32| steps.rem_euclid(side) as f32 / SUBPIXELS as f32;
        let Some(flags) = self.edge_flags[of.instance] else { return false };
        let forms = frame.forms(of).about(block_x, block_y);
        edge_distance(&forms, flags.of(of.triangle), inside(x), inside(y)) > width * 0.5
    }
}

/// Texture coordinates after the use's own transform.
pub(crate) fn transformed(used: &TextureUse, [u, v]: [f32; 2]) -> [f32; 2] {
    let m = &used.transform;
    [m[0] * u + m[1] * v + m[2], m[3] * u + m[4] * v + m[5]]
}
