//! Reads pictures of the light all around: Radiance `.hdr` and OpenEXR `.exr`.
//!
//! Our own readers: the library for OpenEXR is half a megabyte of code, and that for Radiance fills what a file lacks
//! with black.

mod bytes;
#[cfg(feature = "exr")]
mod exr;
#[cfg(feature = "hdr")]
mod hdr;

#[cfg(not(all(feature = "exr", feature = "hdr")))]
use crate::error::missing_feature;
use crate::{Error, ErrorKind, Limits, Place, Warning, files};
use luxel_lighting::{EnvironmentMap, EquirectangularImage};
use std::path::Path;

/// An environment, as it was read.
#[derive(Debug)]
pub struct LoadedEnvironment {
    /// The light.
    pub map: EnvironmentMap,
    /// What is odd about the file.
    pub warnings: Vec<Warning>,
}

/// Extensions of pictures of environments.
const EXTENSIONS: [&str; 2] = ["hdr", "exr"];

/// Whether a file is a picture of an environment, by its extension.
#[must_use]
pub fn is_environment(path: &Path) -> bool {
    let extension = path.extension().unwrap_or_default();
    EXTENSIONS.iter().any(|known| extension.eq_ignore_ascii_case(known))
}

/// Reads a picture of an environment, a regular file. Its path is the map's name.
///
/// # Errors
/// [`Error`] with file and place, if the file can't be read, is damaged or exceeds the limits.
pub fn open_environment(path: &Path, limits: &Limits) -> Result<LoadedEnvironment, Error> {
    let in_file = |error: Error| error.in_file(path);
    if !files::checked(path, limits)?.is_regular {
        // A pipe could block for ever.
        let message = "this is not a regular file".to_owned();
        return Err(in_file(Error::at(Place::File, ErrorKind::Unsupported(message))));
    }
    let bytes = files::read_file(path, limits)?;
    read_environment(&bytes, &path.to_string_lossy(), limits).map_err(in_file)
}

/// Reads a picture of an environment from bytes; the first ones decide its format. `name` is the map's.
///
/// # Errors
/// [`Error`] with its place, if the bytes are damaged or exceed the limits.
pub fn read_environment(
    bytes: &[u8],
    name: &str,
    limits: &Limits,
) -> Result<LoadedEnvironment, Error> {
    let (image, warnings) = decode_environment(bytes, limits)?;
    Ok(LoadedEnvironment { map: EnvironmentMap::new(name, image), warnings })
}

/// Reads a picture of an environment without preparing it for lookups.
///
/// # Errors
/// [`Error`] with its place, if the bytes are damaged or exceed the limits.
pub fn decode_environment(
    bytes: &[u8],
    limits: &Limits,
) -> Result<(EquirectangularImage, Vec<Warning>), Error> {
    let mut image = decode(bytes, limits)?;
    let warnings = check_light(&mut image)?;
    Ok((image, warnings))
}

fn decode(bytes: &[u8], limits: &Limits) -> Result<EquirectangularImage, Error> {
    if bytes.starts_with(b"#?") {
        hdr(bytes, limits)
    } else if bytes.starts_with(&[0x76, 0x2f, 0x31, 0x01]) {
        exr(bytes, limits)
    } else if bytes.is_empty() {
        Err(malformed(0, "the file is empty"))
    } else {
        Err(malformed(0, "the file is neither Radiance (.hdr) nor OpenEXR (.exr)"))
    }
}

#[cfg(feature = "hdr")]
use self::hdr::decode as hdr;

#[cfg(not(feature = "hdr"))]
fn hdr(_: &[u8], _: &Limits) -> Result<EquirectangularImage, Error> {
    Err(Error::at(Place::File, missing_feature("Radiance pictures", "hdr")))
}

#[cfg(feature = "exr")]
use self::exr::decode as exr;

#[cfg(not(feature = "exr"))]
fn exr(_: &[u8], _: &Limits) -> Result<EquirectangularImage, Error> {
    Err(Error::at(Place::File, missing_feature("OpenEXR pictures", "exr")))
}

fn malformed(byte: usize, message: impl Into<String>) -> Error {
    Error::at(Place::Byte(byte as u64), ErrorKind::Malformed(message.into()))
}

/// Checks the size that a file declares before anything is allocated. With fewer than `bytes_needed` bytes
/// it can't hold so many texels.
#[cfg_attr(
    not(any(feature = "exr", feature = "hdr")),
    allow(dead_code, reason = "this build has no decoder")
)]
fn check_size(
    [width, height]: [u32; 2],
    byte: usize,
    (bytes, bytes_needed): (&[u8], u64),
    limits: &Limits,
) -> Result<(), Error> {
    if width == 0 || height == 0 {
        return Err(malformed(byte, format!("the picture declares {width}x{height} texels")));
    }
    let place = Place::Byte(byte as u64);
    let needed = EnvironmentMap::bytes_needed(width, height);
    limits.check(&format!("an environment of {width}x{height}"), needed, 1, place.clone())?;
    if bytes_needed > bytes.len() as u64 {
        let length = bytes.len();
        let message =
            format!("the picture declares {width}x{height} texels, but has only {length} bytes");
        return Err(Error::at(place, ErrorKind::Malformed(message)));
    }
    Ok(())
}

/// Light is finite and not negative. Pictures that were resampled or graded dip below 0 here and there:
/// these values become 0.
fn check_light(image: &mut EquirectangularImage) -> Result<Vec<Warning>, Error> {
    let width = image.width.max(1) as usize;
    let mut negative = 0_u64;
    let mut first = None;
    for (at, light) in image.light.iter_mut().enumerate() {
        let [r, g, b] = *light;
        if !(r.is_finite() && g.is_finite() && b.is_finite()) {
            let (column, row) = (at % width, at / width);
            let message = format!(
                "the texel in column {column}, row {row} (from 0, from the upper left) is not finite: \
                 {r}, {g}, {b}"
            );
            return Err(Error::at(Place::File, ErrorKind::Malformed(message)));
        }
        if r < 0.0 || g < 0.0 || b < 0.0 {
            negative += 1;
            first.get_or_insert((at % width, at / width));
            *light = light.map(|channel| channel.max(0.0));
        }
    }
    let warning = first.map(|(column, row)| {
        let texels = if negative == 1 { "texel has" } else { "texels have" };
        Warning::from(format!(
            "{negative} {texels} negative light, which counts as 0: the first in column {column}, row {row}"
        ))
    });
    Ok(warning.into_iter().collect())
}

#[cfg(test)]
mod tests;
