// Written by ../../generator from gl.xml and commands.toml: change these.

//! Occlusion queries (4.1.7, 6.1.12).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBeginQuery(target: u32, id: u32) {
    call(|gl, _| gl.begin_query(target, id));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glDeleteQueries(n: i32, ids: *const u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if n < 0 {
            gl.set_error(GL_INVALID_VALUE);
        } else {
            gl.delete_queries(&copied(ids, n)?);
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEndQuery(target: u32) {
    call(|gl, _| gl.end_query(target));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenQueries(n: i32, ids: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        store_all(ids, &gl.gen_queries(n))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetQueryObjectiv(id: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(value) = gl.get_query_object(id, pname) {
            store(params, 1, |_| i32::try_from(value).unwrap_or(i32::MAX))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetQueryObjectuiv(id: u32, pname: u32, params: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(value) = gl.get_query_object(id, pname) {
            store(params, 1, |_| u32::try_from(value).unwrap_or(u32::MAX))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetQueryiv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        returned(params, gl.get_query(target, pname))?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsQuery(id: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_query(id)))
}

aliases! {
    glBeginQueryARB = glBeginQuery(target: u32, id: u32);
    unsafe glDeleteQueriesARB = glDeleteQueries(n: i32, ids: *const u32);
    glEndQueryARB = glEndQuery(target: u32);
    unsafe glGenQueriesARB = glGenQueries(n: i32, ids: *mut u32);
    unsafe glGetQueryObjectivARB = glGetQueryObjectiv(id: u32, pname: u32, params: *mut i32);
    unsafe glGetQueryObjectuivARB = glGetQueryObjectuiv(id: u32, pname: u32, params: *mut u32);
    unsafe glGetQueryivARB = glGetQueryiv(target: u32, pname: u32, params: *mut i32);
    glIsQueryARB = glIsQuery(id: u32) -> u8;
}
