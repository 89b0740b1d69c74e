//! What to draw ([`View`]) and how ([`Execution`]): the second never changes a byte.

use luxel_lighting::{Fog, PictureEncoding};
use luxel_math::SimdLevel;
pub use luxel_scene::EnvironmentChoice;
use luxel_scene::{Camera, SceneLight, Size};
use luxel_visibility::Cull;
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

/// Where light is computed, and how it gets to the pixels between.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shading {
    /// Where light is computed.
    pub mode: ShadingMode,
    /// How normals, texture coordinates, colours and intensities get from corners to pixels.
    pub interpolation: Interpolation,
    /// Where intensities are brought into 0..1.
    pub clamp: Clamp,
    /// Whether interpolated normals are brought to unit length.
    pub normal_length: NormalLength,
}

/// Where light is computed.
///
/// In all modes but `Phong`, what is computed elsewhere is the light of the surface without the
/// texture of its base colour; that multiplies it at the pixel, as `GL_MODULATE` does in OpenGL
/// 1.x, and fog comes last. Normal maps count in `Phong` only; other textures are looked up where
/// the light is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ShadingMode {
    /// Once for each polygon: at its centroid, with its own normal (Bouknight 1970).
    Flat,
    /// At the corners; the intensity is interpolated (Gouraud, *Continuous Shading of Curved
    /// Surfaces*, 1971).
    Gouraud,
    /// At every pixel; the normal is interpolated and brought to unit length (Phong, *Illumination
    /// for Computer Generated Pictures*, 1975).
    #[default]
    Phong,
    /// At the corners of smaller triangles, into which those that are seen are divided until
    /// interpolating the intensity gives what `Phong` gives, to the tolerance. Within a small
    /// triangle the intensity is interpolated with perspective.
    Subdivided {
        /// The difference that is left, in steps of 8 bits after encoding.
        tolerance: f32,
    },
}

/// How what corners carry gets to the pixels between.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linearly in space, which is right.
    #[default]
    Perspective,
    /// Linearly in the window, over the triangle: things slide where the surface slants away.
    Screen,
    /// Linearly in the window along the edges of the *polygon* and then along the row between them:
    /// colours within change as the polygon turns (Foley et al., *Computer Graphics: Principles and
    /// Practice*, 1990, section 16.2.6). Polygons of more than 256 corners, or whose outline meets
    /// itself, are taken triangle by triangle.
    Scanline,
}

/// Where intensities that are computed at corners are brought into 0..1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Clamp {
    /// At the corners, as fixed-function OpenGL does.
    #[default]
    Vertex,
    /// At the end, where colours become bytes.
    End,
}

/// The length of the normals that pixels are lit with. At corners it is 1 always.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NormalLength {
    /// 1, as the equation wants it (Phong 1975).
    #[default]
    Unit,
    /// As interpolation left it: less than 1 between corners, by the more the farther apart their
    /// normals point. It shows what becomes of highlights then.
    Interpolated,
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
