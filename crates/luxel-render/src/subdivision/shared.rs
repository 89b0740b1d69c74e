//! The subdivided triangles of a frame, for all threads and tiles.

use super::pieces::{PieceCount, Pieces};
use luxel_visibility::TriangleId;
use std::collections::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// Triangles of fewer pieces are divided again by each tile that sees them: a million of them would take more
/// memory than their frame. `demo:spheres` with `toon` takes 88 MB; keeping all that have 64 pieces would take
/// 280 MB and save a ninth of the time.
const FEWEST_KEPT: u32 = 1024;

/// What the subdivision of a frame's triangles came to, and the pieces of those that take long to divide: a triangle
/// that light jumps across has up to hundreds of thousands of pieces, and many tiles see it.
#[derive(Debug, Default)]
pub(crate) struct SubdividedTriangles(Mutex<HashMap<TriangleId, Subdivided>>);

#[derive(Debug)]
struct Subdivided {
    count: PieceCount,
    kept: Option<Arc<Pieces>>,
}

impl SubdividedTriangles {
    /// The pieces of a triangle, which `divide` makes where they aren't kept. Two threads may divide the same one
    /// at the same time: the other would have to wait as long.
    pub(crate) fn pieces(&self, id: TriangleId, divide: impl FnOnce() -> Pieces) -> Arc<Pieces> {
        if let Some(kept) = self.kept(id) {
            return kept;
        }
        let pieces = Arc::new(divide());
        let count = pieces.count;
        let kept = (count.pieces >= FEWEST_KEPT).then(|| pieces.clone());
        self.locked(|all| {
            all.entry(id).or_insert(Subdivided { count, kept });
        });
        pieces
    }

    /// What each triangle came to, in any order.
    pub(crate) fn counts(&self) -> Vec<PieceCount> {
        self.locked(|all| all.values().map(|one| one.count).collect())
    }

    fn kept(&self, id: TriangleId) -> Option<Arc<Pieces>> {
        self.locked(|all| all.get(&id).and_then(|one| one.kept.clone()))
    }

    fn locked<T>(&self, work: impl FnOnce(&mut HashMap<TriangleId, Subdivided>) -> T) -> T {
        // An entry is inserted whole or not at all.
        work(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

#[cfg(test)]
mod tests {
    use super::super::pieces::tests::divided;
    use super::*;

    #[test]
    fn a_triangle_that_light_jumps_across_is_divided_once_for_all_tiles() {
        let jump = |v: f32| if v > 0.4 { 0.8 } else { 0.2 };
        let even = |v: f32| v;
        let lit = |light: fn(f32) -> f32| divided(1.0, 100.0, |[_, v, _]| [light(v); 3]);
        let triangles = SubdividedTriangles::default();
        let mut times = [0; 2];
        for _ in 0..3 {
            for (number, light) in [jump, even].into_iter().enumerate() {
                let pieces = triangles.pieces(TriangleId(number as u32), || {
                    times[number] += 1;
                    lit(light)
                });
                assert_eq!(pieces.count, lit(light).count);
            }
        }
        // The other has few pieces: it costs less to divide it again than to keep it.
        assert_eq!(times, [1, 3]);
        assert_eq!(triangles.counts().len(), 2, "each triangle counts once");
    }
}
