//! Streams of any commands with any arguments: nothing panics, and neither threads nor SIMD levels change a byte or an
//! answer.
//!
//! `LUXEL_RANDOM_CALLS=N` has each test make about N calls.

mod arrays;
mod framebuffers;
mod images;
mod primitives;
mod textures;

use crate::canvas::{gl, pixels};
use luxel_gl::{Configuration, Context, SimdLevel, Words};
use std::collections::BTreeSet;

/// Numbers that look random, the same each time (Marsaglia 2003).
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32
    }

    fn below(&mut self, limit: u32) -> u32 {
        self.next() % limit
    }

    /// Mostly about the window, sometimes far away, rarely no number at all.
    fn place(&mut self) -> f32 {
        match self.below(40) {
            0 => f32::NAN,
            1 => f32::INFINITY,
            2 => 1e30,
            3..=5 => (self.below(2000) as f32 - 1000.0) * 3.0,
            _ => self.below(1000) as f32 / 400.0 - 1.25,
        }
    }

    fn unit(&mut self) -> f32 {
        self.below(1300) as f32 / 1000.0 - 0.15
    }

    fn color(&mut self) -> [f32; 4] {
        std::array::from_fn(|_| self.unit())
    }

    fn of(&mut self, names: &[u32]) -> u32 {
        // Now and then a name that isn't one.
        if self.below(50) == 0 {
            self.next()
        } else {
            names[self.below(names.len() as u32) as usize]
        }
    }
}

/// A kind of stream.
struct Mix {
    /// A command with its arguments, which may add answers.
    command: fn(&mut Context, &mut Numbers, &mut Vec<u64>),
    /// How many commands there are to one of these; the others are of [`primitives`].
    one_in: u32,
    /// Commands of a stream.
    commands: u32,
    /// Streams, unless the environment says how many calls.
    streams: u64,
    prepare: fn(&mut Context),
    /// What is done before pixels of the window are read.
    finish: fn(&mut Context),
    /// How many strips of the window show what is set, one after the other, time and again.
    strips: u32,
}

impl Mix {
    /// A kind of which nothing else is known.
    fn of(command: fn(&mut Context, &mut Numbers, &mut Vec<u64>)) -> Self {
        Self {
            command,
            one_in: 2,
            commands: 1500,
            streams: 100,
            prepare: |_| {},
            finish: |_| {},
            strips: 0,
        }
    }
}

/// What a stream leaves.
#[derive(PartialEq)]
struct Outcome {
    pixels: Vec<[u8; 4]>,
    /// Errors, counts, what was read.
    answers: Vec<u64>,
    /// What queries have counted at last.
    counts: Vec<u64>,
    /// Of selection or feedback.
    words: String,
}

fn outcome(seed: u64, mix: &Mix, level: SimdLevel) -> Outcome {
    let mut numbers = Numbers(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let mut context = Context::new(Configuration { accum_bits: 16, ..Configuration::default() });
    context.set_simd_level(level).unwrap();
    context.resize_default(150, 70);
    (mix.prepare)(&mut context);
    let mut answers = Vec::new();
    for number in 0..mix.commands {
        if numbers.below(mix.one_in) == 0 {
            (mix.command)(&mut context, &mut numbers, &mut answers);
        } else {
            primitives::command(&mut context, &mut numbers);
        }
        answers.push(context.get_error().into());
        if mix.strips > 0 && number % 100 == 99 {
            cover(&mut context, number / 100 % mix.strips);
        }
    }
    context.end_list();
    context.end();
    context.end_query(images::SAMPLES_PASSED);
    let counts = (1..4).filter_map(|name| context.get_query_object(name, 0x8866)).collect();
    let words = match context.render_mode(gl::RENDER).words {
        Words::Feedback(values) => {
            format!("{:?}", values.iter().map(|v| v.to_bits()).collect::<Vec<_>>())
        }
        other => format!("{other:?}"),
    };
    (mix.finish)(&mut context);
    Outcome { pixels: pixels(&mut context), answers, counts, words }
}

/// Draws a strip of the window with whatever textures are set, so that something is seen of them.
fn cover(context: &mut Context, strip: u32) {
    context.end_list();
    context.end();
    context.render_mode(0x1C00);
    for matrix in [0x1701, 0x1700] {
        context.matrix_mode(matrix);
        context.load_identity();
    }
    // Clip planes, scissor, stencil, depth, alpha, culling, stipple, logical operation, fog.
    for capability in [0x0C11, 0x0B90, 0x0B71, 0x0BC0, 0x0B44, 0x0B42, 0x0BF2, 0x0B60] {
        context.disable(capability);
    }
    for plane in 0..8 {
        context.disable(0x3000 + plane);
    }
    context.viewport(strip as i32 * 10, 0, 10, 70);
    context.color_mask(true, true, true, true);
    context.polygon_mode(0x0408, 0x1B02);
    context.begin(7);
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.5, 1.5], [-1.5, 1.5]] {
        for unit in 0..3 {
            context.tex_coord(0x84C0 + unit, [x, y * 2.0, x + y, 1.0]);
        }
        context.color([0.9, 0.5 + x / 4.0, 0.5 + y / 4.0, 0.8]);
        context.vertex([x, y, 0.0, if y > 1.0 { 1.5 } else { 1.0 }]);
    }
    context.end();
    context.get_error();
}

/// Compares the outcomes of all streams of a kind; how many of them `is_telling` holds of, and how many there are.
fn compare(mix: &Mix, is_telling: impl Fn(&Outcome) -> bool) -> (u64, u64) {
    let threads = |count| rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
    let (single, several) = (threads(1), threads(3));
    let calls = std::env::var("LUXEL_RANDOM_CALLS").ok();
    let streams = calls
        .map_or(mix.streams, |calls| calls.parse::<u64>().unwrap().div_ceil(mix.commands.into()));
    let mut telling = 0;
    for seed in 1..=streams {
        let expected = single.install(|| outcome(seed, mix, SimdLevel::Auto));
        telling += u64::from(is_telling(&expected));
        let threaded = several.install(|| outcome(seed, mix, SimdLevel::Auto));
        assert!(threaded == expected, "seed {seed} with three threads");
        if seed % 25 == 1 {
            for level in SimdLevel::available() {
                assert!(outcome(seed, mix, level) == expected, "seed {seed}, {level:?}");
            }
        }
    }
    (telling, streams)
}

fn has_drawn(outcome: &Outcome) -> bool {
    outcome.pixels.iter().any(|pixel| *pixel != [0; 4])
}

fn colors(outcome: &Outcome) -> usize {
    outcome.pixels.iter().collect::<BTreeSet<_>>().len()
}

#[test]
fn any_primitives_are_the_same_at_every_level_and_for_any_number_of_threads() {
    let of = Mix::of(|context, numbers, _| primitives::command(context, numbers));
    let (drawn, streams) = compare(&Mix { one_in: 1, streams: 300, ..of }, has_drawn);
    assert!(2 * drawn > streams, "only {drawn} of {streams} streams have drawn something");
}

#[test]
fn any_images_and_counts_are_the_same_at_every_level_and_for_any_number_of_threads() {
    let mix = Mix { one_in: 4, commands: 800, streams: 120, ..Mix::of(images::command) };
    let counted = |outcome: &Outcome| outcome.counts.iter().any(|count| *count > 0);
    let (telling, streams) = compare(&mix, |outcome| has_drawn(outcome) && counted(outcome));
    assert!(6 * telling > streams, "only {telling} of {streams} streams have drawn and counted");
}

#[test]
fn any_textures_are_the_same_at_every_level_and_for_any_number_of_threads() {
    let of = Mix::of(textures::command);
    let mix = Mix { one_in: 3, streams: 150, prepare: textures::prepare, strips: 15, ..of };
    let (colorful, streams) = compare(&mix, |outcome| colors(outcome) > 200);
    assert!(5 * colorful > streams, "only {colorful} of {streams} streams have drawn many colours");
}

#[test]
fn any_framebuffers_are_the_same_at_every_level_and_for_any_number_of_threads() {
    let (prepare, finish) = (framebuffers::prepare, framebuffers::finish);
    let mix = Mix { prepare, finish, strips: 5, ..Mix::of(framebuffers::command) };
    let (colorful, streams) = compare(&mix, |outcome| colors(outcome) > 2);
    assert!(5 * colorful > streams, "only {colorful} of {streams} streams have drawn colours");
}

#[test]
fn any_arrays_and_maps_are_the_same_at_every_level_and_for_any_number_of_threads() {
    let mix = Mix { commands: 1000, prepare: arrays::prepare, ..Mix::of(arrays::command) };
    let (drawn, streams) = compare(&mix, has_drawn);
    assert!(2 * drawn > streams, "only {drawn} of {streams} streams have drawn something");
}
