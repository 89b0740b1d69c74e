//! Rays that run close together, followed through the tree as one.
//!
//! Sixty-four rays, as those of a tile of 8x8 pixels, mostly meet the same nodes. So a node is asked
//! once, with intervals that hold the origins and directions of all (Reshetov, Soupikov and Hurley
//! 2005; Wald, Benthin and Boulos 2008): what no ray of the interval meets, none of the bundle does.
//! Where a leaf is reached, its box is asked for each ray, eight side by side, by the same operations
//! as for a ray alone; and triangles by those rays that meet the box. Rounding is monotone, so the
//! intervals hold what each ray would compute, and a ray gets the same triangle and the same bits of
//! the distance as alone.

use crate::bvh::{ALMOST_ZERO, Node, PADDING, Stack, WIDTH, higher, lower, moved, padding};
use crate::intersect::{
    Nearest, Ray, Sheared, axes, gather, longest_axis, meet_gathered, meet_rays, shear,
};
use crate::rays::MeshRays;
use luxel_math::{Simd, f32x8, prelude::*};

/// Most rays of a bundle: a miss of a node's box then costs a 64th of a test.
pub(crate) const BUNDLE: usize = EIGHTS * WIDTH;
const EIGHTS: usize = 8;
/// Fewer are followed one by one.
pub(crate) const LEAST: usize = 8;

/// How far directions may spread, as differences of slopes along the longest axis, and origins, in
/// extents of the scene: beyond it, the interval meets too much.
const SPREAD: f32 = 0.25;

/// Eight rays side by side; axes x, y and z but where said.
#[derive(Clone, Copy)]
struct Eight {
    near_origin: [[f32; WIDTH]; 3],
    far_origin: [[f32; WIDTH]; 3],
    inverse: [[f32; WIDTH]; 3],
    start: [f32; WIDTH],
    /// Origins and shears in the order of the bundle's axes.
    sheared: ShearedEight,
    nearest: [f32; WIDTH],
    triangle: [u32; WIDTH],
    record: [u32; WIDTH],
}

/// What triangles are asked with.
#[derive(Clone, Copy)]
pub(crate) struct ShearedEight {
    pub(crate) origin: [[f32; WIDTH]; 3],
    pub(crate) shear: [[f32; WIDTH]; 3],
}

/// Bounds of all rays of a bundle.
#[derive(Clone, Copy)]
struct Interval {
    /// The origins that give the nearest near planes and the farthest far ones.
    near_origin: [f32; 3],
    far_origin: [f32; 3],
    /// The least and the greatest.
    inverse: [[f32; 2]; 3],
    start: f32,
}

/// Rays of one kind, side by side.
pub(crate) struct Bundle {
    eights: [Eight; EIGHTS],
    /// How many eights have rays.
    count: usize,
    axes: [usize; 3],
    turned: [usize; 3],
}

/// What the rays of a bundle have in common: the signs of their directions, a bit each, and the
/// longest axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Kind(u8);

impl Kind {
    /// Of rays that are followed alone: unsound ones, and those of unusual lengths.
    pub(crate) const NONE: Self = Self(3 << 3);
    pub(crate) const COUNT: usize = 1 << 5;

    #[inline(always)]
    pub(crate) fn number(self) -> usize {
        usize::from(self.0) & (Self::COUNT - 1)
    }

    #[inline(always)]
    pub(crate) fn of(ray: &Ray) -> Self {
        if !ray.is_sound() || !ray.is_usual() {
            return Self::NONE;
        }
        let turned = |axis: usize| u8::from(ray.direction[axis].is_sign_negative()) << axis;
        Self(turned(0) | turned(1) | turned(2) | (longest_axis(ray.direction) as u8) << 3)
    }

    fn turned(self) -> [usize; 3] {
        [0, 1, 2].map(|axis| usize::from(self.0 >> axis & 1))
    }

    fn axes(self) -> [usize; 3] {
        let longest = usize::from(self.0 >> 3).min(2);
        axes(longest, self.turned()[longest] != 0)
    }
}

const NO_RAYS: Eight = Eight {
    near_origin: [[0.0; WIDTH]; 3],
    far_origin: [[0.0; WIDTH]; 3],
    inverse: [[0.0; WIDTH]; 3],
    start: [0.0; WIDTH],
    sheared: ShearedEight { origin: [[0.0; WIDTH]; 3], shear: [[0.0; WIDTH]; 3] },
    nearest: [0.0; WIDTH],
    triangle: [0; WIDTH],
    record: [0; WIDTH],
};

impl Bundle {
    pub(crate) fn new() -> Self {
        Self { eights: [NO_RAYS; EIGHTS], count: 0, axes: [0; 3], turned: [0; 3] }
    }

    /// Takes up to 64 rays of one kind, by their places among others; whether they run close enough
    /// together.
    #[inline(always)]
    pub(crate) fn fill<S: Simd>(
        &mut self,
        simd: S,
        rays: &MeshRays<'_>,
        kind: Kind,
        followed: &[Ray],
        places: &[u8],
    ) -> bool {
        let Some(&first) = places.first() else { return false };
        self.turned = kind.turned();
        self.axes = kind.axes();
        self.count = places.len().div_ceil(WIDTH).min(EIGHTS);
        let mut slopes = [Range::none(simd); 2];
        let mut origins = [Range::none(simd); 3];
        for (number, eight) in self.eights[..self.count].iter_mut().enumerate() {
            let (mut origin, mut direction) = ([[0.0; WIDTH]; 3], [[0.0; WIDTH]; 3]);
            for lane in 0..WIDTH {
                // What is left of the last eight repeats the first ray, and ends before it begins.
                let place = places.get(number * WIDTH + lane);
                let ray = &followed[usize::from(*place.unwrap_or(&first))];
                for axis in 0..3 {
                    origin[axis][lane] = ray.origin[axis];
                    direction[axis][lane] = ray.direction[axis];
                }
                eight.start[lane] = ray.range[0];
                eight.nearest[lane] = if place.is_some() { ray.range[1] } else { -1.0 };
            }
            (eight.triangle, eight.record) = ([u32::MAX; WIDTH], [u32::MAX; WIDTH]);
            let mut along = [f32x8::splat(simd, 0.0); 3];
            let one = f32x8::splat(simd, 1.0);
            for axis in 0..3 {
                let origin = f32x8::simd_from(simd, origin[axis]);
                along[axis] = f32x8::simd_from(simd, direction[axis]);
                let sign = if self.turned[axis] != 0 { -1.0 } else { 1.0 };
                let sign = f32x8::splat(simd, sign);
                let largest = f32x8::splat(simd, rays.largest()[axis]);
                let pad = padding(SimdBase::abs(origin), largest, f32x8::splat(simd, PADDING));
                let [near, far] = moved(origin, sign * pad);
                near.store_slice(&mut eight.near_origin[axis]);
                far.store_slice(&mut eight.far_origin[axis]);
                let length = SimdBase::abs(along[axis]).max(f32x8::splat(simd, ALMOST_ZERO));
                (sign * (one / length)).store_slice(&mut eight.inverse[axis]);
                origins[axis].include(origin);
            }
            let [kx, ky, kz] = self.axes.map(|axis| axis.min(2));
            eight.sheared.origin = [origin[kx], origin[ky], origin[kz]];
            let sheared = shear([along[kx], along[ky], along[kz]], one);
            for place in 0..3 {
                sheared[place].store_slice(&mut eight.sheared.shear[place]);
            }
            slopes[0].include(sheared[0]);
            slopes[1].include(sheared[1]);
        }
        slopes.iter().all(|range| range.width() <= SPREAD)
            && origins.iter().all(|range| range.width() <= SPREAD * rays.extent())
    }

    /// The nearest hit of a ray, by its place.
    pub(crate) fn nearest(&self, place: usize) -> Nearest {
        let (eight, lane) = (&self.eights[place / WIDTH], place % WIDTH);
        Nearest {
            t: eight.nearest[lane],
            triangle: eight.triangle[lane],
            record: eight.record[lane],
        }
    }

    #[inline(always)]
    fn interval<S: Simd>(&self, simd: S) -> Interval {
        let eights = &self.eights[..self.count];
        let mut interval = Interval {
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            inverse: [[0.0; 2]; 3],
            start: 0.0,
        };
        let mut starts = Range::none(simd);
        for eight in eights {
            starts.include(f32x8::simd_from(simd, eight.start));
        }
        [interval.start, _] = starts.ends();
        for axis in 0..3 {
            let mut ranges = [Range::none(simd); 3];
            for eight in eights {
                ranges[0].include(f32x8::simd_from(simd, eight.near_origin[axis]));
                ranges[1].include(f32x8::simd_from(simd, eight.far_origin[axis]));
                ranges[2].include(f32x8::simd_from(simd, eight.inverse[axis]));
            }
            let [near, far, inverse] = [ranges[0].ends(), ranges[1].ends(), ranges[2].ends()];
            // (plane - origin) * inverse is least from the origin that lies farthest ahead.
            let ahead = usize::from(self.turned[axis] == 0);
            interval.near_origin[axis] = near[ahead];
            interval.far_origin[axis] = far[1 - ahead];
            interval.inverse[axis] = inverse;
        }
        interval
    }

    /// The greatest distance that any ray still looks at.
    #[inline(always)]
    fn farthest<S: Simd>(&self, simd: S) -> f32 {
        let mut farthest = f32x8::splat(simd, -1.0);
        for eight in &self.eights[..self.count] {
            farthest = farthest.max(f32x8::simd_from(simd, eight.nearest));
        }
        greatest(farthest)
    }
}

/// The least and the greatest of several eights, lane by lane.
#[derive(Clone, Copy)]
struct Range<S: Simd> {
    least: f32x8<S>,
    greatest: f32x8<S>,
}

impl<S: Simd> Range<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        let (least, greatest) = (f32::INFINITY, f32::NEG_INFINITY);
        Self { least: f32x8::splat(simd, least), greatest: f32x8::splat(simd, greatest) }
    }

    #[inline(always)]
    fn include(&mut self, values: f32x8<S>) {
        self.least = self.least.min(values);
        self.greatest = self.greatest.max(values);
    }

    /// The least and the greatest of all.
    #[inline(always)]
    fn ends(&self) -> [f32; 2] {
        let least = (1..WIDTH).fold(self.least[0], |end, lane| lower(self.least[lane], end));
        [least, greatest(self.greatest)]
    }

    #[inline(always)]
    fn width(&self) -> f32 {
        let [least, greatest] = self.ends();
        greatest - least
    }
}

/// The greatest of eight.
#[inline(always)]
fn greatest<S: Simd>(values: f32x8<S>) -> f32 {
    (1..WIDTH).fold(values[0], |end, lane| higher(values[lane], end))
}

impl Interval {
    /// The least distances at which any ray meets the boxes of a node's children, and a bit for each
    /// that any may meet before `farthest`.
    #[inline(always)]
    fn meet<S: Simd>(
        &self,
        simd: S,
        node: &Node,
        turned: [usize; 3],
        farthest: f32,
    ) -> ([f32; WIDTH], u32) {
        let mut near = f32x8::splat(simd, self.start);
        let mut far = f32x8::splat(simd, farthest);
        for axis in 0..3 {
            let row = 2 * axis;
            let turned = turned[axis] & 1;
            let near_way = f32x8::simd_from(simd, node.rows[row + turned]) - self.near_origin[axis];
            let far_way =
                f32x8::simd_from(simd, node.rows[row + (turned ^ 1)]) - self.far_origin[axis];
            let [least, greatest] = self.inverse[axis];
            near = (near_way * least).min(near_way * greatest).max(near);
            far = (far_way * least).max(far_way * greatest).min(far);
        }
        let mut distances = [0.0; WIDTH];
        near.store_slice(&mut distances);
        (distances, near.simd_le(far).to_bitmask() as u32)
    }
}

/// The nearest triangle for each ray of a bundle.
#[inline(always)]
pub(crate) fn closest_of_bundle<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    stack: &mut Stack,
) {
    let nodes: &[Node] = &rays.tree().nodes;
    stack.clear();
    if nodes.is_empty() {
        return;
    }
    let interval = bundle.interval(simd);
    let mut farthest = bundle.farthest(simd);
    let mut number = 0;
    loop {
        let (distances, bits) = interval.meet(simd, &nodes[number], bundle.turned, farthest);
        stack.push_places(number, &distances, bits);
        loop {
            let Some(place) = stack.pop_place(farthest) else { return };
            let (node, slot) = (&nodes[place / WIDTH], place % WIDTH);
            match node.children[slot].as_leaf() {
                Some(leaf) => {
                    if meet_leaf(simd, rays, bundle, node, slot, leaf) {
                        farthest = bundle.farthest(simd);
                    }
                }
                None => {
                    number = node.children[slot].0 as usize;
                    break;
                }
            }
        }
    }
}

/// Asks a leaf's triangles for the rays that meet its box; whether any was hit.
#[inline(always)]
fn meet_leaf<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    node: &Node,
    slot: usize,
    (start, count): (usize, usize),
) -> bool {
    let Some(records) = rays.records()[start..].first_chunk::<WIDTH>() else { return false };
    let slot = slot & (WIDTH - 1);
    let mut active = [0_u32; EIGHTS];
    let (mut eights, mut singles) = (0, 0);
    for (active, eight) in active.iter_mut().zip(&bundle.eights[..bundle.count]) {
        let mut near = f32x8::simd_from(simd, eight.start);
        let mut far = f32x8::simd_from(simd, eight.nearest);
        for axis in 0..3 {
            let turned = bundle.turned[axis] & 1;
            let near_plane = f32x8::splat(simd, node.rows[2 * axis + turned][slot]);
            let far_plane = f32x8::splat(simd, node.rows[2 * axis + (turned ^ 1)][slot]);
            let inverse = f32x8::simd_from(simd, eight.inverse[axis]);
            near = ((near_plane - f32x8::simd_from(simd, eight.near_origin[axis])) * inverse)
                .max(near);
            far = ((far_plane - f32x8::simd_from(simd, eight.far_origin[axis])) * inverse).min(far);
        }
        *active = near.simd_le(far).to_bitmask() as u32;
        eights += u32::from(*active != 0);
        singles += active.count_ones();
    }
    if singles == 0 {
        return false;
    }
    let mut any = false;
    let gathered = gather(&records[..count.min(WIDTH)], rays.positions());
    if eights * count as u32 <= singles {
        for lane in 0..count.min(WIDTH) {
            let corners = gathered.map(|corner| bundle.axes.map(|axis| corner[axis.min(2)][lane]));
            for (&active, eight) in active.iter().zip(&mut bundle.eights) {
                if active == 0 {
                    continue;
                }
                let range = [eight.start, eight.nearest];
                let (distances, hits) = meet_rays(simd, corners, &eight.sheared, range, active);
                any |= eight.keep(&distances, hits, records[lane][3], (start + lane) as u32);
            }
        }
        return any;
    }
    for (&active, eight) in active.iter().zip(&mut bundle.eights) {
        let mut active = active;
        while active != 0 {
            let lane = active.trailing_zeros() as usize & (WIDTH - 1);
            active &= active - 1;
            let of_lane = |rows: &[[f32; WIDTH]; 3]| rows.map(|row| row[lane]);
            let sheared = Sheared::from_axes(
                bundle.axes,
                of_lane(&eight.sheared.origin),
                of_lane(&eight.sheared.shear),
            );
            let range = [eight.start[lane], eight.nearest[lane]];
            let (distances, mut hits) = meet_gathered(simd, &gathered, count, &sheared, range);
            while hits != 0 {
                let of = hits.trailing_zeros() as usize & (WIDTH - 1);
                hits &= hits - 1;
                any |= eight.keep_one(lane, distances[of], records[of][3], (start + of) as u32);
            }
        }
    }
    any
}

impl Eight {
    /// Takes over hits of one triangle where they are nearer, a bit a ray.
    #[inline(always)]
    fn keep(
        &mut self,
        distances: &[f32; WIDTH],
        mut hits: u32,
        triangle: u32,
        record: u32,
    ) -> bool {
        let mut any = false;
        while hits != 0 {
            let lane = hits.trailing_zeros() as usize & (WIDTH - 1);
            hits &= hits - 1;
            any |= self.keep_one(lane, distances[lane], triangle, record);
        }
        any
    }

    #[inline(always)]
    fn keep_one(&mut self, lane: usize, t: f32, triangle: u32, record: u32) -> bool {
        let is_nearer =
            t < self.nearest[lane] || t == self.nearest[lane] && triangle < self.triangle[lane];
        if is_nearer {
            self.nearest[lane] = t;
            self.triangle[lane] = triangle;
            self.record[lane] = record;
        }
        is_nearer
    }
}
