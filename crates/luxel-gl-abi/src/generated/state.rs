// Written by ../../generator from gl.xml and commands.toml: change these.

//! Errors (2.5), enables, flush and finish (5.5), hints (5.6), queries and attribute stacks (6.1).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClientActiveTexture(texture: u32) {
    call(|gl, _| gl.client_active_texture(texture));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDisable(cap: u32) {
    call(|gl, _| gl.disable(cap));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEnable(cap: u32) {
    call(|gl, _| gl.enable(cap));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFinish() {
    call(|gl, client| {
        gl.finish();
        client.present(gl)
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glFlush() {
    call(|gl, client| {
        gl.flush();
        client.present(gl)
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetBooleanv(pname: u32, data: *mut u8) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(data, gl.get(pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetDoublev(pname: u32, data: *mut f64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(data, gl.get(pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGetError() -> u32 {
    call(|gl, _| gl.get_error())
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetFloatv(pname: u32, data: *mut f32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(data, gl.get(pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetInteger64v(pname: u32, data: *mut i64) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(data, gl.get(pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetIntegerv(pname: u32, data: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(data, gl.get(pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGetString(name: u32) -> *const u8 {
    call(|gl, _| strings::of(gl, name))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGetStringi(name: u32, index: u32) -> *const u8 {
    call(|gl, _| strings::extension(gl, name, index))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glHint(target: u32, mode: u32) {
    call(|gl, _| gl.hint(target, mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsEnabled(cap: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_enabled(cap)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPopAttrib() {
    call(|gl, _| gl.pop_attrib());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPopClientAttrib() {
    call(|gl, _| gl.pop_client_attrib());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPushAttrib(mask: u32) {
    call(|gl, _| gl.push_attrib(mask));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPushClientAttrib(mask: u32) {
    call(|gl, _| gl.push_client_attrib(mask));
}

aliases! {
    glClientActiveTextureARB = glClientActiveTexture(texture: u32);
}
