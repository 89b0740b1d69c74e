// Written by ../../generator from gl.xml and commands.toml: change these.

//! Textures: generated coordinates (2.11.4), images, objects, environments (3.8), queries (6.1.3, 6.1.4).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glAreTexturesResident(
    n: i32,
    textures: *const u32,
    residences: *mut u8,
) -> u8 {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        Some({
            let _ = residences;
            u8::from(gl.are_textures_resident(n, &copied(textures, n)?).is_some())
        })
    })
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindTexture(target: u32, texture: u32) {
    call(|gl, _| gl.bind_texture(target, texture));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBindTextureEXT(target: u32, texture: u32) {
    glBindTexture(target, texture);
}

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
pub(crate) unsafe extern "C" fn glCompressedTexImage1DARB(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    border: i32,
    image_size: i32,
    data: *const c_void,
) {
    // SAFETY: the same contract.
    unsafe {
        glCompressedTexImage1D(target, level, internalformat, width, border, image_size, data)
    };
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
pub(crate) unsafe extern "C" fn glCompressedTexImage2DARB(
    target: u32,
    level: i32,
    internalformat: u32,
    width: i32,
    height: i32,
    border: i32,
    image_size: i32,
    data: *const c_void,
) {
    // SAFETY: the same contract.
    unsafe {
        glCompressedTexImage2D(
            target,
            level,
            internalformat,
            width,
            height,
            border,
            image_size,
            data,
        )
    };
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
pub(crate) unsafe extern "C" fn glCompressedTexImage3DARB(
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
    // SAFETY: the same contract.
    unsafe {
        glCompressedTexImage3D(
            target,
            level,
            internalformat,
            width,
            height,
            depth,
            border,
            image_size,
            data,
        )
    };
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
pub(crate) extern "C" fn glCopyTexSubImage3DEXT(
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
    glCopyTexSubImage3D(target, level, xoffset, yoffset, zoffset, x, y, width, height);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDeleteTextures(n: i32, textures: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.delete_textures(n, &copied(textures, n)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenTextures(n: i32, textures: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let names = gl.gen_textures(n);
        store(textures, names.len(), |at| names[at])?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGenerateMipmap(target: u32) {
    call(|gl, _| gl.generate_mipmap(target));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGenerateMipmapEXT(target: u32) {
    glGenerateMipmap(target);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexEnvfv(target: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_env(target, pname) {
            store(params, values.len(), |at| values.to_f32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexEnviv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_env(target, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGendv(coord: u32, pname: u32, params: *mut f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_gen(coord, pname) {
            store(params, values.len(), |at| values.to_f64(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGenfv(coord: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_gen(coord, pname) {
            store(params, values.len(), |at| values.to_f32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGeniv(coord: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_gen(coord, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }
        Some(())
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
        if let Some(values) = gl.get_tex_level_parameter(target, level, pname) {
            store(params, values.len(), |at| values.to_f32(at))?;
        }
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
        if let Some(values) = gl.get_tex_level_parameter(target, level, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexParameterfv(target: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_parameter(target, pname) {
            store(params, values.len(), |at| values.to_f32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexParameteriv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_tex_parameter(target, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsTexture(texture: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_texture(texture)))
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPrioritizeTextures(
    n: i32,
    textures: *const u32,
    priorities: *const f32,
) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.prioritize_textures(n, &copied(textures, n)?, &copied(priorities, n)?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glPrioritizeTexturesEXT(
    n: i32,
    textures: *const u32,
    priorities: *const f32,
) {
    // SAFETY: the same contract.
    unsafe { glPrioritizeTextures(n, textures, priorities) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexEnvf(target: u32, pname: u32, param: f32) {
    call(|gl, _| gl.tex_env(target, pname, single(&param, lengths::tex_env(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexEnvfv(target: u32, pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_env(target, pname, &few(params, lengths::tex_env(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexEnvi(target: u32, pname: u32, param: i32) {
    call(|gl, _| gl.tex_env(target, pname, single(&(param as f32), lengths::tex_env(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexEnviv(target: u32, pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_env(target, pname, &from_integers(pname, &few(params, lengths::tex_env(pname))?));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexGend(coord: u32, pname: u32, param: f64) {
    call(|gl, _| gl.tex_gen(coord, pname, single(&(param as f32), lengths::tex_gen(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexGendv(coord: u32, pname: u32, params: *const f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_gen(
            coord,
            pname,
            &few(params, lengths::tex_gen(pname))?.map(|value: f64| value as f32),
        );
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexGenf(coord: u32, pname: u32, param: f32) {
    call(|gl, _| gl.tex_gen(coord, pname, single(&param, lengths::tex_gen(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexGenfv(coord: u32, pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_gen(coord, pname, &few(params, lengths::tex_gen(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexGeni(coord: u32, pname: u32, param: i32) {
    call(|gl, _| gl.tex_gen(coord, pname, single(&(param as f32), lengths::tex_gen(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexGeniv(coord: u32, pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_gen(
            coord,
            pname,
            &few(params, lengths::tex_gen(pname))?.map(|value: i32| value as f32),
        );
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
        let length = gl.tex_image_bytes(1, target, [width, 1, 1], format, kind);
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
        let length = gl.tex_image_bytes(2, target, [width, height, 1], format, kind);
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
        let length = gl.tex_image_bytes(3, target, [width, height, depth], format, kind);
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
        let length = gl.tex_image_bytes(3, target, [width, height, depth], format, kind);
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
pub(crate) extern "C" fn glTexParameterf(target: u32, pname: u32, param: f32) {
    call(|gl, _| gl.tex_parameter(target, pname, single(&param, lengths::tex_parameter(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexParameterfv(target: u32, pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_parameter(target, pname, &few(params, lengths::tex_parameter(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glTexParameteri(target: u32, pname: u32, param: i32) {
    call(|gl, _| {
        gl.tex_parameter(target, pname, single(&(param as f32), lengths::tex_parameter(pname)))
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexParameteriv(target: u32, pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.tex_parameter(
            target,
            pname,
            &from_integers(pname, &few(params, lengths::tex_parameter(pname))?),
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
        let length = gl.tex_image_bytes(1, target, [width, 1, 1], format, kind);
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
        let length = gl.tex_image_bytes(2, target, [width, height, 1], format, kind);
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
        let length = gl.tex_image_bytes(3, target, [width, height, depth], format, kind);
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

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glTexSubImage3DEXT(
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
    // SAFETY: the same contract.
    unsafe {
        glTexSubImage3D(
            target, level, xoffset, yoffset, zoffset, width, height, depth, format, kind, pixels,
        )
    };
}
