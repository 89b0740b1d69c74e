//! Strings (GLU 1.3, chapters 2 and 8).

use luxel_glu::{EXTENSIONS, VERSION, error_string, has_extension};
use std::ffi::{CStr, c_char};
use std::ptr;

/// What an error is called; null for numbers that are none.
#[unsafe(no_mangle)]
extern "C" fn gluErrorString(error: u32) -> *const u8 {
    error_string(error).map_or(ptr::null(), |text| text.as_ptr().cast())
}

/// The version and the extensions; null for other names.
#[unsafe(no_mangle)]
extern "C" fn gluGetString(name: u32) -> *const u8 {
    match name {
        100_800 => VERSION.as_ptr().cast(),
        100_801 => EXTENSIONS.as_ptr().cast(),
        _ => ptr::null(),
    }
}

/// Whether a name is in a list of extensions.
#[unsafe(no_mangle)]
unsafe extern "C" fn gluCheckExtension(name: *const c_char, extensions: *const c_char) -> u8 {
    if name.is_null() || extensions.is_null() {
        return 0;
    }
    // SAFETY: the caller passes two strings that a 0 ends.
    let (name, extensions) = unsafe { (CStr::from_ptr(name), CStr::from_ptr(extensions)) };
    u8::from(has_extension(name.to_bytes(), extensions.to_bytes()))
}
