//! `luxel pick`: what is under a place of the window, and in a part of it.

mod at;
mod region;

use crate::camera;
use crate::console::Console;
use crate::failure::Failure;
use crate::model;
use crate::options::{
    ExecutionOptions, FrameOptions, InputOptions, MaterialOptions, ShadingOptions,
};
use crate::surface;
use crate::values::{Rectangle, at as position, finite, lasso, rectangle};
use clap::{Args, ValueEnum};
use luxel::pick::{Inclusion, PickView, Picker, Quality};
use luxel::render::At;
use luxel::scene::Scene;
use std::sync::Arc;

/// Tell what is under a place of the window, or in a part of it
///
/// For example: luxel pick model.glb --at 640,360
#[derive(Args, Debug)]
pub(crate) struct PickCommand {
    #[command(flatten)]
    input: InputOptions,
    #[command(flatten)]
    query: QueryOptions,
    #[command(flatten)]
    frame: FrameOptions,
    #[command(flatten)]
    material: MaterialOptions,
    #[command(flatten)]
    shading: ShadingOptions,
    #[command(flatten)]
    execution: ExecutionOptions,
}

/// The question, and the form of the answer.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Question and answer")]
struct QueryOptions {
    #[command(flatten)]
    place: PlaceOptions,

    /// Everything under the place, nearest first
    #[arg(long, conflicts_with_all = ["rect", "lasso"])]
    through: bool,

    /// Only what owns pixels of the rectangle or polygon, with their number
    #[arg(long, conflicts_with = "at")]
    visible: bool,

    /// Only what lies inside of the rectangle or polygon as a whole
    #[arg(long, conflicts_with = "at")]
    enclosed: bool,

    /// The nearest vertex, edge or face that is seen around the place: vertex, edge, face
    #[arg(long, value_name = "KIND", hide_possible_values = true)]
    #[arg(conflicts_with_all = ["rect", "lasso"])]
    snap: Option<SnapChoice>,

    /// Points and lines seen within so many pixels of the place count as hit; and how far --snap
    /// looks [default: 0; 8 for --snap]
    #[arg(long, value_name = "PIXELS", value_parser = within, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["rect", "lasso"])]
    within: Option<f64>,

    /// Print a JSON document; a document a line for positions from the standard input
    #[arg(long)]
    json: bool,
}

/// Where: one of these.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Question and answer")]
#[group(required = true, multiple = false)]
struct PlaceOptions {
    /// The centre of a pixel (whole numbers), or a point of the window (decimals); `-` reads a
    /// position a line from the standard input
    #[arg(long, value_name = "X,Y", value_parser = positions, allow_hyphen_values = true)]
    at: Option<Positions>,

    /// Everything in a rectangle: its upper left corner and size in pixels
    #[arg(long, value_name = "X,Y,W,H", value_parser = rectangle, allow_hyphen_values = true)]
    rect: Option<Rectangle>,

    /// Everything in a polygon of the window, by its corners
    #[arg(long, value_name = "X,Y,X,Y,...", value_parser = lasso, allow_hyphen_values = true)]
    lasso: Option<Lasso>,
}

/// One position, or one a line of the standard input.
#[derive(Clone, Copy, Debug)]
enum Positions {
    One(At),
    Many,
}

/// A polygon's corners.
type Lasso = Vec<[f64; 2]>;

/// What to snap to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum SnapChoice {
    /// Corners of polygons.
    Vertex,
    /// Edges of polygons.
    Edge,
    /// Surfaces.
    Face,
}

/// The largest distance, since each pixel around the place is picked.
const MOST_WITHIN: f64 = 100.0;
/// The default distance of snapping.
const SNAP_WITHIN: f64 = 8.0;

fn positions(text: &str) -> Result<Positions, String> {
    if text == "-" { Ok(Positions::Many) } else { position(text).map(Positions::One) }
}

fn within(text: &str) -> Result<f64, String> {
    let pixels = finite(text)?;
    if (0.0..=MOST_WITHIN).contains(&pixels) {
        Ok(pixels)
    } else {
        Err(format!("it must lie between 0 and {MOST_WITHIN} pixels"))
    }
}

impl PickCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let many = matches!(self.query.place.at, Some(Positions::Many));
        if many && self.input.model == "-" {
            let message = "the standard input can't give both the model and the positions";
            return Err(Failure::Usage(message.to_owned()));
        }
        let mut model = model::load(&self.input, &self.execution, console)?;
        surface::apply_material(&self.material, &mut model.scene);
        // Regions report no normals.
        if self.query.place.at.is_some() {
            surface::apply_normals(&self.shading, &mut model.scene);
        }
        let scene = &Arc::new(model.scene);
        let camera = camera::choose(&self.frame, scene)?;
        // A single question is answered sooner by a tree that is made quickly.
        let quality = if many { Quality::Thorough } else { Quality::InOrder };
        check_memory(scene, quality, self.execution.max_memory)?;
        let picker = Picker::with(Arc::clone(scene), quality, self.execution.simd)
            .map_err(|error| Failure::work(error.to_string(), ""))?;
        let view = PickView::new(&picker, camera, self.frame.size, self.frame.cull.into())
            .map_err(|error| Failure::work(error.to_string(), ""))?;
        match self.query.place.at {
            Some(Positions::One(at)) => self.query.one(&view, at),
            Some(Positions::Many) => self.query.many(&view),
            None => self.query.region(&view),
        }
    }
}

/// Ends the work before memory is taken for trees that is not allowed.
pub(super) fn check_memory(scene: &Scene, quality: Quality, limit: u64) -> Result<(), Failure> {
    let triangles = scene.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum::<u64>();
    let needed = triangles.saturating_mul(quality.bytes_a_triangle() as u64);
    if needed <= limit {
        return Ok(());
    }
    Err(Failure::work(
        format!(
            "a tree over {triangles} triangles would take {needed} bytes; the limit is {limit}"
        ),
        "raise the limit with --max-memory",
    ))
}

impl QueryOptions {
    fn inclusion(&self) -> Inclusion {
        if self.enclosed { Inclusion::Enclosed } else { Inclusion::Touching }
    }
}
