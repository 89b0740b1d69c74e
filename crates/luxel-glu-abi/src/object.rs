//! Objects that the caller holds by address.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// A function of any type: what callbacks are registered as.
pub(crate) type Callback = Option<unsafe extern "C" fn()>;

/// `which` of the callbacks for errors.
pub(crate) const ERROR: u32 = 100_103;

/// The errors of GLU.
pub(crate) const INVALID_ENUM: u32 = 100_900;
pub(crate) const INVALID_VALUE: u32 = 100_901;
pub(crate) const OUT_OF_MEMORY: u32 = 100_902;
pub(crate) const INVALID_OPERATION: u32 = 100_904;

/// Hands an object to the caller.
pub(crate) fn give<T>(object: T) -> *mut T {
    Box::into_raw(Box::new(object))
}

/// Takes an object back, and ends it; null is none.
///
/// # Safety
///
/// The address is null or from [`give`], and nobody uses it any more.
pub(crate) unsafe fn take<T>(address: *mut T) {
    if !address.is_null() {
        // SAFETY: the caller of this function promises it.
        drop(unsafe { Box::from_raw(address) });
    }
}

/// What `f` makes of an object; the default if the address is null.
///
/// `f` must not call functions of the caller, which may use the object.
///
/// # Safety
///
/// The address is null or from [`give`], and the object not yet taken.
pub(crate) unsafe fn with<T, R: Default>(address: *mut T, f: impl FnOnce(&mut T) -> R) -> R {
    if address.is_null() {
        return R::default();
    }
    // SAFETY: the caller of this function promises that the object lives; no other reference to it exists, since none
    // outlives a function of the library and objects are used by one thread at a time.
    f(unsafe { &mut *address })
}

/// What `f` returns; `None` after a panic, which may not cross into C.
pub(crate) fn caught<R>(f: impl FnOnce() -> R) -> Option<R> {
    catch_unwind(AssertUnwindSafe(f)).ok()
}

/// Calls an error callback.
pub(crate) fn report(callback: Callback, error: u32) {
    let Some(function) = callback else { return };
    // SAFETY: the caller registered it as a function that takes an error.
    let function: unsafe extern "C" fn(u32) = unsafe { std::mem::transmute(function) };
    // SAFETY: as above.
    unsafe { function(error) };
}

/// `N` values at an address; `None` if it is null.
///
/// # Safety
///
/// The address is null, or `N` values can be read there.
pub(crate) unsafe fn array<T: Copy, const N: usize>(address: *const T) -> Option<[T; N]> {
    if address.is_null() {
        return None;
    }
    // SAFETY: the caller of this function promises it; an array has the layout of its values.
    Some(unsafe { address.cast::<[T; N]>().read_unaligned() })
}

/// Writes a value, unless the address is null.
///
/// # Safety
///
/// The address is null, or a value can be written there.
pub(crate) unsafe fn store<T>(address: *mut T, value: T) {
    if !address.is_null() {
        // SAFETY: the caller of this function promises it.
        unsafe { address.write_unaligned(value) };
    }
}
