//! Layers: names, channels and values.

use std::fmt;
use std::str::FromStr;

/// The content of a layer. Exhaustive, so that no renderer forgets a new one.
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
    /// factor s; 0 where nothing is. `Ambient`, `Diffuse`, `Specular`, `Emission`, `Environment`
    /// and `Fog` add up to the colour before clamping.
    Ambient,
    /// The diffuse terms of all lights.
    Diffuse,
    /// The specular terms of all lights.
    Specular,
    /// Emitted light.
    Emission,
    /// The reflected environment.
    Environment,
    /// The fog term: (1 - s) I_dc.
    Fog,
    /// N.L of the first directional, point or spot light, negative where it is behind; 0 where
    /// nothing is.
    NDotL,
    /// Openness, the factor of ambient light by ambient occlusion; 1 without it, 0 where nothing is.
    Openness,
    /// V of the light of this name: the part of it that nothing keeps away; 1 without shadows, 0 where
    /// nothing is.
    Shadow(String),
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
    /// How many values there are.
    #[must_use]
    pub fn len(&self) -> usize {
        match self {
            Self::F32(values) => values.len(),
            Self::U32(values) => values.len(),
        }
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Layer {
    /// All layers but those of single lights.
    pub const ALL: [Self; 16] = [
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
        Self::Openness,
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
            Self::Openness => "openness",
            Self::Shadow(name) => return format!("{SHADOW}{name}"),
            Self::Light(name) => return format!("{LIGHT}{name}"),
        };
        name.to_owned()
    }

    /// Values a pixel.
    #[must_use]
    pub const fn channels(&self) -> usize {
        match self {
            Self::Depth | Self::Z | Self::Object | Self::Triangle | Self::NDotL => 1,
            Self::Openness | Self::Shadow(_) => 1,
            Self::Uv => 2,
            _ => 3,
        }
    }

    /// Whether the values are whole numbers.
    #[must_use]
    pub const fn is_id(&self) -> bool {
        matches!(self, Self::Object | Self::Triangle)
    }

    /// Whether it is a term of the colour: a sum over all surfaces that blend at a pixel, each by its alpha
    /// and by what those before it let through.
    #[must_use]
    pub fn is_summed(&self) -> bool {
        self.is_lit() && !matches!(self, Self::NDotL | Self::Openness | Self::Shadow(_))
    }

    /// Whether it takes the lighting equation.
    #[must_use]
    pub fn is_lit(&self) -> bool {
        match self {
            Self::Ambient | Self::Diffuse | Self::Specular | Self::Emission => true,
            Self::Environment | Self::Fog | Self::NDotL | Self::Light(_) => true,
            Self::Openness | Self::Shadow(_) => true,
            Self::Depth | Self::Z | Self::Normal | Self::Position | Self::Object => false,
            Self::Triangle | Self::Barycentric | Self::Uv => false,
        }
    }
}

/// A name that is not a layer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ParseLayerError(String);

impl fmt::Display for ParseLayerError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = Layer::ALL.map(|layer| layer.name()).join(", ");
        write!(formatter, "`{}` is not a layer: use {names}, {SHADOW}NAME or {LIGHT}NAME", self.0)
    }
}

impl std::error::Error for ParseLayerError {}

impl FromStr for Layer {
    type Err = ParseLayerError;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        if let Some(light) = name.strip_prefix(LIGHT) {
            return Ok(Self::Light(light.to_owned()));
        }
        if let Some(light) = name.strip_prefix(SHADOW) {
            return Ok(Self::Shadow(light.to_owned()));
        }
        if name == "ao" {
            return Ok(Self::Openness);
        }
        let found = Self::ALL.into_iter().find(|layer| layer.name() == name);
        found.ok_or_else(|| ParseLayerError(name.to_owned()))
    }
}

/// The prefix of the layers of single lights' shadows.
const SHADOW: &str = "shadow:";

/// The prefix of the layers of single lights.
const LIGHT: &str = "light:";
