//! Model files in: what a file says becomes a [`Scene`](luxel_scene::Scene).
//!
//! Every reader takes bytes from anywhere, checks counts and indices before it allocates or reads,
//! and answers damaged input with an [`Error`] that names the place. None panics.

#![forbid(unsafe_code)]

mod color;
mod direction;
mod error;
mod files;
mod gltf;
mod image;
mod limits;
mod memory;
mod obj;
mod open;
mod ply;
mod scene_toml;
mod stl;
mod text;
pub mod values;
mod warnings;
mod weld;

pub use error::{Error, ErrorKind, Place};
pub use limits::{Limits, Progress};
pub use open::{Format, Loaded, open, read};
pub use scene_toml::{
    Key, SceneModels, SceneText, Section, Setting, SettingValue, Shape, SurfaceChange,
    scene_settings, sections,
};
