//! Buffer objects (OpenGL 1.5, section 2.9).

use crate::Context;
use crate::context::{demand, outside_begin};
use crate::enums as gl;
use crate::values::Values;
use std::sync::Arc;

/// A buffer's storage, moved out while the program has its address (`glMapBuffer`).
#[derive(Debug)]
pub struct MappedBuffer {
    /// The buffer's name.
    pub name: u32,
    /// What [`Context::unmap_buffer`] gets back, of the same length.
    pub storage: Vec<u8>,
}

impl Context {
    /// The name of what is bound to a target: an error for a target that isn't one.
    fn bound(&self, target: u32) -> Result<u32, u32> {
        match target {
            gl::ARRAY_BUFFER => Ok(self.client.arrays.array_buffer),
            gl::ELEMENT_ARRAY_BUFFER => Ok(self.client.arrays.element_buffer),
            _ => Err(gl::INVALID_ENUM),
        }
    }

    /// What is bound to a target, which must be a buffer: 0 after an error.
    pub fn bound_buffer(&mut self, target: u32) -> u32 {
        outside_begin!(self, 0);
        match self.bound(target) {
            Ok(0) => {
                self.error.set(gl::INVALID_OPERATION);
                0
            }
            Ok(name) => name,
            Err(error) => {
                self.error.set(error);
                0
            }
        }
    }

    /// `glGenBuffers`: names that nobody has.
    pub fn gen_buffers(&mut self, count: i32) -> Vec<u32> {
        outside_begin!(self, Vec::new());
        let Ok(count) = usize::try_from(count) else {
            self.error.set(gl::INVALID_VALUE);
            return Vec::new();
        };
        let names = self.buffers().generate(count);
        if names.len() < count {
            self.error.set(gl::OUT_OF_MEMORY);
        }
        names
    }

    /// `glDeleteBuffers`; bindings to them in this context become 0.
    pub fn delete_buffers(&mut self, names: &[u32]) {
        outside_begin!(self);
        for &name in names.iter().filter(|name| **name != 0) {
            self.buffers().delete(name);
            self.client.arrays.forget(name);
        }
    }

    /// `glIsBuffer`.
    pub fn is_buffer(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.buffers().get(name).is_some()
    }

    /// `glBindBuffer`.
    pub fn bind_buffer(&mut self, target: u32, name: u32) {
        outside_begin!(self);
        demand!(self, self.bound(target).is_ok(), gl::INVALID_ENUM);
        let there = name == 0 || self.buffers().bind(name);
        demand!(self, there, gl::OUT_OF_MEMORY);
        match target {
            gl::ARRAY_BUFFER => self.client.arrays.array_buffer = name,
            _ => self.client.arrays.element_buffer = name,
        }
    }

    /// `glBufferData`: new storage of `size` bytes, with data or zeros. A mapping of the old one ends.
    pub fn buffer_data(&mut self, target: u32, size: isize, data: Option<&[u8]>, usage: u32) {
        outside_begin!(self);
        let is_usage = (gl::STREAM_DRAW..=gl::DYNAMIC_COPY).contains(&usage) && usage % 4 != 3;
        demand!(self, self.bound(target).is_ok() && is_usage, gl::INVALID_ENUM);
        let Ok(size) = usize::try_from(size) else {
            self.error.set(gl::INVALID_VALUE);
            return;
        };
        let name = self.bound_buffer(target);
        if name == 0 {
            return;
        }
        let mut storage = Vec::new();
        demand!(self, storage.try_reserve_exact(size).is_ok(), gl::OUT_OF_MEMORY);
        storage.extend_from_slice(&data.unwrap_or(&[])[..size.min(data.map_or(0, <[u8]>::len))]);
        storage.resize(size, 0);
        if let Some(buffer) = self.buffers().get_mut(name) {
            buffer.data = Some(Arc::new(storage));
            (buffer.size, buffer.usage, buffer.access) = (size, usage, gl::READ_WRITE);
        }
    }

    /// Bytes that `glBufferSubData` reads or `glGetBufferSubData` writes; 0 after an error, which is set.
    pub fn buffer_part_bytes(&mut self, target: u32, offset: isize, size: isize) -> usize {
        let name = self.bound_buffer(target);
        if name == 0 {
            return 0;
        }
        let length = usize::try_from(size).map_err(|_| gl::INVALID_VALUE);
        match length.and_then(|length| self.with_range(name, offset, length, |_| {})) {
            Ok(()) => size.unsigned_abs(),
            Err(error) => {
                self.error.set(error);
                0
            }
        }
    }

    /// `glBufferSubData`. `GL_INVALID_VALUE` beyond the buffer's end, `GL_INVALID_OPERATION` while it is mapped.
    pub fn buffer_sub_data(&mut self, target: u32, offset: isize, data: &[u8]) {
        let name = self.bound_buffer(target);
        if name == 0 {
            return;
        }
        let written = self.with_range(name, offset, data.len(), |bytes| {
            bytes.copy_from_slice(data);
        });
        if let Err(error) = written {
            self.error.set(error);
        }
    }

    /// `glGetBufferSubData`.
    pub fn get_buffer_sub_data(&mut self, target: u32, offset: isize, out: &mut [u8]) {
        let name = self.bound_buffer(target);
        if name == 0 {
            return;
        }
        let length = out.len();
        let read = self.with_range(name, offset, length, |bytes| out.copy_from_slice(bytes));
        if let Err(error) = read {
            self.error.set(error);
        }
    }

    fn with_range(
        &self,
        name: u32,
        offset: isize,
        length: usize,
        work: impl FnOnce(&mut [u8]),
    ) -> Result<(), u32> {
        let mut buffers = self.buffers();
        let buffer = buffers.get_mut(name).ok_or(gl::INVALID_OPERATION)?;
        let start = usize::try_from(offset).map_err(|_| gl::INVALID_VALUE)?;
        let end = start.checked_add(length).filter(|end| *end <= buffer.size);
        let end = end.ok_or(gl::INVALID_VALUE)?;
        let data = buffer.data.as_mut().ok_or(gl::INVALID_OPERATION)?;
        if let Some(bytes) = Arc::make_mut(data).get_mut(start..end) {
            work(bytes);
        }
        Ok(())
    }

    /// `glMapBuffer`: moves the storage out, until [`unmap_buffer`](Self::unmap_buffer).
    pub fn map_buffer(&mut self, target: u32, access: u32) -> Option<MappedBuffer> {
        outside_begin!(self, None);
        let is_access = (gl::READ_ONLY..=gl::READ_WRITE).contains(&access);
        if self.bound(target).is_err() || !is_access {
            self.error.set(gl::INVALID_ENUM);
            return None;
        }
        let name = self.bound_buffer(target);
        if name == 0 {
            return None;
        }
        let storage = {
            let mut buffers = self.buffers();
            buffers.get_mut(name).and_then(|buffer| {
                let data = buffer.data.take()?;
                buffer.access = access;
                Some(Arc::unwrap_or_clone(data))
            })
        };
        if storage.is_none() {
            self.error.set(gl::INVALID_OPERATION);
        }
        storage.map(|storage| MappedBuffer { name, storage })
    }

    /// `glUnmapBuffer`: puts the storage back. `GL_INVALID_OPERATION` for a buffer that isn't mapped; then false.
    pub fn unmap_buffer(&mut self, target: u32, storage: Option<Vec<u8>>) -> bool {
        let name = self.bound_buffer(target);
        if name == 0 {
            return false;
        }
        let put = {
            let mut buffers = self.buffers();
            match (buffers.get_mut(name), storage) {
                (Some(buffer), Some(mut storage)) if buffer.is_mapped() => {
                    storage.resize(buffer.size, 0);
                    buffer.data = Some(Arc::new(storage));
                    buffer.access = gl::READ_WRITE;
                    true
                }
                _ => false,
            }
        };
        if !put {
            self.error.set(gl::INVALID_OPERATION);
        }
        put
    }

    /// `glGetBufferParameter`.
    pub fn get_buffer_parameter(&mut self, target: u32, pname: u32) -> Option<Values> {
        let name = self.bound_buffer(target);
        if name == 0 {
            return None;
        }
        let found = self.buffers().get(name).and_then(|buffer| {
            Some(match pname {
                gl::BUFFER_SIZE => Values::count(buffer.size),
                gl::BUFFER_USAGE => Values::name(buffer.usage),
                gl::BUFFER_ACCESS => Values::name(buffer.access),
                gl::BUFFER_MAPPED => Values::boolean(buffer.is_mapped()),
                _ => return None,
            })
        });
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found
    }
}
