//! The triangles from which rays have left last.

use luxel_math::{LANES, Lanes, lanes_of};
use luxel_rays::TrianglePlaces;
use luxel_visibility::TriangleId;

/// Triangles that are kept: most of those that a tile of 64x64 pixels sees come back with its next row of
/// blocks.
const KEPT: usize = 512;

/// What is known of a kept triangle: its id, and above it whether it has places. Apart from the places, since these
/// don't stay in the first cache.
#[derive(Clone, Copy)]
struct Key(u64);

impl Key {
    const NONE: Self = Self(TriangleId::NONE.0 as u64);

    fn new(id: u32, is_placed: bool) -> Self {
        Self(u64::from(id) | u64::from(is_placed) << 32)
    }

    #[inline(always)]
    fn is_of(self, id: u32) -> bool {
        self.0 as u32 == id
    }

    #[inline(always)]
    fn is_placed(self) -> bool {
        self.0 >> 32 != 0
    }
}

/// The places of triangles, one cache a thread. An id keeps them where its low bits say, until another
/// one with the same bits comes.
pub(super) struct PlaceCache {
    keys: [Key; KEPT],
    /// None until the first are needed.
    places: Box<[TrianglePlaces]>,
    /// Those of a batch that found their place taken by another of it, one a lane.
    spare: Box<[TrianglePlaces; LANES]>,
}

impl Default for PlaceCache {
    fn default() -> Self {
        Self { keys: [Key::NONE; KEPT], places: Box::default(), spare: Box::default() }
    }
}

/// Where a triangle is kept.
#[inline(always)]
fn slot(id: u32) -> usize {
    id as usize % KEPT
}

impl PlaceCache {
    /// Forgets the triangles of another frame.
    pub(super) fn begin_frame(&mut self) {
        self.keys.fill(Key::NONE);
    }

    /// The places of a triangle, if it has any. `make` computes them as for [`Self::of_lanes`].
    pub(super) fn of_one(
        &mut self,
        id: u32,
        make: impl Fn(TriangleId, &mut TrianglePlaces) -> bool,
    ) -> Option<&TrianglePlaces> {
        self.make_room();
        self.keep(id, make);
        let at = slot(id);
        self.keys[at].is_placed().then_some(&self.places[at])
    }

    /// Makes room for the triangles that are kept, once.
    #[inline(always)]
    fn make_room(&mut self) {
        if self.places.is_empty() {
            self.places = vec![TrianglePlaces::default(); KEPT].into();
        }
    }

    /// Computes the places of a triangle unless they are kept; returns whether it did.
    #[inline(always)]
    fn keep(&mut self, id: u32, make: impl Fn(TriangleId, &mut TrianglePlaces) -> bool) -> bool {
        let at = slot(id);
        if self.keys[at].is_of(id) {
            return false;
        }
        self.keys[at] = Key::new(id, make(TriangleId(id), &mut self.places[at]));
        true
    }

    /// The places of each lane's triangle, and the lanes whose triangle has any; those of the others are any. `make`
    /// computes them where they are kept, which saves a copy, and returns whether there are any.
    #[inline(always)]
    pub(super) fn of_lanes<N: Lanes>(
        &mut self,
        simd: N,
        ids: &[u32; LANES],
        lanes: u32,
        make: impl Fn(TriangleId, &mut TrianglePlaces) -> bool,
    ) -> ([&TrianglePlaces; LANES], u32) {
        self.make_room();
        // Lanes that don't count have no triangle, so that each that counts has a first lane.
        let mut counted = *ids;
        if lanes != simd.all_lanes() {
            for lane in 0..LANES {
                counted[lane] |= (lanes >> lane & 1).wrapping_sub(1);
            }
        }
        let firsts = simd.run_starts(&counted) & lanes;
        let (mut made, mut is_plain) = (false, true);
        for lane in lanes_of(firsts) {
            made |= self.keep(ids[lane], &make);
        }
        // Where none was made, nothing took another's place.
        for lane in lanes_of(firsts) {
            let key = self.keys[slot(ids[lane])];
            is_plain &= key.is_placed() & (!made | key.is_of(ids[lane]));
        }
        let (mut placed, mut taken) = (lanes, 0);
        if !is_plain {
            (placed, taken) = self.sort_out(ids, lanes, &make);
        }
        let places = &self.places[..KEPT];
        let mut of = [&places[0]; LANES];
        for lane in 0..LANES {
            of[lane] = &places[slot(ids[lane])];
        }
        for lane in lanes_of(taken) {
            of[lane] = &self.spare[lane];
        }
        (of, placed)
    }

    /// The lanes whose triangles have places, and those whose places are among the spare ones.
    #[cold]
    #[inline(never)]
    fn sort_out(
        &mut self,
        ids: &[u32; LANES],
        lanes: u32,
        make: &impl Fn(TriangleId, &mut TrianglePlaces) -> bool,
    ) -> (u32, u32) {
        let (mut placed, mut taken) = (0, 0);
        for lane in lanes_of(lanes) {
            let (id, key) = (ids[lane], self.keys[slot(ids[lane])]);
            let is_placed = if key.is_of(id) {
                key.is_placed()
            } else {
                taken |= 1 << lane;
                make(TriangleId(id), &mut self.spare[lane])
            };
            placed |= u32::from(is_placed) << lane;
        }
        (placed, taken)
    }
}
