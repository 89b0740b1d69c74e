//! Rays that run close together, followed through the tree as one.
//!
//! Sixty-four rays, as those of a tile of 8x8 pixels, mostly meet the same nodes. So a node is asked
//! once, with intervals that hold the origins and directions of all (Reshetov, Soupikov and Hurley
//! 2005; Wald, Benthin and Boulos 2008): what no ray of the interval meets, none of the bundle does.
//! Where a leaf is reached, its box is asked for each ray, eight side by side, by the same operations
//! as for a ray alone; and triangles by those rays that meet the box. Rounding is monotone, so the
//! intervals hold what each ray would compute, and a ray gets the same triangle and the same bits of
//! the distance as alone.

use crate::bvh::{
    ALMOST_ZERO, Block, Head, Node, PADDING, Places, WIDTH, block, higher, lower, moved, number,
    padding,
};
use crate::gather::gather;
use crate::intersect::{Nearest, Ray, Sheared, axes, meet_gathered, meet_rays};
use crate::kind::{Common, Kind, ROWS, end_before, take_eight};
use crate::rays::{MeshRays, RayHit};
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
    block: [u32; WIDTH],
    lane: [u32; WIDTH],
    /// Which of the eights that the bundle was made of.
    number: usize,
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
    /// As they came: of each eight the origins and directions, axis by axis, and ranges.
    rows: [[[f32; WIDTH]; ROWS]; EIGHTS],
    /// Those of which any meets the box around all.
    eights: [Eight; EIGHTS],
    /// How many eights have such rays.
    count: usize,
    longest: usize,
    axes: [usize; 3],
    turned: [usize; 3],
}

const NO_RAYS: Eight = Eight {
    near_origin: [[0.0; WIDTH]; 3],
    far_origin: [[0.0; WIDTH]; 3],
    inverse: [[0.0; WIDTH]; 3],
    start: [0.0; WIDTH],
    sheared: ShearedEight { origin: [[0.0; WIDTH]; 3], shear: [[0.0; WIDTH]; 3] },
    nearest: [0.0; WIDTH],
    triangle: [0; WIDTH],
    block: [0; WIDTH],
    lane: [0; WIDTH],
    number: 0,
};

impl Bundle {
    pub(crate) fn new() -> Self {
        Self {
            rows: [[[0.0; WIDTH]; ROWS]; EIGHTS],
            eights: [NO_RAYS; EIGHTS],
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
        for (eight, rows) in followed.chunks(WIDTH).zip(&mut self.rows) {
            if let Some(eight) = eight.first_chunk::<WIDTH>() {
                let [a, b, c, d, e, f, g, h] = eight;
                common.include(take_eight(simd, [a, b, c, d, e, f, g, h], rows));
            } else {
                let ray = |lane: usize| eight.get(lane).unwrap_or(first);
                let eight_rays = [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)];
                common.include(take_eight(simd, eight_rays, rows));
                end_before(rows, eight.len());
            }
        }
        common.kind()
    }

    /// Takes rays by their places among others.
    #[inline(always)]
    pub(crate) fn take_places<S: Simd>(&mut self, simd: S, followed: &[Ray], places: &[u8]) {
        let Some(&first) = places.first() else { return };
        for (eight, rows) in places.chunks(WIDTH).zip(&mut self.rows) {
            let ray = |lane: usize| &followed[usize::from(*eight.get(lane).unwrap_or(&first))];
            let eight_rays = [ray(0), ray(1), ray(2), ray(3), ray(4), ray(5), ray(6), ray(7)];
            take_eight(simd, eight_rays, rows);
            end_before(rows, eight.len());
        }
    }

    /// Makes what was taken ready, `count` rays of one kind; whether they run close enough together.
    #[inline(always)]
    pub(crate) fn ready<S: Simd>(
        &mut self,
        simd: S,
        rays: &MeshRays<'_>,
        kind: Kind,
        count: usize,
    ) -> bool {
        self.turned = kind.turned();
        self.longest = kind.longest();
        self.axes = axes(self.longest);
        self.count = 0;
        let mut slopes = [Range::none(simd); 2];
        let mut origins = [Range::none(simd); 3];
        for (number, rows) in self.rows[..count.div_ceil(WIDTH).min(EIGHTS)].iter().enumerate() {
            let eight = &mut self.eights[self.count & (EIGHTS - 1)];
            let start = f32x8::simd_from(simd, rows[6]);
            let end = f32x8::simd_from(simd, rows[7]);
            let one = f32x8::splat(simd, 1.0);
            let (mut near, mut far) = (start, end);
            for axis in 0..3 {
                let origin = f32x8::simd_from(simd, rows[axis]);
                let along = f32x8::simd_from(simd, rows[3 + axis]);
                let turned = self.turned[axis] & 1;
                let sign = f32x8::splat(simd, if turned != 0 { -1.0 } else { 1.0 });
                let largest = f32x8::splat(simd, rays.largest[axis]);
                let pad = padding(SimdBase::abs(origin), largest, f32x8::splat(simd, PADDING));
                let [near_origin, far_origin] = moved(origin, sign * pad);
                let length = SimdBase::abs(along).max(f32x8::splat(simd, ALMOST_ZERO));
                let inverse = sign * (one / length);
                let near_plane = f32x8::splat(simd, rays.bounds[turned][axis]);
                let far_plane = f32x8::splat(simd, rays.bounds[turned ^ 1][axis]);
                near = ((near_plane - near_origin) * inverse).max(near);
                far = ((far_plane - far_origin) * inverse).min(far);
                near_origin.store_slice(&mut eight.near_origin[axis]);
                far_origin.store_slice(&mut eight.far_origin[axis]);
                inverse.store_slice(&mut eight.inverse[axis]);
            }
            let meets = near.simd_le(far);
            if !meets.any_true() {
                continue;
            }
            start.store_slice(&mut eight.start);
            // What misses the box around all ends before it begins.
            meets.select(end, f32x8::splat(simd, -1.0)).store_slice(&mut eight.nearest);
            eight.triangle = [u32::MAX; WIDTH];
            eight.number = number;
            let [kx, ky, kz] = self.axes.map(|axis| axis.min(2));
            eight.sheared.origin = [rows[kx], rows[ky], rows[kz]];
            let inverse = f32x8::simd_from(simd, eight.inverse[kz]);
            let first = f32x8::simd_from(simd, rows[3 + kx]) * inverse;
            let second = f32x8::simd_from(simd, rows[3 + ky]) * inverse;
            first.store_slice(&mut eight.sheared.shear[0]);
            second.store_slice(&mut eight.sheared.shear[1]);
            inverse.store_slice(&mut eight.sheared.shear[2]);
            slopes[0].include(first);
            slopes[1].include(second);
            for axis in 0..3 {
                origins[axis].include(f32x8::simd_from(simd, rows[axis]));
            }
            self.count += 1;
        }
        self.count == 0
            || slopes.iter().all(|range| range.width() <= SPREAD)
                && origins.iter().all(|range| range.width() <= SPREAD * rays.extent())
    }

    /// Writes the hits to their rays' places.
    #[inline(always)]
    pub(crate) fn tell(
        &self,
        rays: &MeshRays<'_>,
        hits: &mut [Option<RayHit>],
        place: impl Fn(usize) -> usize,
    ) {
        let is_negative = self.turned[self.longest] != 0;
        for eight in &self.eights[..self.count] {
            for lane in 0..WIDTH {
                let (t, triangle) = (eight.nearest[lane], eight.triangle[lane]);
                if triangle != u32::MAX {
                    let sheared = eight.sheared(lane, self.longest, is_negative);
                    let (block, of) = (eight.block[lane], eight.lane[lane]);
                    let nearest = Nearest { t, triangle, block, lane: of };
                    hits[place(eight.number * WIDTH + lane)] = rays.told(&sheared, nearest);
                }
            }
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
pub(crate) fn closest_of_bundle<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    places: &Places,
) {
    let nodes: &[Node] = rays.nodes;
    let mut top = 0;
    if bundle.count == 0 {
        return;
    }
    let interval = bundle.interval(simd);
    let mut farthest = bundle.farthest(simd);
    let mut number = 0;
    loop {
        let (distances, bits) = interval.meet(simd, &nodes[number], bundle.turned, farthest);
        // The node's number times eight, and the slot.
        let mut words = [0; WIDTH];
        for slot in 0..WIDTH {
            words[slot] = (number * WIDTH + slot) as u32;
        }
        places.push(&mut top, &words, &distances, bits);
        loop {
            let Some(place) = places.pop(&mut top, farthest) else { return };
            let place = place as usize;
            let (node, slot) = (&nodes[place / WIDTH], place % WIDTH);
            match node.children[slot].as_block() {
                Some(start) => {
                    if meet_leaf(simd, rays, bundle, node, slot, start) {
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
    mut start: usize,
) -> bool {
    let slot = slot & (WIDTH - 1);
    let mut active = [0_u32; EIGHTS];
    let (mut eights, mut singles) = (0, 0);
    for (active, eight) in active.iter_mut().zip(&bundle.eights[..bundle.count]) {
        let mut near = f32x8::simd_from(simd, eight.start);
        let mut far = f32x8::simd_from(simd, eight.nearest);
        for axis in 0..3 {
            let turned = bundle.turned[axis] & 1;
            let near_plane = f32x8::splat(simd, node.planes[axis][turned][slot]);
            let far_plane = f32x8::splat(simd, node.planes[axis][turned ^ 1][slot]);
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
    while let Some(block) = block(rays.words, start) {
        let singly = eights * Head::of(block).count() as u32 > singles;
        any |= meet_rays_of_block(simd, rays, bundle, &active, (block, start as u32), singly);
        let head = Head::of(block);
        if !head.goes_on() {
            break;
        }
        start += head.len();
    }
    any
}

/// Asks a block's triangles for the rays whose bit is set, eight at a time or one by one; whether any
/// was hit.
#[inline(always)]
fn meet_rays_of_block<S: Simd>(
    simd: S,
    rays: &MeshRays<'_>,
    bundle: &mut Bundle,
    active: &[u32; EIGHTS],
    (block, start): (&Block, u32),
    singly: bool,
) -> bool {
    let count = Head::of(block).count();
    let gathered = gather(simd, block, rays.positions);
    let is_negative = bundle.turned[bundle.longest] != 0;
    let mut any = false;
    if !singly {
        for of in 0..count {
            let corners = [0, 1, 2]
                .map(|corner: usize| bundle.axes.map(|axis| gathered[axis & 3][corner][of]));
            let triangle = number(block, of);
            for (&active, eight) in active.iter().zip(&mut bundle.eights) {
                if active == 0 {
                    continue;
                }
                let range = [eight.start, eight.nearest];
                let (distances, mut hits) =
                    meet_rays(simd, corners, &eight.sheared, is_negative, range, active);
                while hits != 0 {
                    let lane = hits.trailing_zeros() as usize & (WIDTH - 1);
                    hits &= hits - 1;
                    any |= eight.keep(lane, distances[lane], triangle, [start, of as u32]);
                }
            }
        }
        return any;
    }
    for (&active, eight) in active.iter().zip(&mut bundle.eights) {
        let mut active = active;
        while active != 0 {
            let lane = active.trailing_zeros() as usize & (WIDTH - 1);
            active &= active - 1;
            let sheared = eight.sheared(lane, bundle.longest, is_negative);
            let range = [eight.start[lane], eight.nearest[lane]];
            let (distances, mut hits) = meet_gathered(simd, &gathered, count, &sheared, range);
            while hits != 0 {
                let of = hits.trailing_zeros() as usize & (WIDTH - 1);
                hits &= hits - 1;
                any |= eight.keep(lane, distances[of], number(block, of), [start, of as u32]);
            }
        }
    }
    any
}

impl Eight {
    /// One of the rays.
    #[inline(always)]
    fn sheared(&self, lane: usize, last: usize, is_negative: bool) -> Sheared {
        let ShearedEight { origin: [x, y, z], shear: [sx, sy, sz] } = &self.sheared;
        let (origin, shear) = ([x[lane], y[lane], z[lane]], [sx[lane], sy[lane], sz[lane]]);
        Sheared { last, is_negative, origin, shear }
    }

    /// Takes over a ray's hit if it is nearer; whether it is.
    #[inline(always)]
    fn keep(&mut self, lane: usize, t: f32, triangle: u32, [block, of]: [u32; 2]) -> bool {
        let is_nearer =
            t < self.nearest[lane] || t == self.nearest[lane] && triangle < self.triangle[lane];
        if is_nearer {
            self.nearest[lane] = t;
            self.triangle[lane] = triangle;
            (self.block[lane], self.lane[lane]) = (block, of);
        }
        is_nearer
    }
}
