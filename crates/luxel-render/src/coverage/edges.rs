//! Edges of polygons in the picture: how far a sample is from them.
//!
//! The weight of a corner is a linear form over the window that is 0 along the opposite edge, so
//! its value over the length of its gradient is the distance from that edge in pixels. Edges
//! between two triangles of one polygon are none.

use luxel_math::{F64Lanes, Lanes};
use luxel_scene::Mesh;
use luxel_visibility::Forms;

/// Which edges of each triangle are edges of its polygon: bit i for the edge opposite corner i.
pub(crate) struct EdgeFlags(Option<Vec<u8>>);

/// All three edges.
const ALL: u8 = 0b111;

impl EdgeFlags {
    /// The flags of a mesh: all edges, where each triangle is its own polygon.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let Some(polygons) = &mesh.polygons else { return Self(None) };
        let mut flags = vec![ALL; mesh.triangles.len()];
        let mut first = 0;
        for run in polygons.chunk_by(|a, b| a == b) {
            let triangles = &mesh.triangles[first..first + run.len()];
            // An edge inside of the polygon runs through two of its triangles, once each way.
            let mut directed: Vec<([u32; 2], usize, usize)> = Vec::with_capacity(3 * run.len());
            for (number, corners) in triangles.iter().enumerate() {
                for opposite in 0..3 {
                    let ends = [corners[(opposite + 1) % 3], corners[(opposite + 2) % 3]];
                    directed.push((ends, first + number, opposite));
                }
            }
            directed.sort_unstable();
            for &([from, to], triangle, opposite) in &directed {
                let back = directed.partition_point(|(ends, ..)| *ends < [to, from]);
                if directed.get(back).is_some_and(|(ends, ..)| *ends == [to, from]) {
                    flags[triangle] &= !(1 << opposite);
                }
            }
            first += run.len();
        }
        Self(Some(flags))
    }

    pub(crate) fn of(&self, triangle: u32) -> u8 {
        self.0.as_ref().map_or(ALL, |flags| flags[triangle as usize])
    }
}

/// The distance in pixels from the nearest edge of the polygon at window position (x, y); very far
/// where no edge counts.
#[inline(always)]
pub(crate) fn edge_distance<D: F64Lanes>(forms: &Forms, flags: u8, x: D, y: D) -> D::F32 {
    let weights = forms.in_lanes(x).weights(x, y);
    let mut distance = x.to_f32().constant(f32::MAX);
    for (corner, weight) in weights.into_iter().enumerate() {
        let steepness = forms.steepness(corner);
        if flags >> corner & 1 == 1 && steepness > 0.0 {
            distance = distance.minimum((weight.abs() / x.constant(steepness)).to_f32());
        }
    }
    distance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_diagonal_of_a_quad_is_no_edge() {
        let mesh = Mesh {
            triangles: vec![[0, 1, 2], [0, 2, 3], [4, 5, 6]],
            polygons: Some(vec![0, 0, 1]),
            ..Mesh::default()
        };
        let flags = EdgeFlags::new(&mesh);
        // Corner 1 lies opposite the diagonal 2-0 in the first triangle, corner 3 in the second.
        assert_eq!([0, 1, 2].map(|triangle| flags.of(triangle)), [0b101, 0b011, 0b111]);
    }
}
