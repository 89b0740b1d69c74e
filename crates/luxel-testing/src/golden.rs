//! Golden pictures: PNG files that pictures must equal to the byte.

use crate::blessing;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

/// Pixels of 8 bits a channel, row by row from the upper left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Pixels in a row.
    pub width: u32,
    /// Red, green, blue and alpha of each.
    pub rgba: Vec<[u8; 4]>,
}

impl Pixels {
    /// The pixels of a PNG; of an animated one, its pictures one below the other.
    ///
    /// # Errors
    /// A message if the file is damaged.
    pub fn of_png(bytes: &[u8]) -> Result<Self, String> {
        Self::decode(bytes).map_err(|error| error.to_string())
    }

    fn decode(bytes: &[u8]) -> Result<Self, png::DecodingError> {
        let mut decoder = png::Decoder::new(Cursor::new(bytes));
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder.read_info()?;
        let pictures = reader.info().animation_control().map_or(1, |control| control.num_frames);
        let mut pixels = Self { width: reader.info().width, rgba: Vec::new() };
        let mut picture = vec![0; reader.output_buffer_size().unwrap_or_default()];
        for _ in 0..pictures {
            let info = reader.next_frame(&mut picture)?;
            let channels = info.color_type.samples();
            pixels.rgba.extend(picture[..info.buffer_size()].chunks_exact(channels).map(|pixel| {
                match *pixel {
                    [grey] => [grey, grey, grey, 255],
                    [grey, alpha] => [grey, grey, grey, alpha],
                    [r, g, b] => [r, g, b, 255],
                    _ => [pixel[0], pixel[1], pixel[2], pixel[3]],
                }
            }));
        }
        Ok(pixels)
    }

    /// A PNG of these pixels, as small as it gets.
    ///
    /// # Panics
    /// If the pixels don't fill their rows.
    #[must_use]
    pub fn to_png(&self) -> Vec<u8> {
        let mut file = Vec::new();
        let height = (self.rgba.len() / self.width.max(1) as usize) as u32;
        let mut encoder = png::Encoder::new(&mut file, self.width, height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(png::Filter::Adaptive);
        let written = encoder
            .write_header()
            .and_then(|mut writer| writer.write_image_data(self.rgba.as_flattened()));
        assert!(written.is_ok(), "{}x{height} pixels: {written:?}", self.width);
        file
    }

    /// Black where both agree, else bright by how much they differ: from 64, so that one step is seen.
    fn difference(&self, other: &Self) -> Self {
        let of = |(a, b): (&[u8; 4], &[u8; 4])| {
            let [r, g, b, alpha] = std::array::from_fn(|channel| a[channel].abs_diff(b[channel]));
            let shown = |steps: u8| match steps.max(alpha) {
                0 => 0,
                steps => 64 + (u16::from(steps) * 191 / 255) as u8,
            };
            [shown(r), shown(g), shown(b), 255]
        };
        Self { width: self.width, rgba: self.rgba.iter().zip(&other.rgba).map(of).collect() }
    }
}

/// Compares pictures with the PNG files of a folder.
#[derive(Debug)]
pub struct Golden {
    folder: PathBuf,
    output: PathBuf,
    faults: Vec<String>,
}

impl Golden {
    /// Pictures in `folder`; what differs is written to `output`, below `CARGO_TARGET_TMPDIR`.
    #[must_use]
    pub fn new(folder: &Path, output: &Path) -> Self {
        Self { folder: folder.to_owned(), output: output.to_owned(), faults: Vec::new() }
    }

    /// Compares a picture with `NAME.png`, or writes that file if `LUXEL_BLESS` is set.
    ///
    /// # Panics
    /// If a file can't be written.
    pub fn compare(&mut self, name: &str, actual: &Pixels) {
        let path = self.folder.join(name).with_extension("png");
        let expected = fs::read(&path)
            .map_err(|error| error.to_string())
            .and_then(|bytes| Pixels::of_png(&bytes));
        if expected.as_ref() == Ok(actual) {
            return;
        }
        if blessing::is_blessing() {
            write(&path, actual);
            return;
        }
        let output = |kind: &str| self.output.join(format!("{name}-{kind}.png"));
        write(&output("actual"), actual);
        let fault = match expected {
            Err(error) => format!("no golden picture to compare with: {error}"),
            Ok(expected) => {
                write(&output("expected"), &expected);
                if (expected.width, expected.rgba.len()) == (actual.width, actual.rgba.len()) {
                    write(&output("difference"), &expected.difference(actual));
                    let pairs = expected.rgba.iter().zip(&actual.rgba);
                    let changed = pairs.filter(|(a, b)| a != b).count();
                    format!("{changed} of {} pixels differ", actual.rgba.len())
                } else {
                    "another size".to_owned()
                }
            }
        };
        let stem = self.output.join(name);
        self.faults.push(format!(
            "{}: {fault}; see {}-{{expected,actual,difference}}.png",
            path.display(),
            stem.display()
        ));
    }

    /// Ends the comparison.
    ///
    /// # Panics
    /// If a picture differs from its file, or `LUXEL_BLESS` is set.
    #[track_caller]
    pub fn finish(self) {
        if blessing::is_blessing() {
            blessing::fail(&self.folder);
        }
        let advice = "LUXEL_BLESS=1 writes the golden pictures anew, if they are meant to change";
        assert!(self.faults.is_empty(), "{}\n{advice}", self.faults.join("\n"));
    }
}

fn write(path: &Path, pixels: &Pixels) {
    let folder = path.parent().map_or(Ok(()), fs::create_dir_all);
    let written = folder.and_then(|()| fs::write(path, pixels.to_png()));
    assert!(written.is_ok(), "{} can't be written: {written:?}", path.display());
}

#[cfg(test)]
mod tests {
    use super::{Golden, Pixels, write};
    use std::fs;

    fn two(last: u8) -> Pixels {
        Pixels { width: 1, rgba: vec![[1, 2, 3, 255], [9, 8, last, 0]] }
    }

    #[test]
    fn a_png_has_the_pixels_that_were_written() {
        assert_eq!(Pixels::of_png(&two(7).to_png()), Ok(two(7)));
    }

    #[test]
    fn a_picture_that_differs_leaves_three_files_and_fails() {
        let folder = std::env::temp_dir().join(format!("luxel-golden-{}", std::process::id()));
        write(&folder.join("same.png"), &two(7));
        write(&folder.join("other.png"), &two(7));
        let mut golden = Golden::new(&folder, &folder.join("out"));
        golden.compare("same", &two(7));
        assert!(golden.faults.is_empty());
        golden.compare("other", &two(6));
        golden.compare("missing", &two(6));
        assert_eq!(golden.faults.len(), 2);
        assert!(golden.faults[0].contains("1 of 2 pixels differ"), "{:?}", golden.faults);
        let written = |kind: &str| {
            let bytes = fs::read(folder.join(format!("out/other-{kind}.png"))).unwrap_or_default();
            Pixels::of_png(&bytes)
        };
        assert_eq!(written("expected"), Ok(two(7)));
        assert_eq!(written("actual"), Ok(two(6)));
        let shown = Pixels { width: 1, rgba: vec![[0, 0, 0, 255], [0, 0, 64, 255]] };
        assert_eq!(written("difference"), Ok(shown));
        assert!(std::panic::catch_unwind(|| golden.finish()).is_err());
        assert!(fs::remove_dir_all(&folder).is_ok());
    }
}
