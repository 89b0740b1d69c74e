//! Why a view can't be drawn.

use luxel_math::UnavailableSimdLevel;
use luxel_rays::TooManyForTree;
use luxel_scene::{Size, UnsoundScene};
use luxel_visibility::TooManyTriangles;

/// Why a view can't be drawn.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// Not 1, 2, 4, 8 or 16 samples.
    #[error("{0} samples a pixel aren't possible: use 1, 2, 4, 8 or 16")]
    Samples(u32),
    /// A side of 0 or beyond the limit.
    #[error("a picture of {0}x{1} isn't possible: each side has 1 to {MAX_SIDE} pixels")]
    Size(u32, u32),
    /// A layer of a light that the view doesn't have.
    #[error("there is no directional, point or spot light `{name}`{}", listed(.lights))]
    NoSuchLight {
        /// The name.
        name: String,
        /// The names of those that there are.
        lights: Vec<String>,
    },
    /// A place outside of the picture.
    #[error("it lies outside of the picture of {}x{} pixels", .0.width, .0.height)]
    Outside(Size),
    /// A scene that refers to what isn't there.
    #[error(transparent)]
    Unsound(#[from] UnsoundScene),
    /// More triangles than can be numbered.
    #[error(transparent)]
    TooManyTriangles(#[from] TooManyTriangles),
    /// More triangles in a mesh than rays for shadows can go through.
    #[error(transparent)]
    TooManyForRays(#[from] TooManyForTree),
    /// Trees for rays that take more than [`Execution::max_memory`](crate::Execution::max_memory).
    #[error(
        "shadows, ambient occlusion and the ground need trees over {triangles} triangles, which would take \
         {needed} bytes; the limit is {limit}"
    )]
    TreesTooLarge {
        /// The triangles of all meshes.
        triangles: u64,
        /// Bytes.
        needed: u64,
        /// The bytes allowed.
        limit: u64,
    },
    /// More pieces of vectors than are allowed.
    #[error("the picture has more than {0} pieces of one colour")]
    TooManyPieces(usize),
    /// Another thread stopped the drawing.
    #[error("the drawing was stopped")]
    Stopped,
    /// The machine lacks the instruction set.
    #[error("{0}")]
    Simd(String),
}

/// What follows the name of a light that isn't there.
fn listed(lights: &[String]) -> String {
    if lights.is_empty() {
        return ": there are none".to_owned();
    }
    let names: Vec<_> = lights.iter().map(|name| format!("`{name}`")).collect();
    format!(": use {}", names.join(", "))
}

impl From<UnavailableSimdLevel> for RenderError {
    fn from(error: UnavailableSimdLevel) -> Self {
        Self::Simd(error.to_string())
    }
}

/// Most pixels of a picture's side: positions in 24.8 bits, with room for the guard band.
pub const MAX_SIDE: u32 = 16384;
