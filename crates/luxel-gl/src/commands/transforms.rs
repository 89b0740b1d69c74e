//! Matrices, viewport, clip planes (OpenGL 1.5, sections 2.10 and 2.11).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::{CLIP_PLANES, TEXTURE_UNITS, VIEWPORT};
use crate::objects::list::Command;
use crate::state::fragment::PixelBox;
use crate::state::matrices::{Stack, frustum, ortho, rotation};
use crate::state::window::ClipControl;
use glam::{DMat4, DVec3, DVec4};

impl Context {
    /// `glMatrixMode`.
    pub fn matrix_mode(&mut self, mode: u32) {
        compile!(self, Command::MatrixMode(mode));
        outside_begin!(self);
        let is_mode = matches!(mode, gl::MODELVIEW | gl::PROJECTION | gl::TEXTURE);
        demand!(self, is_mode, gl::INVALID_ENUM);
        self.state.transform.matrix_mode = mode;
    }

    fn current_stack(&mut self) -> &mut Stack {
        let (mode, unit) = (self.state.transform.matrix_mode, self.state.active_texture);
        self.matrices.stack(mode, unit)
    }

    fn multiply(&mut self, matrix: DMat4) {
        let stack = self.current_stack();
        stack.set(stack.top * matrix);
    }

    /// `glLoadIdentity`.
    pub fn load_identity(&mut self) {
        compile!(self, Command::LoadIdentity);
        outside_begin!(self);
        self.current_stack().set(DMat4::IDENTITY);
    }

    /// `glLoadMatrix`, column by column.
    pub fn load_matrix(&mut self, matrix: &[f64; 16]) {
        compile!(self, Command::LoadMatrix(Box::new(*matrix)));
        outside_begin!(self);
        self.current_stack().set(DMat4::from_cols_array(matrix));
    }

    /// `glMultMatrix`: M' = M C.
    pub fn mult_matrix(&mut self, matrix: &[f64; 16]) {
        compile!(self, Command::MultMatrix(Box::new(*matrix)));
        outside_begin!(self);
        self.multiply(DMat4::from_cols_array(matrix));
    }

    /// `glLoadTransposeMatrix`, row by row.
    pub fn load_transpose_matrix(&mut self, matrix: &[f64; 16]) {
        self.load_matrix(&DMat4::from_cols_array(matrix).transpose().to_cols_array());
    }

    /// `glMultTransposeMatrix`, row by row.
    pub fn mult_transpose_matrix(&mut self, matrix: &[f64; 16]) {
        self.mult_matrix(&DMat4::from_cols_array(matrix).transpose().to_cols_array());
    }

    /// `glPushMatrix`. `GL_STACK_OVERFLOW` if the stack is full.
    pub fn push_matrix(&mut self) {
        compile!(self, Command::PushMatrix);
        outside_begin!(self);
        let (mode, unit) = (self.state.transform.matrix_mode, self.state.active_texture);
        if let Err(error) = self.matrices.push(mode, unit) {
            self.error.set(error);
        }
    }

    /// `glPopMatrix`. `GL_STACK_UNDERFLOW` if there is only one matrix.
    pub fn pop_matrix(&mut self) {
        compile!(self, Command::PopMatrix);
        outside_begin!(self);
        let (mode, unit) = (self.state.transform.matrix_mode, self.state.active_texture);
        if let Err(error) = self.matrices.pop(mode, unit) {
            self.error.set(error);
        }
    }

    /// `glRotate`: by an angle in degrees, counter-clockwise about an axis of any length.
    pub fn rotate(&mut self, angle: f64, x: f64, y: f64, z: f64) {
        compile!(self, Command::Rotate(Box::new([angle, x, y, z])));
        outside_begin!(self);
        if let Some(matrix) = rotation(angle, [x, y, z]) {
            self.multiply(matrix);
        }
    }

    /// `glScale`.
    pub fn scale(&mut self, x: f64, y: f64, z: f64) {
        compile!(self, Command::Scale(Box::new([x, y, z])));
        outside_begin!(self);
        let diagonal = DVec4::new(x, y, z, 1.0);
        self.multiply(DMat4::from_diagonal(diagonal));
    }

    /// `glTranslate`.
    pub fn translate(&mut self, x: f64, y: f64, z: f64) {
        compile!(self, Command::Translate(Box::new([x, y, z])));
        outside_begin!(self);
        self.multiply(DMat4::from_translation(DVec3::new(x, y, z)));
    }

    /// `glFrustum`. `GL_INVALID_VALUE` for a plane that isn't before the eye, or sides that are equal.
    pub fn frustum(&mut self, l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) {
        let sides = [l, r, b, t, n, f];
        compile!(self, Command::Frustum(Box::new(sides)));
        outside_begin!(self);
        match frustum(sides) {
            Some(matrix) => self.multiply(matrix),
            None => self.error.set(gl::INVALID_VALUE),
        }
    }

    /// `glOrtho`. `GL_INVALID_VALUE` for sides that are equal.
    pub fn ortho(&mut self, l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) {
        let sides = [l, r, b, t, n, f];
        compile!(self, Command::Ortho(Box::new(sides)));
        outside_begin!(self);
        match ortho(sides) {
            Some(matrix) => self.multiply(matrix),
            None => self.error.set(gl::INVALID_VALUE),
        }
    }

    /// `glViewport`: lower left corner and size; sizes are clamped to `GL_MAX_VIEWPORT_DIMS`.
    pub fn viewport(&mut self, x: i32, y: i32, width: i32, height: i32) {
        compile!(self, Command::Viewport([x, y, width, height]));
        outside_begin!(self);
        demand!(self, width >= 0 && height >= 0, gl::INVALID_VALUE);
        // So that sums of both are integers; nothing that far out is in any framebuffer.
        let place = |at: i32| at.clamp(-2 * VIEWPORT, 2 * VIEWPORT);
        self.state.viewport.area = PixelBox {
            x: place(x),
            y: place(y),
            width: width.min(VIEWPORT),
            height: height.min(VIEWPORT),
        };
    }

    /// `glDepthRange`, clamped to 0..1; the nearer plane may have the greater depth.
    pub fn depth_range(&mut self, near: f64, far: f64) {
        compile!(self, Command::DepthRange([near, far]));
        outside_begin!(self);
        let viewport = &mut self.state.viewport;
        (viewport.near, viewport.far) = (clamped(near), clamped(far));
    }

    /// `glClipControl`: whether y = -1 of normalized device coordinates is the lower or the upper side of the viewport,
    /// and whether the near plane lies at z = -1 or at 0 (ARB_clip_control).
    pub fn clip_control(&mut self, origin: u32, depth: u32) {
        compile!(self, Command::ClipControl(origin, depth));
        outside_begin!(self);
        let origins = [gl::LOWER_LEFT, gl::UPPER_LEFT];
        let depths = [gl::NEGATIVE_ONE_TO_ONE, gl::ZERO_TO_ONE];
        demand!(self, origins.contains(&origin) && depths.contains(&depth), gl::INVALID_ENUM);
        self.state.transform.clip = ClipControl {
            upper_left: origin == gl::UPPER_LEFT,
            zero_to_one: depth == gl::ZERO_TO_ONE,
        };
    }

    /// `glActiveTexture`.
    pub fn active_texture(&mut self, unit: u32) {
        compile!(self, Command::ActiveTexture(unit));
        outside_begin!(self);
        let number = unit.wrapping_sub(gl::TEXTURE0) as usize;
        demand!(self, number < TEXTURE_UNITS, gl::INVALID_ENUM);
        self.state.active_texture = number;
    }

    /// `glClientActiveTexture`.
    pub fn client_active_texture(&mut self, unit: u32) {
        outside_begin!(self);
        let number = unit.wrapping_sub(gl::TEXTURE0) as usize;
        demand!(self, number < TEXTURE_UNITS, gl::INVALID_ENUM);
        self.client.arrays.unit = number;
    }

    /// `glClipPlane`: what lies at p with p . x >= 0 stays. The plane is taken to eye coordinates by the modelview
    /// matrix of now: p' = p M^-1.
    pub fn clip_plane(&mut self, plane: u32, equation: [f64; 4]) {
        compile!(self, Command::ClipPlane(plane, Box::new(equation)));
        outside_begin!(self);
        let number = plane.wrapping_sub(gl::CLIP_PLANE0) as usize;
        demand!(self, number < CLIP_PLANES, gl::INVALID_ENUM);
        let object_from_eye = self.matrices.modelview.top.inverse();
        let in_eye = object_from_eye.transpose() * DVec4::from_array(equation);
        // The specification leaves a matrix without inverse open: nothing is cut off then.
        let sound = in_eye.is_finite();
        self.state.transform.planes[number] = if sound { in_eye.to_array() } else { [0.0; 4] };
    }

    /// `glGetClipPlane`, in eye coordinates.
    pub fn get_clip_plane(&mut self, plane: u32) -> Option<[f64; 4]> {
        outside_begin!(self, None);
        let number = plane.wrapping_sub(gl::CLIP_PLANE0) as usize;
        let found = self.state.transform.planes.get(number).copied();
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found
    }
}

/// A value within 0 and 1; 0 for NaN.
pub(crate) fn clamped(value: f64) -> f64 {
    if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) }
}
