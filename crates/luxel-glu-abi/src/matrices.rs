//! Matrices and projection (GLU 1.3, chapter 4).

use crate::gl;
use crate::object::{array, store};
use luxel_glu::{Transform, look_at, perspective, pick_matrix};

/// Multiplies the current matrix by a perspective projection; not at all if there is none of these values.
#[unsafe(no_mangle)]
extern "C" fn gluPerspective(fov_y: f64, aspect: f64, near: f64, far: f64) {
    if let Some(matrix) = perspective(fov_y, aspect, near, far) {
        gl::multiply(&matrix);
    }
}

/// Multiplies the current matrix by a projection of a plane.
#[unsafe(no_mangle)]
extern "C" fn gluOrtho2D(left: f64, right: f64, bottom: f64, top: f64) {
    // SAFETY: the function takes no pointer.
    unsafe { gl::glOrtho(left, right, bottom, top, -1.0, 1.0) };
}

/// Multiplies the current matrix by a view.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
extern "C" fn gluLookAt(
    eye_x: f64,
    eye_y: f64,
    eye_z: f64,
    center_x: f64,
    center_y: f64,
    center_z: f64,
    up_x: f64,
    up_y: f64,
    up_z: f64,
) {
    let (eye, center) = ([eye_x, eye_y, eye_z], [center_x, center_y, center_z]);
    gl::multiply(&look_at(eye, center, [up_x, up_y, up_z]));
}

/// Multiplies the current matrix by one that makes a rectangle of the window the whole of it.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluPickMatrix(x: f64, y: f64, width: f64, height: f64, viewport: *const i32) {
    // SAFETY: the caller passes the four values of a viewport.
    let viewport = unsafe { array(viewport) };
    let matrix = viewport.and_then(|viewport| pick_matrix([x, y], [width, height], viewport));
    if let Some(matrix) = matrix {
        gl::multiply(&matrix);
    }
}

/// The matrices and the viewport that the caller passes.
///
/// # Safety
///
/// The addresses are null, or 16, 16 and 4 values can be read there.
unsafe fn transform(
    model: *const f64,
    projection: *const f64,
    viewport: *const i32,
) -> Option<Transform> {
    // SAFETY: the caller of this function promises it.
    unsafe {
        Some(Transform {
            model: array(model)?,
            projection: array(projection)?,
            viewport: array(viewport)?,
        })
    }
}

/// Writes what was found, and returns whether something was.
///
/// # Safety
///
/// The addresses are null, or a value can be written at each.
unsafe fn answer<const N: usize>(found: Option<[f64; N]>, addresses: [*mut f64; N]) -> i32 {
    let Some(found) = found else { return 0 };
    for (address, value) in addresses.into_iter().zip(found) {
        // SAFETY: the caller of this function promises it.
        unsafe { store(address, value) };
    }
    1
}

/// Where an object is in the window.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
unsafe extern "C" fn gluProject(
    x: f64,
    y: f64,
    z: f64,
    model: *const f64,
    projection: *const f64,
    viewport: *const i32,
    window_x: *mut f64,
    window_y: *mut f64,
    window_z: *mut f64,
) -> i32 {
    // SAFETY: the caller passes matrices, a viewport, and where to write.
    unsafe {
        let found = transform(model, projection, viewport);
        answer(found.and_then(|found| found.project([x, y, z])), [window_x, window_y, window_z])
    }
}

/// The object at a position of the window.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
unsafe extern "C" fn gluUnProject(
    window_x: f64,
    window_y: f64,
    window_z: f64,
    model: *const f64,
    projection: *const f64,
    viewport: *const i32,
    x: *mut f64,
    y: *mut f64,
    z: *mut f64,
) -> i32 {
    // SAFETY: the caller passes matrices, a viewport, and where to write.
    unsafe {
        let found = transform(model, projection, viewport);
        answer(found.and_then(|found| found.unproject([window_x, window_y, window_z])), [x, y, z])
    }
}

/// The object at a position of the window, with w and the range of depths.
#[unsafe(no_mangle)]
#[allow(clippy::too_many_arguments, reason = "the parameters are GLU's")]
unsafe extern "C" fn gluUnProject4(
    window_x: f64,
    window_y: f64,
    window_z: f64,
    clip_w: f64,
    model: *const f64,
    projection: *const f64,
    viewport: *const i32,
    near: f64,
    far: f64,
    x: *mut f64,
    y: *mut f64,
    z: *mut f64,
    w: *mut f64,
) -> i32 {
    let window = [window_x, window_y, window_z, clip_w];
    // SAFETY: the caller passes matrices, a viewport, and where to write.
    unsafe {
        let found = transform(model, projection, viewport);
        answer(found.and_then(|found| found.unproject4(window, [near, far])), [x, y, z, w])
    }
}
