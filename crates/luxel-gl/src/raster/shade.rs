//! Colours of the fragments of a block (OpenGL 1.5, sections 3.5.1, 3.9 and 3.10): interpolated with perspective,
//! fogged, within 0 and 1.

use super::batch::Prepared;
use luxel_lighting::{Fog, Silent};
use luxel_math::{LANES, Lanes, Rgb, Simd, f32x16, i32x16, prelude::*, u32x16};
use luxel_visibility::{BLOCK, LinearForms};

/// Columns and rows of a block's lanes, at the centres of pixels.
const CENTRE_X: [f32; LANES] = centres(true);
const CENTRE_Y: [f32; LANES] = centres(false);

const fn centres(across: bool) -> [f32; LANES] {
    let mut places = [0.5; LANES];
    let mut lane = 0;
    while lane < LANES {
        let at = if across { lane % BLOCK as usize } else { lane / BLOCK as usize };
        places[lane] += at as f32;
        lane += 1;
    }
    places
}

/// Red, green, blue, alpha in sixteen lanes.
pub(super) type Colors<S> = [f32x16<S>; 4];

/// Colours at the centres of a block's pixels, whose first is at `origin` in the window. `of(lane)` is the lane's
/// primitive; `alike` tells that all have the first one's.
#[inline(always)]
pub(super) fn shade<'p, S: Simd>(
    simd: S,
    origin: [i32; 2],
    of: impl Fn(usize) -> &'p Prepared,
    alike: bool,
    fog: Option<&Fog>,
) -> Colors<S> {
    let lanes = f32x16::splat(simd, 0.0);
    let x = (f32x16::simd_from(simd, CENTRE_X) + origin[0] as f32).to_f64();
    let y = (f32x16::simd_from(simd, CENTRE_Y) + origin[1] as f32).to_f64();
    let (forms, [first, second]) = if alike {
        let prepared = of(0);
        let constant = |row: &[f32; 8]| row.map(|value| lanes.constant(value));
        (
            LinearForms::everywhere(x, &prepared.forms),
            [constant(&prepared.attributes[0]), constant(&prepared.attributes[1])],
        )
    } else {
        (
            LinearForms::unpacked(
                x,
                #[inline(always)]
                |lane| &of(lane).forms,
            ),
            [
                lanes.load_transposed(
                    #[inline(always)]
                    |lane| &of(lane).attributes[0],
                ),
                lanes.load_transposed(
                    #[inline(always)]
                    |lane| &of(lane).attributes[1],
                ),
            ],
        )
    };
    let [_, v, t] = forms.clamped_barycentrics(x, y);
    // So written, what is the same at all corners stays what it is.
    let mixed = |a: f32x16<S>, b: f32x16<S>, c: f32x16<S>| a + v * (b - a) + t * (c - a);
    let mut colors = [0, 1, 2, 3].map(|channel| {
        let of_corners = [first[channel], first[4 + channel], second[channel]];
        let [a, b, c] = of_corners;
        mixed(a, b, c).clamped(0.0, 1.0)
    });
    if let Some(fog) = fog {
        let distance = mixed(second[4], second[5], second[6]);
        let [r, g, b, a] = colors;
        let Rgb { r, g, b } = fog.veiled(Rgb::new(r, g, b), distance.positive_part(), &mut Silent);
        colors = [r, g, b, a].map(|value| value.clamped(0.0, 1.0));
    }
    colors
}

/// Colours as bytes, red lowest: x 255 + 1/2, rounded down.
#[inline(always)]
pub(super) fn encode<S: Simd>(colors: Colors<S>) -> u32x16<S> {
    let [r, g, b, a] = colors.map(
        #[inline(always)]
        |value| i32x16::truncate_from(value * 255.0 + 0.5),
    );
    (r | (g << 8) | (b << 16) | (a << 24)).bitcast()
}

/// Bytes as colours from 0 to 1.
#[inline(always)]
pub(super) fn decode<S: Simd>(words: u32x16<S>) -> Colors<S> {
    let channel = |shift: u32| {
        let byte: i32x16<S> = ((words >> shift) & 0xff).bitcast();
        f32x16::float_from(byte) * (1.0 / 255.0)
    };
    [channel(0), channel(8), channel(16), channel(24)]
}
