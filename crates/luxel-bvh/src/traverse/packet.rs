//! Packets: up to 64 coherent rays that share their slab tests.
//!
//! The rays of a tile of 8x8 pixels mostly visit the same nodes. A packet tests a node once, with
//! intervals that contain the origins and directions of all its rays (Reshetov, Soupikov and Hurley
//! 2005; Wald, Benthin and Boulos 2008): what the interval misses, every ray misses. Rounding is
//! monotone, so the intervals contain what each ray computes on its own, and a ray gets the same
//! triangle and the same bits of the distance as alone.

use super::packet_kind::{PacketKind, ROWS, SharedSigns, SignBits, load_eight};
use super::query::RayQuery;
use super::target::{NearestHit, RayTarget};
use crate::intersect::{
    ALMOST_ZERO, EMPTY_ROW, LaneRange, PACKET, PADDING, Row, ShearedRay, ShearedRows, greatest,
    lane, load, padding, shifted, store, width,
};
use crate::ray::{Ray, RayColumns, USUAL_LENGTHS, axis_order};
use crate::tree::{Node, WIDTH};
use luxel_math::{LANES, Simd, f32x8, f32x16, prelude::*};
use std::cell::RefCell;

/// Fewer rays are traced singly.
pub(crate) const LEAST: usize = 8;
/// The most groups of a packet.
pub(crate) const GROUPS: usize = PACKET / WIDTH;

/// The largest spread of directions, as differences of slopes along the longest axis, and of origins,
/// relative to the tree's longest side. Wider intervals hit too many boxes.
const SPREAD: f32 = 0.25;

/// Interval bounds of all rays of a packet.
#[derive(Clone, Copy)]
pub(super) struct RayInterval {
    /// The origins that yield the nearest near planes and the farthest far planes.
    pub(super) near_origin: [f32; 3],
    pub(super) far_origin: [f32; 3],
    /// The smallest and largest reciprocal directions.
    inverse: [[f32; 2]; 3],
    /// The smallest and largest shears.
    pub(super) shear: [[f32; 2]; 2],
    start: f32,
}

/// Rays of one kind, side by side. Rows come first, so that sixteen values are a cache line.
#[repr(C, align(64))]
pub(crate) struct Packet {
    /// All rays: origins and directions, axis by axis, and ranges.
    rows: [Row; ROWS],
    /// The groups of which any ray hits the box around all; `numbers` says which groups these are.
    pub(crate) near_origin: [Row; 3],
    pub(crate) far_origin: [Row; 3],
    pub(crate) inverse: [Row; 3],
    pub(crate) start: Row,
    /// Origins and shears in the packet's order of axes.
    pub(crate) sheared: ShearedRows,
    pub(crate) nearest: Row,
    pub(crate) triangle: [u32; PACKET],
    pub(crate) block: [u32; PACKET],
    pub(crate) lane: [u32; PACKET],
    numbers: [usize; GROUPS],
    /// The number of groups.
    pub(crate) count: usize,
    pub(crate) longest: usize,
    pub(crate) axes: [usize; 3],
    pub(crate) reversed: [usize; 3],
}

thread_local! {
    /// The packet of a thread.
    pub(super) static PACKETS: RefCell<Box<Packet>> = RefCell::new(Box::new(Packet::new()));
}

impl Packet {
    pub(crate) fn new() -> Self {
        Self {
            rows: [EMPTY_ROW; ROWS],
            near_origin: [EMPTY_ROW; 3],
            far_origin: [EMPTY_ROW; 3],
            inverse: [EMPTY_ROW; 3],
            start: EMPTY_ROW,
            sheared: ShearedRows { origin: [EMPTY_ROW; 3], shear: [EMPTY_ROW; 3] },
            nearest: EMPTY_ROW,
            triangle: [0; PACKET],
            block: [0; PACKET],
            lane: [0; PACKET],
            numbers: [0; GROUPS],
            count: 0,
            longest: 0,
            axes: [0; 3],
            reversed: [0; 3],
        }
    }

    /// Loads up to 64 rays; returns their kind if they share one.
    #[inline(always)]
    pub(crate) fn load<S: Simd>(&mut self, simd: S, rays: &[Ray]) -> Option<PacketKind> {
        let first = rays.first()?;
        let mut common = SharedSigns::default();
        for (number, sixteen) in rays.chunks(LANES).enumerate() {
            let (low, high) = sixteen.split_at(WIDTH.min(sixteen.len()));
            let low = load_up_to_eight(simd, low, first);
            let columns = combined(low, load_up_to_eight(simd, high, first));
            common.include(SignBits::of(columns));
            self.put(number, sixteen.len(), columns);
        }
        common.kind()
    }

    /// Loads rays by their indices.
    #[inline(always)]
    pub(crate) fn load_selected<S: Simd>(&mut self, simd: S, rays: &[Ray], indices: &[u8]) {
        let Some(&first) = indices.first() else { return };
        for (number, sixteen) in indices.chunks(LANES).enumerate() {
            let ray = |lane: usize| &rays[usize::from(*sixteen.get(lane).unwrap_or(&first))];
            let low = [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)];
            let high = [ray(8), ray(9), ray(10), ray(11), ray(12), ray(13), ray(14), ray(15)];
            let columns = combined(load_eight(simd, low), load_eight(simd, high));
            self.put(number, sixteen.len(), columns);
        }
    }

    /// Loads up to 64 rays that lie side by side; returns their kind if they share one.
    #[inline(always)]
    pub(crate) fn load_columns<S: Simd>(
        &mut self,
        simd: S,
        rays: &[RayColumns],
    ) -> Option<PacketKind> {
        let lanes = f32x16::splat(simd, 0.0);
        let mut common = SharedSigns::default();
        for (number, rays) in rays.iter().enumerate() {
            let number = number % (PACKET / LANES);
            let RayColumns { origin: [ox, oy, oz], direction: [dx, dy, dz], .. } = rays;
            let [nearest, farthest] = &rays.range;
            let mut columns = [ox, oy, oz, dx, dy, dz, nearest, farthest].map(
                #[inline(always)]
                |column| lanes.load(column, 0),
            );
            let full = lanes.all_lanes();
            let mask = lanes.mask_of(rays.lanes);
            if rays.lanes != full {
                // The others repeat the first, so that they widen no interval.
                let first = rays.lanes.trailing_zeros() as usize % LANES;
                for (row, column) in columns.iter_mut().enumerate() {
                    let all = [ox, oy, oz, dx, dy, dz, nearest, farthest];
                    *column = column.select(mask, lanes.constant(all[row][first]));
                }
            }
            common.include(SignBits::of(columns));
            if rays.lanes != full {
                // An empty range.
                columns[ROWS - 1] = columns[ROWS - 1].select(mask, lanes.constant(-1.0));
            }
            for (row, column) in self.rows.iter_mut().zip(columns) {
                column.store_slice(&mut row[number]);
            }
        }
        common.kind()
    }

    /// Stores sixteen rays, of which the first `count` are valid.
    #[inline(always)]
    fn put<S: Simd>(&mut self, number: usize, count: usize, columns: [f32x16<S>; ROWS]) {
        for (row, column) in self.rows.iter_mut().zip(columns) {
            column.store_slice(&mut row[number % (PACKET / LANES)]);
        }
        // The others get an empty range.
        for end in &mut self.rows[ROWS - 1][number % (PACKET / LANES)][count.min(LANES)..] {
            *end = -1.0;
        }
    }

    /// Prepares `count` loaded rays of one kind; returns whether all are valid and of usual lengths.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn prepare<N: Lanes>(
        &mut self,
        lanes: N,
        target: &RayTarget<'_>,
        kind: PacketKind,
        count: usize,
    ) -> bool {
        lanes.vectorized(
            #[inline(always)]
            || self.prepare_here(lanes.zero(), target, kind, count),
        )
    }

    #[inline(always)]
    fn prepare_here<N: Lanes>(
        &mut self,
        lanes: N,
        target: &RayTarget<'_>,
        kind: PacketKind,
        count: usize,
    ) -> bool {
        self.reversed = kind.reversed();
        self.longest = kind.longest();
        self.axes = axis_order(self.longest);
        self.count = 0;
        for number in 0..count.div_ceil(width::<N>()).min(PACKET / width::<N>()) {
            let group = self.count;
            let start = load(lanes, &self.rows[6], number);
            let end = load(lanes, &self.rows[7], number);
            let (mut near, mut far) = (start, end);
            let mut bounded = lanes.zero().less_or_equal(start)
                & end.less_or_equal(lanes.constant(f32::INFINITY));
            for axis in 0..3 {
                let origin = load(lanes, &self.rows[axis], number);
                let along = load(lanes, &self.rows[3 + axis], number);
                let reversed = self.reversed[axis] & 1;
                let sign = lanes.constant(if reversed != 0 { -1.0 } else { 1.0 });
                let largest = lanes.constant(target.largest[axis]);
                let pad = padding(origin.abs(), largest, lanes.constant(PADDING));
                let [near_origin, far_origin] = shifted(origin, sign * pad);
                let length = along.abs().maximum(lanes.constant(ALMOST_ZERO));
                let inverse = sign * (lanes.one() / length);
                // Without finite origins, no interval is one around all rays.
                bounded = bounded
                    & origin.abs().less(lanes.constant(f32::INFINITY))
                    & along.abs().less(lanes.constant(USUAL_LENGTHS.end));
                if axis == self.longest {
                    bounded =
                        bounded & lanes.constant(USUAL_LENGTHS.start).less_or_equal(along.abs());
                }
                let near_plane = lanes.constant(target.bounds[reversed][axis]);
                let far_plane = lanes.constant(target.bounds[reversed ^ 1][axis]);
                near = ((near_plane - near_origin) * inverse).maximum(near);
                far = ((far_plane - far_origin) * inverse).minimum(far);
                store(near_origin, &mut self.near_origin[axis], group);
                store(far_origin, &mut self.far_origin[axis], group);
                store(inverse, &mut self.inverse[axis], group);
            }
            if !bounded.all() {
                return false;
            }
            let reaches = near.less_or_equal(far);
            if !reaches.any() {
                continue;
            }
            store(start, &mut self.start, group);
            // Rays that miss the box around all get an empty range.
            store(end.select(reaches, lanes.constant(-1.0)), &mut self.nearest, group);
            self.numbers[group % GROUPS] = number;
            let [kx, ky, kz] = self.axes.map(|axis| axis.min(2));
            for (to, axis) in [kx, ky, kz].into_iter().enumerate() {
                let origin = load(lanes, &self.rows[axis], number);
                store(origin, &mut self.sheared.origin[to], group);
            }
            let inverse = load(lanes, &self.inverse[kz], group);
            let first = load(lanes, &self.rows[3 + kx], number) * inverse;
            let second = load(lanes, &self.rows[3 + ky], number) * inverse;
            store(first, &mut self.sheared.shear[0], group);
            store(second, &mut self.sheared.shear[1], group);
            store(inverse, &mut self.sheared.shear[2], group);
            self.count += 1;
        }
        self.triangle = [u32::MAX; PACKET];
        true
    }

    /// Writes the answers of rays that hit something; `index` maps a ray of the packet to its answer.
    #[inline(always)]
    pub(crate) fn write_answers<N: Lanes, Q: RayQuery>(
        &self,
        lanes: N,
        target: &RayTarget<'_>,
        answers: &mut [Q::Answer],
        index: impl Fn(usize) -> usize,
    ) {
        let width = width::<N>();
        for group in 0..self.count.min(PACKET / width) {
            let mut hits = self.hits(lanes, group);
            while hits != 0 {
                let at = hits.trailing_zeros() as usize % width;
                hits &= hits - 1;
                let ray = group * width + at;
                let triangle = self.triangle[ray % PACKET];
                let sheared = self.ray(ray);
                let (block, of) = (self.block[ray % PACKET], self.lane[ray % PACKET]);
                let nearest = NearestHit { t: lane(&self.nearest, ray), triangle, block, lane: of };
                answers[index(self.numbers[group] * width + at)] =
                    Q::answer(target, &sheared, nearest);
            }
        }
    }

    /// Which of all groups that were loaded this one is.
    #[inline(always)]
    pub(super) fn number(&self, group: usize) -> usize {
        self.numbers[group % GROUPS]
    }

    /// The rays of a group that have hit something, a bit each.
    #[inline(always)]
    pub(super) fn hits<N: Lanes>(&self, lanes: N, group: usize) -> u32 {
        let (first, mut of_group) = (group * width::<N>(), [u32::MAX; LANES]);
        let triangles = &self.triangle[first % PACKET..][..width::<N>()];
        of_group[..width::<N>()].copy_from_slice(triangles);
        lanes.all_lanes() & !lanes.eq_mask(&of_group, u32::MAX)
    }

    /// The rays of a group that hit the box of a node's child, a bit each.
    #[inline(always)]
    pub(super) fn box_hits<N: Lanes>(
        &self,
        lanes: N,
        group: usize,
        node: &Node,
        slot: usize,
    ) -> u32 {
        let mut near = load(lanes, &self.start, group);
        let mut far = load(lanes, &self.nearest, group);
        for axis in 0..3 {
            let reversed = self.reversed[axis] & 1;
            let near_plane = lanes.constant(node.planes[axis][reversed][slot]);
            let far_plane = lanes.constant(node.planes[axis][reversed ^ 1][slot]);
            let inverse = load(lanes, &self.inverse[axis], group);
            let near_offset = near_plane - load(lanes, &self.near_origin[axis], group);
            let far_offset = far_plane - load(lanes, &self.far_origin[axis], group);
            near = (near_offset * inverse).maximum(near);
            far = (far_offset * inverse).minimum(far);
        }
        near.less_or_equal(far).bits()
    }

    /// One of the rays.
    #[inline(always)]
    pub(crate) fn ray(&self, ray: usize) -> ShearedRay {
        self.sheared.ray(ray, self.longest, self.reversed[self.longest] != 0)
    }

    /// Records a hit of a ray if it is nearer than its nearest so far; returns whether it is. A ray
    /// that asks for any hit is done with the first one: its range becomes empty.
    #[inline(always)]
    pub(crate) fn record<Q: RayQuery>(
        &mut self,
        ray: usize,
        t: f32,
        triangle: u32,
        [block, of]: [u32; 2],
    ) -> bool {
        let ray = ray % PACKET;
        let nearest = &mut self.nearest.as_flattened_mut()[ray];
        let is_nearer = t < *nearest || t == *nearest && triangle < self.triangle[ray];
        if is_nearer {
            *nearest = if Q::ANY { -1.0 } else { t };
            self.triangle[ray] = triangle;
            (self.block[ray], self.lane[ray]) = (block, of);
        }
        is_nearer
    }

    /// Notes that something is in the way of a ray that asks for any hit.
    #[inline(always)]
    pub(super) fn block_ray(&mut self, ray: usize) {
        self.triangle[ray % PACKET] = 0;
    }

    /// The interval around all rays; `None` if they aren't coherent enough for one.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(super) fn interval<N: Lanes>(
        &self,
        lanes: N,
        target: &RayTarget<'_>,
    ) -> Option<RayInterval> {
        lanes.vectorized(
            #[inline(always)]
            || self.interval_here(lanes.zero(), target),
        )
    }

    #[inline(always)]
    fn interval_here<N: Lanes>(&self, lanes: N, target: &RayTarget<'_>) -> Option<RayInterval> {
        let mut interval = RayInterval {
            near_origin: [0.0; 3],
            far_origin: [0.0; 3],
            inverse: [[0.0; 2]; 3],
            shear: [0, 1].map(|side| [lane(&self.sheared.shear[side], 0); 2]),
            start: self.range(lanes, &self.start).least(),
        };
        let mut is_close = true;
        for axis in 0..3 {
            let near = self.range(lanes, &self.near_origin[axis]);
            let far = self.range(lanes, &self.far_origin[axis]);
            // (plane - origin) * inverse is smallest from the origin farthest ahead.
            let [ahead, behind] = match self.reversed[axis] {
                0 => [near.greatest(), far.least()],
                _ => [near.least(), far.greatest()],
            };
            (interval.near_origin[axis], interval.far_origin[axis]) = (ahead, behind);
            is_close &= (ahead - behind).abs() <= SPREAD * target.extent;
        }
        // Rays to a light far away share their direction: its ends need not be looked for.
        let mut is_shared = lanes.zero().equal(lanes.zero());
        for axis in 0..3 {
            let first = lane(&self.inverse[axis], 0);
            interval.inverse[axis] = [first; 2];
            for group in 0..self.count {
                let inverse = load(lanes, &self.inverse[axis], group);
                is_shared = is_shared & inverse.equal(lanes.constant(first));
            }
        }
        if !is_shared.all() {
            for axis in 0..3 {
                interval.inverse[axis] = self.range(lanes, &self.inverse[axis]).ends();
            }
            for (shear, row) in interval.shear.iter_mut().zip(&self.sheared.shear) {
                *shear = self.range(lanes, row).ends();
                is_close &= shear[1] - shear[0] <= SPREAD;
            }
        }
        is_close.then_some(interval)
    }

    /// The minimum and maximum of a row, lane by lane.
    #[inline(always)]
    fn range<N: Lanes>(&self, lanes: N, row: &Row) -> LaneRange<N> {
        let mut range = LaneRange::empty(lanes);
        for group in 0..self.count {
            range.include(load(lanes, row, group));
        }
        range
    }

    /// The largest distance that still counts for any ray.
    #[inline(always)]
    pub(super) fn farthest<N: Lanes>(&self, lanes: N) -> f32 {
        let mut farthest = lanes.constant(-1.0);
        for group in 0..self.count {
            farthest = farthest.maximum(load(lanes, &self.nearest, group));
        }
        greatest(farthest)
    }
}

/// Eight rays and eight more.
#[inline(always)]
fn combined<S: Simd>(low: [f32x8<S>; ROWS], high: [f32x8<S>; ROWS]) -> [f32x16<S>; ROWS] {
    let mut columns = [low[0].combine(high[0]); ROWS];
    for row in 1..ROWS {
        columns[row] = low[row].combine(high[row]);
    }
    columns
}

/// Loads up to eight rays, and `first` for those that are missing.
#[inline(always)]
pub(super) fn load_up_to_eight<S: Simd>(simd: S, rays: &[Ray], first: &Ray) -> [f32x8<S>; ROWS] {
    if let Some([a, b, c, d, e, f, g, h]) = rays.first_chunk::<WIDTH>() {
        return load_eight(simd, [a, b, c, d, e, f, g, h]);
    }
    let ray = |lane: usize| rays.get(lane).unwrap_or(first);
    load_eight(simd, [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)])
}

impl RayInterval {
    /// The smallest distances at which any ray enters the boxes of a node's children, and a bit for each
    /// that any ray may enter before `farthest`.
    #[inline(always)]
    pub(super) fn hit_children<S: Simd>(
        &self,
        simd: S,
        node: &Node,
        reversed: [usize; 3],
        farthest: f32,
    ) -> ([f32; WIDTH], u32) {
        let mut near = f32x8::splat(simd, self.start);
        let mut far = f32x8::splat(simd, farthest);
        for axis in 0..3 {
            let reversed = reversed[axis] & 1;
            let near_way =
                f32x8::simd_from(simd, node.planes[axis][reversed]) - self.near_origin[axis];
            let far_way =
                f32x8::simd_from(simd, node.planes[axis][reversed ^ 1]) - self.far_origin[axis];
            let [least, greatest] = self.inverse[axis];
            near = (near_way * least).min(near_way * greatest).max(near);
            far = (far_way * least).max(far_way * greatest).min(far);
        }
        let mut distances = [0.0; WIDTH];
        near.store_slice(&mut distances);
        (distances, near.simd_le(far).to_bitmask() as u32)
    }
}
