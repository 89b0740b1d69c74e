//! From coordinates to texels: wrapping, and the neighbours that a linear filter weighs.
//!
//! One axis at a time, for textures of one, two and three dimensions (OpenGL 4.6, core profile, sections 8.14.2 and
//! 8.14.3; OpenGL 2.1, section 3.8.7, for the mode that only it has).

use super::Wrap;
use luxel_math::{LANES, Lanes};

/// What lies outside of the texels of an axis.
///
/// Texels are numbered from 0. With the last two modes there is a border: number `size` is the texel before the
/// first one, `size + 1` the one after the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Addressing {
    /// The image repeats.
    Repeat,
    /// It repeats, every other one mirrored.
    MirroredRepeat,
    /// The edge goes on.
    ClampToEdge,
    /// Coordinates end at 0 and 1; filters weigh the border there (`GL_CLAMP`).
    Clamp,
    /// Coordinates end half a texel outside, where there is only border.
    ClampToBorder,
}

impl From<Wrap> for Addressing {
    fn from(wrap: Wrap) -> Self {
        match wrap {
            Wrap::Repeat => Self::Repeat,
            Wrap::MirroredRepeat => Self::MirroredRepeat,
            Wrap::ClampToEdge => Self::ClampToEdge,
        }
    }
}

/// From here on, coordinates are whole numbers.
const NO_FRACTION: f32 = 8_388_608.0;

/// Where a coordinate lies on an axis of `size` texels, in texels: from 0 to `size`, or half a texel further where
/// there is a border. Coordinates that aren't finite, or so large that no fraction is left, count as 0.
#[inline(always)]
#[must_use]
pub fn texel_position<N: Lanes>(coordinate: N, size: N, addressing: Addressing) -> N {
    // False for NaN, too.
    let has_fraction = coordinate.abs().less(coordinate.constant(NO_FRACTION));
    let coordinate = coordinate.masked(has_fraction);
    let folded = match addressing {
        Addressing::Repeat => coordinate - coordinate.floor(),
        Addressing::MirroredRepeat => {
            let two = coordinate.constant(2.0);
            let within_two = coordinate - two * (coordinate * coordinate.constant(0.5)).floor();
            // Half of the negative number next to 0 is -0, whose floor is no less than itself.
            within_two.minimum(two - within_two).positive_part()
        }
        Addressing::ClampToEdge | Addressing::Clamp => coordinate.clamped(0.0, 1.0),
        Addressing::ClampToBorder => {
            let half = coordinate.constant(0.5);
            return (coordinate * size).maximum(-half).minimum(size + half);
        }
    };
    folded * size
}

/// The number of the texel that a position lies in.
#[inline(always)]
#[must_use]
pub fn nearest_texel<N: Lanes>(position: N, size: N, addressing: Addressing) -> N {
    let number = position.floor();
    if addressing != Addressing::ClampToBorder {
        return number.minimum(size - size.one());
    }
    let number = size.select(number.less(number.zero()), number);
    (size + size.one()).select(size.less_or_equal(position), number)
}

/// The two texels between whose centres a position lies, and how far it is from the first to the
/// second, which is the result.
#[inline(always)]
pub fn neighbouring_texels<N: Lanes>(
    position: N,
    size: N,
    addressing: Addressing,
    [first, second]: [&mut [u32; LANES]; 2],
) -> N {
    let one = position.one();
    // Shifted by a whole texel, so that it is not negative.
    let shifted = position + position.constant(0.5);
    let after = shifted.floor().minimum(size);
    let last = size - one;
    let zero = position.zero();
    let (before_first, after_last) = match addressing {
        Addressing::Repeat => (last, zero),
        Addressing::MirroredRepeat | Addressing::ClampToEdge => (zero, last),
        Addressing::Clamp | Addressing::ClampToBorder => (size, size + one),
    };
    before_first.select(after.less(one), after - one).store_whole(first, 0);
    after_last.select(last.less(after), after).store_whole(second, 0);
    shifted - after
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers of the two texels, and the second's weight.
    fn linear(coordinate: f32, addressing: Addressing) -> (u32, u32, f32) {
        let (mut first, mut second) = ([0; LANES], [0; LANES]);
        let position = texel_position(coordinate, 4.0, addressing);
        let weight = neighbouring_texels(position, 4.0, addressing, [&mut first, &mut second]);
        (first[0], second[0], weight)
    }

    #[test]
    fn section_3_8_7_clamp_weighs_edge_and_border_equally_and_clamp_to_border_reaches_it() {
        assert_eq!(linear(-3.0, Addressing::Clamp), (4, 0, 0.5));
        assert_eq!(linear(3.0, Addressing::Clamp), (3, 5, 0.5));
        assert_eq!(linear(-3.0, Addressing::ClampToBorder), (4, 0, 0.0));
        assert_eq!(linear(3.0, Addressing::ClampToBorder), (3, 5, 1.0));
        assert_eq!(linear(3.0, Addressing::ClampToEdge), (3, 3, 0.5));
        assert_eq!(linear(0.5, Addressing::ClampToBorder), (1, 2, 0.5));
    }

    #[test]
    fn the_numbers_next_to_0_lie_on_the_axis_in_every_mode() {
        for addressing in [
            Addressing::Repeat,
            Addressing::MirroredRepeat,
            Addressing::ClampToEdge,
            Addressing::Clamp,
        ] {
            for coordinate in [-f32::from_bits(1), -f32::MIN_POSITIVE, -0.0, f32::from_bits(1)] {
                let position = texel_position(coordinate, 4.0, addressing);
                assert!((0.0..=4.0).contains(&position), "{coordinate:e}: {position:e}");
                assert!(nearest_texel(position, 4.0, addressing) >= 0.0, "{coordinate:e}");
            }
        }
    }

    #[test]
    fn section_3_8_8_the_nearest_texel_outside_is_the_border_only_where_that_is_asked_for() {
        let nearest = |coordinate: f32, addressing| {
            nearest_texel(texel_position(coordinate, 4.0, addressing), 4.0, addressing)
        };
        assert_eq!(nearest(-0.001, Addressing::ClampToBorder), 4.0);
        assert_eq!(nearest(1.0, Addressing::ClampToBorder), 5.0);
        assert_eq!(nearest(0.999, Addressing::ClampToBorder), 3.0);
        assert_eq!(nearest(7.0, Addressing::Clamp), 3.0);
        assert_eq!(nearest(f32::NAN, Addressing::Clamp), 0.0);
    }
}
