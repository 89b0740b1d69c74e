//! Colours of the fragments of a block (OpenGL 1.5, sections 3.5.1, 3.9 and 3.10): interpolated with perspective,
//! fogged, within 0 and 1.

use super::batch::Prepared;
use crate::fragment::{Footprint, TextureStages};
use luxel_lighting::{Fog, Silent};
use luxel_math::{
    F64x16, LANES, Lanes, Rgb, Simd, columns, f32x4, f32x16, i32x16, prelude::*, u32x16,
};
use luxel_visibility::{BLOCK, LinearForms, PackedForms, ProjectiveForms};
use std::ops::{Add, Mul, Sub};

/// Columns and rows of a block's lanes, at the centres of pixels.
const CENTRE_X: [f32; LANES] = lane_centres(true);
const CENTRE_Y: [f32; LANES] = lane_centres(false);

const fn lane_centres(across: bool) -> [f32; LANES] {
    let mut places = [0.5; LANES];
    let mut lane = 0;
    while lane < LANES {
        let at = if across { lane % BLOCK as usize } else { lane / BLOCK as usize };
        places[lane] += at as f32;
        lane += 1;
    }
    places
}

/// The centres of a block's pixels in the window.
#[inline(always)]
fn centres<S: Simd>(simd: S, origin: [i32; 2]) -> [F64x16<S>; 2] {
    let x = f32x16::simd_from(simd, CENTRE_X) + origin[0] as f32;
    let y = f32x16::simd_from(simd, CENTRE_Y) + origin[1] as f32;
    [x.to_f64(), y.to_f64()]
}

/// Red, green, blue, alpha in sixteen lanes.
pub(super) type Colors<S> = [f32x16<S>; 4];

/// What fragments of one draw go through after interpolation.
#[derive(Clone, Copy)]
pub(super) struct Shading<'p> {
    pub(super) textures: Option<&'p TextureStages>,
    /// Of all primitives.
    pub(super) rows: &'p [PackedForms],
    pub(super) fog: Option<&'p Fog>,
    /// Colours of an image's fragments, in the place of interpolated ones.
    pub(super) primary: Option<&'p [[f32; LANES]; 4]>,
    /// The lanes that matter, a bit each.
    pub(super) lanes: u32,
}

/// Colours at the centres of a block's pixels, whose first is at `origin` in the window. `of(lane)` is the lane's
/// primitive; with `alike`, all have the first one's.
#[inline(always)]
pub(super) fn shade<'p, S: Simd>(
    simd: S,
    origin: [i32; 2],
    of: impl Fn(usize) -> &'p Prepared,
    alike: bool,
    shading: Shading<'_>,
) -> Colors<S> {
    let Shading { textures, fog, .. } = shading;
    let is_even = of(0).is_even && (alike || (1..LANES).all(|lane| of(lane).is_even));
    let (mut colors, distance) = if is_even {
        // What interpolation gives, to the bit.
        at_corner(simd, &of, alike, fog.is_some())
    } else {
        interpolated(simd, origin, &of, alike, fog.is_some())
    };
    for color in &mut colors {
        *color = color.clamped(0.0, 1.0);
    }
    if let Some(primary) = shading.primary {
        for (color, values) in colors.iter_mut().zip(primary) {
            *color = f32x16::from_slice(simd, values).clamped(0.0, 1.0);
        }
    }
    if let Some(textures) = textures {
        let rows = shading.rows;
        let lookup = TextureLookup { of: &of, alike, position: centres(simd, origin), rows };
        colors = textured(colors, &lookup, textures, shading.lanes);
    }
    if let Some(fog) = fog {
        let [r, g, b, a] = colors;
        let Rgb { r, g, b } = fog.veiled(Rgb::new(r, g, b), distance.positive_part(), &mut Silent);
        colors = [r, g, b, a];
        for color in &mut colors {
            *color = color.clamped(0.0, 1.0);
        }
    }
    colors
}

/// Red, green, blue, alpha and the fog coordinate, if there is one, at the first corner.
#[inline(always)]
fn at_corner<'p, S: Simd>(
    simd: S,
    of: &impl Fn(usize) -> &'p Prepared,
    alike: bool,
    has_fog: bool,
) -> (Colors<S>, f32x16<S>) {
    let lanes = f32x16::splat(simd, 0.0);
    if alike {
        let Prepared { colors: [color, ..], fog: [fog, ..], .. } = of(0);
        return (in_lanes(lanes, color), lanes.constant(*fog));
    }
    let colors = columns(
        simd,
        #[inline(always)]
        |lane| f32x4::simd_from(simd, of(lane).colors[0]),
    );
    (colors, if has_fog { lanes.each_lane(|lane| of(lane).fog[0]) } else { lanes })
}

/// Red, green, blue, alpha and the fog coordinate, if there is one, at the centres of a block's pixels.
#[inline(always)]
fn interpolated<'p, S: Simd>(
    simd: S,
    origin: [i32; 2],
    of: &impl Fn(usize) -> &'p Prepared,
    alike: bool,
    has_fog: bool,
) -> (Colors<S>, f32x16<S>) {
    let lanes = f32x16::splat(simd, 0.0);
    if alike {
        let [x, y] = centres(simd, origin);
        let Prepared { forms, colors: [a, b, c], fog, .. } = of(0);
        let [_, v, t] = LinearForms::everywhere(x, forms).clamped_barycentrics(x, y);
        let [a, b, c] = [in_lanes(lanes, a), in_lanes(lanes, b), in_lanes(lanes, c)];
        let mut colors = a;
        for (channel, color) in colors.iter_mut().enumerate() {
            *color = mixed([a[channel], b[channel], c[channel]], [v, t]);
        }
        return (colors, if has_fog { mixed(in_lanes(lanes, fog), [v, t]) } else { lanes });
    }
    let [x, y] = origin.map(f64::from);
    let [_, v, t] = LinearForms::own_clamped_barycentrics(
        simd,
        #[inline(always)]
        |lane| &of(lane).forms,
        #[inline(always)]
        |lane| [x + f64::from(CENTRE_X[lane]), y + f64::from(CENTRE_Y[lane])],
    );
    let weights: [[f32; LANES]; 2] = [v.into(), t.into()];
    let colors = columns(
        simd,
        #[inline(always)]
        |lane| {
            let [a, b, c] = &of(lane).colors;
            let corners = [
                f32x4::simd_from(simd, *a),
                f32x4::simd_from(simd, *b),
                f32x4::simd_from(simd, *c),
            ];
            let [v, t] = &weights;
            mixed(corners, [f32x4::splat(simd, v[lane]), f32x4::splat(simd, t[lane])])
        },
    );
    if !has_fog {
        return (colors, lanes);
    }
    let fog = [0, 1, 2].map(|corner| lanes.each_lane(|lane| of(lane).fog[corner]));
    (colors, mixed(fog, [v, t]))
}

/// Numbers in every lane.
#[inline(always)]
fn in_lanes<N: Lanes, const K: usize>(simd: N, numbers: &[f32; K]) -> [N; K] {
    let mut lanes = [simd; K];
    for (lanes, number) in lanes.iter_mut().zip(numbers) {
        *lanes = simd.constant(*number);
    }
    lanes
}

/// The value between three corners' by the second and third barycentrics. So written, what is the same at all corners
/// stays what it is.
#[inline(always)]
fn mixed<V>([a, b, c]: [V; 3], [v, t]: [V; 2]) -> V
where
    V: Copy + Add<Output = V> + Sub<Output = V> + Mul<Output = V>,
{
    a + v * (b - a) + t * (c - a)
}

/// Where the fragments of a block lie on their primitives.
struct TextureLookup<'l, S: Simd, F> {
    of: &'l F,
    alike: bool,
    position: [F64x16<S>; 2],
    rows: &'l [PackedForms],
}

impl<'p, S: Simd, F: Fn(usize) -> &'p Prepared> TextureLookup<'_, S, F> {
    /// The values of row `number` of each lane's primitive, and how they change to the right and upwards.
    #[inline(always)]
    fn values(&self, number: usize) -> ([f32x16<S>; 3], [[f32x16<S>; 3]; 2]) {
        let [x, y] = self.position;
        let forms = if self.alike {
            ProjectiveForms::everywhere(x, &self.rows[(self.of)(0).rows as usize + number])
        } else {
            ProjectiveForms::unpacked(
                x,
                #[inline(always)]
                |lane| &self.rows[(self.of)(lane).rows as usize + number],
            )
        };
        forms.values(x, y)
    }
}

/// Colours after all texture units, the secondary ones added (sections 3.8 and 3.9). Coordinates a pixel to the right
/// and a pixel above come from the primitive's own forms, so that levels of detail are the same in any block.
#[inline(never)]
fn textured<'p, S: Simd, F: Fn(usize) -> &'p Prepared>(
    colors: Colors<S>,
    lookup: &TextureLookup<'_, S, F>,
    textures: &TextureStages,
    lanes: u32,
) -> Colors<S> {
    colors[0].vectorized(
        #[inline(always)]
        || {
            let mut colors = textures.apply(
                colors,
                #[inline(always)]
                |stage| {
                    let (at, per_pixel) = lookup.values(1 + stage);
                    Footprint { at, per_pixel }
                },
                lanes,
            );
            if textures.secondary {
                let (secondary, _) = lookup.values(0);
                for (color, more) in colors.iter_mut().zip(secondary) {
                    *color = (*color + more.clamped(0.0, 1.0)).clamped(0.0, 1.0);
                }
            }
            colors
        },
    )
}

/// Colours as bytes, red lowest: x 255 + 1/2, rounded down.
#[inline(always)]
pub(super) fn encode<S: Simd>(colors: Colors<S>) -> u32x16<S> {
    let mut word = i32x16::splat(colors[0].simd, 0);
    for (channel, value) in colors.into_iter().enumerate() {
        let byte: i32x16<S> = i32x16::truncate_from(value * 255.0 + 0.5);
        word |= byte << (8 * channel as u32);
    }
    word.bitcast()
}

/// Bytes as colours from 0 to 1.
#[inline(always)]
pub(super) fn decode<S: Simd>(words: u32x16<S>) -> Colors<S> {
    let mut colors = [f32x16::splat(words.simd, 0.0); 4];
    for (channel, color) in colors.iter_mut().enumerate() {
        let byte: i32x16<S> = ((words >> (8 * channel as u32)) & 0xff).bitcast();
        *color = f32x16::float_from(byte) * (1.0 / 255.0);
    }
    colors
}
