//! Layers: what the picture is made of, one value or three a pixel, taken at the pixel's centre and
//! never averaged.

use crate::shade::{Batch, Kept, Scene16, interpolate};
use crate::surface;
use luxel_math::{LANES, Simd, f32x16, prelude::*};
use luxel_scene::Projection;
use luxel_visibility::{Tile, TriangleId};
use std::str::FromStr;

/// What a layer shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Layer {
    /// Window depth, 0 at the near plane, 1 at the far one and where nothing is.
    Depth,
    /// The distance along the viewing axis; infinite where nothing is.
    Z,
    /// The unit normal used for shading, in world space; 0 where nothing is.
    Normal,
    /// The place in world space; 0 where nothing is.
    Position,
    /// The object's number; 4294967295 where nothing is.
    Object,
    /// The triangle's number within its object; 4294967295 where nothing is.
    Triangle,
    /// The weights of the triangle's three corners; 0 where nothing is.
    Barycentric,
    /// Texture coordinates of the first set; 0 where there are none.
    Uv,
}

/// A layer's values, row by row.
#[derive(Clone, Debug, PartialEq)]
pub enum LayerValues {
    /// One to three numbers a pixel.
    F32(Vec<f32>),
    /// One number a pixel.
    U32(Vec<u32>),
}

impl Layer {
    /// All layers.
    pub const ALL: [Self; 8] = [
        Self::Depth,
        Self::Z,
        Self::Normal,
        Self::Position,
        Self::Object,
        Self::Triangle,
        Self::Barycentric,
        Self::Uv,
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Z => "z",
            Self::Normal => "normal",
            Self::Position => "position",
            Self::Object => "object",
            Self::Triangle => "triangle",
            Self::Barycentric => "barycentric",
            Self::Uv => "uv",
        }
    }

    /// Values a pixel.
    #[must_use]
    pub const fn channels(self) -> usize {
        match self {
            Self::Depth | Self::Z | Self::Object | Self::Triangle => 1,
            Self::Uv => 2,
            Self::Normal | Self::Position | Self::Barycentric => 3,
        }
    }

    /// Whether the values are whole numbers.
    #[must_use]
    pub const fn is_id(self) -> bool {
        matches!(self, Self::Object | Self::Triangle)
    }
}

/// A name that is no layer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{0}` is no layer: use depth, z, normal, position, object, triangle, barycentric or uv")]
pub struct ParseLayerError(String);

impl FromStr for Layer {
    type Err = ParseLayerError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let found = Self::ALL.into_iter().find(|layer| layer.name() == name);
        found.ok_or_else(|| ParseLayerError(name.to_owned()))
    }
}

/// Most channels of a layer.
const CHANNELS: usize = 3;

/// The bits of a layer's values at one pixel.
pub(crate) type LayerPixel = [u32; CHANNELS];

/// Everything that layers need beside the surfaces.
pub(crate) struct LayerView {
    pub(crate) projection: Projection,
    /// The eye's place in the world, f64, which positions are about.
    pub(crate) eye: [f64; 3],
}

impl LayerView {
    fn depth(&self, z: f32) -> f32 {
        self.projection.window_depth(f64::from(z)) as f32
    }
}

/// The values of a layer for one block of a tile of one sample a pixel.
#[inline(always)]
pub(crate) fn layers_of_block<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    view: &LayerView,
    layer: Layer,
    tile: &Tile,
    block: usize,
    kept: &mut Kept,
) -> [LayerPixel; LANES] {
    let ids = tile.planes()[0].ids[block];
    let batch = Batch::new(tile, block, ids, &[0; LANES], scene.frame.samples());
    let interpolated = interpolate(f32x16::splat(simd, 0.0), scene, &batch, kept);
    let corners = &kept.corners;
    let point = surface::point(scene, &interpolated, corners);
    let z = point.depth;
    let normals = match layer {
        Layer::Normal => surface::shading_normals(scene, &interpolated, corners, &point),
        _ => point.normal,
    };
    let uv = if corners.has.uvs[0] {
        corners.uv(0, &interpolated.weights)
    } else {
        [f32x16::splat(simd, 0.0); 2]
    };
    let mut values = [[0; CHANNELS]; LANES];
    for (lane, (value, &id)) in values.iter_mut().zip(&ids).enumerate() {
        let floats = |values: [f32; CHANNELS]| values.map(f32::to_bits);
        let Some(of) = scene.frame.triangle(TriangleId(id)) else {
            *value = match layer {
                Layer::Depth => floats([1.0; CHANNELS]),
                Layer::Z => floats([f32::INFINITY; CHANNELS]),
                Layer::Object | Layer::Triangle => [u32::MAX; CHANNELS],
                _ => [0; CHANNELS],
            };
            continue;
        };
        *value = match layer {
            Layer::Depth => floats([view.depth(z[lane]); CHANNELS]),
            Layer::Z => floats([z[lane]; CHANNELS]),
            Layer::Object => [scene.objects[of.instance] as u32; CHANNELS],
            // Points and lines come after the objects' own instances and have no triangles.
            Layer::Triangle if scene.objects[of.instance] != of.instance => [u32::MAX; CHANNELS],
            Layer::Triangle => [of.triangle; CHANNELS],
            Layer::Normal => floats(normals.lane(lane)),
            Layer::Position => {
                let about_eye = point.position.lane(lane);
                let place = |axis: usize| (view.eye[axis] + f64::from(about_eye[axis])) as f32;
                floats([place(0), place(1), place(2)])
            }
            Layer::Barycentric => floats(interpolated.weights.map(|weight| weight[lane])),
            Layer::Uv => floats([uv[0][lane], uv[1][lane], 0.0]),
        };
    }
    values
}
