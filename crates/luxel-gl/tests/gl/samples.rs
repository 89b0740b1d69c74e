//! Several samples a pixel (sections 3.2.1 and 4.1.3, EXT_framebuffer_multisample).

use crate::canvas::{canvas, draw, gl};
use crate::depth::{clear_parts_of_tiles, draw_all, drawn, drawn_large};
use luxel_gl::Context;
use proptest::prelude::*;

const FRAMEBUFFER: u32 = 0x8d40;
const READ_FRAMEBUFFER: u32 = 0x8ca8;
const DRAW_FRAMEBUFFER: u32 = 0x8ca9;
const RENDERBUFFER: u32 = 0x8d41;
const COLOR_ATTACHMENT0: u32 = 0x8ce0;
const DEPTH_ATTACHMENT: u32 = 0x8d00;
const STENCIL_ATTACHMENT: u32 = 0x8d20;
const STENCIL_INDEX8: u32 = 0x8d48;
const RGBA8: u32 = 0x8058;
const DEPTH_COMPONENT24: u32 = 0x81a6;
const NEAREST: u32 = 0x2600;
const COMPLETE: u32 = 0x8cd5;
const INCOMPLETE_MULTISAMPLE: u32 = 0x8d56;
const MULTISAMPLE: u32 = 0x809d;
const SAMPLE_COVERAGE: u32 = 0x80a0;
const SAMPLE_COVERAGE_VALUE: u32 = 0x80aa;
const MULTISAMPLE_BIT: u32 = 0x2000_0000;

const SIDE: i32 = 70;

/// Attaches a new renderbuffer of `samples` with the canvas's size.
fn attach(context: &mut Context, place: u32, samples: i32, format: u32) {
    let name = context.gen_renderbuffers(1)[0];
    context.bind_renderbuffer(RENDERBUFFER, name);
    let [width, height] = context.default_size().map(|side| side as i32);
    context.renderbuffer_storage(RENDERBUFFER, samples, format, width, height);
    context.framebuffer_renderbuffer(FRAMEBUFFER, place, RENDERBUFFER, name);
}

/// A canvas whose pixels have four samples; the framebuffer's name.
fn space() -> (Context, u32) {
    let mut context = canvas(SIDE as u32, SIDE as u32);
    let name = bind_samples(&mut context);
    (context, name)
}

/// Goes on with a framebuffer of the canvas's size whose pixels have four samples, without stencil values: its name.
fn bind_samples(context: &mut Context) -> u32 {
    let name = context.gen_framebuffers(1)[0];
    context.bind_framebuffer(FRAMEBUFFER, name);
    attach(context, COLOR_ATTACHMENT0, 4, RGBA8);
    attach(context, DEPTH_ATTACHMENT, 4, DEPTH_COMPONENT24);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    name
}

/// The same with stencil values.
pub(crate) fn bind_samples_with_stencil(context: &mut Context) -> u32 {
    let name = bind_samples(context);
    attach(context, STENCIL_ATTACHMENT, 4, STENCIL_INDEX8);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), COMPLETE);
    name
}

/// The mean of the samples.
pub(crate) fn resolved(context: &mut Context, from: u32) -> Vec<u8> {
    context.bind_framebuffer(READ_FRAMEBUFFER, from);
    context.bind_framebuffer(DRAW_FRAMEBUFFER, 0);
    let [width, height] = context.default_size().map(|side| side as i32);
    let whole = [0, 0, width, height];
    context.disable(gl::SCISSOR_TEST);
    context.blit_framebuffer(whole, whole, gl::COLOR_BUFFER_BIT, NEAREST);
    context.bind_framebuffer(FRAMEBUFFER, 0);
    let mut bytes = vec![0; (width * height * 4) as usize];
    context.read_pixels(0, 0, width, height, gl::RGBA, gl::UNSIGNED_BYTE, &mut bytes);
    context.bind_framebuffer(FRAMEBUFFER, from);
    assert_eq!(context.get_error(), gl::NO_ERROR);
    bytes
}

#[test]
fn section_3_2_1_a_pixel_has_the_share_of_its_samples_that_a_triangle_covers() {
    let (mut context, name) = space();
    context.color([1.0; 4]);
    // Corners on no sample, in steps that window coordinates keep.
    let steps = |x: i32, y: i32| [x, y].map(|step| step as f32 / 256.0);
    let [a, b, c] = [steps(833, 643), steps(17089, 5183), steps(5503, 16831)];
    draw(&mut context, gl::TRIANGLES, &[a, b, c].map(|[x, y]| [x, y, 0.0]));
    let bytes = resolved(&mut context, name);
    let samples = [[0.375, 0.125], [0.875, 0.375], [0.125, 0.625], [0.625, 0.875]];
    let left_of = |[ax, ay]: [f32; 2], [bx, by]: [f32; 2], [x, y]: [f32; 2]| {
        let area = (bx - ax) * (y - ay) - (by - ay) * (x - ax);
        assert!(area.abs() > 1e-4, "a sample on an edge");
        area > 0.0
    };
    let mut shares = [0; 5];
    for y in 0..SIDE {
        for x in 0..SIDE {
            let within = |sample: &&[f32; 2]| {
                let at = [x as f32 + sample[0], y as f32 + sample[1]];
                left_of(a, b, at) && left_of(b, c, at) && left_of(c, a, at)
            };
            let count = samples.iter().filter(within).count();
            shares[count] += 1;
            let byte = bytes[((y * SIDE + x) * 4) as usize];
            assert_eq!(usize::from(byte), (255 * count * 2 + 4) / 8, "at {x} {y}");
        }
    }
    assert!(shares.iter().all(|share| *share > 10), "{shares:?}");
}

#[test]
fn section_3_2_1_without_multisample_all_samples_are_those_of_the_centre() {
    let (mut context, name) = space();
    context.disable(MULTISAMPLE);
    draw(&mut context, gl::TRIANGLES, &[[3.3, 2.4, 0.0], [66.7, 20.1, 0.0], [21.4, 65.8, 0.0]]);
    let bytes = resolved(&mut context, name);
    assert!(bytes.iter().all(|byte| matches!(byte, 0 | 255)));
    assert!(bytes.contains(&255) && bytes.contains(&0));
}

#[test]
fn section_3_2_1_surfaces_that_cross_within_a_pixel_share_its_samples() {
    let (mut context, name) = space();
    context.enable(gl::DEPTH_TEST);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
    let side = SIDE as f32;
    for (color, [left, right]) in
        [([1.0, 0.0, 0.0, 1.0], [0.5, -0.5]), ([0.0, 1.0, 0.0, 1.0], [-0.5, 0.5])]
    {
        context.color(color);
        let corners =
            [[0.0, 0.0, left], [side, 0.0, right], [side, side, right], [0.0, side, left]];
        draw(&mut context, gl::QUADS, &corners);
    }
    let bytes = resolved(&mut context, name);
    // They cross at x = 35, in the middle between two pixels: turned, none would be half and half.
    let (mut both, mut one) = (0, 0);
    for pixel in bytes.as_chunks::<4>().0 {
        assert_eq!(u32::from(pixel[0]) + u32::from(pixel[1]), 255);
        let is_one = pixel[0] == 0 || pixel[1] == 0;
        if is_one { one += 1 } else { both += 1 }
    }
    assert!(one >= 68 * SIDE && both <= 2 * SIDE, "{one} {both}");
}

#[test]
fn section_4_1_3_coverage_is_saved_with_its_group_and_takes_effect_in_lists() {
    let (mut context, name) = space();
    context.enable(SAMPLE_COVERAGE);
    context.new_list(1, gl::COMPILE);
    context.sample_coverage(0.25, false);
    draw(
        &mut context,
        gl::QUADS,
        &[[0.0, 0.0, 0.0], [70.0, 0.0, 0.0], [70.0, 70.0, 0.0], [0.0, 70.0, 0.0]],
    );
    context.end_list();
    context.sample_coverage(7.0, true);
    context.push_attrib(MULTISAMPLE_BIT);
    context.call_list(1);
    context.pop_attrib();
    assert_eq!(context.get(SAMPLE_COVERAGE_VALUE).unwrap().to_f32(0), 1.0);
    assert!(resolved(&mut context, name).iter().all(|byte| *byte == 64));
}

#[test]
fn framebuffers_of_several_samples_refuse_what_the_extension_says() {
    let (mut context, name) = space();
    let mut pixel = [0; 4];
    context.read_pixels(0, 0, 1, 1, gl::RGBA, gl::UNSIGNED_BYTE, &mut pixel);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.copy_pixels([0, 0], [1, 1], 0x1800);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.bind_framebuffer(DRAW_FRAMEBUFFER, 0);
    let whole = [0, 0, SIDE, SIDE];
    context.blit_framebuffer(whole, [0, 0, SIDE, 9], gl::COLOR_BUFFER_BIT, NEAREST);
    assert_eq!(context.get_error(), gl::INVALID_OPERATION);
    context.bind_framebuffer(FRAMEBUFFER, name);
    context.renderbuffer_storage(RENDERBUFFER, 5, DEPTH_COMPONENT24, SIDE, SIDE);
    assert_eq!(context.get_error(), gl::INVALID_VALUE);
    context.renderbuffer_storage(RENDERBUFFER, 0, DEPTH_COMPONENT24, SIDE, SIDE);
    assert_eq!(context.check_framebuffer_status(FRAMEBUFFER), INCOMPLETE_MULTISAMPLE);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn section_4_1_6_in_each_sample_triangles_hide_one_another_in_the_order_of_calls(
        all in prop::collection::vec(drawn(), 1..120), run in 1..64_usize, by_samples in any::<bool>(),
    ) {
        let outcome = |waits: bool| {
            let (mut context, name) = space();
            if !by_samples {
                context.disable(MULTISAMPLE);
            }
            context.clear(gl::DEPTH_BUFFER_BIT);
            draw_all(&mut context, &all, run, waits);
            resolved(&mut context, name)
        };
        prop_assert!(outcome(true) == outcome(false));
    }

    #[test]
    fn section_4_1_6_what_is_decided_about_all_samples_of_a_tile_is_as_one_by_one(
        all in prop::collection::vec(drawn_large(), 1..12),
    ) {
        let outcome = |is_written: bool| {
            let (mut context, name) = space();
            context.clear(gl::DEPTH_BUFFER_BIT);
            if is_written {
                clear_parts_of_tiles(&mut context, [SIDE as usize; 2]);
            }
            draw_all(&mut context, &all, 1, true);
            resolved(&mut context, name)
        };
        prop_assert!(outcome(true) == outcome(false));
    }
}
