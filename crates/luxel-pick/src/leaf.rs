//! A leaf's triangles and the rays of a bundle.

use crate::bundle::{Bundle, GROUPS};
use crate::bvh::{Block, Head, Node, WIDTH, block, number};
use crate::gather::gather;
use crate::intersect::{Sheared, meet_gathered, meet_rays};
use crate::rays::MeshRays;
use crate::row::{BUNDLE, load, one, width};
use luxel_math::{LANES, Simd, prelude::*};

/// Asks a leaf's triangles for the rays that meet its box; whether any was hit.
#[inline(always)]
pub(crate) fn meet_leaf<S: Simd, N: Number>(
    simd: S,
    like: N,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    node: &Node,
    slot: usize,
    mut start: usize,
) -> bool {
    let slot = slot & (WIDTH - 1);
    let (mut near_planes, mut far_planes) = ([like; 3], [like; 3]);
    for axis in 0..3 {
        let turned = bundle.turned[axis] & 1;
        near_planes[axis] = like.constant(node.planes[axis][turned][slot]);
        far_planes[axis] = like.constant(node.planes[axis][turned ^ 1][slot]);
    }
    let mut active = [0_u32; GROUPS];
    let mut any_active = 0;
    for group in 0..bundle.count.min(BUNDLE / width::<N>()) {
        let mut near = load(like, &bundle.start, group);
        let mut far = load(like, &bundle.nearest, group);
        for axis in 0..3 {
            let inverse = load(like, &bundle.inverse[axis], group);
            let near_way = near_planes[axis] - load(like, &bundle.near_origin[axis], group);
            let far_way = far_planes[axis] - load(like, &bundle.far_origin[axis], group);
            near = (near_way * inverse).maximum(near);
            far = (far_way * inverse).minimum(far);
        }
        let bits = near.less_or_equal(far).bits();
        active[group] = bits;
        any_active |= bits;
    }
    if any_active == 0 {
        return false;
    }
    let mut any = false;
    while let Some(block) = block(rays.words, start) {
        any |= meet_block(simd, like, rays, bundle, &active, (block, start as u32));
        let head = Head::of(block);
        if !head.goes_on() {
            break;
        }
        start += head.len();
    }
    any
}

/// Asks a block's triangles for the rays whose bit is set; whether any was hit.
#[inline(always)]
fn meet_block<S: Simd, N: Number>(
    simd: S,
    like: N,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    active: &[u32; GROUPS],
    (block, start): (&Block, u32),
) -> bool {
    let count = Head::of(block).count();
    let gathered = gather(simd, block, rays.positions);
    let is_negative = bundle.turned[bundle.longest] != 0;
    let mut any = false;
    for (group, &active) in active.iter().enumerate() {
        let mut active = active;
        if active == 0 {
            continue;
        }
        if 2 * active.count_ones() as usize <= 3 * count {
            // A ray at a time is a little cheaper than a triangle.
            while active != 0 {
                let ray = group * width::<N>() + active.trailing_zeros() as usize;
                active &= active - 1;
                let sheared = bundle.ray(ray);
                let range = [one(&bundle.start, ray), one(&bundle.nearest, ray)];
                let (distances, mut hits) = meet_gathered(simd, &gathered, count, &sheared, range);
                while hits != 0 {
                    let of = hits.trailing_zeros() as usize & (WIDTH - 1);
                    hits &= hits - 1;
                    any |= bundle.keep(ray, distances[of], number(block, of), [start, of as u32]);
                }
            }
            continue;
        }
        for of in 0..count {
            let corners = [0, 1, 2]
                .map(|corner: usize| bundle.axes.map(|axis| gathered[axis & 3][corner][of & 7]));
            let range = [&bundle.start, &bundle.nearest];
            let sheared = (&bundle.sheared, group);
            let (t, mut hits) = meet_rays(like, corners, sheared, is_negative, range, active);
            if hits == 0 {
                continue;
            }
            let mut distances = [0.0; LANES];
            t.store(&mut distances, 0);
            while hits != 0 {
                let lane = hits.trailing_zeros() as usize & (LANES - 1);
                hits &= hits - 1;
                let ray = group * width::<N>() + lane;
                any |= bundle.keep(ray, distances[lane], number(block, of), [start, of as u32]);
            }
        }
    }
    any
}

impl Bundle {
    /// One of the rays.
    #[inline(always)]
    pub(crate) fn ray(&self, ray: usize) -> Sheared {
        let ([x, y, z], [sx, sy, sz]) = (&self.sheared.origin, &self.sheared.shear);
        Sheared {
            last: self.longest,
            is_negative: self.turned[self.longest] != 0,
            origin: [one(x, ray), one(y, ray), one(z, ray)],
            shear: [one(sx, ray), one(sy, ray), one(sz, ray)],
        }
    }

    /// Takes over a ray's hit if it is nearer; whether it is.
    #[inline(always)]
    fn keep(&mut self, ray: usize, t: f32, triangle: u32, [block, of]: [u32; 2]) -> bool {
        let ray = ray % BUNDLE;
        let nearest = &mut self.nearest.as_flattened_mut()[ray];
        let is_nearer = t < *nearest || t == *nearest && triangle < self.triangle[ray];
        if is_nearer {
            *nearest = t;
            self.triangle[ray] = triangle;
            (self.block[ray], self.lane[ray]) = (block, of);
        }
        is_nearer
    }
}
