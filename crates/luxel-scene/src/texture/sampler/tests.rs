use super::*;
use crate::Encoding;
use crate::texture::Image;
use luxel_math::{Simd, SimdLevel, dispatch, f32x16, prelude::*};
use proptest::prelude::*;
use std::sync::Arc;

/// Coordinates that files may have.
const ODD: [f32; 7] =
    [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, -1e-45, -1e-10];

const WRAPS: [Wrap; 3] = [Wrap::Repeat, Wrap::MirroredRepeat, Wrap::ClampToEdge];

fn texture(width: u32, height: u32, texels: Vec<[u8; 4]>, sampler: Sampler) -> Texture {
    Texture { image: Arc::new(Image::new("", Encoding::Linear, width, height, texels)), sampler }
}

fn noise(width: u32, height: u32) -> Vec<[u8; 4]> {
    let mut state = 12_345_u32;
    (0..width * height)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state.to_be_bytes()
        })
        .collect()
}

/// The colour that one alone gets: one copy of the sampler for all tests, each of which would have its own.
#[inline(never)]
fn sample(texture: &Texture, at: [f32; 2], by_x: [f32; 2], by_y: [f32; 2]) -> [f32; 4] {
    texture.sample(at, by_x, by_y, 1)
}

/// The wrap rules of OpenGL 4.6, table 8.20, on texel numbers.
fn wrapped(index: i64, size: i64, wrap: Wrap) -> i64 {
    let mirror = |a: i64| if a >= 0 { a } else { -(1 + a) };
    match wrap {
        Wrap::Repeat => index.rem_euclid(size),
        Wrap::MirroredRepeat => size - 1 - mirror(index.rem_euclid(2 * size) - size),
        Wrap::ClampToEdge => index.clamp(0, size - 1),
    }
}

/// One level by the formulas of OpenGL 4.6, section 8.14.3, in f64.
fn reference(texture: &Texture, level: usize, u: f64, v: f64, filter: Filter) -> [f64; 4] {
    let level = &texture.image.levels[level];
    let (width, height) = (i64::from(level.width), i64::from(level.height));
    let fetch = |x: i64, y: i64| {
        let x = wrapped(x, width, texture.sampler.wrap_u);
        let y = wrapped(y, height, texture.sampler.wrap_v);
        level.texels[(y * width + x) as usize].map(|byte| f64::from(byte) / 255.0)
    };
    let clamp = |s: f64, wrap| if wrap == Wrap::ClampToEdge { s.clamp(0.0, 1.0) } else { s };
    let u = clamp(u, texture.sampler.wrap_u) * width as f64;
    let v = clamp(v, texture.sampler.wrap_v) * height as f64;
    if filter == Filter::Nearest {
        return fetch(u.floor() as i64, v.floor() as i64);
    }
    let (x, y) = ((u - 0.5).floor(), (v - 0.5).floor());
    let (a, b) = (u - 0.5 - x, v - 0.5 - y);
    let (x, y) = (x as i64, y as i64);
    let corners = [fetch(x, y), fetch(x + 1, y), fetch(x, y + 1), fetch(x + 1, y + 1)];
    std::array::from_fn(|channel| {
        (1.0 - a) * (1.0 - b) * corners[0][channel]
            + a * (1.0 - b) * corners[1][channel]
            + (1.0 - a) * b * corners[2][channel]
            + a * b * corners[3][channel]
    })
}

fn assert_near(value: [f32; 4], expected: [f64; 4], tolerance: f64) {
    for channel in 0..4 {
        let difference = (f64::from(value[channel]) - expected[channel]).abs();
        assert!(difference <= tolerance, "{value:?} instead of {expected:?}");
    }
}

/// All channels of level 0.
fn base(texture: &Texture, u: f32, v: f32) -> [f32; 4] {
    texture.sample_base::<f32, 0, 4>(u, v, 1)
}

#[test]
fn a_constant_image_is_constant_everywhere_and_at_every_level() {
    let color = [17, 130, 255, 77];
    for (width, height) in [(1, 1), (8, 8), (7, 5), (1, 300), (33, 2)] {
        for encoding in [Encoding::Linear, Encoding::Srgb] {
            let texels = vec![color; width as usize * height as usize];
            let image = Arc::new(Image::new("", encoding, width, height, texels));
            assert!(image.levels.iter().all(|level| level.texels.iter().all(|&t| t == color)));
            let texture = Texture { image, sampler: Sampler::trilinear() };
            let expected = [
                encoding.linear(color[0]),
                encoding.linear(color[1]),
                encoding.linear(color[2]),
                77.0 / 255.0,
            ];
            for step in 0..200 {
                let at = step as f32 * 0.37 - 20.0;
                let per_pixel = 0.001 * 1.1_f32.sqrt() * step as f32;
                let value = sample(&texture, [at, -at], [per_pixel, 0.0], [0.0, per_pixel * 0.2]);
                assert_near(value, expected.map(f64::from), 1e-6);
            }
        }
    }
}

#[test]
fn the_last_level_of_a_checker_is_its_mean_in_linear_light() {
    let texels = |light: [u8; 4], dark: [u8; 4]| {
        (0..64).map(|at| if (at + at / 8) % 2 == 0 { light } else { dark }).collect::<Vec<_>>()
    };
    let of = |encoding| {
        let image = Image::new("", encoding, 8, 8, texels([255; 4], [0, 0, 0, 255]));
        (image.levels.len(), image.levels[3].texels[0])
    };
    assert_eq!(of(Encoding::Linear), (4, [128, 128, 128, 255]));
    // Half the light is byte 188 (187.5 by the curve), not 128.
    assert_eq!(of(Encoding::Srgb), (4, [188, 188, 188, 255]));
}

#[test]
fn transparent_texels_do_not_bleed_into_colours() {
    let texels = vec![[200, 100, 50, 255], [0, 255, 0, 0], [0, 255, 0, 0], [0, 255, 0, 0]];
    let image = Image::new("", Encoding::Srgb, 2, 2, texels.clone());
    assert_eq!(image.levels[1].texels, [[200, 100, 50, 64]]);
    let data = Image::new("", Encoding::Linear, 2, 2, texels);
    assert_eq!(data.levels[1].texels, [[50, 216, 13, 64]]);
}

#[test]
fn odd_sides_keep_the_mean_at_every_level() {
    for (width, height) in [(7, 1), (5, 3), (1, 9), (63, 17), (64, 48), (100, 3)] {
        let texels = noise(width, height);
        let mean = |texels: &[[u8; 4]], channel: usize| {
            texels.iter().map(|texel| f64::from(texel[channel])).sum::<f64>() / texels.len() as f64
        };
        let image = Image::new("", Encoding::Linear, width, height, texels.clone());
        for level in &image.levels {
            assert_eq!(level.texels.len(), level.width as usize * level.height as usize);
            for channel in 0..4 {
                let drift = mean(&level.texels, channel) - mean(&texels, channel);
                assert!(drift.abs() < 2.0, "{width}x{height}: {drift} at {}", level.width);
            }
        }
        let last = &image.levels[image.levels.len() - 1];
        assert_eq!((last.width, last.height), (1, 1));
    }
}

#[test]
fn three_taps_weigh_by_what_they_cover() {
    let gray = |bytes: &[u8]| bytes.iter().map(|&b| [b, b, b, 255]).collect::<Vec<_>>();
    // Five become two, each of which covers two and a half: weights 2 2 1 and 1 2 2.
    let image = Image::new("", Encoding::Linear, 5, 1, gray(&[0, 50, 100, 150, 200]));
    assert_eq!(image.levels[1].texels, gray(&[40, 160]));
    assert_eq!(image.levels[2].texels, gray(&[100]));
}

#[test]
fn damaged_sizes_become_what_is_there() {
    let two_rows = Image::new("", Encoding::Linear, 3, 9, noise(4, 2));
    assert_eq!((two_rows.levels[0].width, two_rows.levels[0].height), (3, 2));
    for (width, height, count) in [(0, 5, 4), (5, 0, 4), (5, 5, 4), (0, 0, 0), (u32::MAX, 1, 3)] {
        let image = Image::new("gone", Encoding::Linear, width, height, vec![[0; 4]; count]);
        assert_eq!(image, Image::stand_in("gone"));
    }
}

#[test]
fn any_number_as_a_coordinate_gives_a_colour() {
    for wrap in WRAPS {
        for filter in [Filter::Nearest, Filter::Linear] {
            let sampler = Sampler {
                wrap_u: wrap,
                wrap_v: wrap,
                magnify: filter,
                minify: filter,
                mipmap: Some(filter),
            };
            let texture = texture(7, 3, noise(7, 3), sampler);
            for u in ODD {
                for d in ODD {
                    for value in [
                        base(&texture, u, d),
                        sample(&texture, [u, d], [d, u], [0.0, 0.1]),
                        sample(&texture, [0.3, u], [0.1, 0.0], [d, d]),
                    ] {
                        assert!(value.iter().all(|channel| (0.0..=1.0).contains(channel)));
                    }
                }
            }
        }
    }
}

#[test]
fn seams_of_repeating_pictures_are_smooth() {
    let texture = texture(4, 4, noise(4, 4), Sampler::trilinear());
    for step in 0..50 {
        let v = step as f32 / 50.0;
        let value = base(&texture, 1.0 - 1e-6, v).map(f64::from);
        assert_near(base(&texture, 0.0, v), value, 1e-4);
        assert_near(base(&texture, 1.0, v), value, 1e-4);
        assert_near(base(&texture, -1e-9, v), value, 1e-4);
    }
}

#[test]
fn between_levels_lies_their_mean() {
    let texture = texture(64, 64, noise(64, 64), Sampler::trilinear());
    for (level, fraction) in [(0, 0.25), (1, 0.0), (2, 0.5), (5, 0.75)] {
        let per_pixel = libm::exp2(level as f64 + fraction) / 64.0;
        let d = per_pixel as f32;
        let value = sample(&texture, [0.3, 0.7], [d, 0.0], [0.0, d]);
        let [a, b] =
            [level, level + 1].map(|level| reference(&texture, level, 0.3, 0.7, Filter::Linear));
        let expected = std::array::from_fn(|at| a[at] + (b[at] - a[at]) * fraction);
        assert_near(value, expected, 1e-4);
    }
}

#[test]
fn the_nearest_level_is_chosen_as_in_opengl() {
    let sampler =
        Sampler { minify: Filter::Nearest, mipmap: Some(Filter::Nearest), ..Sampler::trilinear() };
    let texture = texture(64, 64, noise(64, 64), sampler);
    // Up to half a level the picture is still magnified, smoothly.
    for (level_of_detail, level, filter) in [
        (-1.0, 0, Filter::Linear),
        (0.4, 0, Filter::Linear),
        (0.6, 1, Filter::Nearest),
        (1.4, 1, Filter::Nearest),
        (1.6, 2, Filter::Nearest),
        (9.0, 6, Filter::Nearest),
    ] {
        let d = (libm::exp2(level_of_detail) / 64.0) as f32;
        let value = sample(&texture, [0.3, 0.7], [d, 0.0], [0.0, d]);
        assert_near(value, reference(&texture, level, 0.3, 0.7, filter), 1e-5);
    }
}

#[test]
fn long_footprints_keep_detail_across() {
    // Stripes that run along u: a footprint long in u loses nothing, a square one loses all.
    let texels = (0..64 * 64).map(|at| [if (at / 64) % 2 == 0 { 255 } else { 0 }; 4]).collect();
    let texture = texture(64, 64, texels, Sampler::trilinear());
    let v = 0.5 / 64.0;
    let along = sample(&texture, [0.4, v], [8.0 / 64.0, 0.0], [0.0, 1.0 / 64.0]);
    assert_near(along, [1.0; 4], 1e-5);
    let square = sample(&texture, [0.4, v], [8.0 / 64.0, 0.0], [0.0, 8.0 / 64.0]);
    assert_near(square, [128.0 / 255.0; 4], 1e-5);
    let across = sample(&texture, [0.4, v], [0.0, 8.0 / 64.0], [1.0 / 64.0, 0.0]);
    assert_near(across, [0.5; 4], 0.1);
}

/// Samples the first lanes, as many as are seen, and one after the other.
#[inline(always)]
fn sixteen<S: Simd>(simd: S, texture: &Texture, rows: &[[f32; LANES]; 6], lanes: u32) {
    let [u, v, u_by_x, v_by_x, u_by_y, v_by_y] = rows.map(|row| f32x16::simd_from(simd, row));
    let together: [f32x16<S>; 4] =
        texture.sample([u, v], [u_by_x, v_by_x], [u_by_y, v_by_y], lanes);
    let colors: [f32x16<S>; 3] = texture.sample([u, v], [u_by_x, v_by_x], [u_by_y, v_by_y], lanes);
    for lane in (0..LANES).filter(|lane| lanes >> lane & 1 == 1) {
        let [u, v, u_by_x, v_by_x, u_by_y, v_by_y] = rows.map(|row| row[lane]);
        let alone = sample(texture, [u, v], [u_by_x, v_by_x], [u_by_y, v_by_y]);
        let bits = |color: [f32; 4]| color.map(f32::to_bits);
        assert_eq!(bits(together.map(|channel| channel[lane])), bits(alone), "{u} {v}");
        let [r, g, b] = colors.map(|channel| channel[lane]);
        assert_eq!(bits([r, g, b, alone[3]]), bits(alone), "{u} {v}");
    }
}

#[test]
fn lanes_get_the_bits_that_one_alone_gets_at_every_level() {
    let mut state = 7_u32;
    let mut number = |scale: f32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        scale * ((state >> 8) as f32 / 8_388_608.0 - 1.0)
    };
    for round in 0..400 {
        let [wrap_u, wrap_v] = [WRAPS[round % 3], WRAPS[round / 3 % 3]];
        let [magnify, minify, between] = [0, 1, 2]
            .map(|bit| if round >> bit & 1 == 0 { Filter::Linear } else { Filter::Nearest });
        let mipmap = (round % 5 != 0).then_some(between);
        let sampler = Sampler { wrap_u, wrap_v, magnify, minify, mipmap };
        let mut texture = texture(37, 20, noise(37, 20), sampler);
        if round % 2 == 0 {
            let image = Image::new("", Encoding::Srgb, 37, 20, noise(37, 20));
            texture.image = Arc::new(image);
        }
        // From much less than a texel to all of them, square or long.
        let widest = [0.001, 0.05, 0.3, 3.0][round / 7 % 4];
        let scales = [2.0, 2.0, widest, widest, 0.2 * widest, 0.2 * widest];
        let mut rows = scales.map(|scale| [(); LANES].map(|()| number(scale)));
        if round % 7 == 0 {
            let turn = round / 7 % ODD.len();
            rows[0][..ODD.len()].copy_from_slice(&ODD);
            rows[1][turn..turn + ODD.len()].copy_from_slice(&ODD);
        }
        let lanes = if round % 3 == 0 { 0xffff } else { number(32_000.0) as i32 as u32 & 0xffff };
        for level in SimdLevel::available() {
            dispatch!(level.resolve().unwrap(), simd => sixteen(simd, &texture, &rows, lanes));
        }
    }
}

proptest! {
    #[test]
    fn one_level_follows_the_formulas(
        u in -3.0_f32..3.0,
        v in -3.0_f32..3.0,
        width in 1_u32..9,
        height in 1_u32..9,
        wrap_u in prop::sample::select(&WRAPS[..]),
        wrap_v in prop::sample::select(&WRAPS[..]),
        linear in any::<bool>(),
    ) {
        let filter = if linear { Filter::Linear } else { Filter::Nearest };
        let sampler = Sampler { wrap_u, wrap_v, magnify: filter, minify: filter, mipmap: None };
        let texture = texture(width, height, noise(width, height), sampler);
        // Next to an edge between texels rounding decides which of them is the nearest.
        let edge = |coordinate: f32, size: u32| {
            let place = f64::from(coordinate) * f64::from(size);
            (place - place.round()).abs() < 1e-5
        };
        prop_assume!(linear || !edge(u, width) && !edge(v, height));
        let expected = reference(&texture, 0, f64::from(u), f64::from(v), filter);
        assert_near(base(&texture, u, v), expected, 1e-5);
        assert_near(sample(&texture, [u, v], [9.0, 0.0], [0.0, 9.0]), expected, 1e-5);
    }
}
