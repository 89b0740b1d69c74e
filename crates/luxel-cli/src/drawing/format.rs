//! The kind of a file with a picture.

use luxel::render::{ParsePictureFormatError, PictureFormat};

/// The kind of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    /// Pixels.
    Pixels(PictureFormat),
    /// Vectors.
    Svg,
}

impl std::str::FromStr for Format {
    type Err = String;

    fn from_str(extension: &str) -> Result<Self, Self::Err> {
        if extension.eq_ignore_ascii_case("svg") {
            return Ok(Self::Svg);
        }
        extension.parse().map(Self::Pixels).map_err(|_: ParsePictureFormatError| {
            format!("`{extension}` is not an image format: use png, exr, ppm, npy or svg")
        })
    }
}
