//! Matrix stacks (OpenGL 1.5, section 2.10.2).
//!
//! Products are made in f64 and kept to the digits of f32, what `glGetFloatv` returns: a program that gets a matrix and
//! loads it again for a second pass draws the same depths, as `GL_EQUAL` and its kind need.

use crate::enums as gl;
use crate::limits::{MODELVIEW_DEPTH, PROJECTION_DEPTH, TEXTURE_DEPTH, TEXTURE_UNITS};
use glam::{DMat4, DVec3};

/// A stack of matrices; it is never empty.
#[derive(Clone, Debug)]
pub(crate) struct Stack {
    below: Vec<DMat4>,
    pub(crate) top: DMat4,
    limit: usize,
}

impl Stack {
    fn new(limit: usize) -> Self {
        Self { below: Vec::new(), top: DMat4::IDENTITY, limit }
    }

    /// How many matrices there are, the top one among them.
    pub(crate) fn depth(&self) -> usize {
        self.below.len() + 1
    }

    /// Replaces the top matrix.
    pub(crate) fn set(&mut self, matrix: DMat4) {
        self.top = matrix.as_mat4().as_dmat4();
    }

    fn push(&mut self) -> Result<(), u32> {
        if self.depth() >= self.limit {
            return Err(gl::STACK_OVERFLOW);
        }
        self.below.push(self.top);
        Ok(())
    }

    fn pop(&mut self) -> Result<(), u32> {
        self.top = self.below.pop().ok_or(gl::STACK_UNDERFLOW)?;
        Ok(())
    }
}

/// All stacks.
#[derive(Clone, Debug)]
pub(crate) struct Matrices {
    pub(crate) modelview: Stack,
    pub(crate) projection: Stack,
    pub(crate) texture: [Stack; TEXTURE_UNITS],
}

impl Matrices {
    pub(crate) fn new() -> Self {
        Self {
            modelview: Stack::new(MODELVIEW_DEPTH),
            projection: Stack::new(PROJECTION_DEPTH),
            texture: std::array::from_fn(|_| Stack::new(TEXTURE_DEPTH)),
        }
    }

    /// The stack of a matrix mode; of texture matrices, that of the active unit.
    pub(crate) fn stack(&mut self, mode: u32, unit: usize) -> &mut Stack {
        match mode {
            gl::PROJECTION => &mut self.projection,
            gl::TEXTURE => &mut self.texture[unit],
            _ => &mut self.modelview,
        }
    }

    pub(crate) fn push(&mut self, mode: u32, unit: usize) -> Result<(), u32> {
        self.stack(mode, unit).push()
    }

    pub(crate) fn pop(&mut self, mode: u32, unit: usize) -> Result<(), u32> {
        self.stack(mode, unit).pop()
    }

    /// The product that takes vertices to clip coordinates.
    pub(crate) fn clip_from_object(&self) -> DMat4 {
        self.projection.top * self.modelview.top
    }
}

/// The rotation of `glRotate`; `None` for an axis without length, which leaves the matrix as it is.
pub(crate) fn rotation(angle_degrees: f64, axis: [f64; 3]) -> Option<DMat4> {
    let axis = DVec3::from_array(axis);
    let length = axis.length();
    if !(length > 0.0 && length.is_finite()) {
        return None;
    }
    let (sin, cos) = sin_cos_degrees(angle_degrees);
    let DVec3 { x, y, z } = axis / length;
    let t = 1.0 - cos;
    Some(DMat4::from_cols_array(&[
        x * x * t + cos,
        x * y * t + z * sin,
        x * z * t - y * sin,
        0.0,
        x * y * t - z * sin,
        y * y * t + cos,
        y * z * t + x * sin,
        0.0,
        x * z * t + y * sin,
        y * z * t - x * sin,
        z * z * t + cos,
        0.0,
        0.0,
        0.0,
        0.0,
        1.0,
    ]))
}

/// Sine and cosine of an angle in degrees; quarter turns are exact.
pub(crate) fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        turned => libm::sincos(turned.to_radians()),
    }
}

/// The matrix of `glFrustum`: `None` where the specification has `GL_INVALID_VALUE`.
pub(crate) fn frustum([l, r, b, t, n, f]: [f64; 6]) -> Option<DMat4> {
    if !(n > 0.0 && f > 0.0) || l == r || b == t || n == f {
        return None;
    }
    Some(DMat4::from_cols_array(&[
        2.0 * n / (r - l),
        0.0,
        0.0,
        0.0,
        0.0,
        2.0 * n / (t - b),
        0.0,
        0.0,
        (r + l) / (r - l),
        (t + b) / (t - b),
        -(f + n) / (f - n),
        -1.0,
        0.0,
        0.0,
        -2.0 * f * n / (f - n),
        0.0,
    ]))
}

/// The matrix of `glOrtho`: `None` where the specification has `GL_INVALID_VALUE`.
pub(crate) fn ortho([l, r, b, t, n, f]: [f64; 6]) -> Option<DMat4> {
    if l == r || b == t || n == f {
        return None;
    }
    let translation = DVec3::new(-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n));
    let scale = DVec3::new(2.0 / (r - l), 2.0 / (t - b), -2.0 / (f - n));
    Some(DMat4::from_translation(translation) * DMat4::from_scale(scale))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_2_10_2_a_matrix_that_is_got_and_loaded_again_is_the_same_in_every_product() {
        let turned = rotation(30.0, [1.0, 2.0, 3.0]).unwrap();
        let projection = frustum([-1.0, 3.0, -2.0, 2.0, 0.01, 50.0]).unwrap();
        let mut once = Stack::new(2);
        once.set(projection);
        once.set(once.top * turned);
        let mut again = Stack::new(2);
        let got = once.top.to_cols_array().map(|value| value as f32);
        again.set(DMat4::from_cols_array(&got.map(f64::from)));
        assert_eq!(once.top, again.top);
        once.set(once.top * turned);
        again.set(again.top * turned);
        assert_eq!(once.top, again.top);
    }

    #[test]
    fn section_2_10_2_a_quarter_turn_about_z_takes_x_to_y_exactly() {
        let turned = rotation(90.0, [0.0, 0.0, 7.0]).unwrap() * DVec3::X.extend(1.0);
        assert_eq!(turned.truncate(), DVec3::Y);
        assert_eq!(rotation(30.0, [0.0; 3]), None);
    }

    #[test]
    fn section_2_10_2_frustum_takes_the_corners_of_its_planes_to_those_of_the_clip_volume() {
        let matrix = frustum([-1.0, 3.0, -2.0, 2.0, 1.0, 5.0]).unwrap();
        let near = matrix * DVec3::new(3.0, 2.0, -1.0).extend(1.0);
        assert_eq!((near / near.w).truncate(), DVec3::new(1.0, 1.0, -1.0));
        let far = matrix * DVec3::new(-5.0, -10.0, -5.0).extend(1.0);
        assert!((far / far.w).truncate().abs_diff_eq(DVec3::new(-1.0, -1.0, 1.0), 1e-14));
        assert_eq!(frustum([0.0, 1.0, 0.0, 1.0, -1.0, 5.0]), None);
    }
}
