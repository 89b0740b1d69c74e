//! Buffer objects that the caller has mapped (2.9.1).
//!
//! Mapping moves the storage out of the buffer object into this table, and unmapping moves it back: in between OpenGL
//! forbids commands to use the buffer, so nothing in the library reads what the caller writes. The address is that of the
//! storage on the heap, which stays where it is.

use luxel_gl::Context;
use std::ffi::c_void;
use std::ptr;

const INVALID_ENUM: u32 = 0x0500;
const INVALID_VALUE: u32 = 0x0501;
const INVALID_OPERATION: u32 = 0x0502;
const BUFFER_SIZE: u32 = 0x8764;
const BUFFER_MAPPED: u32 = 0x88BC;
const BUFFER_MAP_POINTER: u32 = 0x88BD;
const READ_ONLY: u32 = 0x88B8;
const WRITE_ONLY: u32 = 0x88B9;
const READ_WRITE: u32 = 0x88BA;
/// Bits of glMapBufferRange: read, write, and all that there are.
const MAP_READ: u32 = 1;
const MAP_WRITE: u32 = 2;
const MAP_ALL: u32 = 0x3F;

/// A mapped buffer: its name and its storage.
struct Entry {
    name: u32,
    storage: Vec<u8>,
}

/// All mapped buffers of a context.
#[derive(Default)]
pub(crate) struct Mapped(Vec<Entry>);

impl Mapped {
    /// Maps the buffer that is bound, and returns its address; null, with an error set, if it can't be.
    pub(crate) fn map(&mut self, gl: &mut Context, target: u32, access: u32) -> *mut c_void {
        let Some(mapped) = gl.map_buffer(target, access) else { return ptr::null_mut() };
        self.forget(&[mapped.name]);
        self.0.push(Entry { name: mapped.name, storage: mapped.storage });
        self.0.last_mut().map_or(ptr::null_mut(), |entry| entry.storage.as_mut_ptr().cast())
    }

    /// Maps a part of the buffer that is bound.
    pub(crate) fn map_range(
        &mut self,
        gl: &mut Context,
        target: u32,
        [offset, length]: [isize; 2],
        access: u32,
    ) -> *mut c_void {
        let Some(size) = gl.get_buffer_parameter(target, BUFFER_SIZE) else {
            return ptr::null_mut();
        };
        let size = size.to_i32(0) as isize;
        let within = offset >= 0 && length >= 0 && offset <= size && length <= size - offset;
        if !within || access & !MAP_ALL != 0 {
            gl.set_error(INVALID_VALUE);
            return ptr::null_mut();
        }
        let access = match (access & MAP_READ != 0, access & MAP_WRITE != 0) {
            (true, true) => READ_WRITE,
            (true, false) => READ_ONLY,
            (false, true) => WRITE_ONLY,
            (false, false) => {
                gl.set_error(INVALID_OPERATION);
                return ptr::null_mut();
            }
        };
        let start = self.map(gl, target, access);
        if start.is_null() { start } else { start.wrapping_byte_offset(offset) }
    }

    /// What the caller wrote is seen when the buffer is unmapped anyway: only errors are left to find.
    pub(crate) fn flush(&mut self, gl: &mut Context, target: u32, [offset, length]: [isize; 2]) {
        let name = gl.bound_buffer(target);
        if name == 0 {
            return;
        }
        match self.0.iter().find(|entry| entry.name == name) {
            None => gl.set_error(INVALID_OPERATION),
            Some(entry) => {
                let size = entry.storage.len() as isize;
                if offset < 0 || length < 0 || offset > size || length > size - offset {
                    gl.set_error(INVALID_VALUE);
                }
            }
        }
    }

    /// Moves the storage of the buffer that is bound back into it.
    pub(crate) fn unmap(&mut self, gl: &mut Context, target: u32) -> bool {
        let name = gl.bound_buffer(target);
        if name == 0 {
            return false;
        }
        let place = self.0.iter().position(|entry| entry.name == name);
        let storage = place.map(|place| self.0.swap_remove(place).storage);
        gl.unmap_buffer(target, storage)
    }

    /// Carries out a command that gives the buffer that is bound new storage.
    pub(crate) fn replace(
        &mut self,
        gl: &mut Context,
        target: u32,
        command: impl FnOnce(&mut Context),
    ) {
        command(gl);
        if self.0.is_empty() {
            return;
        }
        // A command that failed has left the mapping as it was.
        let mapped = gl.get_buffer_parameter(target, BUFFER_MAPPED);
        if mapped.is_some_and(|mapped| mapped.to_bool(0) == 0) {
            let name = gl.bound_buffer(target);
            self.forget(&[name]);
        }
    }

    /// Drops the storage of buffers that are no more, or that have other storage now.
    pub(crate) fn forget(&mut self, names: &[u32]) {
        self.0.retain(|entry| !names.contains(&entry.name));
    }

    /// The address of the buffer that is bound: null if it isn't mapped; `None`, with an error set, if there is none.
    pub(crate) fn address(
        &mut self,
        gl: &mut Context,
        target: u32,
        pname: u32,
    ) -> Option<*mut c_void> {
        if pname != BUFFER_MAP_POINTER {
            gl.set_error(INVALID_ENUM);
            return None;
        }
        let name = gl.bound_buffer(target);
        if name == 0 {
            return None;
        }
        let entry = self.0.iter_mut().find(|entry| entry.name == name);
        Some(entry.map_or(ptr::null_mut(), |entry| entry.storage.as_mut_ptr().cast()))
    }
}
