//! From texture coordinates to light: wrapping, filtering, level of detail.
//!
//! As OpenGL 4.6 says (core profile, section 8.14), with the footprint of a pixel taken from the
//! derivatives of the texture coordinates. Where the footprint is long and thin, up to
//! [`MOST_PROBES`] probes lie along it (after `GL_EXT_texture_filter_anisotropic`), each from the
//! level that fits its width, so that floors stay sharp towards the horizon.

use crate::encoding::BYTE_TO_UNIT;
use crate::texture::{MipLevel, Texture};
use luxel_math::elementary::log2;

/// How many probes a footprint gets at most.
const MOST_PROBES: f32 = 8.0;

/// By how much a footprint may be longer than its probes cover before there is another one:
/// footprints that are nearly square need no second probe.
const STRETCH_TOLERATED: f32 = 0.125;

/// What happens outside 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
pub enum Filter {
    /// The nearest texel.
    Nearest,
    /// A weighted mean of neighbours, and of mipmap levels.
    #[default]
    Linear,
}

/// The rules of sampling.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
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
    /// Repeating, trilinear: what files that say nothing get.
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
    /// Linear red, green, blue and alpha at (u, v), (0, 0) being the image's upper left, seen
    /// through a pixel over which the coordinates change by `per_pixel_x` = (du/dx, dv/dx) from
    /// left to right and by `per_pixel_y` from top to bottom.
    ///
    /// With P_x, P_y the lengths of the two in texels of level 0, P_max and P_min the longer and
    /// the shorter, there are N = ceil(P_max / max(P_min, 1)) probes (at most 8) along the longer
    /// one, from the level lambda = log2(P_max / N). Samplers that take the nearest texel or know
    /// no levels get one probe. Coordinates that aren't finite, or so large that no fraction is
    /// left, count as 0.
    #[must_use]
    #[inline]
    pub fn sample(&self, u: f32, v: f32, per_pixel_x: [f32; 2], per_pixel_y: [f32; 2]) -> [f32; 4] {
        let Some(base) = self.image.levels.first() else { return [0.0; 4] };
        let (width, height) = (base.width as f32, base.height as f32);
        let squared_length = |[du, dv]: [f32; 2]| {
            let (across, down) = (du * width, dv * height);
            // Not a number counts as 0, beyond all measure as far out.
            let squared = across * across + down * down;
            if squared > 0.0 { squared.min(1e30) } else { 0.0 }
        };
        let (squared_x, squared_y) = (squared_length(per_pixel_x), squared_length(per_pixel_y));
        let x_is_longer = squared_x >= squared_y;
        let (longer, shorter) =
            if x_is_longer { (squared_x, squared_y) } else { (squared_y, squared_x) };
        if longer <= 1.0 {
            return self.filtered(base, u, v, self.sampler.magnify);
        }
        let Some(between) = self.sampler.mipmap else {
            return self.filtered(base, u, v, self.sampler.minify);
        };
        if self.sampler.minify == Filter::Nearest {
            return self.of_level(u, v, 0.5 * log2(longer), between);
        }
        let stretch = (longer / shorter.max(1.0)).sqrt() - STRETCH_TOLERATED;
        if stretch <= 1.0 {
            return self.of_level(u, v, 0.5 * log2(longer), between);
        }
        let probes = ceil(stretch.min(MOST_PROBES));
        let level = 0.5 * log2(longer / (probes * probes));
        let [du, dv] = if x_is_longer { per_pixel_x } else { per_pixel_y };
        let mut sum = [0.0; 4];
        let mut probe = 1.0;
        while probe <= probes {
            // From just after -1/2 to just before 1/2 of a pixel.
            let along = probe / (probes + 1.0) - 0.5;
            let value = self.of_level(u + du * along, v + dv * along, level, between);
            for (sum, value) in sum.iter_mut().zip(value) {
                *sum += value;
            }
            probe += 1.0;
        }
        sum.map(|sum| sum / probes)
    }

    /// The value of level 0 at (u, v), for questions that must not depend on the pixel, such as
    /// alpha masks: filtered as where a texel covers more than a pixel.
    #[must_use]
    #[inline]
    pub fn sample_base(&self, u: f32, v: f32) -> [f32; 4] {
        match self.image.levels.first() {
            Some(base) => self.filtered(base, u, v, self.sampler.magnify),
            None => [0.0; 4],
        }
    }

    /// The value at a level of detail, which may lie between two levels.
    #[inline]
    fn of_level(&self, u: f32, v: f32, level: f32, between: Filter) -> [f32; 4] {
        let levels = &self.image.levels;
        let Sampler { magnify, minify, .. } = self.sampler;
        // Where magnified texels are smooth and minified ones aren't, the change comes half a
        // level later, or pictures would be sharper from afar (OpenGL 4.6, 8.15).
        let threshold =
            if magnify == Filter::Linear && minify == Filter::Nearest { 0.5 } else { 0.0 };
        if level <= threshold {
            return self.filtered(&levels[0], u, v, magnify);
        }
        let last = levels.len() - 1;
        match between {
            Filter::Nearest => {
                // ceil(level + 1/2) - 1: halves go to the larger picture.
                let nearest = (ceil(level + 0.5) as usize).saturating_sub(1).min(last);
                self.filtered(&levels[nearest], u, v, minify)
            }
            Filter::Linear => {
                let larger = level as usize;
                if larger >= last {
                    return self.filtered(&levels[last], u, v, minify);
                }
                let a = self.filtered(&levels[larger], u, v, minify);
                let b = self.filtered(&levels[larger + 1], u, v, minify);
                mix(a, b, level - larger as f32)
            }
        }
    }

    /// The value within one level.
    #[inline]
    fn filtered(&self, level: &MipLevel, u: f32, v: f32, filter: Filter) -> [f32; 4] {
        let table = self.image.encoding.table();
        let fetch = |x: u32, y: u32| {
            let [r, g, b, a] = level.texels[y as usize * level.width as usize + x as usize];
            [table[r as usize], table[g as usize], table[b as usize], BYTE_TO_UNIT[a as usize]]
        };
        let across = folded(u, self.sampler.wrap_u) * level.width as f32;
        let down = folded(v, self.sampler.wrap_v) * level.height as f32;
        match filter {
            Filter::Nearest => {
                fetch((across as u32).min(level.width - 1), (down as u32).min(level.height - 1))
            }
            Filter::Linear => {
                let (left, right, x) = neighbours(across, level.width, self.sampler.wrap_u);
                let (upper, lower, y) = neighbours(down, level.height, self.sampler.wrap_v);
                let above = mix(fetch(left, upper), fetch(right, upper), x);
                let below = mix(fetch(left, lower), fetch(right, lower), x);
                mix(above, below, y)
            }
        }
    }
}

/// The coordinate brought to 0..=1 by the rule for what lies outside.
#[inline]
fn folded(coordinate: f32, wrap: Wrap) -> f32 {
    /// From here on, coordinates are whole numbers.
    const NO_FRACTION: f32 = 8_388_608.0;
    // False for what isn't a number, too.
    let coordinate = if coordinate.abs() < NO_FRACTION { coordinate } else { 0.0 };
    match wrap {
        Wrap::Repeat => coordinate - floor(coordinate),
        Wrap::MirroredRepeat => {
            let within_two = coordinate - 2.0 * floor(coordinate * 0.5);
            within_two.min(2.0 - within_two)
        }
        Wrap::ClampToEdge => coordinate.clamp(0.0, 1.0),
    }
}

/// The two texels between whose centres a place lies, and how far it is from the first to the
/// second. The place is in texels, from 0 to `size`.
#[inline]
fn neighbours(place: f32, size: u32, wrap: Wrap) -> (u32, u32, f32) {
    // Shifted by a whole texel, so that it is positive and cut off rather than rounded down.
    let shifted = place + 0.5;
    let second = (shifted as u32).min(size);
    let fraction = shifted - second as f32;
    let last = size - 1;
    let (before, after) = if wrap == Wrap::Repeat { (last, 0) } else { (0, last) };
    let first = if second == 0 { before } else { second - 1 };
    (first, if second > last { after } else { second }, fraction)
}

#[inline]
fn mix(a: [f32; 4], b: [f32; 4], fraction: f32) -> [f32; 4] {
    [
        a[0] + (b[0] - a[0]) * fraction,
        a[1] + (b[1] - a[1]) * fraction,
        a[2] + (b[2] - a[2]) * fraction,
        a[3] + (b[3] - a[3]) * fraction,
    ]
}

/// The whole number below, for numbers that fit into an `i32`. The standard library's is a call on
/// machines without an instruction for it.
#[inline]
fn floor(x: f32) -> f32 {
    let toward_zero = x as i32 as f32;
    if toward_zero > x { toward_zero - 1.0 } else { toward_zero }
}

/// The whole number above.
#[inline]
fn ceil(x: f32) -> f32 {
    -floor(-x)
}

#[cfg(test)]
mod tests;
