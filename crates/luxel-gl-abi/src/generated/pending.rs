// Written by ../../generator from gl.xml and commands.toml: change these.

//! Commands of OpenGL 1.5 and of framebuffer objects that are not carried out yet.

use std::ffi::c_void;

crate::entry::unsupported! {
    glCompressedTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage1DARB(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage2DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glCompressedTexSubImage3DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void);
    glGetCompressedTexImageARB(target: u32, level: i32, img: *mut c_void);
}
