//! Strings of the context (6.1.11).

use luxel_gl::Context;
use std::ffi::{CStr, CString};
use std::ptr;
use std::sync::OnceLock;

const EXTENSIONS: u32 = 0x1F03;
const INVALID_ENUM: u32 = 0x0500;
const INVALID_VALUE: u32 = 0x0501;

/// glGetString.
pub(crate) fn of(gl: &mut Context, name: u32) -> *const u8 {
    gl.get_string(name).map_or(ptr::null(), |text| text.as_ptr().cast())
}

/// glGetStringi: one name of the extension string.
pub(crate) fn extension(gl: &mut Context, name: u32, index: u32) -> *const u8 {
    if name != EXTENSIONS {
        gl.set_error(INVALID_ENUM);
        return ptr::null();
    }
    let Some(all) = gl.get_string(EXTENSIONS) else { return ptr::null() };
    match separate(all).get(index as usize) {
        Some(name) => name.as_ptr().cast(),
        None => {
            gl.set_error(INVALID_VALUE);
            ptr::null()
        }
    }
}

/// The names of the extension string, which is the same for every context.
fn separate(all: &CStr) -> &'static [CString] {
    static NAMES: OnceLock<Vec<CString>> = OnceLock::new();
    NAMES.get_or_init(|| {
        let names = all.to_bytes().split(|&byte| byte == b' ').filter(|name| !name.is_empty());
        names.filter_map(|name| CString::new(name).ok()).collect()
    })
}
