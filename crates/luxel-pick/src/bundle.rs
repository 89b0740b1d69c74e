//! Rays that run close together, followed through the tree as one.
//!
//! Sixty-four rays, as those of a tile of 8x8 pixels, mostly meet the same nodes. So a node is asked
//! once, with intervals that hold the origins and directions of all (Reshetov, Soupikov and Hurley
//! 2005; Wald, Benthin and Boulos 2008): what no ray of the interval meets, none of the bundle does.
//! Where a leaf is reached, its box is asked for each ray, eight or sixteen side by side, by the same
//! operations as for a ray alone; and triangles by those rays that meet the box. Rounding is monotone, so the
//! intervals hold what each ray would compute, and a ray gets the same triangle and the same bits of
//! the distance as alone.

use crate::bvh::{ALMOST_ZERO, Ahead, Node, PADDING, Places, WIDTH, moved, padding};
use crate::intersect::{Nearest, Ray, axes};
use crate::kind::{Common, Kind, ROWS, Signs, take_eight};
use crate::leaf::meet_leaf;
use crate::rays::{MeshRays, RayHit};
use crate::row::{BUNDLE, NO_ROW, Range, Row, ShearedRows, greatest, load, one, store, width};
use luxel_math::{LANES, Simd, f32x8, prelude::*};

/// Fewer are followed one by one.
pub(crate) const LEAST: usize = 8;
/// Most groups of a bundle.
pub(crate) const GROUPS: usize = BUNDLE / WIDTH;

/// How far directions may spread, as differences of slopes along the longest axis, and origins, in
/// extents of the scene: beyond it, the interval meets too much.
const SPREAD: f32 = 0.25;

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

/// Rays of one kind, side by side; axes x, y and z but where said. Rows come first, so that each of
/// their sixteens is a cache line.
#[repr(C, align(64))]
pub(crate) struct Bundle {
    /// As they came: origins and directions, axis by axis, and ranges.
    rows: [Row; ROWS],
    /// Of those groups of which any ray meets the box around all, and which groups these are.
    pub(crate) near_origin: [Row; 3],
    pub(crate) far_origin: [Row; 3],
    pub(crate) inverse: [Row; 3],
    pub(crate) start: Row,
    /// Origins and shears in the order of the bundle's axes.
    pub(crate) sheared: ShearedRows,
    pub(crate) nearest: Row,
    pub(crate) triangle: [u32; BUNDLE],
    pub(crate) block: [u32; BUNDLE],
    pub(crate) lane: [u32; BUNDLE],
    numbers: [usize; GROUPS],
    /// How many groups there are.
    pub(crate) count: usize,
    pub(crate) longest: usize,
    pub(crate) axes: [usize; 3],
    pub(crate) turned: [usize; 3],
}

impl Bundle {
    pub(crate) fn new() -> Self {
        Self {
            rows: [NO_ROW; ROWS],
            near_origin: [NO_ROW; 3],
            far_origin: [NO_ROW; 3],
            inverse: [NO_ROW; 3],
            start: NO_ROW,
            sheared: ShearedRows { origin: [NO_ROW; 3], shear: [NO_ROW; 3] },
            nearest: NO_ROW,
            triangle: [0; BUNDLE],
            block: [0; BUNDLE],
            lane: [0; BUNDLE],
            numbers: [0; GROUPS],
            count: 0,
            longest: 0,
            axes: [0; 3],
            turned: [0; 3],
        }
    }

    /// Takes up to 64 rays as they come; their kind, if they are of one.
    #[inline(always)]
    pub(crate) fn take<S: Simd>(&mut self, simd: S, followed: &[Ray]) -> Option<Kind> {
        let first = followed.first()?;
        let mut common = Common::default();
        for (number, sixteen) in followed.chunks(LANES).enumerate() {
            let (low, high) = sixteen.split_at(WIDTH.min(sixteen.len()));
            let (low, signs) = take_up_to_eight(simd, low, first);
            common.include(signs);
            let (high, signs) = take_up_to_eight(simd, high, first);
            common.include(signs);
            self.put(number, sixteen.len(), low, high);
        }
        common.kind()
    }

    /// Takes rays by their places among others.
    #[inline(always)]
    pub(crate) fn take_places<S: Simd>(&mut self, simd: S, followed: &[Ray], places: &[u8]) {
        let Some(&first) = places.first() else { return };
        for (number, sixteen) in places.chunks(LANES).enumerate() {
            let ray = |lane: usize| &followed[usize::from(*sixteen.get(lane).unwrap_or(&first))];
            let low = [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)];
            let high = [ray(8), ray(9), ray(10), ray(11), ray(12), ray(13), ray(14), ray(15)];
            let ((low, _), (high, _)) = (take_eight(simd, low), take_eight(simd, high));
            self.put(number, sixteen.len(), low, high);
        }
    }

    /// Keeps sixteen rays, of which the first `count` are some.
    #[inline(always)]
    fn put<S: Simd>(
        &mut self,
        number: usize,
        count: usize,
        low: [f32x8<S>; ROWS],
        high: [f32x8<S>; ROWS],
    ) {
        for (row, (low, high)) in self.rows.iter_mut().zip(low.into_iter().zip(high)) {
            low.combine(high).store_slice(&mut row[number % (BUNDLE / LANES)]);
        }
        // What is no ray ends before it begins.
        for end in &mut self.rows[ROWS - 1][number % (BUNDLE / LANES)][count.min(LANES)..] {
            *end = -1.0;
        }
    }

    /// Makes what was taken ready, `count` rays of one kind; whether they run close enough together.
    #[inline(always)]
    pub(crate) fn ready<N: Number>(
        &mut self,
        like: N,
        rays: &MeshRays<'_>,
        kind: Kind,
        count: usize,
    ) -> bool {
        self.turned = kind.turned();
        self.longest = kind.longest();
        self.axes = axes(self.longest);
        self.count = 0;
        let mut slopes = [Range::none(like); 2];
        let mut origins = [Range::none(like); 3];
        for number in 0..count.div_ceil(width::<N>()).min(BUNDLE / width::<N>()) {
            let group = self.count;
            let start = load(like, &self.rows[6], number);
            let end = load(like, &self.rows[7], number);
            let (mut near, mut far) = (start, end);
            for axis in 0..3 {
                let origin = load(like, &self.rows[axis], number);
                let along = load(like, &self.rows[3 + axis], number);
                let turned = self.turned[axis] & 1;
                let sign = like.constant(if turned != 0 { -1.0 } else { 1.0 });
                let largest = like.constant(rays.largest[axis]);
                let pad = padding(origin.abs(), largest, like.constant(PADDING));
                let [near_origin, far_origin] = moved(origin, sign * pad);
                let length = along.abs().maximum(like.constant(ALMOST_ZERO));
                let inverse = sign * (like.one() / length);
                let near_plane = like.constant(rays.bounds[turned][axis]);
                let far_plane = like.constant(rays.bounds[turned ^ 1][axis]);
                near = ((near_plane - near_origin) * inverse).maximum(near);
                far = ((far_plane - far_origin) * inverse).minimum(far);
                store(near_origin, &mut self.near_origin[axis], group);
                store(far_origin, &mut self.far_origin[axis], group);
                store(inverse, &mut self.inverse[axis], group);
            }
            let meets = near.less_or_equal(far);
            if !meets.any() {
                continue;
            }
            store(start, &mut self.start, group);
            // What misses the box around all ends before it begins.
            store(end.select(meets, like.constant(-1.0)), &mut self.nearest, group);
            self.numbers[group % GROUPS] = number;
            let [kx, ky, kz] = self.axes.map(|axis| axis.min(2));
            for (to, axis) in [kx, ky, kz].into_iter().enumerate() {
                let origin = load(like, &self.rows[axis], number);
                store(origin, &mut self.sheared.origin[to], group);
            }
            let inverse = load(like, &self.inverse[kz], group);
            let first = load(like, &self.rows[3 + kx], number) * inverse;
            let second = load(like, &self.rows[3 + ky], number) * inverse;
            store(first, &mut self.sheared.shear[0], group);
            store(second, &mut self.sheared.shear[1], group);
            store(inverse, &mut self.sheared.shear[2], group);
            slopes[0].include(first);
            slopes[1].include(second);
            for axis in 0..3 {
                origins[axis].include(load(like, &self.rows[axis], number));
            }
            self.count += 1;
        }
        if self.count == 0 {
            return true;
        }
        self.triangle = [u32::MAX; BUNDLE];
        slopes.iter().all(|range| range.width() <= SPREAD)
            && origins.iter().all(|range| range.width() <= SPREAD * rays.extent())
    }

    /// Writes the hits to their rays' places.
    #[inline(always)]
    pub(crate) fn tell<N: Number>(
        &self,
        _like: N,
        rays: &MeshRays<'_>,
        hits: &mut [Option<RayHit>],
        place: impl Fn(usize) -> usize,
    ) {
        let width = width::<N>();
        for group in 0..self.count.min(BUNDLE / width) {
            for lane in 0..width {
                let ray = group * width + lane;
                let triangle = self.triangle[ray % BUNDLE];
                if triangle != u32::MAX {
                    let sheared = self.ray(ray);
                    let (block, of) = (self.block[ray % BUNDLE], self.lane[ray % BUNDLE]);
                    let nearest = Nearest { t: one(&self.nearest, ray), triangle, block, lane: of };
                    hits[place(self.numbers[group] * width + lane)] = rays.told(&sheared, nearest);
                }
            }
        }
    }

    #[inline(always)]
    fn interval<N: Number>(&self, like: N) -> Interval {
        let mut interval = Interval {
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            inverse: [[0.0; 2]; 3],
            start: 0.0,
        };
        [interval.start, _] = self.range(like, &self.start);
        for axis in 0..3 {
            let near = self.range(like, &self.near_origin[axis]);
            let far = self.range(like, &self.far_origin[axis]);
            // (plane - origin) * inverse is least from the origin that lies farthest ahead.
            let ahead = usize::from(self.turned[axis] == 0);
            interval.near_origin[axis] = near[ahead];
            interval.far_origin[axis] = far[1 - ahead];
            interval.inverse[axis] = self.range(like, &self.inverse[axis]);
        }
        interval
    }

    /// The least and the greatest of a row.
    #[inline(always)]
    fn range<N: Number>(&self, like: N, row: &Row) -> [f32; 2] {
        let mut range = Range::none(like);
        for group in 0..self.count {
            range.include(load(like, row, group));
        }
        range.ends()
    }

    /// The greatest distance that any ray still looks at.
    #[inline(always)]
    fn farthest<N: Number>(&self, like: N) -> f32 {
        let mut farthest = like.constant(-1.0);
        for group in 0..self.count {
            farthest = farthest.maximum(load(like, &self.nearest, group));
        }
        greatest(farthest)
    }
}

/// Up to eight rays, and `first` in place of those that are missing.
#[inline(always)]
fn take_up_to_eight<S: Simd>(simd: S, rays: &[Ray], first: &Ray) -> ([f32x8<S>; ROWS], Signs) {
    if let Some([a, b, c, d, e, f, g, h]) = rays.first_chunk::<WIDTH>() {
        return take_eight(simd, [a, b, c, d, e, f, g, h]);
    }
    let ray = |lane: usize| rays.get(lane).unwrap_or(first);
    take_eight(simd, [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)])
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
            let turned = turned[axis] & 1;
            let near_way =
                f32x8::simd_from(simd, node.planes[axis][turned]) - self.near_origin[axis];
            let far_way =
                f32x8::simd_from(simd, node.planes[axis][turned ^ 1]) - self.far_origin[axis];
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
pub(crate) fn closest_of_bundle<S: Simd, N: Number>(
    simd: S,
    like: N,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    places: &Places,
) {
    let nodes: &[Node] = rays.nodes;
    let ahead = Ahead { nodes, words: rays.words };
    let mut top = 0;
    if bundle.count == 0 {
        return;
    }
    let interval = bundle.interval(like);
    let mut farthest = bundle.farthest(like);
    let mut number = 0;
    loop {
        let (distances, bits) = interval.meet(simd, &nodes[number], bundle.turned, farthest);
        // The node's number times eight, and the slot.
        let mut words = [0; WIDTH];
        for slot in 0..WIDTH {
            words[slot] = (number * WIDTH + slot) as u32;
        }
        ahead.read_children(&nodes[number], bits);
        places.push(&mut top, &words, &distances, bits);
        loop {
            let Some(place) = places.pop(&mut top, farthest) else { return };
            let place = place as usize;
            let (node, slot) = (&nodes[place / WIDTH], place % WIDTH);
            match node.children[slot].as_block() {
                Some(start) => {
                    if meet_leaf(simd, like, rays, bundle, node, slot, start) {
                        farthest = bundle.farthest(like);
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
