//! Screenshots.

use crate::options::WriteFile;
use luxel::lighting::PictureEncoding;
use luxel::render::{PictureFormat, write_rgba8};
use luxel::scene::Size;
use std::path::PathBuf;

/// Opaque RGBA of 0RGB pixels.
pub(crate) fn rgba_of(pixels: &[u32]) -> Vec<[u8; 4]> {
    let opaque = |pixel: &u32| {
        let [_, r, g, b] = pixel.to_be_bytes();
        [r, g, b, 255]
    };
    pixels.iter().map(opaque).collect()
}

/// Writes a picture to the first free file `STEM-N.png`; returns a notice for the user, or an error.
pub(crate) fn save_png(
    stem: &str,
    rgba: &[[u8; 4]],
    size: Size,
    encoding: PictureEncoding,
    write: &WriteFile,
) -> Result<String, String> {
    let mut bytes = Vec::new();
    write_rgba8(PictureFormat::Png, size, rgba, encoding, &mut bytes)
        .map_err(|error| error.to_string())?;
    let name = |number: u32| PathBuf::from(format!("{stem}-{number}.png"));
    let free = (1..).map(name).find(|path| !path.exists());
    let path = free.ok_or("no name is free for a picture")?;
    write(&path, &bytes)?;
    Ok(format!("{} written", path.display()))
}
