//! Occlusion queries.

use crate::canvas::{canvas, draw, gl};
use luxel_gl::Context;

const SAMPLES_PASSED: u32 = 0x8914;
const CURRENT_QUERY: u32 = 0x8865;
const RESULT: u32 = 0x8866;
const AVAILABLE: u32 = 0x8867;

fn square(context: &mut Context, side: f32, z: f32) {
    let corners = [[0.0, 0.0, z], [side, 0.0, z], [side, side, z], [0.0, side, z]];
    draw(context, gl::QUADS, &corners);
}

fn counted(context: &mut Context, work: impl FnOnce(&mut Context)) -> u64 {
    context.begin_query(SAMPLES_PASSED, 7);
    work(context);
    context.end_query(SAMPLES_PASSED);
    context.get_query_object(7, RESULT).unwrap()
}

#[test]
fn section_4_1_7_samples_that_pass_the_depth_test_are_counted() {
    let mut context = canvas(200, 200);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT);
    context.enable(gl::DEPTH_TEST);
    assert_eq!(counted(&mut context, |context| square(context, 100.0, 0.0)), 10_000);
    // Behind it, only what stands out passes; the window cuts the rest.
    assert_eq!(counted(&mut context, |context| square(context, 300.0, -0.5)), 30_000);
    assert_eq!(counted(&mut context, |context| square(context, 200.0, -0.9)), 0);
    // Two draws add up; draws before and after don't count, nor do clears.
    context.disable(gl::DEPTH_TEST);
    square(&mut context, 10.0, 0.0);
    let sum = counted(&mut context, |context| {
        square(context, 10.0, 0.0);
        context.clear(gl::COLOR_BUFFER_BIT);
        square(context, 20.0, 0.0);
    });
    square(&mut context, 10.0, 0.0);
    assert_eq!((sum, context.get_query_object(7, RESULT)), (500, Some(500)));
    // Alpha test and masks: what fails the former isn't counted, what the latter keep out is.
    context.enable(0x0BC0);
    context.alpha_func(0x0200, 0.0);
    assert_eq!(counted(&mut context, |context| square(context, 10.0, 0.0)), 0);
    context.disable(0x0BC0);
    context.color_mask(false, false, false, false);
    assert_eq!(counted(&mut context, |context| square(context, 10.0, 0.0)), 100);
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_4_1_7_a_query_that_is_begun_anew_starts_at_0_and_lists_hold_them() {
    let mut context = canvas(32, 32);
    context.new_list(1, gl::COMPILE);
    context.begin_query(SAMPLES_PASSED, 3);
    square(&mut context, 8.0, 0.0);
    context.end_query(SAMPLES_PASSED);
    context.end_list();
    assert!(!context.is_query(3));
    for _ in 0..2 {
        context.call_list(1);
        assert_eq!(context.get_query_object(3, AVAILABLE), Some(1));
        assert_eq!(context.get_query_object(3, RESULT), Some(64));
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
}

#[test]
fn section_4_1_7_one_query_counts_at_a_time() {
    let mut context = canvas(8, 8);
    let mut error = |work: &dyn Fn(&mut Context)| {
        work(&mut context);
        context.get_error()
    };
    assert_eq!(error(&|context| context.begin_query(SAMPLES_PASSED, 0)), gl::INVALID_OPERATION);
    assert_eq!(error(&|context| context.begin_query(gl::RGBA, 1)), gl::INVALID_ENUM);
    assert_eq!(error(&|context| context.end_query(SAMPLES_PASSED)), gl::INVALID_OPERATION);
    assert_eq!(error(&|context| context.begin_query(SAMPLES_PASSED, 1)), gl::NO_ERROR);
    assert_eq!(error(&|context| context.begin_query(SAMPLES_PASSED, 2)), gl::INVALID_OPERATION);
    let read = |name: u32, pname: u32| {
        move |context: &mut Context| assert_eq!(context.get_query_object(name, pname), None)
    };
    assert_eq!(error(&read(1, RESULT)), gl::INVALID_OPERATION);
    assert_eq!(error(&read(2, RESULT)), gl::INVALID_OPERATION);
    assert_eq!(error(&|context| context.end_query(SAMPLES_PASSED)), gl::NO_ERROR);
    assert_eq!(error(&read(1, CURRENT_QUERY)), gl::INVALID_ENUM);
    assert_eq!(error(&|context| drop(context.gen_queries(-1))), gl::INVALID_VALUE);
    // A query that is deleted while it counts is ended.
    context.begin_query(SAMPLES_PASSED, 1);
    context.delete_queries(&[1, 0, 99]);
    assert_eq!(context.get_query(SAMPLES_PASSED, CURRENT_QUERY).unwrap().to_i32(0), 0);
    assert!(!context.is_query(1));
    let names = context.gen_queries(3);
    assert!(names.len() == 3 && !context.is_query(names[0]));
    assert_eq!(context.get_error(), gl::NO_ERROR);
}
