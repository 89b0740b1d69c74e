//! Texture environments and generated coordinates: `glTexEnv`, `glTexGen` (OpenGL 1.5, sections 2.10.4 and 3.8.13).

use crate::Context;
use crate::context::{compile, demand, first_values, outside_begin};
use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;
use crate::objects::list::Command;
use crate::state::texture_unit::Environment;

/// The place of a name that ends in 0, 1 or 2 and is of colours or alphas.
pub(super) fn argument(pname: u32, [rgb, alpha]: [u32; 2]) -> Option<(usize, usize)> {
    [rgb, alpha].into_iter().enumerate().find_map(|(of, first)| {
        let number = pname.wrapping_sub(first);
        (number < 3).then_some((of, number as usize))
    })
}

/// The names of sources and of operands, of colours and of alphas.
pub(super) const SOURCES: [u32; 2] = [gl::SRC0_RGB, gl::SRC0_ALPHA];
pub(super) const OPERANDS: [u32; 2] = [gl::OPERAND0_RGB, gl::OPERAND0_ALPHA];

/// Sets a value of an environment; an error for one that it can't have.
fn set(environment: &mut Environment, pname: u32, values: &[f32]) -> Result<(), u32> {
    let value = values.first().copied().unwrap_or(0.0);
    let name = value as u32;
    let among = |names: &[u32]| {
        if names.contains(&name) { Ok(name) } else { Err(gl::INVALID_ENUM) }
    };
    let functions =
        [gl::REPLACE, gl::MODULATE, gl::ADD, gl::ADD_SIGNED, gl::INTERPOLATE, gl::SUBTRACT];
    let scale = || {
        if [1.0, 2.0, 4.0].contains(&value) { Ok(value) } else { Err(gl::INVALID_VALUE) }
    };
    match pname {
        gl::TEXTURE_ENV_MODE => {
            environment.mode =
                among(&[gl::MODULATE, gl::DECAL, gl::BLEND, gl::REPLACE, gl::ADD, gl::COMBINE])?;
        }
        gl::TEXTURE_ENV_COLOR => {
            environment.color = first_values(values).map(super::fragments::unit);
        }
        gl::COMBINE_RGB if matches!(name, gl::DOT3_RGB | gl::DOT3_RGBA) => {
            environment.combine[0] = name;
        }
        gl::COMBINE_RGB => environment.combine[0] = among(&functions)?,
        gl::COMBINE_ALPHA => environment.combine[1] = among(&functions)?,
        gl::RGB_SCALE => environment.scales[0] = scale()?,
        gl::ALPHA_SCALE => environment.scales[1] = scale()?,
        _ => {
            if let Some((of, number)) = argument(pname, SOURCES) {
                let unit = name.wrapping_sub(gl::TEXTURE0) < TEXTURE_UNITS as u32;
                let known = [gl::TEXTURE, gl::CONSTANT, gl::PRIMARY_COLOR, gl::PREVIOUS];
                environment.sources[of][number] = if unit { name } else { among(&known)? };
            } else if let Some((of, number)) = argument(pname, OPERANDS) {
                let of_alpha = [gl::SRC_ALPHA, gl::ONE_MINUS_SRC_ALPHA];
                let of_color = [gl::SRC_COLOR, gl::ONE_MINUS_SRC_COLOR];
                let is_color = of == 0 && of_color.contains(&name);
                environment.operands[of][number] = if is_color { name } else { among(&of_alpha)? };
            } else {
                return Err(gl::INVALID_ENUM);
            }
        }
    }
    Ok(())
}

impl Context {
    /// `glTexEnv`: of the active unit; `GL_TEXTURE_FILTER_CONTROL` has its bias of levels.
    pub fn tex_env(&mut self, target: u32, pname: u32, values: &[f32]) {
        compile!(self, Command::TexEnv(target, pname, first_values(values)));
        outside_begin!(self);
        demand!(self, !values.is_empty(), gl::INVALID_ENUM);
        let unit = &mut self.state.texture.units[self.state.active_texture];
        match (target, pname) {
            (gl::TEXTURE_FILTER_CONTROL, gl::TEXTURE_LOD_BIAS) => unit.lod_bias = values[0],
            (gl::TEXTURE_ENV, _) => {
                if let Err(error) = set(&mut unit.environment, pname, values) {
                    self.error.set(error);
                }
            }
            _ => self.error.set(gl::INVALID_ENUM),
        }
    }

    /// `glTexGen`: of `GL_S`, `GL_T`, `GL_R` or `GL_Q` of the active unit. A plane in eye coordinates is given in those
    /// of the modelview matrix of this moment.
    pub fn tex_gen(&mut self, coordinate: u32, pname: u32, values: &[f32]) {
        compile!(self, Command::TexGen(coordinate, pname, first_values(values)));
        outside_begin!(self);
        let axis = coordinate.wrapping_sub(gl::S) as usize;
        demand!(self, axis < 4 && !values.is_empty(), gl::INVALID_ENUM);
        let inverse = self.matrices.modelview.top.inverse();
        let unit = &mut self.state.texture.units[self.state.active_texture];
        let generator = &mut unit.generation.0[axis];
        match pname {
            gl::TEXTURE_GEN_MODE => {
                let mode = values[0] as u32;
                let allowed = match mode {
                    gl::OBJECT_LINEAR | gl::EYE_LINEAR => true,
                    gl::SPHERE_MAP => axis < 2,
                    gl::NORMAL_MAP | gl::REFLECTION_MAP => axis < 3,
                    _ => false,
                };
                demand!(self, allowed, gl::INVALID_ENUM);
                generator.mode = mode;
            }
            gl::OBJECT_PLANE => generator.object_plane = first_values(values),
            gl::EYE_PLANE => {
                // Of a matrix without inverse the result is undefined: the plane stays what it is.
                let plane = glam::DVec4::from(first_values::<f32, 4>(values).map(f64::from));
                if inverse.is_finite() {
                    let moved = inverse.transpose() * plane;
                    generator.eye_plane = moved.to_array().map(|value| value as f32);
                }
            }
            _ => self.error.set(gl::INVALID_ENUM),
        }
    }
}
