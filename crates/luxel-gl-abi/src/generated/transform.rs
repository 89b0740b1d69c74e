// Written by ../../generator from gl.xml and commands.toml: change these.

//! Matrices (2.11), viewport, user clip planes (2.12), raster positions (2.13).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glActiveTexture(texture: u32) {
    call(|gl, _| gl.active_texture(texture));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glActiveTextureARB(texture: u32) {
    glActiveTexture(texture);
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
            store(equation, 4, |at| plane[at])?;
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
pub(crate) unsafe extern "C" fn glLoadTransposeMatrixdARB(m: *const f64) {
    // SAFETY: the same contract.
    unsafe { glLoadTransposeMatrixd(m) };
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
pub(crate) unsafe extern "C" fn glLoadTransposeMatrixfARB(m: *const f32) {
    // SAFETY: the same contract.
    unsafe { glLoadTransposeMatrixf(m) };
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
pub(crate) unsafe extern "C" fn glMultTransposeMatrixdARB(m: *const f64) {
    // SAFETY: the same contract.
    unsafe { glMultTransposeMatrixd(m) };
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
pub(crate) unsafe extern "C" fn glMultTransposeMatrixfARB(m: *const f32) {
    // SAFETY: the same contract.
    unsafe { glMultTransposeMatrixf(m) };
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
pub(crate) extern "C" fn glRasterPos2d(x: f64, y: f64) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos2dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.raster_pos([x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos2f(x: f32, y: f32) {
    call(|gl, _| gl.raster_pos([x, y, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos2fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.raster_pos([x, y, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos2i(x: i32, y: i32) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos2iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.raster_pos([x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos2s(x: i16, y: i16) {
    call(|gl, _| gl.raster_pos([f32::from(x), f32::from(y), 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos2sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.raster_pos([f32::from(x), f32::from(y), 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos3d(x: f64, y: f64, z: f64) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, z as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.raster_pos([x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos3f(x: f32, y: f32, z: f32) {
    call(|gl, _| gl.raster_pos([x, y, z, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.raster_pos([x, y, z, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos3i(x: i32, y: i32, z: i32) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, z as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.raster_pos([x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos3s(x: i16, y: i16, z: i16) {
    call(|gl, _| gl.raster_pos([f32::from(x), f32::from(y), f32::from(z), 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.raster_pos([f32::from(x), f32::from(y), f32::from(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos4d(x: f64, y: f64, z: f64, w: f64) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, z as f32, w as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos4dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.raster_pos([x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos4f(x: f32, y: f32, z: f32, w: f32) {
    call(|gl, _| gl.raster_pos([x, y, z, w]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos4fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.raster_pos([x, y, z, w]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos4i(x: i32, y: i32, z: i32, w: i32) {
    call(|gl, _| gl.raster_pos([x as f32, y as f32, z as f32, w as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos4iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.raster_pos([x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRasterPos4s(x: i16, y: i16, z: i16, w: i16) {
    call(|gl, _| gl.raster_pos([f32::from(x), f32::from(y), f32::from(z), f32::from(w)]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRasterPos4sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.raster_pos([f32::from(x), f32::from(y), f32::from(z), f32::from(w)]);
        Some(())
    });
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

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2d(x: f64, y: f64) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, 0.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2dARB(x: f64, y: f64) {
    glWindowPos2d(x, y);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.window_pos([x as f32, y as f32, 0.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2dvARB(v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glWindowPos2dv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2f(x: f32, y: f32) {
    call(|gl, _| gl.window_pos([x, y, 0.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2fARB(x: f32, y: f32) {
    glWindowPos2f(x, y);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.window_pos([x, y, 0.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2fvARB(v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glWindowPos2fv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2i(x: i32, y: i32) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, 0.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2iARB(x: i32, y: i32) {
    glWindowPos2i(x, y);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.window_pos([x as f32, y as f32, 0.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2ivARB(v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glWindowPos2iv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2s(x: i16, y: i16) {
    call(|gl, _| gl.window_pos([f32::from(x), f32::from(y), 0.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos2sARB(x: i16, y: i16) {
    glWindowPos2s(x, y);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.window_pos([f32::from(x), f32::from(y), 0.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos2svARB(v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glWindowPos2sv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3d(x: f64, y: f64, z: f64) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, z as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3dARB(x: f64, y: f64, z: f64) {
    glWindowPos3d(x, y, z);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.window_pos([x as f32, y as f32, z as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3dvARB(v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glWindowPos3dv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3f(x: f32, y: f32, z: f32) {
    call(|gl, _| gl.window_pos([x, y, z]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3fARB(x: f32, y: f32, z: f32) {
    glWindowPos3f(x, y, z);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.window_pos([x, y, z]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3fvARB(v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glWindowPos3fv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3i(x: i32, y: i32, z: i32) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, z as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3iARB(x: i32, y: i32, z: i32) {
    glWindowPos3i(x, y, z);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.window_pos([x as f32, y as f32, z as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3ivARB(v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glWindowPos3iv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3s(x: i16, y: i16, z: i16) {
    call(|gl, _| gl.window_pos([f32::from(x), f32::from(y), f32::from(z)]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glWindowPos3sARB(x: i16, y: i16, z: i16) {
    glWindowPos3s(x, y, z);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.window_pos([f32::from(x), f32::from(y), f32::from(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glWindowPos3svARB(v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glWindowPos3sv(v) };
}
