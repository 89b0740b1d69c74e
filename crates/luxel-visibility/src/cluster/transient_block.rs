//! Blocks of clusters that are drawn for one frame: made from the mesh where they are drawn, not kept.
//!
//! Corners that triangles share aren't looked for: finding them takes longer than what they save.
//! Sixteen triangles have three groups of vertices, their first corners, second ones and third ones.

use super::block::{Block, GROUP_WORDS, Numbers};
use luxel_math::LANES;
use luxel_scene::Mesh;

/// Most triangles of such a cluster: five times sixteen, as corner numbers take eight bits.
pub(crate) const TRANSIENT_TRIANGLES: usize = 80;
const CHUNKS: usize = TRANSIENT_TRIANGLES / LANES;

/// Room for a block.
pub(crate) struct TransientBlock([[[u32; GROUP_WORDS]; 3]; CHUNKS]);

/// The corner numbers of each triangle, the same in all such clusters.
const TRIANGLES: [u32; TRANSIENT_TRIANGLES] = {
    let mut words = [0; TRANSIENT_TRIANGLES];
    let mut slot = 0;
    while slot < TRANSIENT_TRIANGLES {
        let first = (slot / LANES * 3 * LANES + slot % LANES) as u32;
        let (second, third) = (first + LANES as u32, first + 2 * LANES as u32);
        words[slot] = first | second << 8 | third << 16;
        slot += 1;
    }
    words
};
const _: () = assert!(3 * TRANSIENT_TRIANGLES <= 1 << 8, "corner numbers take eight bits");

impl TransientBlock {
    pub(crate) fn new() -> Self {
        Self([[[0; GROUP_WORDS]; 3]; CHUNKS])
    }

    /// The block of `count` triangles of a mesh.
    pub(crate) fn fill(&mut self, mesh: &Mesh, numbers: Numbers<'_>, count: usize) -> Block<'_> {
        let chunks = &mut self.0[..count.div_ceil(LANES)];
        for (chunk, groups) in chunks.iter_mut().enumerate() {
            for lane in 0..LANES {
                // What is left of the last sixteen repeats the last triangle, so that bounds stay
                // those of the cluster.
                let slot = (chunk * LANES + lane).min(count - 1);
                let corners = corners(mesh, numbers.of(slot));
                for (group, [x, y, z]) in groups.iter_mut().zip(corners) {
                    group[lane] = x.to_bits();
                    group[LANES + lane] = y.to_bits();
                    group[2 * LANES + lane] = z.to_bits();
                }
            }
        }
        Block {
            vertices: chunks.as_flattened(),
            triangles: &TRIANGLES[..count],
            shading_vertices: None,
        }
    }
}

/// The positions of a triangle's corners.
#[inline(always)]
pub(crate) fn corners(mesh: &Mesh, triangle: u32) -> [[f32; 3]; 3] {
    mesh.triangles[triangle as usize].map(|corner| mesh.positions[corner as usize])
}

/// The box of `count` triangles: low x y z, high x y z; not a number if a coordinate is none, so that
/// no bound is taken from it.
pub(crate) fn box_of(mesh: &Mesh, numbers: Numbers<'_>, count: usize) -> [f32; 6] {
    let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    let mut is_sound = true;
    for slot in 0..count {
        for position in corners(mesh, numbers.of(slot)) {
            for axis in 0..3 {
                let value = position[axis];
                is_sound &= !value.is_nan();
                low[axis] = if value < low[axis] { value } else { low[axis] };
                high[axis] = if value > high[axis] { value } else { high[axis] };
            }
        }
    }
    let bounds = [low[0], low[1], low[2], high[0], high[1], high[2]];
    if is_sound { bounds } else { [f32::NAN; 6] }
}
