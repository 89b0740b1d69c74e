//! From texture coordinates to light: wrapping, filtering, level of detail.
//!
//! As in OpenGL 4.6 (core profile, section 8.14), with the footprint of a pixel taken from the
//! derivatives of the texture coordinates. Where the footprint is long and thin, up to
//! [`MOST_PROBES`] probes lie along it (after `GL_EXT_texture_filter_anisotropic`), each from the
//! level that fits its width, so that floors stay sharp towards the horizon.

use crate::encoding::BYTE_TO_UNIT;
use crate::texture::{MipLevel, Texture};
use luxel_math::elementary::log2;
use luxel_math::{LANES, Lanes, Mask};

/// How many probes a footprint gets at most.
const MOST_PROBES: f32 = 8.0;

/// By how much a footprint may be longer than its probes cover before there is another one:
/// footprints that are nearly square need no second probe.
const STRETCH_TOLERATED: f32 = 0.125;

/// Beyond so many texels across or down there are numbers between which an `f32` can't tell; the
/// rest of so large an image isn't looked at.
const MOST_TEXELS: u32 = 1 << 24;

/// The wrapping outside 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Wrap {
    /// The picture repeats.
    #[default]
    Repeat,
    /// It repeats, every other one mirrored.
    MirroredRepeat,
    /// The edge goes on.
    ClampToEdge,
}

/// How texels become a value.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// A weighted mean of neighbours, and of mipmap levels.
    #[default]
    Linear,
}

/// The rules of sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Sampler {
    /// Across.
    pub wrap_u: Wrap,
    /// Down.
    pub wrap_v: Wrap,
    /// Where a texel covers more than a pixel.
    pub magnify: Filter,
    /// Where a pixel covers more than a texel, within a level.
    pub minify: Filter,
    /// Between levels; `None`: only level 0 is used.
    pub mipmap: Option<Filter>,
}

impl Sampler {
    /// Repeating, trilinear: the default of files.
    #[must_use]
    pub const fn trilinear() -> Self {
        Self {
            wrap_u: Wrap::Repeat,
            wrap_v: Wrap::Repeat,
            magnify: Filter::Linear,
            minify: Filter::Linear,
            mipmap: Some(Filter::Linear),
        }
    }
}

impl Texture {
    /// The first `C` of linear red, green, blue and alpha at (u, v), (0, 0) being the image's upper
    /// left, seen through a pixel over which the coordinates change by `per_pixel_x` = (du/dx,
    /// dv/dx) from left to right and by `per_pixel_y` from top to bottom. That is for the lanes
    /// whose bit is set; the other lanes are undefined.
    ///
    /// With P_x, P_y the lengths of the two in texels of level 0, P_max and P_min the longer and
    /// the shorter, there are N = ceil(P_max / max(P_min, 1)) probes (at most 8) along the longer
    /// one, from the level lambda = log2(P_max / N). Samplers that take the nearest texel or know
    /// no levels get one probe. Coordinates that aren't finite, or so large that no fraction is
    /// left, count as 0.
    #[must_use]
    #[inline(always)]
    pub fn sample<N: Lanes, const C: usize>(
        &self,
        [u, v]: [N; 2],
        per_pixel_x: [N; 2],
        per_pixel_y: [N; 2],
        lanes: u32,
    ) -> [N; C] {
        let Some(base) = self.image.levels.first() else { return [u.zero(); C] };
        let size = [u.constant(base.width as f32), u.constant(base.height as f32)];
        let squared_x = squared_length(per_pixel_x, size);
        let squared_y = squared_length(per_pixel_y, size);
        let x_is_longer = squared_y.less_or_equal(squared_x);
        let longer = squared_x.select(x_is_longer, squared_y);
        let shorter = squared_y.select(x_is_longer, squared_x);
        let one = u.one();
        let is_magnified = longer.less_or_equal(one);
        let Some(between) = self.sampler.mipmap else {
            let [near, far] = [self.sampler.magnify, self.sampler.minify];
            let far = Levels::all(0, far);
            let magnified = is_magnified.bits();
            let levels = far.or_where(u, magnified & lanes, 0, near);
            return self.of_levels(&levels, u, v, lanes);
        };

        let stretch = (longer / shorter.maximum(one)).sqrt() - u.constant(STRETCH_TOLERATED);
        let has_one = if self.sampler.minify == Filter::Nearest {
            is_magnified.splat_like(true)
        } else {
            is_magnified | stretch.less_or_equal(one)
        };
        let most = ceil(stretch.minimum(u.constant(MOST_PROBES)));
        let probes = one.select(has_one, most);
        let level = u.constant(0.5) * log2(longer / (probes * probes));
        let level = u.constant(-1.0).select(is_magnified, level);
        let detail = self.detail(level, between, lanes);
        if has_one.bits() & lanes == lanes {
            return self.of_detail(&detail, u, v, lanes);
        }
        let du = per_pixel_x[0].select(x_is_longer, per_pixel_y[0]);
        let dv = per_pixel_x[1].select(x_is_longer, per_pixel_y[1]);
        let mut sum = [u.zero(); C];
        let mut probe = 1.0;
        loop {
            let here = u.constant(probe);
            let reached = here.less_or_equal(probes);
            let left = reached.bits() & lanes;
            if left == 0 {
                break;
            }
            // From just after -1/2 to just before 1/2 of a pixel.
            let along = here / (probes + one) - u.constant(0.5);
            let u_here = u.select(has_one, u + du * along);
            let v_here = v.select(has_one, v + dv * along);
            let value: [N; C] = self.of_detail(&detail, u_here, v_here, left);
            for (sum, value) in sum.iter_mut().zip(value) {
                *sum = (*sum + value).select(reached, *sum);
            }
            probe += 1.0;
        }
        for sum in &mut sum {
            *sum = *sum / probes;
        }
        sum
    }

    /// `C` channels from the `FIRST` on of level 0 at (u, v), for questions that must not depend on
    /// the pixel, such as alpha masks: filtered as where a texel covers more than a pixel. That is
    /// for the lanes whose bit is set; the other lanes are undefined.
    #[must_use]
    #[inline(always)]
    pub fn sample_base<N: Lanes, const FIRST: usize, const C: usize>(
        &self,
        u: N,
        v: N,
        lanes: u32,
    ) -> [N; C] {
        match self.image.levels.first() {
            Some(base) => self.filtered::<N, FIRST, C>(base, u, v, self.sampler.magnify, lanes),
            None => [u.zero(); C],
        }
    }

    /// The levels to sample for a level of detail, which may be between two.
    #[inline(always)]
    fn detail<N: Lanes>(&self, level: N, between: Filter, lanes: u32) -> Detail<N> {
        let Sampler { magnify, minify, .. } = self.sampler;
        // Where magnified texels are smooth and minified ones aren't, the change comes half a
        // level later, or pictures would be sharper from afar (OpenGL 4.6, 8.15).
        let threshold =
            if magnify == Filter::Linear && minify == Filter::Nearest { 0.5 } else { 0.0 };
        let magnified = level.less_or_equal(level.constant(threshold)).bits() & lanes;
        let last = (self.image.levels.len() - 1) as f32;
        let positive = level.positive_part();
        let larger = match between {
            // ceil(level + 1/2) - 1: halves go to the larger picture.
            Filter::Nearest => ceil(positive + level.constant(0.5)) - level.one(),
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
        Detail { first, second, two, fraction: positive - larger }
    }

    #[inline(always)]
    fn of_detail<N: Lanes, const C: usize>(
        &self,
        detail: &Detail<N>,
        u: N,
        v: N,
        lanes: u32,
    ) -> [N; C] {
        let near: [N; C] = self.of_levels(&detail.first, u, v, lanes);
        let two = detail.two & lanes;
        if two == 0 {
            return near;
        }
        let far = self.of_levels(&detail.second, u, v, two);
        let mixed = mix(near, far, detail.fraction);
        let mask = u.mask_of(two);
        let mut value = near;
        for (value, mixed) in value.iter_mut().zip(mixed) {
            *value = mixed.select(mask, *value);
        }
        value
    }

    /// The values within the level of each lane.
    #[inline(always)]
    fn of_levels<N: Lanes, const C: usize>(
        &self,
        levels: &Levels,
        u: N,
        v: N,
        lanes: u32,
    ) -> [N; C] {
        let mut value = [u.zero(); C];
        let mut left = lanes;
        while left != 0 {
            let key = levels.0[left.trailing_zeros() as usize & (LANES - 1)];
            let here = u.eq_mask(&levels.0, key) & left;
            left &= !here;
            let filter = if key & 1 == 0 { Filter::Nearest } else { Filter::Linear };
            let Some(level) = self.image.levels.get((key >> 1) as usize) else { continue };
            let filtered = self.filtered::<N, 0, C>(level, u, v, filter, here);
            let mask = u.mask_of(here);
            for (value, filtered) in value.iter_mut().zip(filtered) {
                *value = filtered.select(mask, *value);
            }
        }
        value
    }

    /// The values within one level: `C` channels from the `FIRST` on.
    #[inline(always)]
    fn filtered<N: Lanes, const FIRST: usize, const C: usize>(
        &self,
        level: &MipLevel,
        u: N,
        v: N,
        filter: Filter,
        lanes: u32,
    ) -> [N; C] {
        let [width, height] =
            [level.width, level.height].map(|texels| u.constant(texels.min(MOST_TEXELS) as f32));
        let across = folded(u, self.sampler.wrap_u) * width;
        let down = folded(v, self.sampler.wrap_v) * height;
        let table = self.image.encoding.table();
        let [mut left, mut right, mut upper, mut lower] = [[0; LANES]; 4];
        match filter {
            Filter::Nearest => {
                across.floor().minimum(width - u.one()).store_whole(&mut left, 0);
                down.floor().minimum(height - u.one()).store_whole(&mut upper, 0);
                let mut texels = Texels::<FIRST, C>::new();
                u.visit(
                    lanes,
                    #[inline(always)]
                    |lane| texels.put(lane, level.texel(left[lane], upper[lane]), table),
                );
                texels.loaded(u)
            }
            Filter::Linear => {
                let x = neighbours(across, width, self.sampler.wrap_u, [&mut left, &mut right]);
                let y = neighbours(down, height, self.sampler.wrap_v, [&mut upper, &mut lower]);
                let mut texels = [const { Texels::<FIRST, C>::new() }; 4];
                u.visit(
                    lanes,
                    #[inline(always)]
                    |lane| {
                        texels[0].put(lane, level.texel(left[lane], upper[lane]), table);
                        texels[1].put(lane, level.texel(right[lane], upper[lane]), table);
                        texels[2].put(lane, level.texel(left[lane], lower[lane]), table);
                        texels[3].put(lane, level.texel(right[lane], lower[lane]), table);
                    },
                );
                let above = mix(texels[0].loaded(u), texels[1].loaded(u), x);
                let below = mix(texels[2].loaded(u), texels[3].loaded(u), x);
                mix(above, below, y)
            }
        }
    }
}

impl MipLevel {
    #[inline(always)]
    fn texel(&self, x: u32, y: u32) -> [u8; 4] {
        self.texels[y as usize * self.width as usize + x as usize]
    }
}

/// A texel for each lane: `C` channels from the `FIRST` on.
struct Texels<const FIRST: usize, const C: usize>([[f32; LANES]; C]);

impl<const FIRST: usize, const C: usize> Texels<FIRST, C> {
    const fn new() -> Self {
        Self([[0.0; LANES]; C])
    }

    /// `colors` are the linear values of the bytes of red, green and blue.
    #[inline(always)]
    fn put(&mut self, lane: usize, texel: [u8; 4], colors: &[f32; 256]) {
        for (number, channel) in (FIRST..).zip(&mut self.0) {
            let table = if number < 3 { colors } else { &BYTE_TO_UNIT };
            channel[lane] = table[usize::from(texel[number])];
        }
    }

    #[inline(always)]
    fn loaded<N: Lanes>(&self, simd: N) -> [N; C] {
        let mut channels = [simd; C];
        for (channel, values) in channels.iter_mut().zip(&self.0) {
            *channel = simd.load(values, 0);
        }
        channels
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
}

fn key(level: u32, filter: Filter) -> u32 {
    level << 1 | u32::from(filter == Filter::Linear)
}

/// The levels that each lane samples: one, or two with their blend factor.
struct Detail<N> {
    first: Levels,
    second: Levels,
    /// The lanes that look at two.
    two: u32,
    fraction: N,
}

/// The squared length, in texels, of a change of coordinates.
#[inline(always)]
fn squared_length<N: Lanes>([du, dv]: [N; 2], [width, height]: [N; 2]) -> N {
    let (across, down) = (du * width, dv * height);
    // Not a number counts as 0, beyond all measure as far out.
    let squared = across * across + down * down;
    squared.minimum(du.constant(1e30)).masked(du.zero().less(squared))
}

/// The coordinate wrapped to 0..=1.
#[inline(always)]
fn folded<N: Lanes>(coordinate: N, wrap: Wrap) -> N {
    /// From here on, coordinates are whole numbers.
    const NO_FRACTION: f32 = 8_388_608.0;
    // False for NaN, too.
    let has_fraction = coordinate.abs().less(coordinate.constant(NO_FRACTION));
    let coordinate = coordinate.masked(has_fraction);
    match wrap {
        Wrap::Repeat => coordinate - coordinate.floor(),
        Wrap::MirroredRepeat => {
            let two = coordinate.constant(2.0);
            let within_two = coordinate - two * (coordinate * coordinate.constant(0.5)).floor();
            within_two.minimum(two - within_two)
        }
        Wrap::ClampToEdge => coordinate.clamped(0.0, 1.0),
    }
}

/// The two texels between whose centres a place lies, and how far it is from the first to the
/// second, which is the result. The place is in texels, from 0 to `size`.
#[inline(always)]
fn neighbours<N: Lanes>(
    place: N,
    size: N,
    wrap: Wrap,
    [first, second]: [&mut [u32; LANES]; 2],
) -> N {
    let one = place.one();
    // Shifted by a whole texel, so that it is not negative.
    let shifted = place + place.constant(0.5);
    let after = shifted.floor().minimum(size);
    let last = size - one;
    let zero = place.zero();
    let repeats = wrap == Wrap::Repeat;
    let (before_first, after_last) = if repeats { (last, zero) } else { (zero, last) };
    before_first.select(after.less(one), after - one).store_whole(first, 0);
    after_last.select(last.less(after), after).store_whole(second, 0);
    shifted - after
}

#[inline(always)]
fn mix<N: Lanes, const C: usize>(mut a: [N; C], b: [N; C], fraction: N) -> [N; C] {
    for (a, b) in a.iter_mut().zip(b) {
        *a = *a + (b - *a) * fraction;
    }
    a
}

/// The whole number above.
#[inline(always)]
fn ceil<N: Lanes>(x: N) -> N {
    -(-x).floor()
}

#[cfg(test)]
mod tests;
