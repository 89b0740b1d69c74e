//! Samples of small triangles into the visibility buffer of a tile.

use super::buffer::{Plane, Tile};
use super::rules::{self, Rules};
use super::small_triangles::{SmallPlaces, SmallSamples, SmallSink};
use super::tile_points::{self, x_of, y_of};
use crate::types::{TILE, TriangleId};
use luxel_math::{LANES, SUBPIXELS, Simd, lanes_of};

/// Puts samples where they win.
pub(super) struct BufferSink<'t> {
    pub(super) rules: &'t Rules<'t>,
    pub(super) tile: &'t mut Tile,
}

impl SmallSink<TriangleId> for BufferSink<'_> {
    #[inline(always)]
    fn put<S: Simd>(&mut self, samples: &SmallSamples<'_, S, TriangleId>) {
        let Self { rules, tile } = self;
        let mut left = samples.covered;
        let places = samples.places();
        if rules.behind.is_none() && rules.holes.is_none() {
            // Nearly always. Only between equally near ones more than depth decides.
            let mut rest = samples.covered;
            left = 0;
            let Plane { depth, ids } = &mut tile.planes[samples.sample];
            let (depth, ids) = (depth.as_flattened_mut(), ids.as_flattened_mut());
            while rest != 0 {
                let number = rest.trailing_zeros() as usize & (LANES - 1);
                rest &= rest - 1;
                let place = places.places[number] as usize & (SAMPLES - 1);
                let (z, before) = (places.z[number], depth[place]);
                if before < z {
                    depth[place] = z;
                    ids[place] = samples.ids[number].0;
                } else if before == z {
                    left |= 1 << number;
                }
            }
            if left == 0 {
                return;
            }
        }
        put_rest(samples, left, &places, rules, tile);
    }
}

/// Puts those about which more than depth decides: a function of its own, as it is rarely called.
#[inline(never)]
fn put_rest<S: Simd>(
    samples: &SmallSamples<'_, S, TriangleId>,
    mut left: u32,
    SmallPlaces { places, z: depths }: &SmallPlaces,
    rules: &Rules<'_>,
    tile: &mut Tile,
) {
    let &SmallSamples { ids, pixels, sample, .. } = samples;
    let place = |number: usize| {
        let place = places[number] as usize;
        (place / LANES, place % LANES)
    };
    if let Some(holes) = rules.holes {
        for number in lanes_of(left) {
            let id = ids[number];
            let wins = rules::wins(id, depths[number], place(number), rules, tile, sample);
            left &= !(u32::from(!wins) << number);
        }
        if left != 0 {
            let [offset_x, offset_y] = rules.offsets[sample];
            let [x, y] = tile_points::middle_of(tile.region);
            left &= !pixels.simd.vectorize(
                #[inline(always)]
                || {
                    let across = (x_of(pixels) + x) * SUBPIXELS + offset_x;
                    let down = (y_of(pixels) + y) * SUBPIXELS + offset_y;
                    rules::ask(holes, *ids, [across, down], left)
                },
            );
        }
    }
    // Two of them may want the same sample.
    for number in lanes_of(left) {
        let (id, z) = (ids[number], depths[number]);
        if rules::wins(id, z, place(number), rules, tile, sample) {
            rules::put(id, z, place(number), tile, sample);
        }
    }
}

/// Samples of a plane.
const SAMPLES: usize = (TILE * TILE) as usize;
