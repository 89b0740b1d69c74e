// Written by ../../generator from gl.xml and commands.toml: change these.

//! Operations on fragments and on the framebuffer (4.1, 4.2).

use crate::prelude::*;

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glAccum(op: u32, value: f32) {
    call(|gl, _| gl.accum(op, value));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glAlphaFunc(func: u32, reference: f32) {
    call(|gl, _| gl.alpha_func(func, reference));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlendColor(red: f32, green: f32, blue: f32, alpha: f32) {
    call(|gl, _| gl.blend_color([red, green, blue, alpha]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlendEquation(mode: u32) {
    call(|gl, _| gl.blend_equation(mode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlendEquationSeparate(mode_rgb: u32, mode_alpha: u32) {
    call(|gl, _| gl.blend_equation_separate(mode_rgb, mode_alpha));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlendFunc(sfactor: u32, dfactor: u32) {
    call(|gl, _| gl.blend_func(sfactor, dfactor));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glBlendFuncSeparate(
    sfactor_rgb: u32,
    dfactor_rgb: u32,
    sfactor_alpha: u32,
    dfactor_alpha: u32,
) {
    call(|gl, _| gl.blend_func_separate(sfactor_rgb, dfactor_rgb, sfactor_alpha, dfactor_alpha));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClear(mask: u32) {
    call(|gl, _| gl.clear(mask));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClearAccum(red: f32, green: f32, blue: f32, alpha: f32) {
    call(|gl, _| gl.clear_accum([red, green, blue, alpha]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClearColor(red: f32, green: f32, blue: f32, alpha: f32) {
    call(|gl, _| gl.clear_color([red, green, blue, alpha]));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClearDepth(depth: f64) {
    call(|gl, _| gl.clear_depth(depth));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClearIndex(c: f32) {
    call(|gl, _| gl.clear_index(c));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glClearStencil(s: i32) {
    call(|gl, _| gl.clear_stencil(s));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glColorMask(red: u8, green: u8, blue: u8, alpha: u8) {
    call(|gl, _| gl.color_mask(red != 0, green != 0, blue != 0, alpha != 0));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDepthFunc(func: u32) {
    call(|gl, _| gl.depth_func(func));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDepthMask(flag: u8) {
    call(|gl, _| gl.depth_mask(flag != 0));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glDrawBuffer(buf: u32) {
    call(|gl, _| gl.draw_buffer(buf));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glIndexMask(mask: u32) {
    call(|gl, _| gl.index_mask(mask));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glLogicOp(opcode: u32) {
    call(|gl, _| gl.logic_op(opcode));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glSampleCoverage(value: f32, invert: u8) {
    call(|gl, _| gl.sample_coverage(value, invert != 0));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glScissor(x: i32, y: i32, width: i32, height: i32) {
    call(|gl, _| gl.scissor(x, y, width, height));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glStencilFunc(func: u32, reference: i32, mask: u32) {
    call(|gl, _| gl.stencil_func(func, reference, mask));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glStencilMask(mask: u32) {
    call(|gl, _| gl.stencil_mask(mask));
}

#[unsafe(no_mangle)]
pub(crate) extern "C" fn glStencilOp(fail: u32, zfail: u32, zpass: u32) {
    call(|gl, _| gl.stencil_op(fail, zfail, zpass));
}

aliases! {
    glBlendColorEXT = glBlendColor(red: f32, green: f32, blue: f32, alpha: f32);
    glBlendEquationEXT = glBlendEquation(mode: u32);
    glBlendFuncSeparateEXT = glBlendFuncSeparate(sfactor_rgb: u32, dfactor_rgb: u32, sfactor_alpha: u32, dfactor_alpha: u32);
    glSampleCoverageARB = glSampleCoverage(value: f32, invert: u8);
}
