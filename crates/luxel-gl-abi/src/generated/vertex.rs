// Written by ../../generator from gl.xml and commands.toml: change these.

//! Begin and End, vertices, normals, fog coordinates, edge flags (2.6, 2.7), rectangles (2.10).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBegin(mode: u32) {
    call(|gl, _| gl.begin(mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEdgeFlag(flag: u8) {
    call(|gl, _| gl.edge_flag(flag != 0));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glEdgeFlagv(flag: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [flag] = array(flag)?;
        gl.edge_flag(flag != 0);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEnd() {
    call(|gl, _| gl.end());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogCoordd(coord: f64) {
    call(|gl, _| gl.fog_coord(coord as f32));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFogCoorddv(coord: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(coord)?;
        gl.fog_coord(x as f32);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogCoordf(coord: f32) {
    call(|gl, _| gl.fog_coord(coord));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFogCoordfv(coord: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(coord)?;
        gl.fog_coord(x);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNormal3b(nx: i8, ny: i8, nz: i8) {
    call_uncaught(|gl, _| gl.normal([convert::byte(nx), convert::byte(ny), convert::byte(nz)]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormal3bv(v: *const i8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.normal([convert::byte(x), convert::byte(y), convert::byte(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNormal3d(nx: f64, ny: f64, nz: f64) {
    call_uncaught(|gl, _| gl.normal([nx as f32, ny as f32, nz as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormal3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.normal([x as f32, y as f32, z as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNormal3f(nx: f32, ny: f32, nz: f32) {
    call_uncaught(|gl, _| gl.normal([nx, ny, nz]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormal3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.normal([x, y, z]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNormal3i(nx: i32, ny: i32, nz: i32) {
    call_uncaught(|gl, _| gl.normal([convert::int(nx), convert::int(ny), convert::int(nz)]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormal3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.normal([convert::int(x), convert::int(y), convert::int(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNormal3s(nx: i16, ny: i16, nz: i16) {
    call_uncaught(|gl, _| gl.normal([convert::short(nx), convert::short(ny), convert::short(nz)]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glNormal3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.normal([convert::short(x), convert::short(y), convert::short(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRectd(x1: f64, y1: f64, x2: f64, y2: f64) {
    call(|gl, _| gl.rect([x1 as f32, y1 as f32], [x2 as f32, y2 as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRectdv(v1: *const f64, v2: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.rect(array(v1)?.map(|x| x as f32), array(v2)?.map(|x| x as f32));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRectf(x1: f32, y1: f32, x2: f32, y2: f32) {
    call(|gl, _| gl.rect([x1, y1], [x2, y2]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRectfv(v1: *const f32, v2: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.rect(array(v1)?, array(v2)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRecti(x1: i32, y1: i32, x2: i32, y2: i32) {
    call(|gl, _| gl.rect([x1 as f32, y1 as f32], [x2 as f32, y2 as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRectiv(v1: *const i32, v2: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.rect(array(v1)?.map(|x| x as f32), array(v2)?.map(|x| x as f32));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRects(x1: i16, y1: i16, x2: i16, y2: i16) {
    call(|gl, _| gl.rect([x1, y1].map(f32::from), [x2, y2].map(f32::from)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glRectsv(v1: *const i16, v2: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.rect(array(v1)?.map(f32::from), array(v2)?.map(f32::from));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex2d(x: f64, y: f64) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex2dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.vertex([x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex2f(x: f32, y: f32) {
    call_uncaught(|gl, _| gl.vertex([x, y, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex2fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.vertex([x, y, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex2i(x: i32, y: i32) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex2iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.vertex([x as f32, y as f32, 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex2s(x: i16, y: i16) {
    call_uncaught(|gl, _| gl.vertex([f32::from(x), f32::from(y), 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex2sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y] = array(v)?;
        gl.vertex([f32::from(x), f32::from(y), 0.0, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex3d(x: f64, y: f64, z: f64) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, z as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.vertex([x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex3f(x: f32, y: f32, z: f32) {
    call_uncaught(|gl, _| gl.vertex([x, y, z, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.vertex([x, y, z, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex3i(x: i32, y: i32, z: i32) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, z as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.vertex([x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex3s(x: i16, y: i16, z: i16) {
    call_uncaught(|gl, _| gl.vertex([f32::from(x), f32::from(y), f32::from(z), 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.vertex([f32::from(x), f32::from(y), f32::from(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex4d(x: f64, y: f64, z: f64, w: f64) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, z as f32, w as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex4dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.vertex([x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex4f(x: f32, y: f32, z: f32, w: f32) {
    call_uncaught(|gl, _| gl.vertex([x, y, z, w]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex4fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.vertex([x, y, z, w]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex4i(x: i32, y: i32, z: i32, w: i32) {
    call_uncaught(|gl, _| gl.vertex([x as f32, y as f32, z as f32, w as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex4iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.vertex([x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glVertex4s(x: i16, y: i16, z: i16, w: i16) {
    call_uncaught(|gl, _| gl.vertex([f32::from(x), f32::from(y), f32::from(z), f32::from(w)]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glVertex4sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.vertex([f32::from(x), f32::from(y), f32::from(z), f32::from(w)]);
        Some(())
    });
}

aliases! {
    glFogCoorddEXT = glFogCoordd(coord: f64);
    unsafe glFogCoorddvEXT = glFogCoorddv(coord: *const f64);
    glFogCoordfEXT = glFogCoordf(coord: f32);
    unsafe glFogCoordfvEXT = glFogCoordfv(coord: *const f32);
}
