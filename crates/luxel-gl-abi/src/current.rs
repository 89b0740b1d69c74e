//! Contexts by their handles, and the one that is current in each thread.
//!
//! A handle is the address of a context. The list of all contexts says which addresses are handles, and which thread a
//! context is current in: a context is current in one thread at most, which alone touches it. So a handle that was
//! destroyed, or never was one, is refused instead of followed.

use crate::client::Client;
use crate::slot;
use luxel_gl::Context;
use std::ptr;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// A context, and what the library keeps of its caller's memory.
pub(crate) struct Bound {
    /// The safe context.
    pub(crate) gl: Context,
    /// Addresses of the caller's memory.
    pub(crate) client: Client,
}

/// A context in the list.
struct Listed {
    /// Its address, from `Box::into_raw`.
    handle: *mut Bound,
    /// The number of the thread that it is current in.
    thread: Option<usize>,
    /// Destroyed while it was current in another thread: it goes when that thread leaves it.
    doomed: bool,
}

// SAFETY: the handle is followed by the thread alone that `thread` names, or under the lock if none does, and what it
// leads to may be sent: `Context` is `Send`, and addresses of the caller's memory belong to the context.
unsafe impl Send for Listed {}

static CONTEXTS: Mutex<Vec<Listed>> = Mutex::new(Vec::new());

thread_local! {
    /// Tells threads apart by its address.
    static MARK: u8 = const { 0 };
    /// Leaves the context when the thread ends.
    static AT_EXIT: AtExit = const { AtExit };
}

struct AtExit;

impl Drop for AtExit {
    fn drop(&mut self) {
        leave();
    }
}

fn contexts() -> MutexGuard<'static, Vec<Listed>> {
    // The list is whole between any two of its operations.
    CONTEXTS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A number that no other living thread has: the address of one of its variables.
fn thread_number() -> usize {
    MARK.with(|mark| ptr::from_ref(mark).addr())
}

/// The current context of this thread, or null.
#[inline(always)]
pub(crate) fn current() -> *mut Bound {
    slot::get()
}

/// Lists a new context, and returns its handle.
pub(crate) fn insert(bound: Bound) -> *mut Bound {
    let handle = Box::into_raw(Box::new(bound));
    contexts().push(Listed { handle, thread: None, doomed: false });
    handle
}

/// What `f` makes of a context; `None` if `handle` is none, or current in another thread.
///
/// `f` must not call this module.
pub(crate) fn inspect<R>(handle: *mut Bound, f: impl FnOnce(&mut Bound) -> R) -> Option<R> {
    let contexts = contexts();
    let listed = contexts.iter().find(|listed| listed.handle == handle && !listed.doomed)?;
    if listed.thread.is_some_and(|thread| thread != thread_number()) {
        return None;
    }
    // SAFETY: a listed handle is alive; no other thread uses it, since it is current in none but this and the lock is
    // held; in this thread no reference to it outlives an entry point.
    Some(f(unsafe { &mut *handle }))
}

/// Makes a context current in this thread, instead of the one that was, which is left.
///
/// False if `handle` is none, or current in another thread.
pub(crate) fn make_current(handle: *mut Bound) -> bool {
    if handle == current() {
        return !handle.is_null();
    }
    let number = thread_number();
    {
        let mut contexts = contexts();
        let found = contexts.iter_mut().find(|listed| listed.handle == handle && !listed.doomed);
        match found {
            Some(listed) if listed.thread.is_none() => listed.thread = Some(number),
            _ => return false,
        }
    }
    leave();
    AT_EXIT.with(|_| {});
    slot::set(handle);
    true
}

/// Leaves the current context of this thread, if there is one.
pub(crate) fn leave() {
    let handle = current();
    if handle.is_null() {
        return;
    }
    slot::set::<Bound>(ptr::null_mut());
    let mut contexts = contexts();
    if let Some(place) = contexts.iter().position(|listed| listed.handle == handle) {
        contexts[place].thread = None;
        if contexts[place].doomed {
            free(contexts.swap_remove(place));
        }
    }
}

/// Destroys a context: at once, or when the other thread that it is current in leaves it.
pub(crate) fn destroy(handle: *mut Bound) {
    if handle.is_null() {
        return;
    }
    if handle == current() {
        leave();
    }
    let mut contexts = contexts();
    let Some(place) = contexts.iter().position(|listed| listed.handle == handle) else { return };
    if contexts[place].thread.is_some() {
        contexts[place].doomed = true;
    } else {
        free(contexts.swap_remove(place));
    }
}

/// Destroys a context when the thread that it is current in leaves it, this one too; at once if there is none. False if
/// `handle` is none.
pub(crate) fn destroy_when_left(handle: *mut Bound) -> bool {
    let mut contexts = contexts();
    let alive = |listed: &Listed| listed.handle == handle && !listed.doomed;
    let Some(place) = contexts.iter().position(alive) else { return false };
    if contexts[place].thread.is_some() {
        contexts[place].doomed = true;
    } else {
        free(contexts.swap_remove(place));
    }
    true
}

/// Whether `handle` is a context.
pub(crate) fn is_context(handle: *mut Bound) -> bool {
    contexts().iter().any(|listed| listed.handle == handle && !listed.doomed)
}

fn free(listed: Listed) {
    // SAFETY: the handle came from `Box::into_raw`, is off the list, and current nowhere.
    drop(unsafe { Box::from_raw(listed.handle) });
}
