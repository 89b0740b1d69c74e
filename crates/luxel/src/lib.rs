//! Light, draw and pick 3D models on the CPU, with the same bytes on every machine.
//!
//! ```no_run
//! use luxel::scene::Size;
//!
//! let model = luxel::load("model.glb")?;
//! let picture = luxel::draw(model.scene, Size { width: 1280, height: 720 })?;
//! picture.save("model.png")?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! To choose camera, light or background, take [`default_view`], change its fields, and give it to
//! a [`render::Renderer`], which makes a scene ready once and draws it as often as you like.
//!
//! This crate is the one to depend on: it gathers the others, each with one subject.
//!
//! | module | subject |
//! | --- | --- |
//! | [`formats`] | files in: glTF, OBJ, STL, PLY, with limits and errors that name their place |
//! | [`scene`] | scenes: meshes, nodes, cameras, lights, textures, the built-in demos |
//! | [`lighting`] | the lighting equation |
//! | [`check`] | mesh defects that spoil shading |
//! | [`bvh`] | rays against triangles: closest, any and all hits |
//! | [`pick`] | picking: rays, pixels, rectangles |
//! | [`rays`] | rays through a scene: what they hit, and what lies in their way |
//! | [`view`] | views: camera, lights, shading, layers |
//! | [`render`] | pictures and layers of a scene |
//! | [`report`] | the light of a pixel term by term, and picks, as text, JSON, LaTeX, HTML |
//! | [`navigation`] | from mouse and keys to the camera, without a window |
//! | [`light_editing`] | lights under a hand: poses, and handles in a picture |
//! | [`math`] | numbers with the same bits everywhere |
//!
//! # Features
//!
//! All but `packed` are on by default; `luxel = { default-features = false, features = ["gltf"] }` reads glTF
//! alone.
//!
//! - `readers` turns on all features below.
//! - `gltf` reads glTF 2.0 and GLB; `draco` and `meshopt` read its compressed geometry, too.
//! - `obj` reads OBJ with MTL, `ply` PLY, `stl` STL, `toml` scene files.
//! - `png` and `jpeg` decode textures.
//! - `packed` (off by default) turns scenes and views into bytes and back, for other processes.
//! - `avx512` adds kernels for AVX-512; without them such machines run AVX2's.

#![forbid(unsafe_code)]

mod camera_choice;
mod default_view;
mod draw;
pub mod light_editing;
mod load;
#[cfg(feature = "packed")]
mod packed;
mod settings;

pub use camera_choice::{CameraChoice, CameraError};
pub use default_view::{
    DEFAULT_AZIMUTH_DEGREES, DEFAULT_ELEVATION_DEGREES, DEFAULT_FOV_DEGREES, default_camera,
    default_view, default_view_from, environment_of, lights_of, view_from_world_of,
};
pub use draw::{draw, write_png};
pub use load::load;
pub use luxel_bvh as bvh;
pub use luxel_check as check;
pub use luxel_formats as formats;
pub use luxel_lighting as lighting;
pub use luxel_math as math;
pub use luxel_navigation as navigation;
pub use luxel_pick as pick;
pub use luxel_rays as rays;
pub use luxel_render as render;
pub use luxel_report as report;
pub use luxel_scene as scene;
pub use luxel_view as view;
pub use luxel_view::DEFAULT_SAMPLES;
#[cfg(feature = "packed")]
pub use packed::{
    UnpackError, pack, pack_map, pack_view, pack_view_without_map, unpack, unpack_map, unpack_view,
    unpack_view_with_map,
};
pub use settings::{SETTINGS, SettingError, Settings};

/// The types that most programs need.
pub mod prelude {
    pub use crate::{default_view, draw, load, write_png};
    pub use luxel_formats::{Format, Limits, Loaded};
    pub use luxel_lighting::{Light, LightKind, Material, Reflection};
    pub use luxel_math::SimdLevel;
    pub use luxel_render::{Execution, Layer, Renderer, View};
    pub use luxel_scene::{Camera, DMat4, DVec3, Lens, Placement, Projection, Scene, Size};
}

/// The examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
