// Written by ../../generator from gl.xml and commands.toml: change these.

//! Raster positions (2.13).

use crate::prelude::*;

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
pub(crate) extern "C" fn glWindowPos2d(x: f64, y: f64) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, 0.0]));
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
pub(crate) extern "C" fn glWindowPos2f(x: f32, y: f32) {
    call(|gl, _| gl.window_pos([x, y, 0.0]));
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
pub(crate) extern "C" fn glWindowPos2i(x: i32, y: i32) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, 0.0]));
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
pub(crate) extern "C" fn glWindowPos2s(x: i16, y: i16) {
    call(|gl, _| gl.window_pos([f32::from(x), f32::from(y), 0.0]));
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
pub(crate) extern "C" fn glWindowPos3d(x: f64, y: f64, z: f64) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, z as f32]));
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
pub(crate) extern "C" fn glWindowPos3f(x: f32, y: f32, z: f32) {
    call(|gl, _| gl.window_pos([x, y, z]));
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
pub(crate) extern "C" fn glWindowPos3i(x: i32, y: i32, z: i32) {
    call(|gl, _| gl.window_pos([x as f32, y as f32, z as f32]));
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
pub(crate) extern "C" fn glWindowPos3s(x: i16, y: i16, z: i16) {
    call(|gl, _| gl.window_pos([f32::from(x), f32::from(y), f32::from(z)]));
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

aliases! {
    glWindowPos2dARB = glWindowPos2d(x: f64, y: f64);
    unsafe glWindowPos2dvARB = glWindowPos2dv(v: *const f64);
    glWindowPos2fARB = glWindowPos2f(x: f32, y: f32);
    unsafe glWindowPos2fvARB = glWindowPos2fv(v: *const f32);
    glWindowPos2iARB = glWindowPos2i(x: i32, y: i32);
    unsafe glWindowPos2ivARB = glWindowPos2iv(v: *const i32);
    glWindowPos2sARB = glWindowPos2s(x: i16, y: i16);
    unsafe glWindowPos2svARB = glWindowPos2sv(v: *const i16);
    glWindowPos3dARB = glWindowPos3d(x: f64, y: f64, z: f64);
    unsafe glWindowPos3dvARB = glWindowPos3dv(v: *const f64);
    glWindowPos3fARB = glWindowPos3f(x: f32, y: f32, z: f32);
    unsafe glWindowPos3fvARB = glWindowPos3fv(v: *const f32);
    glWindowPos3iARB = glWindowPos3i(x: i32, y: i32, z: i32);
    unsafe glWindowPos3ivARB = glWindowPos3iv(v: *const i32);
    glWindowPos3sARB = glWindowPos3s(x: i16, y: i16, z: i16);
    unsafe glWindowPos3svARB = glWindowPos3sv(v: *const i16);
}
