//! Internal formats of textures (OpenGL 1.5, section 3.8.1, tables 3.15 and 3.16).

use crate::depth::DepthKind;
use crate::enums as gl;

/// Which components a texel has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BaseFormat {
    Alpha,
    Luminance,
    LuminanceAlpha,
    Intensity,
    Rgb,
    Rgba,
    Depth,
}

/// How a component is kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Storage {
    /// 8 bits.
    Bytes,
    /// 16 bits.
    Words,
    /// Depth: 16 or 24 bits, or floats of 32.
    Depth(u32),
}

/// An internal format: components and their storage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InternalFormat {
    pub(crate) base: BaseFormat,
    pub(crate) storage: Storage,
    /// Whether red, green and blue follow the curve of sRGB.
    pub(crate) srgb: bool,
    /// Whether there are 8 bits of stencil beside a depth.
    pub(crate) stencil: bool,
}

/// Whether a name is that of a generic compressed format.
pub(crate) fn is_compressed(name: u32) -> bool {
    matches!(
        name,
        gl::COMPRESSED_ALPHA..=gl::COMPRESSED_RGBA
            | gl::COMPRESSED_SRGB..=gl::COMPRESSED_SLUMINANCE_ALPHA
    )
}

impl BaseFormat {
    /// The name of a format that has these components in no particular form.
    fn name(self) -> u32 {
        match self {
            Self::Alpha => gl::ALPHA,
            Self::Luminance => gl::LUMINANCE,
            Self::LuminanceAlpha => gl::LUMINANCE_ALPHA,
            Self::Intensity => gl::INTENSITY,
            Self::Rgb => gl::RGB,
            Self::Rgba => gl::RGBA,
            Self::Depth => gl::DEPTH_COMPONENT,
        }
    }

    /// Which of red, green, blue and alpha a pixel of that format has, where colours are drawn to: luminances and
    /// intensities are red (ARB_framebuffer_object, table 3.15).
    pub(crate) fn present(self) -> [bool; 4] {
        match self {
            Self::Alpha => [false, false, false, true],
            Self::Luminance | Self::Intensity | Self::Depth => [true, false, false, false],
            Self::LuminanceAlpha => [true, false, false, true],
            Self::Rgb => [true, true, true, false],
            Self::Rgba => [true; 4],
        }
    }

    /// A texel in its canonical form as section 6.1.4 returns it (table 6.1): what isn't there is 0, alpha 1.
    pub(crate) fn returned<T: Copy>(self, texel: [T; 4], zero: T, one: T) -> [T; 4] {
        let (present, missing) = (self.present(), [zero, zero, zero, one]);
        std::array::from_fn(|at| if present[at] { texel[at] } else { missing[at] })
    }
}

impl InternalFormat {
    /// The format of a name, or of a number of components from 1 to 4; `None` for other values. A format of fewer bits
    /// is kept in bytes, generic compressed ones without compression.
    pub(crate) fn named(name: u32) -> Option<Self> {
        use BaseFormat::{Alpha, Depth, Intensity, Luminance, LuminanceAlpha, Rgb, Rgba};
        let of = |base, storage| Some(Self { base, storage, srgb: false, stencil: false });
        let bytes = |base| of(base, Storage::Bytes);
        let words = |base| of(base, Storage::Words);
        let depth = |bits| of(Depth, Storage::Depth(bits));
        let with_stencil = |bits| depth(bits).map(|of| Self { stencil: true, ..of });
        let srgb = |base| Some(Self { base, storage: Storage::Bytes, srgb: true, stencil: false });
        match name {
            1 | gl::LUMINANCE | gl::LUMINANCE4 | gl::LUMINANCE8 | gl::COMPRESSED_LUMINANCE => {
                bytes(Luminance)
            }
            2
            | gl::LUMINANCE_ALPHA
            | gl::LUMINANCE4_ALPHA4
            | gl::LUMINANCE6_ALPHA2
            | gl::LUMINANCE8_ALPHA8
            | gl::COMPRESSED_LUMINANCE_ALPHA => bytes(LuminanceAlpha),
            3 | gl::RGB | gl::R3_G3_B2 | gl::RGB4 | gl::RGB5 | gl::RGB8 | gl::COMPRESSED_RGB => {
                bytes(Rgb)
            }
            4
            | gl::RGBA
            | gl::RGBA2
            | gl::RGBA4
            | gl::RGB5_A1
            | gl::RGBA8
            | gl::COMPRESSED_RGBA => bytes(Rgba),
            gl::ALPHA | gl::ALPHA4 | gl::ALPHA8 | gl::COMPRESSED_ALPHA => bytes(Alpha),
            gl::INTENSITY | gl::INTENSITY4 | gl::INTENSITY8 | gl::COMPRESSED_INTENSITY => {
                bytes(Intensity)
            }
            gl::ALPHA12 | gl::ALPHA16 => words(Alpha),
            gl::LUMINANCE12 | gl::LUMINANCE16 => words(Luminance),
            gl::LUMINANCE12_ALPHA4 | gl::LUMINANCE12_ALPHA12 | gl::LUMINANCE16_ALPHA16 => {
                words(LuminanceAlpha)
            }
            gl::INTENSITY12 | gl::INTENSITY16 => words(Intensity),
            gl::RGB10 | gl::RGB12 | gl::RGB16 => words(Rgb),
            gl::RGB10_A2 | gl::RGBA12 | gl::RGBA16 => words(Rgba),
            gl::DEPTH_COMPONENT | gl::DEPTH_COMPONENT24 | gl::DEPTH_COMPONENT32 => depth(24),
            gl::DEPTH_COMPONENT16 => depth(16),
            gl::DEPTH_COMPONENT32F => depth(32),
            gl::DEPTH_STENCIL | gl::DEPTH24_STENCIL8 => with_stencil(24),
            gl::DEPTH32F_STENCIL8 => with_stencil(32),
            gl::SRGB | gl::SRGB8 | gl::COMPRESSED_SRGB => srgb(Rgb),
            gl::SRGB_ALPHA | gl::SRGB8_ALPHA8 | gl::COMPRESSED_SRGB_ALPHA => srgb(Rgba),
            gl::SLUMINANCE | gl::SLUMINANCE8 | gl::COMPRESSED_SLUMINANCE => srgb(Luminance),
            gl::SLUMINANCE_ALPHA | gl::SLUMINANCE8_ALPHA8 | gl::COMPRESSED_SLUMINANCE_ALPHA => {
                srgb(LuminanceAlpha)
            }
            _ => None,
        }
    }

    /// The name that queries return for an image of that name: of generic compressed ones, which aren't compressed, that
    /// of their components (section 3.8.1).
    pub(crate) fn queried(self, name: u32) -> u32 {
        if is_compressed(name) { self.base.name() } else { name }
    }

    /// Red, green, blue, alpha as the components that the base format has (table 3.15), in the form in which textures are
    /// sources of environments: what a format lacks is 0 in colour and 1 in alpha (table 3.23).
    pub(crate) fn canonical<T: Copy>(self, [r, g, b, a]: [T; 4], zero: T, one: T) -> [T; 4] {
        match self.base {
            BaseFormat::Alpha => [zero, zero, zero, a],
            BaseFormat::Luminance => [r, r, r, one],
            BaseFormat::LuminanceAlpha => [r, r, r, a],
            BaseFormat::Intensity | BaseFormat::Depth => [r; 4],
            BaseFormat::Rgb => [r, g, b, one],
            BaseFormat::Rgba => [r, g, b, a],
        }
    }

    /// How depths are kept.
    pub(crate) fn depth_kind(self) -> DepthKind {
        match self.storage {
            Storage::Depth(32) => DepthKind::Floats,
            _ => DepthKind::Steps,
        }
    }

    /// Bits of red, green, blue, alpha, luminance, intensity, depth.
    pub(crate) fn component_bits(self) -> [u32; 7] {
        let bits = match self.storage {
            Storage::Bytes => 8,
            Storage::Words => 16,
            Storage::Depth(bits) => bits,
        };
        let has = match self.base {
            BaseFormat::Alpha => [0, 0, 0, 1, 0, 0, 0],
            BaseFormat::Luminance => [0, 0, 0, 0, 1, 0, 0],
            BaseFormat::LuminanceAlpha => [0, 0, 0, 1, 1, 0, 0],
            BaseFormat::Intensity => [0, 0, 0, 0, 0, 1, 0],
            BaseFormat::Rgb => [1, 1, 1, 0, 0, 0, 0],
            BaseFormat::Rgba => [1, 1, 1, 1, 0, 0, 0],
            BaseFormat::Depth => [0, 0, 0, 0, 0, 0, 1],
        };
        has.map(|has| has * bits)
    }

    /// Whether texels are depths.
    pub(crate) fn is_depth(self) -> bool {
        self.base == BaseFormat::Depth
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_3_8_1_formats_that_are_lacking_in_a_component_have_the_default_of_table_3_23() {
        let texel = [0.1, 0.2, 0.3, 0.4];
        let canonical = |name| InternalFormat::named(name).unwrap().canonical(texel, 0.0, 1.0);
        assert_eq!(canonical(gl::ALPHA8), [0.0, 0.0, 0.0, 0.4]);
        assert_eq!(canonical(1), [0.1, 0.1, 0.1, 1.0]);
        assert_eq!(canonical(2), [0.1, 0.1, 0.1, 0.4]);
        assert_eq!(canonical(gl::INTENSITY), [0.1; 4]);
        assert_eq!(canonical(3), [0.1, 0.2, 0.3, 1.0]);
        assert_eq!(canonical(4), texel);
        assert_eq!(InternalFormat::named(5), None);
        assert_eq!(InternalFormat::named(gl::BGRA), None);
    }
}
