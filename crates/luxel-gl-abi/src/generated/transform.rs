// Written by ../../generator from gl.xml and commands.toml: change these.

//! Matrices (2.11), viewport, user clip planes (2.12).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glActiveTexture(texture: u32) {
    call(|gl, _| gl.active_texture(texture));
}

pub(crate) extern "C" fn glClipControl(origin: u32, depth: u32) {
    call(|gl, _| gl.clip_control(origin, depth));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glClipPlane(plane: u32, equation: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.clip_plane(plane, array(equation)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDepthRange(n: f64, f: f64) {
    call(|gl, _| gl.depth_range(n, f));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFrustum(
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    z_near: f64,
    z_far: f64,
) {
    call(|gl, _| gl.frustum(left, right, bottom, top, z_near, z_far));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetClipPlane(plane: u32, equation: *mut f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(plane) = gl.get_clip_plane(plane) {
            store_all(equation, &plane)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLoadIdentity() {
    call(|gl, _| gl.load_identity());
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLoadMatrixd(m: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.load_matrix(&array(m)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLoadMatrixf(m: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.load_matrix(&array(m)?.map(f64::from));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLoadTransposeMatrixd(m: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.load_transpose_matrix(&array(m)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLoadTransposeMatrixf(m: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.load_transpose_matrix(&array(m)?.map(f64::from));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMatrixMode(mode: u32) {
    call(|gl, _| gl.matrix_mode(mode));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultMatrixd(m: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.mult_matrix(&array(m)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultMatrixf(m: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.mult_matrix(&array(m)?.map(f64::from));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultTransposeMatrixd(m: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.mult_transpose_matrix(&array(m)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultTransposeMatrixf(m: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.mult_transpose_matrix(&array(m)?.map(f64::from));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glOrtho(
    left: f64,
    right: f64,
    bottom: f64,
    top: f64,
    z_near: f64,
    z_far: f64,
) {
    call(|gl, _| gl.ortho(left, right, bottom, top, z_near, z_far));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPopMatrix() {
    call(|gl, _| gl.pop_matrix());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPushMatrix() {
    call(|gl, _| gl.push_matrix());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRotated(angle: f64, x: f64, y: f64, z: f64) {
    call(|gl, _| gl.rotate(angle, x, y, z));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRotatef(angle: f32, x: f32, y: f32, z: f32) {
    call(|gl, _| gl.rotate(angle.into(), x.into(), y.into(), z.into()));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glScaled(x: f64, y: f64, z: f64) {
    call(|gl, _| gl.scale(x, y, z));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glScalef(x: f32, y: f32, z: f32) {
    call(|gl, _| gl.scale(x.into(), y.into(), z.into()));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTranslated(x: f64, y: f64, z: f64) {
    call(|gl, _| gl.translate(x, y, z));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTranslatef(x: f32, y: f32, z: f32) {
    call(|gl, _| gl.translate(x.into(), y.into(), z.into()));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glViewport(x: i32, y: i32, width: i32, height: i32) {
    call(|gl, _| gl.viewport(x, y, width, height));
}

aliases! {
    glActiveTextureARB = glActiveTexture(texture: u32);
    unsafe glLoadTransposeMatrixdARB = glLoadTransposeMatrixd(m: *const f64);
    unsafe glLoadTransposeMatrixfARB = glLoadTransposeMatrixf(m: *const f32);
    unsafe glMultTransposeMatrixdARB = glMultTransposeMatrixd(m: *const f64);
    unsafe glMultTransposeMatrixfARB = glMultTransposeMatrixf(m: *const f32);
}
