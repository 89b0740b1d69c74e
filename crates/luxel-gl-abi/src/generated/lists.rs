// Written by ../../generator from gl.xml and commands.toml: change these.

//! Display lists (5.4).

use crate::prelude::*;
use std::ffi::c_void;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glCallList(list: u32) {
    call(|gl, _| gl.call_list(list));
}

#[unsafe(no_mangle)]
pub(crate) unsafe extern "C" fn glCallLists(n: i32, kind: u32, lists: *const c_void) {
    // SAFETY: as OpenGL demands, pointers lead to as many values as the command takes.
    call_with_memory(|gl, _| unsafe {
        gl.call_lists(n, kind, bytes(lists, lengths::call_lists_bytes(n, kind))?);
        Some(())
    });
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDeleteLists(list: u32, range: i32) {
    call(|gl, _| gl.delete_lists(list, range));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glEndList() {
    call(|gl, _| gl.end_list());
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glGenLists(range: i32) -> u32 {
    call(|gl, _| gl.gen_lists(range))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIsList(list: u32) -> u8 {
    call(|gl, _| u8::from(gl.is_list(list)))
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glListBase(base: u32) {
    call(|gl, _| gl.list_base(base));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glNewList(list: u32, mode: u32) {
    call(|gl, _| gl.new_list(list, mode));
}
