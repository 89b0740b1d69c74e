//! The destination and format of images.

use super::OutputOptions;
use crate::drawing::Format;
use crate::failure::Failure;
use crate::output;
use crate::values::Numbering;
use luxel::render::{Layer, PictureFormat};
use std::path::{Path, PathBuf};

/// The destination and format of images.
#[derive(Debug)]
pub(super) struct Target {
    pub(super) format: Format,
    place: Place,
}

#[derive(Debug)]
enum Place {
    StandardOutput,
    File(PathBuf),
    Files(Numbering),
}

impl Target {
    /// Whether pixels are light rather than what a picture shows of it.
    pub(super) fn holds_light(&self) -> bool {
        matches!(self.format, Format::Pixels(format) if format.is_linear())
    }

    /// Checks the flags before any work.
    pub(super) fn of(options: &OutputOptions) -> Result<Self, Failure> {
        let usage = |message: &str| Err(Failure::Usage(message.to_owned()));
        let to_standard_output = options.output == "-";
        if to_standard_output && options.json {
            return usage("--json and `-o -` would both write to the standard output: use a file");
        }
        let layers = &options.layers;
        for (number, layer) in layers.iter().enumerate() {
            if layers[..number].contains(layer) {
                let also = if *layer == Layer::Openness { " (`ao` is the same)" } else { "" };
                let name = layer.name();
                return usage(&format!("the layer `{name}` is given twice{also}"));
            }
        }
        let format = format(options)?;
        match format {
            Format::Pixels(format) => {
                if options.bits == 16 && format.is_linear() {
                    return usage("--bits is for PNG and PPM: EXR and NPY have 32 bits");
                }
                if options.layers.len() > 1 && format != PictureFormat::Exr {
                    return usage(
                        "only EXR supports several layers: use -o FILE.exr, or a single --layer",
                    );
                }
            }
            Format::Svg => {
                if options.bits == 16 {
                    return usage("--bits is for PNG and PPM: SVG colours have 8 bits");
                }
                if !options.layers.is_empty() {
                    return usage("layers need a pixel format: use .exr, .png, .ppm or .npy");
                }
                if options.wireframe || options.edges {
                    return usage("SVG output has no edges: remove --wireframe or --edges");
                }
            }
        }
        let place = match options.is_numbered() {
            true if to_standard_output => {
                return usage("several images need numbered files: use -o f.png, or f_{n:3}.png");
            }
            true => {
                let numbering =
                    Numbering::parse(&options.output.to_string_lossy()).map_err(|message| {
                        Failure::Usage(format!("invalid value for '--output': {message}"))
                    })?;
                output::check_folder(&numbering.name(0), "-o")?;
                Place::Files(numbering)
            }
            false if to_standard_output => Place::StandardOutput,
            false => {
                let path = PathBuf::from(&options.output);
                output::check_folder(&path, "-o")?;
                Place::File(path)
            }
        };
        Ok(Self { format, place })
    }

    /// Checks the flags of several models before any work, but for what depends on the model.
    pub(super) fn check(options: &OutputOptions) -> Result<(), Failure> {
        match Self::of(options) {
            Err(Failure::Usage(message)) => Err(Failure::Usage(message)),
            _ => Ok(()),
        }
    }

    /// Writes an image and returns its file name.
    pub(super) fn write(&self, number: u32, bytes: &[u8]) -> Result<Option<String>, Failure> {
        let path = match &self.place {
            Place::StandardOutput => {
                output::print_file(bytes)?;
                return Ok(None);
            }
            Place::File(path) => path.clone(),
            Place::Files(numbering) => numbering.name(number),
        };
        output::write_file(&path, bytes)?;
        Ok(Some(path.to_string_lossy().into_owned()))
    }
}

fn format(options: &OutputOptions) -> Result<Format, Failure> {
    if let Some(format) = options.output_format {
        return Ok(format);
    }
    if options.output == "-" {
        return Ok(Format::Pixels(PictureFormat::Png));
    }
    let extension = Path::new(&options.output).extension().unwrap_or_default().to_string_lossy();
    if extension.is_empty() {
        let message =
            "--output needs an extension: .png, .exr, .ppm, .npy or .svg (or --output-format)";
        return Err(Failure::Usage(message.to_owned()));
    }
    extension.parse().map_err(|error: String| {
        let name = options.output.to_string_lossy();
        Failure::Usage(format!("invalid value '{name}' for '--output': {error}"))
    })
}
