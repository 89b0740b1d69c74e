//! The frame: visibility and lighting become pictures and layers.
//!
//! A [`Renderer`] makes a scene ready once; [`Renderer::rgba8`], [`Renderer::linear`] and
//! [`Renderer::layers`] then draw a [`View`] of it. Every pixel goes the same way: what its samples
//! see (`luxel-visibility`), where on the triangle they lie (`corners`), what the surface is there
//! (`surface`), what light it sends (`luxel-lighting`), and how samples become a pixel (`resolve`).

#![forbid(unsafe_code)]

mod corners;
mod edges;
mod holes;
mod layers;
mod place;
mod renderer;
mod resolve;
mod shade;
mod surface;
mod tiles;
mod view;

pub use layers::{Layer, LayerValues, ParseLayerError};
pub use renderer::{MAX_SIDE, Picture, RenderError, Renderer, Stages};
pub use view::{Cull, Edges, EnvironmentChoice, Execution, View};
