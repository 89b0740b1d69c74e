// Written by ../../generator from gl.xml and commands.toml: change these.

//! Occlusion queries (4.1.7, 6.1.12).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBeginQuery(target: u32, id: u32) {
    call(|gl, _| gl.begin_query(target, id));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBeginQueryARB(target: u32, id: u32) {
    glBeginQuery(target, id);
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
pub(crate) unsafe extern "C" fn glDeleteQueriesARB(n: i32, ids: *const u32) {
    // SAFETY: the same contract.
    unsafe { glDeleteQueries(n, ids) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEndQuery(target: u32) {
    call(|gl, _| gl.end_query(target));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEndQueryARB(target: u32) {
    glEndQuery(target);
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenQueries(n: i32, ids: *mut u32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        let names = gl.gen_queries(n);
        store(ids, names.len(), |at| names[at])?;
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGenQueriesARB(n: i32, ids: *mut u32) {
    // SAFETY: the same contract.
    unsafe { glGenQueries(n, ids) };
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
pub(crate) unsafe extern "C" fn glGetQueryObjectivARB(id: u32, pname: u32, params: *mut i32) {
    // SAFETY: the same contract.
    unsafe { glGetQueryObjectiv(id, pname, params) };
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
pub(crate) unsafe extern "C" fn glGetQueryObjectuivARB(id: u32, pname: u32, params: *mut u32) {
    // SAFETY: the same contract.
    unsafe { glGetQueryObjectuiv(id, pname, params) };
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetQueryiv(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        if let Some(values) = gl.get_query(target, pname) {
            store(params, values.len(), |at| values.to_i32(at))?;
        }
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glGetQueryivARB(target: u32, pname: u32, params: *mut i32) {
    // SAFETY: the same contract.
    unsafe { glGetQueryiv(target, pname, params) };
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsQuery(id: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_query(id)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsQueryARB(id: u32) -> u8 {
    glIsQuery(id)
}
