//! From an entry point to the current context.
//!
//! No panic crosses into C: it is caught, and the command sets GL_OUT_OF_MEMORY, the one error after which results
//! are undefined (2.5). Commands for single vertices are spared the net; a panic there ends the process.

use crate::client::Client;
use crate::current;
use luxel_gl::Context;
use std::ffi::c_void;
use std::panic::{AssertUnwindSafe, catch_unwind};

const INVALID_VALUE: u32 = 0x0501;
const INVALID_OPERATION: u32 = 0x0502;
const OUT_OF_MEMORY: u32 = 0x0505;

/// Carries out `command` on the current context; without one it does nothing and returns 0.
#[inline]
pub(crate) fn call_uncaught<R: Default>(command: impl FnOnce(&mut Context, &mut Client) -> R) -> R {
    let bound = current::current();
    if bound.is_null() {
        return R::default();
    }
    // SAFETY: the current context is alive, and this thread alone uses it, as `current` says; entry points don't call
    // one another while they hold it.
    let bound = unsafe { &mut *bound };
    command(&mut bound.gl, &mut bound.client)
}

/// As [`call_uncaught`], for a command that reads or writes the caller's memory: a null pointer sets GL_INVALID_VALUE.
#[inline]
pub(crate) fn call_with_memory_uncaught<R: Default>(
    command: impl FnOnce(&mut Context, &mut Client) -> Option<R>,
) -> R {
    call_uncaught(|gl, client| {
        command(gl, client).unwrap_or_else(|| {
            gl.set_error(INVALID_VALUE);
            R::default()
        })
    })
}

/// Carries out `command` on the current context, and catches panics.
pub(crate) fn call<R: Default>(command: impl FnOnce(&mut Context, &mut Client) -> R) -> R {
    caught(|| call_uncaught(command))
}

/// As [`call`], for a command that reads or writes the caller's memory: a null pointer sets GL_INVALID_VALUE.
pub(crate) fn call_with_memory<R: Default>(
    command: impl FnOnce(&mut Context, &mut Client) -> Option<R>,
) -> R {
    caught(|| call_with_memory_uncaught(command))
}

/// What `f` returns, or, after a panic, 0 with GL_OUT_OF_MEMORY set.
pub(crate) fn caught<R: Default>(f: impl FnOnce() -> R) -> R {
    catch_unwind(AssertUnwindSafe(f)).unwrap_or_else(|_| {
        call_uncaught(|gl, _| gl.set_error(OUT_OF_MEMORY));
        R::default()
    })
}

/// A command that is not carried out.
pub(crate) fn refuse<R: Default>() -> R {
    call_uncaught(|gl, _| gl.set_error(INVALID_OPERATION));
    R::default()
}

/// Entry points that set GL_INVALID_OPERATION and return 0.
macro_rules! unsupported {
    ($($name:ident($($parameter:ident: $type:ty),*) $(-> $result:ty)?;)*) => {$(
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($(_: $type),*) $(-> $result)? {
            $crate::entry::refuse()
        }
    )*};
}

/// Entry points that are others by another name; `unsafe` those that take pointers.
macro_rules! aliases {
    () => {};
    ($name:ident = $command:ident($($parameter:ident: $type:ty),*) $(-> $result:ty)?; $($rest:tt)*) => {
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($($parameter: $type),*) $(-> $result)? {
            $command($($parameter),*)
        }
        $crate::entry::aliases! { $($rest)* }
    };
    (unsafe $name:ident = $command:ident($($parameter:ident: $type:ty),*) $(-> $result:ty)?; $($rest:tt)*) => {
        #[unsafe(no_mangle)]
        pub(crate) unsafe extern "C" fn $name($($parameter: $type),*) $(-> $result)? {
            // SAFETY: the same contract.
            unsafe { $command($($parameter),*) }
        }
        $crate::entry::aliases! { $($rest)* }
    };
}

/// Entry points that do nothing.
macro_rules! silent {
    ($($name:ident($($parameter:ident: $type:ty),*);)*) => {$(
        #[unsafe(no_mangle)]
        pub(crate) extern "C" fn $name($(_: $type),*) {}
    )*};
}

/// The address of an entry point.
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) address: *const c_void,
}

// SAFETY: the addresses are of functions.
unsafe impl Sync for Entry {}

/// A table of entry points, sorted by name.
macro_rules! entries {
    ($($name:ident)*) => {
        /// All entry points, sorted by name.
        pub(crate) static ENTRIES: &[$crate::entry::Entry] = &[
            $($crate::entry::Entry { name: stringify!($name), address: $name as *const _ }),*
        ];
    };
}

pub(crate) use {aliases, entries, silent, unsupported};
