//! The triangles from which rays have left last.

use luxel_math::{LANES, lanes_of};
use luxel_rays::TrianglePlaces;
use luxel_visibility::TriangleId;

/// Triangles that are kept: most of those that a tile of 64x64 pixels sees come back with its next row of
/// blocks.
const KEPT: usize = 512;

/// The places of triangles, one cache a thread. An id keeps them where its low bits say, until another
/// one with the same bits comes.
pub(super) struct PlaceCache {
    ids: Vec<u32>,
    places: Vec<Option<TrianglePlaces>>,
    /// Those of a batch that found their place taken by another of it.
    spare: [Option<TrianglePlaces>; LANES],
    /// Stands for lanes without a place.
    nowhere: TrianglePlaces,
}

impl Default for PlaceCache {
    fn default() -> Self {
        Self {
            ids: Vec::new(),
            places: Vec::new(),
            spare: [None; LANES],
            nowhere: TrianglePlaces::default(),
        }
    }
}

impl PlaceCache {
    /// Forgets the triangles of another frame.
    pub(super) fn begin_frame(&mut self) {
        self.ids.fill(TriangleId::NONE.0);
    }

    /// The places of each lane's triangle, and the lanes whose triangle has any; `make` computes them.
    pub(super) fn of_lanes(
        &mut self,
        ids: &[u32; LANES],
        lanes: u32,
        make: impl Fn(TriangleId) -> Option<TrianglePlaces>,
    ) -> ([&TrianglePlaces; LANES], u32) {
        if self.ids.is_empty() {
            self.ids = vec![TriangleId::NONE.0; KEPT];
            self.places = vec![None; KEPT];
        }
        let slot = |id: u32| id as usize % KEPT;
        let (mut taken, mut made) = (0, 0);
        for lane in lanes_of(lanes) {
            let id = ids[lane];
            if self.ids[slot(id)] != id {
                self.ids[slot(id)] = id;
                self.places[slot(id)] = make(TriangleId(id));
                made += 1;
            }
        }
        // Where nothing was made, nothing took another's place.
        for lane in lanes_of(if made > 0 { lanes } else { 0 }) {
            let id = ids[lane];
            if self.ids[slot(id)] != id {
                self.spare[lane] = make(TriangleId(id));
                taken |= 1 << lane;
            }
        }
        let (mut of, mut placed) = ([&self.nowhere; LANES], 0);
        for lane in lanes_of(lanes) {
            let found = match taken >> lane & 1 {
                0 => &self.places[slot(ids[lane])],
                _ => &self.spare[lane],
            };
            if let Some(places) = found {
                of[lane] = places;
                placed |= 1 << lane;
            }
        }
        (of, placed)
    }
}
