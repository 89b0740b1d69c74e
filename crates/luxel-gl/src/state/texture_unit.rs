//! Texture units: bindings, environments, generated coordinates (OpenGL 1.5, tables 6.15, 6.17, 6.18).

use super::texgen::Generation;
use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;
use crate::texture::{Parameters, Target, TextureHandle, locked};

/// How a unit's texel and the fragment's colour are combined (section 3.8.13).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Environment {
    pub(crate) mode: u32,
    pub(crate) color: [f32; 4],
    /// The functions of colours and alphas with `GL_COMBINE`.
    pub(crate) combine: [u32; 2],
    /// Of colours and alphas three sources.
    pub(crate) sources: [[u32; 3]; 2],
    pub(crate) operands: [[u32; 3]; 2],
    pub(crate) scales: [f32; 2],
}

impl Default for Environment {
    fn default() -> Self {
        Self {
            mode: gl::MODULATE,
            color: [0.0; 4],
            combine: [gl::MODULATE; 2],
            sources: [[gl::TEXTURE, gl::PREVIOUS, gl::CONSTANT]; 2],
            operands: [[gl::SRC_COLOR, gl::SRC_COLOR, gl::SRC_ALPHA], [gl::SRC_ALPHA; 3]],
            scales: [1.0; 2],
        }
    }
}

/// One unit.
#[derive(Clone, Debug, Default)]
pub(crate) struct TextureUnit {
    pub(crate) environment: Environment,
    /// `GL_TEXTURE_LOD_BIAS` of `GL_TEXTURE_FILTER_CONTROL`.
    pub(crate) lod_bias: f32,
    pub(crate) generation: Generation,
    /// The texture of each target; `None` for the one of name 0.
    pub(crate) bound: [Option<TextureHandle>; 4],
}

impl TextureUnit {
    /// The texture of a target; `None` for the one of name 0.
    pub(crate) fn bound(&self, target: Target) -> Option<&TextureHandle> {
        self.bound[target as usize].as_ref()
    }
}

/// All units.
#[derive(Clone, Debug, Default)]
pub(crate) struct TextureState {
    pub(crate) units: [TextureUnit; TEXTURE_UNITS],
    /// Of a copy that `glPushAttrib` keeps: the bound textures' parameters.
    saved: Vec<(TextureHandle, Parameters)>,
}

impl TextureState {
    /// Notes the parameters of bound textures, which `glPopAttrib` brings back (section 6.1.13).
    pub(crate) fn note_parameters(&mut self, defaults: impl Fn(Target) -> TextureHandle) {
        self.saved.clear();
        for unit in &self.units {
            for target in Target::ALL {
                let texture =
                    unit.bound(target).map_or_else(|| defaults(target), TextureHandle::clone);
                let parameters = *locked(&texture).parameters();
                self.saved.push((texture, parameters));
            }
        }
    }

    /// Takes over units and parameters.
    pub(super) fn restore(&mut self, saved: &Self) {
        self.units.clone_from(&saved.units);
        for (texture, parameters) in &saved.saved {
            let mut texture = locked(texture);
            if texture.parameters() != parameters {
                *texture.parameters_mut() = *parameters;
            }
        }
    }
}
