//! Vertex arrays: their state, and drawing from them (OpenGL 1.5, section 2.8).

use crate::Context;
use crate::context::{demand, outside_begin};
use crate::enums as gl;
use crate::limits::{STREAM_VERTICES, TEXTURE_UNITS};
use crate::objects::list::Command;
use crate::state::arrays::{VertexArray, type_bytes};
use crate::vertex::{
    ArrayDraw, ClientMemory, Fetched, VertexSource, Wanted, byte_range, decode, decode_indices,
};
use std::sync::Arc;

/// Types of components: floating-point ones, and which integers.
const SIGNED_WIDE: &[u32] = &[gl::SHORT, gl::INT, gl::FLOAT, gl::DOUBLE];
const SIGNED: &[u32] = &[gl::BYTE, gl::SHORT, gl::INT, gl::FLOAT, gl::DOUBLE];
const EVERY: &[u32] = &[
    gl::BYTE,
    gl::UNSIGNED_BYTE,
    gl::SHORT,
    gl::UNSIGNED_SHORT,
    gl::INT,
    gl::UNSIGNED_INT,
    gl::FLOAT,
    gl::DOUBLE,
];
const INDEXES: &[u32] = &[gl::UNSIGNED_BYTE, gl::SHORT, gl::INT, gl::FLOAT, gl::DOUBLE];

impl Context {
    /// `glGetPointerv` of an array: an address, or an offset into its buffer.
    pub fn get_pointer(&mut self, pname: u32) -> Option<usize> {
        outside_begin!(self, None);
        let arrays = &self.client.arrays;
        let found = match pname {
            gl::VERTEX_ARRAY_POINTER => &arrays.vertex,
            gl::NORMAL_ARRAY_POINTER => &arrays.normal,
            gl::COLOR_ARRAY_POINTER => &arrays.color,
            gl::SECONDARY_COLOR_ARRAY_POINTER => &arrays.secondary,
            gl::INDEX_ARRAY_POINTER => &arrays.index,
            gl::EDGE_FLAG_ARRAY_POINTER => &arrays.edge_flag,
            gl::FOG_COORD_ARRAY_POINTER => &arrays.fog_coord,
            gl::TEXTURE_COORD_ARRAY_POINTER => &arrays.tex_coords[arrays.unit],
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return None;
            }
        };
        Some(found.pointer)
    }

    /// `glEnableClientState`.
    pub fn enable_client_state(&mut self, array: u32) {
        self.switch_array(array, true);
    }

    /// `glDisableClientState`.
    pub fn disable_client_state(&mut self, array: u32) {
        self.switch_array(array, false);
    }

    fn switch_array(&mut self, name: u32, on: bool) {
        outside_begin!(self);
        match self.client.arrays.named_mut(name) {
            Some(array) => array.enabled = on,
            None => self.error.set(gl::INVALID_ENUM),
        }
    }

    /// Sets an array's pointer, after its arguments are checked (table 2.4).
    fn set_pointer(
        &mut self,
        name: u32,
        [size, stride]: [i32; 2],
        data_type: u32,
        pointer: usize,
        (sizes, types): (std::ops::RangeInclusive<i32>, &[u32]),
    ) {
        outside_begin!(self);
        demand!(self, sizes.contains(&size) && stride >= 0, gl::INVALID_VALUE);
        demand!(self, types.contains(&data_type), gl::INVALID_ENUM);
        let buffer = self.client.arrays.array_buffer;
        if let Some(array) = self.client.arrays.named_mut(name) {
            let (size, stride) = (size as usize, stride as usize);
            *array = VertexArray { size, data_type, stride, pointer, buffer, ..*array };
        }
    }

    /// `glVertexPointer`: 2 to 4 components; `pointer` is an address, or an offset into the buffer that is bound.
    pub fn vertex_pointer(&mut self, size: i32, data_type: u32, stride: i32, pointer: usize) {
        let allowed = (2..=4, SIGNED_WIDE);
        self.set_pointer(gl::VERTEX_ARRAY, [size, stride], data_type, pointer, allowed);
    }

    /// `glNormalPointer`.
    pub fn normal_pointer(&mut self, data_type: u32, stride: i32, pointer: usize) {
        self.set_pointer(gl::NORMAL_ARRAY, [3, stride], data_type, pointer, (3..=3, SIGNED));
    }

    /// `glColorPointer`: 3 or 4 components.
    pub fn color_pointer(&mut self, size: i32, data_type: u32, stride: i32, pointer: usize) {
        self.set_pointer(gl::COLOR_ARRAY, [size, stride], data_type, pointer, (3..=4, EVERY));
    }

    /// `glSecondaryColorPointer`: 3 components.
    pub fn secondary_color_pointer(
        &mut self,
        size: i32,
        data_type: u32,
        stride: i32,
        pointer: usize,
    ) {
        let allowed = (3..=3, EVERY);
        self.set_pointer(gl::SECONDARY_COLOR_ARRAY, [size, stride], data_type, pointer, allowed);
    }

    /// `glIndexPointer`.
    pub fn index_pointer(&mut self, data_type: u32, stride: i32, pointer: usize) {
        self.set_pointer(gl::INDEX_ARRAY, [1, stride], data_type, pointer, (1..=1, INDEXES));
    }

    /// `glEdgeFlagPointer`: a byte each.
    pub fn edge_flag_pointer(&mut self, stride: i32, pointer: usize) {
        let allowed: (_, &[u32]) = (1..=1, &[gl::UNSIGNED_BYTE]);
        self.set_pointer(gl::EDGE_FLAG_ARRAY, [1, stride], gl::UNSIGNED_BYTE, pointer, allowed);
    }

    /// `glFogCoordPointer`.
    pub fn fog_coord_pointer(&mut self, data_type: u32, stride: i32, pointer: usize) {
        let allowed: (_, &[u32]) = (1..=1, &[gl::FLOAT, gl::DOUBLE]);
        self.set_pointer(gl::FOG_COORD_ARRAY, [1, stride], data_type, pointer, allowed);
    }

    /// `glTexCoordPointer` of the client's active unit: 1 to 4 components.
    pub fn tex_coord_pointer(&mut self, size: i32, data_type: u32, stride: i32, pointer: usize) {
        let allowed = (1..=4, SIGNED_WIDE);
        self.set_pointer(gl::TEXTURE_COORD_ARRAY, [size, stride], data_type, pointer, allowed);
    }

    /// `glLockArraysEXT` (EXT_compiled_vertex_array): a promise that vertices stay as they are; drawing does not use it.
    pub fn lock_arrays(&mut self, first: i32, count: i32) {
        outside_begin!(self);
        demand!(self, first >= 0 && count > 0, gl::INVALID_VALUE);
        demand!(self, self.client.arrays.locked == [0; 2], gl::INVALID_OPERATION);
        self.client.arrays.locked = [first, count];
    }

    /// `glUnlockArraysEXT`.
    pub fn unlock_arrays(&mut self) {
        outside_begin!(self);
        demand!(self, self.client.arrays.locked != [0; 2], gl::INVALID_OPERATION);
        self.client.arrays.locked = [0; 2];
    }

    /// `glInterleavedArrays`: pointers and switches of the arrays that a format has (table 2.5).
    pub fn interleaved_arrays(&mut self, format: u32, stride: i32, pointer: usize) {
        outside_begin!(self);
        // Components of texture coordinates, of colours with their type, whether there are normals, and of places.
        let byte = gl::UNSIGNED_BYTE;
        let (texture, color, normal, vertex) = match format {
            gl::V2F => (0, (0, 0), false, 2),
            gl::V3F => (0, (0, 0), false, 3),
            gl::C4UB_V2F => (0, (4, byte), false, 2),
            gl::C4UB_V3F => (0, (4, byte), false, 3),
            gl::C3F_V3F => (0, (3, gl::FLOAT), false, 3),
            gl::N3F_V3F => (0, (0, 0), true, 3),
            gl::C4F_N3F_V3F => (0, (4, gl::FLOAT), true, 3),
            gl::T2F_V3F => (2, (0, 0), false, 3),
            gl::T4F_V4F => (4, (0, 0), false, 4),
            gl::T2F_C4UB_V3F => (2, (4, byte), false, 3),
            gl::T2F_C3F_V3F => (2, (3, gl::FLOAT), false, 3),
            gl::T2F_N3F_V3F => (2, (0, 0), true, 3),
            gl::T2F_C4F_N3F_V3F => (2, (4, gl::FLOAT), true, 3),
            gl::T4F_C4F_N3F_V4F => (4, (4, gl::FLOAT), true, 4),
            _ => {
                self.error.set(gl::INVALID_ENUM);
                return;
            }
        };
        demand!(self, stride >= 0, gl::INVALID_VALUE);
        for name in
            [gl::EDGE_FLAG_ARRAY, gl::INDEX_ARRAY, gl::FOG_COORD_ARRAY, gl::SECONDARY_COLOR_ARRAY]
        {
            self.disable_client_state(name);
        }
        let (color, color_type) = color;
        // Colours of bytes are padded to four.
        let color_bytes = color as usize * type_bytes(color_type);
        let texture_bytes = texture as usize * 4;
        let normal_bytes = if normal { 12 } else { 0 };
        let whole = texture_bytes + color_bytes + normal_bytes + vertex as usize * 4;
        let stride = if stride == 0 { whole as i32 } else { stride };
        let switch = |context: &mut Self, name: u32, on: bool| context.switch_array(name, on);
        switch(self, gl::TEXTURE_COORD_ARRAY, texture > 0);
        switch(self, gl::COLOR_ARRAY, color > 0);
        switch(self, gl::NORMAL_ARRAY, normal);
        switch(self, gl::VERTEX_ARRAY, true);
        let mut at = pointer;
        if texture > 0 {
            self.tex_coord_pointer(texture, gl::FLOAT, stride, at);
        }
        at = at.wrapping_add(texture_bytes);
        if color > 0 {
            self.color_pointer(color, color_type, stride, at);
        }
        at = at.wrapping_add(color_bytes);
        if normal {
            self.normal_pointer(gl::FLOAT, stride, at);
        }
        at = at.wrapping_add(normal_bytes);
        self.vertex_pointer(vertex, gl::FLOAT, stride, at);
    }

    /// The bytes of an array from vertex `first` on, and what to do with them; `None` where the memory can't be.
    fn with_bytes<R>(
        &self,
        array: &VertexArray,
        vertices: Wanted<'_>,
        memory: &dyn ClientMemory,
        work: impl FnOnce(&[u8]) -> R,
    ) -> Result<R, u32> {
        let (first, count) = vertices.span();
        let (start, length) = byte_range(array, first, count).ok_or(gl::OUT_OF_MEMORY)?;
        if array.buffer == 0 {
            let nothing = length == 0 || start == 0;
            return Ok(work(if nothing { &[] } else { memory.bytes(start, length) }));
        }
        let data = {
            let buffers = self.buffers();
            let buffer = buffers.get(array.buffer);
            match buffer.map(|buffer| buffer.data.clone()) {
                Some(Some(data)) => data,
                // A mapped buffer has no data to draw.
                Some(None) => return Err(gl::INVALID_OPERATION),
                None => Arc::default(),
            }
        };
        let end = start.saturating_add(length).min(data.len());
        Ok(work(data.get(start..end).unwrap_or(&[])))
    }

    /// Attributes of vertices out of the arrays that are enabled; none without an array of places.
    fn fetch(&self, vertices: Wanted<'_>, memory: &dyn ClientMemory) -> Result<Fetched, u32> {
        let arrays = &self.client.arrays;
        let mut fetched = Fetched::default();
        if !arrays.vertex.enabled || vertices.count() == 0 {
            return Ok(fetched);
        }
        if vertices.count() > STREAM_VERTICES {
            return Err(gl::OUT_OF_MEMORY);
        }
        macro_rules! values {
            ($array:expr, $normalized:expr, $fill:expr) => {
                self.with_bytes(&$array, vertices, memory, |bytes| {
                    decode(&$array, bytes, vertices, $normalized, $fill)
                })?
            };
        }
        fetched.positions = values!(arrays.vertex, false, [0.0, 0.0, 0.0, 1.0]);
        if arrays.normal.enabled {
            fetched.normals = Some(values!(arrays.normal, true, [0.0; 3]));
        }
        if arrays.color.enabled {
            fetched.colors = Some(values!(arrays.color, true, [0.0, 0.0, 0.0, 1.0]));
        }
        if arrays.secondary.enabled {
            fetched.secondary = Some(values!(arrays.secondary, true, [0.0; 3]));
        }
        if arrays.edge_flag.enabled {
            let flags = values!(arrays.edge_flag, false, [0.0; 1]);
            fetched.edge_flags = Some(flags.iter().map(|[flag]| *flag != 0.0).collect());
        }
        if arrays.fog_coord.enabled {
            let coordinates = values!(arrays.fog_coord, false, [0.0; 1]);
            fetched.fog_coords = Some(coordinates.iter().map(|[value]| *value).collect());
        }
        for unit in 0..TEXTURE_UNITS {
            let array = arrays.tex_coords[unit];
            let there = array.enabled;
            let mut of_unit = None;
            if there {
                of_unit = Some(values!(array, false, [0.0, 0.0, 0.0, 1.0]));
            }
            fetched.tex_coords.push(of_unit);
        }
        Ok(fetched)
    }

    /// `glArrayElement`: the attributes of one vertex of the arrays, then the vertex.
    pub fn array_element(&mut self, index: i32, memory: &dyn ClientMemory) {
        demand!(self, index >= 0, gl::INVALID_VALUE);
        let fetched = match self.fetch_one(index as usize, memory) {
            Ok(fetched) => fetched,
            Err(error) => {
                self.error.set(error);
                return;
            }
        };
        let first =
            |values: &Option<Vec<[f32; 3]>>| values.as_ref().and_then(|all| all.first().copied());
        if let Some(normal) = first(&fetched.normals) {
            self.normal(normal);
        }
        if let Some(color) = fetched.colors.as_ref().and_then(|all| all.first()) {
            self.color(*color);
        }
        if let Some(color) = first(&fetched.secondary) {
            self.secondary_color(color);
        }
        if let Some(flag) = fetched.edge_flags.as_ref().and_then(|all| all.first()) {
            self.edge_flag(*flag);
        }
        if let Some(coordinate) = fetched.fog_coords.as_ref().and_then(|all| all.first()) {
            self.fog_coord(*coordinate);
        }
        for (unit, coordinates) in (gl::TEXTURE0..).zip(&fetched.tex_coords) {
            if let Some(coordinates) = coordinates.as_ref().and_then(|all| all.first()) {
                self.tex_coord(unit, *coordinates);
            }
        }
        if self.client.arrays.vertex.enabled
            && let Some(position) = fetched.positions.first()
        {
            self.vertex(*position);
        }
    }

    /// One vertex, whose attributes count also without an array of places.
    fn fetch_one(&mut self, index: usize, memory: &dyn ClientMemory) -> Result<Fetched, u32> {
        let enabled = std::mem::replace(&mut self.client.arrays.vertex.enabled, true);
        let places = self.client.arrays.vertex;
        if !enabled {
            // Nobody looks at the place.
            self.client.arrays.vertex = VertexArray { pointer: 0, buffer: 0, ..places };
        }
        let fetched = self.fetch(Wanted::Range { first: index, count: 1 }, memory);
        self.client.arrays.vertex = VertexArray { enabled, ..places };
        fetched
    }

    /// Whether arrays are to be drawn between `glBegin` and `glEnd`: an error, that a list keeps as a draw of nothing.
    fn is_drawn_within_begin(&mut self) -> bool {
        let within = self.is_within_begin();
        if within && self.is_compiling() {
            self.compile(Command::Draw(Arc::default()));
        }
        within
    }

    /// `glDrawArrays`.
    pub fn draw_arrays(&mut self, mode: u32, first: i32, count: i32, memory: &dyn ClientMemory) {
        if self.is_drawn_within_begin() {
            return;
        }
        demand!(self, mode <= gl::POLYGON, gl::INVALID_ENUM);
        demand!(self, first >= 0 && count >= 0, gl::INVALID_VALUE);
        let vertices = Wanted::Range { first: first as usize, count: count as usize };
        match self.fetch(vertices, memory) {
            Ok(vertices) => self.draw_fetched(ArrayDraw { mode, vertices, elements: None }),
            Err(error) => self.error.set(error),
        }
    }

    /// `glMultiDrawArrays`; as many draws as both slices have.
    pub fn multi_draw_arrays(
        &mut self,
        mode: u32,
        first: &[i32],
        count: &[i32],
        memory: &dyn ClientMemory,
    ) {
        let negative = count.iter().any(|count| *count < 0);
        demand!(self, !negative, gl::INVALID_VALUE);
        for (&first, &count) in first.iter().zip(count) {
            if count > 0 {
                self.draw_arrays(mode, first, count, memory);
            }
        }
    }

    /// `glDrawElements`; `indices` is an address, or an offset into the buffer of elements.
    pub fn draw_elements(
        &mut self,
        mode: u32,
        count: i32,
        data_type: u32,
        indices: usize,
        memory: &dyn ClientMemory,
    ) {
        if self.is_drawn_within_begin() {
            return;
        }
        demand!(self, mode <= gl::POLYGON, gl::INVALID_ENUM);
        demand!(self, count >= 0, gl::INVALID_VALUE);
        let is_type =
            matches!(data_type, gl::UNSIGNED_BYTE | gl::UNSIGNED_SHORT | gl::UNSIGNED_INT);
        demand!(self, is_type, gl::INVALID_ENUM);
        demand!(self, count as usize <= STREAM_VERTICES, gl::OUT_OF_MEMORY);
        let array = VertexArray {
            enabled: true,
            size: 1,
            data_type,
            stride: 0,
            pointer: indices,
            buffer: self.client.arrays.element_buffer,
        };
        let all = Wanted::Range { first: 0, count: count as usize };
        let decoded =
            self.with_bytes(&array, all, memory, |bytes| decode_indices(data_type, bytes));
        let drawn = decoded.and_then(|elements| self.fetch_elements(mode, elements, memory));
        match drawn {
            Ok(draw) => self.draw_fetched(draw),
            Err(error) => self.error.set(error),
        }
    }

    /// The vertices of elements: a run of all between the least and the greatest number where that is no more than
    /// twice as many, else one for each element.
    fn fetch_elements(
        &self,
        mode: u32,
        mut elements: Vec<u32>,
        memory: &dyn ClientMemory,
    ) -> Result<ArrayDraw, u32> {
        let list = Wanted::List(&elements);
        let (first, span) = list.span();
        if span > 2 * elements.len() {
            let vertices = self.fetch(list, memory)?;
            return Ok(ArrayDraw { mode, vertices, elements: None });
        }
        let vertices = self.fetch(Wanted::Range { first, count: span }, memory)?;
        if first > 0 {
            elements.iter_mut().for_each(|element| *element -= first as u32);
        }
        Ok(ArrayDraw { mode, vertices, elements: Some(elements) })
    }

    /// `glDrawRangeElements`; that no index lies outside of the range is the program's promise.
    #[expect(clippy::too_many_arguments, reason = "glDrawRangeElements has as many")]
    pub fn draw_range_elements(
        &mut self,
        mode: u32,
        start: u32,
        end: u32,
        count: i32,
        data_type: u32,
        indices: usize,
        memory: &dyn ClientMemory,
    ) {
        demand!(self, start <= end, gl::INVALID_VALUE);
        self.draw_elements(mode, count, data_type, indices, memory);
    }

    /// `glMultiDrawElements`; as many draws as both slices have.
    pub fn multi_draw_elements(
        &mut self,
        mode: u32,
        count: &[i32],
        data_type: u32,
        indices: &[usize],
        memory: &dyn ClientMemory,
    ) {
        let negative = count.iter().any(|count| *count < 0);
        demand!(self, !negative, gl::INVALID_VALUE);
        for (&count, &indices) in count.iter().zip(indices) {
            if count > 0 {
                self.draw_elements(mode, count, data_type, indices, memory);
            }
        }
    }

    /// Draws vertices of arrays, or puts them into the open list.
    fn draw_fetched(&mut self, draw: ArrayDraw) {
        let draw = Arc::new(draw);
        if self.is_compiling() {
            if !self.compile(Command::Draw(Arc::clone(&draw))) {
                self.draw_recorded(&draw);
            }
            return;
        }
        self.draw_vertices(VertexSource::Arrays(draw));
    }

    /// Draws vertices that a list holds.
    pub(crate) fn draw_recorded(&mut self, draw: &Arc<ArrayDraw>) {
        outside_begin!(self);
        self.draw_vertices(VertexSource::Arrays(Arc::clone(draw)));
    }
}
