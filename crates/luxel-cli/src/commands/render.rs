//! `luxel render`: an image, or its layers.

mod path;
mod target;

use crate::camera;
use crate::console::Console;
use crate::drawing::{self, Content, Format, Stopwatch, VectorOptions, burnt_out};
use crate::failure::Failure;
use crate::model;
use crate::options::{InputOptions, ViewOptions};
use crate::output;
use crate::progress::Progress;
use crate::surface;
use crate::view;
use clap::Args;
use luxel::formats::Format as InputFormat;
use luxel::lighting::{Display, Tone};
use luxel::render::{Edges, Execution, Layer, Legend, Renderer, ShadingMode, Subdivision};
use luxel::report::display_to_json;
use luxel::scene::{Camera, Scene, Size};
use serde_json::{Map, Value, json};
use std::ffi::{OsStr, OsString};
use std::num::NonZeroU32;
use std::path::Path;
use std::sync::Arc;
use target::Target;

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
    /// barycentric, uv, ambient, diffuse, specular, emission, environment, fog, n_dot_l, openness (or
    /// ao), shadow:NAME, light:NAME; may be repeated for an EXR
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

/// What a line says of a picture, apart from where it is written.
#[derive(Clone, Debug)]
pub(crate) struct PictureSettings {
    /// The model's format, regardless of its name.
    pub(crate) format: Option<InputFormat>,
    /// The view.
    pub(crate) view: ViewOptions,
    /// The edges of polygons that are drawn.
    pub(crate) edges: Option<Edges>,
    /// Bits per channel of a PNG or PPM.
    pub(crate) bits: u8,
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

    /// Checks the flags of the output before any work.
    ///
    /// # Errors
    /// [`Failure::Usage`]
    pub(crate) fn check_output(&self) -> Result<(), Failure> {
        Target::check(&self.output)
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

    /// What the line says of the picture, apart from where it is written.
    pub(crate) fn into_settings(self) -> PictureSettings {
        let Self { input, output, view, .. } = self;
        PictureSettings { format: input.format, edges: output.edges(), bits: output.bits, view }
    }

    pub(crate) fn run(mut self, console: Console) -> Result<(), Failure> {
        let mut stopwatch = Stopwatch::start();
        self.output.output = self.output_of(&self.input.model);
        let target = Target::of(&self.output)?;
        let content = Content {
            layers: self.output.layers.clone(),
            bits: self.output.bits,
            format: target.format,
        };
        let max_memory = self.view.execution.max_memory;
        drawing::check_memory(self.view.frame.size, std::slice::from_ref(&content), max_memory)?;

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
        let vector_options = VectorOptions { tolerance: self.view.mode.tolerance, max_memory };
        let mut exposure = None;
        let mut warnings: Vec<String> = model.warnings.clone();
        for (number, &camera) in cameras.iter().enumerate() {
            let (view, said) = view::next_view(&options, edges, camera, scene, &mut exposure)?;
            said.iter().for_each(|said| console.notice(said));
            if number == 0 {
                let mut idle = view::idle_flags(&view, &options.light);
                idle.extend(view::idle_layers(&view, &content.layers));
                idle.iter().for_each(|said| console.warn(said));
                warnings.extend(idle);
            }
            let drawn = drawing::draw(&renderer, &view, &content, &vector_options, &mut stopwatch)?;
            if let Some(file) = target.write(number as u32, &drawn.bytes)? {
                files.push(file);
            }
            subdivision = subdivision.or(drawn.subdivision);
            vectors = vectors.or(drawn.svg);
            if number == 0 && drawn.may_be_burnt_out() {
                let warning = burnt_out::warning(&renderer, &view)?;
                warning.iter().for_each(|warning| console.warn(warning));
                warnings.extend(warning);
            }
            legend = drawn.legend;
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
                    entry["name"] = json!(scene.nodes[object.node.index()].name.as_str());
                }
                entry
            };
            colors.iter().map(entry).collect()
        }
    }
}
