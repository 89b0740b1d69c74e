//! Scenes: meshes, nodes with names and paths, cameras, lights, materials and textures.
//!
//! World space is right-handed. Matrices are column-major, act on column vectors, and are named
//! target-from-source, so that products read themselves: `clip_from_view * view_from_world`.

#![forbid(unsafe_code)]

mod angle;
mod background;
mod camera;
mod coplanar;
pub mod demos;
mod encoding;
mod environment;
mod extremes;
mod fans;
mod fit;
mod light;
mod material;
mod mesh;
mod meshes;
mod node;
mod normal_map;
mod normals;
mod opacity;
mod point_tree;
pub mod primitives;
mod restyle;
mod scene;
mod sections;
mod shared_axes;
mod shared_matrix;
mod soundness;
mod tangents;
pub mod texture;
mod topology;
mod triangulate;

pub use background::Background;
pub use camera::{CLIP_VOLUME, Camera, Lens, Projection, SceneCamera, Size};
pub use coplanar::{CoplanarRanks, rank_of};
pub use encoding::Encoding;
pub use environment::{EnvironmentChoice, NamedEnvironment};
pub use fit::{Viewpoint, fit_along, fit_box, fit_planes, fit_view};
pub use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
pub use light::{DEFAULT_AMBIENT, Placement, SceneLight, default_lights};
pub use material::{AlphaMode, SceneMaterial, Sides, TextureUse};
pub use mesh::{Bounds, Lines, Mesh, NormalFault, Part, Points, Section};
pub use meshes::Meshes;
pub use node::{CameraId, LightId, MaterialId, MeshId, Node, NodeId, TextureId};
pub use normal_map::mapped_normal;
pub use normals::{DEFAULT_CREASE_DEGREES, NormalOptions, NormalSource};
pub use opacity::{OpacityCorners, OpacityLanes};
pub use restyle::Restyle;
pub use scene::{Object, Scene, bodies};
pub use sections::{Joiner, SectionRange};
pub use shared_axes::SharedAxes;
pub use shared_matrix::SharedMatrix;
/// A name of a node or a material, in 24 bytes: up to 23 letters of ASCII take no memory of their own.
pub use smol_str::SmolStr as Name;
pub use soundness::{ScenePart, UnsoundScene};
pub use texture::{Filter, Image, MipLevel, Sampler, Texture, Wrap};
pub use topology::{Topology, weld};
pub use triangulate::triangulate;
