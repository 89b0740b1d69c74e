// Written by ../../generator from gl.xml and commands.toml: change these.

//! Pixels: how they are stored (3.6.1), drawing (3.6.4), bitmaps (3.7), pixel transfer and maps (3.6.3, 6.1.5), reading (4.3.2), and copying (4.3.3).

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
pub(crate) unsafe extern "C" fn glGetPixelMapfv(map: u32, values: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(table) = gl.get_pixel_map(map) {
            store_all(values, &table)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetPixelMapuiv(map: u32, values: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(table) = gl.get_pixel_map_integers(map, u32::MAX) {
            store_all(values, &table)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetPixelMapusv(map: u32, values: *mut u16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(table) = gl.get_pixel_map_integers(map, 65535) {
            store(values, table.len(), |at| table[at] as u16)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPixelMapfv(map: u32, mapsize: i32, values: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.pixel_map(map, mapsize, &copied(values, lengths::pixel_map(mapsize))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPixelMapuiv(map: u32, mapsize: i32, values: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.pixel_map_uints(map, mapsize, &copied(values, lengths::pixel_map(mapsize))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPixelMapusv(map: u32, mapsize: i32, values: *const u16) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.pixel_map_ushorts(map, mapsize, &copied(values, lengths::pixel_map(mapsize))?);
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
pub(crate) extern "C" fn glPixelTransferf(pname: u32, param: f32) {
    call(|gl, _| gl.pixel_transfer(pname, param));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPixelTransferi(pname: u32, param: i32) {
    call(|gl, _| gl.pixel_transfer(pname, param as f32));
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
