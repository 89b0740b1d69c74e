//! One ray through the tree of a mesh, as fast as it goes.
//!
//! Most rays of a picture miss the mesh or meet a few nodes, so what happens before the first node
//! counts as much as what happens at each: a ray is made ready with vectors of its three axes, one
//! division for all. Of a node's children that are met, the nearest stays at hand and only the
//! others go onto the stack. All that are met are read at once, before it is known in which order they
//! are visited: a ray in a large tree mostly waits for memory, and so it waits for several together.

use crate::bvh::{
    ALMOST_ZERO, Ahead, Child, Head, PADDING, Places, WIDTH, block, moved, number, padding,
};
use crate::intersect::{Nearest, Ray, Sheared, USUAL_LENGTHS, meet_block};
use crate::rays::{MeshRays, RayHit};
use luxel_math::{Simd, f32x4, f32x8, i32x4, prelude::*};

/// A ray as boxes want it, axis by axis; the fourth place is the same for all rays. In memory, from
/// where a number comes to all lanes of a vector at once.
#[derive(Clone, Copy)]
pub(crate) struct Lean {
    /// Where near planes are looked at from, and far ones.
    near_origin: [f32; 4],
    far_origin: [f32; 4],
    /// One over the direction.
    inverse: [f32; 4],
    /// A bit for each axis where the near plane is the high one.
    turned: u32,
}

/// What is known of a ray before the first node.
pub(crate) enum Begun {
    /// It isn't finite, has no direction or one of an unusual length.
    Unusual,
    /// It meets nothing.
    Misses,
    /// It meets the box around all.
    Meets(Lean),
}

/// Makes a ray ready and asks the box around all. What misses it misses the boxes inside, as rounding
/// is monotone.
#[inline(always)]
pub(crate) fn begin<S: Simd>(simd: S, rays: &MeshRays<'_>, ray: &Ray) -> Begun {
    let [ox, oy, oz] = ray.origin;
    let [dx, dy, dz] = ray.direction;
    let origin = f32x4::simd_from(simd, [ox, oy, oz, 0.0]);
    let direction = f32x4::simd_from(simd, [dx, dy, dz, 0.0]);
    let (size, length) = (SimdBase::abs(origin), SimdBase::abs(direction));
    let bounded = size.simd_lt(f32::INFINITY) & length.simd_lt(USUAL_LENGTHS.end);
    let long = length.simd_ge(USUAL_LENGTHS.start);
    if bounded.to_bitmask() != 0b1111 || long.to_bitmask() == 0 {
        return Begun::Unusual;
    }
    let largest = f32x4::simd_from(simd, rays.largest);
    let pad = padding(size, largest, f32x4::splat(simd, PADDING));
    let one = f32x4::splat(simd, 1.0);
    let inverse = (one / length.max(f32x4::splat(simd, ALMOST_ZERO))).copysign(direction);
    let [near_origin, far_origin] = moved(origin, pad.copysign(direction));
    let turned = direction.bitcast::<i32x4<S>>().simd_lt(0);
    let low = f32x4::simd_from(simd, rays.bounds[0]);
    let high = f32x4::simd_from(simd, rays.bounds[1]);
    let (first, last) = (turned.select(high, low), turned.select(low, high));
    let near = (first - near_origin) * inverse;
    let far = (last - far_origin) * inverse;
    let near = near.max(near.slide::<2>(near));
    let far = far.min(far.slide::<2>(far));
    let near = near.max(near.slide::<1>(near)).max(ray.range[0]);
    let far = far.min(far.slide::<1>(far)).min(ray.range[1]);
    if near.simd_le(far).to_bitmask() & 1 == 0 || !ray.has_range() {
        return Begun::Misses;
    }
    Begun::Meets(Lean {
        near_origin: near_origin.into(),
        far_origin: far_origin.into(),
        inverse: inverse.into(),
        turned: turned.to_bitmask() as u32,
    })
}

/// An axis of a ray as the boxes of eight children want it.
#[derive(Clone, Copy)]
struct Axis<S: Simd> {
    near_origin: f32x8<S>,
    far_origin: f32x8<S>,
    inverse: f32x8<S>,
    /// 0 where the near plane is the low one, else 1.
    turned: usize,
}

impl<S: Simd> Axis<S> {
    #[inline(always)]
    fn new(simd: S, lean: &Lean, axis: usize) -> Self {
        Self {
            near_origin: f32x8::splat(simd, lean.near_origin[axis]),
            far_origin: f32x8::splat(simd, lean.far_origin[axis]),
            inverse: f32x8::splat(simd, lean.inverse[axis]),
            turned: (lean.turned >> axis) as usize & 1,
        }
    }

    /// The part of a way that lies between two planes, of each of eight boxes.
    #[inline(always)]
    fn cut(
        &self,
        simd: S,
        planes: &[[f32; WIDTH]; 2],
        [near, far]: [f32x8<S>; 2],
    ) -> [f32x8<S>; 2] {
        let near_plane = f32x8::simd_from(simd, planes[self.turned & 1]);
        let far_plane = f32x8::simd_from(simd, planes[(self.turned ^ 1) & 1]);
        [
            ((near_plane - self.near_origin) * self.inverse).max(near),
            ((far_plane - self.far_origin) * self.inverse).min(far),
        ]
    }
}

/// The nearest triangle that a ray meets, of which so much is known.
#[inline(always)]
pub(crate) fn closest<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    ray: &Ray,
    lean: &Lean,
    places: &Places,
) -> Option<RayHit> {
    let (nearest, sheared) = follow::<S, false>(simd, rays, lean, ray, places);
    rays.told(&sheared, nearest)
}

/// The same, without where on the triangle.
#[inline(always)]
pub(crate) fn nearest_alone<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    ray: &Ray,
    lean: &Lean,
    places: &Places,
) -> Nearest {
    follow::<S, false>(simd, rays, lean, ray, places).0
}

/// Whether a ray meets anything.
#[inline(always)]
pub(crate) fn any<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    ray: &Ray,
    lean: &Lean,
    places: &Places,
) -> bool {
    follow::<S, true>(simd, rays, lean, ray, places).0.triangle != u32::MAX
}

/// A ray on its way through the tree.
struct Followed<S: Simd> {
    x: Axis<S>,
    y: Axis<S>,
    z: Axis<S>,
    /// Where it begins, and where what counts ends.
    start: f32x8<S>,
    farthest: f32x8<S>,
    range_start: f32,
    sheared: Sheared,
    nearest: Nearest,
    /// What is visited next, and how many places are to be visited after it.
    child: Child,
    top: usize,
}

impl<S: Simd> Followed<S> {
    #[inline(always)]
    fn new(simd: S, lean: &Lean, ray: &Ray) -> Self {
        Self {
            x: Axis::new(simd, lean, 0),
            y: Axis::new(simd, lean, 1),
            z: Axis::new(simd, lean, 2),
            start: f32x8::splat(simd, ray.range[0]),
            farthest: f32x8::splat(simd, ray.range[1]),
            range_start: ray.range[0],
            sheared: Sheared::with_inverse(&ray.origin, &ray.direction, &lean.inverse),
            nearest: Nearest::before(ray.range[1]),
            child: Child::inner(0),
            top: 0,
        }
    }

    /// Goes on by one node or leaf, before others have their turn or not; whether there is more.
    #[inline(always)]
    fn advance<const ANY: bool, const IN_TURNS: bool>(
        &mut self,
        simd: S,
        rays: &MeshRays<'_>,
        places: &Places,
    ) -> bool {
        if let Some(start) = self.child.as_block() {
            let Some(block) = block(rays.words, start) else { return false };
            Ahead::read_block(block);
            let range = [self.range_start, self.nearest.t];
            let (distances, mut bits) =
                meet_block(simd, block, rays.positions, &self.sheared, range);
            while bits != 0 {
                let lane = bits.trailing_zeros() as usize & (WIDTH - 1);
                bits &= bits - 1;
                let (t, triangle) = (distances[lane], number(block, lane));
                let nearest = &self.nearest;
                if t < nearest.t || t == nearest.t && triangle < nearest.triangle {
                    let (block, lane) = (start as u32, lane as u32);
                    self.nearest = Nearest { t, triangle, block, lane };
                }
            }
            if ANY && self.nearest.triangle != u32::MAX {
                return false;
            }
            self.farthest = f32x8::splat(simd, self.nearest.t);
            let head = Head::of(block);
            if head.goes_on() {
                self.child = Child::block(start + head.len());
                return true;
            }
        } else {
            let node = &rays.nodes[self.child.0 as usize];
            let [of_x, of_y, of_z] = &node.planes;
            let way = self.x.cut(simd, of_x, [self.start, self.farthest]);
            let way = self.y.cut(simd, of_y, way);
            let [near, far] = self.z.cut(simd, of_z, way);
            let bits = near.simd_le(far).to_bitmask() as u32;
            if bits != 0 {
                let slot = bits.trailing_zeros() as usize & (WIDTH - 1);
                let ahead = Ahead { nodes: rays.nodes, words: rays.words };
                if bits & (bits - 1) == 0 {
                    self.child = node.children[slot];
                    if IN_TURNS {
                        ahead.read(self.child);
                    }
                } else {
                    let mut distances = [0.0; WIDTH];
                    near.store_slice(&mut distances);
                    let words = node.words();
                    let top = &mut self.top;
                    self.child = Child(places.push_farther(top, words, &distances, bits, ahead));
                }
                return true;
            }
        }
        match places.pop(&mut self.top, self.nearest.t) {
            Some(next) => {
                self.child = Child(next);
                true
            }
            None => false,
        }
    }
}

/// Follows a ray to the nearest triangle, or to any; and the ray as triangles want it.
#[inline(always)]
fn follow<S: Simd, const ANY: bool>(
    simd: S,
    rays: &MeshRays<'_>,
    lean: &Lean,
    ray: &Ray,
    places: &Places,
) -> (Nearest, Sheared) {
    let mut followed = Followed::new(simd, lean, ray);
    while followed.advance::<ANY, false>(simd, rays, places) {}
    (followed.nearest, followed.sheared)
}

/// Rays that go on in turns: while one waits for memory, the others compute.
pub(crate) const TURNS: usize = 4;

/// The nearest triangle of each ray whose place is told, of rays that share little: they take turns,
/// a node or leaf each.
#[inline(always)]
pub(crate) fn closest_in_turns<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    all: &[Ray],
    mut asked: impl Iterator<Item = usize>,
    hits: &mut [Option<RayHit>],
    places: &[Places; TURNS],
) {
    let mut turns: [Option<(Followed<S>, usize)>; TURNS] = [const { None }; TURNS];
    let mut more = true;
    loop {
        let mut busy = false;
        for (turn, places) in turns.iter_mut().zip(places) {
            if let Some((followed, place)) = turn {
                busy = true;
                if followed.advance::<false, true>(simd, rays, places) {
                    continue;
                }
                hits[*place] = rays.told(&followed.sheared, followed.nearest);
                *turn = None;
            }
            // The next ray that meets the box around all.
            while more {
                let Some(place) = asked.next() else {
                    more = false;
                    break;
                };
                let ray = &all[place];
                match begin(simd, rays, ray) {
                    Begun::Unusual => hits[place] = rays.closest_unusual(ray),
                    Begun::Misses => {}
                    Begun::Meets(lean) => {
                        *turn = Some((Followed::new(simd, &lean, ray), place));
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
