//! State that queries return, in the type of the caller's array.

use crate::memory::store;
use luxel_gl::Values;

/// A type of queries: `GLboolean`, `GLint`, `GLint64`, `GLfloat`, `GLdouble`.
pub(crate) trait Returned {
    /// Value `at`, converted by section 6.1.2.
    fn of(values: &Values, at: usize) -> Self;
}

impl Returned for u8 {
    fn of(values: &Values, at: usize) -> Self {
        values.to_bool(at)
    }
}

impl Returned for i32 {
    fn of(values: &Values, at: usize) -> Self {
        values.to_i32(at)
    }
}

impl Returned for i64 {
    fn of(values: &Values, at: usize) -> Self {
        values.to_i32(at).into()
    }
}

impl Returned for f32 {
    fn of(values: &Values, at: usize) -> Self {
        values.to_f32(at)
    }
}

impl Returned for f64 {
    fn of(values: &Values, at: usize) -> Self {
        values.to_f64(at)
    }
}

/// Writes the values of a query at `address`; nothing after an error.
///
/// # Safety
///
/// `address` is null, or as many values can be written there.
pub(crate) unsafe fn returned<T: Returned>(address: *mut T, values: Option<Values>) -> Option<()> {
    let Some(values) = values else { return Some(()) };
    // SAFETY: the same promise.
    unsafe { store(address, values.len(), |at| T::of(&values, at)) }
}
