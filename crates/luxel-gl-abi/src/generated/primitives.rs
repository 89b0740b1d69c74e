// Written by ../../generator from gl.xml and commands.toml: change these.

//! Points, lines and polygons (3.3 to 3.5).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCullFace(mode: u32) {
    call(|gl, _| gl.cull_face(mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFrontFace(mode: u32) {
    call(|gl, _| gl.front_face(mode));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetPolygonStipple(mask: *mut u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.stipple_bytes(true);
        gl.get_polygon_stipple(bytes_mut(mask.cast(), length)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLineStipple(factor: i32, pattern: u16) {
    call(|gl, _| gl.line_stipple(factor, pattern));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLineWidth(width: f32) {
    call(|gl, _| gl.line_width(width));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPointParameterf(pname: u32, param: f32) {
    call(|gl, _| gl.point_parameter(pname, single(&param, lengths::point_parameter(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPointParameterfv(pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.point_parameter(pname, &few(params, lengths::point_parameter(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPointParameteri(pname: u32, param: i32) {
    call(|gl, _| {
        gl.point_parameter(pname, single(&(param as f32), lengths::point_parameter(pname)))
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPointParameteriv(pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.point_parameter(
            pname,
            &from_integers(pname, &few(params, lengths::point_parameter(pname))?),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPointSize(size: f32) {
    call(|gl, _| gl.point_size(size));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPolygonMode(face: u32, mode: u32) {
    call(|gl, _| gl.polygon_mode(face, mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPolygonOffset(factor: f32, units: f32) {
    call(|gl, _| gl.polygon_offset(factor, units));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPolygonStipple(mask: *const u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.stipple_bytes(false);
        gl.polygon_stipple(bytes(mask.cast(), length)?);
        Some(())
    });
}

aliases! {
    glPointParameterfARB = glPointParameterf(pname: u32, param: f32);
    glPointParameterfEXT = glPointParameterf(pname: u32, param: f32);
    unsafe glPointParameterfvARB = glPointParameterfv(pname: u32, params: *const f32);
    unsafe glPointParameterfvEXT = glPointParameterfv(pname: u32, params: *const f32);
}
