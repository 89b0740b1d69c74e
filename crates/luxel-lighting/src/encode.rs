//! From light to a picture's bytes, and back.
//!
//! The curve of sRGB (IEC 61966-2-1:1999): encode(v) = 12.92 v up to 0.0031308, else
//! 1.055 v^(1/2.4) - 0.055.

use luxel_math::{F64Lanes, LANES, Lanes, Simd, f32x16, i32x16, prelude::*, u32x16};
use std::sync::LazyLock;

/// How a picture stores light.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum PictureEncoding {
    /// By the curve of sRGB.
    #[default]
    Srgb,
    /// Linear.
    None,
}

impl PictureEncoding {
    /// round(255 encode(clamp(v, 0, 1))), ties to even; 0 for NaN. Exact: the byte is that of the
    /// formula over real numbers.
    #[inline]
    #[must_use]
    pub fn byte(self, linear: f32) -> u8 {
        match self {
            Self::Srgb => srgb_to_byte(linear),
            Self::None => unit_to_byte(linear),
        }
    }

    /// [`Self::byte`] of sixteen values.
    #[inline(always)]
    #[must_use]
    pub fn bytes_of_lanes<S: Simd>(self, linear: f32x16<S>) -> u32x16<S> {
        match self {
            Self::Srgb => SRGB.bytes_of_lanes(linear),
            Self::None => {
                let scaled = scaled_unit(linear);
                if from_whole(scaled).equal(scaled.constant(0.5)).any() {
                    let exact = linear.clamped(0.0, 1.0).to_f64();
                    let whole = exact.constant(WHOLE);
                    let rounded = exact * exact.constant(255.0) + whole - whole;
                    return i32x16::truncate_from(rounded.to_f32()).bitcast();
                }
                shifted(scaled) & 255
            }
        }
    }

    /// The bytes of sixteen colours as words, red lowest, with `alpha` in the highest byte.
    #[inline(always)]
    #[must_use]
    pub fn words_of_lanes<S: Simd>(self, [r, g, b]: [f32x16<S>; 3], alpha: u32x16<S>) -> u32x16<S> {
        if self == Self::None {
            let [red, green, blue] = [scaled_unit(r), scaled_unit(g), scaled_unit(b)];
            // One question for the three: ties are rare.
            let farthest = from_whole(red).maximum(from_whole(green)).maximum(from_whole(blue));
            if !farthest.equal(farthest.constant(0.5)).any() {
                let [red, green, blue] = [shifted(red), shifted(green), shifted(blue)];
                // Of the sums' exponents, that of red alone is left in the word.
                let exponent = FRACTIONLESS.to_bits();
                return red + (green << 8) + (blue << 16) + ((alpha << 24) - exponent);
            }
        }
        self.bytes_of_lanes(r)
            | self.bytes_of_lanes(g) << 8
            | self.bytes_of_lanes(b) << 16
            | alpha << 24
    }

    /// round(65535 encode(clamp(v, 0, 1))), ties to even; 0 for NaN.
    #[must_use]
    pub fn word(self, linear: f32) -> u16 {
        let unit = f64::from(unit(linear));
        let encoded = match self {
            Self::Srgb => encode_srgb(unit),
            Self::None => unit,
        };
        (encoded * 65535.0).round_ties_even() as u16
    }
}

/// 255 clamp(v, 0, 1), rounded to `f32`.
#[inline(always)]
fn scaled_unit<S: Simd>(linear: f32x16<S>) -> f32x16<S> {
    linear.clamped(0.0, 1.0) * linear.constant(255.0)
}

/// The nearest whole number in the lowest bits, ties to even, below the exponent of
/// [`FRACTIONLESS`].
#[inline(always)]
fn shifted<S: Simd>(scaled: f32x16<S>) -> u32x16<S> {
    (scaled + scaled.constant(FRACTIONLESS)).bitcast()
}

/// How far a product is from the nearest integer, 0.5 at most. If that: rounded to `f32` it may have
/// become a tie that it was not. Nothing else can change its byte.
#[inline(always)]
fn from_whole<S: Simd>(scaled: f32x16<S>) -> f32x16<S> {
    let whole = scaled + scaled.constant(FRACTIONLESS) - scaled.constant(FRACTIONLESS);
    Lanes::abs(scaled - whole)
}

/// encode(v) for v in 0..=1.
#[must_use]
pub fn encode_srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055
    }
}

/// The inverse of [`encode_srgb`]: v / 12.92 up to 0.04045, else ((v + 0.055) / 1.055)^2.4.
#[must_use]
pub fn decode_srgb(encoded: f64) -> f64 {
    if encoded <= 0.040_45 { encoded / 12.92 } else { libm::pow((encoded + 0.055) / 1.055, 2.4) }
}

/// The light of each byte of an sRGB-encoded picture: decode(byte / 255), rounded to `f32`.
#[must_use]
pub fn byte_to_linear() -> &'static [f32; 256] {
    &DECODED
}

static DECODED: LazyLock<[f32; 256]> =
    LazyLock::new(|| std::array::from_fn(|byte| decode_srgb(byte as f64 / 255.0) as f32));

/// round(255 clamp(v, 0, 1)), ties to even; 0 for NaN.
#[inline]
#[must_use]
pub fn unit_to_byte(linear: f32) -> u8 {
    (f64::from(unit(linear)) * 255.0 + WHOLE - WHOLE) as u8
}

/// Adding it rounds an `f64` to an integer, without a call where
/// processors have no instruction for that. In f64 the product with 255 is exact.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// The same for an `f32`, 2^23: the sum's lowest bits are the whole number.
const FRACTIONLESS: f32 = 8_388_608.0;

/// round(255 encode(clamp(v, 0, 1))), ties to even; 0 for NaN.
///
/// Exact for every `f32`: 255 thresholds, each the smallest `f32` whose byte is this or more,
/// decide. (No `f32` lies on a tie: in the straight part of the curve a tie is (2 k - 1) / 6589.2,
/// no dyadic fraction for k up to 10; in the other part it is irrational.)
#[inline]
#[must_use]
pub fn srgb_to_byte(linear: f32) -> u8 {
    SRGB.byte(linear)
}

/// Light below this is byte 0: 2^-13 is less than half a step, 1 / 6589.2.
const LEAST_BITS: u32 = (127 - 13) << 23;
/// Light from 1 on has the byte of this.
const BELOW_ONE: f32 = 1.0_f32.next_down();
/// Cells to each doubling, as a power of 2: 128, so that no cell holds two thresholds (the curve
/// has 84 steps in an octave at most, at its lower end, if the octave went on as it begins).
const CELL_BITS: u32 = 7;
const CELL_SHIFT: u32 = 23 - CELL_BITS;
/// More than the 13 octaves take: a power of 2.
const CELLS: usize = 16 << CELL_BITS;

/// The bits of a float below its cell's.
const WITHIN_CELL: u32 = (1 << CELL_SHIFT) - 1;

/// The bytes by the top bits of a float.
struct SrgbTable {
    /// For each cell the byte of its least value, times 2^16, plus what a float's lower bits lack
    /// at least to carry over where they reach the cell's threshold; 0 where it has none.
    cells: [u32; CELLS],
}

static SRGB: LazyLock<SrgbTable> = LazyLock::new(SrgbTable::new);

impl SrgbTable {
    /// The smallest `f32` whose byte is `k` + 1 or more, for each k below 255.
    fn thresholds() -> [f32; 255] {
        std::array::from_fn(|k| {
            let exact = decode_srgb((k as f64 + 0.5) / 255.0);
            let nearest = exact as f32;
            if f64::from(nearest) < exact { nearest.next_up() } else { nearest }
        })
    }

    fn new() -> Self {
        let thresholds = Self::thresholds().map(f32::to_bits);
        let cells = std::array::from_fn(|cell| {
            let least = LEAST_BITS + ((cell as u32) << CELL_SHIFT);
            // The bits of positive floats are in the floats' order.
            let byte = thresholds.partition_point(|&threshold| threshold <= least);
            let inside = |&threshold: &u32| threshold <= least + WITHIN_CELL;
            let carries = thresholds
                .get(byte)
                .copied()
                .filter(inside)
                .map_or(0, |threshold| WITHIN_CELL + 1 - (threshold - least));
            ((byte as u32) << CELL_SHIFT) + carries
        });
        Self { cells }
    }

    #[inline]
    fn byte(&self, linear: f32) -> u8 {
        // Comparisons with NaN are false. Clamped values have the byte of that end of the range.
        let least = f32::from_bits(LEAST_BITS);
        let inside = if linear > least { linear } else { least };
        let bits = if inside < BELOW_ONE { inside } else { BELOW_ONE }.to_bits();
        let cell = (bits - LEAST_BITS) >> CELL_SHIFT;
        ((self.cells[cell as usize & (CELLS - 1)] + (bits & WITHIN_CELL)) >> CELL_SHIFT) as u8
    }

    #[inline(always)]
    fn bytes_of_lanes<S: Simd>(&self, linear: f32x16<S>) -> u32x16<S> {
        let least = linear.constant(f32::from_bits(LEAST_BITS));
        let inside = linear.maximum(least).minimum(linear.constant(BELOW_ONE));
        let bits: u32x16<S> = inside.bitcast();
        let mut entries = [0; LANES];
        ((bits - LEAST_BITS) >> CELL_SHIFT).store_slice(&mut entries);
        for entry in &mut entries {
            *entry = self.cells[*entry as usize & (CELLS - 1)];
        }
        (u32x16::simd_from(linear.simd, entries) + (bits & WITHIN_CELL)) >> CELL_SHIFT
    }
}

/// The value brought into 0..=1; 0 for NaN.
#[inline]
fn unit(linear: f32) -> f32 {
    if linear > 0.0 { linear.min(1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The definition, in f64.
    fn reference(linear: f32) -> u8 {
        (255.0 * encode_srgb(f64::from(linear).clamp(0.0, 1.0))).round_ties_even() as u8
    }

    #[test]
    fn each_threshold_is_exact_on_both_sides() {
        for (k, &threshold) in SrgbTable::thresholds().iter().enumerate() {
            let byte = k as u8;
            assert_eq!(srgb_to_byte(threshold), byte + 1);
            assert_eq!(srgb_to_byte(threshold.next_down()), byte);
            assert_eq!(reference(threshold), byte + 1);
            assert_eq!(reference(threshold.next_down()), byte);
            // f64 settles it: its error is far below the distance to the next f32.
            let exact = decode_srgb((k as f64 + 0.5) / 255.0);
            for near in [threshold, threshold.next_down()] {
                let distance = (f64::from(near) - exact).abs() / exact;
                assert!(distance > 1e-12, "byte {byte}: {distance:e}");
            }
        }
    }

    #[test]
    fn no_cell_holds_two_thresholds() {
        let cells: Vec<_> = SrgbTable::thresholds()
            .iter()
            .map(|threshold| (threshold.to_bits() - LEAST_BITS) >> CELL_SHIFT)
            .collect();
        assert!(cells.windows(2).all(|pair| pair[0] < pair[1]));
    }

    #[test]
    fn every_thousandth_float_has_the_byte_of_the_definition() {
        for bits in (0..=1.5_f32.to_bits()).step_by(1009) {
            let value = f32::from_bits(bits);
            assert_eq!(srgb_to_byte(value), reference(value), "{value:e}");
        }
    }

    #[test]
    fn values_outside_the_unit_are_clamped_and_nan_is_black() {
        for (value, byte) in [
            (-1.0, 0),
            (-0.0, 0),
            (f32::NEG_INFINITY, 0),
            (f32::NAN, 0),
            (-f32::NAN, 0),
            (1e-30, 0),
            (1.0, 255),
            (1e30, 255),
            (f32::INFINITY, 255),
        ] {
            assert_eq!(srgb_to_byte(value), byte, "{value}");
            assert_eq!(unit_to_byte(value), byte, "{value}");
            let word = PictureEncoding::Srgb.word(value);
            assert_eq!(word, u16::from(byte) * 257, "{value}");
        }
    }

    #[test]
    fn ties_of_unencoded_light_go_to_even() {
        // 0.5 is 127.5 of 255 steps, between 127 and 128.
        assert_eq!(unit_to_byte(0.5), 128);
        assert_eq!(unit_to_byte(0.5_f32.next_down()), 127);
        assert_eq!(PictureEncoding::None.word(0.5), 32768);
    }

    #[test]
    fn decoding_and_encoding_again_gives_every_byte_back() {
        for (byte, &linear) in byte_to_linear().iter().enumerate() {
            assert_eq!(usize::from(srgb_to_byte(linear)), byte);
        }
        // IEC 61966-2-1: the middle grey 118 is 0.1812.
        assert!((byte_to_linear()[118] - 0.181_164).abs() < 1e-6);
    }

    #[test]
    fn words_agree_with_bytes_to_half_a_step() {
        for step in 0..=10_000 {
            let value = step as f32 / 10_000.0;
            let word = f64::from(PictureEncoding::Srgb.word(value)) / 257.0;
            assert!((word - f64::from(srgb_to_byte(value))).abs() <= 0.502);
        }
    }
}
