//! The log: what has been drawn and not yet been carried out.

use super::framebuffer::Framebuffer;
use luxel_math::Level;

/// One `glClear`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Clear {
    /// Left, bottom, right and top, the last two beyond.
    pub(crate) region: [i32; 4],
    pub(crate) color: [f32; 4],
    /// The bits of a colour that are written.
    pub(crate) color_mask: u32,
    pub(crate) depth: Option<f64>,
    pub(crate) stencil: Option<u8>,
    pub(crate) stencil_mask: u8,
}

/// What has been drawn.
#[derive(Debug, Default)]
pub(crate) struct Log {
    clears: Vec<Clear>,
}

impl Log {
    pub(crate) fn clear(&mut self, clear: Clear) {
        self.clears.push(clear);
    }

    pub(crate) fn carry_out(&mut self, _framebuffer: &mut Framebuffer, _level: Level) {
        self.clears.clear();
    }
}
