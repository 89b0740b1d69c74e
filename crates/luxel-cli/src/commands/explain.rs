//! `luxel explain`: the lighting equation of a pixel, term by term.

use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::options::{InputOptions, ViewOptions};
use crate::output;
use crate::surface;
use crate::values::at;
use crate::view;
use clap::Args;
use luxel::render::{At, Execution, RenderError, Renderer, Unseen};
use luxel::report::{Hint, Pictures, Report};
use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::Path;
use std::sync::Arc;

/// Explain a pixel's colour, term by term
///
/// For example: luxel explain model.glb --at 640,360
#[derive(Args, Debug)]
pub(crate) struct ExplainCommand {
    #[command(flatten)]
    input: InputOptions,
    #[command(flatten)]
    query: QueryOptions,
    #[command(flatten)]
    view: ViewOptions,
}

/// The position, and the output format.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Query and output")]
struct QueryOptions {
    /// The pixel with all its samples (integers), or one sample at a point (decimals)
    #[arg(long, value_name = "X,Y", value_parser = at, allow_hyphen_values = true)]
    at: At,

    /// Print a JSON document
    #[arg(long, conflicts_with_all = ["latex", "html"])]
    json: bool,

    /// Print a LaTeX fragment, for a document with amsmath
    #[arg(long, conflicts_with = "html")]
    latex: bool,

    /// Print an HTML page with drawings of the pixel's neighbourhood and vectors
    #[arg(long)]
    html: bool,

    /// The output file; `-` is the standard output [default: -]
    #[arg(short, long, value_name = "FILE")]
    output: Option<OsString>,
}

impl ExplainCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let file = self.query.output.as_deref().filter(|name| *name != "-").map(Path::new);
        if let Some(path) = file {
            output::check_folder(path, "-o")?;
        }
        let mut model = model::load(&self.input, &self.view.execution, console)?;
        if model.scene.is_empty() {
            return Err(model::nothing_to_draw(&self.input.name()));
        }
        surface::apply_material(&self.view.material, &mut model.scene);
        surface::apply_normals(&self.view.shading, &mut model.scene);
        let scene = &Arc::new(model.scene);
        let camera = camera::choose(&self.view.frame, scene)?;
        let mut view = view::view(&self.view, None, camera, scene)?;
        let idle = view::idle_flags(&view, &self.view.light);
        idle.iter().for_each(|said| console.warn(said));
        if let Some(said) = view::expose(&mut view, &self.view, scene) {
            console.notice(&said);
        }
        let execution = Execution { one_frame: true, ..view::execution(&self.view.execution) };
        let renderer = Renderer::new(Arc::clone(scene), &execution)?;
        let explanation = renderer.explain(&view, self.query.at).map_err(|error| match error {
            RenderError::Outside(_) => Failure::Usage(format!("--at: {error}")),
            other => other.into(),
        })?;
        let unseen = Unseen::new(&renderer, &view, &explanation)?;
        let model = self.input.name();
        let report = Report::new(&explanation, scene, &view)
            .with_model(&model)
            .with_unseen(&unseen)
            .with_hint_text(flag_of);
        let text = if self.query.json {
            format!("{}\n", report.to_json())
        } else if self.query.latex {
            report.to_latex()
        } else if self.query.html {
            let pictures = Pictures::draw(&renderer, &view, explanation.pixel)
                .map_err(|error| Failure::work(error.to_string(), ""))?;
            report.with_pictures(&pictures).to_html()
        } else if file.is_none() && has_colors() {
            report.to_colored_text()
        } else {
            report.to_text()
        };
        match file {
            Some(path) => output::write_file(path, text.as_bytes()),
            None => output::print(&text),
        }
    }
}

/// Words a hint as a flag.
fn flag_of(hint: Hint) -> &'static str {
    match hint {
        Hint::ViewCullsBackFaces => "--cull back hides such faces",
        other => other.text(),
    }
}

/// Colours need a terminal that supports them and an unset `NO_COLOR`.
fn has_colors() -> bool {
    std::io::stdout().is_terminal()
        && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
