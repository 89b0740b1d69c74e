//! What triangles cover of whole tiles, against the samples that they cover there.

use crate::random::cases;
use luxel_math::{Level, SUBPIXELS, Simd, dispatch, f32x16, mask32x16, prelude::*};
use luxel_visibility::{CullFaces, Overlap, Region, Sink, TILE, Triangle, WindowVertex, cover};
use proptest::prelude::*;

/// Counts samples.
struct Count(i32);

impl Sink for Count {
    #[inline(always)]
    fn few(&mut self, _: [i32; 4]) {}

    #[inline(always)]
    fn blocks<S: Simd>(&mut self, _: S, _: i32, blocks: u32, _: f32x16<S>, _: bool) -> u32 {
        blocks
    }

    #[inline(always)]
    fn block<S: Simd>(&mut self, _: S, covered: mask32x16<S>, _: f32x16<S>, _: usize) {
        self.0 += covered.to_bitmask().count_ones() as i32;
    }

    #[inline(always)]
    fn sample(&mut self, _: [i32; 2], _: [i32; 2], _: f32) {
        self.0 += 1;
    }
}

proptest! {
    #![proptest_config(cases(600))]

    #[test]
    fn a_triangle_that_covers_all_samples_of_a_tile_or_none_is_found(
        middle in [-8000..24000_i32, -8000..24000_i32],
        corners in [[-1.0..1.0_f32, -1.0..1.0_f32], [-1.0..1.0_f32, -1.0..1.0_f32], [-1.0..1.0_f32, -1.0..1.0_f32]],
        size in prop::sample::select(vec![200.0_f32, 4000.0, 60000.0]),
        offset in [0..SUBPIXELS, 0..SUBPIXELS],
    ) {
        let vertex = |[x, y]: [f32; 2]| WindowVertex {
            x: middle[0] + (x * size) as i32,
            y: middle[1] + (y * size) as i32,
            z: 0.5,
        };
        let triangle = Triangle::new(corners.map(vertex), CullFaces::None);
        prop_assume!(triangle.is_some());
        let triangle = triangle.unwrap();
        let tile = Region { x: 0, y: 0, width: TILE, height: TILE };
        let mut count = Count(0);
        dispatch!(Level::baseline(), simd => cover(simd, &triangle, tile, offset, &mut count));
        match triangle.overlap(tile, offset) {
            Overlap::None => prop_assert_eq!(count.0, 0),
            Overlap::Whole => prop_assert_eq!(count.0, TILE * TILE),
            Overlap::Part => prop_assert!(count.0 < TILE * TILE),
        }
    }
}
