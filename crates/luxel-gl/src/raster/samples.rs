//! Where the samples of a pixel lie, and which of them a fragment covers (OpenGL 1.5, sections 3.2.1 and 4.1.3).

use luxel_math::{Lanes, SUBPIXELS};

/// Samples of a pixel in framebuffers that have several.
pub(crate) const SAMPLES: usize = 4;
const _: () = assert!(SAMPLES.is_power_of_two(), "means are found by shifts");

/// A pixel's centre.
const CENTRE: [i32; 2] = [SUBPIXELS / 2; 2];

/// Four samples in steps of 1/256 pixel, each in a row and a column of its own.
const FOUR: [[i32; 2]; SAMPLES] = [[96, 32], [224, 96], [32, 160], [160, 224]];

/// What `GL_MULTISAMPLE` and its kind do to fragments of a framebuffer with several samples.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Multisample {
    /// Alphas take samples away (`GL_SAMPLE_ALPHA_TO_COVERAGE`).
    pub(crate) alpha_to_coverage: bool,
    /// Alphas are 1 afterwards (`GL_SAMPLE_ALPHA_TO_ONE`).
    pub(crate) alpha_to_one: bool,
    /// The part of the samples that is covered at most, and whether it is the other part (`GL_SAMPLE_COVERAGE`).
    pub(crate) coverage: Option<(f32, bool)>,
}

impl Multisample {
    /// Whether alphas decide what is covered, or are changed.
    pub(super) fn needs_colors(&self) -> bool {
        self.alpha_to_coverage || self.alpha_to_one
    }

    /// Whether `GL_SAMPLE_COVERAGE` lets a sample be covered.
    pub(super) fn covers(&self, sample: usize) -> bool {
        self.coverage.is_none_or(|(value, invert)| {
            let count = (value * SAMPLES as f32 + 0.5) as usize;
            (sample < count) != invert
        })
    }
}

/// Where a sample lies: at the centre, unless polygons are drawn sample by sample.
pub(super) fn offset(multisample: Option<&Multisample>, sample: usize) -> [i32; 2] {
    offsets(multisample, SAMPLES)[sample % SAMPLES]
}

/// Where `count` samples lie, each by [`offset`].
pub(super) fn offsets(multisample: Option<&Multisample>, count: usize) -> &'static [[i32; 2]] {
    let all: &[[i32; 2]; SAMPLES] = multisample.map_or(&[CENTRE; SAMPLES], |_| &FOUR);
    &all[..count.min(SAMPLES)]
}

/// The lanes whose alpha covers a sample: as many of the first ones as alpha is a part of all, rounded.
#[inline(always)]
pub(super) fn covered_by_alpha<N: Lanes>(alpha: N, sample: usize) -> N::Mask {
    let least = (sample as f32 + 0.5) / SAMPLES as f32;
    alpha.constant(least).less_or_equal(alpha)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_3_2_1_samples_share_no_row_and_no_column_and_have_their_middle_at_the_centre() {
        for axis in 0..2 {
            let mut places = FOUR.map(|sample| sample[axis]);
            assert_eq!(places.iter().sum::<i32>(), 4 * SUBPIXELS / 2);
            places.sort_unstable();
            assert_eq!(places, [32, 96, 160, 224]);
        }
    }

    #[test]
    fn section_4_1_3_a_value_of_coverage_takes_as_many_samples_and_inverted_the_others() {
        let covered = |value: f32, invert: bool| {
            let of = Multisample {
                alpha_to_coverage: false,
                alpha_to_one: false,
                coverage: Some((value, invert)),
            };
            (0..SAMPLES).map(|sample| of.covers(sample)).collect::<Vec<_>>()
        };
        assert_eq!(covered(0.5, false), [true, true, false, false]);
        assert_eq!(covered(0.5, true), [false, false, true, true]);
        assert_eq!(covered(0.0, false), [false; 4]);
        assert_eq!(covered(1.0, false), [true; 4]);
    }

    #[test]
    fn section_4_1_3_more_alpha_covers_more_samples() {
        let count = |alpha: f32| (0..SAMPLES).filter(|&of| covered_by_alpha(alpha, of)).count();
        assert_eq!([0.0, 0.2, 0.3, 0.5, 0.8, 1.0].map(count), [0, 1, 1, 2, 3, 4]);
    }
}
