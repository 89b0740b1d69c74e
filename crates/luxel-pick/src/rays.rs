//! Rays through one mesh: the nearest triangle, any, all, and millions of rays on all cores.

use crate::alone::{Begun, Lean, TURNS, any, begin, closest, closest_in_turns, nearest_alone};
use crate::bundle::{Bundle, LEAST, closest_of_bundle};
use crate::bvh::{Block, Box3, Bvh, Node, Places, Slabs, Walk, block, corners, number, step};
use crate::intersect::{Nearest, Ray, Sheared, axes, meet_block};
use crate::kind::Kind;
use crate::row::BUNDLE;
use luxel_math::{
    Level, Simd, SimdLevel, dispatch_long, f32x8, f32x16, has_wide_registers, prelude::*,
};
use luxel_parallel::fill;
use std::cell::RefCell;

/// Where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayHit {
    /// Along the ray, in lengths of its direction.
    pub t: f32,
    /// The triangle, by its place in the mesh.
    pub triangle: u32,
    /// The weights of the triangle's corners.
    pub barycentric: [f32; 3],
}

/// A tree with the positions that it was built over, or last fitted to, ready for rays.
///
/// Of triangles that a ray meets at the same distance, as at a shared edge, the one with the lowest
/// number counts. Both sides of triangles are hit.
#[derive(Clone, Copy)]
pub struct MeshRays<'m> {
    bvh: &'m Bvh,
    pub(crate) nodes: &'m [Node],
    /// Those of the leaves.
    pub(crate) words: &'m [u32],
    pub(crate) positions: &'m [[f32; 3]],
    /// The box around all, its lowest corner and its highest; the fourth lane has no bounds. Upside
    /// down where there is nothing.
    pub(crate) bounds: [[f32; 4]; 2],
    /// The largest coordinates of the box, without signs, and 0.
    pub(crate) largest: [f32; 4],
    /// Of the tree's box, along its longest side.
    extent: f32,
    level: Level,
}

/// Trees of more bytes are far from the processor: rays wait for memory.
const FAR: usize = 1 << 24;

/// Rays that one task follows.
const CHUNK: usize = 1024;

thread_local! {
    static PLACES: [Places; TURNS] = const { [const { Places::new() }; TURNS] };
    static BUNDLES: RefCell<Box<Bundle>> = RefCell::new(Box::new(Bundle::new()));
}

impl<'m> MeshRays<'m> {
    /// With the best instruction set that the machine has.
    ///
    /// # Panics
    /// If there are fewer positions than the tree was built over.
    #[must_use]
    pub fn new(bvh: &'m Bvh, positions: &'m [[f32; 3]]) -> Self {
        let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
        Self::with_level(bvh, positions, level)
    }

    /// With an instruction set of your choice; results are the same with all.
    ///
    /// # Panics
    /// If there are fewer positions than the tree was built over.
    #[must_use]
    pub fn with_level(bvh: &'m Bvh, positions: &'m [[f32; 3]], level: Level) -> Self {
        assert!(positions.len() >= bvh.vertices(), "positions are missing");
        let within = bvh.box_of_all();
        let [x, y, z] = within.map_or([0.0; 3], |bounds| bounds.largest());
        let largest = [x, y, z, 0.0];
        let extent = within.map_or(0.0, |bounds| bounds.longest());
        let Box3 { low, high } = within.unwrap_or(Box3::EMPTY);
        let corner = |[x, y, z]: [f32; 3], end| [x, y, z, end];
        let bounds = [corner(low, f32::NEG_INFINITY), corner(high, f32::INFINITY)];
        let (nodes, words) = (bvh.nodes(), bvh.leaves().words());
        Self { bvh, nodes, words, positions, bounds, largest, extent, level }
    }

    /// The nearest triangle that a ray meets; `None` also for a ray that isn't sound.
    #[must_use]
    #[inline]
    pub fn closest(&self, ray: &Ray) -> Option<RayHit> {
        let mut hit = None;
        match self.begin(ray) {
            Begun::Unusual => hit = self.closest_unusual(ray),
            Begun::Misses => {}
            Begun::Meets(lean) => self.closest_within(ray, &lean, &mut hit),
        }
        hit
    }

    /// Most rays of a picture end here: in the function that asks, without what a large one begins and
    /// ends with. Every level has vectors of four.
    #[inline(always)]
    fn begin(&self, ray: &Ray) -> Begun {
        dispatch_long!(Level::baseline(), simd => begin(simd, self, ray))
    }

    /// The nearest triangle for a ray that meets the box around all, written where it is wanted: a copy
    /// would wait for parts that were just stored.
    #[inline(never)]
    fn closest_within(&self, ray: &Ray, lean: &Lean, hit: &mut Option<RayHit>) {
        PLACES.with(|[places, ..]| {
            dispatch_long!(self.level, simd => *hit = closest(simd, self, ray, lean, places));
        });
    }

    /// The nearest triangle for each of many rays, on all threads of the current pool.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[Ray]) -> Vec<Option<RayHit>> {
        let mut hits = Vec::new();
        self.closest_of_each_into(rays, &mut hits);
        hits
    }

    /// [`Self::closest_of_each`] in place of what `hits` held, whose memory is used again.
    pub fn closest_of_each_into(&self, rays: &[Ray], hits: &mut Vec<Option<RayHit>>) {
        hits.resize(rays.len(), None);
        fill(hits, CHUNK, &|start, hits| {
            // Here, where it stays in the cache.
            hits.fill(None);
            let rays = &rays[start..start + hits.len()];
            BUNDLES.with_borrow_mut(|bundle| {
                PLACES.with(|places| {
                    dispatch_long!(self.level, simd => closest_of_many(simd, self, rays, hits, bundle, places));
                });
            });
        });
    }

    /// Whether a ray meets anything: quicker than asking what.
    #[must_use]
    pub fn any(&self, ray: &Ray) -> bool {
        match self.begin(ray) {
            Begun::Unusual => self.nearest_unusual(ray).triangle != u32::MAX,
            Begun::Misses => false,
            Begun::Meets(lean) => PLACES.with(
                |[places, ..]| dispatch_long!(self.level, simd => any(simd, self, ray, &lean, places)),
            ),
        }
    }

    /// Every triangle that a ray meets, nearest first, of equally near ones the lowest number first.
    #[must_use]
    pub fn all(&self, ray: &Ray) -> Vec<RayHit> {
        let mut hits = Vec::new();
        if !ray.is_sound() {
            return hits;
        }
        let (ray, scale) = &ray.scaled();
        let (slabs, sheared) = self.prepared(ray);
        let mut walk = Walk::new(self.nodes);
        while let Some(start) = walk.next(|node| step(self.level, node, &slabs, ray.range[1]).1) {
            self.bvh.leaves().each_block(start, &mut |block| {
                let (distances, mut bits) = dispatch_long!(self.level, simd => meet_block(simd, block, self.positions, &sheared, ray.range));
                while bits != 0 {
                    let lane = bits.trailing_zeros() as usize;
                    bits &= bits - 1;
                    hits.push(self.told_of(&sheared, block, lane, distances[lane] * scale));
                }
            });
        }
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.triangle.cmp(&b.triangle)));
        hits
    }

    #[inline(always)]
    fn prepared(&self, ray: &Ray) -> (Slabs, Sheared) {
        let slabs = Slabs::new(ray.origin, ray.direction, ray.range[0], self.largest());
        (slabs, Sheared::new(ray.origin, ray.direction))
    }

    /// The largest coordinates of the tree's box, without signs.
    pub(crate) fn largest(&self) -> [f32; 3] {
        let [x, y, z, _] = self.largest;
        [x, y, z]
    }

    /// The longest side of the tree's box.
    pub(crate) fn extent(&self) -> f32 {
        self.extent
    }

    /// The nearest triangle for a ray of an unusual length, and nothing for one that isn't sound.
    #[cold]
    #[inline(never)]
    pub(crate) fn nearest_unusual(&self, ray: &Ray) -> Nearest {
        let mut nearest = Nearest::before(0.0);
        if ray.is_sound() && !ray.is_usual() {
            let (scaled, scale) = ray.scaled();
            if let Begun::Meets(lean) = self.begin(&scaled) {
                nearest = PLACES.with(
                    |[places, ..]| dispatch_long!(self.level, simd => nearest_alone(simd, self, &scaled, &lean, places)),
                );
                nearest.t *= scale;
            }
        }
        nearest
    }

    #[cold]
    #[inline(never)]
    pub(crate) fn closest_unusual(&self, ray: &Ray) -> Option<RayHit> {
        let nearest = self.nearest_unusual(ray);
        let (scaled, _) = ray.scaled();
        self.told(&Sheared::new(scaled.origin, scaled.direction), nearest)
    }

    /// Where on its triangle a hit is.
    #[inline(always)]
    pub(crate) fn told(&self, sheared: &Sheared, nearest: Nearest) -> Option<RayHit> {
        if nearest.triangle == u32::MAX {
            return None;
        }
        let block = block(self.words, nearest.block as usize)?;
        Some(self.told_of(sheared, block, nearest.lane as usize, nearest.t))
    }

    /// What is told of a block's triangle that is met at t.
    #[inline(always)]
    fn told_of(&self, sheared: &Sheared, block: &Block, lane: usize, t: f32) -> RayHit {
        let triangle = number(block, lane);
        let corners = corners(block, lane, self.positions, axes(sheared.last));
        RayHit { t, triangle, barycentric: sheared.barycentric(corners) }
    }
}

/// Follows rays in bundles of their kind, those that are left one by one.
#[inline(always)]
fn closest_of_many<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    followed: &[Ray],
    hits: &mut [Option<RayHit>],
    bundle: &mut Bundle,
    cells: &[Places; TURNS],
) {
    if has_wide_registers(simd) {
        let like = f32x16::splat(simd, 0.0);
        closest_in_bundles(simd, like, rays, followed, hits, bundle, cells);
    } else {
        let like = f32x8::splat(simd, 0.0);
        closest_in_bundles(simd, like, rays, followed, hits, bundle, cells);
    }
}

/// The same with groups of rays as wide as `like`.
#[inline(always)]
fn closest_in_bundles<S: Simd, N: Number>(
    simd: S,
    like: N,
    rays: &MeshRays<'_>,
    followed: &[Ray],
    hits: &mut [Option<RayHit>],
    bundle: &mut Bundle,
    cells: &[Places; TURNS],
) {
    for (followed, hits) in followed.chunks(BUNDLE).zip(hits.chunks_mut(BUNDLE)) {
        if let Some(kind) = bundle.take(simd, followed)
            && followed.len() >= LEAST
        {
            if bundle.ready(like, rays, kind, followed.len()) {
                closest_of_bundle(simd, like, rays, bundle, &cells[0]);
                bundle.tell(like, rays, hits, |place| place);
            } else {
                closest_of_rest(simd, rays, followed, 0..followed.len(), hits, cells);
            }
            continue;
        }
        let mut kinds = [Kind::NONE; BUNDLE];
        for (kind, ray) in kinds.iter_mut().zip(followed) {
            *kind = Kind::of(ray);
        }
        let kinds = &mut kinds[..followed.len()];
        let mut counts = [0_u8; Kind::COUNT];
        for kind in kinds.iter() {
            counts[kind.number()] += 1;
        }
        let mut alone = [true; BUNDLE];
        for first in 0..kinds.len() {
            let kind = kinds[first];
            if kind == Kind::NONE || usize::from(counts[kind.number()]) < LEAST {
                continue;
            }
            let mut places = [0_u8; BUNDLE];
            let mut count = 0;
            for (place, other) in (0_u8..).zip(kinds.iter_mut()) {
                places[count & (BUNDLE - 1)] = place;
                count += usize::from(*other == kind);
                *other = if *other == kind { Kind::NONE } else { *other };
            }
            let places = &places[..count];
            bundle.take_places(simd, followed, places);
            if !bundle.ready(like, rays, kind, count) {
                continue;
            }
            closest_of_bundle(simd, like, rays, bundle, &cells[0]);
            bundle.tell(like, rays, hits, |number| usize::from(places[number]));
            for &place in places {
                alone[usize::from(place)] = false;
            }
        }
        let rest = (0..followed.len()).filter(|place| alone[*place]);
        closest_of_rest(simd, rays, followed, rest, hits, cells);
    }
}

/// Those that run along no others: in turns where the tree is larger than what memory is near, else
/// one by one.
#[inline(always)]
fn closest_of_rest<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    followed: &[Ray],
    rest: impl Iterator<Item = usize>,
    hits: &mut [Option<RayHit>],
    cells: &[Places; TURNS],
) {
    if rays.bvh.memory() >= FAR {
        closest_in_turns(simd, rays, followed, rest, hits, cells);
    } else {
        for place in rest {
            let ray = &followed[place];
            hits[place] = match begin(simd, rays, ray) {
                Begun::Unusual => rays.closest_unusual(ray),
                Begun::Misses => None,
                Begun::Meets(lean) => closest(simd, rays, ray, &lean, &cells[0]),
            };
        }
    }
}
