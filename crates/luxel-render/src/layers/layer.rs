//! What layers there are: names, channels, and the values of one.

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

impl LayerValues {
    /// A list of numbers, in the memory of these if they are such.
    pub(crate) fn as_f32(&mut self) -> &mut Vec<f32> {
        if matches!(self, Self::U32(_)) {
            *self = Self::F32(Vec::new());
        }
        match self {
            Self::F32(values) => values,
            Self::U32(_) => unreachable!("it was replaced"),
        }
    }

    /// A list of whole numbers, in the memory of these if they are such.
    pub(crate) fn as_u32(&mut self) -> &mut Vec<u32> {
        if matches!(self, Self::F32(_)) {
            *self = Self::U32(Vec::new());
        }
        match self {
            Self::U32(values) => values,
            Self::F32(_) => unreachable!("it was replaced"),
        }
    }
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
    pub(crate) fn is_lit(&self) -> bool {
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
