//! Fragments that mix with what is there (section 4.1): in the order of their calls, whatever they are carried out with.

use crate::canvas::{canvas, depths, draw, gl, pixels};
use crate::samples::{bind_samples_with_stencil, resolved};
use luxel_gl::Context;
use proptest::prelude::*;

const TEXTURE_2D: u32 = 0x0de1;
const MIN_FILTER: u32 = 0x2801;
const NEAREST: u32 = 0x2600;
const TEXTURE0: u32 = 0x84c0;
const SRC_ALPHA: u32 = 0x0302;
const ONE_MINUS_SRC_ALPHA: u32 = 0x0303;
const ALPHA_TEST: u32 = 0x0bc0;
const GREATER: u32 = 0x0204;
const STENCIL_TEST: u32 = 0x0b90;
const STENCIL_BUFFER_BIT: u32 = 0x400;
const STENCIL_INDEX: u32 = 0x1901;
const ALWAYS: u32 = 0x0207;
const KEEP: u32 = 0x1e00;
const INCR: u32 = 0x1e02;
const INVERT: u32 = 0x150a;
const POLYGON_STIPPLE: u32 = 0x0b42;
const POLYGON_OFFSET_FILL: u32 = 0x8037;
const SAMPLES_PASSED: u32 = 0x8914;
const QUERY_RESULT: u32 = 0x8866;

const SIZE: [u32; 2] = [100, 70];

/// What a run of primitives goes through.
#[derive(Clone, Debug)]
struct Tests {
    /// The first or the second one.
    texture: Option<bool>,
    blends: bool,
    by_alpha: bool,
    /// The comparison, and whether depths are written.
    depth: Option<(u32, bool)>,
    counts_stencil: bool,
    stippled: bool,
    moved: bool,
    /// From the half of the run on.
    is_counted: bool,
}

#[derive(Clone, Debug)]
struct Primitive {
    mode: u32,
    corners: [[f32; 3]; 3],
    color: [f32; 4],
}

fn tests() -> impl Strategy<Value = Tests> {
    let often = || prop::bool::weighted(0.8);
    let rarely = || prop::bool::weighted(0.2);
    let func = prop::sample::select(vec![0x201, 0x202, 0x203, 0x206, 0x207]);
    (
        prop::option::weighted(0.8, any::<bool>()),
        (often(), rarely()),
        prop::option::weighted(0.7, (func, often())),
        [rarely(), rarely(), rarely(), rarely()],
    )
        .prop_map(|(texture, (blends, by_alpha), depth, rare)| {
            let [counts_stencil, stippled, moved, is_counted] = rare;
            Tests { texture, blends, by_alpha, depth, counts_stencil, stippled, moved, is_counted }
        })
}

fn primitive() -> impl Strategy<Value = Primitive> {
    let mode = prop_oneof![8 => Just(gl::TRIANGLES), 1 => Just(gl::LINES), 1 => Just(gl::POINTS)];
    let place = [0.0..100.0_f32, 0.0..70.0_f32];
    let size = prop_oneof![3 => 0.3..5.0_f32, 2 => 5.0..20.0_f32, 1 => 20.0..150.0_f32];
    let corner = || [-1.0..1.0_f32, -1.0..1.0_f32, -1.0..1.0_f32];
    let unit = || 0.0..1.0_f32;
    (mode, place, size, [corner(), corner(), corner()], [unit(), unit(), unit(), unit()]).prop_map(
        |(mode, [x, y], size, corners, color)| {
            // Few depths: equally near ones are frequent.
            let corners =
                corners.map(|[dx, dy, z]| [x + dx * size, y + dy * size, (z * 2.0).round() / 4.0]);
            Primitive { mode, corners, color }
        },
    )
}

fn switch(context: &mut Context, capability: u32, is_on: bool) {
    if is_on {
        context.enable(capability);
    } else {
        context.disable(capability);
    }
}

impl Tests {
    fn set(&self, context: &mut Context, textures: &[u32]) {
        switch(context, TEXTURE_2D, self.texture.is_some());
        context.bind_texture(TEXTURE_2D, textures[usize::from(self.texture == Some(true))]);
        switch(context, gl::BLEND, self.blends);
        switch(context, ALPHA_TEST, self.by_alpha);
        switch(context, gl::DEPTH_TEST, self.depth.is_some());
        if let Some((func, writes)) = self.depth {
            context.depth_func(func);
            context.depth_mask(writes);
        }
        switch(context, STENCIL_TEST, self.counts_stencil);
        switch(context, POLYGON_STIPPLE, self.stippled);
        switch(context, POLYGON_OFFSET_FILL, self.moved);
    }
}

/// A canvas with two textures, of few texels and of many alphas.
fn space() -> (Context, Vec<u32>) {
    let mut context = canvas(SIZE[0], SIZE[1]);
    context.blend_func(SRC_ALPHA, ONE_MINUS_SRC_ALPHA);
    context.alpha_func(GREATER, 0.3);
    context.stencil_func(ALWAYS, 0, 255);
    context.stencil_op(KEEP, INVERT, INCR);
    context.polygon_offset(0.0, 4000.0);
    context.polygon_stipple(&[0b1100_1010; 128]);
    let names = context.gen_textures(2);
    for (number, name) in names.iter().enumerate() {
        context.bind_texture(TEXTURE_2D, *name);
        let texels: Vec<u8> = (0..64).map(|at: u32| (at * 37 + 91 * number as u32) as u8).collect();
        context.tex_image_2d(
            TEXTURE_2D,
            0,
            gl::RGBA as i32,
            [4; 2],
            0,
            gl::RGBA,
            gl::UNSIGNED_BYTE,
            Some(&texels),
        );
        context.tex_parameter(TEXTURE_2D, MIN_FILTER, &[NEAREST as f32]);
    }
    context.clear(gl::DEPTH_BUFFER_BIT | STENCIL_BUFFER_BIT);
    (context, names)
}

/// Pixels, depths, stencil values, and how many samples passed.
type Outcome = (Vec<[u8; 4]>, Vec<f32>, Vec<u8>, u64);

/// Draws runs of primitives; with `waits` all are carried out together.
fn draw_runs(
    context: &mut Context,
    textures: &[u32],
    runs: &[(Tests, Vec<Primitive>)],
    waits: bool,
) -> u64 {
    let mut count = 0;
    let query = context.gen_queries(1)[0];
    for (tests, primitives) in runs {
        tests.set(context, textures);
        for (number, Primitive { mode, corners, color }) in primitives.iter().enumerate() {
            if tests.is_counted && number == primitives.len() / 2 {
                context.begin_query(SAMPLES_PASSED, query);
            }
            context.color(*color);
            context.begin(*mode);
            let corners = if *mode == gl::LINES { &corners[..2] } else { &corners[..] };
            for [x, y, z] in corners {
                context.tex_coord(TEXTURE0, [x / 7.0, y / 9.0, 0.0, 1.0]);
                context.vertex([*x, *y, *z, 1.0]);
            }
            context.end();
            if !waits {
                context.finish();
            }
        }
        if tests.is_counted {
            context.end_query(SAMPLES_PASSED);
            count += context.get_query_object(query, QUERY_RESULT).unwrap();
        }
    }
    assert_eq!(context.get_error(), gl::NO_ERROR);
    count
}

/// What a framebuffer with one sample shows after runs of primitives.
fn drawn(runs: &[(Tests, Vec<Primitive>)], waits: bool) -> Outcome {
    let (mut context, textures) = space();
    let count = draw_runs(&mut context, &textures, runs, waits);
    let stencil = stencil_values(&mut context);
    (pixels(&mut context), depths(&mut context), stencil, count)
}

/// What one with four samples shows, and how many passed.
fn drawn_in_samples(runs: &[(Tests, Vec<Primitive>)], waits: bool) -> (Vec<u8>, u64) {
    let (mut context, textures) = space();
    let name = bind_samples_with_stencil(&mut context);
    context.clear(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT | STENCIL_BUFFER_BIT);
    let count = draw_runs(&mut context, &textures, runs, waits);
    (resolved(&mut context, name), count)
}

fn stencil_values(context: &mut Context) -> Vec<u8> {
    let [width, height] = SIZE.map(|side| side as i32);
    let mut values = vec![0; (width * height) as usize];
    context.read_pixels(0, 0, width, height, STENCIL_INDEX, gl::UNSIGNED_BYTE, &mut values);
    values
}

#[test]
fn section_4_1_5_hidden_fragments_that_mix_change_stencil_values() {
    let (mut context, textures) = space();
    let less = Some((0x201, true));
    let tests = |texture, blends, counts_stencil| Tests {
        texture,
        blends,
        by_alpha: false,
        depth: less,
        counts_stencil,
        stippled: false,
        moved: false,
        is_counted: false,
    };
    tests(None, false, false).set(&mut context, &textures);
    draw(&mut context, gl::TRIANGLES, &[[0.0, 0.0, 0.5], [90.0, 0.0, 0.5], [0.0, 90.0, 0.5]]);
    tests(Some(false), true, true).set(&mut context, &textures);
    // One before what is there, one behind it; none covers a whole block.
    for (x, z) in [(5.0, 0.75), (25.0, 0.0)] {
        draw(&mut context, gl::TRIANGLES, &[[x, 5.0, z], [x + 4.0, 5.0, z], [x, 9.0, z]]);
    }
    let values = stencil_values(&mut context);
    let at = |x: usize| values[6 * SIZE[0] as usize + x];
    assert_eq!([at(6), at(26), at(46)], [1, 255, 0]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn section_4_1_fragments_that_are_carried_out_together_mix_in_the_order_of_calls(
        runs in prop::collection::vec((tests(), prop::collection::vec(primitive(), 1..24)), 1..8),
    ) {
        prop_assert!(drawn(&runs, true) == drawn(&runs, false));
    }

    #[test]
    fn section_4_1_in_each_sample_fragments_mix_in_the_order_of_calls(
        runs in prop::collection::vec((tests(), prop::collection::vec(primitive(), 1..24)), 1..8),
    ) {
        prop_assert!(drawn_in_samples(&runs, true) == drawn_in_samples(&runs, false));
    }
}
