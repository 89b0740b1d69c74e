//! The frame: visibility and lighting become pictures and layers.
//!
//! A [`Renderer`] makes a scene ready once; [`Renderer::rgba8`], [`Renderer::linear`] and
//! [`Renderer::layers`] then draw a [`View`] of it. Every pixel goes the same way: what its samples
//! see (`luxel-visibility`), where on the triangle they lie (`interpolate`), what the surface is there
//! (`material`), what light it sends (`luxel-lighting`), and how samples become a pixel (`resolve`).
//! [`write_rgba8`], [`write_linear`] and [`write_layers`] make files of what was drawn.

#![forbid(unsafe_code)]

mod backdrop;
mod context;
mod coverage;
mod execution;
mod explain;
mod exposure;
mod frame;
mod image;
mod interpolate;
mod layers;
mod material;
mod polygons;
mod resolve;
mod setup;
mod shade;
mod shadow;
mod subdivision;
mod vector;

pub use execution::Execution;
pub use explain::{
    At, BlockedBy, EvaluatedAt, ExplainedGround, ExplainedLight, ExplainedMaterial,
    ExplainedSample, ExplainedShadow, ExplainedSurface, Explanation, Hidden, NEAREST_WITHIN,
    NearestObject, Seen, SurfaceBelow, Unlit, Unseen,
};
pub use exposure::{AutoExposure, auto_exposure};
pub use frame::{
    MAX_SIDE, Picture, Prepared, RenderError, Renderer, Stages, Subdivision, TileDrawing,
};
pub use image::{
    LayerImage, Legend, ParsePictureFormatError, PictureError, PictureFormat, id_color, layer_rgb8,
    write_layers, write_linear, write_rgba8,
};
pub use luxel_pick::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
pub use luxel_view::{
    Background, Clamp, Cull, Edges, EnvironmentChoice, Interpolation, Layer, LayerValues,
    NormalLength, ParseLayerError, Shading, ShadingMode, View,
};
pub use luxel_visibility::TILE as TILE_SIDE;
#[cfg(feature = "vectors")]
pub use vector::{MAX_PIECES, Svg, SvgOptions};
