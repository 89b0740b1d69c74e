//! Tests of pieces: their light is near enough everywhere, and no highlight slips through.

use super::super::tries::EachPlace;
use super::*;
use luxel_lighting::PictureEncoding;
use luxel_math::Level;

/// The pieces of a triangle with sides of `side` pixels, across which the light is `light`.
pub(in crate::subdivision) fn divided(
    tolerance: f32,
    side: f64,
    light: impl Fn(Place) -> [f32; 3],
) -> Pieces {
    Pieces::new(Asked {
        tolerance,
        light: &EachPlace(light),
        comparison: Comparison {
            level: Level::new(),
            display: None,
            encoding: PictureEncoding::None,
            texels: TexelLight::WHITE,
        },
        window: &|[_, v, w]| Some([f64::from(v) * side, f64::from(w) * side]),
        size: [side; 2],
    })
}

fn pieces(tolerance: f32, light: impl Fn(Place) -> [f32; 3]) -> Pieces {
    divided(tolerance, 300.0, light)
}

/// A narrow highlight in the middle, which no corner and no edge sees.
fn highlight([_, v, w]: Place) -> [f32; 3] {
    let (x, y) = (v - 0.3, w - 0.3);
    [1.0 / (1.0 + 60.0 * (x * x + y * y)), 0.2, 0.0]
}

#[test]
fn even_light_needs_one_piece() {
    let even = pieces(0.5, |[_, v, w]| [v, w, 0.5]);
    assert_eq!(even.count.pieces, 1);
    assert!(even.count.error < 1e-3);
}

#[test]
fn the_interpolated_light_is_within_the_tolerance_everywhere() {
    for tolerance in [0.5, 2.0, 8.0] {
        let pieces = pieces(tolerance, highlight);
        assert!(pieces.count.pieces > 10 && pieces.count.error <= tolerance);
        for row in 0..=97 {
            for column in 0..=97 - row {
                let [v, w] = [row, column].map(|at| at as f32 / 97.0);
                let place = [1.0 - v - w, v, w];
                let (got, wanted) = (pieces.light(place, [1.0; 3]), highlight(place));
                let off = 255.0 * (got[0] - wanted[0]).abs();
                // What was tried is within, and places between lie near such.
                assert!(off <= pieces.count.error + 0.05, "{place:?}: {off} of {tolerance}");
            }
        }
    }
}

/// A highlight of four pixels, which the first tries pass by.
#[test]
fn a_highlight_of_a_few_pixels_is_not_missed() {
    let narrow = |[_, v, w]: Place| {
        let (x, y) = (v - 0.31, w - 0.287);
        [1.0 / (1.0 + 30_000.0 * (x * x + y * y)), 0.0, 0.0]
    };
    let pieces = pieces(4.0, narrow);
    let off = 255.0 * (pieces.light([0.403, 0.31, 0.287], [1.0; 3])[0] - 1.0).abs();
    assert!(off < 8.0 && pieces.count.beyond == 0, "{off}, {:?}", pieces.count);
}

#[test]
fn where_light_jumps_the_pieces_beyond_are_told_and_tiny() {
    let pieces = pieces(2.0, |[_, v, w]| [if v + 0.7 * w > 0.4 { 0.8 } else { 0.2 }, 0.0, 0.0]);
    let count = pieces.count;
    assert!(count.error > 100.0 && count.beyond > 0, "{count:?}");
    // The jump is some 300 pixels long, and the pieces at it a small part of a pixel wide.
    assert!(count.beyond_area < 65_536 * 300 / 4, "{count:?}");
}

#[test]
fn a_finer_tolerance_takes_more_pieces() {
    let count = |tolerance| pieces(tolerance, highlight).count.pieces;
    assert!(count(0.5) > 2 * count(4.0));
}

#[test]
fn a_piece_holds_its_place() {
    let pieces = pieces(1.0, highlight);
    let place = [0.41, 0.28, 0.31];
    let (corners, weights) = pieces.piece(place);
    let back = mixed(corners.map(|(_, corner)| corner), weights);
    assert!(back.iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-5), "{back:?}");
}
