//! What the tests draw on.

use luxel_gl::{Configuration, Context};

/// Symbolic constants, by their names in C.
#[allow(dead_code, reason = "a list of names, of which tests use some")]
pub(crate) mod gl {
    pub(crate) const POINTS: u32 = 0;
    pub(crate) const LINES: u32 = 1;
    pub(crate) const LINE_STRIP: u32 = 3;
    pub(crate) const TRIANGLES: u32 = 4;
    pub(crate) const QUADS: u32 = 7;
    pub(crate) const POLYGON: u32 = 9;
    pub(crate) const COLOR_BUFFER_BIT: u32 = 0x4000;
    pub(crate) const DEPTH_BUFFER_BIT: u32 = 0x100;
    pub(crate) const RGBA: u32 = 0x1908;
    pub(crate) const UNSIGNED_BYTE: u32 = 0x1401;
    pub(crate) const UNSIGNED_INT: u32 = 0x1405;
    pub(crate) const FLOAT: u32 = 0x1406;
    pub(crate) const DEPTH_COMPONENT: u32 = 0x1902;
    pub(crate) const MODELVIEW: u32 = 0x1700;
    pub(crate) const PROJECTION: u32 = 0x1701;
    pub(crate) const DEPTH_TEST: u32 = 0x0B71;
    pub(crate) const LIGHTING: u32 = 0x0B50;
    pub(crate) const LIGHT0: u32 = 0x4000;
    pub(crate) const BLEND: u32 = 0x0BE2;
    pub(crate) const CULL_FACE: u32 = 0x0B44;
    pub(crate) const SCISSOR_TEST: u32 = 0x0C11;
    pub(crate) const NO_ERROR: u32 = 0;
    pub(crate) const INVALID_ENUM: u32 = 0x0500;
    pub(crate) const INVALID_VALUE: u32 = 0x0501;
    pub(crate) const INVALID_OPERATION: u32 = 0x0502;
    pub(crate) const STACK_OVERFLOW: u32 = 0x0503;
    pub(crate) const STACK_UNDERFLOW: u32 = 0x0504;
    pub(crate) const COMPILE: u32 = 0x1300;
    pub(crate) const COMPILE_AND_EXECUTE: u32 = 0x1301;
    pub(crate) const RENDER: u32 = 0x1C00;
    pub(crate) const FEEDBACK: u32 = 0x1C01;
    pub(crate) const SELECT: u32 = 0x1C02;
    pub(crate) const ALL_ATTRIB_BITS: u32 = 0xffff_ffff;
}

/// A context whose object coordinates are pixels, the origin at the lower left; z from 1 near to -1 far.
pub(crate) fn canvas(width: u32, height: u32) -> Context {
    let mut context = Context::new(Configuration::default());
    context.resize_default(width, height);
    context.matrix_mode(gl::PROJECTION);
    context.ortho(0.0, f64::from(width), 0.0, f64::from(height), -1.0, 1.0);
    context.matrix_mode(gl::MODELVIEW);
    context
}

/// All pixels, the bottom row first.
pub(crate) fn pixels(context: &mut Context) -> Vec<[u8; 4]> {
    let [width, height] = context.default_size();
    let mut bytes = vec![0; (width * height * 4) as usize];
    let (w, h) = (width as i32, height as i32);
    context.read_pixels(0, 0, w, h, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    bytes.as_chunks().0.to_vec()
}

/// The window depths of all pixels.
pub(crate) fn depths(context: &mut Context) -> Vec<f32> {
    let [width, height] = context.default_size();
    let mut bytes = vec![0; (width * height * 4) as usize];
    let (w, h) = (width as i32, height as i32);
    context.read_pixels(0, 0, w, h, gl::DEPTH_COMPONENT, gl::FLOAT, &mut bytes);
    bytes.as_chunks().0.iter().map(|bytes| f32::from_ne_bytes(*bytes)).collect()
}

/// Draws a primitive of one colour.
pub(crate) fn draw(context: &mut Context, mode: u32, vertices: &[[f32; 3]]) {
    context.begin(mode);
    for [x, y, z] in vertices {
        context.vertex([*x, *y, *z, 1.0]);
    }
    context.end();
}
