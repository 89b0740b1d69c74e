//! Vertex arrays (OpenGL 1.5, sections 2.8 and 2.9, tables 6.6 and 6.7).

use crate::enums as gl;
use crate::limits::TEXTURE_UNITS;

/// One array: where its elements lie, and what they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct VertexArray {
    pub(crate) enabled: bool,
    pub(crate) size: usize,
    pub(crate) data_type: u32,
    /// Bytes from one element to the next, as the program has given them: 0 for one after the other.
    pub(crate) stride: usize,
    /// An address of the program's memory, or an offset into the buffer.
    pub(crate) pointer: usize,
    /// The buffer object that was bound to `GL_ARRAY_BUFFER`; 0 for the program's memory.
    pub(crate) buffer: u32,
}

impl VertexArray {
    const fn new(size: usize, data_type: u32) -> Self {
        Self { enabled: false, size, data_type, stride: 0, pointer: 0, buffer: 0 }
    }

    /// Bytes of one element.
    pub(crate) fn element_bytes(&self) -> usize {
        self.size * type_bytes(self.data_type)
    }

    /// Bytes from one element to the next.
    pub(crate) fn step(&self) -> usize {
        if self.stride == 0 { self.element_bytes() } else { self.stride }
    }
}

/// Bytes of one component.
pub(crate) fn type_bytes(data_type: u32) -> usize {
    match data_type {
        gl::BYTE | gl::UNSIGNED_BYTE => 1,
        gl::SHORT | gl::UNSIGNED_SHORT => 2,
        gl::DOUBLE => 8,
        _ => 4,
    }
}

/// All arrays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrays {
    pub(crate) vertex: VertexArray,
    pub(crate) normal: VertexArray,
    pub(crate) color: VertexArray,
    pub(crate) secondary: VertexArray,
    pub(crate) index: VertexArray,
    pub(crate) edge_flag: VertexArray,
    pub(crate) fog_coord: VertexArray,
    pub(crate) tex_coords: [VertexArray; TEXTURE_UNITS],
    /// The unit that `glClientActiveTexture` has chosen.
    pub(crate) unit: usize,
    /// What is bound to `GL_ARRAY_BUFFER` and `GL_ELEMENT_ARRAY_BUFFER`.
    pub(crate) array_buffer: u32,
    pub(crate) element_buffer: u32,
    /// The first locked vertex and how many; nothing is locked if there are none.
    pub(crate) locked: [i32; 2],
}

impl Default for Arrays {
    fn default() -> Self {
        Self {
            vertex: VertexArray::new(4, gl::FLOAT),
            normal: VertexArray::new(3, gl::FLOAT),
            color: VertexArray::new(4, gl::FLOAT),
            secondary: VertexArray::new(3, gl::FLOAT),
            index: VertexArray::new(1, gl::FLOAT),
            edge_flag: VertexArray::new(1, gl::UNSIGNED_BYTE),
            fog_coord: VertexArray::new(1, gl::FLOAT),
            tex_coords: [VertexArray::new(4, gl::FLOAT); TEXTURE_UNITS],
            unit: 0,
            array_buffer: 0,
            element_buffer: 0,
            locked: [0; 2],
        }
    }
}

impl Arrays {
    /// The array with a name; of texture coordinates that of the chosen unit.
    pub(crate) fn named(&self, name: u32) -> Option<&VertexArray> {
        Some(match name {
            gl::VERTEX_ARRAY => &self.vertex,
            gl::NORMAL_ARRAY => &self.normal,
            gl::COLOR_ARRAY => &self.color,
            gl::SECONDARY_COLOR_ARRAY => &self.secondary,
            gl::INDEX_ARRAY => &self.index,
            gl::EDGE_FLAG_ARRAY => &self.edge_flag,
            gl::FOG_COORD_ARRAY => &self.fog_coord,
            gl::TEXTURE_COORD_ARRAY => &self.tex_coords[self.unit],
            _ => return None,
        })
    }

    /// The same, to be changed.
    pub(crate) fn named_mut(&mut self, name: u32) -> Option<&mut VertexArray> {
        Some(match name {
            gl::VERTEX_ARRAY => &mut self.vertex,
            gl::NORMAL_ARRAY => &mut self.normal,
            gl::COLOR_ARRAY => &mut self.color,
            gl::SECONDARY_COLOR_ARRAY => &mut self.secondary,
            gl::INDEX_ARRAY => &mut self.index,
            gl::EDGE_FLAG_ARRAY => &mut self.edge_flag,
            gl::FOG_COORD_ARRAY => &mut self.fog_coord,
            gl::TEXTURE_COORD_ARRAY => &mut self.tex_coords[self.unit],
            _ => return None,
        })
    }

    /// Every array.
    fn all_mut(&mut self) -> impl Iterator<Item = &mut VertexArray> {
        let others = [
            &mut self.vertex,
            &mut self.normal,
            &mut self.color,
            &mut self.secondary,
            &mut self.index,
            &mut self.edge_flag,
            &mut self.fog_coord,
        ];
        others.into_iter().chain(&mut self.tex_coords)
    }

    /// Forgets a buffer that is deleted.
    pub(crate) fn forget(&mut self, buffer: u32) {
        for array in self.all_mut().filter(|array| array.buffer == buffer) {
            array.buffer = 0;
            array.pointer = 0;
        }
        for binding in [&mut self.array_buffer, &mut self.element_buffer] {
            if *binding == buffer {
                *binding = 0;
            }
        }
    }
}
