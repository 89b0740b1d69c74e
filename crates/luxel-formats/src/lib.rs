//! Reads model files into a [`Scene`](luxel_scene::Scene).
//!
//! Readers accept untrusted bytes: they check counts and indices before they allocate or index, and
//! return an [`Error`] with its place for damaged input. None panics.
//!
//! # Features
//!
//! All are on by default. A file that needs a feature which is off fails with
//! [`ErrorKind::MissingFeature`]; a placeholder replaces a texture, with a [`Warning`].
//!
//! - `gltf` reads glTF 2.0 and GLB.
//! - `draco` reads glTF geometry compressed by `KHR_draco_mesh_compression`, and turns `gltf` on.
//! - `meshopt` reads glTF geometry compressed by `EXT_meshopt_compression`, and turns `gltf` on.
//! - `obj` reads OBJ with MTL.
//! - `ply` reads PLY, text and binary.
//! - `stl` reads STL, text and binary.
//! - `toml` reads and writes scene files.
//! - `png` decodes PNG textures of glTF and MTL.
//! - `jpeg` decodes JPEG textures of glTF and MTL.
//! - `hdr` reads environments of Radiance (`.hdr`).
//! - `exr` reads environments of OpenEXR (`.exr`).

#![forbid(unsafe_code)]

#[cfg(any(feature = "ply", feature = "stl"))]
mod block_reader;
#[cfg(any(feature = "obj", feature = "ply"))]
mod color;
#[cfg(any(feature = "obj", feature = "ply"))]
mod direction;
mod environment;
mod error;
mod files;
mod format;
mod given_files;
#[cfg(feature = "gltf")]
mod gltf;
#[cfg(any(feature = "gltf", feature = "obj"))]
mod image;
mod limits;
#[cfg(any(feature = "gltf", feature = "obj", feature = "toml"))]
mod memory;
mod model_file;
#[cfg(feature = "obj")]
mod obj;
mod open;
#[cfg(feature = "ply")]
mod ply;
#[cfg(feature = "toml")]
mod scene_toml;
#[cfg(feature = "stl")]
mod stl;
#[cfg(any(feature = "obj", feature = "ply", feature = "stl"))]
#[cfg_attr(
    not(all(feature = "obj", feature = "ply", feature = "stl")),
    allow(dead_code, reason = "each reader uses a part of it")
)]
mod text;
pub mod values;
#[cfg_attr(
    not(any(
        feature = "gltf",
        feature = "obj",
        feature = "ply",
        feature = "stl",
        feature = "toml"
    )),
    allow(dead_code, reason = "this build has no reader")
)]
mod warnings;
#[cfg(any(feature = "obj", feature = "stl"))]
#[cfg_attr(
    not(all(feature = "obj", feature = "stl")),
    allow(dead_code, reason = "each reader uses a part of it")
)]
mod weld;

pub use environment::{
    LoadedEnvironment, decode_environment, is_environment, open_environment, read_environment,
};
pub use error::{Error, ErrorKind, Hint, Place, UnknownFormat};
pub use format::{Format, Loaded};
pub use given_files::GivenFiles;
pub use limits::{FileList, Limits, Progress, ReadFile};
pub use open::{open, read};
#[cfg(feature = "toml")]
pub use scene_toml::{
    Key, SceneModels, SceneText, Section, Setting, SettingValue, Shape, SurfaceChange,
    scene_settings, sections,
};
pub use warnings::Warning;
