// Written by ../../generator from gl.xml and commands.toml: change these.

//! Pixels: how they are stored (3.6.1), drawing (3.6.4), bitmaps (3.7), reading (4.3.2), and copying (4.3.3).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glBitmap(
    width: i32,
    height: i32,
    xorig: f32,
    yorig: f32,
    xmove: f32,
    ymove: f32,
    bitmap: *const u8,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.bitmap_bytes(width, height);
        gl.bitmap(
            [width, height],
            [xorig, yorig],
            [xmove, ymove],
            optional_bytes(bitmap.cast(), length),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyPixels(x: i32, y: i32, width: i32, height: i32, kind: u32) {
    call(|gl, _| gl.copy_pixels([x, y], [width, height], kind));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDrawPixels(
    width: i32,
    height: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.draw_pixels_bytes([width, height], format, kind);
        gl.draw_pixels(
            [width, height],
            format,
            kind,
            if length > 0 { bytes(pixels, length)? } else { &[] },
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPixelStoref(pname: u32, param: f32) {
    call(|gl, _| gl.pixel_store(pname, param));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPixelStorei(pname: u32, param: i32) {
    call(|gl, _| gl.pixel_store(pname, param as f32));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPixelZoom(xfactor: f32, yfactor: f32) {
    call(|gl, _| gl.pixel_zoom(xfactor, yfactor));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glReadBuffer(src: u32) {
    call(|gl, _| gl.read_buffer(src));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glReadPixels(
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    format: u32,
    kind: u32,
    pixels: *mut c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.pack_bytes(width, height, format, kind);
        if length > 0 {
            gl.read_pixels(x, y, width, height, format, kind, bytes_mut(pixels, length)?);
        }

        Some(())
    });
}
