//! The functions of OpenGL that GLU calls.

use luxel_glu::Drawing;
use std::ffi::c_void;

unsafe extern "C" {
    pub(crate) fn glBegin(mode: u32);
    pub(crate) fn glEnd();
    pub(crate) fn glNormal3d(x: f64, y: f64, z: f64);
    pub(crate) fn glTexCoord2d(s: f64, t: f64);
    pub(crate) fn glVertex3d(x: f64, y: f64, z: f64);
    pub(crate) fn glMultMatrixd(m: *const f64);
    pub(crate) fn glOrtho(left: f64, right: f64, bottom: f64, top: f64, near: f64, far: f64);
    pub(crate) fn glGetIntegerv(pname: u32, params: *mut i32);
    pub(crate) fn glPixelStorei(pname: u32, param: i32);
    pub(crate) fn glGetTexLevelParameteriv(target: u32, level: i32, pname: u32, params: *mut i32);
    pub(crate) fn glTexImage1D(
        target: u32,
        level: i32,
        internal: i32,
        width: i32,
        border: i32,
        format: u32,
        kind: u32,
        pixels: *const c_void,
    );
    pub(crate) fn glTexImage2D(
        target: u32,
        level: i32,
        internal: i32,
        width: i32,
        height: i32,
        border: i32,
        format: u32,
        kind: u32,
        pixels: *const c_void,
    );
    pub(crate) fn glTexImage3D(
        target: u32,
        level: i32,
        internal: i32,
        width: i32,
        height: i32,
        depth: i32,
        border: i32,
        format: u32,
        kind: u32,
        pixels: *const c_void,
    );
}

/// The current context.
pub(crate) struct Current;

impl Drawing for Current {
    fn begin(&mut self, mode: u32) {
        // SAFETY: OpenGL's functions without pointers may be called in any state.
        unsafe { glBegin(mode) };
    }

    fn end(&mut self) {
        // SAFETY: as above.
        unsafe { glEnd() };
    }

    fn normal(&mut self, [x, y, z]: [f64; 3]) {
        // SAFETY: as above.
        unsafe { glNormal3d(x, y, z) };
    }

    fn tex_coord(&mut self, [s, t]: [f64; 2]) {
        // SAFETY: as above.
        unsafe { glTexCoord2d(s, t) };
    }

    fn vertex(&mut self, [x, y, z]: [f64; 3]) {
        // SAFETY: as above.
        unsafe { glVertex3d(x, y, z) };
    }
}

/// Multiplies the current matrix from the right.
pub(crate) fn multiply(matrix: &[f64; 16]) {
    // SAFETY: the matrix has 16 values.
    unsafe { glMultMatrixd(matrix.as_ptr()) };
}

/// A state of one integer; 0 where there is no such state.
pub(crate) fn integer(pname: u32) -> i32 {
    // Room for any state of OpenGL.
    let mut values = [0; 16];
    // SAFETY: no state has more than 16 values.
    unsafe { glGetIntegerv(pname, values.as_mut_ptr()) };
    values[0]
}
