//! The frame: visibility and lighting become pictures and layers.
//!
//! A [`Renderer`] makes a scene ready once; [`Renderer::rgba8`], [`Renderer::linear`] and
//! [`Renderer::layers`] then draw a [`View`] of it. Every pixel goes the same way: what its samples
//! see (`luxel-visibility`), where on the triangle they lie (`shade`), what the surface is there
//! (`varying`, `surface`), what light it sends (`luxel-lighting`), and how samples become a pixel (`resolve`).
//! [`write_rgba8`], [`write_linear`] and [`write_layers`] make files of what was drawn.

#![forbid(unsafe_code)]

mod around;
mod edges;
mod evaluated;
mod explain;
mod feedback;
mod firsts;
mod gathered;
mod holes;
mod layers;
mod ledger;
mod outline;
mod packed;
mod picture;
mod pieces;
mod place;
mod plain;
mod polygons;
mod primitives;
mod ready;
mod renderer;
mod resolve;
mod shade;
mod surface;
mod svg;
mod tiles;
mod triangles;
mod unseen;
mod varying;
mod vertex;
mod view;
mod worker;

pub use explain::At;
pub use feedback::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
pub use layers::{Layer, LayerValues, ParseLayerError};
pub use ledger::{
    EvaluatedAt, ExplainedLight, ExplainedMaterial, ExplainedSample, ExplainedSurface, Explanation,
    Seen, Unlit,
};
pub use luxel_visibility::Cull;
pub use picture::{
    LayerImage, Legend, ParsePictureFormatError, PictureError, PictureFormat, id_color, layer_rgb8,
    write_layers, write_linear, write_rgba8,
};
pub use renderer::{MAX_SIDE, Picture, Prepared, RenderError, Renderer, Stages, Subdivision};
pub use svg::{MAX_PIECES, Svg, SvgOptions};
pub use unseen::{Hidden, NEAREST_WITHIN, NearestObject, SurfaceBelow, Unseen};
pub use view::{
    Clamp, Edges, EnvironmentChoice, Execution, Interpolation, NormalLength, Shading, ShadingMode,
    View,
};
