//! Clusters that repeat the one before them.

use super::block::Numbers;
use luxel_scene::Mesh;

/// The clusters that have the same triangles in the same places as the one before them, all submitted later.
///
/// Where nothing shows through they are hidden, as of equally near triangles the first one wins. So a million
/// copies of a triangle in as many materials, a file of some megabytes, cost one of them.
#[derive(Clone, Debug, Default)]
pub(super) struct Repeats(
    /// A bit for each cluster; empty where none repeats another.
    Box<[u64]>,
);

impl Repeats {
    /// Of the clusters of a mesh with these boxes and the numbers of these triangles.
    pub(super) fn new<'n>(
        mesh: &Mesh,
        boxes: &[[f32; 6]],
        numbers: impl Fn(usize) -> (Numbers<'n>, usize),
    ) -> Self {
        let place = |triangle: u32| {
            let corners = mesh.triangles[triangle as usize];
            corners.map(|corner| mesh.positions[corner as usize].map(f32::to_bits))
        };
        let repeats = |cluster: usize| {
            let ((before, count_before), (own, count)) = (numbers(cluster - 1), numbers(cluster));
            count == count_before
                && (0..count).all(|slot| {
                    let (first, later) = (before.of(slot), own.of(slot));
                    first < later && place(first) == place(later)
                })
        };
        let mut bits = Vec::new();
        for cluster in 1..boxes.len() {
            if boxes[cluster] == boxes[cluster - 1] && repeats(cluster) {
                bits.resize(boxes.len().div_ceil(u64::BITS as usize), 0);
                bits[cluster / u64::BITS as usize] |= 1 << (cluster % u64::BITS as usize);
            }
        }
        Self(bits.into())
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether a cluster repeats the one before it.
    pub(super) fn contains(&self, cluster: usize) -> bool {
        let word = self.0.get(cluster / u64::BITS as usize);
        word.is_some_and(|word| word >> (cluster % u64::BITS as usize) & 1 == 1)
    }
}
