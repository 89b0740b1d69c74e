//! `luxel render`: an image, or its layers.

mod burnt_out;
mod path;
mod stopwatch;
mod target;

use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::options::{InputOptions, ViewOptions};
use crate::output;
use crate::progress::Progress;
use crate::surface;
use crate::view;
use clap::Args;
use luxel::lighting::{Display, PictureEncoding, Tone};
use luxel::render::{
    Edges, Execution, Layer, LayerImage, Legend, PictureError, Renderer, ShadingMode, Subdivision,
    SvgOptions, View, write_layers, write_linear, write_rgba8,
};
use luxel::report::display_to_json;
use luxel::scene::{Camera, Scene, Size};
use serde_json::{Map, Value, json};
use std::ffi::{OsStr, OsString};
use std::num::NonZeroU32;
use std::path::Path;
use std::sync::Arc;
use stopwatch::Stopwatch;
use target::{Format, Target};

/// Render an image
///
/// For example: luxel render model.glb -o picture.png --size 1920x1080
#[derive(Args, Debug)]
pub(crate) struct RenderCommand {
    #[command(flatten)]
    input: InputOptions,

    /// More models, each into a file of its own: `-o '{stem}.png'`
    #[arg(value_name = "MODEL")]
    more: Vec<OsString>,

    #[command(flatten)]
    output: OutputOptions,
    #[command(flatten)]
    view: ViewOptions,
}

#[cfg(all(test, feature = "viewer"))]
impl RenderCommand {
    pub(crate) fn frame(&self) -> &crate::options::FrameOptions {
        &self.view.frame
    }
}

/// The output files and their content.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Output")]
struct OutputOptions {
    /// The image file: .png, .exr, .ppm, .npy, or .svg for vectors; {stem} is the model's name
    /// without its extension; `-` is the standard output
    #[arg(short, long, value_name = "FILE")]
    output: OsString,

    /// The output format, regardless of the file name: png, exr, ppm, npy, svg [default for `-`:
    /// png]
    #[arg(long, value_name = "EXT")]
    output_format: Option<Format>,

    /// Bits per channel of a PNG or PPM: 8 or 16
    #[arg(long, value_name = "N", default_value = "8", value_parser = bits)]
    bits: u8,

    /// Write a layer instead of the image: depth, z, normal, position, object, triangle,
    /// barycentric, uv, ambient, diffuse, specular, emission, environment, fog, n_dot_l, openness,
    /// shadow:NAME, light:NAME; may be repeated for an EXR
    #[arg(long = "layer", value_name = "NAME")]
    layers: Vec<Layer>,

    /// Draw only the edges of polygons
    #[arg(long, conflicts_with = "edges")]
    wireframe: bool,

    /// Draw the edges of polygons on top of the faces
    #[arg(long)]
    edges: bool,

    /// Render N views around the target into numbered files: f_0.png, ... for f.png, or with
    /// three digits for f_{n:3}.png
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    turntable: Option<NonZeroU32>,

    #[command(flatten)]
    path: path::PathOptions,

    /// Print a JSON document about the work done
    #[arg(long)]
    json: bool,
}

/// What stands for the model's name in the name of an output file.
const STEM: &str = "{stem}";

fn bits(text: &str) -> Result<u8, String> {
    match text {
        "8" => Ok(8),
        "16" => Ok(16),
        _ => Err("use 8 or 16".to_owned()),
    }
}

impl OutputOptions {
    /// Whether the output is several numbered images.
    fn is_numbered(&self) -> bool {
        self.turntable.is_some() || self.path.is_given()
    }

    /// The output file of a model: its stem takes the place of `{stem}`.
    fn of_model(&self, model: &OsStr) -> OsString {
        let pattern = self.output.to_string_lossy();
        if !pattern.contains(STEM) {
            return self.output.clone();
        }
        let stem = match model.to_str().and_then(|name| name.strip_prefix("demo:")) {
            Some(name) => name.into(),
            None if model == "-" => "stdin".into(),
            None => Path::new(model).file_stem().unwrap_or_default().to_string_lossy(),
        };
        pattern.replace(STEM, &stem).into()
    }

    fn edges(&self) -> Option<Edges> {
        if self.wireframe {
            Some(Edges::WIREFRAME)
        } else {
            self.edges.then_some(Edges::OVER_FACES)
        }
    }
}

impl RenderCommand {
    /// All models, if there are several.
    pub(crate) fn several(&self) -> Option<Vec<OsString>> {
        let all = std::iter::once(&self.input.model).chain(&self.more).cloned();
        (!self.more.is_empty()).then(|| all.collect())
    }

    /// The output file of a model.
    pub(crate) fn output_of(&self, model: &OsStr) -> OsString {
        self.output.of_model(model)
    }

    /// The same command for one model only.
    pub(crate) fn with_model(mut self, model: &OsStr) -> Self {
        self.input.model = model.to_owned();
        self.more.clear();
        self
    }

    pub(crate) fn run(mut self, console: Console) -> Result<(), Failure> {
        let mut stopwatch = Stopwatch::start();
        self.output.output = self.output_of(&self.input.model);
        let target = Target::of(&self.output)?;
        check_memory(&self, &target)?;

        let mut model = model::load(&self.input, &self.view.execution, console)?;
        stopwatch.lap("read");
        if model.scene.is_empty() {
            return Err(model::nothing_to_draw(&self.input.name()));
        }
        surface::apply_material(&self.view.material, &mut model.scene);
        surface::apply_normals(&self.view.shading, &mut model.scene);
        stopwatch.lap("normals");
        let scene = &Arc::new(model.scene);
        let cameras =
            match self.output.path.cameras(&self.view.frame, &self.view.execution, scene)? {
                Some(cameras) => cameras,
                None => {
                    let frames = self.output.turntable.map_or(1, NonZeroU32::get);
                    camera::turntable(&self.view.frame, scene, frames)?
                }
            };
        stopwatch.lap("camera");
        let one_frame = cameras.len() == 1;
        let execution = Execution { one_frame, ..view::execution(&self.view.execution) };
        let renderer = Renderer::new(Arc::clone(scene), &execution)?;
        stopwatch.lap("prepare");

        let progress = Progress::new(console, cameras.len(), "pictures");
        let mut files = Vec::new();
        let mut legend = None;
        let mut subdivision = None;
        let mut vectors = None;
        let edges = self.output.edges();
        // Vectors have a tolerance in every mode.
        let mut options = self.view.clone();
        let mode = &mut options.mode;
        if target.format == Format::Svg && !matches!(mode.shading, ShadingMode::Subdivided { .. }) {
            mode.tolerance = None;
        }
        if options.picture.tone != Tone::None && target.holds_light() {
            console.notice("EXR and NPY hold light, which --tone leaves as it is");
        }
        if options.light.ground && target.format == Format::Svg {
            console.notice("a picture of vectors leaves the ground out");
        }
        if options.light.environment_background && target.format == Format::Svg {
            console.notice("a picture of vectors leaves the environment behind the model out");
        }
        let mut exposure = None;
        let mut warnings: Vec<String> = model.warnings.clone();
        for (number, &camera) in cameras.iter().enumerate() {
            let mut view = view::view(&options, edges, camera, scene)?;
            // Of several pictures, the first one decides.
            view.exposure = *exposure.get_or_insert_with(|| {
                if let Some(said) = view::expose(&mut view, &options, scene) {
                    console.notice(&said);
                }
                view.exposure
            });
            if number == 0 {
                let idle = view::idle_flags(&view, &options.light);
                idle.iter().for_each(|said| console.warn(said));
                warnings.extend(idle);
            }
            let drawn = self.draw(&renderer, &view, target.format, &mut stopwatch)?;
            if let Some(file) = target.write(number as u32, &drawn.bytes)? {
                files.push(file);
            }
            legend = drawn.legend;
            subdivision = subdivision.or(drawn.subdivision);
            vectors = vectors.or(drawn.svg);
            if drawn.may_be_burnt_out && number == 0 {
                let warning = burnt_out::warning(&renderer, &view)?;
                warning.iter().for_each(|warning| console.warn(warning));
                warnings.extend(warning);
            }
            stopwatch.lap("write");
            progress.step();
        }
        progress.finish();
        console.detail(&stopwatch.to_string());
        if let Some(subdivision) = subdivision {
            let Subdivision { triangles, largest_error, beyond, beyond_pixels } = subdivision;
            console.detail(&format!(
                "subdivided into {triangles} triangles, at most {largest_error:.2} steps of 255 from \
                 phong; {beyond} of them, {beyond_pixels:.2} pixels in all, are beyond the tolerance"
            ));
        }
        if let Some([faces, pieces, paths]) = vectors {
            console.detail(&format!(
                "{faces} faces in {pieces} pieces of uniform colour, {paths} paths"
            ));
        }
        if self.output.json {
            let mut report = self.report(&renderer, scene, &cameras[0], &files, &stopwatch);
            if let Some(subdivision) = subdivision {
                let entry = json!({
                    "triangles": subdivision.triangles,
                    "largest_error": subdivision.largest_error,
                    "beyond": subdivision.beyond,
                    "beyond_pixels": subdivision.beyond_pixels,
                });
                report.insert("subdivision".into(), entry);
            }
            if let Some([faces, pieces, paths]) = vectors {
                let entry = json!({ "faces": faces, "pieces": pieces, "paths": paths });
                report.insert("svg".into(), entry);
            }
            report.insert("warnings".into(), json!(warnings));
            let display = Display::new(exposure.unwrap_or_default(), options.picture.tone);
            report.extend(display_to_json(&display).map(|(key, value)| (key.to_owned(), value)));
            if let Some(legend) = &legend {
                let layer = &self.output.layers[0];
                report.insert("legend".into(), legend_to_json(legend, layer, scene));
            }
            output::print_json(&Value::Object(report))?;
        }
        Ok(())
    }

    /// Renders a view and encodes it.
    fn draw(
        &self,
        renderer: &Renderer,
        view: &View,
        format: Format,
        stopwatch: &mut Stopwatch,
    ) -> Result<Drawn, Failure> {
        let mut drawn = Drawn::default();
        let format = match format {
            Format::Pixels(format) => format,
            Format::Svg => {
                let defaults = SvgOptions::default();
                // Half of the memory is for pieces, half for the text of their paths.
                let pieces = self.view.execution.max_memory / 600;
                let options = SvgOptions {
                    tolerance: self.view.mode.tolerance.map_or(defaults.tolerance, |t| t as f32),
                    max_pieces: defaults
                        .max_pieces
                        .min(usize::try_from(pieces).unwrap_or(usize::MAX)),
                };
                let svg = renderer.svg(view, &options)?;
                stopwatch.lap("frame");
                drawn.svg = Some([svg.faces, svg.pieces, svg.paths]);
                drawn.bytes = svg.text.into_bytes();
                drawn.may_be_burnt_out = true;
                return Ok(drawn);
            }
        };
        let Drawn { bytes, legend, subdivision, may_be_burnt_out, .. } = &mut drawn;
        let size = view.size;
        if !self.output.layers.is_empty() {
            let values = renderer.layers(view, &self.output.layers)?;
            stopwatch.lap("frame");
            let image = |(layer, values): (&Layer, _)| LayerImage {
                name: layer.name(),
                channels: layer.channels(),
                values,
            };
            let images: Vec<_> = self.output.layers.iter().zip(values).map(image).collect();
            *legend = write_layers(format, size, &images, bytes).map_err(cannot_encode)?;
        } else if format.is_linear() || self.output.bits == 16 {
            // Of light itself, a curve for the eye would leave nothing to work with.
            let tone = if format.is_linear() { Tone::None } else { view.tone };
            let mut shown = view.clone().with_tone(tone);
            if format.is_linear() && view.ground {
                // The ground's alpha is for the bytes of sRGB unless the picture has none.
                shown.encoding = PictureEncoding::None;
            }
            let picture = renderer.linear(&shown)?;
            *may_be_burnt_out = !format.is_linear();
            stopwatch.lap("frame");
            stopwatch.add_stages(&picture.stages);
            *subdivision = picture.subdivision;
            write_linear(format, size, &picture.pixels, view.encoding, bytes)
                .map_err(cannot_encode)?;
        } else {
            let picture = renderer.rgba8(view)?;
            stopwatch.lap("frame");
            stopwatch.add_stages(&picture.stages);
            *subdivision = picture.subdivision;
            *may_be_burnt_out = burnt_out::is_suspicious(&picture.pixels);
            write_rgba8(format, size, &picture.pixels, view.encoding, bytes)
                .map_err(cannot_encode)?;
        }
        stopwatch.lap("encode");
        Ok(drawn)
    }

    fn report(
        &self,
        renderer: &Renderer,
        scene: &Scene,
        camera: &Camera,
        files: &[String],
        stopwatch: &Stopwatch,
    ) -> Map<String, Value> {
        let Size { width, height } = self.view.frame.size;
        let mut report = Map::new();
        report.insert("file".into(), json!(files.first()));
        if self.output.is_numbered() {
            report.insert("files".into(), json!(files));
        }
        report.insert("size".into(), json!([width, height]));
        report.insert("ms".into(), stopwatch.to_json());
        report.insert("triangles".into(), json!(scene.triangle_count()));
        report.insert("simd".into(), json!(luxel::math::SimdLevel::name_of(renderer.level())));
        report.insert("threads".into(), json!(renderer.threads()));
        report.insert("camera".into(), camera::to_json(camera, self.view.frame.size));
        report
    }
}

/// An encoded image.
#[derive(Default)]
struct Drawn {
    bytes: Vec<u8>,
    /// The meaning of a layer's 16-bit values.
    legend: Option<Legend>,
    /// Statistics of subdivision.
    subdivision: Option<Subdivision>,
    /// Faces, pieces and paths of vector output.
    svg: Option<[usize; 3]>,
    /// Whether it is worth a look how much of the model is burnt out.
    may_be_burnt_out: bool,
}

fn cannot_encode(error: PictureError) -> Failure {
    Failure::work(error.to_string(), "choose another format with -o")
}

/// The meaning of the numbers or colours in a layer's image.
fn legend_to_json(legend: &Legend, layer: &Layer, scene: &Scene) -> Value {
    match legend {
        Legend::Scaled(ranges) => json!({ "from_0_to_65535": ranges }),
        Legend::Colors(colors) => {
            let objects = scene.objects();
            let entry = |(id, color): &(u32, [u16; 3])| {
                let mut entry = json!({ "id": id, "color": color });
                if *layer == Layer::Object
                    && let Some(object) = objects.get(*id as usize)
                {
                    entry["name"] = json!(scene.nodes[object.node.index()].name);
                }
                entry
            };
            colors.iter().map(entry).collect()
        }
    }
}

/// Fails before allocating beyond the memory limit.
fn check_memory(command: &RenderCommand, target: &Target) -> Result<(), Failure> {
    let Size { width, height } = command.view.frame.size;
    let pixels = u64::from(width) * u64::from(height);
    // The rendered and the encoded pixels.
    let bytes_each: u64 = if !command.output.layers.is_empty() {
        command.output.layers.iter().map(|layer| 12 + 8 * layer.channels() as u64).sum()
    } else {
        match target.format {
            Format::Pixels(format) if format.is_linear() || command.output.bits == 16 => 32,
            Format::Pixels(_) => 8,
            Format::Svg => 0,
        }
    };
    let needed = pixels.saturating_mul(bytes_each);
    let limit = command.view.execution.max_memory;
    if needed <= limit {
        return Ok(());
    }
    Err(Failure::work(
        format!("an image of {width}x{height} would take {needed} bytes; the limit is {limit}"),
        "use a smaller --size, or raise the limit with --max-memory",
    ))
}
