//! Pictures as files: PNG, PPM, OpenEXR and NumPy arrays, written to anything that takes bytes.
//!
//! | format | pictures | layers |
//! | --- | --- | --- |
//! | PNG | 8 or 16 bits, encoded, straight alpha | one, 16 bits, scaled ([`Legend`]) |
//! | PPM (`P6`) | 8 or 16 bits, encoded, over black | one, as in PNG |
//! | EXR | float32, linear, multiplied by alpha | any number, float32 and uint32 |
//! | NPY | uint8 as encoded, float32 linear, straight alpha | one, float32 or uint32 |

mod exr;
mod layer;
mod legend;
mod npy;
mod png;
mod ppm;
mod save;

pub use layer::LayerImage;
pub use legend::{Legend, id_color, layer_rgb8};

use luxel_lighting::PictureEncoding;
use luxel_scene::Size;
use std::io::{self, Write};
use std::str::FromStr;

/// A format for pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PictureFormat {
    /// Portable Network Graphics.
    Png,
    /// Portable pixmap, binary.
    Ppm,
    /// OpenEXR.
    Exr,
    /// An array of NumPy.
    Npy,
}

impl PictureFormat {
    /// All formats.
    pub const ALL: [Self; 4] = [Self::Png, Self::Ppm, Self::Exr, Self::Npy];

    /// The ending of such files' names.
    #[must_use]
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Ppm => "ppm",
            Self::Exr => "exr",
            Self::Npy => "npy",
        }
    }

    /// Whether it holds linear light rather than encoded bytes.
    #[must_use]
    pub const fn is_linear(self) -> bool {
        matches!(self, Self::Exr | Self::Npy)
    }
}

/// A name that is not an image format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is not an image format: use png, ppm, exr or npy")]
pub struct ParsePictureFormatError(String);

impl FromStr for PictureFormat {
    type Err = ParsePictureFormatError;

    fn from_str(extension: &str) -> Result<Self, Self::Err> {
        let wanted = extension.to_ascii_lowercase();
        let found = Self::ALL.into_iter().find(|format| format.extension() == wanted);
        found.ok_or_else(|| ParsePictureFormatError(extension.to_owned()))
    }
}

/// Why a picture can't be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The file's extension names no format.
    #[error(transparent)]
    Format(#[from] ParsePictureFormatError),
    /// Writing failed.
    #[error("writing the picture failed: {0}")]
    Io(#[from] io::Error),
    /// The values don't fill the picture, or overfill it.
    #[error("an image of {width}x{height} doesn't have {values} values")]
    Values {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// The values that were given.
        values: usize,
    },
    /// More layers than the format holds.
    #[error("{} holds one layer, not {layers}: write each to a file of its own, or all to .exr", format.extension())]
    Layers {
        /// The format.
        format: PictureFormat,
        /// The layers that were given.
        layers: usize,
    },
    /// The format holds linear light, and was given bytes.
    #[error("{} holds linear light: give it linear pixels", format.extension())]
    Bytes {
        /// The format.
        format: PictureFormat,
    },
    /// Two channels of one name, or a name that doesn't fit.
    #[error("`{0}` can't be a channel of an .exr file: rename it")]
    Channel(String),
}

/// Writes finished pixels (encoded red, green, blue; alpha) as PNG or PPM with 8 bits, or NPY.
///
/// `encoding` is how the bytes were made; PNG tells it to its readers.
///
/// # Errors
/// [`PictureError`], also where the format holds linear light only (EXR).
pub fn write_rgba8(
    format: PictureFormat,
    size: Size,
    pixels: &[[u8; 4]],
    encoding: PictureEncoding,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    check_count(size, pixels.len(), 1)?;
    match format {
        PictureFormat::Png => png::write_rgba8(size, pixels, encoding, out),
        PictureFormat::Ppm => ppm::write_rgba8(size, pixels, out),
        PictureFormat::Npy => npy::write(size, 4, npy::Values::U8(pixels.as_flattened()), out),
        PictureFormat::Exr => Err(PictureError::Bytes { format }),
    }
}

/// Writes linear pixels with straight alpha: as they are into EXR and NPY, encoded to 16 bits into
/// PNG and PPM.
///
/// # Errors
/// [`PictureError`]
pub fn write_linear(
    format: PictureFormat,
    size: Size,
    pixels: &[[f32; 4]],
    encoding: PictureEncoding,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    check_count(size, pixels.len(), 1)?;
    match format {
        PictureFormat::Png => png::write_rgba16(size, &words(pixels, encoding), encoding, out),
        PictureFormat::Ppm => ppm::write_rgba16(size, &words(pixels, encoding), out),
        PictureFormat::Npy => npy::write(size, 4, npy::Values::F32(pixels.as_flattened()), out),
        PictureFormat::Exr => exr::write_rgba(size, pixels, out),
    }
}

/// Writes layers: any number into one EXR, exactly one into the other formats.
///
/// For PNG and PPM the result tells what the 16 bits mean; the others hold the values themselves.
///
/// # Errors
/// [`PictureError`]
pub fn write_layers(
    format: PictureFormat,
    size: Size,
    layers: &[LayerImage],
    out: &mut dyn Write,
) -> Result<Option<Legend>, PictureError> {
    for layer in layers {
        check_count(size, layer.values.len(), layer.channels)?;
    }
    if format == PictureFormat::Exr {
        exr::write_layers(size, layers, out)?;
        return Ok(None);
    }
    let [layer] = layers else {
        return Err(PictureError::Layers { format, layers: layers.len() });
    };
    if format == PictureFormat::Npy {
        npy::write(size, layer.channels, npy::Values::from(&layer.values), out)?;
        return Ok(None);
    }
    let (legend, words) = legend::of(layer);
    if format == PictureFormat::Png {
        png::write_layer(size, &words, out)?;
    } else {
        ppm::write_layer(size, &words, out)?;
    }
    Ok(Some(legend))
}

/// Checks that values fill the picture.
fn check_count(size: Size, values: usize, channels: usize) -> Result<(), PictureError> {
    let wanted = u64::from(size.width) * u64::from(size.height) * channels as u64;
    if values as u64 == wanted && (1..=4).contains(&channels) {
        Ok(())
    } else {
        Err(PictureError::Values { width: size.width, height: size.height, values })
    }
}

/// Pixels that a thread encodes to 16 bits at a time, within about half a millisecond.
const ENCODED_AT_A_TIME: usize = 1 << 12;

/// Encoded to 16 bits; alpha is never encoded.
fn words(pixels: &[[f32; 4]], encoding: PictureEncoding) -> Vec<[u16; 4]> {
    let mut words = vec![[0; 4]; pixels.len()];
    luxel_parallel::fill(&mut words, ENCODED_AT_A_TIME, &|start, run| {
        for (&[r, g, b, alpha], words) in pixels[start..].iter().zip(run) {
            let alpha = PictureEncoding::None.word(alpha);
            *words = [encoding.word(r), encoding.word(g), encoding.word(b), alpha];
        }
    });
    words
}
