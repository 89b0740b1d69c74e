//! The accumulation buffer (OpenGL 1.5, section 4.2.4).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;

impl Context {
    /// Whether what is drawn to has an accumulation buffer.
    fn accumulates(&self) -> bool {
        self.configuration.accum_bits > 0 && self.framebuffers.draw == 0
    }

    /// Whether there is memory for the buffer, which is 0 at first.
    fn has_accumulation(&mut self) -> bool {
        let [width, height] = self.framebuffer.size().map(|side| side as usize);
        let count = width * height;
        if self.accumulation.len() != count {
            self.accumulation = Vec::new();
            if self.accumulation.try_reserve_exact(count).is_err() {
                self.error.set(gl::OUT_OF_MEMORY);
                return false;
            }
            self.accumulation.resize(count, [0.0; 4]);
        }
        true
    }

    /// The part of `glClear` that is the accumulation buffer's.
    pub(super) fn clear_accumulation(&mut self) {
        if !self.accumulates() || !self.has_accumulation() {
            return;
        }
        let color = self.state.clear_accum;
        self.each_accumulated(|_, _, sum| *sum = color);
    }

    /// Shows each pixel within the scissor box with its sum.
    fn each_accumulated(&mut self, mut visit: impl FnMut(&mut Self, [u32; 2], &mut [f32; 4])) {
        let [left, bottom, right, top] = self.scissored_region().map(|at| at as u32);
        let [width, _] = self.framebuffer.size();
        let mut sums = std::mem::take(&mut self.accumulation);
        for y in bottom..top {
            for x in left..right {
                let place = y as usize * width as usize + x as usize;
                if let Some(sum) = sums.get_mut(place) {
                    visit(self, [x, y], sum);
                }
            }
        }
        self.accumulation = sums;
    }

    /// `glAccum`: loads or adds colours times a value, adds to sums or multiplies them, or returns them times a value as
    /// colours, within the scissor box. Sums are from -1 to 1. `GL_INVALID_OPERATION` without such a buffer.
    pub fn accum(&mut self, operation: u32, value: f32) {
        compile!(self, Command::Accum(operation, value));
        outside_begin!(self);
        let is_operation =
            matches!(operation, gl::ACCUM | gl::LOAD | gl::RETURN | gl::MULT | gl::ADD);
        demand!(self, is_operation, gl::INVALID_ENUM);
        let there = self.accumulates() && self.framebuffers.read == self.framebuffers.draw;
        demand!(self, there, gl::INVALID_OPERATION);
        if self.render_mode != gl::RENDER || !self.has_accumulation() {
            return;
        }
        self.carry_out();
        let within = |value: f32| if value.is_nan() { 0.0 } else { value.clamp(-1.0, 1.0) };
        let mask = self.state.color.mask;
        let returns = operation == gl::RETURN && self.state.color.draw_buffer != gl::NONE;
        self.drawn |= returns;
        self.each_accumulated(|context, at, sum| {
            let color = match operation {
                gl::ACCUM | gl::LOAD => context.frame_colors().color(at),
                _ => [0.0; 4],
            };
            for (sum, color) in sum.iter_mut().zip(color) {
                *sum = within(match operation {
                    gl::ACCUM => *sum + color * value,
                    gl::LOAD => color * value,
                    gl::MULT => *sum * value,
                    gl::ADD => *sum + value,
                    _ => *sum,
                });
            }
            if returns {
                let mut bytes = context.framebuffer.color(at);
                for channel in (0..4).filter(|&channel| mask[channel]) {
                    bytes[channel] = (unit(sum[channel] * value) * 255.0 + 0.5) as u8;
                }
                context.framebuffer.set_color(at, bytes);
            }
        });
    }
}
