//! Samples of the three types.

/// The type of a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Uint,
    Half,
    Float,
}

impl Kind {
    pub(super) const fn of(number: i32) -> Option<Self> {
        match number {
            0 => Some(Self::Uint),
            1 => Some(Self::Half),
            2 => Some(Self::Float),
            _ => None,
        }
    }

    pub(super) const fn bytes(self) -> usize {
        match self {
            Self::Half => 2,
            Self::Uint | Self::Float => 4,
        }
    }

    /// The value of a sample; 0 without enough bytes.
    pub(super) fn value(self, bytes: &[u8]) -> f32 {
        match (self, bytes) {
            (Self::Half, &[low, high]) => half(u16::from_le_bytes([low, high])),
            (Self::Uint, &[a, b, c, d]) => u32::from_le_bytes([a, b, c, d]) as f32,
            (Self::Float, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]),
            _ => 0.0,
        }
    }
}

/// A number of 16 bits: sign, 5 bits of exponent, 10 of mantissa (IEEE 754-2008).
fn half(bits: u16) -> f32 {
    let (exponent, mantissa) = (bits >> 10 & 0x1f, bits & 0x3ff);
    let magnitude = match (exponent, mantissa) {
        (0, mantissa) => f32::from(mantissa) / 16_777_216.0,
        (0x1f, 0) => f32::INFINITY,
        (0x1f, _) => f32::NAN,
        _ => f32::from_bits((u32::from(exponent) + 112) << 23 | u32::from(mantissa) << 13),
    };
    if bits & 0x8000 == 0 { magnitude } else { -magnitude }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halves_have_their_values() {
        for (bits, value) in [
            (0, 0.0),
            (0x3c00, 1.0),
            (0xc000, -2.0),
            (0x7bff, 65_504.0),
            (0x0001, 5.960_464_5e-8),
            (0x0400, 6.103_515_6e-5),
            (0x3555, 0.333_251_95),
            (0x7c00, f32::INFINITY),
        ] {
            assert_eq!(half(bits), value, "{bits:x}");
        }
        assert!(half(0x7e00).is_nan());
    }
}
