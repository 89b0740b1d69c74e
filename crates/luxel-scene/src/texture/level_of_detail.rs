//! Which mipmap levels are sampled, and how two of them are mixed (OpenGL 4.6, core profile, section 8.14).

use super::Filter;
use luxel_math::{LANES, Lanes, Mask};

/// The filters of magnified and minified texels, and between levels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelFilters {
    /// Where a texel covers more than a pixel.
    pub magnify: Filter,
    /// Where a pixel covers more than a texel, within a level.
    pub minify: Filter,
    /// Between levels.
    pub between: Filter,
}

/// What has levels of texels to sample at a place that it knows.
pub trait LevelSource<N: Lanes, const C: usize> {
    /// The values within one level, for the lanes whose bit is set; the other lanes are undefined.
    fn filtered(&self, level: u32, filter: Filter, lanes: u32) -> [N; C];
}

/// The levels that each lane samples: one, or two with their blend factor.
pub struct Detail<N> {
    first: Levels,
    second: Levels,
    /// The lanes that look at two.
    two: u32,
    fraction: N,
}

impl<N: Lanes> Detail<N> {
    /// Level 0 alone, with one filter or the other.
    #[inline(always)]
    #[must_use]
    pub fn of_base(simd: N, [magnify, minify]: [Filter; 2], magnified: u32) -> Self {
        let first = Levels::all(0, minify).or_where(simd, magnified, 0, magnify);
        Self { first, second: Levels::all(0, minify), two: 0, fraction: simd.zero() }
    }

    /// The levels to sample for a level of detail, which may be between two; `last` is the smallest image's number.
    #[inline(always)]
    #[must_use]
    pub fn new(level: N, filters: LevelFilters, last: u32, lanes: u32) -> Self {
        let LevelFilters { magnify, minify, between } = filters;
        // Where magnified texels are smooth and minified ones aren't, the change comes half a
        // level later, or pictures would be sharper from afar (OpenGL 4.6, 8.15).
        let threshold =
            if magnify == Filter::Linear && minify == Filter::Nearest { 0.5 } else { 0.0 };
        let magnified = level.less_or_equal(level.constant(threshold)).bits() & lanes;
        let last = last as f32;
        let positive = level.positive_part();
        let larger = match between {
            // ceil(level + 1/2) - 1: halves go to the larger picture.
            Filter::Nearest => -(-(positive + level.constant(0.5))).floor() - level.one(),
            Filter::Linear => positive.floor(),
        };
        let is_last = level.constant(last).less_or_equal(larger);
        let larger = larger.minimum(level.constant(last));
        let first = Levels::of(larger, minify).or_where(level, magnified, 0, magnify);
        let two = match between {
            Filter::Nearest => 0,
            Filter::Linear => lanes & !magnified & !is_last.bits(),
        };
        let second = Levels::of(larger + level.one(), minify);
        Self { first, second, two, fraction: positive - larger }
    }

    /// What the levels' values come to, for the lanes whose bit is set; the other lanes are undefined.
    #[inline(always)]
    pub fn value<const C: usize>(
        &self,
        simd: N,
        source: &impl LevelSource<N, C>,
        lanes: u32,
    ) -> [N; C] {
        let two = self.two & lanes;
        let mut values = [[simd.zero(); C]; 2];
        // A loop, since two copies of what samples would be most of the code.
        for (value, (levels, lanes)) in
            values.iter_mut().zip([(&self.first, lanes), (&self.second, two)])
        {
            *value = levels.value(simd, source, lanes);
        }
        let [mut value, far] = values;
        if two == 0 {
            return value;
        }
        let mixed = mix(value, far, self.fraction);
        let mask = simd.mask_of(two);
        for (value, mixed) in value.iter_mut().zip(mixed) {
            *value = mixed.select(mask, *value);
        }
        value
    }
}

/// The level that each lane looks at and its filter, in the lowest bit: 1 for a linear one.
struct Levels([u32; LANES]);

impl Levels {
    #[inline(always)]
    fn all(level: u32, filter: Filter) -> Self {
        Self([key(level, filter); LANES])
    }

    /// Levels by number, with one filter.
    #[inline(always)]
    fn of<N: Lanes>(levels: N, filter: Filter) -> Self {
        let mut keys = [0; LANES];
        let bit = levels.constant(key(0, filter) as f32);
        (levels + levels + bit).store_whole(&mut keys, 0);
        Self(keys)
    }

    /// With another level and filter in some lanes.
    #[inline(always)]
    fn or_where<N: Lanes>(mut self, simd: N, lanes: u32, level: u32, filter: Filter) -> Self {
        simd.visit(
            lanes,
            #[inline(always)]
            |lane| self.0[lane] = key(level, filter),
        );
        self
    }

    /// The values within the level of each lane.
    #[inline(always)]
    fn value<N: Lanes, const C: usize>(
        &self,
        simd: N,
        source: &impl LevelSource<N, C>,
        lanes: u32,
    ) -> [N; C] {
        let mut value = [simd.zero(); C];
        let mut left = lanes;
        while left != 0 {
            let key = self.0[left.trailing_zeros() as usize & (LANES - 1)];
            let here = simd.eq_mask(&self.0, key) & left;
            left &= !here;
            let filter = if key & 1 == 0 { Filter::Nearest } else { Filter::Linear };
            let filtered = source.filtered(key >> 1, filter, here);
            let mask = simd.mask_of(here);
            for (value, filtered) in value.iter_mut().zip(filtered) {
                *value = filtered.select(mask, *value);
            }
        }
        value
    }
}

fn key(level: u32, filter: Filter) -> u32 {
    level << 1 | u32::from(filter == Filter::Linear)
}

/// The squared length, in texels, of a change of coordinates on axes of so many texels.
#[inline(always)]
#[must_use]
pub fn squared_length<N: Lanes, const D: usize>(change: [N; D], size: [N; D]) -> N {
    let simd = change[0];
    let mut squared = simd.zero();
    for (axis, (change, size)) in change.into_iter().zip(size).enumerate() {
        let texels = change * size;
        squared = if axis == 0 { texels * texels } else { squared + texels * texels };
    }
    // Not a number counts as 0, beyond all measure as far out.
    squared.minimum(simd.constant(1e30)).masked(simd.zero().less(squared))
}

/// From `a` to `b` by a fraction.
#[inline(always)]
#[must_use]
pub fn mix<N: Lanes, const C: usize>(mut a: [N; C], b: [N; C], fraction: N) -> [N; C] {
    for (a, b) in a.iter_mut().zip(b) {
        *a = *a + (b - *a) * fraction;
    }
    a
}
