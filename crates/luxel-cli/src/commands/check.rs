//! `luxel check`: mesh defects that spoil shading.

use crate::camera;
use crate::console::{Console, printable};
use crate::failure::Failure;
use crate::flag_words::cure;
use crate::model::{self, Model};
use crate::options::{InputOptions, ViewOptions};
use crate::output;
use crate::surface;
use crate::view;
use clap::Args;
use luxel::check::{Finding, Kind, Report, Setup, check};
use luxel::formats::values::nearest;
use luxel::lighting::PictureEncoding;
use luxel::render::{ParsePictureFormatError, PictureFormat, Renderer, write_rgba8};
use luxel::scene::{Camera, Scene};
use serde_json::{Value, json};
use std::ffi::OsString;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// Find the mesh defects that spoil shading
///
/// Winding, degenerate faces, T-junctions, cracks, normals and more: how many, how visible in steps
/// of 8-bit pixels, where, and how to fix them. Exits with status 0 if nothing is found, else
/// with 3. For example: luxel check model.obj -o marks.png
#[derive(Args, Debug)]
pub(crate) struct CheckCommand {
    #[command(flatten)]
    input: InputOptions,

    /// Write an image of the model in grey with the findings in colour and a legend: .png or .ppm
    #[arg(short, long, value_name = "FILE")]
    output: Option<OsString>,

    /// Mark only this kind of finding, such as t-junction; may be repeated [default: all]
    #[arg(long = "layer", value_name = "KIND", value_parser = kind, requires = "output")]
    layers: Vec<Kind>,

    /// Print a JSON document
    #[arg(long)]
    json: bool,

    #[command(flatten)]
    view: ViewOptions,
}

impl CheckCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let format = self.output.as_ref().map(format_of).transpose()?;
        let mut model = model::load(&self.input, &self.view.execution, console)?;
        surface::apply_material(&self.view.material, &mut model.scene);
        let scene = &model.scene;
        let camera = camera::choose(&self.view.frame, scene)?;
        let execution = view::execution(&self.view.execution);
        let mut view = view::view(&self.view, None, camera, scene)?;
        if let Some(said) = view::expose(&mut view, &self.view, scene) {
            console.notice(&said);
        }
        let setup = Setup { view, normals: surface::normal_options(&self.view.shading), execution };
        let report = check(scene, &setup);
        if let (Some(path), Some(format)) = (&self.output, format) {
            self.draw(&report, scene, camera, Path::new(path), format)?;
        }
        if self.json {
            output::print_json(&to_json(&report, &model))?;
        } else {
            output::print(&to_text(&report, &model, &self.input.name()))?;
        }
        if report.findings.is_empty() { Ok(()) } else { Err(Failure::Findings) }
    }

    /// Renders the model with its findings marked.
    fn draw(
        &self,
        report: &Report,
        scene: &Scene,
        camera: Camera,
        path: &Path,
        format: PictureFormat,
    ) -> Result<(), Failure> {
        output::check_folder(path, "-o")?;
        let failure = |error: String| Failure::work(error, "");
        let only = if self.layers.is_empty() { &Kind::ALL[..] } else { &self.layers };
        let mut marked = report.marked_only(scene, only);
        surface::apply_normals(&self.view.shading, &mut marked);
        let marked = Arc::new(marked);
        let execution = view::execution(&self.view.execution);
        let renderer = Renderer::new(Arc::clone(&marked), &execution)
            .map_err(|error| failure(error.to_string()))?;
        let mut view = luxel::default_view_from(&marked, camera, self.view.frame.size);
        view.samples = self.view.frame.samples;
        let picture = report
            .picture(scene, only, &renderer, &view)
            .map_err(|error| failure(error.to_string()))?;
        let mut bytes = Vec::new();
        write_rgba8(format, view.size, &picture.pixels, PictureEncoding::Srgb, &mut bytes)
            .map_err(|error| failure(error.to_string()))?;
        output::write_file(path, &bytes)
    }
}

/// Parses a kind of finding.
fn kind(name: &str) -> Result<Kind, String> {
    let names = Kind::ALL.map(Kind::name);
    let found = Kind::ALL.into_iter().find(|kind| kind.name() == name);
    found.ok_or_else(|| match nearest(name, names) {
        Some(meant) => format!("unknown kind of finding: did you mean `{meant}`?"),
        None => format!("unknown kind of finding: use {}", names.join(", ")),
    })
}

/// The format of the marked image, by its file name.
fn format_of(name: &OsString) -> Result<PictureFormat, Failure> {
    let extension = Path::new(name).extension().unwrap_or_default().to_string_lossy();
    let format = extension.parse().map_err(|error: ParsePictureFormatError| {
        let name = name.to_string_lossy();
        Failure::Usage(format!("invalid value '{name}' for '--output': {error}"))
    })?;
    match format {
        PictureFormat::Png | PictureFormat::Ppm => Ok(format),
        _ => Err(Failure::Usage("the marked image must be .png or .ppm".to_owned())),
    }
}

fn to_json(report: &Report, model: &Model) -> Value {
    json!({
        "findings": report.to_json(&model.scene, cure),
        "triangles": model.scene.triangle_count(),
        "warnings": model.warnings,
    })
}

fn to_text(report: &Report, model: &Model, name: &str) -> String {
    let mut text = String::new();
    // Writing to a string can't fail.
    let _ = write_text(report, model, name, &mut text);
    text
}

fn write_text(report: &Report, model: &Model, name: &str, text: &mut String) -> std::fmt::Result {
    let triangles = model.scene.triangle_count();
    let name = printable(name);
    if report.findings.is_empty() {
        return writeln!(text, "{name}: nothing found in {triangles} triangles");
    }
    let kinds = match report.findings.len() {
        1 => "1 kind of finding".to_owned(),
        count => format!("{count} kinds of findings"),
    };
    writeln!(text, "{name}: {kinds} in {triangles} triangles")?;
    let objects = model.scene.objects();
    for finding in &report.findings {
        let Finding { kind, count, severity, pixels, places } = finding;
        let steps = |steps: &f32| match steps {
            1.0 => "1 step".to_owned(),
            steps => format!("{steps} steps"),
        };
        let degree = match (severity, pixels) {
            (Some(most), Some(pixels)) => {
                format!(", up to {pixels:.1} pixels off and {} of 255", steps(most))
            }
            (None, Some(pixels)) => format!(", up to {pixels:.1} pixels off"),
            (Some(0.0), _) => ", not visible in luxel".to_owned(),
            (Some(most), _) => format!(", up to {} of 255", steps(most)),
            _ => String::new(),
        };
        writeln!(text, "\n{}  {count}{degree}", kind.name())?;
        writeln!(text, "  {}", kind.about())?;
        for place in places.iter().take(3) {
            let object = &objects[place.object as usize];
            let path = printable(&model.scene.path(object.node).join(" / "));
            let [x, y, z] = place.position.to_array().map(|value| format!("{value:.5}"));
            let triangle = place.triangle.map(|number| format!(" triangle {number}"));
            writeln!(text, "  at {x} {y} {z}: {path}{}", triangle.unwrap_or_default())?;
        }
        writeln!(text, "  cure: {}", cure(*kind))?;
    }
    Ok(())
}
