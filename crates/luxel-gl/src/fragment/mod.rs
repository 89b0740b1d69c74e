//! Textures on fragments (OpenGL 1.5, sections 3.8.7 to 3.8.16).
//!
//! `stages`: what a draw's fragments meet, unit by unit; `footprint`, `fetch`, `sample`: texels at a place; `combine`:
//! environments.

mod combine;
mod fetch;
mod footprint;
mod sample;
mod stages;

pub(crate) use footprint::Footprint;
pub(crate) use stages::TextureStages;
