//! Tone curves beside their definitions in f64, and beside themselves at every SIMD level.

use luxel_lighting::{Display, Tone};
use luxel_math::prelude::*;
use luxel_math::{Rgb, SimdLevel, dispatch, f32x16};

type Color = [f64; 3];
type Definition = fn(Color) -> Color;

fn shown(display: &Display, color: [f32; 3]) -> [f32; 3] {
    let [r, g, b] = color;
    display.shown(Rgb::new(r, g, b)).lane(0)
}

fn product(matrix: [[f64; 3]; 3], color: Color) -> Color {
    matrix.map(|row| row.iter().zip(color).map(|(a, b)| a * b).sum())
}

/// The specification's text.
fn neutral(color: Color) -> Color {
    let (f90, k_d) = (0.04, 0.15);
    let k_s = 0.8 - f90;
    let x = color.into_iter().fold(f64::INFINITY, f64::min);
    let f = if x <= 2.0 * f90 { x - x * x / (4.0 * f90) } else { f90 };
    let p = color.into_iter().fold(0.0, f64::max) - f;
    if p <= k_s {
        return color.map(|channel| channel - f);
    }
    let p_n = 1.0 - (1.0 - k_s) * (1.0 - k_s) / (p + 1.0 - 2.0 * k_s);
    let g = 1.0 / (k_d * (p - p_n) + 1.0);
    color.map(|channel| (channel - f) * p_n / p * g + p_n * (1.0 - g))
}

fn aces(color: Color) -> Color {
    let input =
        [[0.59719, 0.35458, 0.04823], [0.076, 0.90834, 0.01566], [0.0284, 0.13383, 0.83777]];
    let output = [
        [1.60475, -0.53108, -0.07367],
        [-0.10208, 1.10813, -0.00605],
        [-0.00327, -0.07276, 1.07602],
    ];
    let fit = |v: f64| {
        (v * (v + 0.024_578_6) - 0.000_090_537) / (v * (0.983_729 * v + 0.432_951) + 0.238_081)
    };
    product(output, product(input, color).map(fit)).map(|channel| channel.clamp(0.0, 1.0))
}

fn agx(color: Color) -> Color {
    let inset = [
        [0.842_479_062_253_094, 0.078_433_599_999_999_2, 0.079_223_745_147_764_3],
        [0.042_328_242_261_012_3, 0.878_468_636_469_772, 0.079_166_127_460_543_4],
        [0.042_375_654_905_705_1, 0.078_433_6, 0.879_142_973_793_104],
    ];
    let outset = [
        [1.196_879_005_120_17, -0.098_020_881_140_136_8, -0.099_029_744_079_720_5],
        [-0.052_896_851_757_456_2, 1.151_903_129_904_17, -0.098_961_176_844_843_3],
        [-0.052_971_635_514_443_8, -0.098_043_450_117_124_1, 1.151_073_672_641_16],
    ];
    let (least, most) = (-12.473_93, 4.026_069);
    let contrast = |light: f64| {
        let x = (libm::log2(light).clamp(least, most) - least) / (most - least);
        let (x2, x4) = (x * x, x * x * x * x);
        let even = 15.5 * x4 * x2 + 31.96 * x4 + 0.4298 * x2 - 0.002_32;
        even + (-40.14 * x4 - 6.868 * x2 + 0.1191) * x
    };
    let curved = product(outset, product(inset, color).map(contrast));
    curved.map(|channel| libm::pow(channel.clamp(0.0, 1.0), 2.2))
}

/// Greys and colours from far below what a byte shows to far beyond white.
fn colors() -> Vec<[f32; 3]> {
    let hues = [
        [1.0, 1.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [0.9, 0.6, 0.1],
        [0.05, 0.4, 0.8],
        [1.0, 0.99, 0.98],
    ];
    let steps = (-80..=80_i16).map(|step| libm::exp2f(f32::from(step) * 0.25));
    let scaled = steps.flat_map(|by| hues.map(|hue| hue.map(|channel: f32| channel * by)));
    scaled.chain([[0.0; 3], [0.08; 3], [0.79, 0.8, 0.3]]).collect()
}

#[test]
fn curves_are_their_definitions() {
    let definitions: [(Tone, Definition); 3] =
        [(Tone::Neutral, neutral), (Tone::Aces, aces), (Tone::Agx, agx)];
    for (tone, definition) in definitions {
        let display = Display::new(0.0, tone);
        for color in colors() {
            let expected = definition(color.map(f64::from));
            for (got, expected) in shown(&display, color).into_iter().zip(expected) {
                // Half a step of 16 bits.
                let error = (f64::from(got) - expected).abs();
                assert!(error < 7.6e-6, "{tone:?} of {color:?}: {got}, {expected}");
                assert!((0.0..=1.0).contains(&got), "{tone:?} of {color:?}: {got}");
            }
        }
    }
}

#[test]
fn curves_have_their_published_values() {
    // Of the specification's formulas, worked by hand: f = 0.04, p = 0.96,
    // p_n = 1 - 0.24^2 / (0.96 - 0.52) = 0.8690909.
    let neutral = Display::new(0.0, Tone::Neutral);
    let near = |got: [f32; 3], expected: [f32; 3], within: f32| {
        let is_near = got.iter().zip(expected).all(|(a, b)| (a - b).abs() < within);
        assert!(is_near, "{got:?}, {expected:?}");
    };
    near(shown(&neutral, [1.0; 3]), [0.869_090_9; 3], 1e-6);
    // A base colour under white light: what the curve promises to keep, less the highlight of F90.
    near(shown(&neutral, [0.54, 0.34, 0.14]), [0.5, 0.3, 0.1], 1e-6);
    // 1.0244881 / 1.6547610, as rows of the matrices add up to 1.
    near(shown(&Display::new(0.0, Tone::Aces), [1.0; 3]), [0.619_12; 3], 2e-5);
    // Middle grey, 10 of the 16.5 stops up, is shown in the middle: 0.5 for a display of gamma 2.2.
    near(shown(&Display::new(0.0, Tone::Agx), [0.18; 3]), [0.217_638; 3], 0.004);
}

#[test]
fn brighter_greys_are_never_shown_darker() {
    for tone in Tone::ALL {
        let display = Display::new(0.0, tone);
        let mut last = 0.0;
        for step in -3000..=5000_i16 {
            let grey = libm::exp2f(f32::from(step) * 0.005);
            let [r, g, b] = shown(&display, [grey; 3]);
            assert!(r >= last - 1e-6, "{tone:?} at {grey}: {r} after {last}");
            // The rows of the fits' matrices don't quite add up to 1.
            assert!((r - g).abs() < 1e-3 && (r - b).abs() < 1e-3, "{tone:?} tints {grey}");
            last = r;
        }
        assert!(last > 0.96, "{tone:?} ends at {last}");
    }
}

#[test]
fn any_light_has_a_finite_colour() {
    let values =
        [f32::NAN, f32::NEG_INFINITY, -f32::MAX, -1.0, -0.0, 1e-45, f32::MAX, f32::INFINITY];
    for tone in Tone::ALL {
        for ev in [-1e9, -3.0, 0.0, 70.0, f32::NAN, f32::INFINITY] {
            let display = Display::new(ev, tone);
            assert!(display.factor() > 0.0 && display.factor().is_finite());
            for value in values {
                for color in [[value; 3], [value, 0.2, 1e20], [0.0, value, 0.0]] {
                    let shown = shown(&display, color);
                    assert!(shown.iter().all(|channel| channel.is_finite()), "{tone:?} {color:?}");
                }
            }
        }
    }
}

#[test]
fn a_stop_doubles_the_light() {
    for (ev, factor) in [(0.0, 1.0), (1.0, 2.0), (-3.0, 0.125), (0.5, std::f32::consts::SQRT_2)] {
        let display = Display::new(ev, Tone::None);
        assert_eq!((display.ev(), display.factor()), (ev, factor));
        assert_eq!(shown(&display, [0.25, 0.5, 3.0]), [0.25, 0.5, 3.0].map(|light| light * factor));
    }
}

#[test]
fn names_are_distinct() {
    let names = Tone::ALL.map(Tone::name);
    assert_eq!(names, ["none", "neutral", "aces", "agx"]);
    assert!(Tone::ALL.iter().all(|tone| !tone.help().is_empty()));
}

#[inline(always)]
fn in_lanes<S: Simd>(simd: S, display: &Display, colors: &[[f32; 3]; 16]) -> [[f32; 3]; 16] {
    let simd = f32x16::splat(simd, 0.0);
    let channel = |at: usize| simd.each_lane(|lane| colors[lane][at]);
    let shown = display.shown(Rgb::new(channel(0), channel(1), channel(2)));
    std::array::from_fn(|lane| shown.lane(lane))
}

#[test]
fn every_simd_level_gives_the_bits_of_one_value() {
    let colors = colors();
    for level in SimdLevel::available() {
        let level = level.resolve().unwrap();
        for display in Tone::ALL.map(|tone| Display::new(-0.7, tone)) {
            for sixteen in colors.as_chunks::<16>().0 {
                let lanes = dispatch!(level, simd => in_lanes(simd, &display, sixteen));
                for (lane, &color) in lanes.into_iter().zip(sixteen) {
                    let one = shown(&display, color);
                    assert_eq!(
                        lane.map(f32::to_bits),
                        one.map(f32::to_bits),
                        "{level:?} {color:?}"
                    );
                }
            }
        }
    }
}
