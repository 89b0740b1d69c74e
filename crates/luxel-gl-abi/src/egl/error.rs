//! The error of the last call of a thread (EGL 1.5, 3.1).

use std::cell::Cell;

pub(super) const SUCCESS: i32 = 0x3000;
pub(super) const NOT_INITIALIZED: i32 = 0x3001;
pub(super) const BAD_ALLOC: i32 = 0x3003;
pub(super) const BAD_ATTRIBUTE: i32 = 0x3004;
pub(super) const BAD_CONFIG: i32 = 0x3005;
pub(super) const BAD_CONTEXT: i32 = 0x3006;
pub(super) const BAD_DISPLAY: i32 = 0x3008;
pub(super) const BAD_MATCH: i32 = 0x3009;
pub(super) const BAD_NATIVE_PIXMAP: i32 = 0x300A;
pub(super) const BAD_NATIVE_WINDOW: i32 = 0x300B;
pub(super) const BAD_PARAMETER: i32 = 0x300C;
pub(super) const BAD_SURFACE: i32 = 0x300D;

thread_local! {
    static LAST: Cell<i32> = const { Cell::new(SUCCESS) };
}

/// Takes the error of the last call.
pub(super) extern "C" fn get_error() -> i32 {
    LAST.replace(SUCCESS)
}

/// What a call returns, and its error: the default where there is one.
pub(super) fn answer<R: Default>(result: Result<R, i32>) -> R {
    LAST.set(result.as_ref().err().copied().unwrap_or(SUCCESS));
    result.unwrap_or_default()
}

/// As [`answer`], for calls that return whether they succeeded.
pub(super) fn succeeds(result: Result<(), i32>) -> u32 {
    answer(result.map(|()| 1))
}
