//! `glBegin`, `glEnd` and what stands between them (OpenGL 1.5, sections 2.6 and 2.7), rectangles (2.11).
//!
//! Independent primitives wait after `glEnd`: where the next command is a `glBegin` of their mode, they go on, and are
//! drawn together.

use crate::Context;
use crate::context::{compile, demand, outside_begin, record};
use crate::enums as gl;
use crate::limits::{PART_VERTICES, STREAM_VERTICES, TEXTURE_UNITS};
use crate::objects::list::Command;
use crate::vertex::{VertexSource, Vertices, Welded};
use std::borrow::Cow;
use std::sync::Arc;

impl Context {
    /// `glBegin`. `GL_INVALID_OPERATION` within another one, `GL_INVALID_ENUM` for a mode that isn't one.
    pub fn begin(&mut self, mode: u32) {
        compile!(self, Command::Begin(mode));
        let is_listed = self.nesting > 0;
        if self.stream.resume(mode, is_listed) {
            return;
        }
        outside_begin!(self);
        demand!(self, mode <= gl::POLYGON, gl::INVALID_ENUM);
        if self.is_incomplete() {
            return;
        }
        let of = (mode, is_listed, self.render_mode == gl::SELECT);
        self.stream.begin(of, &self.state.current, self.state.materials);
    }

    /// `glEnd`. `GL_INVALID_OPERATION` without `glBegin`.
    pub fn end(&mut self) {
        compile!(self, Command::End);
        if !self.stream.is_open() {
            self.error.set(gl::INVALID_OPERATION);
            return;
        }
        self.stream.end();
        if !self.stream.is_waiting() {
            self.draw_waiting();
        }
    }

    /// `glVertex`: x, y, z, w. Outside of `glBegin` and `glEnd` it has no effect.
    #[inline(always)]
    pub fn vertex(&mut self, position: [f32; 4]) {
        // The coordinates go straight to where they stay: a copy in between would wait for their single stores.
        let usual = !self.is_compiling()
            && self.stream.is_open()
            && self.stream.vertices.push_usual(position, PART_VERTICES - 1);
        if !usual {
            let [x, y, z, w] = position;
            self.any_vertex(x, y, z, w);
        }
    }

    #[inline(never)]
    fn any_vertex(&mut self, x: f32, y: f32, z: f32, w: f32) {
        let position = [x, y, z, w];
        record!(self, |list| list.vertex(position));
        if self.stream.is_open() {
            self.stream.vertices.push(position);
            if self.stream.vertices.len() >= PART_VERTICES {
                self.limit_stream();
            }
        }
    }

    /// Draws a long stream of independent primitives in part, so that it doesn't grow without bound; ends others at a
    /// limit.
    #[cold]
    fn limit_stream(&mut self) {
        let count = self.stream.vertices.len();
        if self.stream.is_independent() {
            let mut stream = std::mem::take(&mut self.stream);
            self.draw_stream(&stream);
            stream.drop_complete();
            self.stream = stream;
        } else if count > STREAM_VERTICES {
            self.error.set(gl::OUT_OF_MEMORY);
            self.stream.vertices.truncate(STREAM_VERTICES);
        }
    }

    /// Vertices and attributes of a display list, as the commands that they are.
    pub(crate) fn vertices_of_list(&mut self, run: &Vertices) {
        run.put_current(&mut self.state.current);
        if self.state.enables.has(gl::COLOR_MATERIAL) {
            self.color_drives_material();
        }
        if self.stream.is_open() {
            self.stream.vertices.append(run);
            if self.stream.vertices.len() >= PART_VERTICES {
                self.limit_stream();
            }
        } else if self.stream.is_waiting() {
            self.stream.vertices.take_attributes(run);
        }
    }

    /// Primitives of a display list, from `glBegin` to `glEnd`.
    pub(crate) fn primitives_of_list(&mut self, of: &Arc<Welded>) {
        let Welded { mode, vertices, elements } = &**of;
        if self.stream.is_open() || self.is_incomplete() {
            // Some of the commands are errors.
            self.begin(*mode);
            self.vertices_of_list(&vertices.gathered(elements));
            self.end();
            return;
        }
        if self.stream.is_waiting() {
            self.draw_waiting();
        }
        self.draw_vertices(VertexSource::Welded(Arc::clone(of)));
        self.vertices_of_list(vertices);
    }

    /// `glColor`: red, green, blue, alpha, not clamped.
    #[inline]
    pub fn color(&mut self, color: [f32; 4]) {
        record!(self, |list| list.set(|run| run.set_color(color)));
        self.state.current.color = color;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_color(color);
        }
        if self.state.enables.has(gl::COLOR_MATERIAL) {
            self.color_drives_material();
        }
    }

    /// Puts the current colour into the materials that it drives (section 2.13.3).
    pub(crate) fn color_drives_material(&mut self) {
        let color = self.state.current.color;
        self.state.color_material.apply(color, &mut self.state.materials);
    }

    /// `glSecondaryColor`.
    #[inline]
    pub fn secondary_color(&mut self, color: [f32; 3]) {
        record!(self, |list| list.set(|run| run.set_secondary(color)));
        self.state.current.secondary = color;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_secondary(color);
        }
    }

    /// `glNormal`, of any length.
    #[inline]
    pub fn normal(&mut self, normal: [f32; 3]) {
        record!(self, |list| list.set(|run| run.set_normal(normal)));
        self.state.current.normal = normal;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_normal(normal);
        }
    }

    /// `glMultiTexCoord`: s, t, r, q of the unit `GL_TEXTUREi`. `GL_INVALID_ENUM` for a unit that isn't there.
    #[inline]
    pub fn tex_coord(&mut self, unit: u32, coordinates: [f32; 4]) {
        let number = unit.wrapping_sub(gl::TEXTURE0) as usize;
        if number >= TEXTURE_UNITS {
            compile!(self, Command::Error(gl::INVALID_ENUM));
            self.error.set(gl::INVALID_ENUM);
            return;
        }
        record!(self, |list| list.set(|run| run.set_tex_coord(number, coordinates)));
        self.state.current.tex_coords[number] = coordinates;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_tex_coord(number, coordinates);
        }
    }

    /// `glFogCoord`.
    #[inline]
    pub fn fog_coord(&mut self, coordinate: f32) {
        record!(self, |list| list.set(|run| run.set_fog_coord(coordinate)));
        self.state.current.fog_coord = coordinate;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_fog_coord(coordinate);
        }
    }

    /// `glEdgeFlag`: whether an edge of a polygon that begins at the next vertex is one of its border.
    #[inline]
    pub fn edge_flag(&mut self, flag: bool) {
        record!(self, |list| list.set(|run| run.set_edge_flag(flag)));
        self.state.current.edge_flag = flag;
        if self.stream.takes_attributes() {
            self.stream.vertices.set_edge_flag(flag);
        }
    }

    /// `glIndex`: state only, since there are no colour-index framebuffers.
    #[inline]
    pub fn index(&mut self, index: f32) {
        compile!(self, Command::Index(index));
        self.state.current.index = index;
    }

    /// `glRect`: a quadrilateral at z = 0, counter-clockwise if the second corner lies above to the right.
    pub fn rect(&mut self, first: [f32; 2], second: [f32; 2]) {
        compile!(self, Command::Rect(first, second));
        outside_begin!(self);
        let mut vertices = Vertices::default();
        vertices.restart(&self.state.current);
        let ([x1, y1], [x2, y2]) = (first, second);
        for [x, y] in [[x1, y1], [x2, y1], [x2, y2], [x1, y2]] {
            vertices.push([x, y, 0.0, 1.0]);
        }
        // A quad, as in Mesa: where it is clipped, its diagonal is that of quads.
        self.draw_vertices(VertexSource::Run(gl::QUADS, Cow::Owned(vertices)));
    }
}
