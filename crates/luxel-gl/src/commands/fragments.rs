//! State of tests and blending (OpenGL 1.5, section 4.1).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;
use crate::state::attributes::SampleCoverage;
use crate::state::fragment::PixelBox;

fn is_comparison(func: u32) -> bool {
    (gl::NEVER..=gl::ALWAYS).contains(&func)
}

fn is_factor(factor: u32, of_source: bool) -> bool {
    match factor {
        gl::ZERO
        | gl::ONE
        | gl::SRC_COLOR
        | gl::ONE_MINUS_SRC_COLOR
        | gl::SRC_ALPHA
        | gl::ONE_MINUS_SRC_ALPHA
        | gl::DST_ALPHA
        | gl::ONE_MINUS_DST_ALPHA
        | gl::DST_COLOR
        | gl::ONE_MINUS_DST_COLOR
        | gl::CONSTANT_COLOR
        | gl::ONE_MINUS_CONSTANT_COLOR
        | gl::CONSTANT_ALPHA
        | gl::ONE_MINUS_CONSTANT_ALPHA => true,
        gl::SRC_ALPHA_SATURATE => of_source,
        _ => false,
    }
}

impl Context {
    /// `glScissor`: lower left corner and size.
    pub fn scissor(&mut self, x: i32, y: i32, width: i32, height: i32) {
        compile!(self, Command::Scissor([x, y, width, height]));
        outside_begin!(self);
        demand!(self, width >= 0 && height >= 0, gl::INVALID_VALUE);
        self.state.scissor = PixelBox { x, y, width, height };
    }

    /// `glSampleCoverage`: the part of a pixel's samples that fragments cover at most, clamped to 0..1, or its other part.
    pub fn sample_coverage(&mut self, value: f32, invert: bool) {
        compile!(self, Command::SampleCoverage(value, invert));
        outside_begin!(self);
        self.state.sample_coverage = SampleCoverage((unit(value), invert));
    }

    /// `glAlphaFunc`; the reference is clamped to 0..1.
    pub fn alpha_func(&mut self, func: u32, reference: f32) {
        compile!(self, Command::AlphaFunc(func, reference));
        outside_begin!(self);
        demand!(self, is_comparison(func), gl::INVALID_ENUM);
        self.state.color.alpha_func = func;
        self.state.color.alpha_reference =
            if reference.is_nan() { 0.0 } else { reference.clamp(0.0, 1.0) };
    }

    /// `glDepthFunc`.
    pub fn depth_func(&mut self, func: u32) {
        compile!(self, Command::DepthFunc(func));
        outside_begin!(self);
        demand!(self, is_comparison(func), gl::INVALID_ENUM);
        self.state.depth.func = func;
    }

    /// `glDepthMask`.
    pub fn depth_mask(&mut self, mask: bool) {
        compile!(self, Command::DepthMask(mask));
        outside_begin!(self);
        self.state.depth.mask = mask;
    }

    /// `glColorMask`.
    pub fn color_mask(&mut self, r: bool, g: bool, b: bool, a: bool) {
        compile!(self, Command::ColorMask([r, g, b, a]));
        outside_begin!(self);
        self.state.color.mask = [r, g, b, a];
    }

    /// `glIndexMask`: state only.
    pub fn index_mask(&mut self, mask: u32) {
        compile!(self, Command::IndexMask(mask));
        outside_begin!(self);
        self.state.color.index_mask = mask;
    }

    /// `glStencilFunc`.
    pub fn stencil_func(&mut self, func: u32, reference: i32, mask: u32) {
        compile!(self, Command::StencilFunc(func, reference, mask));
        outside_begin!(self);
        demand!(self, is_comparison(func), gl::INVALID_ENUM);
        let stencil = &mut self.state.stencil;
        (stencil.func, stencil.reference, stencil.value_mask) = (func, reference, mask);
    }

    /// `glStencilOp`: what happens where the stencil test fails, where the depth test fails, where both pass.
    pub fn stencil_op(&mut self, fail: u32, depth_fail: u32, pass: u32) {
        compile!(self, Command::StencilOp([fail, depth_fail, pass]));
        outside_begin!(self);
        let is_operation = |operation: u32| {
            matches!(
                operation,
                gl::KEEP
                    | gl::ZERO
                    | gl::REPLACE
                    | gl::INCR
                    | gl::DECR
                    | gl::INVERT
                    | gl::INCR_WRAP
                    | gl::DECR_WRAP
            )
        };
        let all = [fail, depth_fail, pass].into_iter().all(is_operation);
        demand!(self, all, gl::INVALID_ENUM);
        let stencil = &mut self.state.stencil;
        (stencil.fail, stencil.depth_fail, stencil.pass) = (fail, depth_fail, pass);
    }

    /// `glStencilMask`.
    pub fn stencil_mask(&mut self, mask: u32) {
        compile!(self, Command::StencilMask(mask));
        outside_begin!(self);
        self.state.stencil.write_mask = mask;
    }

    /// `glBlendFunc`.
    pub fn blend_func(&mut self, source: u32, destination: u32) {
        self.blend_func_separate(source, destination, source, destination);
    }

    /// `glBlendFuncSeparate`: factors of colours, then of alphas.
    pub fn blend_func_separate(&mut self, source: u32, destination: u32, sa: u32, da: u32) {
        compile!(self, Command::BlendFunc([source, destination, sa, da]));
        outside_begin!(self);
        let sound = is_factor(source, true)
            && is_factor(sa, true)
            && is_factor(destination, false)
            && is_factor(da, false);
        demand!(self, sound, gl::INVALID_ENUM);
        self.state.color.blend = [source, destination, sa, da];
    }

    /// `glBlendEquation`.
    pub fn blend_equation(&mut self, mode: u32) {
        self.blend_equation_separate(mode, mode);
    }

    /// `glBlendEquationSeparate` (EXT_blend_equation_separate): of colours and of alphas.
    pub fn blend_equation_separate(&mut self, colors: u32, alphas: u32) {
        let modes = [colors, alphas];
        compile!(self, Command::BlendEquation(modes));
        outside_begin!(self);
        let are_equations = modes.iter().all(|mode| {
            matches!(
                *mode,
                gl::FUNC_ADD | gl::FUNC_SUBTRACT | gl::FUNC_REVERSE_SUBTRACT | gl::MIN | gl::MAX
            )
        });
        demand!(self, are_equations, gl::INVALID_ENUM);
        self.state.color.blend_equations = modes;
    }

    /// `glBlendColor`, clamped to 0..1.
    pub fn blend_color(&mut self, color: [f32; 4]) {
        compile!(self, Command::BlendColor(color));
        outside_begin!(self);
        self.state.color.blend_color = color.map(unit);
    }

    /// `glLogicOp`.
    pub fn logic_op(&mut self, operation: u32) {
        compile!(self, Command::LogicOp(operation));
        outside_begin!(self);
        demand!(self, (gl::CLEAR..=gl::SET).contains(&operation), gl::INVALID_ENUM);
        self.state.color.logic_op = operation;
    }
}

/// A component within 0 and 1; 0 for NaN.
pub(crate) fn unit(value: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(0.0, 1.0) }
}
