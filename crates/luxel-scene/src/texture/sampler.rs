//! From texture coordinates to light: wrapping, filtering, level of detail.
//!
//! As in OpenGL 4.6 (core profile, section 8.14), with the footprint of a pixel taken from the
//! derivatives of the texture coordinates. Where the footprint is long and thin, up to
//! [`MOST_PROBES`] probes lie along it (after `GL_EXT_texture_filter_anisotropic`), each from the
//! level that fits its width, so that floors stay sharp towards the horizon.

use super::addressing::{Addressing, nearest_texel, neighbouring_texels, texel_position};
use super::level_of_detail::{Detail, LevelFilters, LevelSource, mix, squared_length};
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
        let Sampler { magnify, minify, mipmap, .. } = self.sampler;
        let (detail, probes, has_one);
        if let Some(between) = mipmap {
            let stretch = (longer / shorter.maximum(one)).sqrt() - u.constant(STRETCH_TOLERATED);
            has_one = if minify == Filter::Nearest {
                is_magnified.splat_like(true)
            } else {
                is_magnified | stretch.less_or_equal(one)
            };
            probes = one.select(has_one, ceil(stretch.minimum(u.constant(MOST_PROBES))));
            let level = u.constant(0.5) * log2(longer / (probes * probes));
            let level = u.constant(-1.0).select(is_magnified, level);
            let filters = LevelFilters { magnify, minify, between };
            let last = (self.image.levels.len() - 1) as u32;
            detail = Detail::new(level, filters, last, lanes);
        } else {
            detail = Detail::of_base(u, [magnify, minify], is_magnified.bits() & lanes);
            (probes, has_one) = (one, is_magnified.splat_like(true));
        }
        let du = per_pixel_x[0].select(x_is_longer, per_pixel_y[0]);
        let dv = per_pixel_x[1].select(x_is_longer, per_pixel_y[1]);
        let mut sum = [u.zero(); C];
        let mut probe = 1.0;
        // One probe goes this way, too: a second copy of what samples would be most of the code.
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
            let here = At { texture: self, u: u_here, v: v_here };
            let value: [N; C] = detail.value(u, &here, left);
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
        let [wrap_u, wrap_v] = [self.sampler.wrap_u, self.sampler.wrap_v].map(Addressing::from);
        let across = texel_position(u, width, wrap_u);
        let down = texel_position(v, height, wrap_v);
        let table = self.image.encoding.table();
        let [mut left, mut right, mut upper, mut lower] = [[0; LANES]; 4];
        match filter {
            Filter::Nearest => {
                nearest_texel(across, width, wrap_u).store_whole(&mut left, 0);
                nearest_texel(down, height, wrap_v).store_whole(&mut upper, 0);
                let mut texels = Texels::<FIRST, C>::new();
                u.visit(
                    lanes,
                    #[inline(always)]
                    |lane| texels.put(lane, level.texel(left[lane], upper[lane]), table),
                );
                texels.loaded(u)
            }
            Filter::Linear => {
                let x = neighbouring_texels(across, width, wrap_u, [&mut left, &mut right]);
                let y = neighbouring_texels(down, height, wrap_v, [&mut upper, &mut lower]);
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

/// A texture at a place.
struct At<'t, N> {
    texture: &'t Texture,
    u: N,
    v: N,
}

impl<N: Lanes, const C: usize> LevelSource<N, C> for At<'_, N> {
    #[inline(always)]
    fn filtered(&self, level: u32, filter: Filter, lanes: u32) -> [N; C] {
        let Self { texture, u, v } = *self;
        match texture.image.levels.get(level as usize) {
            Some(level) => texture.filtered::<N, 0, C>(level, u, v, filter, lanes),
            None => [u.zero(); C],
        }
    }
}

/// The whole number above.
#[inline(always)]
fn ceil<N: Lanes>(x: N) -> N {
    -(-x).floor()
}

#[cfg(test)]
mod tests;
