//! What to draw ([`View`]) and how ([`Execution`]): the second never changes a byte.

mod shading;

use luxel_lighting::{Fog, PictureEncoding};
use luxel_math::SimdLevel;
pub use luxel_scene::EnvironmentChoice;
use luxel_scene::{Camera, SceneLight, Size};
use luxel_visibility::Cull;
pub use shading::{Clamp, Interpolation, NormalLength, Shading, ShadingMode};
use std::time::Duration;

/// What a picture shows, apart from the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// The picture's size.
    pub size: Size,
    /// The camera.
    pub camera: Camera,
    /// Samples a pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Which faces are left out.
    pub cull: Cull,
    /// The lights, in the order in which they are added up.
    pub lights: Vec<SceneLight>,
    /// I_a: the scene's own ambient light.
    pub ambient: [f32; 3],
    /// What mirrors and metals see.
    pub environment: EnvironmentChoice,
    /// Depth cueing.
    pub fog: Option<Fog>,
    /// Linear red, green, blue, and alpha, where nothing is.
    pub background: [f32; 4],
    /// How light becomes bytes.
    pub encoding: PictureEncoding,
    /// Edges of polygons, drawn or nothing but them.
    pub edges: Option<Edges>,
    /// Where light is computed, and how it gets to the pixels between.
    pub shading: Shading,
}

/// How edges of polygons are drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edges {
    /// Only edges, with holes between them; else edges over the faces.
    pub wireframe: bool,
    /// Width in pixels.
    pub width: f32,
    /// Linear colour of edges over faces; wires are lit like their face.
    pub color: [f32; 3],
}

impl Edges {
    /// Wires a pixel and a half wide, lit like the faces.
    pub const WIREFRAME: Self = Self { wireframe: true, width: 1.5, color: [0.0; 3] };
    /// Thin dark lines over the faces.
    pub const OVER_FACES: Self = Self { wireframe: false, width: 1.0, color: [0.01; 3] };
}

/// How the work is done.
#[derive(Clone, Copy, Debug)]
pub struct Execution {
    /// Threads; 0 means one for each core.
    pub threads: usize,
    /// The instruction set.
    pub simd: SimdLevel,
    /// The time since some fixed moment, for the figures of stages. The default doesn't look at any
    /// clock, as not every machine has one.
    pub clock: fn() -> Duration,
    /// Whether a single frame is all that is asked for: meshes are made ready in a fraction of the time
    /// and of the memory, and a frame takes somewhat longer. Pictures are the same.
    pub one_frame: bool,
}

impl Default for Execution {
    fn default() -> Self {
        Self { threads: 0, simd: SimdLevel::Auto, clock: || Duration::ZERO, one_frame: false }
    }
}
