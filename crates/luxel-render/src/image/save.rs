//! Pictures to files by name, whole or not at all.

use super::{PictureError, PictureFormat, write_linear, write_rgba8};
use crate::frame::Picture;
use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

impl Picture<[u8; 4]> {
    /// The pixels as bytes: red, green, blue and alpha of each, row by row from the top.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// Writes a file; the extension of its name selects the [format](PictureFormat). A file of that name
    /// is replaced once the new one is whole.
    ///
    /// ```no_run
    /// # fn save(picture: &luxel_render::Picture<[u8; 4]>) -> Result<(), luxel_render::PictureError> {
    /// picture.save("teapot.png")
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`PictureError`] for an unknown extension, for EXR, which holds [linear
    /// light](crate::Renderer::linear), and if writing fails.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), PictureError> {
        replace(path.as_ref(), &|format, out| {
            write_rgba8(format, self.size, &self.pixels, self.encoding, out)
        })
    }
}

impl Picture<[f32; 4]> {
    /// Writes a file; the extension of its name selects the [format](PictureFormat): linear light for EXR
    /// and NPY, 16 encoded bits for PNG and PPM. A file of that name is replaced once the new one is whole.
    ///
    /// # Errors
    /// [`PictureError`] for an unknown extension, and if writing fails.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), PictureError> {
        replace(path.as_ref(), &|format, out| {
            write_linear(format, self.size, &self.pixels, self.encoding, out)
        })
    }
}

/// Writes beside the file first.
fn replace(
    path: &Path,
    write: &dyn Fn(PictureFormat, &mut dyn Write) -> Result<(), PictureError>,
) -> Result<(), PictureError> {
    let extension = path.extension().and_then(OsStr::to_str).unwrap_or_default();
    let format = extension.parse()?;
    let mut name = path.file_name().map(OsStr::to_owned).unwrap_or_default();
    name.push(".part");
    let part = path.with_file_name(name);
    let whole = (|| {
        let mut out = BufWriter::new(File::create(&part)?);
        write(format, &mut out)?;
        out.into_inner().map_err(io::IntoInnerError::into_error)?;
        Ok(fs::rename(&part, path)?)
    })();
    if whole.is_err() {
        // Whatever went wrong is the error to tell, not that its rest can't be removed.
        let _ = fs::remove_file(&part);
    }
    whole
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::Size;

    fn picture() -> Picture<[u8; 4]> {
        let size = Size { width: 2, height: 1 };
        Picture { size, pixels: vec![[1, 2, 3, 4], [5, 6, 7, 8]], ..Picture::default() }
    }

    #[test]
    fn a_saved_picture_is_the_one_that_is_written_and_leaves_no_part() {
        let folder = std::env::temp_dir().join(format!("luxel-save-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("picture.ppm");
        picture().save(&path).unwrap();
        let mut expected = Vec::new();
        let Picture { size, pixels, encoding, .. } = picture();
        write_rgba8(PictureFormat::Ppm, size, &pixels, encoding, &mut expected).unwrap();
        assert_eq!(fs::read(&path).unwrap(), expected);

        // What fails leaves the old file as it was.
        let values = picture().pixels[..1].to_vec();
        let damaged = Picture { pixels: values, ..picture() };
        assert!(matches!(damaged.save(&path), Err(PictureError::Values { .. })));
        assert_eq!(fs::read(&path).unwrap(), expected);
        assert!(matches!(picture().save(folder.join("a.gif")), Err(PictureError::Format(_))));
        assert!(matches!(picture().save(folder.join("a.exr")), Err(PictureError::Bytes { .. })));
        let names: Vec<_> =
            fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(names, ["picture.ppm"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn bytes_are_the_channels_of_pixels_in_order() {
        assert_eq!(picture().as_bytes(), [1, 2, 3, 4, 5, 6, 7, 8]);
    }
}
