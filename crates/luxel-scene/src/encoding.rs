//! How an image's bytes stand for light.

use std::sync::LazyLock;

/// How an image's bytes stand for light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Encoding {
    /// Red, green and blue by the curve of IEC 61966-2-1; alpha linear: colours.
    Srgb,
    /// All four linear: normals, roughness, masks.
    Linear,
}

impl Encoding {
    /// The linear value of a byte of red, green or blue, from 0 to 1.
    #[must_use]
    pub const fn linear(self, byte: u8) -> f32 {
        self.table()[byte as usize]
    }

    /// The linear values of all bytes of red, green and blue.
    pub(crate) const fn table(self) -> &'static [f32; 256] {
        match self {
            Self::Srgb => &SRGB_TO_LINEAR,
            Self::Linear => &BYTE_TO_UNIT,
        }
    }
}

/// b / 255.
pub(crate) static BYTE_TO_UNIT: [f32; 256] = {
    let mut table = [0.0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = byte as f32 / 255.0;
        byte += 1;
    }
    table
};

/// The linear value of each sRGB byte, rounded from f64.
static SRGB_TO_LINEAR: [f32; 256] = {
    let mut table = [0.0; 256];
    let mut byte = 0;
    while byte < 256 {
        table[byte] = srgb_to_linear(byte as f64 / 255.0) as f32;
        byte += 1;
    }
    table
};

/// The curve of IEC 61966-2-1: v / 12.92 up to 0.04045, ((v + 0.055) / 1.055)^2.4 above.
const fn srgb_to_linear(v: f64) -> f64 {
    if v <= 0.04045 {
        return v / 12.92;
    }
    let base = (v + 0.055) / 1.055;
    // x^2.4 = x^2 r^2 with r the fifth root of x, by Newton's method: r^5 = x.
    let mut root = 1.0;
    let mut step = 0;
    while step < 40 {
        let fourth = root * root * root * root;
        root = (4.0 * root + base / fourth) / 5.0;
        step += 1;
    }
    base * base * root * root
}

/// The largest linear value in the whole numbers that mipmaps are averaged in.
pub(crate) const LINEAR_STEPS: u16 = u16::MAX;

/// The number type of mipmap averages: linear light in integers, so that sums are exact.
pub(crate) struct WholeNumbers {
    /// From a byte to 0..=[`LINEAR_STEPS`].
    pub(crate) linear: [u16; 256],
    /// Back to the nearest byte.
    pub(crate) byte: Vec<u8>,
}

impl WholeNumbers {
    pub(crate) fn of(encoding: Encoding) -> &'static Self {
        static SRGB: LazyLock<WholeNumbers> = LazyLock::new(|| WholeNumbers::new(srgb_to_linear));
        static LINEAR: LazyLock<WholeNumbers> = LazyLock::new(|| WholeNumbers::new(|v| v));
        match encoding {
            Encoding::Srgb => &SRGB,
            Encoding::Linear => &LINEAR,
        }
    }

    fn new(curve: impl Fn(f64) -> f64) -> Self {
        let steps = f64::from(LINEAR_STEPS);
        // Rounding is half up; exact halves occur in neither curve but at bytes and thresholds.
        let linear = std::array::from_fn(|byte| (curve(byte as f64 / 255.0) * steps + 0.5) as u16);
        let mut byte = Vec::with_capacity(usize::from(LINEAR_STEPS) + 1);
        for below in 0..255 {
            // Up to where the next byte is nearer, on the curve's own scale.
            let end = curve((f64::from(below) + 0.5) / 255.0) * steps;
            byte.resize(byte.len().max(libm::ceil(end) as usize), below as u8);
        }
        byte.resize(usize::from(LINEAR_STEPS) + 1, 255);
        Self { linear, byte }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_bytes_are_the_rounded_values_of_the_standard() {
        for byte in 0..=255_u8 {
            let v = f64::from(byte) / 255.0;
            let exact = if v <= 0.04045 { v / 12.92 } else { libm::pow((v + 0.055) / 1.055, 2.4) };
            assert_eq!(Encoding::Srgb.linear(byte), exact as f32, "{byte}");
            assert_eq!(Encoding::Linear.linear(byte), (f64::from(byte) / 255.0) as f32);
        }
    }

    #[test]
    fn bytes_come_back_from_whole_numbers() {
        for encoding in [Encoding::Srgb, Encoding::Linear] {
            let numbers = WholeNumbers::of(encoding);
            assert_eq!(numbers.byte.len(), 65_536);
            for byte in 0..=255_u8 {
                let linear = numbers.linear[usize::from(byte)];
                assert_eq!(numbers.byte[usize::from(linear)], byte);
            }
            assert!(numbers.byte.is_sorted());
        }
    }
}
