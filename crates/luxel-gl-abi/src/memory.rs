//! The caller's memory as values and slices.
//!
//! How many values a pointer leads to is computed by `luxel_gl`, from the command's arguments and the context's state;
//! here pointers become values. A null pointer where values are due gives `None`: the command is left out, with an
//! error, where a C library would crash. Values may be unaligned.

use luxel_gl::ClientMemory;
use std::ffi::c_void;
use std::ops::Deref;
use std::{ptr, slice};

/// The most values that a parameter of OpenGL 1.5 has: a matrix.
const MOST: usize = 16;

/// A few values that the caller passed by address.
pub(crate) struct Few<T> {
    values: [T; MOST],
    length: usize,
}

impl<T> Deref for Few<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        &self.values[..self.length]
    }
}

impl<T: Copy> Few<T> {
    /// Each value by `f`.
    pub(crate) fn map<U>(&self, f: impl Fn(T) -> U) -> Few<U> {
        Few { values: self.values.map(f), length: self.length }
    }
}

/// `N` values at `address`.
///
/// # Safety
///
/// `address` is null, or `N` values can be read there.
pub(crate) unsafe fn array<T: Copy, const N: usize>(address: *const T) -> Option<[T; N]> {
    if address.is_null() {
        return None;
    }
    // SAFETY: the caller of this function promises N values; an array of them has their layout.
    Some(unsafe { address.cast::<[T; N]>().read_unaligned() })
}

/// `length` values at `address`, at most 16.
///
/// # Safety
///
/// `address` is null, or `length` values can be read there.
pub(crate) unsafe fn few<T: Copy + Default>(address: *const T, length: usize) -> Option<Few<T>> {
    let mut few = Few { values: [T::default(); MOST], length: length.min(MOST) };
    if address.is_null() && length > 0 {
        return None;
    }
    for at in 0..few.length {
        // SAFETY: `at` is below `length`.
        few.values[at] = unsafe { address.add(at).read_unaligned() };
    }
    Some(few)
}

/// `count` values at `address`; none for a negative count.
///
/// # Safety
///
/// `address` is null, or `count` values can be read there.
pub(crate) unsafe fn copied<T: Copy>(address: *const T, count: i32) -> Option<Vec<T>> {
    let count = usize::try_from(count).unwrap_or(0);
    if address.is_null() && count > 0 {
        return None;
    }
    // SAFETY: each index is below the count that the caller of this function promises.
    Some((0..count).map(|at| unsafe { address.add(at).read_unaligned() }).collect())
}

/// Reads every byte once in builds for the address sanitizer, which watches this crate alone: slices are read by code that
/// it doesn't see.
///
/// # Safety
///
/// `length` bytes can be read at `address`.
#[inline(always)]
unsafe fn watch(address: *const u8, length: usize) {
    if cfg!(luxel_watched) {
        for at in 0..length {
            // SAFETY: `at` is below `length`.
            unsafe { address.add(at).read_volatile() };
        }
    }
}

/// `length` bytes at `address`.
///
/// # Safety
///
/// `address` is null, or `length` bytes can be read there, and nobody writes there while the slice lives.
pub(crate) unsafe fn bytes<'a>(address: *const c_void, length: usize) -> Option<&'a [u8]> {
    if length == 0 {
        return Some(&[]);
    }
    if address.is_null() || length > isize::MAX as usize {
        return None;
    }
    // SAFETY: bytes have no alignment, and the caller of this function promises as many.
    unsafe {
        watch(address.cast(), length);
        Some(slice::from_raw_parts(address.cast(), length))
    }
}

/// `length` bytes at `address`, or `None` where a null pointer means that there are none.
///
/// # Safety
///
/// As of [`bytes`].
pub(crate) unsafe fn optional_bytes<'a>(address: *const c_void, length: usize) -> Option<&'a [u8]> {
    // SAFETY: the same promise.
    if address.is_null() { None } else { unsafe { bytes(address, length) } }
}

/// `length` bytes to write at `address`.
///
/// # Safety
///
/// `address` is null, or `length` bytes can be written there, and nobody else uses them while the slice lives.
pub(crate) unsafe fn bytes_mut<'a>(address: *mut c_void, length: usize) -> Option<&'a mut [u8]> {
    if length == 0 {
        return Some(&mut []);
    }
    if address.is_null() || length > isize::MAX as usize {
        return None;
    }
    // SAFETY: bytes have no alignment, and the caller of this function promises as many.
    unsafe {
        watch(address.cast(), length);
        Some(slice::from_raw_parts_mut(address.cast(), length))
    }
}

/// Writes `length` values at `address`.
///
/// # Safety
///
/// `address` is null, or `length` values can be written there.
pub(crate) unsafe fn store<T>(
    address: *mut T,
    length: usize,
    value: impl Fn(usize) -> T,
) -> Option<()> {
    if address.is_null() && length > 0 {
        return None;
    }
    for at in 0..length {
        // SAFETY: `at` is below `length`.
        unsafe { address.add(at).write_unaligned(value(at)) };
    }
    Some(())
}

/// Writes `values` at `address`.
///
/// # Safety
///
/// `address` is null, or as many values can be written there.
pub(crate) unsafe fn store_all<T: Copy>(address: *mut T, values: &[T]) -> Option<()> {
    // SAFETY: the same promise.
    unsafe { store(address, values.len(), |at| values[at]) }
}

/// The number of an address that the library keeps: of arrays, and of offsets into buffers.
pub(crate) fn address<T>(pointer: *const T) -> usize {
    pointer.expose_provenance()
}

/// A size in bytes; none for a negative one, which commands refuse.
pub(crate) fn extent(size: isize) -> usize {
    usize::try_from(size).unwrap_or(0)
}

/// The caller's memory, where arrays are at addresses that it gave earlier.
pub(crate) struct CallerMemory(());

/// The caller's memory for the length of a command.
///
/// # Safety
///
/// What the caller's arrays have, by their sizes, strides and the vertices that are drawn, can be read while the value
/// lives.
pub(crate) unsafe fn caller_memory() -> CallerMemory {
    CallerMemory(())
}

impl ClientMemory for CallerMemory {
    fn bytes(&self, address: usize, length: usize) -> &[u8] {
        if address == 0 || length == 0 || length > isize::MAX as usize {
            return &[];
        }
        // SAFETY: the caller of `caller_memory` promised that arrays can be read, and OpenGL reads no more.
        unsafe {
            let address = ptr::with_exposed_provenance(address);
            watch(address, length);
            slice::from_raw_parts(address, length)
        }
    }
}

/// An array of the caller that the library writes to later: what glSelectBuffer and glFeedbackBuffer keep.
pub(crate) struct CallerArray<T> {
    address: *mut T,
    length: usize,
}

impl<T: Copy> CallerArray<T> {
    /// No array.
    pub(crate) const NONE: Self = Self { address: ptr::null_mut(), length: 0 };

    /// The caller's promise to keep `length` values at `address`; a negative length is none.
    pub(crate) fn new(address: *mut T, length: i32) -> Self {
        Self { address, length: usize::try_from(length).unwrap_or(0) }
    }

    /// Where it is.
    pub(crate) fn address(&self) -> *mut T {
        self.address
    }

    /// Writes `values`, as many as fit.
    ///
    /// # Safety
    ///
    /// The caller of the library keeps what it promised to [`CallerArray::new`].
    pub(crate) unsafe fn write(&self, values: &[T]) {
        if !self.address.is_null() {
            for (at, value) in values.iter().take(self.length).enumerate() {
                // SAFETY: `at` is below the length that the caller promised.
                unsafe { self.address.add(at).write_unaligned(*value) };
            }
        }
    }
}
