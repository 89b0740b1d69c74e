//! Commands that meet images while they are drawn to (EXT_framebuffer_object, section 4.4).

use crate::canvas::{canvas, draw, gl};
use luxel_gl::{Configuration, Context};

const FRAMEBUFFER: u32 = 0x8d40;
const RENDERBUFFER: u32 = 0x8d41;
const COLOR: u32 = 0x8ce0;
const DEPTH: u32 = 0x8d00;
const STENCIL: u32 = 0x8d20;
const RGBA8: u32 = 0x8058;
const DEPTH24: u32 = 0x81a6;
const DEPTH24_STENCIL8: u32 = 0x88f0;
const DEPTH_STENCIL: u32 = 0x84f9;
const UNSIGNED_INT_24_8: u32 = 0x84fa;
const TEXTURE_2D: u32 = 0x0de1;
const COMPLETE: u32 = 0x8cd5;
const INCOMPLETE_ATTACHMENT: u32 = 0x8cd6;
const MISSING_ATTACHMENT: u32 = 0x8cd7;

const SIDE: i32 = 8;

fn texture(context: &mut Context, inside: u32, format: u32, data_type: u32) -> u32 {
    let name = context.gen_textures(1)[0];
    context.bind_texture(TEXTURE_2D, name);
    context.tex_image_2d(TEXTURE_2D, 0, inside as i32, [SIDE; 2], 0, format, data_type, None);
    name
}

fn renderbuffer(context: &mut Context, format: u32) -> u32 {
    let name = context.gen_renderbuffers(1)[0];
    context.bind_renderbuffer(RENDERBUFFER, name);
    context.renderbuffer_storage(RENDERBUFFER, 0, format, SIDE, SIDE);
    name
}

/// A framebuffer object is bound; nothing is attached.
fn space() -> Context {
    let mut context = canvas(SIDE as u32, SIDE as u32);
    let name = context.gen_framebuffers(1)[0];
    context.bind_framebuffer(FRAMEBUFFER, name);
    context
}

fn pixel(context: &mut Context, x: i32, y: i32) -> [u8; 4] {
    let mut pixel = [9; 4];
    context.read_pixels(x, y, 1, 1, gl::RGBA, gl::UNSIGNED_BYTE, &mut pixel);
    pixel
}

fn fill(context: &mut Context, color: [f32; 4]) {
    context.color(color);
    let side = SIDE as f32;
    let corners = [[0.0, 0.0, 0.0], [side, 0.0, 0.0], [side, side, 0.0], [0.0, side, 0.0]];
    draw(context, gl::QUADS, &corners);
}

#[test]
fn new_storage_of_one_image_leaves_what_was_drawn_to_another() {
    let mut context = space();
    let color = renderbuffer(&mut context, RGBA8);
    context.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, color);
    let depth = renderbuffer(&mut context, DEPTH24);
    context.framebuffer_renderbuffer(FRAMEBUFFER, DEPTH, RENDERBUFFER, depth);
    fill(&mut context, [1.0, 0.0, 0.0, 1.0]);
    context.renderbuffer_storage(RENDERBUFFER, 0, DEPTH24, SIDE, SIDE);
    assert_eq!(pixel(&mut context, 3, 3), [255, 0, 0, 255]);
    context.delete_renderbuffers(&[depth]);
    assert_eq!(pixel(&mut context, 3, 3), [255, 0, 0, 255]);
    context.delete_renderbuffers(&[color]);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), MISSING_ATTACHMENT);
}

#[test]
fn a_part_of_a_texture_that_is_drawn_to_is_replaced_among_what_was_drawn() {
    let mut context = space();
    let name = texture(&mut context, RGBA8, gl::RGBA, gl::UNSIGNED_BYTE);
    context.framebuffer_texture(FRAMEBUFFER, COLOR, TEXTURE_2D, name, 0, 0);
    fill(&mut context, [0.0, 1.0, 0.0, 1.0]);
    let texel = [10, 20, 30, 255];
    context.tex_sub_image(
        2,
        TEXTURE_2D,
        0,
        [2, 3, 0],
        [1, 1, 1],
        gl::RGBA,
        gl::UNSIGNED_BYTE,
        &texel,
    );
    assert_eq!(pixel(&mut context, 2, 3), texel);
    assert_eq!(pixel(&mut context, 3, 3), [0, 255, 0, 255]);
    let mut all = vec![0; (SIDE * SIDE * 4) as usize];
    context.get_tex_image(TEXTURE_2D, 0, gl::RGBA, gl::UNSIGNED_BYTE, &mut all);
    assert_eq!(all[..4], [0, 255, 0, 255]);
    context.delete_textures(1, &[name]);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), MISSING_ATTACHMENT);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn textures_of_depth_and_stencil_keep_both_and_those_of_depth_have_no_stencil() {
    let mut context = space();
    let both = texture(&mut context, DEPTH24_STENCIL8, DEPTH_STENCIL, UNSIGNED_INT_24_8);
    context.framebuffer_texture(FRAMEBUFFER, DEPTH, TEXTURE_2D, both, 0, 0);
    context.framebuffer_texture(FRAMEBUFFER, STENCIL, TEXTURE_2D, both, 0, 0);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    context.clear_stencil(0x5a);
    context.clear_depth(1.0);
    context.clear(0x400 | gl::DEPTH_BUFFER_BIT);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    let mut words = vec![0; (SIDE * SIDE * 4) as usize];
    context.get_tex_image(TEXTURE_2D, 0, DEPTH_STENCIL, UNSIGNED_INT_24_8, &mut words);
    assert!(words.as_chunks::<4>().0.iter().all(|word| u32::from_ne_bytes(*word) == 0xffff_ff5a));
    assert_eq!(context.get_error(), gl::NO_ERROR);
    let mut context = space();
    let depth = texture(&mut context, DEPTH24, gl::DEPTH_COMPONENT, gl::FLOAT);
    context.framebuffer_texture(FRAMEBUFFER, STENCIL, TEXTURE_2D, depth, 0, 0);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), INCOMPLETE_ATTACHMENT);
}

#[test]
fn bits_and_alphas_are_those_of_the_framebuffer_that_is_bound() {
    let mut context = Context::new(Configuration { alpha: false, ..Configuration::default() });
    context.resize_default(SIDE as u32, SIDE as u32);
    context.clear_color([0.2; 4]);
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(pixel(&mut context, 0, 0), [51, 51, 51, 255]);
    let name = context.gen_framebuffers(1)[0];
    context.bind_framebuffer(FRAMEBUFFER, name);
    let color = renderbuffer(&mut context, RGBA8);
    context.framebuffer_renderbuffer(FRAMEBUFFER, COLOR, RENDERBUFFER, color);
    context.clear(gl::COLOR_BUFFER_BIT);
    assert_eq!(pixel(&mut context, 0, 0), [51; 4]);
    // Bits of alpha, depth and stencil.
    let bits = |context: &mut Context| {
        [0x0d55, 0x0d56, 0x0d57].map(|name| context.get(name).unwrap().to_i32(0))
    };
    assert_eq!(bits(&mut context), [8, 0, 0]);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    assert_eq!(bits(&mut context), [0, 24, 8]);
}
