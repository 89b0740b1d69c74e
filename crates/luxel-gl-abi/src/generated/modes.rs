// Written by ../../generator from gl.xml and commands.toml: change these.

//! Selection (5.2) and feedback (5.3).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glFeedbackBuffer(size: i32, kind: u32, buffer: *mut f32) {
    call(|gl, client| {
        if gl.feedback_buffer(size, kind) {
            client.feedback = CallerArray::new(buffer, size)
        }
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetPointerv(pname: u32, params: *mut *mut c_void) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, client| unsafe {
        if let Some(address) = pointer_query::address(gl, client, pname) {
            store(params, 1, |_| address)?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glInitNames() {
    call(|gl, _| gl.init_names());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLoadName(name: u32) {
    call(|gl, _| gl.load_name(name));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPassThrough(token: f32) {
    call(|gl, _| gl.pass_through(token));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPopName() {
    call(|gl, _| gl.pop_name());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glPushName(name: u32) {
    call(|gl, _| gl.push_name(name));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glRenderMode(mode: u32) -> i32 {
    call(|gl, client| client.render_mode(gl, mode))
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glSelectBuffer(size: i32, buffer: *mut u32) {
    call(|gl, client| {
        if gl.select_buffer(size) {
            client.selection = CallerArray::new(buffer, size)
        }
    });
}

aliases! {
    unsafe glGetPointervEXT = glGetPointerv(pname: u32, params: *mut *mut c_void);
}
