//! Matrices of GLU 1.3, chapter 4.1: column-major, acting on column vectors, as `glMultMatrixd` takes them.

use glam::{DMat4, DVec3};

/// The projection with a field of view of `fov_y_degrees` from bottom to top, `aspect` its width by its height
/// (`gluPerspective`).
///
/// ```text
/// f/aspect  0        0                      0
///    0      f        0                      0
///    0      0  (near+far)/(near-far)  2 near far/(near-far)      f = cot(fov_y / 2)
///    0      0       -1                      0
/// ```
///
/// `None` if near and far are equal, or the aspect or the sine of half the angle is 0: there is no such matrix.
#[must_use]
pub fn perspective(fov_y_degrees: f64, aspect: f64, near: f64, far: f64) -> Option<[f64; 16]> {
    let half = fov_y_degrees.to_radians() / 2.0;
    let (sine, depth) = (libm::sin(half), far - near);
    if sine == 0.0 || aspect == 0.0 || depth == 0.0 {
        return None;
    }
    let f = libm::cos(half) / sine;
    let mut matrix = [0.0; 16];
    matrix[0] = f / aspect;
    matrix[5] = f;
    matrix[10] = -(far + near) / depth;
    matrix[11] = -1.0;
    matrix[14] = -2.0 * near * far / depth;
    Some(matrix)
}

/// The view from `eye` towards `center`, with `up` upwards in the picture (`gluLookAt`).
///
/// ```text
///  s.x   s.y   s.z  -s·eye
///  u.x   u.y   u.z  -u·eye      f = (center - eye)/|center - eye|
/// -f.x  -f.y  -f.z   f·eye      s = f x up/|f x up|, u = s x f
///   0     0     0      1
/// ```
///
/// Directions that don't exist, since `center` is `eye` or `up` is along the view, are 0.
#[must_use]
pub fn look_at(eye: [f64; 3], center: [f64; 3], up: [f64; 3]) -> [f64; 16] {
    let eye = DVec3::from_array(eye);
    let forward = (DVec3::from_array(center) - eye).normalize_or_zero();
    let side = forward.cross(DVec3::from_array(up)).normalize_or_zero();
    let upwards = side.cross(forward);
    let row = |axis: DVec3| axis.extend(-axis.dot(eye));
    let rows = [row(side), row(upwards), row(-forward), DVec3::ZERO.extend(1.0)];
    DMat4::from_cols(rows[0], rows[1], rows[2], rows[3]).transpose().to_cols_array()
}
