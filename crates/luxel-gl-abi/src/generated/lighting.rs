// Written by ../../generator from gl.xml and commands.toml: change these.

//! Lights, materials (2.14) and fog (3.10).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColorMaterial(face: u32, mode: u32) {
    call(|gl, _| gl.color_material(face, mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogf(pname: u32, param: f32) {
    call(|gl, _| gl.fog(pname, single(&param, lengths::fog(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFogfv(pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.fog(pname, &few(params, lengths::fog(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFogi(pname: u32, param: i32) {
    call(|gl, _| gl.fog(pname, single(&(param as f32), lengths::fog(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFogiv(pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.fog(pname, &from_integers(pname, &few(params, lengths::fog(pname))?));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetLightfv(light: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_light(light, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetLightiv(light: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_light(light, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetMaterialfv(face: u32, pname: u32, params: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_material(face, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetMaterialiv(face: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_material(face, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLightModelf(pname: u32, param: f32) {
    call(|gl, _| gl.light_model(pname, single(&param, lengths::light_model(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLightModelfv(pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.light_model(pname, &few(params, lengths::light_model(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLightModeli(pname: u32, param: i32) {
    call(|gl, _| gl.light_model(pname, single(&(param as f32), lengths::light_model(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLightModeliv(pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.light_model(pname, &from_integers(pname, &few(params, lengths::light_model(pname))?));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLightf(light: u32, pname: u32, param: f32) {
    call(|gl, _| gl.light(light, pname, single(&param, lengths::light(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLightfv(light: u32, pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.light(light, pname, &few(params, lengths::light(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLighti(light: u32, pname: u32, param: i32) {
    call(|gl, _| gl.light(light, pname, single(&(param as f32), lengths::light(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glLightiv(light: u32, pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.light(light, pname, &from_integers(pname, &few(params, lengths::light(pname))?));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMaterialf(face: u32, pname: u32, param: f32) {
    call(|gl, _| gl.material(face, pname, single(&param, lengths::material(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMaterialfv(face: u32, pname: u32, params: *const f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.material(face, pname, &few(params, lengths::material(pname))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glMateriali(face: u32, pname: u32, param: i32) {
    call(|gl, _| gl.material(face, pname, single(&(param as f32), lengths::material(pname))));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glMaterialiv(face: u32, pname: u32, params: *const i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.material(face, pname, &from_integers(pname, &few(params, lengths::material(pname))?));
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glShadeModel(mode: u32) {
    call(|gl, _| gl.shade_model(mode));
}
