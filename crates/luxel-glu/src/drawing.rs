//! What shapes are drawn to.

/// A stream of primitives: OpenGL, between and around `glBegin` and `glEnd`.
pub trait Drawing {
    /// `glBegin`, with OpenGL's number of the mode.
    fn begin(&mut self, mode: u32);
    /// `glEnd`.
    fn end(&mut self);
    /// `glNormal3d`, a unit vector.
    fn normal(&mut self, normal: [f64; 3]);
    /// `glTexCoord2d`.
    fn tex_coord(&mut self, st: [f64; 2]);
    /// `glVertex3d`.
    fn vertex(&mut self, position: [f64; 3]);
}
