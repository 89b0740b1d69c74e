//! Coordinates of the clip volume (ARB_clip_control), and depths as floats (ARB_depth_buffer_float).

use crate::canvas::{depths, draw, gl, pixels};
use luxel_gl::{Configuration, Context, Words};

const LOWER_LEFT: u32 = 0x8ca1;
const UPPER_LEFT: u32 = 0x8ca2;
const NEGATIVE_ONE_TO_ONE: u32 = 0x935e;
const ZERO_TO_ONE: u32 = 0x935f;
const FRAMEBUFFER: u32 = 0x8d40;
const RENDERBUFFER: u32 = 0x8d41;
const DEPTH: u32 = 0x8d00;
const DEPTH_STENCIL_ATTACHMENT: u32 = 0x821a;
const DEPTH24: u32 = 0x81a6;
const DEPTH32F: u32 = 0x8cac;
const DEPTH32F_STENCIL8: u32 = 0x8cad;
const DEPTH_STENCIL: u32 = 0x84f9;
const FLOAT_AND_BYTE: u32 = 0x8dad;
const STENCIL_BUFFER_BIT: u32 = 0x400;
const COMPLETE: u32 = 0x8cd5;
const NEAREST: u32 = 0x2600;
const GREATER: u32 = 0x204;
const ALWAYS: u32 = 0x207;
const SIDE: u32 = 8;

/// A context whose object coordinates are clip coordinates.
fn volume(origin: u32, depth: u32) -> Context {
    let mut context = Context::new(Configuration::default());
    context.resize_default(SIDE, SIDE);
    context.clip_control(origin, depth);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.enable(gl::DEPTH_TEST);
    context.depth_func(ALWAYS);
    context
}

/// A triangle that covers all pixels.
fn cover(context: &mut Context, z: f32) {
    draw(context, gl::TRIANGLES, &[[-3.0, -1.0, z], [3.0, -1.0, z], [0.0, 9.0, z]]);
}

/// An object is bound, with a plane of depths of a format at an attachment.
fn with_depths(context: &mut Context, attachment: u32, format: u32) -> u32 {
    let plane = context.gen_renderbuffers(1)[0];
    context.bind_renderbuffer(RENDERBUFFER, plane);
    context.renderbuffer_storage(RENDERBUFFER, 0, format, SIDE as i32, SIDE as i32);
    let object = context.gen_framebuffers(1)[0];
    context.bind_framebuffer(FRAMEBUFFER, object);
    context.framebuffer_renderbuffer(FRAMEBUFFER, attachment, RENDERBUFFER, plane);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    object
}

fn depth_at(context: &mut Context, x: i32, y: i32) -> f32 {
    let mut bytes = [0; 4];
    context.read_pixels(x, y, 1, 1, gl::DEPTH_COMPONENT, gl::FLOAT, &mut bytes);
    f32::from_ne_bytes(bytes)
}

#[test]
fn the_near_plane_lies_at_zero_and_depths_are_z() {
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    for z in [0.0, 0.25, 0.75, 1.0] {
        cover(&mut context, z);
        assert!((depth_at(&mut context, 3, 3) - z).abs() < 1e-7, "z = {z}");
    }
    context.depth_range(0.5, 1.0);
    cover(&mut context, 0.5);
    assert!((depth_at(&mut context, 3, 3) - 0.75).abs() < 1e-7);
    context.depth_range(0.0, 1.0);
    for outside in [-0.01, 1.01] {
        context.clear(gl::COLOR_BUFFER_BIT);
        cover(&mut context, outside);
        assert!(pixels(&mut context).iter().all(|pixel| *pixel == [0; 4]), "z = {outside}");
    }
}

#[test]
fn what_reaches_before_the_near_plane_is_cut_there() {
    // z runs from -1 at the left side to 1 at the right one: the left half lies before the near plane at 0.
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    let corners = [[-1.0, -1.0, -1.0], [1.0, -1.0, 1.0], [1.0, 1.0, 1.0], [-1.0, 1.0, -1.0]];
    draw(&mut context, gl::QUADS, &corners);
    let seen = pixels(&mut context);
    for (at, pixel) in seen.iter().enumerate() {
        assert_eq!(pixel[0] > 0, at % 8 >= 4, "pixel {at}");
    }
    let found = depths(&mut context);
    for x in 4..8 {
        let expected = (x as f32 + 0.5) / 4.0 - 1.0;
        assert!((found[x] - expected).abs() < 1e-6, "{} at {x}", found[x]);
    }
}

#[test]
fn y_runs_downwards_and_faces_stay_what_they_are() {
    for origin in [LOWER_LEFT, UPPER_LEFT] {
        let mut context = volume(origin, NEGATIVE_ONE_TO_ONE);
        context.enable(gl::CULL_FACE);
        // In the lower half of the volume, counter-clockwise there.
        let corners = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
        draw(&mut context, gl::QUADS, &corners);
        let seen = pixels(&mut context);
        for (at, pixel) in seen.iter().enumerate() {
            let is_lower = at / 8 < 4;
            assert_eq!(pixel[0] > 0, is_lower == (origin == LOWER_LEFT), "pixel {at}");
        }
        // One that reaches behind the eye, too.
        context.clear(gl::COLOR_BUFFER_BIT);
        context.begin(gl::TRIANGLES);
        for corner in [[-1.0, -1.0, 0.0, 1.0], [1.0, -1.0, 0.0, 1.0], [0.0, 1.0, 0.0, -0.5]] {
            context.vertex(corner);
        }
        context.end();
        assert!(pixels(&mut context).iter().any(|pixel| pixel[0] > 0), "origin {origin:#x}");
    }
}

#[test]
fn selection_feedback_and_raster_positions_go_by_it() {
    let mut context = volume(UPPER_LEFT, ZERO_TO_ONE);
    context.select_buffer(16);
    context.render_mode(gl::SELECT);
    draw(&mut context, gl::LINES, &[[0.0, 0.0, -0.5], [0.0, 0.0, 0.5]]);
    draw(&mut context, gl::POINTS, &[[0.0, 0.0, -0.25]]);
    let Words::Selection(words) = context.render_mode(gl::RENDER).words else { panic!() };
    let depth = |word: u32| f64::from(word) / f64::from(u32::MAX);
    assert_eq!(words[0], 0);
    assert!(depth(words[1]) == 0.0 && (depth(words[2]) - 0.5).abs() < 1e-6);

    context.feedback_buffer(16, 0x0601);
    context.render_mode(gl::FEEDBACK);
    draw(&mut context, gl::POINTS, &[[0.5, 0.5, 0.25]]);
    let Words::Feedback(words) = context.render_mode(gl::RENDER).words else { panic!() };
    assert_eq!(words[1..4], [6.0, 2.0, 0.25]);

    context.raster_pos([0.5, 0.5, 0.25, 1.0]);
    let place = context.get(0x0B07).unwrap();
    assert_eq!([0, 1, 2].map(|at| place.to_f32(at)), [6.0, 2.0, 0.25]);
}

#[test]
fn it_is_state_of_the_transform_and_goes_into_lists() {
    let mut context = volume(UPPER_LEFT, ZERO_TO_ONE);
    let state = |context: &mut Context| {
        [0x935c, 0x935d].map(|name| context.get(name).unwrap().to_i32(0) as u32)
    };
    context.clip_control(1, ZERO_TO_ONE);
    assert_eq!(context.get_error(), gl::INVALID_ENUM);
    context.clip_control(LOWER_LEFT, 1);
    assert_eq!(context.get_error(), gl::INVALID_ENUM);
    assert_eq!(state(&mut context), [UPPER_LEFT, ZERO_TO_ONE]);
    context.push_attrib(0x1000);
    context.new_list(1, gl::COMPILE);
    context.clip_control(LOWER_LEFT, NEGATIVE_ONE_TO_ONE);
    context.end_list();
    assert_eq!(state(&mut context), [UPPER_LEFT, ZERO_TO_ONE]);
    context.call_list(1);
    assert_eq!(state(&mut context), [LOWER_LEFT, NEGATIVE_ONE_TO_ONE]);
    context.pop_attrib();
    assert_eq!(state(&mut context), [UPPER_LEFT, ZERO_TO_ONE]);
}

#[test]
fn floats_tell_depths_near_zero_apart_and_steps_do_not() {
    for (format, apart) in [(DEPTH24, false), (DEPTH32F, true), (DEPTH32F_STENCIL8, true)] {
        let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
        with_depths(&mut context, DEPTH, format);
        context.draw_buffer(0);
        context.clear_depth(0.0);
        context.clear(gl::DEPTH_BUFFER_BIT);
        context.depth_func(GREATER);
        cover(&mut context, 1.0e-9);
        let first = depth_at(&mut context, 3, 3);
        cover(&mut context, 1.5e-9);
        let second = depth_at(&mut context, 3, 3);
        assert_eq!(second > first, apart, "{format:#x}: {first} and {second}");
        if apart {
            assert!((first - 1.0e-9).abs() < 1e-15 && (second - 1.5e-9).abs() < 1e-15);
        }
    }
}

#[test]
fn floats_are_read_as_they_are_alone_and_beside_stencil_values() {
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    with_depths(&mut context, DEPTH_STENCIL_ATTACHMENT, DEPTH32F_STENCIL8);
    assert_eq!(context.get(0x0D56).unwrap().to_i32(0), 32);
    context.clear_depth(0.1);
    context.clear_stencil(77);
    context.clear(gl::DEPTH_BUFFER_BIT | STENCIL_BUFFER_BIT);
    assert_eq!(depth_at(&mut context, 1, 2), 0.1);
    let mut both = [0; 8];
    context.read_pixels(1, 2, 1, 1, DEPTH_STENCIL, FLOAT_AND_BYTE, &mut both);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    assert_eq!(both[..4], 0.1_f32.to_ne_bytes());
    assert_eq!(both[4..], 77_u32.to_ne_bytes());
    for format in [gl::RGBA, gl::DEPTH_COMPONENT] {
        context.read_pixels(1, 2, 1, 1, format, FLOAT_AND_BYTE, &mut both);
        assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    }
    // What is drawn to it from memory is exact, too.
    context.enable(0x0B90);
    context.stencil_func(ALWAYS, 0, 255);
    context.window_pos([2.0, 2.0, 0.0]);
    let pixel = [0.3_f32.to_ne_bytes(), 5_u32.to_ne_bytes()].concat();
    context.draw_pixels([1, 1], DEPTH_STENCIL, FLOAT_AND_BYTE, &pixel);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.read_pixels(2, 2, 1, 1, DEPTH_STENCIL, FLOAT_AND_BYTE, &mut both);
    assert_eq!(both.as_slice(), pixel);
}

#[test]
fn offsets_move_floats_by_their_last_places() {
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    with_depths(&mut context, DEPTH, DEPTH32F);
    context.draw_buffer(0);
    context.enable(0x8037);
    context.polygon_offset(0.0, 3.0);
    for z in [0.75_f32, 0.0625] {
        cover(&mut context, z);
        assert_eq!(depth_at(&mut context, 3, 3), f32::from_bits(z.to_bits() + 3));
    }
}

#[test]
fn depths_are_copied_between_planes_of_one_kind_alone() {
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    let floats = with_depths(&mut context, DEPTH, DEPTH32F);
    context.clear_depth(0.1);
    context.clear(gl::DEPTH_BUFFER_BIT);
    let other = with_depths(&mut context, DEPTH, DEPTH32F_STENCIL8);
    let steps = with_depths(&mut context, DEPTH, DEPTH24);
    let whole = [0, 0, SIDE as i32, SIDE as i32];
    context.bind_framebuffer(0x8ca8, floats);
    context.blit_framebuffer(whole, whole, gl::DEPTH_BUFFER_BIT, NEAREST);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.blit_framebuffer(whole, whole, STENCIL_BUFFER_BIT, NEAREST);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.bind_framebuffer(0x8ca9, other);
    context.blit_framebuffer(whole, whole, gl::DEPTH_BUFFER_BIT, NEAREST);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    context.bind_framebuffer(FRAMEBUFFER, other);
    assert_eq!(depth_at(&mut context, 5, 5), 0.1);
    context.bind_framebuffer(FRAMEBUFFER, steps);
    assert_eq!(depth_at(&mut context, 5, 5), 0.0);
}

#[test]
fn a_context_without_its_own_framebuffer_draws_to_objects_alone() {
    let mut context = volume(LOWER_LEFT, ZERO_TO_ONE);
    context.remove_default();
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), 0x8219);
    cover(&mut context, 0.5);
    assert_eq!(context.get_error(), 0x0506);
    context.read_pixels(0, 0, 1, 1, gl::RGBA, gl::UNSIGNED_BYTE, &mut [0; 4]);
    assert_eq!(context.get_error(), 0x0506);
    with_depths(&mut context, DEPTH, DEPTH24);
    context.draw_buffer(0);
    cover(&mut context, 0.5);
    assert!((depth_at(&mut context, 3, 3) - 0.5).abs() < 1e-6);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    context.resize_default(SIDE, SIDE);
    cover(&mut context, 0.5);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    assert_eq!(pixels(&mut context)[0], [255; 4]);
}
