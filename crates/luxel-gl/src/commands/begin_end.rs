//! `glBegin`, `glEnd` and what stands between them (OpenGL 1.5, sections 2.6 and 2.7), rectangles (2.11).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::limits::{PART_VERTICES, STREAM_VERTICES, TEXTURE_UNITS};
use crate::objects::list::Command;
use crate::vertex::Stream;

impl Context {
    /// `glBegin`. `GL_INVALID_OPERATION` within another one, `GL_INVALID_ENUM` for a mode that isn't one.
    pub fn begin(&mut self, mode: u32) {
        compile!(self, Command::Begin(mode));
        outside_begin!(self);
        demand!(self, mode <= gl::POLYGON, gl::INVALID_ENUM);
        if self.is_incomplete() {
            return;
        }
        self.stream = Some(Box::new(Stream::new(mode, &self.state.current, self.state.materials)));
    }

    /// `glEnd`. `GL_INVALID_OPERATION` without `glBegin`.
    pub fn end(&mut self) {
        compile!(self, Command::End);
        let Some(stream) = self.stream.take() else {
            self.error.set(gl::INVALID_OPERATION);
            return;
        };
        self.draw(&stream);
    }

    /// `glVertex`: x, y, z, w. Outside of `glBegin` and `glEnd` it has no effect.
    #[inline]
    pub fn vertex(&mut self, position: [f32; 4]) {
        compile!(self, Command::Vertex(position));
        let Some(stream) = &mut self.stream else { return };
        stream.push(position);
        if stream.len() >= PART_VERTICES {
            self.draw_part();
        }
    }

    /// Draws a stream of independent primitives in part, so that it doesn't grow without bound; ends others at a
    /// limit.
    #[cold]
    fn draw_part(&mut self) {
        let Some(mut stream) = self.stream.take() else { return };
        let independent = matches!(stream.mode, gl::POINTS | gl::LINES | gl::TRIANGLES | gl::QUADS);
        if independent && stream.len() == PART_VERTICES {
            self.draw(&stream);
            stream.keep_from(PART_VERTICES);
        } else if stream.len() > STREAM_VERTICES {
            self.error.set(gl::OUT_OF_MEMORY);
            stream.positions.pop();
        }
        self.stream = Some(stream);
    }

    /// `glColor`: red, green, blue, alpha, not clamped.
    #[inline]
    pub fn color(&mut self, color: [f32; 4]) {
        compile!(self, Command::Color(color));
        self.state.current.color = color;
        if let Some(stream) = &mut self.stream {
            stream.color.set(color, stream.positions.len());
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
        compile!(self, Command::SecondaryColor(color));
        self.state.current.secondary = color;
        if let Some(stream) = &mut self.stream {
            stream.secondary.set(color, stream.positions.len());
        }
    }

    /// `glNormal`, of any length.
    #[inline]
    pub fn normal(&mut self, normal: [f32; 3]) {
        compile!(self, Command::Normal(normal));
        self.state.current.normal = normal;
        if let Some(stream) = &mut self.stream {
            stream.normal.set(normal, stream.positions.len());
        }
    }

    /// `glMultiTexCoord`: s, t, r, q of the unit `GL_TEXTUREi`. `GL_INVALID_ENUM` for a unit that isn't there.
    #[inline]
    pub fn tex_coord(&mut self, unit: u32, coordinates: [f32; 4]) {
        compile!(self, Command::TexCoord(unit, coordinates));
        let number = unit.wrapping_sub(gl::TEXTURE0) as usize;
        demand!(self, number < TEXTURE_UNITS, gl::INVALID_ENUM);
        self.state.current.tex_coords[number] = coordinates;
        if let Some(stream) = &mut self.stream {
            stream.set_tex_coord(number, coordinates);
        }
    }

    /// `glFogCoord`.
    #[inline]
    pub fn fog_coord(&mut self, coordinate: f32) {
        compile!(self, Command::FogCoord(coordinate));
        self.state.current.fog_coord = coordinate;
        if let Some(stream) = &mut self.stream {
            stream.fog_coord.set(coordinate, stream.positions.len());
        }
    }

    /// `glEdgeFlag`: whether an edge of a polygon that begins at the next vertex is one of its border.
    #[inline]
    pub fn edge_flag(&mut self, flag: bool) {
        compile!(self, Command::EdgeFlag(flag));
        self.state.current.edge_flag = flag;
        if let Some(stream) = &mut self.stream {
            stream.edge_flag.set(flag, stream.positions.len());
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
        let mut stream = Stream::new(gl::POLYGON, &self.state.current, self.state.materials);
        let ([x1, y1], [x2, y2]) = (first, second);
        for [x, y] in [[x1, y1], [x2, y1], [x2, y2], [x1, y2]] {
            stream.push([x, y, 0.0, 1.0]);
        }
        self.draw(&stream);
    }
}
