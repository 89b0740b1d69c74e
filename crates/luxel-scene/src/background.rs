//! What lies behind everything.

use crate::Encoding;

/// What a picture shows where no surface is seen. Exposure and tone curve leave it as it is.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Background {
    /// One colour: linear red, green, blue, and alpha.
    Flat([f32; 4]),
    /// An opaque, quiet gradient from the top of the picture to its bottom, as of light paper.
    Studio,
}

/// The studio's colour at the top, `#f4f2ee`.
const TOP: [f32; 3] = srgb([0xf4, 0xf2, 0xee]);
/// The studio's colour at the bottom, `#dedad2`.
const BOTTOM: [f32; 3] = srgb([0xde, 0xda, 0xd2]);

const fn srgb([r, g, b]: [u8; 3]) -> [f32; 3] {
    [Encoding::Srgb.linear(r), Encoding::Srgb.linear(g), Encoding::Srgb.linear(b)]
}

impl Background {
    /// Nothing: black with alpha 0.
    pub const TRANSPARENT: Self = Self::Flat([0.0; 4]);
    /// The studio's name, in flags and scene files.
    pub const STUDIO: &'static str = "studio";

    /// Linear red, green, blue (not multiplied by alpha) and alpha; `down` is 0 at the top of the picture
    /// and 1 at its bottom.
    #[must_use]
    pub fn color(&self, down: f32) -> [f32; 4] {
        match *self {
            Self::Flat(color) => color,
            Self::Studio => {
                let [r, g, b] =
                    [0, 1, 2].map(|channel| TOP[channel] * (1.0 - down) + BOTTOM[channel] * down);
                [r, g, b, 1.0]
            }
        }
    }
}

impl Default for Background {
    fn default() -> Self {
        Self::TRANSPARENT
    }
}

impl From<[f32; 4]> for Background {
    fn from(color: [f32; 4]) -> Self {
        Self::Flat(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_studio_is_opaque_and_runs_from_its_light_colour_down_to_its_darker_one() {
        let [r, g, b, alpha] = Background::Studio.color(0.0);
        assert_eq!(([r, g, b], alpha), (TOP, 1.0));
        let [r, g, b, _] = Background::Studio.color(1.0);
        assert_eq!([r, g, b], BOTTOM);
        let mut last = TOP[0];
        for step in 1..=100 {
            let [r, ..] = Background::Studio.color(step as f32 / 100.0);
            assert!(r < last, "{step}");
            last = r;
        }
    }
}
