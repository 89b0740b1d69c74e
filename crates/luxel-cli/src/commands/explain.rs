//! `luxel explain`: why a pixel has its colour, term by term.

mod equation;
mod json;
mod text;

use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::options::{
    ExecutionOptions, FrameOptions, InputOptions, LightOptions, MaterialOptions, ModeOptions,
    PictureOptions, ShadingOptions,
};
use crate::output;
use crate::surface;
use crate::values::at;
use crate::view;
use clap::Args;
use luxel::render::{At, Explanation, RenderError, Renderer, View};
use luxel::scene::Scene;

/// Explain a pixel's colour, term by term
///
/// For example: luxel explain model.glb --at 640,360
#[derive(Args, Debug)]
pub(crate) struct ExplainCommand {
    #[command(flatten)]
    input: InputOptions,
    #[command(flatten)]
    asked: AskedOptions,
    #[command(flatten)]
    frame: FrameOptions,
    #[command(flatten)]
    light: LightOptions,
    #[command(flatten)]
    material: MaterialOptions,
    #[command(flatten)]
    shading: ShadingOptions,
    #[command(flatten)]
    mode: ModeOptions,
    #[command(flatten)]
    picture: PictureOptions,
    #[command(flatten)]
    execution: ExecutionOptions,
}

/// What is asked, and how it is told.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Question and answer")]
struct AskedOptions {
    /// The pixel with all its samples (whole numbers), or one sample at a point (decimals)
    #[arg(long, value_name = "X,Y", value_parser = at, allow_hyphen_values = true)]
    at: At,

    /// Print a JSON document
    #[arg(long)]
    json: bool,
}

/// What is told, and what about.
struct Told<'a> {
    explanation: &'a Explanation,
    scene: &'a Scene,
    view: &'a View,
    /// The model's name.
    model: String,
}

impl ExplainCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let mut model = model::load(&self.input, &self.execution, console)?;
        if model.scene.bounds().is_empty() {
            return Err(model::nothing_to_draw(&self.input.name()));
        }
        surface::apply_material(&self.material, &mut model.scene);
        surface::apply_normals(&self.shading, &mut model.scene);
        let scene = &model.scene;
        let camera = camera::choose(&self.frame, scene)?;
        let view =
            view::view(&self.frame, &self.light, &self.mode, &self.picture, None, camera, scene)?;
        let renderer = Renderer::new(scene, &view::execution(&self.execution))
            .map_err(|error| Failure::work(error.to_string(), ""))?;
        let explanation = renderer.explain(&view, self.asked.at).map_err(|error| match error {
            RenderError::Outside(_) => Failure::Usage(format!("--at: {error}")),
            other => Failure::work(other.to_string(), ""),
        })?;
        let told = Told { explanation: &explanation, scene, view: &view, model: self.input.name() };
        if self.asked.json {
            output::print_json(&json::document(&told))
        } else {
            output::print(&text::page(&told))
        }
    }
}
