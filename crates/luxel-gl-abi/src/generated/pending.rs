// Written by ../../generator from gl.xml and commands.toml: change these.

//! Commands of OpenGL 1.5 and of framebuffer objects that are not carried out yet.

use std::ffi::c_void;

crate::entry::unsupported! {
    glAccum(op: u32, value: f32);
    glCompressedTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage1DARB(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void);
    glGetCompressedTexImageARB(target: u32, level: i32, img: *mut c_void);
    glGetPixelMapfv(map: u32, values: *mut f32);
    glGetPixelMapuiv(map: u32, values: *mut u32);
    glGetPixelMapusv(map: u32, values: *mut u16);
    glPixelMapfv(map: u32, mapsize: i32, values: *const f32);
    glPixelMapuiv(map: u32, mapsize: i32, values: *const u32);
    glPixelMapusv(map: u32, mapsize: i32, values: *const u16);
    glPixelTransferf(pname: u32, param: f32);
    glPixelTransferi(pname: u32, param: i32);
    glSampleCoverage(value: f32, invert: u8);
    glSampleCoverageARB(value: f32, invert: u8);
}
