//! Primitives of several `glBegin` that are drawn together (sections 2.6 and 2.7): what stands between them.

use crate::canvas::{canvas, gl};
use luxel_gl::{Context, Words};

const FRONT_AND_BACK: u32 = 0x0408;
const AMBIENT: u32 = 0x1200;
const COLOR_MATERIAL: u32 = 0x0b57;
const FLAT: u32 = 0x1d00;
const ALWAYS: u32 = 0x0207;
const FRONT: u32 = 0x0404;
const CURRENT_BIT: u32 = 0x0001;
const LINE: u32 = 0x1b01;

/// Commands that draw, each with what it does to the next pairs of `glBegin` and `glEnd`.
type Step = fn(&mut Context);

fn triangle(context: &mut Context, mode: u32, [x, y]: [f32; 2]) {
    context.begin(mode);
    for [dx, dy] in [[0.0, 0.0], [0.7, 0.0], [0.7, 0.7], [0.0, 0.7]] {
        context.vertex([x + dx, y + dy, 0.25 * x, 1.0]);
        context.color([0.5 + 0.5 * x, dx, 0.5 - 0.5 * y, 1.0]);
    }
    context.end();
}

const STEPS: &[Step] = &[
    |context| context.color([1.0, 0.5, 0.25, 1.0]),
    |context| context.enable(gl::LIGHTING),
    |context| context.normal([0.6, 0.0, 0.8]),
    |context| context.material(FRONT_AND_BACK, AMBIENT, &[0.9, 0.1, 0.4, 1.0]),
    |context| context.rotate(30.0, 0.0, 0.0, 1.0),
    |context| context.enable(COLOR_MATERIAL),
    |context| context.shade_model(FLAT),
    |context| context.depth_func(ALWAYS),
    |context| context.cull_face(FRONT),
    |context| context.enable(gl::CULL_FACE),
    |context| context.load_name(7),
    |context| context.push_attrib(CURRENT_BIT),
    |context| context.color([0.0, 0.9, 0.4, 1.0]),
    |context| context.pop_attrib(),
    |context| context.call_list(1),
    |context| context.viewport(10, 5, 40, 40),
    |context| context.disable(gl::LIGHTING),
    |context| context.clear_depth(0.5),
    |context| context.clear(gl::DEPTH_BUFFER_BIT),
    |context| context.polygon_mode(FRONT_AND_BACK, LINE),
];

/// A context whose object coordinates are clip coordinates.
fn space() -> Context {
    let mut context = canvas(64, 48);
    context.matrix_mode(gl::PROJECTION);
    context.load_identity();
    context.matrix_mode(gl::MODELVIEW);
    context
}

fn pixels(mode: u32, between: Step) -> Vec<u8> {
    let mut context = space();
    context.new_list(1, gl::COMPILE);
    context.normal([0.0, 0.6, 0.8]);
    triangle(&mut context, mode, [-0.1, -0.2]);
    context.color([0.3, 0.3, 1.0, 1.0]);
    context.end_list();
    context.enable(gl::LIGHT0);
    context.enable(gl::DEPTH_TEST);
    for (number, step) in STEPS.iter().enumerate() {
        let at = [number as f32 * 0.08 - 0.9, 0.4 - (number % 3) as f32 * 0.5];
        triangle(&mut context, mode, at);
        between(&mut context);
        step(&mut context);
        between(&mut context);
        triangle(&mut context, mode, [at[0] + 0.04, at[1] - 0.2]);
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    let mut pixels = vec![0; 64 * 48 * 4];
    context.read_pixels(0, 0, 64, 48, gl::RGBA, gl::UNSIGNED_BYTE, &mut pixels);
    pixels
}

#[test]
fn section_2_6_primitives_have_the_state_of_their_own_begin_however_long_they_wait() {
    for mode in [gl::POINTS, gl::LINES, gl::TRIANGLES, gl::QUADS, gl::POLYGON] {
        let waiting = pixels(mode, |_| {});
        let at_once = pixels(mode, Context::finish);
        assert!(waiting == at_once, "mode {mode:#x}");
        assert!(waiting.iter().any(|byte| *byte != 0));
    }
}

fn words(between: Step) -> Vec<u32> {
    let mut context = space();
    context.select_buffer(1 << 12);
    context.render_mode(gl::SELECT);
    for number in 0..40_u32 {
        match number % 8 {
            0 => context.init_names(),
            1 | 5 => context.push_name(number),
            2 | 3 => context.load_name(number),
            6 => context.pop_name(),
            _ => {}
        }
        between(&mut context);
        // Every third lies outside.
        let x = if number % 3 == 0 { 1.5 } else { number as f32 * 0.04 - 0.9 };
        triangle(&mut context, gl::TRIANGLES, [x, -0.4]);
        between(&mut context);
    }
    let Words::Selection(words) = context.render_mode(gl::RENDER).words else { panic!("records") };
    assert_eq!(context.get_error(), gl::NO_ERROR);
    words
}

#[test]
fn section_5_2_hits_have_the_names_of_their_own_begin_however_long_they_wait() {
    let waiting = words(|_| {});
    assert_eq!(waiting, words(Context::finish));
    assert!(waiting.len() > 60);
}

#[test]
fn section_5_2_names_are_refused_by_the_depth_that_waiting_changes_leave() {
    let mut context = space();
    context.select_buffer(1 << 12);
    context.render_mode(gl::SELECT);
    triangle(&mut context, gl::TRIANGLES, [0.0; 2]);
    context.load_name(1);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    triangle(&mut context, gl::TRIANGLES, [0.0; 2]);
    context.push_name(1);
    context.pop_name();
    context.pop_name();
    assert_eq!(context.get_error(), gl::STACK_UNDERFLOW);
    for _ in 0..64 {
        context.push_name(1);
    }
    triangle(&mut context, gl::TRIANGLES, [0.0; 2]);
    context.push_name(1);
    assert_eq!(context.get_error(), gl::STACK_OVERFLOW);
    assert_eq!(context.render_mode(gl::RENDER).count, 2);
}
