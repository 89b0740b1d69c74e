// Written by ../../generator from gl.xml and commands.toml: change these.

//! Begin and End, vertices and their attributes (2.6, 2.7), rectangles (2.10).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBegin(mode: u32) {
    call(|gl, _| gl.begin(mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3b(red: i8, green: i8, blue: i8) {
    call_uncaught(|gl, _| {
        gl.color([convert::byte(red), convert::byte(green), convert::byte(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3bv(v: *const i8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::byte(x), convert::byte(y), convert::byte(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3d(red: f64, green: f64, blue: f64) {
    call_uncaught(|gl, _| gl.color([red as f32, green as f32, blue as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([x as f32, y as f32, z as f32, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3f(red: f32, green: f32, blue: f32) {
    call_uncaught(|gl, _| gl.color([red, green, blue, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([x, y, z, 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3i(red: i32, green: i32, blue: i32) {
    call_uncaught(|gl, _| {
        gl.color([convert::int(red), convert::int(green), convert::int(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::int(x), convert::int(y), convert::int(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3s(red: i16, green: i16, blue: i16) {
    call_uncaught(|gl, _| {
        gl.color([convert::short(red), convert::short(green), convert::short(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::short(x), convert::short(y), convert::short(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3ub(red: u8, green: u8, blue: u8) {
    call_uncaught(|gl, _| {
        gl.color([convert::ubyte(red), convert::ubyte(green), convert::ubyte(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3ubv(v: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::ubyte(x), convert::ubyte(y), convert::ubyte(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3ui(red: u32, green: u32, blue: u32) {
    call_uncaught(|gl, _| {
        gl.color([convert::uint(red), convert::uint(green), convert::uint(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3uiv(v: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::uint(x), convert::uint(y), convert::uint(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor3us(red: u16, green: u16, blue: u16) {
    call_uncaught(|gl, _| {
        gl.color([convert::ushort(red), convert::ushort(green), convert::ushort(blue), 1.0])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor3usv(v: *const u16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.color([convert::ushort(x), convert::ushort(y), convert::ushort(z), 1.0]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4b(red: i8, green: i8, blue: i8, alpha: i8) {
    call_uncaught(|gl, _| {
        gl.color([
            convert::byte(red),
            convert::byte(green),
            convert::byte(blue),
            convert::byte(alpha),
        ])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4bv(v: *const i8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::byte(x), convert::byte(y), convert::byte(z), convert::byte(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4d(red: f64, green: f64, blue: f64, alpha: f64) {
    call_uncaught(|gl, _| gl.color([red as f32, green as f32, blue as f32, alpha as f32]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([x as f32, y as f32, z as f32, w as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4f(red: f32, green: f32, blue: f32, alpha: f32) {
    call_uncaught(|gl, _| gl.color([red, green, blue, alpha]));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([x, y, z, w]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4i(red: i32, green: i32, blue: i32, alpha: i32) {
    call_uncaught(|gl, _| {
        gl.color([convert::int(red), convert::int(green), convert::int(blue), convert::int(alpha)])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::int(x), convert::int(y), convert::int(z), convert::int(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4s(red: i16, green: i16, blue: i16, alpha: i16) {
    call_uncaught(|gl, _| {
        gl.color([
            convert::short(red),
            convert::short(green),
            convert::short(blue),
            convert::short(alpha),
        ])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::short(x), convert::short(y), convert::short(z), convert::short(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4ub(red: u8, green: u8, blue: u8, alpha: u8) {
    call_uncaught(|gl, _| {
        gl.color([
            convert::ubyte(red),
            convert::ubyte(green),
            convert::ubyte(blue),
            convert::ubyte(alpha),
        ])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4ubv(v: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::ubyte(x), convert::ubyte(y), convert::ubyte(z), convert::ubyte(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4ui(red: u32, green: u32, blue: u32, alpha: u32) {
    call_uncaught(|gl, _| {
        gl.color([
            convert::uint(red),
            convert::uint(green),
            convert::uint(blue),
            convert::uint(alpha),
        ])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4uiv(v: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::uint(x), convert::uint(y), convert::uint(z), convert::uint(w)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColor4us(red: u16, green: u16, blue: u16, alpha: u16) {
    call_uncaught(|gl, _| {
        gl.color([
            convert::ushort(red),
            convert::ushort(green),
            convert::ushort(blue),
            convert::ushort(alpha),
        ])
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glColor4usv(v: *const u16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory_uncaught(|gl, _| unsafe {
        let [x, y, z, w] = array(v)?;
        gl.color([convert::ushort(x), convert::ushort(y), convert::ushort(z), convert::ushort(w)]);
        Some(())
    });
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
pub(crate) extern "C" fn glFogCoorddEXT(coord: f64) {
    glFogCoordd(coord);
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
pub(crate) unsafe extern "C" fn glFogCoorddvEXT(coord: *const f64) {
    // SAFETY: the same contract.
    unsafe { glFogCoorddv(coord) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogCoordf(coord: f32) {
    call(|gl, _| gl.fog_coord(coord));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogCoordfEXT(coord: f32) {
    glFogCoordf(coord);
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
pub(crate) unsafe extern "C" fn glFogCoordfvEXT(coord: *const f32) {
    // SAFETY: the same contract.
    unsafe { glFogCoordfv(coord) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexd(c: f64) {
    call(|gl, _| gl.index(c as f32));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexdv(c: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(c)?;
        gl.index(x as f32);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexf(c: f32) {
    call(|gl, _| gl.index(c));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexfv(c: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(c)?;
        gl.index(x);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexi(c: i32) {
    call(|gl, _| gl.index(c as f32));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexiv(c: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(c)?;
        gl.index(x as f32);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexs(c: i16) {
    call(|gl, _| gl.index(f32::from(c)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexsv(c: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(c)?;
        gl.index(f32::from(x));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexub(c: u8) {
    call(|gl, _| gl.index(f32::from(c)));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glIndexubv(c: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x] = array(c)?;
        gl.index(f32::from(x));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1d(target: u32, s: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1dARB(target: u32, s: f64) {
    glMultiTexCoord1d(target, s);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord1dvARB(target: u32, v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord1dv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1f(target: u32, s: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1fARB(target: u32, s: f32) {
    glMultiTexCoord1f(target, s);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord1fvARB(target: u32, v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord1fv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1i(target: u32, s: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1iARB(target: u32, s: i32) {
    glMultiTexCoord1i(target, s);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord1ivARB(target: u32, v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord1iv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1s(target: u32, s: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), 0.0, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord1sARB(target: u32, s: i16) {
    glMultiTexCoord1s(target, s);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord1svARB(target: u32, v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord1sv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2d(target: u32, s: f64, t: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2dARB(target: u32, s: f64, t: f64) {
    glMultiTexCoord2d(target, s, t);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord2dvARB(target: u32, v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord2dv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2f(target: u32, s: f32, t: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2fARB(target: u32, s: f32, t: f32) {
    glMultiTexCoord2f(target, s, t);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord2fvARB(target: u32, v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord2fv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2i(target: u32, s: i32, t: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2iARB(target: u32, s: i32, t: i32) {
    glMultiTexCoord2i(target, s, t);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord2ivARB(target: u32, v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord2iv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2s(target: u32, s: i16, t: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), f32::from(t), 0.0, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord2sARB(target: u32, s: i16, t: i16) {
    glMultiTexCoord2s(target, s, t);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord2svARB(target: u32, v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord2sv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3d(target: u32, s: f64, t: f64, r: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3dARB(target: u32, s: f64, t: f64, r: f64) {
    glMultiTexCoord3d(target, s, t, r);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord3dvARB(target: u32, v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord3dv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3f(target: u32, s: f32, t: f32, r: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, r, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3fARB(target: u32, s: f32, t: f32, r: f32) {
    glMultiTexCoord3f(target, s, t, r);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord3fvARB(target: u32, v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord3fv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3i(target: u32, s: i32, t: i32, r: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3iARB(target: u32, s: i32, t: i32, r: i32) {
    glMultiTexCoord3i(target, s, t, r);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord3ivARB(target: u32, v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord3iv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3s(target: u32, s: i16, t: i16, r: i16) {
    call_uncaught(|gl, _| gl.tex_coord(target, [f32::from(s), f32::from(t), f32::from(r), 1.0]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord3sARB(target: u32, s: i16, t: i16, r: i16) {
    glMultiTexCoord3s(target, s, t, r);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord3svARB(target: u32, v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord3sv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4d(target: u32, s: f64, t: f64, r: f64, q: f64) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4dARB(target: u32, s: f64, t: f64, r: f64, q: f64) {
    glMultiTexCoord4d(target, s, t, r, q);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord4dvARB(target: u32, v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord4dv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4f(target: u32, s: f32, t: f32, r: f32, q: f32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s, t, r, q]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4fARB(target: u32, s: f32, t: f32, r: f32, q: f32) {
    glMultiTexCoord4f(target, s, t, r, q);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord4fvARB(target: u32, v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord4fv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4i(target: u32, s: i32, t: i32, r: i32, q: i32) {
    call_uncaught(|gl, _| gl.tex_coord(target, [s as f32, t as f32, r as f32, q as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4iARB(target: u32, s: i32, t: i32, r: i32, q: i32) {
    glMultiTexCoord4i(target, s, t, r, q);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord4ivARB(target: u32, v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord4iv(target, v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4s(target: u32, s: i16, t: i16, r: i16, q: i16) {
    call_uncaught(|gl, _| {
        gl.tex_coord(target, [f32::from(s), f32::from(t), f32::from(r), f32::from(q)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMultiTexCoord4sARB(target: u32, s: i16, t: i16, r: i16, q: i16) {
    glMultiTexCoord4s(target, s, t, r, q);
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
pub(crate) unsafe extern "C" fn glMultiTexCoord4svARB(target: u32, v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glMultiTexCoord4sv(target, v) };
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
pub(crate) extern "C" fn glSecondaryColor3b(red: i8, green: i8, blue: i8) {
    call(|gl, _| {
        gl.secondary_color([convert::byte(red), convert::byte(green), convert::byte(blue)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3bEXT(red: i8, green: i8, blue: i8) {
    glSecondaryColor3b(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3bv(v: *const i8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::byte(x), convert::byte(y), convert::byte(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3bvEXT(v: *const i8) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3bv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3d(red: f64, green: f64, blue: f64) {
    call(|gl, _| gl.secondary_color([red as f32, green as f32, blue as f32]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3dEXT(red: f64, green: f64, blue: f64) {
    glSecondaryColor3d(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3dv(v: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([x as f32, y as f32, z as f32]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3dvEXT(v: *const f64) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3dv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3f(red: f32, green: f32, blue: f32) {
    call(|gl, _| gl.secondary_color([red, green, blue]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3fEXT(red: f32, green: f32, blue: f32) {
    glSecondaryColor3f(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3fv(v: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([x, y, z]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3fvEXT(v: *const f32) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3fv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3i(red: i32, green: i32, blue: i32) {
    call(|gl, _| gl.secondary_color([convert::int(red), convert::int(green), convert::int(blue)]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3iEXT(red: i32, green: i32, blue: i32) {
    glSecondaryColor3i(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3iv(v: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::int(x), convert::int(y), convert::int(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3ivEXT(v: *const i32) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3iv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3s(red: i16, green: i16, blue: i16) {
    call(|gl, _| {
        gl.secondary_color([convert::short(red), convert::short(green), convert::short(blue)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3sEXT(red: i16, green: i16, blue: i16) {
    glSecondaryColor3s(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3sv(v: *const i16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::short(x), convert::short(y), convert::short(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3svEXT(v: *const i16) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3sv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3ub(red: u8, green: u8, blue: u8) {
    call(|gl, _| {
        gl.secondary_color([convert::ubyte(red), convert::ubyte(green), convert::ubyte(blue)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3ubEXT(red: u8, green: u8, blue: u8) {
    glSecondaryColor3ub(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3ubv(v: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::ubyte(x), convert::ubyte(y), convert::ubyte(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3ubvEXT(v: *const u8) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3ubv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3ui(red: u32, green: u32, blue: u32) {
    call(|gl, _| {
        gl.secondary_color([convert::uint(red), convert::uint(green), convert::uint(blue)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3uiEXT(red: u32, green: u32, blue: u32) {
    glSecondaryColor3ui(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3uiv(v: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::uint(x), convert::uint(y), convert::uint(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3uivEXT(v: *const u32) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3uiv(v) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3us(red: u16, green: u16, blue: u16) {
    call(|gl, _| {
        gl.secondary_color([convert::ushort(red), convert::ushort(green), convert::ushort(blue)])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSecondaryColor3usEXT(red: u16, green: u16, blue: u16) {
    glSecondaryColor3us(red, green, blue);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3usv(v: *const u16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let [x, y, z] = array(v)?;
        gl.secondary_color([convert::ushort(x), convert::ushort(y), convert::ushort(z)]);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSecondaryColor3usvEXT(v: *const u16) {
    // SAFETY: the same contract.
    unsafe { glSecondaryColor3usv(v) };
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
