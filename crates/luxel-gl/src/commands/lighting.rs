//! Lights, materials, fog (OpenGL 1.5, sections 2.13 and 3.10).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, demand, first_values, outside_begin};
use crate::enums as gl;
use crate::lengths;
use crate::limits::LIGHTS;
use crate::objects::list::Command;
use crate::state::material::ColorMaterial;
use crate::values::Values;
use glam::DVec4;

/// A symbolic constant that came as a floating-point number.
fn as_name(value: f32) -> u32 {
    value as u32
}

impl Context {
    /// `glLight`. Positions are transformed by the modelview matrix of now, directions of spots by its upper left
    /// part.
    pub fn light(&mut self, light: u32, pname: u32, params: &[f32]) {
        compile!(self, Command::Light(light, pname, first_values(params)));
        outside_begin!(self);
        let number = light.wrapping_sub(gl::LIGHT0) as usize;
        demand!(self, number < LIGHTS && lengths::light(pname) > 0, gl::INVALID_ENUM);
        let values: [f32; 4] = first_values(params);
        let [x, y, z, w] = values;
        match pname {
            gl::SPOT_EXPONENT => {
                demand!(self, (0.0..=128.0).contains(&x), gl::INVALID_VALUE);
            }
            gl::SPOT_CUTOFF => {
                demand!(self, (0.0..=90.0).contains(&x) || x == 180.0, gl::INVALID_VALUE);
            }
            gl::CONSTANT_ATTENUATION | gl::LINEAR_ATTENUATION | gl::QUADRATIC_ATTENUATION => {
                demand!(self, x >= 0.0, gl::INVALID_VALUE);
            }
            _ => {}
        }
        let eye_from_object = self.matrices.modelview.top;
        let in_eye = |w: f32| {
            (eye_from_object * DVec4::new(f64::from(x), f64::from(y), f64::from(z), f64::from(w)))
                .as_vec4()
                .to_array()
        };
        let source = &mut self.state.lights.sources[number];
        match pname {
            gl::AMBIENT => source.ambient = values,
            gl::DIFFUSE => source.diffuse = values,
            gl::SPECULAR => source.specular = values,
            gl::POSITION => source.position = in_eye(w),
            gl::SPOT_DIRECTION => source.spot_direction = first_values(&in_eye(0.0)),
            gl::SPOT_EXPONENT => source.spot_exponent = x,
            gl::SPOT_CUTOFF => source.spot_cutoff = x,
            gl::CONSTANT_ATTENUATION => source.attenuation[0] = x,
            gl::LINEAR_ATTENUATION => source.attenuation[1] = x,
            _ => source.attenuation[2] = x,
        }
    }

    /// `glGetLight`.
    pub fn get_light(&mut self, light: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let number = light.wrapping_sub(gl::LIGHT0) as usize;
        let source = self.state.lights.sources.get(number);
        let found = source.and_then(|source| {
            Some(match pname {
                gl::AMBIENT => Values::scaled(source.ambient),
                gl::DIFFUSE => Values::scaled(source.diffuse),
                gl::SPECULAR => Values::scaled(source.specular),
                gl::POSITION => Values::reals(source.position),
                gl::SPOT_DIRECTION => Values::reals(source.spot_direction),
                gl::SPOT_EXPONENT => Values::real(source.spot_exponent),
                gl::SPOT_CUTOFF => Values::real(source.spot_cutoff),
                gl::CONSTANT_ATTENUATION => Values::real(source.attenuation[0]),
                gl::LINEAR_ATTENUATION => Values::real(source.attenuation[1]),
                gl::QUADRATIC_ATTENUATION => Values::real(source.attenuation[2]),
                _ => return None,
            })
        });
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found
    }

    /// `glLightModel`.
    pub fn light_model(&mut self, pname: u32, params: &[f32]) {
        compile!(self, Command::LightModel(pname, first_values(params)));
        outside_begin!(self);
        let values: [f32; 4] = first_values(params);
        let model = &mut self.state.lights.model;
        match pname {
            gl::LIGHT_MODEL_AMBIENT => model.ambient = values,
            gl::LIGHT_MODEL_LOCAL_VIEWER => model.local_viewer = values[0] != 0.0,
            gl::LIGHT_MODEL_TWO_SIDE => model.two_side = values[0] != 0.0,
            gl::LIGHT_MODEL_COLOR_CONTROL => {
                let control = as_name(values[0]);
                let is_control = matches!(control, gl::SINGLE_COLOR | gl::SEPARATE_SPECULAR_COLOR);
                demand!(self, is_control, gl::INVALID_ENUM);
                model.color_control = control;
            }
            _ => self.error.set(gl::INVALID_ENUM),
        }
    }

    /// `glMaterial`, also between vertices. A property that the current colour drives stays as it is.
    pub fn material(&mut self, face: u32, pname: u32, params: &[f32]) {
        compile!(self, Command::Material(face, pname, first_values(params)));
        if self.stream.is_waiting() {
            self.draw_waiting();
        }
        let is_face = matches!(face, gl::FRONT | gl::BACK | gl::FRONT_AND_BACK);
        demand!(self, is_face && lengths::material(pname) > 0, gl::INVALID_ENUM);
        let values: [f32; 4] = first_values(params);
        let shines = pname != gl::SHININESS || (0.0..=128.0).contains(&values[0]);
        demand!(self, shines, gl::INVALID_VALUE);
        for side in 0..2 {
            if face != gl::FRONT_AND_BACK && (face == gl::BACK) != (side == 1) {
                continue;
            }
            self.state.materials[side].set(pname, &values);
        }
        if self.state.enables.has(gl::COLOR_MATERIAL) {
            self.color_drives_material();
        }
        if self.stream.is_open() {
            self.stream.set_materials(self.state.materials);
        }
    }

    /// `glGetMaterial`, of `GL_FRONT` or `GL_BACK`.
    pub fn get_material(&mut self, face: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let side = match face {
            gl::FRONT => Some(&self.state.materials[0]),
            gl::BACK => Some(&self.state.materials[1]),
            _ => None,
        };
        let found = side.and_then(|side| {
            Some(match pname {
                gl::AMBIENT => Values::scaled(side.ambient),
                gl::DIFFUSE => Values::scaled(side.diffuse),
                gl::SPECULAR => Values::scaled(side.specular),
                gl::EMISSION => Values::scaled(side.emission),
                gl::SHININESS => Values::real(side.shininess),
                gl::COLOR_INDEXES => Values::reals(side.indexes),
                _ => return None,
            })
        });
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found
    }

    /// `glColorMaterial`: which properties follow the current colour while `GL_COLOR_MATERIAL` is enabled.
    pub fn color_material(&mut self, face: u32, mode: u32) {
        compile!(self, Command::ColorMaterial(face, mode));
        outside_begin!(self);
        let is_face = matches!(face, gl::FRONT | gl::BACK | gl::FRONT_AND_BACK);
        let is_mode = mode != gl::SHININESS && lengths::material(mode) == 4;
        demand!(self, is_face && is_mode, gl::INVALID_ENUM);
        self.state.color_material = ColorMaterial { face, mode };
        if self.state.enables.has(gl::COLOR_MATERIAL) {
            self.color_drives_material();
        }
    }

    /// `glShadeModel`: smooth or flat.
    pub fn shade_model(&mut self, mode: u32) {
        compile!(self, Command::ShadeModel(mode));
        outside_begin!(self);
        demand!(self, matches!(mode, gl::FLAT | gl::SMOOTH), gl::INVALID_ENUM);
        self.state.lights.shade_model = mode;
    }

    /// `glFog`.
    pub fn fog(&mut self, pname: u32, params: &[f32]) {
        compile!(self, Command::Fog(pname, first_values(params)));
        outside_begin!(self);
        let values: [f32; 4] = first_values(params);
        let fog = &mut self.state.fog;
        match pname {
            gl::FOG_COLOR => fog.color = values.map(unit),
            gl::FOG_START => fog.start = values[0],
            gl::FOG_END => fog.end = values[0],
            gl::FOG_INDEX => fog.index = values[0],
            gl::FOG_DENSITY => {
                demand!(self, values[0] >= 0.0, gl::INVALID_VALUE);
                fog.density = values[0];
            }
            gl::FOG_MODE => {
                let mode = as_name(values[0]);
                demand!(self, matches!(mode, gl::EXP | gl::EXP2 | gl::LINEAR), gl::INVALID_ENUM);
                fog.mode = mode;
            }
            gl::FOG_COORD_SRC => {
                let source = as_name(values[0]);
                let is_source = matches!(source, gl::FRAGMENT_DEPTH | gl::FOG_COORD);
                demand!(self, is_source, gl::INVALID_ENUM);
                fog.source = source;
            }
            _ => self.error.set(gl::INVALID_ENUM),
        }
    }
}
