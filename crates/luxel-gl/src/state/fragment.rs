//! State of fragments: tests, blending, masks, what buffers are cleared to, fog (OpenGL 1.5, sections 3.10, 4.1, 4.2).

use crate::enums as gl;

/// Fog (section 3.10).
#[derive(Clone, Debug)]
pub(crate) struct FogState {
    pub(crate) mode: u32,
    pub(crate) density: f32,
    pub(crate) start: f32,
    pub(crate) end: f32,
    pub(crate) index: f32,
    pub(crate) color: [f32; 4],
    pub(crate) source: u32,
}

/// The scissor box: left, bottom, width, height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct PixelBox {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) width: i32,
    pub(crate) height: i32,
}

/// The stencil test (section 4.1.5).
#[derive(Clone, Debug)]
pub(crate) struct Stencil {
    pub(crate) func: u32,
    pub(crate) reference: i32,
    pub(crate) value_mask: u32,
    pub(crate) write_mask: u32,
    pub(crate) fail: u32,
    pub(crate) depth_fail: u32,
    pub(crate) pass: u32,
    pub(crate) clear: i32,
}

/// Depth.
#[derive(Clone, Debug)]
pub(crate) struct Depth {
    pub(crate) func: u32,
    pub(crate) mask: bool,
    pub(crate) clear: f64,
}

/// Everything about colours of the framebuffer.
#[derive(Clone, Debug)]
pub(crate) struct ColorBuffer {
    pub(crate) alpha_func: u32,
    pub(crate) alpha_reference: f32,
    /// Factors: of the source's colour, the destination's, and of both alphas.
    pub(crate) blend: [u32; 4],
    /// Of colours, then of alphas.
    pub(crate) blend_equations: [u32; 2],
    pub(crate) blend_color: [f32; 4],
    pub(crate) logic_op: u32,
    pub(crate) mask: [bool; 4],
    pub(crate) index_mask: u32,
    pub(crate) clear: [f32; 4],
    pub(crate) clear_index: f32,
    pub(crate) draw_buffer: u32,
}

impl Default for FogState {
    fn default() -> Self {
        Self {
            mode: gl::EXP,
            density: 1.0,
            start: 0.0,
            end: 1.0,
            index: 0.0,
            color: [0.0; 4],
            source: gl::FRAGMENT_DEPTH,
        }
    }
}

impl Default for Stencil {
    fn default() -> Self {
        Self {
            func: gl::ALWAYS,
            reference: 0,
            value_mask: u32::MAX,
            write_mask: u32::MAX,
            fail: gl::KEEP,
            depth_fail: gl::KEEP,
            pass: gl::KEEP,
            clear: 0,
        }
    }
}

impl Default for Depth {
    fn default() -> Self {
        Self { func: gl::LESS, mask: true, clear: 1.0 }
    }
}

impl Default for ColorBuffer {
    fn default() -> Self {
        Self {
            alpha_func: gl::ALWAYS,
            alpha_reference: 0.0,
            blend: [gl::ONE, gl::ZERO, gl::ONE, gl::ZERO],
            blend_equations: [gl::FUNC_ADD; 2],
            blend_color: [0.0; 4],
            logic_op: gl::COPY,
            mask: [true; 4],
            index_mask: u32::MAX,
            clear: [0.0; 4],
            clear_index: 0.0,
            draw_buffer: gl::FRONT,
        }
    }
}
