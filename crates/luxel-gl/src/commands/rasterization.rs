//! State of points, lines and polygons (OpenGL 1.5, sections 3.3 to 3.5).

use crate::Context;
use crate::context::{compile, demand, first_values, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;
use crate::pixels::store::{read_stipple, stipple_bytes, write_stipple};

impl Context {
    /// `glCullFace`.
    pub fn cull_face(&mut self, mode: u32) {
        compile!(self, Command::CullFace(mode));
        outside_begin!(self);
        let is_face = matches!(mode, gl::FRONT | gl::BACK | gl::FRONT_AND_BACK);
        demand!(self, is_face, gl::INVALID_ENUM);
        self.state.polygons.cull = mode;
    }

    /// `glFrontFace`.
    pub fn front_face(&mut self, mode: u32) {
        compile!(self, Command::FrontFace(mode));
        outside_begin!(self);
        demand!(self, matches!(mode, gl::CW | gl::CCW), gl::INVALID_ENUM);
        self.state.polygons.front = mode;
    }

    /// `glPolygonMode`: filled, as lines or as points, for each side.
    pub fn polygon_mode(&mut self, face: u32, mode: u32) {
        compile!(self, Command::PolygonMode(face, mode));
        outside_begin!(self);
        let is_face = matches!(face, gl::FRONT | gl::BACK | gl::FRONT_AND_BACK);
        let is_mode = matches!(mode, gl::POINT | gl::LINE | gl::FILL);
        demand!(self, is_face && is_mode, gl::INVALID_ENUM);
        if face != gl::BACK {
            self.state.polygons.modes[0] = mode;
        }
        if face != gl::FRONT {
            self.state.polygons.modes[1] = mode;
        }
    }

    /// `glPolygonOffset`.
    pub fn polygon_offset(&mut self, factor: f32, units: f32) {
        compile!(self, Command::PolygonOffset([factor, units]));
        outside_begin!(self);
        self.state.polygons.offset_factor = factor;
        self.state.polygons.offset_units = units;
    }

    /// `glPolygonStipple`: 32x32 bits, unpacked by `glPixelStore`; [`stipple_bytes`](Self::stipple_bytes) of
    /// them.
    pub fn polygon_stipple(&mut self, pattern: &[u8]) {
        self.set_polygon_stipple(read_stipple(pattern, &self.client.unpack));
    }

    pub(crate) fn set_polygon_stipple(&mut self, stipple: [u32; 32]) {
        compile!(self, Command::PolygonStipple(Box::new(stipple)));
        outside_begin!(self);
        self.state.polygons.stipple = stipple;
    }

    /// `glGetPolygonStipple`, packed by `glPixelStore`.
    pub fn get_polygon_stipple(&mut self, pattern: &mut [u8]) {
        outside_begin!(self);
        write_stipple(&self.state.polygons.stipple, &self.client.pack, pattern);
    }

    /// Bytes that `glPolygonStipple` reads, or `glGetPolygonStipple` writes where `pack` is set.
    #[must_use]
    pub fn stipple_bytes(&self, pack: bool) -> usize {
        let store = if pack { &self.client.pack } else { &self.client.unpack };
        stipple_bytes(store)
    }

    /// `glLineWidth`, in pixels. `GL_INVALID_VALUE` unless it is above 0.
    pub fn line_width(&mut self, width: f32) {
        compile!(self, Command::LineWidth(width));
        outside_begin!(self);
        demand!(self, width > 0.0, gl::INVALID_VALUE);
        self.state.lines.width = width;
    }

    /// `glLineStipple`: each bit of the pattern, the lowest first, stands for `factor` pixels, 1 to 256.
    pub fn line_stipple(&mut self, factor: i32, pattern: u16) {
        compile!(self, Command::LineStipple(factor, pattern));
        outside_begin!(self);
        self.state.lines.factor = factor.clamp(1, 256);
        self.state.lines.pattern = pattern;
    }

    /// `glPointSize`, in pixels. `GL_INVALID_VALUE` unless it is above 0.
    pub fn point_size(&mut self, size: f32) {
        compile!(self, Command::PointSize(size));
        outside_begin!(self);
        demand!(self, size > 0.0, gl::INVALID_VALUE);
        self.state.points.size = size;
    }

    /// `glPointParameter`.
    pub fn point_parameter(&mut self, pname: u32, params: &[f32]) {
        compile!(self, Command::PointParameter(pname, first_values(params)));
        outside_begin!(self);
        let values: [f32; 3] = first_values(params);
        let points = &mut self.state.points;
        let field = match pname {
            gl::POINT_DISTANCE_ATTENUATION => {
                points.attenuation = values;
                return;
            }
            gl::POINT_SIZE_MIN => &mut points.least,
            gl::POINT_SIZE_MAX => &mut points.largest,
            gl::POINT_FADE_THRESHOLD_SIZE => &mut points.fade,
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return;
            }
        };
        if values[0] >= 0.0 {
            *field = values[0];
        } else {
            self.error.set(gl::INVALID_VALUE);
        }
    }
}
