//! The accumulation buffer.

use crate::canvas::{gl, pixels};
use luxel_gl::{Configuration, Context};

const ACCUM: u32 = 0x0100;
const LOAD: u32 = 0x0101;
const RETURN: u32 = 0x0102;
const MULT: u32 = 0x0103;
const ADD: u32 = 0x0104;
const ACCUM_BUFFER_BIT: u32 = 0x200;

fn accumulating() -> Context {
    let mut context = Context::new(Configuration { accum_bits: 16, ..Configuration::default() });
    context.resize_default(2, 2);
    context
}

fn filled(context: &mut Context, color: [f32; 4]) {
    context.clear_color(color);
    context.clear(gl::COLOR_BUFFER_BIT);
}

#[test]
fn section_4_2_4_sums_of_pictures_are_returned() {
    let mut context = accumulating();
    filled(&mut context, [1.0, 0.0, 0.2, 1.0]);
    context.accum(LOAD, 0.5);
    filled(&mut context, [0.0, 1.0, 0.2, 1.0]);
    context.accum(ACCUM, 0.25);
    context.accum(RETURN, 1.0);
    assert_eq!(pixels(&mut context), [[128, 64, 38, 191]; 4]);
    context.accum(MULT, -1.0);
    context.accum(ADD, 0.75);
    context.accum(RETURN, 2.0);
    assert_eq!(pixels(&mut context), [[128, 255, 255, 0]; 4]);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_4_2_4_scissor_box_and_colour_mask_hold() {
    let mut context = accumulating();
    context.clear_accum([0.2, 0.4, 0.6, 1.0]);
    context.clear(ACCUM_BUFFER_BIT);
    filled(&mut context, [0.0; 4]);
    context.enable(gl::SCISSOR_TEST);
    context.scissor(1, 0, 1, 1);
    context.color_mask(true, false, true, true);
    context.accum(RETURN, 1.0);
    let drawn = [51, 0, 153, 255];
    assert_eq!(pixels(&mut context), [[0; 4], drawn, [0; 4], [0; 4]]);
    context.accum(MULT, 0.0);
    context.disable(gl::SCISSOR_TEST);
    context.accum(RETURN, 0.5);
    let half = [26, 0, 77, 128];
    assert_eq!(pixels(&mut context), [half, [0; 4], half, half]);
    // Another size begins at 0.
    context.resize_default(3, 1);
    context.accum(RETURN, 1.0);
    assert_eq!(pixels(&mut context), [[0; 4]; 3]);
}

#[test]
fn section_4_2_4_there_is_none_unless_it_was_asked_for_and_none_in_objects() {
    let mut context = Context::new(Configuration::default());
    context.resize_default(2, 2);
    context.accum(LOAD, 1.0);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.clear(ACCUM_BUFFER_BIT);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    let mut context = accumulating();
    context.accum(gl::RGBA, 1.0);
    assert_eq!(context.get_error(), gl::INVALID_ENUM);
    context.begin(gl::POINTS);
    context.accum(LOAD, 1.0);
    context.end();
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.new_list(1, gl::COMPILE);
    context.accum(ADD, 0.4);
    context.accum(RETURN, 1.0);
    context.end_list();
    assert_eq!(pixels(&mut context), [[0; 4]; 4]);
    context.call_list(1);
    assert_eq!(pixels(&mut context), [[102; 4]; 4]);
}
