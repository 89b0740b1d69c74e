// Written by ../../generator from gl.xml and commands.toml: change these.

//! Texture coordinates of vertices (2.7).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1d(target: u32, s: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord1dv(target: u32, v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(target, [x as f32, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1f(target: u32, s: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord1fv(target: u32, v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(target, [x, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1i(target: u32, s: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord1iv(target: u32, v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(target, [x as f32, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1s(target: u32, s: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord1sv(target: u32, v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(target, [f32::from(x), 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2d(target: u32, s: f64, t: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord2dv(target: u32, v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2f(target: u32, s: f32, t: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord2fv(target: u32, v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(target, [x, y, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2i(target: u32, s: i32, t: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord2iv(target: u32, v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2s(target: u32, s: i16, t: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), f32::from(t), 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord2sv(target: u32, v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(target, [f32::from(x), f32::from(y), 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3d(target: u32, s: f64, t: f64, r: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord3dv(target: u32, v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3f(target: u32, s: f32, t: f32, r: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, r, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord3fv(target: u32, v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(target, [x, y, z, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3i(target: u32, s: i32, t: i32, r: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord3iv(target: u32, v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3s(target: u32, s: i16, t: i16, r: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), f32::from(t), f32::from(r), 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord3sv(target: u32, v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(target, [f32::from(x), f32::from(y), f32::from(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4d(target: u32, s: f64, t: f64, r: f64, q: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord4dv(target: u32, v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4f(target: u32, s: f32, t: f32, r: f32, q: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, r, q]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord4fv(target: u32, v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(target, [x, y, z, w]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4i(target: u32, s: i32, t: i32, r: i32, q: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord4iv(target: u32, v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(target, [x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4s(target: u32, s: i16, t: i16, r: i16, q: i16) {
    call_uncaught(|gl, _| {
        gl.tex_coord(target, [f32::from(s), f32::from(t), f32::from(r), f32::from(q)])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMultiTexCoord4sv(target: u32, v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(target, [f32::from(x), f32::from(y), f32::from(z), f32::from(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord1d(s: f64) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord1dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord1f(s: f32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord1fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord1i(s: i32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord1iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord1s(s: i16) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [f32::from(s), 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord1sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [f32::from(x), 0.0, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord2d(s: f64, t: f64) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord2dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord2f(s: f32, t: f32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s, t, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord2fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x, y, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord2i(s: i32, t: i32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord2iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord2s(s: i16, t: i16) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [f32::from(s), f32::from(t), 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord2sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [f32::from(x), f32::from(y), 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord3d(s: f64, t: f64, r: f64) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord3f(s: f32, t: f32, r: f32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s, t, r, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x, y, z, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord3i(s: i32, t: i32, r: i32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord3s(s: i16, t: i16, r: i16) {
    call_uncaught(|gl, _| {
        gl.tex_coord(GL_TEXTURE0, [f32::from(s), f32::from(t), f32::from(r), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [f32::from(x), f32::from(y), f32::from(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord4d(s: f64, t: f64, r: f64, q: f64) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord4dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord4f(s: f32, t: f32, r: f32, q: f32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s, t, r, q]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord4fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x, y, z, w]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord4i(s: i32, t: i32, r: i32, q: i32) {
    call_uncaught(|gl, _| gl.tex_coord(GL_TEXTURE0, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord4iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexCoord4s(s: i16, t: i16, r: i16, q: i16) {
    call_uncaught(|gl, _| {
        gl.tex_coord(GL_TEXTURE0, [f32::from(s), f32::from(t), f32::from(r), f32::from(q)])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexCoord4sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.tex_coord(GL_TEXTURE0, [f32::from(x), f32::from(y), f32::from(z), f32::from(w)]);
        Some(())
    });
}

aliases! {
    glMultiTexCoord1dARB = glMultiTexCoord1d(target: u32, s: f64);
    unsafe glMultiTexCoord1dvARB = glMultiTexCoord1dv(target: u32, v: *const f64);
    glMultiTexCoord1fARB = glMultiTexCoord1f(target: u32, s: f32);
    unsafe glMultiTexCoord1fvARB = glMultiTexCoord1fv(target: u32, v: *const f32);
    glMultiTexCoord1iARB = glMultiTexCoord1i(target: u32, s: i32);
    unsafe glMultiTexCoord1ivARB = glMultiTexCoord1iv(target: u32, v: *const i32);
    glMultiTexCoord1sARB = glMultiTexCoord1s(target: u32, s: i16);
    unsafe glMultiTexCoord1svARB = glMultiTexCoord1sv(target: u32, v: *const i16);
    glMultiTexCoord2dARB = glMultiTexCoord2d(target: u32, s: f64, t: f64);
    unsafe glMultiTexCoord2dvARB = glMultiTexCoord2dv(target: u32, v: *const f64);
    glMultiTexCoord2fARB = glMultiTexCoord2f(target: u32, s: f32, t: f32);
    unsafe glMultiTexCoord2fvARB = glMultiTexCoord2fv(target: u32, v: *const f32);
    glMultiTexCoord2iARB = glMultiTexCoord2i(target: u32, s: i32, t: i32);
    unsafe glMultiTexCoord2ivARB = glMultiTexCoord2iv(target: u32, v: *const i32);
    glMultiTexCoord2sARB = glMultiTexCoord2s(target: u32, s: i16, t: i16);
    unsafe glMultiTexCoord2svARB = glMultiTexCoord2sv(target: u32, v: *const i16);
    glMultiTexCoord3dARB = glMultiTexCoord3d(target: u32, s: f64, t: f64, r: f64);
    unsafe glMultiTexCoord3dvARB = glMultiTexCoord3dv(target: u32, v: *const f64);
    glMultiTexCoord3fARB = glMultiTexCoord3f(target: u32, s: f32, t: f32, r: f32);
    unsafe glMultiTexCoord3fvARB = glMultiTexCoord3fv(target: u32, v: *const f32);
    glMultiTexCoord3iARB = glMultiTexCoord3i(target: u32, s: i32, t: i32, r: i32);
    unsafe glMultiTexCoord3ivARB = glMultiTexCoord3iv(target: u32, v: *const i32);
    glMultiTexCoord3sARB = glMultiTexCoord3s(target: u32, s: i16, t: i16, r: i16);
    unsafe glMultiTexCoord3svARB = glMultiTexCoord3sv(target: u32, v: *const i16);
    glMultiTexCoord4dARB = glMultiTexCoord4d(target: u32, s: f64, t: f64, r: f64, q: f64);
    unsafe glMultiTexCoord4dvARB = glMultiTexCoord4dv(target: u32, v: *const f64);
    glMultiTexCoord4fARB = glMultiTexCoord4f(target: u32, s: f32, t: f32, r: f32, q: f32);
    unsafe glMultiTexCoord4fvARB = glMultiTexCoord4fv(target: u32, v: *const f32);
    glMultiTexCoord4iARB = glMultiTexCoord4i(target: u32, s: i32, t: i32, r: i32, q: i32);
    unsafe glMultiTexCoord4ivARB = glMultiTexCoord4iv(target: u32, v: *const i32);
    glMultiTexCoord4sARB = glMultiTexCoord4s(target: u32, s: i16, t: i16, r: i16, q: i16);
    unsafe glMultiTexCoord4svARB = glMultiTexCoord4sv(target: u32, v: *const i16);
}
