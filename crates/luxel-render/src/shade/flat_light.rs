//! Flat shading: the one light of a polygon.

use super::lit_triangle::{LitTriangle, entry_of, place_of_whole};
use crate::context::{AttributeMask, ShadingContext};
use crate::material::{Corner, light_at};
use luxel_lighting::Silent;
use luxel_visibility::{TriangleId, TriangleOf};

/// The lights of the triangles that a thread has seen last, by their ids.
pub(crate) struct FlatLights {
    /// Empty before the first is seen.
    entries: Vec<(TriangleId, [f32; 3])>,
}

/// Entries of the cache: 16 KiB, half of a core's first-level cache.
const ENTRIES: usize = 1024;

impl FlatLights {
    pub(crate) fn new() -> Self {
        Self { entries: Vec::new() }
    }

    /// Forgets the triangles of another frame.
    pub(crate) fn begin_frame(&mut self) {
        self.entries.clear();
    }

    /// The light of an id's triangle; black for [`TriangleId::NONE`].
    #[inline]
    pub(crate) fn get(&mut self, scene: &ShadingContext<'_>, id: TriangleId) -> [f32; 3] {
        if self.entries.is_empty() {
            self.entries.resize(ENTRIES, (TriangleId::NONE, [0.0; 3]));
        }
        let entry = &mut self.entries[entry_of(id, ENTRIES)];
        if entry.0 != id {
            let Some(of) = scene.frame.triangle(id) else { return [0.0; 3] };
            *entry = (id, flat_light(scene, id, of));
        }
        entry.1
    }
}

/// The light that leaves a triangle's polygon, clamped if the view says so.
fn flat_light(scene: &ShadingContext<'_>, id: TriangleId, of: TriangleOf) -> [f32; 3] {
    let mesh = scene.frame.instances()[of.instance].mesh;
    let (number, has) = (mesh.parts[of.part].material.0, AttributeMask::of_mesh(mesh));
    let is_colored =
        has.has(AttributeMask::COLORS) && scene.scene.materials[number as usize].vertex_colors;
    // The corners matter to textures and vertex colours alone.
    let whole = match scene.uniform[number as usize] {
        Some(_) if !is_colored => {
            let [position, normal] = place_of_whole(scene, of);
            let (tangent, uv, color, light) = ([0.0; 4], [[0.0; 2]; 2], [1.0; 4], [0.0; 3]);
            Corner { position, normal, tangent, uv, color, light }
        }
        _ => LitTriangle::new(scene, id, of).whole(scene),
    };
    light_at(scene, &whole, has, number, &mut Silent)
}
