//! Formats and types of pixels (OpenGL 1.5, tables 3.5 to 3.8, 4.5 to 4.7).

use crate::enums as gl;

/// Which components a pixel has, in the order of memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Components {
    /// Places of red, green, blue, alpha.
    Colors(&'static [usize]),
    /// R + G + B, and alpha.
    Luminance {
        alpha: bool,
    },
    Depth,
    Stencil,
    /// Indices of colours in the pixel maps.
    Index,
    /// Depth, then stencil: as a part of 255, where components are from 0 to 1.
    DepthStencil,
}

/// Of a type: one element a component, or one for all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Elements {
    Byte,
    UnsignedByte,
    Short,
    UnsignedShort,
    Int,
    UnsignedInt,
    Float,
    /// A float, and a word with the stencil value in its low byte (ARB_depth_buffer_float).
    FloatAndByte,
    /// Bytes, bits of each component from the first on, and whether the first one is the lowest.
    Packed {
        bytes: usize,
        bits: &'static [u32],
        reversed: bool,
    },
}

/// Format and type together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PixelFormat {
    pub(crate) components: Components,
    pub(crate) elements: Elements,
}

impl Components {
    fn named(format: u32) -> Option<Self> {
        Some(match format {
            gl::RED => Self::Colors(&[0]),
            gl::GREEN => Self::Colors(&[1]),
            gl::BLUE => Self::Colors(&[2]),
            gl::ALPHA => Self::Colors(&[3]),
            gl::RGB => Self::Colors(&[0, 1, 2]),
            gl::RGBA => Self::Colors(&[0, 1, 2, 3]),
            gl::BGR => Self::Colors(&[2, 1, 0]),
            gl::BGRA => Self::Colors(&[2, 1, 0, 3]),
            gl::ABGR => Self::Colors(&[3, 2, 1, 0]),
            gl::LUMINANCE => Self::Luminance { alpha: false },
            gl::LUMINANCE_ALPHA => Self::Luminance { alpha: true },
            gl::DEPTH_COMPONENT => Self::Depth,
            gl::STENCIL_INDEX => Self::Stencil,
            gl::DEPTH_STENCIL => Self::DepthStencil,
            _ => return None,
        })
    }

    pub(crate) fn count(self) -> usize {
        match self {
            Self::Colors(places) => places.len(),
            Self::Luminance { alpha } => 1 + usize::from(alpha),
            Self::Depth | Self::Stencil | Self::Index => 1,
            Self::DepthStencil => 2,
        }
    }

    /// Whether pixels have depths.
    pub(crate) fn has_depth(self) -> bool {
        matches!(self, Self::Depth | Self::DepthStencil)
    }
}

impl Elements {
    fn named(data_type: u32) -> Option<Self> {
        const BITS_332: &[u32] = &[3, 3, 2];
        const BITS_565: &[u32] = &[5, 6, 5];
        const BITS_4444: &[u32] = &[4, 4, 4, 4];
        const BITS_5551: &[u32] = &[5, 5, 5, 1];
        const BITS_1555: &[u32] = &[5, 5, 5, 1];
        const BITS_8888: &[u32] = &[8, 8, 8, 8];
        const BITS_1010102: &[u32] = &[10, 10, 10, 2];
        const BITS_248: &[u32] = &[24, 8];
        let packed = |bytes, bits, reversed| Self::Packed { bytes, bits, reversed };
        Some(match data_type {
            gl::BYTE => Self::Byte,
            gl::UNSIGNED_BYTE => Self::UnsignedByte,
            gl::SHORT => Self::Short,
            gl::UNSIGNED_SHORT => Self::UnsignedShort,
            gl::INT => Self::Int,
            gl::UNSIGNED_INT => Self::UnsignedInt,
            gl::FLOAT => Self::Float,
            gl::UNSIGNED_BYTE_3_3_2 => packed(1, BITS_332, false),
            gl::UNSIGNED_BYTE_2_3_3_REV => packed(1, BITS_332, true),
            gl::UNSIGNED_SHORT_5_6_5 => packed(2, BITS_565, false),
            gl::UNSIGNED_SHORT_5_6_5_REV => packed(2, BITS_565, true),
            gl::UNSIGNED_SHORT_4_4_4_4 => packed(2, BITS_4444, false),
            gl::UNSIGNED_SHORT_4_4_4_4_REV => packed(2, BITS_4444, true),
            gl::UNSIGNED_SHORT_5_5_5_1 => packed(2, BITS_5551, false),
            gl::UNSIGNED_SHORT_1_5_5_5_REV => packed(2, BITS_1555, true),
            gl::UNSIGNED_INT_8_8_8_8 => packed(4, BITS_8888, false),
            gl::UNSIGNED_INT_8_8_8_8_REV => packed(4, BITS_8888, true),
            gl::UNSIGNED_INT_10_10_10_2 => packed(4, BITS_1010102, false),
            gl::UNSIGNED_INT_2_10_10_10_REV => packed(4, BITS_1010102, true),
            gl::UNSIGNED_INT_24_8 => packed(4, BITS_248, false),
            gl::FLOAT_32_UNSIGNED_INT_24_8_REV => Self::FloatAndByte,
            _ => return None,
        })
    }

    /// Whether pixels of depth and stencil may have this type, and those alone.
    fn is_of_depth_and_stencil(self) -> bool {
        match self {
            Self::FloatAndByte => true,
            Self::Packed { bits, .. } => bits.len() == 2,
            _ => false,
        }
    }

    /// Bytes of one element.
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::Byte | Self::UnsignedByte => 1,
            Self::Short | Self::UnsignedShort => 2,
            Self::Int | Self::UnsignedInt | Self::Float | Self::FloatAndByte => 4,
            Self::Packed { bytes, .. } => bytes,
        }
    }
}

impl PixelFormat {
    /// Format and type of pixels that come from the program: also indices of colours, and bits (`GL_BITMAP`) as the bytes
    /// that they become.
    ///
    /// # Errors
    /// As of [`named`](Self::named); `GL_INVALID_ENUM` for bits that aren't indices.
    pub(crate) fn of_source(format: u32, data_type: u32) -> Result<Self, u32> {
        let indices = match format {
            gl::COLOR_INDEX => Components::Index,
            gl::STENCIL_INDEX => Components::Stencil,
            _ => return Self::named(format, data_type),
        };
        let elements = match data_type {
            gl::BITMAP => Elements::UnsignedByte,
            _ => Elements::named(data_type).ok_or(gl::INVALID_ENUM)?,
        };
        match elements {
            Elements::Packed { .. } | Elements::FloatAndByte => Err(gl::INVALID_OPERATION),
            _ => Ok(Self { components: indices, elements }),
        }
    }

    /// Format and type by their names.
    ///
    /// # Errors
    /// `GL_INVALID_ENUM` for names that aren't any, and `GL_INVALID_OPERATION` for a packed type beside a format of
    /// another number of components (table 3.8).
    pub(crate) fn named(format: u32, data_type: u32) -> Result<Self, u32> {
        if format == gl::COLOR_INDEX && Elements::named(data_type).is_some() {
            return Err(gl::INVALID_OPERATION);
        }
        let elements = Elements::named(data_type).ok_or(gl::INVALID_ENUM)?;
        let is_packed = matches!(elements, Elements::Packed { .. } | Elements::FloatAndByte);
        // A packed type beside an unknown format is a mismatch first, as in Mesa.
        let other = if is_packed { gl::INVALID_OPERATION } else { gl::INVALID_ENUM };
        let components = Components::named(format).ok_or(other)?;
        let fit = match (components, elements) {
            (Components::DepthStencil, _) => elements.is_of_depth_and_stencil(),
            // Three components only red first; of four also blue first.
            (Components::Colors(places), Elements::Packed { bits, .. }) => {
                places.len() == bits.len() && (bits.len() == 4 || places == [0, 1, 2])
            }
            _ => !is_packed,
        };
        match (fit, is_packed) {
            (true, _) => Ok(Self { components, elements }),
            (false, true) => Err(gl::INVALID_OPERATION),
            // Depth and stencil come together alone (EXT_packed_depth_stencil).
            (false, false) => Err(gl::INVALID_ENUM),
        }
    }

    /// Bytes of one pixel.
    pub(crate) fn bytes(self) -> usize {
        match self.elements {
            Elements::Packed { bytes, .. } => bytes,
            elements => elements.bytes() * self.components.count(),
        }
    }

    /// Writes components, in the order of memory, of 0 to 1 (of a stencil whole numbers), as table 4.7 converts
    /// them.
    pub(crate) fn write(self, values: &[f32], swap: bool, out: &mut [u8]) {
        let indexes = self.components == Components::Stencil;
        let width = self.elements.bytes();
        let put = |out: &mut [u8], bytes: &[u8]| {
            for (place, byte) in out.iter_mut().zip(bytes) {
                *place = *byte;
            }
            if swap {
                out.reverse();
            }
        };
        if let Elements::Packed { bits, reversed, .. } = self.elements {
            let word = packed(values, bits, reversed);
            put(out, &word.to_ne_bytes()[native_part(width)]);
            return;
        }
        if self.elements == Elements::FloatAndByte {
            let (depth, stencil) = out.split_at_mut(width.min(out.len()));
            put(depth, &values[0].to_ne_bytes());
            put(stencil, &packed(&values[1..2], &[8], true).to_ne_bytes());
            return;
        }
        for (value, out) in values.iter().zip(out.chunks_exact_mut(width)) {
            let unsigned = |steps: f64| {
                let value = f64::from(*value);
                (if indexes { value } else { value * steps + 0.5 }) as u32
            };
            let signed = |steps: f64| {
                let value = f64::from(*value);
                // Symmetric, so that 0 is 0, as for queries.
                (if indexes { value } else { (steps - 1.0) / 2.0 * value + 0.5 }).floor() as i32
            };
            match self.elements {
                Elements::Byte => put(out, &(signed(255.0) as i8).to_ne_bytes()),
                Elements::UnsignedByte => put(out, &[unsigned(255.0) as u8]),
                Elements::Short => put(out, &(signed(65535.0) as i16).to_ne_bytes()),
                Elements::UnsignedShort => put(out, &(unsigned(65535.0) as u16).to_ne_bytes()),
                Elements::Int => put(out, &signed(4_294_967_295.0).to_ne_bytes()),
                Elements::UnsignedInt => put(out, &unsigned(4_294_967_295.0).to_ne_bytes()),
                _ => put(out, &value.to_ne_bytes()),
            }
        }
    }
}

/// The bytes of a `u32` that hold a smaller word.
fn native_part(bytes: usize) -> std::ops::Range<usize> {
    if cfg!(target_endian = "little") { 0..bytes } else { 4 - bytes..4 }
}

fn packed(values: &[f32], bits: &[u32], reversed: bool) -> u32 {
    let mut word = 0_u32;
    let mut low = 0;
    let total: u32 = bits.iter().sum();
    for (value, &bits) in values.iter().zip(bits) {
        let steps = f64::from((1_u32 << bits) - 1);
        let rounded = (f64::from(*value) * steps + 0.5) as u32;
        let shift = if reversed { low } else { total - low - bits };
        word |= rounded << shift;
        low += bits;
    }
    word
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(format: u32, data_type: u32, values: &[f32]) -> Vec<u8> {
        let format = PixelFormat::named(format, data_type).unwrap();
        let mut out = vec![0; format.bytes()];
        format.write(values, false, &mut out);
        out
    }

    #[test]
    fn table_4_7_components_scale_to_the_range_of_their_type() {
        assert_eq!(bytes(gl::RED, gl::UNSIGNED_BYTE, &[1.0]), [255]);
        assert_eq!(bytes(gl::RED, gl::BYTE, &[1.0]), [127]);
        assert_eq!(bytes(gl::RED, gl::SHORT, &[1.0]), i16::MAX.to_ne_bytes());
        assert_eq!(bytes(gl::RED, gl::INT, &[1.0]), i32::MAX.to_ne_bytes());
        assert_eq!(bytes(gl::RED, gl::UNSIGNED_INT, &[1.0]), u32::MAX.to_ne_bytes());
        assert_eq!(bytes(gl::STENCIL_INDEX, gl::UNSIGNED_SHORT, &[7.0]), 7_u16.to_ne_bytes());
    }

    #[test]
    fn table_3_8_packed_pixels_have_their_first_component_highest_unless_reversed() {
        let red = [1.0, 0.0, 0.0, 0.0];
        let word = |data_type| {
            let bytes = bytes(gl::RGBA, data_type, &red);
            u32::from_ne_bytes(bytes.try_into().unwrap())
        };
        assert_eq!(word(gl::UNSIGNED_INT_8_8_8_8), 0xff00_0000);
        assert_eq!(word(gl::UNSIGNED_INT_8_8_8_8_REV), 0xff);
        assert_eq!(word(gl::UNSIGNED_INT_2_10_10_10_REV), 0x3ff);
        let short = bytes(gl::RGB, gl::UNSIGNED_SHORT_5_6_5, &red[..3]);
        assert_eq!(short, 0xf800_u16.to_ne_bytes());
        let rejected = PixelFormat::named(gl::RGB, gl::UNSIGNED_INT_8_8_8_8);
        assert_eq!(rejected, Err(gl::INVALID_OPERATION));
    }
}
