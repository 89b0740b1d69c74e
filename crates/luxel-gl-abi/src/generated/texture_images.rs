// Written by ../../generator from gl.xml and commands.toml: change these.

//! Images of textures: from memory, from the framebuffer, mipmaps (3.8.1 to 3.8.5), queries (6.1.3, 6.1.4).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexImage1D(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    border: i32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (target, level, internalformat, width, border, image_size, data);
        gl.compressed_tex_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexImage2D(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    height: i32,
    border: i32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (target, level, internalformat, width, height, border, image_size, data);
        gl.compressed_tex_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexImage3D(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    height: i32,
    depth: i32,
    border: i32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (target, level, internalformat, width, height, depth, border, image_size, data);
        gl.compressed_tex_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexSubImage1D(
    target: u32,
    level: i32,
    xoffset: i32,
    width: i32,
    format: u32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (target, level, xoffset, width, format, image_size, data);
        gl.compressed_tex_sub_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexSubImage2D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    width: i32,
    height: i32,
    format: u32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (target, level, xoffset, yoffset, width, height, format, image_size, data);
        gl.compressed_tex_sub_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCompressedTexSubImage3D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    zoffset: i32,
    width: i32,
    height: i32,
    depth: i32,
    format: u32,
    image_size: i32,
    data: *const c_void,
) {
    call(|gl, _| {
        let _ = (
            target, level, xoffset, yoffset, zoffset, width, height, depth, format, image_size,
            data,
        );
        gl.compressed_tex_sub_image()
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyTexImage1D(
    target: u32,
    level: i32,
    internalformat: u32,
    x: i32,
    y: i32,
    width: i32,
    border: i32,
) {
    call(|gl, _| gl.copy_tex_image(1, target, level, internalformat, [x, y], [width, 1], border));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyTexImage2D(
    target: u32,
    level: i32,
    internalformat: u32,
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    border: i32,
) {
    call(|gl, _| {
        gl.copy_tex_image(2, target, level, internalformat, [x, y], [width, height], border)
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyTexSubImage1D(
    target: u32,
    level: i32,
    xoffset: i32,
    x: i32,
    y: i32,
    width: i32,
) {
    call(|gl, _| gl.copy_tex_sub_image(1, target, level, [xoffset, 0, 0], [x, y], [width, 1]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyTexSubImage2D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    x: i32,
    y: i32,
    width: i32,
    height: i32,
) {
    call(|gl, _| {
        gl.copy_tex_sub_image(2, target, level, [xoffset, yoffset, 0], [x, y], [width, height])
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCopyTexSubImage3D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    zoffset: i32,
    x: i32,
    y: i32,
    width: i32,
    height: i32,
) {
    call(|gl, _| {
        gl.copy_tex_sub_image(
            3,
            target,
            level,
            [xoffset, yoffset, zoffset],
            [x, y],
            [width, height],
        )
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGenerateMipmap(target: u32) {
    call(|gl, _| gl.generate_mipmap(target));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void) {
    call(|gl, _| {
        let _ = img;
        gl.get_compressed_tex_image(target, level)
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexImage(
    target: u32,
    level: i32,
    format: u32,
    kind: u32,
    pixels: *mut c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.get_tex_image_bytes(target, level, format, kind);
        if length > 0 {
            gl.get_tex_image(target, level, format, kind, bytes_mut(pixels, length)?);
        }

        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexLevelParameterfv(
    target: u32,
    level: i32,
    pname: u32,
    params: *mut f32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_level_parameter(target, level, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexLevelParameteriv(
    target: u32,
    level: i32,
    pname: u32,
    params: *mut i32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_level_parameter(target, level, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexImage1D(
    target: u32,
    level: i32,
    internalformat: i32,
    width: i32,
    border: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_image_bytes(
            1,
            target,
            level,
            internalformat,
            [width, 1, 1],
            border,
            format,
            kind,
        );
        gl.tex_image_1d(
            target,
            level,
            internalformat,
            width,
            border,
            format,
            kind,
            optional_bytes(pixels, length),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexImage2D(
    target: u32,
    level: i32,
    internalformat: i32,
    width: i32,
    height: i32,
    border: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_image_bytes(
            2,
            target,
            level,
            internalformat,
            [width, height, 1],
            border,
            format,
            kind,
        );
        gl.tex_image_2d(
            target,
            level,
            internalformat,
            [width, height],
            border,
            format,
            kind,
            optional_bytes(pixels, length),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexImage3D(
    target: u32,
    level: i32,
    internalformat: i32,
    width: i32,
    height: i32,
    depth: i32,
    border: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_image_bytes(
            3,
            target,
            level,
            internalformat,
            [width, height, depth],
            border,
            format,
            kind,
        );
        gl.tex_image_3d(
            target,
            level,
            internalformat,
            [width, height, depth],
            border,
            format,
            kind,
            optional_bytes(pixels, length),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexImage3DEXT(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    height: i32,
    depth: i32,
    border: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_image_bytes(
            3,
            target,
            level,
            internalformat as i32,
            [width, height, depth],
            border,
            format,
            kind,
        );
        gl.tex_image_3d(
            target,
            level,
            internalformat as i32,
            [width, height, depth],
            border,
            format,
            kind,
            optional_bytes(pixels, length),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexSubImage1D(
    target: u32,
    level: i32,
    xoffset: i32,
    width: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length =
            gl.tex_sub_image_bytes(1, target, level, [xoffset, 0, 0], [width, 1, 1], format, kind);
        gl.tex_sub_image(
            1,
            target,
            level,
            [xoffset, 0, 0],
            [width, 1, 1],
            format,
            kind,
            bytes(pixels, length)?,
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexSubImage2D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    width: i32,
    height: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_sub_image_bytes(
            2,
            target,
            level,
            [xoffset, yoffset, 0],
            [width, height, 1],
            format,
            kind,
        );
        gl.tex_sub_image(
            2,
            target,
            level,
            [xoffset, yoffset, 0],
            [width, height, 1],
            format,
            kind,
            bytes(pixels, length)?,
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexSubImage3D(
    target: u32,
    level: i32,
    xoffset: i32,
    yoffset: i32,
    zoffset: i32,
    width: i32,
    height: i32,
    depth: i32,
    format: u32,
    kind: u32,
    pixels: *const c_void,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let length = gl.tex_sub_image_bytes(
            3,
            target,
            level,
            [xoffset, yoffset, zoffset],
            [width, height, depth],
            format,
            kind,
        );
        gl.tex_sub_image(
            3,
            target,
            level,
            [xoffset, yoffset, zoffset],
            [width, height, depth],
            format,
            kind,
            bytes(pixels, length)?,
        );
        Some(())
    });
}

aliases! {
    unsafe glCompressedTexImage1DARB = glCompressedTexImage1D(target: u32, level: i32, internalformat: u32, width: i32, border: i32, image_size: i32, data: *const c_void);
    unsafe glCompressedTexImage2DARB = glCompressedTexImage2D(target: u32, level: i32, internalformat: u32, width: i32, height: i32, border: i32, image_size: i32, data: *const c_void);
    unsafe glCompressedTexImage3DARB = glCompressedTexImage3D(target: u32, level: i32, internalformat: u32, width: i32, height: i32, depth: i32, border: i32, image_size: i32, data: *const c_void);
    unsafe glCompressedTexSubImage1DARB = glCompressedTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, image_size: i32, data: *const c_void);
    unsafe glCompressedTexSubImage2DARB = glCompressedTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, image_size: i32, data: *const c_void);
    unsafe glCompressedTexSubImage3DARB = glCompressedTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, image_size: i32, data: *const c_void);
    glCopyTexSubImage3DEXT = glCopyTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, x: i32, y: i32, width: i32, height: i32);
    glGenerateMipmapEXT = glGenerateMipmap(target: u32);
    unsafe glGetCompressedTexImageARB = glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void);
    unsafe glTexSubImage3DEXT = glTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, kind: u32, pixels: *const c_void);
}
