//! Layers: what the picture is made of, one value or three a pixel, taken at the pixel's centre and
//! never averaged.

use crate::explain::Lit;
use crate::shade::{Batch, Kept, Scene16, interpolate};
use crate::surface::{self, Interpolated};
use crate::tiles::TilePixels;
use crate::worker::{ALL_BLOCKS, place_in_tile};
use luxel_lighting::LightTerms;
use luxel_math::{LANES, Simd, f32x16, prelude::*};
use luxel_scene::{Projection, SceneLight};
use luxel_visibility::{Tile, TriangleId};
use std::str::FromStr;

/// What a layer shows.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
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
    /// The ambient terms of the scene and of all lights. Terms are linear light, times the fog's
    /// factor s; 0 where nothing is. `Ambient`, `Diffuse`, `Specular`, `Emission`, `Environment` and
    /// `Fog` add up to the colour before clamping.
    Ambient,
    /// The diffuse terms of all lights.
    Diffuse,
    /// The specular terms of all lights.
    Specular,
    /// What surfaces send of their own.
    Emission,
    /// What surfaces mirror of the environment.
    Environment,
    /// What the fog adds: (1 - s) I_dc.
    Fog,
    /// N.L of the first directional, point or spot light, negative where it stands behind; 0 where
    /// nothing is.
    NDotL,
    /// The ambient, diffuse and specular term of the light of this name.
    Light(String),
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
    /// All layers but those of single lights.
    pub const ALL: [Self; 15] = [
        Self::Depth,
        Self::Z,
        Self::Normal,
        Self::Position,
        Self::Object,
        Self::Triangle,
        Self::Barycentric,
        Self::Uv,
        Self::Ambient,
        Self::Diffuse,
        Self::Specular,
        Self::Emission,
        Self::Environment,
        Self::Fog,
        Self::NDotL,
    ];

    /// The name.
    #[must_use]
    pub fn name(&self) -> String {
        let name = match self {
            Self::Depth => "depth",
            Self::Z => "z",
            Self::Normal => "normal",
            Self::Position => "position",
            Self::Object => "object",
            Self::Triangle => "triangle",
            Self::Barycentric => "barycentric",
            Self::Uv => "uv",
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Emission => "emission",
            Self::Environment => "environment",
            Self::Fog => "fog",
            Self::NDotL => "n_dot_l",
            Self::Light(name) => return format!("{LIGHT}{name}"),
        };
        name.to_owned()
    }

    /// Values a pixel.
    #[must_use]
    pub const fn channels(&self) -> usize {
        match self {
            Self::Depth | Self::Z | Self::Object | Self::Triangle | Self::NDotL => 1,
            Self::Uv => 2,
            _ => 3,
        }
    }

    /// Whether the values are whole numbers.
    #[must_use]
    pub const fn is_id(&self) -> bool {
        matches!(self, Self::Object | Self::Triangle)
    }

    /// Whether it takes the lighting equation.
    fn is_lit(&self) -> bool {
        match self {
            Self::Ambient | Self::Diffuse | Self::Specular | Self::Emission => true,
            Self::Environment | Self::Fog | Self::NDotL | Self::Light(_) => true,
            Self::Depth | Self::Z | Self::Normal | Self::Position | Self::Object => false,
            Self::Triangle | Self::Barycentric | Self::Uv => false,
        }
    }
}

/// A name that is no layer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "`{0}` is no layer: use depth, z, normal, position, object, triangle, barycentric, uv, ambient, \
     diffuse, specular, emission, environment, fog, n_dot_l or light:NAME"
)]
pub struct ParseLayerError(String);

impl FromStr for Layer {
    type Err = ParseLayerError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        if let Some(light) = name.strip_prefix(LIGHT) {
            return Ok(Self::Light(light.to_owned()));
        }
        let found = Self::ALL.into_iter().find(|layer| layer.name() == name);
        found.ok_or_else(|| ParseLayerError(name.to_owned()))
    }
}

/// What the names of single lights' layers begin with.
const LIGHT: &str = "light:";

/// Most channels of a layer.
const CHANNELS: usize = 3;

/// The bits of a layer's values at one pixel.
pub(crate) type LayerPixel = [u32; CHANNELS];

/// Everything that layers need beside the surfaces.
pub(crate) struct LayerView<'a> {
    /// The lights that have terms.
    pub(crate) lights: Vec<&'a SceneLight>,
    pub(crate) projection: Projection,
    /// The eye's place in the world, f64, which positions are about.
    pub(crate) eye: [f64; 3],
}

impl LayerView<'_> {
    fn depth(&self, z: f32) -> f32 {
        self.projection.window_depth(f64::from(z)) as f32
    }
}

/// Writes one layer of all blocks of a tile.
#[inline(always)]
pub(crate) fn tile_layer<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    view: &LayerView<'_>,
    layer: &Layer,
    tile: &Tile,
    kept: &mut Kept,
    pixels: &mut TilePixels<LayerPixel>,
) {
    for block in 0..ALL_BLOCKS {
        let values = layers_of_block(simd, scene, view, layer, tile, block, kept);
        for (lane, value) in values.into_iter().enumerate() {
            pixels[place_in_tile(block, lane)] = value;
        }
    }
}

/// The values of a layer for one block of a tile of one sample a pixel.
#[inline(always)]
fn layers_of_block<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    view: &LayerView<'_>,
    layer: &Layer,
    tile: &Tile,
    block: usize,
    kept: &mut Kept,
) -> [LayerPixel; LANES] {
    let ids = tile.planes()[0].ids[block];
    let batch = Batch::new(tile, block, ids, &[0; LANES], scene.frame.samples());
    let mut interpolated = Interpolated::nothing(f32x16::splat(simd, 0.0));
    interpolate(scene, &batch, kept, &mut interpolated);
    let point = surface::point(scene, interpolated.varying.position, interpolated.varying.normal);
    let z = point.depth;
    let normals = match layer {
        Layer::Normal => surface::shading_normals(scene, &interpolated, &point),
        _ => point.normal,
    };
    let [uv, ..] = interpolated.varying.uv(0);
    let mut values = [[0; CHANNELS]; LANES];
    if layer.is_lit() {
        for (lane, value) in values.iter_mut().enumerate() {
            let term = lit_value(scene, view, layer, &batch.only(lane), kept);
            *value = term.map(f32::to_bits);
        }
        return values;
    }
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
            // Lit ones have been told above.
            _ => [0; CHANNELS],
        };
    }
    values
}

/// The value of a term at one sample; 0 where nothing is seen.
fn lit_value(
    scene: &Scene16<'_>,
    view: &LayerView<'_>,
    layer: &Layer,
    batch: &Batch,
    kept: &mut Kept,
) -> [f32; CHANNELS] {
    let Some(lit) = Lit::of(scene, view.eye, &view.lights, batch, kept) else {
        return [0.0; CHANNELS];
    };
    let plus = |a: [f32; 3], b: [f32; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let terms = &lit.terms;
    let each = |of: fn(&LightTerms<f32>) -> [f32; 3], first: [f32; 3]| {
        terms.lights.iter().fold(first, |sum, light| plus(sum, of(&light.terms)))
    };
    let (factor, fog) = lit.fog.unwrap_or((1.0, [0.0; 3]));
    let term = match layer {
        Layer::Ambient => each(|terms| terms.ambient.lane(0), terms.scene_ambient),
        Layer::Diffuse => each(|terms| terms.diffuse.lane(0), [0.0; 3]),
        Layer::Specular => each(|terms| terms.specular.lane(0), [0.0; 3]),
        Layer::Emission => terms.emission,
        Layer::Environment => terms.environment,
        Layer::Fog => return fog.map(|channel| channel * (1.0 - factor)),
        Layer::NDotL => {
            return [terms.lights.first().map_or(0.0, |light| light.terms.n_dot_l); CHANNELS];
        }
        Layer::Light(name) => {
            let light = terms.lights.iter().find(|light| light.name == *name);
            light.map_or([0.0; 3], |light| {
                let LightTerms { ambient, diffuse, specular, .. } = &light.terms;
                plus(plus(ambient.lane(0), diffuse.lane(0)), specular.lane(0))
            })
        }
        _ => [0.0; 3],
    };
    term.map(|channel| channel * factor)
}
