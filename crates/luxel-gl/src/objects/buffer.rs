//! Buffer objects (OpenGL 1.5, section 2.9).

use crate::enums as gl;
use crate::limits::BUFFER_NAMES;
use std::collections::BTreeMap;
use std::sync::Arc;

/// One buffer's data, and how it is used.
#[derive(Clone, Debug)]
pub(crate) struct Buffer {
    /// `None` while it is mapped: then whoever has mapped it has the storage.
    pub(crate) data: Option<Arc<Vec<u8>>>,
    pub(crate) size: usize,
    pub(crate) usage: u32,
    pub(crate) access: u32,
}

impl Default for Buffer {
    fn default() -> Self {
        Self { data: Some(Arc::default()), size: 0, usage: gl::STATIC_DRAW, access: gl::READ_WRITE }
    }
}

impl Buffer {
    pub(crate) fn is_mapped(&self) -> bool {
        self.data.is_none()
    }
}

/// The buffers of a context, and of those that share with it. A name without buffer has been generated and never
/// bound.
#[derive(Debug, Default)]
pub(crate) struct Buffers {
    names: BTreeMap<u32, Option<Buffer>>,
}

impl Buffers {
    /// So many names that nobody has; fewer if there are too many.
    pub(crate) fn generate(&mut self, count: usize) -> Vec<u32> {
        super::names::generate(&mut self.names, count, BUFFER_NAMES)
    }

    /// Makes a buffer of a name that is bound; whether there can be one more.
    pub(crate) fn bind(&mut self, name: u32) -> bool {
        super::names::bind(&mut self.names, name, BUFFER_NAMES)
    }

    pub(crate) fn get(&self, name: u32) -> Option<&Buffer> {
        self.names.get(&name)?.as_ref()
    }

    pub(crate) fn get_mut(&mut self, name: u32) -> Option<&mut Buffer> {
        self.names.get_mut(&name)?.as_mut()
    }

    pub(crate) fn delete(&mut self, name: u32) {
        self.names.remove(&name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_2_9_names_become_buffers_when_they_are_bound() {
        let mut buffers = Buffers::default();
        let names = buffers.generate(2);
        assert_eq!(names, [1, 2]);
        assert!(buffers.get(1).is_none());
        assert!(buffers.bind(1) && buffers.bind(9));
        assert!(buffers.get(1).is_some_and(|buffer| buffer.size == 0 && !buffer.is_mapped()));
        assert_eq!(buffers.generate(1), [10]);
        buffers.delete(1);
        assert!(buffers.get(1).is_none());
    }
}
