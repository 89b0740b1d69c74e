// Written by ../../generator from gl.xml and commands.toml: change these.

//! Textures: generated coordinates (2.11.4), parameters, objects, environments (3.8), queries (6.1.3, 6.1.4).

use crate::prelude::*;

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
        store_all(textures, &gl.gen_textures(n))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexEnvfv(target: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_env(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexEnviv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_env(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGendv(coord: u32, pname: u32, params: *mut f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_gen(coord, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGenfv(coord: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_gen(coord, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexGeniv(coord: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_gen(coord, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexParameterfv(target: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_parameter(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetTexParameteriv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_tex_parameter(target, pname))?;
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

aliases! {
    glBindTextureEXT = glBindTexture(target: u32, texture: u32);
    unsafe glPrioritizeTexturesEXT = glPrioritizeTextures(n: i32, textures: *const u32, priorities: *const f32);
}
