//! Rays through one mesh: the nearest triangle, any, all, and millions of rays on all cores.

use crate::bundle::{BUNDLE, Bundle, Kind, LEAST, closest_of_bundle};
use crate::bvh::{Bvh, Child, Node, Record, Slabs, Stack, Tree, WIDTH, Walk, meet, step};
use crate::intersect::{Nearest, Ray, Sheared, meet_triangles};
use luxel_math::{Level, Simd, SimdLevel, dispatch_long};
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

/// A tree with the positions that it was built over, ready for rays.
///
/// Of triangles that a ray meets at the same distance, as at a shared edge, the one with the lowest
/// number counts. Both sides of triangles are hit.
#[derive(Clone, Copy)]
pub struct MeshRays<'m> {
    bvh: &'m Bvh,
    positions: &'m [[f32; 3]],
    largest: [f32; 3],
    /// Of the tree's box, along its longest side.
    extent: f32,
    level: Level,
}

/// Rays that one task follows.
const CHUNK: usize = 1024;

thread_local! {
    static STACK: RefCell<Stack> = RefCell::new(Stack::new());
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
        let largest = bvh.tree().bounds.map_or([0.0; 3], |bounds| bounds.largest());
        let extent = bvh.tree().bounds.map_or(0.0, |bounds| bounds.longest());
        Self { bvh, positions, largest, extent, level }
    }

    /// The nearest triangle that a ray meets; `None` also for a ray that isn't sound.
    #[must_use]
    pub fn closest(&self, ray: &Ray) -> Option<RayHit> {
        let mut nearest = [Nearest::before(0.0)];
        STACK.with_borrow_mut(|stack| {
            let rays = std::slice::from_ref(ray);
            dispatch_long!(self.level, simd => closest(simd, self, rays, &mut nearest, stack));
        });
        self.told(ray, nearest[0])
    }

    /// The nearest triangle for each of many rays, on all threads of the current pool.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[Ray]) -> Vec<Option<RayHit>> {
        let mut hits = vec![None; rays.len()];
        fill(&mut hits, CHUNK, &|start, hits| {
            let rays = &rays[start..start + hits.len()];
            let mut nearest = [Nearest::before(0.0); CHUNK];
            self.follow(rays, &mut nearest[..rays.len()]);
            for ((hit, ray), nearest) in hits.iter_mut().zip(rays).zip(nearest) {
                *hit = self.told(ray, nearest);
            }
        });
        hits
    }

    /// Whether a ray meets anything: quicker than asking what.
    #[must_use]
    pub fn any(&self, ray: &Ray) -> bool {
        ray.is_sound()
            && STACK.with_borrow_mut(
                |stack| dispatch_long!(self.level, simd => any(simd, self, ray, stack)),
            )
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
        let mut walk = Walk::new(self.bvh.tree());
        while let Some((start, count)) =
            walk.next(|node| step(self.level, node, &slabs, ray.range[1]).1)
        {
            let (distances, mut bits) = dispatch_long!(self.level, simd => leaf(simd, self, (start, count), &sheared, ray.range));
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize;
                bits &= bits - 1;
                let [a, b, c, triangle] = self.bvh.records()[start + lane];
                let corners = [a, b, c].map(|vertex| self.positions[vertex as usize]);
                let barycentric = sheared.barycentric(corners);
                hits.push(RayHit { t: distances[lane] * scale, triangle, barycentric });
            }
        }
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.triangle.cmp(&b.triangle)));
        hits
    }

    /// The nearest triangles, in bundles where rays that follow one another run close together.
    fn follow(&self, rays: &[Ray], nearest: &mut [Nearest]) {
        STACK.with_borrow_mut(|stack| {
            BUNDLES.with_borrow_mut(|bundle| {
                dispatch_long!(self.level, simd => closest_of_many(simd, self, rays, nearest, bundle, stack));
            });
        });
    }

    pub(crate) fn tree(&self) -> &'m Tree {
        self.bvh.tree()
    }

    pub(crate) fn records(&self) -> &'m [Record] {
        self.bvh.records()
    }

    pub(crate) fn positions(&self) -> &'m [[f32; 3]] {
        self.positions
    }

    #[inline(always)]
    fn prepared(&self, ray: &Ray) -> (Slabs, Sheared) {
        let slabs = Slabs::new(ray.origin, ray.direction, ray.range[0], self.largest);
        (slabs, Sheared::new(ray.origin, ray.direction))
    }

    /// The largest coordinates of the tree's box, without signs.
    pub(crate) fn largest(&self) -> [f32; 3] {
        self.largest
    }

    /// The longest side of the tree's box.
    pub(crate) fn extent(&self) -> f32 {
        self.extent
    }

    fn told(&self, ray: &Ray, nearest: Nearest) -> Option<RayHit> {
        if nearest.triangle == u32::MAX {
            return None;
        }
        let [a, b, c, triangle] = self.bvh.records()[nearest.record as usize];
        let corners = [a, b, c].map(|vertex| self.positions[vertex as usize]);
        let (scaled, _) = ray.scaled();
        let barycentric = Sheared::new(scaled.origin, scaled.direction).barycentric(corners);
        Some(RayHit { t: nearest.t, triangle, barycentric })
    }
}

/// A leaf's triangles.
#[inline(always)]
fn leaf<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    (start, count): (usize, usize),
    ray: &Sheared,
    range: [f32; 2],
) -> ([f32; WIDTH], u32) {
    match rays.bvh.records()[start..].first_chunk::<WIDTH>() {
        Some(records) => meet_triangles(simd, records, count, rays.positions, ray, range),
        None => ([0.0; WIDTH], 0),
    }
}

/// Follows rays in bundles of their kind, those that are left one by one.
#[inline(always)]
fn closest_of_many<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    followed: &[Ray],
    nearest: &mut [Nearest],
    bundle: &mut Bundle,
    stack: &mut Stack,
) {
    for (followed, nearest) in followed.chunks(BUNDLE).zip(nearest.chunks_mut(BUNDLE)) {
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
            if !bundle.fill(simd, rays, kind, followed, places) {
                continue;
            }
            closest_of_bundle(simd, rays, bundle, stack);
            for (number, &place) in places.iter().enumerate() {
                nearest[usize::from(place)] = bundle.nearest(number);
                alone[usize::from(place)] = false;
            }
        }
        for ((ray, nearest), _) in
            followed.iter().zip(nearest).zip(alone).filter(|(_, alone)| *alone)
        {
            closest(simd, rays, std::slice::from_ref(ray), std::slice::from_mut(nearest), stack);
        }
    }
}

/// Follows rays one by one.
#[inline(always)]
fn closest<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    followed: &[Ray],
    nearest: &mut [Nearest],
    stack: &mut Stack,
) {
    for (ray, nearest) in followed.iter().zip(nearest) {
        *nearest = Nearest::before(0.0);
        if ray.is_sound() {
            let (ray, scale) = ray.scaled();
            nearest.t = ray.range[1];
            closest_of(simd, rays, &ray, nearest, stack);
            nearest.t *= scale;
        }
    }
}

#[inline(always)]
fn closest_of<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    ray: &Ray,
    nearest: &mut Nearest,
    stack: &mut Stack,
) {
    let (slabs, sheared) = rays.prepared(ray);
    let nodes: &[Node] = &rays.bvh.tree().nodes;
    stack.clear();
    if nodes.is_empty() {
        return;
    }
    let mut child = Child::inner(0);
    loop {
        if let Some((start, count)) = child.as_leaf() {
            let range = [ray.range[0], nearest.t];
            let (distances, mut bits) = leaf(simd, rays, (start, count), &sheared, range);
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize & (WIDTH - 1);
                bits &= bits - 1;
                let (t, triangle) = (distances[lane], rays.bvh.records()[start + lane][3]);
                if t < nearest.t || t == nearest.t && triangle < nearest.triangle {
                    *nearest = Nearest { t, triangle, record: (start + lane) as u32 };
                }
            }
        } else {
            let node = &nodes[child.0 as usize];
            let (distances, bits) = meet(simd, node, &slabs, nearest.t);
            if bits != 0 && bits & (bits - 1) == 0 {
                child = node.children[bits.trailing_zeros() as usize & (WIDTH - 1)];
                continue;
            }
            stack.push(node, &distances, bits);
        }
        match stack.pop(nearest.t) {
            Some(next) => child = next,
            None => return,
        }
    }
}

#[inline(always)]
fn any<S: Simd>(simd: S, rays: &MeshRays<'_>, ray: &Ray, stack: &mut Stack) -> bool {
    let (ray, _) = &ray.scaled();
    let (slabs, sheared) = rays.prepared(ray);
    let nodes: &[Node] = &rays.bvh.tree().nodes;
    stack.clear();
    if nodes.is_empty() {
        return false;
    }
    let mut child = Child::inner(0);
    loop {
        if let Some(of) = child.as_leaf() {
            if leaf(simd, rays, of, &sheared, ray.range).1 != 0 {
                return true;
            }
        } else {
            let node = &nodes[child.0 as usize];
            let (distances, bits) = meet(simd, node, &slabs, ray.range[1]);
            stack.push(node, &distances, bits);
        }
        match stack.pop(ray.range[1]) {
            Some(next) => child = next,
            None => return false,
        }
    }
}
