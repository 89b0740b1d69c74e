//! Lines, points and bitmaps in a tile (OpenGL 1.5, sections 3.3, 3.4 and 3.7).

use super::bitmap::Bitmap;
use super::piece_sink::PieceSink;
use super::shape::LineEnds;
use luxel_math::{SUBPIXELS, Simd};
use luxel_visibility::{DepthPlane, Sink, TILE};

/// The fragments of a line in the tile: each stands for a column of `width` pixels across the major axis.
#[inline(always)]
pub(super) fn line<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    of: &LineEnds,
    width: i32,
    counter: u32,
) {
    let LineEnds { places: ends, depths, .. } = *of;
    let walk = of.walk();
    // A column across.
    let across = if walk.major == 0 { [0, 1] } else { [1, 0] };
    // By the axis from two values: one by its number would go through memory.
    let along = |[x, y]: [i32; 2]| if walk.major == 0 { x } else { y };
    let length = (along(ends[1]) - along(ends[0])) as f32;
    let slope = if length == 0.0 { 0.0 } else { (depths[1] - depths[0]) / length };
    let slopes = if walk.major == 0 { [slope, 0.0] } else { [0.0, slope] };
    let plane = DepthPlane {
        x: ends[0][0],
        y: ends[0][1],
        z: depths[0],
        dz_dx: slopes[0],
        dz_dy: slopes[1],
        low: depths[0].min(depths[1]),
        high: depths[0].max(depths[1]),
    };
    // Fragments within the tile along the major axis.
    let low = along(sink.origin);
    let bounds = if walk.step > 0 {
        [low - walk.first, low + TILE - walk.first]
    } else {
        [walk.first - low - TILE + 1, walk.first - low + 1]
    };
    let stipple = sink.tests.pipeline.line_stipple;
    for index in bounds[0].max(0)..bounds[1].min(walk.count) {
        if let Some((factor, pattern)) = stipple
            && pattern >> (counter.wrapping_add(index as u32) / factor % 16) & 1 == 0
        {
            continue;
        }
        let first = walk.pixel(index);
        let position = first.map(|at| at * SUBPIXELS + SUBPIXELS / 2);
        let z = plane.at(position);
        let first = [first[0] - sink.origin[0], first[1] - sink.origin[1]];
        for number in 0..width {
            let pixel = [first[0] + number * across[0], first[1] + number * across[1]];
            if (0..TILE).contains(&pixel[0]) && (0..TILE).contains(&pixel[1]) {
                sink.sample(pixel, position, z);
            }
        }
    }
}

/// The square of a point, block by block.
#[inline(always)]
pub(super) fn point<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    corner: [i32; 2],
    side: i32,
    depth: f32,
) {
    let [left, bottom] = [corner[0] - sink.origin[0], corner[1] - sink.origin[1]];
    let [low_x, low_y] = [left.max(0), bottom.max(0)];
    let [high_x, high_y] = [(left + side).min(TILE), (bottom + side).min(TILE)];
    for y in low_y..high_y {
        for x in low_x..high_x {
            sink.sample([x, y], [0; 2], depth);
        }
    }
}

/// The pixels of a bitmap whose bits are set.
pub(super) fn bitmap<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    of: &Bitmap,
    corner: [i32; 2],
    depth: f32,
) {
    let [left, bottom] = [corner[0] - sink.origin[0], corner[1] - sink.origin[1]];
    let [width, height] = of.size();
    for y in bottom.max(0)..(bottom + height).min(TILE) {
        for x in left.max(0)..(left + width).min(TILE) {
            if of.is_set((x - left) as usize, (y - bottom) as usize) {
                sink.sample([x, y], [0; 2], depth);
            }
        }
    }
}
