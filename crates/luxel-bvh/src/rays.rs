//! Queries of one mesh: closest, any and all hits.

use crate::bvh::Bvh;
use crate::intersect::{ShearedRay, SlabTest, intersect_block};
use crate::ray::{Ray, RayColumns, RayHit};
use crate::traverse::{
    AnyHit, ClosestHit, RayQuery, RaySetup, RaySlabs, RayTarget, any_of_columns, set_up,
    trace_batch, trace_here, trace_unusual, trace_usual,
};
use luxel_math::{Level, SimdLevel, dispatch_long};
use std::cell::Cell;
use std::ops::ControlFlow;

/// A tree with the positions that it was built over or last refitted to: casts rays.
///
/// Both sides of triangles are hit. Of triangles hit at the same distance, as at a shared edge, the
/// one with the lowest number wins. Results are the same to the bit for every instruction set, every
/// number of threads, and for rays cast singly or in batches.
#[derive(Clone, Copy)]
pub struct MeshRays<'m>(RayTarget<'m>);

impl<'m> MeshRays<'m> {
    /// Uses the best instruction set of the machine.
    ///
    /// # Panics
    /// If there are fewer positions than the tree was built over.
    #[must_use]
    pub fn new(bvh: &'m Bvh, positions: &'m [[f32; 3]]) -> Self {
        let level = SimdLevel::Auto.resolve().unwrap_or_else(|_| Level::baseline());
        Self::with_level(bvh, positions, level)
    }

    /// Uses a given instruction set.
    ///
    /// # Panics
    /// If there are fewer positions than the tree was built over.
    #[must_use]
    pub fn with_level(bvh: &'m Bvh, positions: &'m [[f32; 3]], level: Level) -> Self {
        assert!(positions.len() >= bvh.vertices(), "positions are missing");
        Self(RayTarget::new(bvh, positions, level))
    }

    /// The closest hit of a ray; `None` also for a ray that isn't sound.
    #[must_use]
    #[inline]
    pub fn closest(&self, ray: &Ray) -> Option<RayHit> {
        let mut hit = None;
        match self.set_up(ray) {
            RaySetup::Unusual => hit = trace_unusual::<ClosestHit>(&self.0, ray),
            RaySetup::Misses => {}
            RaySetup::Hits(slabs) => self.closest_within(ray, &slabs, &mut hit),
        }
        hit
    }

    /// Whether a ray hits anything within its range: an occlusion query, which ends at the first hit
    /// found. The same as `closest(ray).is_some()`, and quicker.
    #[must_use]
    #[inline]
    pub fn any(&self, ray: &Ray) -> bool {
        match self.set_up(ray) {
            RaySetup::Unusual => trace_unusual::<AnyHit>(&self.0, ray),
            RaySetup::Misses => false,
            RaySetup::Hits(slabs) => self.any_within(ray, &slabs),
        }
    }

    /// All hits of a ray, nearest first; of equally near ones the lowest triangle first.
    #[must_use]
    pub fn all(&self, ray: &Ray) -> Vec<RayHit> {
        let mut hits = Vec::new();
        self.each_hit(ray, &mut |hit| {
            hits.push(hit);
            ControlFlow::Continue(())
        });
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.triangle.cmp(&b.triangle)));
        hits
    }

    /// Visits the hits of a ray, in no particular order, until `visit` breaks.
    pub fn each_hit(&self, ray: &Ray, visit: &mut dyn FnMut(RayHit) -> ControlFlow<()>) {
        if !ray.is_sound() {
            return;
        }
        let target = &self.0;
        let (ray, scale) = &ray.scaled();
        let [x, y, z, _] = target.largest;
        let slabs = SlabTest::new(ray.origin, ray.direction, ray.range[0], [x, y, z]);
        let sheared = ShearedRay::new(ray.origin, ray.direction);
        // What is left to visit then passes quickly: no box is hit any more.
        let is_over = Cell::new(false);
        target.tree.visit_blocks(
            |node| match is_over.get() {
                true => 0,
                false => slabs.hit_children_at(target.level, node, ray.range[1]).1,
            },
            |block| {
                if is_over.get() {
                    return;
                }
                let (distances, mut bits) = dispatch_long!(target.level, simd => intersect_block(simd, block, target.positions, &sheared, ray.range));
                while bits != 0 && !is_over.get() {
                    let lane = bits.trailing_zeros() as usize;
                    bits &= bits - 1;
                    let hit = target.hit_on(&sheared, block, lane, distances[lane] * scale);
                    is_over.set(visit(hit).is_break());
                }
            },
        );
    }

    /// The closest hit of each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those of a tile of pixels, share their tests.
    #[must_use]
    pub fn closest_of_each(&self, rays: &[Ray]) -> Vec<Option<RayHit>> {
        let mut hits = Vec::new();
        self.closest_of_each_into(rays, &mut hits);
        hits
    }

    /// [`Self::closest_of_each`], replacing the contents of `hits` and reusing its memory.
    pub fn closest_of_each_into(&self, rays: &[Ray], hits: &mut Vec<Option<RayHit>>) {
        self.trace_batch::<ClosestHit>(rays, hits);
    }

    /// [`Self::any`] for each of many rays, on all threads of the current pool. Consecutive rays that
    /// run close together, as those from one light to a tile of pixels, share their tests.
    #[must_use]
    pub fn any_of_each(&self, rays: &[Ray]) -> Vec<bool> {
        let mut hits = Vec::new();
        self.any_of_each_into(rays, &mut hits);
        hits
    }

    /// [`Self::any_of_each`], replacing the contents of `hits` and reusing its memory.
    pub fn any_of_each_into(&self, rays: &[Ray], hits: &mut Vec<bool>) {
        self.trace_batch::<AnyHit>(rays, hits);
    }

    /// [`Self::closest`] for each of a few rays, up to a thousand or so, on this thread: for programs whose
    /// threads have rays of their own.
    ///
    /// # Panics
    /// If `hits` isn't as long as `rays`.
    pub fn closest_of_few(&self, rays: &[Ray], hits: &mut [Option<RayHit>]) {
        assert_eq!(rays.len(), hits.len(), "each ray has an answer");
        trace_here::<ClosestHit>(&self.0, rays, true, hits);
    }

    /// [`Self::any`] for each of a few rays, up to a thousand or so, on this thread: for programs whose
    /// threads have rays of their own.
    ///
    /// # Panics
    /// If `hits` isn't as long as `rays`.
    pub fn any_of_few(&self, rays: &[Ray], hits: &mut [bool]) {
        assert_eq!(rays.len(), hits.len(), "each ray has an answer");
        trace_here::<AnyHit>(&self.0, rays, true, hits);
    }

    /// [`Self::any_of_few`] for rays that go all ways: none is looked at for what it shares with others.
    ///
    /// # Panics
    /// If `hits` isn't as long as `rays`.
    pub fn any_of_incoherent(&self, rays: &[Ray], hits: &mut [bool]) {
        assert_eq!(rays.len(), hits.len(), "each ray has an answer");
        trace_here::<AnyHit>(&self.0, rays, false, hits);
    }

    /// [`Self::any_of_few`] for rays in columns: sets a bit for each lane whose ray hits anything. Up to four
    /// columns are traced as one packet.
    ///
    /// # Panics
    /// If `hits` isn't as long as `rays`.
    pub fn any_of_columns(&self, rays: &[RayColumns], hits: &mut [u32]) {
        assert_eq!(rays.len(), hits.len(), "each ray has an answer");
        any_of_columns(&self.0, rays, hits);
    }

    fn trace_batch<Q: RayQuery>(&self, rays: &[Ray], answers: &mut Vec<Q::Answer>) {
        answers.resize(rays.len(), Q::MISS);
        trace_batch::<Q>(&self.0, rays, answers);
    }

    /// Most rays of an image end here: inlined into the caller, without the prologue and epilogue of
    /// the traversal, a camera's rays one at a time take 0.95 to 0.98 of the time. Every level has
    /// vectors of four.
    #[inline(always)]
    fn set_up(&self, ray: &Ray) -> RaySetup {
        dispatch_long!(Level::baseline(), simd => set_up(simd, &self.0, ray))
    }

    #[inline(never)]
    fn closest_within(&self, ray: &Ray, slabs: &RaySlabs, hit: &mut Option<RayHit>) {
        trace_usual::<ClosestHit>(&self.0, ray, slabs, hit);
    }

    #[inline(never)]
    fn any_within(&self, ray: &Ray, slabs: &RaySlabs) -> bool {
        let mut hit = false;
        trace_usual::<AnyHit>(&self.0, ray, slabs, &mut hit);
        hit
    }
}
