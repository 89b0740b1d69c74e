//! Single-ray traversal.
//!
//! Most rays of an image miss the mesh or visit a few nodes, so the work before the first node counts
//! as much as the work per node: the setup handles the three axes in one vector with one division, and
//! tests the box around all first. Of the children that a ray hits, the nearest stays in a register and
//! only the others go onto the stack. All of them are prefetched before their order is known, since a
//! ray in a large tree mostly waits for memory and so waits for several lines at once.

use super::query::RayQuery;
use super::stack::{STACKS, TURNS, TraversalStack};
use super::target::{NearestHit, RayTarget};
use crate::intersect::{ALMOST_ZERO, PADDING, ShearedRay, intersect_block, padding, shifted};
use crate::ray::{Ray, USUAL_LENGTHS};
use crate::tree::{Child, WIDTH, block_at};
use luxel_math::{Level, Simd, dispatch_long, f32x4, f32x8, i32x4, prelude::*};

/// A ray in the form of the slab test, axis by axis; the fourth lane never decides. Kept in memory, from
/// where the processor broadcasts a value to all lanes in one instruction.
#[derive(Clone, Copy)]
pub(crate) struct RaySlabs {
    /// The origins for near planes and far planes.
    near_origin: [f32; 4],
    far_origin: [f32; 4],
    /// The reciprocal direction.
    inverse: [f32; 4],
    /// A bit for each axis where the near plane is the high one.
    reversed: u32,
}

/// The result of setting up a ray.
pub(crate) enum RaySetup {
    /// The ray isn't finite, or its direction is 0 or of an unusual length.
    Unusual,
    /// It misses the box around all.
    Misses,
    /// It hits that box.
    Hits(RaySlabs),
}

/// Gives a sign, a bit in each lane, to values that are not negative.
#[inline(always)]
fn with_sign<S: Simd>(values: f32x4<S>, sign: i32x4<S>) -> f32x4<S> {
    (values.bitcast::<i32x4<S>>() | sign).bitcast()
}

/// Prepares a ray and tests it against the box around all. Rounding is monotone, so a ray that misses
/// this box misses the boxes inside.
#[inline(always)]
pub(crate) fn set_up<S: Simd>(simd: S, target: &RayTarget<'_>, ray: &Ray) -> RaySetup {
    let ([ox, oy, oz], [dx, dy, dz]) = (ray.origin, ray.direction);
    let [nearest, farthest] = ray.range;
    // The fourth lanes are what follows in memory and don't count.
    let origin = f32x4::simd_from(simd, [ox, oy, oz, dx]);
    let direction = f32x4::simd_from(simd, [dx, dy, dz, nearest]);
    let (size, length) = (SimdBase::abs(origin), SimdBase::abs(direction));
    let bounded = size.simd_lt(f32::INFINITY) & length.simd_lt(USUAL_LENGTHS.end);
    let long = length.simd_ge(USUAL_LENGTHS.start);
    if bounded.to_bitmask() & 0b111 != 0b111 || long.to_bitmask() & 0b111 == 0 {
        return RaySetup::Unusual;
    }
    let sign = direction.bitcast::<i32x4<S>>() & i32::MIN;
    let largest = f32x4::simd_from(simd, target.largest);
    let pad = padding(size, largest, f32x4::splat(simd, PADDING));
    let one = f32x4::splat(simd, 1.0);
    let inverse = with_sign(one / length.max(f32x4::splat(simd, ALMOST_ZERO)), sign);
    let [near_origin, far_origin] = shifted(origin, with_sign(pad, sign));
    let reversed = direction.bitcast::<i32x4<S>>().simd_lt(0);
    let low = f32x4::simd_from(simd, target.bounds[0]);
    let high = f32x4::simd_from(simd, target.bounds[1]);
    let (first, last) = (reversed.select(high, low), reversed.select(low, high));
    let near = (first - near_origin) * inverse;
    let far = (last - far_origin) * inverse;
    let near = near.max(near.slide::<1>(near)).max(near.slide::<2>(near).max(nearest));
    let far = far.min(far.slide::<1>(far)).min(far.slide::<2>(far).min(farthest));
    if near.simd_le(far).to_bitmask() & 1 == 0 || !ray.has_range() {
        return RaySetup::Misses;
    }
    RaySetup::Hits(RaySlabs {
        near_origin: near_origin.into(),
        far_origin: far_origin.into(),
        inverse: inverse.into(),
        reversed: reversed.to_bitmask() as u32 & 0b111,
    })
}

/// An axis of a ray, broadcast for slab tests of eight boxes.
#[derive(Clone, Copy)]
struct Axis<S: Simd> {
    near_origin: f32x8<S>,
    far_origin: f32x8<S>,
    inverse: f32x8<S>,
    /// 0 where the near plane is the low one, else 1.
    reversed: usize,
}

impl<S: Simd> Axis<S> {
    #[inline(always)]
    fn new(simd: S, slabs: &RaySlabs, axis: usize) -> Self {
        Self {
            near_origin: f32x8::splat(simd, slabs.near_origin[axis]),
            far_origin: f32x8::splat(simd, slabs.far_origin[axis]),
            inverse: f32x8::splat(simd, slabs.inverse[axis]),
            reversed: (slabs.reversed >> axis) as usize & 1,
        }
    }

    /// The ray's interval between two planes, for each of eight boxes.
    #[inline(always)]
    fn interval(&self, simd: S, planes: &[[f32; WIDTH]; 2]) -> [f32x8<S>; 2] {
        let near_plane = f32x8::simd_from(simd, planes[self.reversed & 1]);
        let far_plane = f32x8::simd_from(simd, planes[(self.reversed ^ 1) & 1]);
        [
            (near_plane - self.near_origin) * self.inverse,
            (far_plane - self.far_origin) * self.inverse,
        ]
    }
}

/// A traversal in progress.
struct Traversal<S: Simd> {
    x: Axis<S>,
    y: Axis<S>,
    z: Axis<S>,
    /// The interval that still counts.
    start: f32x8<S>,
    farthest: f32x8<S>,
    range_start: f32,
    sheared: ShearedRay,
    nearest: NearestHit,
    /// The subtree to visit next, and the number of entries on the stack.
    child: Child,
    top: usize,
}

impl<S: Simd> Traversal<S> {
    #[inline(always)]
    fn new(simd: S, slabs: &RaySlabs, ray: &Ray) -> Self {
        Self {
            x: Axis::new(simd, slabs, 0),
            y: Axis::new(simd, slabs, 1),
            z: Axis::new(simd, slabs, 2),
            start: f32x8::splat(simd, ray.range[0]),
            farthest: f32x8::splat(simd, ray.range[1]),
            range_start: ray.range[0],
            sheared: ShearedRay::with_inverse(&ray.origin, &ray.direction, &slabs.inverse),
            nearest: NearestHit::before(ray.range[1]),
            child: Child::inner(0),
            top: 0,
        }
    }

    /// Visits one node or block; returns whether there is more. `IN_TURNS`: other rays visit theirs before
    /// this one continues, so a single child is worth prefetching.
    #[inline(always)]
    fn advance<Q: RayQuery, const IN_TURNS: bool>(
        &mut self,
        simd: S,
        target: &RayTarget<'_>,
        stack: &TraversalStack,
    ) -> bool {
        if let Some(start) = self.child.as_block() {
            let Some(block) = block_at(target.tree.words, start) else { return false };
            block.prefetch();
            let range = [self.range_start, self.nearest.t];
            let (distances, mut bits) =
                intersect_block(simd, block, target.positions, &self.sheared, range);
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize & (WIDTH - 1);
                bits &= bits - 1;
                let (t, triangle) = (distances[lane], block.triangle(lane));
                let nearest = &self.nearest;
                if t < nearest.t || t == nearest.t && triangle < nearest.triangle {
                    let (block, lane) = (start as u32, lane as u32);
                    self.nearest = NearestHit { t, triangle, block, lane };
                }
            }
            if Q::ANY && self.nearest.is_hit() {
                return false;
            }
            self.farthest = f32x8::splat(simd, self.nearest.t);
            let header = block.header();
            if header.more_follow() {
                self.child = Child::block(start + header.len());
                return true;
            }
        } else {
            let node = &target.tree.nodes[self.child.0 as usize];
            let [of_x, of_y, of_z] = &node.planes;
            let [near_x, far_x] = self.x.interval(simd, of_x);
            let [near_y, far_y] = self.y.interval(simd, of_y);
            let [near_z, far_z] = self.z.interval(simd, of_z);
            // In pairs: a chain of three would be waited for.
            let near = near_x.max(near_y).max(near_z.max(self.start));
            let far = far_x.min(far_y).min(far_z.min(self.farthest));
            let bits = near.simd_le(far).to_bitmask() as u32;
            if bits != 0 {
                let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
                if bits & (bits - 1) == 0 {
                    self.child = node.children[slot];
                    if IN_TURNS {
                        target.tree.prefetch(self.child);
                    }
                } else {
                    let mut distances = [0.0; WIDTH];
                    near.store_slice(&mut distances);
                    let words = node.words();
                    let top = &mut self.top;
                    self.child =
                        Child(stack.push_farther(top, words, &distances, bits, target.tree));
                }
                return true;
            }
        }
        match stack.pop(&mut self.top, self.nearest.t) {
            Some(next) => {
                self.child = Child(next);
                true
            }
            None => false,
        }
    }
}

/// Traces a ray that hits the box around all.
#[inline(always)]
pub(crate) fn trace<S: Simd, Q: RayQuery>(
    simd: S,
    target: &RayTarget<'_>,
    ray: &Ray,
    slabs: &RaySlabs,
    stack: &TraversalStack,
) -> Q::Answer {
    let traversal = traverse::<S, Q>(simd, target, ray, slabs, stack);
    Q::answer(target, &traversal.sheared, traversal.nearest)
}

#[inline(always)]
fn traverse<S: Simd, Q: RayQuery>(
    simd: S,
    target: &RayTarget<'_>,
    ray: &Ray,
    slabs: &RaySlabs,
    stack: &TraversalStack,
) -> Traversal<S> {
    let mut traversal = Traversal::new(simd, slabs, ray);
    while traversal.advance::<Q, false>(simd, target, stack) {}
    traversal
}

/// [`trace`] at the target's SIMD level. Writes the answer where it is wanted: returning it would copy
/// parts that were just stored, and stall.
#[inline(always)]
pub(crate) fn trace_usual<Q: RayQuery>(
    target: &RayTarget<'_>,
    ray: &Ray,
    slabs: &RaySlabs,
    answer: &mut Q::Answer,
) {
    STACKS.with(|stacks| {
        dispatch_long!(target.level, simd => *answer = trace::<_, Q>(simd, target, ray, slabs, &stacks.turns[0]));
    });
}

/// Traces a ray of unusual length, rescaled; a ray that isn't sound hits nothing.
///
/// Uses a stack of its own: rays of the same batch may be on their way.
#[cold]
#[inline(never)]
pub(crate) fn trace_unusual<Q: RayQuery>(target: &RayTarget<'_>, ray: &Ray) -> Q::Answer {
    if !ray.is_sound() || ray.is_usual() {
        return Q::MISS;
    }
    let (scaled, scale) = ray.scaled();
    let setup = dispatch_long!(Level::baseline(), simd => set_up(simd, target, &scaled));
    let RaySetup::Hits(slabs) = setup else { return Q::MISS };
    let mut nearest = NearestHit::before(0.0);
    STACKS.with(|stacks| {
        dispatch_long!(target.level, simd => nearest = traverse::<_, Q>(simd, target, &scaled, &slabs, &stacks.rescaled).nearest);
    });
    nearest.t *= scale;
    Q::answer(target, &ShearedRay::new(scaled.origin, scaled.direction), nearest)
}

/// Traces the rays whose indices `selected` yields, which have little in common: they take turns, a
/// node or block each, so that one computes while others wait for memory.
///
/// Worth it for incoherent rays in trees of more than 16 MB; in smaller ones turns were slower.
#[inline(always)]
pub(crate) fn trace_in_turns<S: Simd, Q: RayQuery>(
    simd: S,
    target: &RayTarget<'_>,
    rays: &[Ray],
    mut selected: impl Iterator<Item = usize>,
    answers: &mut [Q::Answer],
    stacks: &[TraversalStack; TURNS],
) {
    let mut turns: [Option<(Traversal<S>, usize)>; TURNS] = [const { None }; TURNS];
    let mut more = true;
    loop {
        let mut busy = false;
        for (turn, stack) in turns.iter_mut().zip(stacks) {
            if let Some((traversal, index)) = turn {
                busy = true;
                if traversal.advance::<Q, true>(simd, target, stack) {
                    continue;
                }
                answers[*index] = Q::answer(target, &traversal.sheared, traversal.nearest);
                *turn = None;
            }
            // The next ray that hits the box around all.
            while more {
                let Some(index) = selected.next() else {
                    more = false;
                    break;
                };
                let ray = &rays[index];
                match set_up(simd, target, ray) {
                    RaySetup::Unusual => answers[index] = trace_unusual::<Q>(target, ray),
                    RaySetup::Misses => {}
                    RaySetup::Hits(slabs) => {
                        *turn = Some((Traversal::new(simd, &slabs, ray), index));
                        busy = true;
                        break;
                    }
                }
            }
        }
        if !busy {
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::build::Quality;
    use crate::bvh::Bvh;
    use crate::traverse::query::{AnyHit, ClosestHit};

    /// Rays that take turns in a tree of any size, some of them of unusual length.
    #[test]
    fn rays_that_are_rescaled_leave_those_that_wait_alone() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 40) as f32 / (1 << 23) as f32 - 1.0
        };
        let mut positions: Vec<[f32; 3]> = Vec::new();
        for _ in 0..4000 {
            let corner = [next(), next(), next()];
            positions.push(corner);
            positions.push([corner[0] + 0.4 * next(), corner[1] + 0.4 * next(), corner[2]]);
            positions.push([corner[0], corner[1] + 0.4 * next(), corner[2] + 0.4 * next()]);
        }
        let triangles: Vec<[u32; 3]> =
            (0..4000).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect();
        let bvh = Bvh::build(&positions, &triangles, Quality::Thorough).expect("there are few");
        let target = RayTarget::new(&bvh, &positions, Level::baseline());
        let mut ray = |at: usize| {
            let scale = if at.is_multiple_of(3) { 1e-20 } else { 1.0 };
            let direction = [next() * scale, next() * scale, next() * scale];
            Ray::new([2.0 * next(), 2.0 * next(), 2.0 * next()], direction)
        };
        let rays: Vec<Ray> = (0..2000).map(&mut ray).collect();
        let all = 0..rays.len();
        let (mut hits, mut any) = (vec![None; rays.len()], vec![false; rays.len()]);
        STACKS.with(|stacks| {
            dispatch_long!(Level::baseline(), simd => {
                trace_in_turns::<_, ClosestHit>(simd, &target, &rays, all.clone(), &mut hits, &stacks.turns);
                trace_in_turns::<_, AnyHit>(simd, &target, &rays, all.clone(), &mut any, &stacks.turns);
            });
        });
        assert!(any.iter().filter(|hit| **hit).count() > 300);
        for (at, ray) in rays.iter().enumerate() {
            let setup = dispatch_long!(Level::baseline(), simd => set_up(simd, &target, ray));
            let mut expected = None;
            match setup {
                RaySetup::Unusual => expected = trace_unusual::<ClosestHit>(&target, ray),
                RaySetup::Misses => {}
                RaySetup::Hits(slabs) => {
                    trace_usual::<ClosestHit>(&target, ray, &slabs, &mut expected);
                }
            }
            assert_eq!((hits[at], any[at]), (expected, expected.is_some()), "{ray:?}");
        }
    }
}
