// Written by ../../generator from gl.xml and commands.toml: change these.

//! Colours of vertices (2.7).

use crate::prelude::*;

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
pub(crate) extern "C" fn glSecondaryColor3b(red: i8, green: i8, blue: i8) {
    call(|gl, _| {
        gl.secondary_color([convert::byte(red), convert::byte(green), convert::byte(blue)])
    });
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
pub(crate) extern "C" fn glSecondaryColor3d(red: f64, green: f64, blue: f64) {
    call(|gl, _| gl.secondary_color([red as f32, green as f32, blue as f32]));
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
pub(crate) extern "C" fn glSecondaryColor3f(red: f32, green: f32, blue: f32) {
    call(|gl, _| gl.secondary_color([red, green, blue]));
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
pub(crate) extern "C" fn glSecondaryColor3i(red: i32, green: i32, blue: i32) {
    call(|gl, _| gl.secondary_color([convert::int(red), convert::int(green), convert::int(blue)]));
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
pub(crate) extern "C" fn glSecondaryColor3s(red: i16, green: i16, blue: i16) {
    call(|gl, _| {
        gl.secondary_color([convert::short(red), convert::short(green), convert::short(blue)])
    });
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
pub(crate) extern "C" fn glSecondaryColor3ub(red: u8, green: u8, blue: u8) {
    call(|gl, _| {
        gl.secondary_color([convert::ubyte(red), convert::ubyte(green), convert::ubyte(blue)])
    });
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
pub(crate) extern "C" fn glSecondaryColor3ui(red: u32, green: u32, blue: u32) {
    call(|gl, _| {
        gl.secondary_color([convert::uint(red), convert::uint(green), convert::uint(blue)])
    });
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
pub(crate) extern "C" fn glSecondaryColor3us(red: u16, green: u16, blue: u16) {
    call(|gl, _| {
        gl.secondary_color([convert::ushort(red), convert::ushort(green), convert::ushort(blue)])
    });
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

aliases! {
    glSecondaryColor3bEXT = glSecondaryColor3b(red: i8, green: i8, blue: i8);
    unsafe glSecondaryColor3bvEXT = glSecondaryColor3bv(v: *const i8);
    glSecondaryColor3dEXT = glSecondaryColor3d(red: f64, green: f64, blue: f64);
    unsafe glSecondaryColor3dvEXT = glSecondaryColor3dv(v: *const f64);
    glSecondaryColor3fEXT = glSecondaryColor3f(red: f32, green: f32, blue: f32);
    unsafe glSecondaryColor3fvEXT = glSecondaryColor3fv(v: *const f32);
    glSecondaryColor3iEXT = glSecondaryColor3i(red: i32, green: i32, blue: i32);
    unsafe glSecondaryColor3ivEXT = glSecondaryColor3iv(v: *const i32);
    glSecondaryColor3sEXT = glSecondaryColor3s(red: i16, green: i16, blue: i16);
    unsafe glSecondaryColor3svEXT = glSecondaryColor3sv(v: *const i16);
    glSecondaryColor3ubEXT = glSecondaryColor3ub(red: u8, green: u8, blue: u8);
    unsafe glSecondaryColor3ubvEXT = glSecondaryColor3ubv(v: *const u8);
    glSecondaryColor3uiEXT = glSecondaryColor3ui(red: u32, green: u32, blue: u32);
    unsafe glSecondaryColor3uivEXT = glSecondaryColor3uiv(v: *const u32);
    glSecondaryColor3usEXT = glSecondaryColor3us(red: u16, green: u16, blue: u16);
    unsafe glSecondaryColor3usvEXT = glSecondaryColor3usv(v: *const u16);
}
