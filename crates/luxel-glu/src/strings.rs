//! Strings: of errors, versions, and lists of extensions (GLU 1.3, chapters 2 and 8).

use std::ffi::CStr;

/// `GLU_VERSION` of `gluGetString`.
pub const VERSION: &CStr = c"1.3";
/// `GLU_EXTENSIONS` of `gluGetString`: there are none.
pub const EXTENSIONS: &CStr = c"";

/// What an error of OpenGL or GLU is called (`gluErrorString`); `None` for numbers that are none.
#[must_use]
pub fn error_string(error: u32) -> Option<&'static CStr> {
    Some(match error {
        0 => c"no error",
        0x0500 | 100_900 => c"invalid enumerant",
        0x0501 | 100_901 => c"invalid value",
        0x0502 | 100_904 => c"invalid operation",
        0x0503 => c"stack overflow",
        0x0504 => c"stack underflow",
        0x0505 | 100_902 => c"out of memory",
        0x0506 => c"invalid framebuffer operation",
        0x8031 => c"table too large",
        100_903 => c"incompatible gl version",
        100_151 => c"gluTessBeginPolygon must come before gluTessEndPolygon",
        100_152 => c"gluTessBeginContour must come before gluTessEndContour",
        100_153 => c"gluTessEndPolygon must follow gluTessBeginPolygon",
        100_154 => c"gluTessEndContour must follow gluTessBeginContour",
        100_155 => c"a coordinate is too large",
        100_156 => c"contours cross: a combine callback is needed",
        100_251..=100_287 => c"NURBS error",
        _ => return None,
    })
}

/// Whether `name` is one of the names in `extensions`, which blanks separate (`gluCheckExtension`).
#[must_use]
pub fn has_extension(name: &[u8], extensions: &[u8]) -> bool {
    !name.is_empty() && extensions.split(|&byte| byte == b' ').any(|word| word == name)
}
