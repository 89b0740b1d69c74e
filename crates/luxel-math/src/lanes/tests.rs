//! One `f32` and vectors of them, at every level.

use super::*;
use crate::SimdLevel;
use fearless_simd::{Simd, dispatch, f32x8, f32x16, prelude::*};

/// What comparisons take apart: both zeros, infinities, NaN.
const VALUES: [f32; 8] =
    [0.0, -0.0, 1.0, -1.5, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE];

/// The smaller and the larger of two, lane by lane, in pieces.
struct Extremes {
    pairs: [[f32; LANES]; 2],
    found: [[f32; LANES]; 2],
    times: [u32; LANES],
}

impl SplitLanes for Extremes {
    #[inline(always)]
    fn part<N: Lanes>(&mut self, simd: N, first: usize) {
        let [a, b] = self.pairs.map(|values| simd.load(&values, first));
        a.minimum(b).store(&mut self.found[0], first);
        a.maximum(b).store(&mut self.found[1], first);
        let mut lanes = simd.all_lanes();
        while lanes != 0 {
            self.times[first + lanes.trailing_zeros() as usize] += 1;
            lanes &= lanes - 1;
        }
    }
}

#[inline(always)]
fn extremes<S: Simd>(simd: S, pairs: [[f32; LANES]; 2], whole: bool) -> Extremes {
    let mut work = Extremes { pairs, found: [[0.0; LANES]; 2], times: [0; LANES] };
    let simd = f32x16::splat(simd, 0.0);
    if whole {
        work.part(simd, 0);
    } else {
        simd.in_parts(&mut work);
    }
    work
}

#[inline(always)]
fn columns<N: Lanes>(simd: N, rows: &[[f32; 8]; LANES], first: usize) -> [[f32; LANES]; 8] {
    let mut stored = [[0.0; LANES]; 8];
    let columns = simd.load_transposed(
        #[inline(always)]
        |lane| &rows[first + lane],
    );
    for (stored, column) in stored.iter_mut().zip(columns) {
        column.store(stored, first);
    }
    let mut back = [[0.0; 8]; LANES];
    N::store_transposed(
        columns,
        #[inline(always)]
        |lane, row| back[first + lane] = row,
    );
    for (lane, back) in back.iter().enumerate().skip(first) {
        assert!(*back == rows[lane] || *back == [0.0; 8], "row {lane}");
    }
    assert_eq!(back[first], rows[first]);
    stored
}

#[test]
fn lanes_that_begin_differ_from_those_beside_and_above() {
    let begin = |values: &[u32; LANES]| {
        let differs = |lane: usize, by: usize| values[lane] != values[lane - by];
        let begins = |lane| (lane % 4 == 0 || differs(lane, 1)) && (lane < 4 || differs(lane, 4));
        (0..LANES).fold(0, |bits, lane| bits | u32::from(begins(lane)) << lane)
    };
    let mut state = 1_u32;
    for round in 0..200 {
        let values: [u32; LANES] = std::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) % (1 + round % 7)
        });
        for level in SimdLevel::available() {
            let level = level.resolve().unwrap();
            let sixteen = dispatch!(level, simd => f32x16::splat(simd, 0.0).run_starts(&values));
            let eight = dispatch!(level, simd => f32x8::splat(simd, 0.0).run_starts(&values));
            assert_eq!(sixteen, begin(&values), "{values:?} at {level:?}");
            assert_eq!(eight, begin(&values) & 0xff, "{values:?} at {level:?}");
        }
        assert_eq!(0.0_f32.run_starts(&values), begin(&values) & 1);
    }
}

#[test]
fn a_lane_of_a_column_is_a_component_of_its_row_and_the_way_back_finds_it() {
    let rows = std::array::from_fn(|row| std::array::from_fn(|at| (row * 8 + at) as f32));
    for level in SimdLevel::available() {
        let level = level.resolve().unwrap();
        let sixteen = dispatch!(level, simd => columns(f32x16::splat(simd, 0.0), &rows, 0));
        let eight = dispatch!(level, simd => columns(f32x8::splat(simd, 0.0), &rows, 8));
        for row in 0..LANES {
            for at in 0..8 {
                assert_eq!(sixteen[at][row], rows[row][at], "{level:?}");
                let expected = if row < 8 { 0.0 } else { rows[row][at] };
                assert_eq!(eight[at][row], expected, "{level:?}");
            }
        }
        assert_eq!(columns(0.0_f32, &rows, 5)[3][5], rows[5][3]);
    }
}

#[test]
fn the_smaller_and_the_larger_of_two_have_the_same_bits_at_every_level_and_in_pieces() {
    for level in SimdLevel::available() {
        let level = level.resolve().unwrap();
        for turn in 0..VALUES.len() {
            let a = std::array::from_fn(|lane| VALUES[lane % 8]);
            let b = std::array::from_fn(|lane| VALUES[(lane + turn) % 8]);
            for whole in [false, true] {
                let work = dispatch!(level, simd => extremes(simd, [a, b], whole));
                assert_eq!(work.times, [1; LANES], "{level:?}");
                for lane in 0..LANES {
                    let bits = work.found.map(|values| values[lane].to_bits());
                    let (a, b) = (a[lane], b[lane]);
                    let one = [Lanes::minimum(a, b), Lanes::maximum(a, b)].map(f32::to_bits);
                    assert_eq!(bits, one, "{a} and {b} at {level:?}");
                }
            }
        }
    }
}

/// Whole numbers as integers from lane `first` on, and the lanes that are visited.
#[inline(always)]
fn whole_and_visited<N: Lanes>(
    simd: N,
    values: &[f32; LANES],
    first: usize,
    lanes: u32,
) -> ([u32; LANES], Vec<usize>) {
    let mut whole = [u32::MAX; LANES];
    simd.load(values, first).store_whole(&mut whole, first);
    let mut visited = Vec::new();
    simd.visit(
        lanes,
        #[inline(always)]
        |lane| visited.push(lane),
    );
    (whole, visited)
}

#[test]
fn whole_numbers_are_stored_as_they_are_and_only_asked_lanes_visited() {
    #[inline(always)]
    fn check<S: Simd>(simd: S) {
        let values: [f32; LANES] = std::array::from_fn(|lane| (lane * lane * 74_565) as f32);
        let expected = |lane: usize| (lane * lane * 74_565) as u32;
        for lanes in [0, 1, 0x8001, 0xffff, 0x0ff0, 0x5a] {
            let of = |lanes: u32| (0..LANES).filter(move |lane| lanes >> lane & 1 == 1);
            let (whole, visited) = whole_and_visited(f32x16::splat(simd, 0.0), &values, 0, lanes);
            assert!((0..LANES).all(|lane| whole[lane] == expected(lane)));
            assert!(visited.into_iter().eq(of(lanes)));
            let (whole, visited) =
                whole_and_visited(f32x8::splat(simd, 0.0), &values, 8, lanes & 0xff);
            assert!((8..LANES).all(|lane| whole[lane] == expected(lane)));
            assert!(visited.into_iter().eq(of(lanes & 0xff)));
            let (whole, visited) = whole_and_visited(0.0_f32, &values, 5, lanes & 1);
            assert_eq!(whole[5], expected(5));
            assert!(visited.into_iter().eq(of(lanes & 1)));
        }
    }
    for level in SimdLevel::available() {
        dispatch!(level.resolve().unwrap(), simd => check(simd));
    }
}

#[inline(always)]
fn put_in_lanes<N: Lanes>(new: N, kept: &[f32; LANES], lanes: u32) -> [f32; LANES] {
    let mut place = new.load(kept, 0);
    new.put(new.mask_of(lanes), &mut place);
    let mut stored = [0.0; LANES];
    place.store(&mut stored, 0);
    stored
}

#[test]
fn lanes_outside_a_mask_keep_what_their_place_had() {
    let kept: [f32; LANES] = std::array::from_fn(|lane| VALUES[lane % VALUES.len()]);
    for level in SimdLevel::available() {
        for lanes in [0, 1, 0x8001, 0x5a3c, 0xffff] {
            let stored = dispatch!(level.resolve().unwrap(), simd => {
                put_in_lanes(f32x16::splat(simd, 7.0), &kept, lanes)
            });
            for lane in 0..LANES {
                let expected = if lanes >> lane & 1 == 1 { 7.0 } else { kept[lane] };
                assert_eq!(
                    stored[lane].to_bits(),
                    expected.to_bits(),
                    "{level:?} {lanes:x} {lane}"
                );
            }
        }
    }
}
