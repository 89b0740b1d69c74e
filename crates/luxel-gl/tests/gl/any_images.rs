//! Streams of commands with images, transfers, sums and queries among them: nothing panics, and neither threads nor SIMD
//! levels change a byte or a count.

use crate::any_commands::{Numbers, command};
use crate::canvas::pixels;
use luxel_gl::{Configuration, Context, SimdLevel};

const FORMATS: &[u32] =
    &[0x1908, 0x1907, 0x80E1, 0x1903, 0x1906, 0x1909, 0x190A, 0x1902, 0x1901, 0x84F9];
const TYPES: &[u32] = &[0x1401, 0x1400, 0x1403, 0x1402, 0x1405, 0x1406, 0x8035, 0x8363, 0x84FA];
const SAMPLES_PASSED: u32 = 0x8914;

fn image_command(context: &mut Context, n: &mut Numbers, bytes: &[u8]) {
    match n.below(12) {
        0..=2 => {
            let size = [n.below(20) as i32 - 1, n.below(20) as i32];
            context.draw_pixels(size, n.of(FORMATS), n.of(TYPES), bytes);
        }
        3..=4 => {
            let from = [n.below(200) as i32 - 30, n.below(90) as i32 - 10];
            let size = [n.below(60) as i32 - 1, n.below(60) as i32];
            context.copy_pixels(from, size, n.of(&[0x1800, 0x1801, 0x1802, 0x84F9]));
        }
        5 => context.pixel_zoom(n.place() * 3.0, n.place() * 3.0),
        6..=7 => {
            let place = [n.below(150) as f32, n.below(70) as f32, n.unit()];
            context.window_pos(place);
        }
        8 => {
            let values = n.color();
            context.pixel_map(0x0C70 + n.below(11), n.below(6) as i32, &values);
        }
        9 => context.pixel_transfer(0x0D10 + n.below(17), n.place()),
        10 => context.accum(0x0100 + n.below(6), n.place()),
        _ => match n.below(3) {
            0 => context.begin_query(n.of(&[SAMPLES_PASSED]), n.below(4)),
            1 => context.end_query(SAMPLES_PASSED),
            _ => context.delete_queries(&[n.below(4)]),
        },
    }
}

/// What a stream leaves: all pixels, what queries have counted, errors.
fn outcome(seed: u64, level: SimdLevel) -> (Vec<[u8; 4]>, Vec<Option<u64>>, Vec<u32>) {
    let mut numbers = Numbers(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
    let mut context = Context::new(Configuration { accum_bits: 16, ..Configuration::default() });
    context.set_simd_level(level).unwrap();
    context.resize_default(150, 70);
    let bytes: Vec<u8> = (0..20 * 20 * 16).map(|_| numbers.next() as u8).collect();
    let mut errors = Vec::new();
    for _ in 0..800 {
        if numbers.below(4) == 0 {
            image_command(&mut context, &mut numbers, &bytes);
        } else {
            command(&mut context, &mut numbers);
        }
        errors.push(context.get_error());
    }
    context.end_list();
    context.end();
    context.end_query(SAMPLES_PASSED);
    let counts = (1..4).map(|name| context.get_query_object(name, 0x8866)).collect();
    context.render_mode(crate::canvas::gl::RENDER);
    (pixels(&mut context), counts, errors)
}

#[test]
fn any_images_give_the_same_bytes_and_counts_at_every_level_and_for_any_number_of_threads() {
    let several = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
    let single = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    let (mut drawn, mut counted) = (0, 0);
    for seed in 1..120 {
        let expected = single.install(|| outcome(seed, SimdLevel::Auto));
        drawn += usize::from(expected.0.iter().any(|pixel| *pixel != [0; 4]));
        counted += usize::from(expected.1.iter().flatten().any(|count| *count > 0));
        assert!(several.install(|| outcome(seed, SimdLevel::Auto)) == expected, "seed {seed}");
        if seed < 8 {
            for level in SimdLevel::available() {
                assert!(outcome(seed, level) == expected, "seed {seed}, {level:?}");
            }
        }
    }
    assert!(drawn > 60 && counted > 20, "{drawn} streams have drawn, {counted} have counted");
}
