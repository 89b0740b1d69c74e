//! Lights and the lighting model (OpenGL 1.5, section 2.13.1, table 2.10).

use crate::enums as gl;
use crate::limits::LIGHTS;

/// One light, in eye coordinates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightSource {
    pub(crate) ambient: [f32; 4],
    pub(crate) diffuse: [f32; 4],
    pub(crate) specular: [f32; 4],
    pub(crate) position: [f32; 4],
    pub(crate) spot_direction: [f32; 3],
    pub(crate) spot_exponent: f32,
    /// Degrees: 0 to 90, or 180.
    pub(crate) spot_cutoff: f32,
    pub(crate) attenuation: [f32; 3],
}

/// The lighting model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightModel {
    pub(crate) ambient: [f32; 4],
    pub(crate) local_viewer: bool,
    pub(crate) two_side: bool,
    pub(crate) color_control: u32,
}

/// All of it.
#[derive(Clone, Debug)]
pub(crate) struct Lights {
    pub(crate) sources: [LightSource; LIGHTS],
    pub(crate) model: LightModel,
    pub(crate) shade_model: u32,
}

impl LightSource {
    fn new(number: usize) -> Self {
        let color = if number == 0 { [1.0; 4] } else { [0.0, 0.0, 0.0, 1.0] };
        Self {
            ambient: [0.0, 0.0, 0.0, 1.0],
            diffuse: color,
            specular: color,
            position: [0.0, 0.0, 1.0, 0.0],
            spot_direction: [0.0, 0.0, -1.0],
            spot_exponent: 0.0,
            spot_cutoff: 180.0,
            attenuation: [1.0, 0.0, 0.0],
        }
    }
}

impl Default for Lights {
    fn default() -> Self {
        Self {
            sources: std::array::from_fn(LightSource::new),
            model: LightModel {
                ambient: [0.2, 0.2, 0.2, 1.0],
                local_viewer: false,
                two_side: false,
                color_control: gl::SINGLE_COLOR,
            },
            shade_model: gl::SMOOTH,
        }
    }
}
