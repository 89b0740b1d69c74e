//! `luxel pick`: the objects at a position or in a region of the image.

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
use luxel::scene::{Scene, Size};
use std::sync::Arc;

/// Find the objects at a position, or in a region of the image
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

/// The position, and the output format.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Query and output")]
struct QueryOptions {
    #[command(flatten)]
    place: PlaceOptions,

    /// List all hits at the position, nearest first
    #[arg(long, conflicts_with_all = ["rect", "lasso"])]
    through: bool,

    /// List only objects visible in the region, with their number of pixels
    #[arg(long, conflicts_with = "at")]
    visible: bool,

    /// List only objects entirely inside the region
    #[arg(long, conflicts_with = "at")]
    enclosed: bool,

    /// Snap to the nearest visible vertex, edge or face around the position: vertex, edge, face
    #[arg(long, value_name = "KIND", hide_possible_values = true)]
    #[arg(conflicts_with_all = ["rect", "lasso"])]
    snap: Option<SnapChoice>,

    /// Points and lines within this many pixels of the position count as hits; also the reach of
    /// --snap [default: 0; 8 with --snap]
    #[arg(long, value_name = "PIXELS", value_parser = within, allow_hyphen_values = true)]
    #[arg(conflicts_with_all = ["rect", "lasso"])]
    within: Option<f64>,

    /// Print a JSON document; with positions from the standard input, one document per line
    #[arg(long)]
    json: bool,
}

/// The position or region: one of these.
#[derive(Args, Clone, Debug)]
#[command(next_help_heading = "Query and output")]
#[group(required = true, multiple = false)]
struct PlaceOptions {
    /// The centre of a pixel (integers), or a point of the image (decimals); `-` reads one
    /// position per line from the standard input
    #[arg(long, value_name = "X,Y", value_parser = positions, allow_hyphen_values = true)]
    at: Option<Positions>,

    /// A rectangle: its upper left corner and size in pixels
    #[arg(long, value_name = "X,Y,W,H", value_parser = rectangle, allow_hyphen_values = true)]
    rect: Option<Rectangle>,

    /// A polygon in the image, by its corners in pixels
    #[arg(long, value_name = "X,Y,X,Y,...", value_parser = lasso, allow_hyphen_values = true)]
    lasso: Option<Lasso>,
}

/// One position, or one per line of the standard input.
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

/// The largest distance: luxel picks each pixel around the position.
const MOST_WITHIN: f64 = 100.0;
/// The default reach of snapping.
const SNAP_WITHIN: f64 = 8.0;

fn positions(text: &str) -> Result<Positions, String> {
    if text == "-" { Ok(Positions::Many) } else { position(text).map(Positions::One) }
}

fn within(text: &str) -> Result<f64, String> {
    let pixels = finite(text)?;
    if (0.0..=MOST_WITHIN).contains(&pixels) {
        Ok(pixels)
    } else {
        Err(format!("it must be between 0 and {MOST_WITHIN} pixels"))
    }
}

impl PickCommand {
    pub(crate) fn run(self, console: Console) -> Result<(), Failure> {
        let many = matches!(self.query.place.at, Some(Positions::Many));
        if many && self.input.model == "-" {
            let message = "model and positions can't both be the standard input: use a file";
            return Err(Failure::Usage(message.to_owned()));
        }
        self.query.check_place(self.frame.size)?;
        let mut model = model::load(&self.input, &self.execution, console)?;
        surface::apply_material(&self.material, &mut model.scene);
        // Regions report no normals.
        if self.query.place.at.is_some() {
            surface::apply_normals(&self.shading, &mut model.scene);
        }
        let scene = &Arc::new(model.scene);
        let camera = camera::choose(&self.frame, scene)?;
        // A single query finishes sooner with a tree that builds fast.
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

/// Fails before allocating trees beyond the memory limit.
pub(super) fn check_memory(scene: &Scene, quality: Quality, limit: u64) -> Result<(), Failure> {
    let triangles = scene.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum::<u64>();
    let needed = Picker::bytes_needed(scene, quality);
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
    /// Refuses a position outside of the window, and a region of which no part lies in it.
    fn check_place(&self, size: Size) -> Result<(), Failure> {
        let PlaceOptions { at, rect, lasso } = &self.place;
        if let Some(Positions::One(at)) = at {
            at::check_inside(*at, size)?;
        }
        let corners = match (rect, lasso) {
            (Some(Rectangle { x, y, width, height }), _) => vec![[*x, *y], [x + width, y + height]],
            (None, Some(corners)) => corners.clone(),
            (None, None) => return Ok(()),
        };
        let reaches = |axis: usize, side: u32| {
            let places = corners.iter().map(|corner| corner[axis]);
            let [low, high] = [
                places.clone().fold(f64::INFINITY, f64::min),
                places.fold(f64::NEG_INFINITY, f64::max),
            ];
            low < f64::from(side) && high > 0.0
        };
        let Size { width, height } = size;
        if reaches(0, width) && reaches(1, height) {
            return Ok(());
        }
        let message = format!("the region lies outside of the picture of {width}x{height} pixels");
        Err(Failure::Usage(message))
    }

    fn inclusion(&self) -> Inclusion {
        if self.enclosed { Inclusion::Enclosed } else { Inclusion::Touching }
    }
}
