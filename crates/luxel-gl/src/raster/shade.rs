//! Colours of the fragments of a block (OpenGL 1.5, sections 3.5.1, 3.9 and 3.10): interpolated with perspective,
//! fogged, within 0 and 1.

use super::batch::{Prepared, Row};
use crate::fragment::{Footprint, TextureStages};
use luxel_lighting::{Fog, Silent};
use luxel_math::{F64x16, LANES, Lanes, Rgb, Simd, f32x16, i32x16, prelude::*, u32x16};
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

/// What fragments of one draw go through after interpolation.
#[derive(Clone, Copy)]
pub(super) struct Shading<'p> {
    pub(super) textures: Option<&'p TextureStages>,
    /// Of all primitives.
    pub(super) rows: &'p [Row],
    pub(super) fog: Option<&'p Fog>,
    /// The lanes that matter, a bit each.
    pub(super) lanes: u32,
}

/// Colours at the centres of a block's pixels, whose first is at `origin` in the window. `of(lane)` is the lane's
/// primitive; `alike` tells that all have the first one's.
#[inline(always)]
pub(super) fn shade<'p, S: Simd>(
    simd: S,
    origin: [i32; 2],
    of: impl Fn(usize) -> &'p Prepared,
    alike: bool,
    shading: Shading<'_>,
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
    let Shading { textures, fog, .. } = shading;
    let [_, v, t] = forms.clamped_barycentrics(x, y);
    // So written, what is the same at all corners stays what it is.
    let mixed = |a: f32x16<S>, b: f32x16<S>, c: f32x16<S>| a + v * (b - a) + t * (c - a);
    let mut colors = [0, 1, 2, 3].map(|channel| {
        let of_corners = [first[channel], first[4 + channel], second[channel]];
        let [a, b, c] = of_corners;
        mixed(a, b, c).clamped(0.0, 1.0)
    });
    if let Some(textures) = textures {
        let lookup = TextureLookup { of: &of, alike, forms: &forms, position: [x, y], at: [v, t] };
        colors = textured(colors, &lookup, textures, shading.rows, shading.lanes);
    }
    if let Some(fog) = fog {
        let distance = mixed(second[4], second[5], second[6]);
        let [r, g, b, a] = colors;
        let Rgb { r, g, b } = fog.veiled(Rgb::new(r, g, b), distance.positive_part(), &mut Silent);
        colors = [r, g, b, a].map(|value| value.clamped(0.0, 1.0));
    }
    colors
}

/// Where the fragments of a block lie on their primitives.
struct TextureLookup<'l, S: Simd, F> {
    of: &'l F,
    alike: bool,
    forms: &'l LinearForms<F64x16<S>>,
    position: [F64x16<S>; 2],
    /// The second and third barycentrics.
    at: [f32x16<S>; 2],
}

/// Colours after all texture units, the secondary ones added (sections 3.8 and 3.9). Coordinates a pixel to the right
/// and a pixel above come from the primitive's own weights, so that levels of detail are the same in any block.
#[inline(never)]
fn textured<'p, S: Simd, F: Fn(usize) -> &'p Prepared>(
    colors: Colors<S>,
    lookup: &TextureLookup<'_, S, F>,
    textures: &TextureStages,
    rows: &[Row],
    lanes: u32,
) -> Colors<S> {
    let simd = colors[0];
    simd.vectorized(
        #[inline(always)]
        || {
            let TextureLookup { of, alike, forms, position: [x, y], at } = *lookup;
            let corners = |number: usize| -> [[f32x16<S>; 4]; 3] {
                let row = |lane: usize| &rows[of(lane).rows as usize + number];
                let [first, second] = if alike {
                    row(0).map(|half| half.map(|value| simd.constant(value)))
                } else {
                    [0, 1].map(|half| {
                        simd.load_transposed(
                            #[inline(always)]
                            |lane| &row(lane)[half],
                        )
                    })
                };
                [
                    [first[0], first[1], first[2], first[3]],
                    [first[4], first[5], first[6], first[7]],
                    [second[0], second[1], second[2], second[3]],
                ]
            };
            let weighted = |[a, b, c]: &[[f32x16<S>; 4]; 3], [v, t]: [f32x16<S>; 2]| {
                [0, 1, 2, 3].map(|axis| a[axis] + v * (b[axis] - a[axis]) + t * (c[axis] - a[axis]))
            };
            let steps = forms.steps(x, y);
            let beside = steps.map(|[v, t]| [at[0] + v, at[1] + t]);
            let footprint = |stage: usize| {
                let corners = corners(1 + stage);
                Footprint {
                    centre: weighted(&corners, at),
                    right: weighted(&corners, beside[0]),
                    above: weighted(&corners, beside[1]),
                }
            };
            let colors = textures.apply(colors, footprint, lanes);
            if !textures.secondary {
                return colors;
            }
            let secondary = weighted(&corners(0), at);
            [0, 1, 2, 3].map(|channel| {
                let more = secondary[channel].clamped(0.0, 1.0);
                (colors[channel] + more).clamped(0.0, 1.0)
            })
        },
    )
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
