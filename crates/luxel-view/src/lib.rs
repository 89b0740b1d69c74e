//! The view of a scene, independent of any renderer.
//!
//! | item | subject |
//! | --- | --- |
//! | [`View`] | size, camera, samples, lights, background, exposure, tone, encoding, edges |
//! | [`Shading`] | where light is computed, and how it gets to the pixels between |
//! | [`Cull`] | which faces are left out |
//! | [`Layer`], [`LayerValues`] | pixel data besides colour: depth, normals, ids, terms of light |
//!
//! `luxel-render` answers on the CPU. Nothing here knows how.

#![forbid(unsafe_code)]

mod cull;
mod layer;
mod shading;
mod view;

pub use cull::Cull;
pub use layer::{Layer, LayerValues, ParseLayerError};
pub use luxel_scene::{Background, EnvironmentChoice};
pub use shading::{Clamp, Interpolation, NormalLength, Shading, ShadingMode};
pub use view::{
    AmbientOcclusion, DEFAULT_LIGHT_RAYS, DEFAULT_POINT_SIZE, DEFAULT_SAMPLES, Edges, View,
};
