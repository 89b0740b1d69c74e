//! Draws.

use crate::Context;
use crate::context::{compile, outside_begin};
use crate::objects::list::Command;
use crate::vertex::Stream;

impl Context {
    pub(crate) fn draw(&mut self, stream: &Stream) {
        let _ = stream;
    }

    /// `glRasterPos`: x, y, z, w, through transform and lighting (OpenGL 1.5, section 2.12).
    pub fn raster_pos(&mut self, position: [f32; 4]) {
        compile!(self, Command::RasterPos(position));
        outside_begin!(self);
    }

    /// `glWindowPos`: x and y in the window, z from 0 to 1.
    pub fn window_pos(&mut self, position: [f32; 3]) {
        compile!(self, Command::WindowPos(position));
        outside_begin!(self);
    }
}
