//! The triangles from which rays have left last.

use luxel_math::{LANES, Lanes, lanes_of};
use luxel_rays::TrianglePlaces;
use luxel_visibility::TriangleId;

/// Triangles that are kept: most of those that a tile of 64x64 pixels sees come back with its next row of
/// blocks.
const KEPT: usize = 512;

/// A triangle and its places, if it has any.
#[derive(Clone)]
struct Entry {
    id: u32,
    is_placed: bool,
    places: TrianglePlaces,
}

impl Entry {
    fn empty() -> Self {
        Self { id: TriangleId::NONE.0, is_placed: false, places: TrianglePlaces::default() }
    }
}

/// The places of triangles, one cache a thread. An id keeps them where its low bits say, until another
/// one with the same bits comes.
#[derive(Default)]
pub(super) struct PlaceCache {
    entries: Box<[Entry]>,
    /// Those of a batch that found their place taken by another of it, one a lane.
    spare: Vec<Entry>,
    /// Stands for lanes without a place.
    nowhere: TrianglePlaces,
}

impl PlaceCache {
    /// Forgets the triangles of another frame.
    pub(super) fn begin_frame(&mut self) {
        self.entries.iter_mut().for_each(|entry| entry.id = TriangleId::NONE.0);
    }

    /// The places of a triangle, if it has any. `make` computes them as for [`Self::of_lanes`].
    pub(super) fn of_one(
        &mut self,
        id: u32,
        make: impl Fn(TriangleId, &mut TrianglePlaces) -> bool,
    ) -> Option<&TrianglePlaces> {
        self.make_room();
        let entry = &mut self.entries[id as usize % KEPT];
        if entry.id != id {
            entry.id = id;
            entry.is_placed = make(TriangleId(id), &mut entry.places);
        }
        entry.is_placed.then_some(&entry.places)
    }

    /// Makes room for the triangles that are kept, once.
    #[inline(always)]
    fn make_room(&mut self) {
        if self.entries.is_empty() {
            self.entries = vec![Entry::empty(); KEPT].into();
            self.spare.resize(LANES, Entry::empty());
        }
    }

    /// The places of each lane's triangle, and the lanes whose triangle has any. `make` computes them where
    /// they are kept, which saves a copy, and returns whether there are any.
    #[inline(always)]
    pub(super) fn of_lanes<N: Lanes>(
        &mut self,
        simd: N,
        ids: &[u32; LANES],
        lanes: u32,
        make: impl Fn(TriangleId, &mut TrianglePlaces) -> bool,
    ) -> ([&TrianglePlaces; LANES], u32) {
        self.make_room();
        let slot = |id: u32| id as usize % KEPT;
        let fill = |entry: &mut Entry, id: u32| {
            entry.id = id;
            entry.is_placed = make(TriangleId(id), &mut entry.places);
        };
        let (mut taken, mut made) = (0, 0);
        // Lanes that don't count have no triangle, so that each that counts has a first lane.
        let mut counted = *ids;
        if lanes != simd.all_lanes() {
            for lane in 0..LANES {
                counted[lane] |= (lanes >> lane & 1).wrapping_sub(1);
            }
        }
        for lane in lanes_of(simd.run_starts(&counted) & lanes) {
            let (id, entry) = (ids[lane], &mut self.entries[slot(ids[lane])]);
            if entry.id != id {
                fill(entry, id);
                made += 1;
            }
        }
        // Where none was made, nothing took another's place.
        for lane in lanes_of(if made > 0 { lanes } else { 0 }) {
            let id = ids[lane];
            if self.entries[slot(id)].id != id {
                fill(&mut self.spare[lane], id);
                taken |= 1 << lane;
            }
        }
        let (mut of, mut placed) = ([&self.nowhere; LANES], 0);
        for lane in lanes_of(lanes) {
            let entry = match taken >> lane & 1 {
                0 => &self.entries[slot(ids[lane])],
                _ => &self.spare[lane],
            };
            if entry.is_placed {
                of[lane] = &entry.places;
                placed |= 1 << lane;
            }
        }
        (of, placed)
    }
}
