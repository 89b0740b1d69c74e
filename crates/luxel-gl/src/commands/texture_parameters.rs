//! `glTexParameter` (OpenGL 1.5, section 3.8.4, table 3.19).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, demand, first_values, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;
use crate::texture::{Parameters, Target, locked};

/// Whether a name is one of the eight comparisons.
pub(super) fn is_comparison(name: u32) -> bool {
    (gl::NEVER..=gl::ALWAYS).contains(&name)
}

/// Sets a parameter; an error for a value that it can't have.
fn set(parameters: &mut Parameters, pname: u32, values: &[f32]) -> Result<(), u32> {
    let value = values.first().copied().unwrap_or(0.0);
    let name = value as u32;
    let among = |names: &[u32]| {
        if names.contains(&name) { Ok(name) } else { Err(gl::INVALID_ENUM) }
    };
    let level = || {
        let level = value.round() as i32;
        if level < 0 { Err(gl::INVALID_VALUE) } else { Ok(level) }
    };
    match pname {
        gl::TEXTURE_WRAP_S | gl::TEXTURE_WRAP_T | gl::TEXTURE_WRAP_R => {
            let axis = match pname {
                gl::TEXTURE_WRAP_S => 0,
                gl::TEXTURE_WRAP_T => 1,
                _ => 2,
            };
            parameters.wrap[axis] = among(&[
                gl::CLAMP,
                gl::REPEAT,
                gl::CLAMP_TO_EDGE,
                gl::CLAMP_TO_BORDER,
                gl::MIRRORED_REPEAT,
            ])?;
        }
        gl::TEXTURE_MIN_FILTER => {
            parameters.minify = among(&[
                gl::NEAREST,
                gl::LINEAR,
                gl::NEAREST_MIPMAP_NEAREST,
                gl::NEAREST_MIPMAP_LINEAR,
                gl::LINEAR_MIPMAP_NEAREST,
                gl::LINEAR_MIPMAP_LINEAR,
            ])?;
        }
        gl::TEXTURE_MAG_FILTER => parameters.magnify = among(&[gl::NEAREST, gl::LINEAR])?,
        gl::TEXTURE_BORDER_COLOR => parameters.border = first_values(values).map(unit),
        gl::TEXTURE_PRIORITY => parameters.priority = unit(value),
        gl::TEXTURE_MIN_LOD => parameters.least_lod = value,
        gl::TEXTURE_MAX_LOD => parameters.largest_lod = value,
        gl::TEXTURE_BASE_LEVEL => parameters.base_level = level()?,
        gl::TEXTURE_MAX_LEVEL => parameters.max_level = level()?,
        gl::TEXTURE_LOD_BIAS => parameters.lod_bias = value,
        gl::DEPTH_TEXTURE_MODE => {
            parameters.depth_mode = among(&[gl::LUMINANCE, gl::INTENSITY, gl::ALPHA])?;
        }
        gl::TEXTURE_COMPARE_MODE => {
            parameters.compare_mode = among(&[gl::NONE, gl::COMPARE_R_TO_TEXTURE])?;
        }
        gl::TEXTURE_COMPARE_FUNC if is_comparison(name) => parameters.compare_func = name,
        gl::GENERATE_MIPMAP => parameters.generate_mipmap = value != 0.0,
        _ => return Err(gl::INVALID_ENUM),
    }
    Ok(())
}

impl Context {
    /// `glTexParameter`: of the texture that is bound to a target of the active unit.
    pub fn tex_parameter(&mut self, target: u32, pname: u32, values: &[f32]) {
        compile!(self, Command::TexParameter(target, pname, first_values(values)));
        outside_begin!(self);
        let Some(target) = Target::named(target) else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        // One value is no border's colour, but for a list, as in Mesa.
        let too_few = pname == gl::TEXTURE_BORDER_COLOR && values.len() < 4;
        let sound = !values.is_empty() && (!too_few || self.is_compiling());
        demand!(self, sound, gl::INVALID_ENUM);
        let texture = self.active_texture_of(target);
        let mut texture = locked(&texture);
        let mut parameters = *texture.parameters();
        match set(&mut parameters, pname, values) {
            Ok(()) if parameters != *texture.parameters() => {
                *texture.parameters_mut() = parameters;
            }
            Ok(()) => {}
            Err(error) => self.error.set(error),
        }
    }
}
