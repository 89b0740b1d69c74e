//! Layers as 16-bit pictures, and what their numbers mean.

use super::LayerImage;
use crate::LayerValues;
use std::collections::BTreeSet;

/// What the 16 bits of a layer's picture mean.
#[derive(Clone, Debug, PartialEq)]
pub enum Legend {
    /// 0 stands for the first number, 65535 for the second, evenly between; for each channel.
    /// Values outside are brought to the nearest end; NaN is 0.
    Scaled(Vec<[f32; 2]>),
    /// Each number of the picture with its colour, in ascending order; nothing (4294967295) is black
    /// and not told.
    Colors(Vec<(u32, [u16; 3])>),
}

/// The words of a picture of one or three channels.
pub(crate) enum LayerWords {
    Gray(Vec<u16>),
    Rgb(Vec<[u16; 3]>),
}

/// The number that stands for nothing.
const NOTHING: u32 = u32::MAX;

/// The colour of a number: different for different numbers, bright, and unlike that of the numbers
/// next to it.
///
/// The number is mixed by two multiplications with odd factors and shifts, each of which can be
/// undone, and its 32 bits become 11 of red, 11 of green and 10 of blue, in the upper five sixths
/// of their range. Black stands for 4294967295.
#[must_use]
pub fn id_color(id: u32) -> [u16; 3] {
    const DARKEST: u32 = 0x2800;
    /// 2^32 over the golden ratio: spreads numbers that follow one another (Knuth 1973, 6.4).
    const GOLDEN: u32 = 0x9e37_79b1;
    /// Any odd factor of mixed bits does.
    const SECOND: u32 = 0x85eb_ca6b;
    if id == NOTHING {
        return [0; 3];
    }
    let mut bits = id.wrapping_add(1).wrapping_mul(GOLDEN);
    bits ^= bits >> 15;
    bits = bits.wrapping_mul(SECOND);
    bits ^= bits >> 13;
    let red = DARKEST + (bits >> 21) * 27;
    let green = DARKEST + ((bits >> 10) & 0x7ff) * 27;
    let blue = DARKEST + (bits & 0x3ff) * 54;
    [red as u16, green as u16, blue as u16]
}

/// The picture of a layer.
pub(crate) fn of(layer: &LayerImage) -> (Legend, LayerWords) {
    match &layer.values {
        LayerValues::U32(ids) => {
            let different: BTreeSet<u32> =
                ids.iter().copied().filter(|&id| id != NOTHING).collect();
            let legend = different.into_iter().map(|id| (id, id_color(id))).collect();
            (Legend::Colors(legend), LayerWords::Rgb(ids.iter().map(|&id| id_color(id)).collect()))
        }
        LayerValues::F32(values) => {
            let channels = layer.channels;
            let ranges: Vec<_> = (0..channels)
                .map(|channel| range(&layer.name, values, channel, channels))
                .collect();
            let word = |value: f32, channel: usize| scaled(value, ranges[channel]);
            let words = if channels == 1 {
                LayerWords::Gray(values.iter().map(|&value| word(value, 0)).collect())
            } else {
                let pixel = |pixel: &[f32]| {
                    let mut words = [0; 3];
                    for (channel, (target, &value)) in words.iter_mut().zip(pixel).enumerate() {
                        *target = word(value, channel);
                    }
                    words
                };
                LayerWords::Rgb(values.chunks_exact(channels).map(pixel).collect())
            };
            (Legend::Scaled(ranges), words)
        }
    }
}

/// A layer as it is seen on a screen: the upper eight bits of [`Legend`]'s picture, gray as three equal
/// channels.
#[must_use]
pub fn layer_rgb8(layer: &LayerImage) -> Vec<[u8; 3]> {
    let byte = |word: u16| (word >> 8) as u8;
    match of(layer).1 {
        LayerWords::Gray(words) => words.into_iter().map(|word| [byte(word); 3]).collect(),
        LayerWords::Rgb(words) => words.into_iter().map(|words| words.map(byte)).collect(),
    }
}

/// What 0 and 65535 stand for: fixed where the layer has natural bounds, else its least and its
/// largest finite value.
fn range(name: &str, values: &[f32], channel: usize, channels: usize) -> [f32; 2] {
    match name {
        "normal" | "n_dot_l" => [-1.0, 1.0],
        "z" | "position" | "uv" => {
            let finite = values.iter().skip(channel).step_by(channels).filter(|v| v.is_finite());
            let (low, high) = finite.fold((f32::INFINITY, f32::NEG_INFINITY), |(low, high), &v| {
                (low.min(v), high.max(v))
            });
            if low <= high { [low, high] } else { [0.0, 1.0] }
        }
        _ => [0.0, 1.0],
    }
}

/// 65535 (value - low) / (high - low), rounded, ties to even.
fn scaled(value: f32, [low, high]: [f32; 2]) -> u16 {
    let (value, low, high) = (f64::from(value), f64::from(low), f64::from(high));
    let part = if high > low {
        (value - low) / (high - low)
    } else if value > high {
        1.0
    } else {
        0.0
    };
    // A cast takes NaN to 0 and what is too large to the end.
    (part * 65535.0).round_ties_even() as u16
}
