//! Triangles in tiles whose depths follow from a rule: many are decided about there as a whole, so that the tile needn't be
//! written.

use super::blend::compare;
use super::piece_sink::Tests;
use super::tile::Seen;
use crate::depth::{DepthKind, DepthRule};
use crate::enums as gl;
use crate::plane::PlaneTile;
use luxel_math::SUBPIXELS;
use luxel_visibility::{Overlap, Region, TILE, Triangle};

/// A tile of one sample whose depths follow from a rule.
pub(super) struct WholeTile<'t> {
    pub(super) rule: DepthRule,
    pub(super) depth: &'t mut PlaneTile<f32>,
    pub(super) depth_kind: DepthKind,
    pub(super) seen: &'t mut Seen,
    /// Its pixels that the window has.
    pub(super) region: Region,
    /// Where the sample lies in a pixel.
    pub(super) offset: [i32; 2],
}

impl WholeTile<'_> {
    /// Takes a triangle, if it needn't be drawn pixel by pixel: it reaches no sample, or lies behind all that is there, or
    /// covers the tile and is seen everywhere. Whether it has been taken.
    #[inline(never)]
    pub(super) fn take(&mut self, triangle: &Triangle, tests: Tests<'_>) -> bool {
        let overlap = triangle.overlap(self.region, self.offset);
        if overlap == Overlap::None {
            return true;
        }
        let Some((func, writes)) = tests.pipeline.depth.filter(|_| tests.plain) else {
            return false;
        };
        let Region { x, y, .. } = self.region;
        let first = [x * SUBPIXELS + self.offset[0], y * SUBPIXELS + self.offset[1]];
        let depths = DepthRule::of_triangle(self.depth_kind, &triangle.depth, tests.offset, first);
        match passes(func, depths.range(), self.rule.range()) {
            Some(false) => true,
            Some(true) if overlap == Overlap::Whole && tests.limits == [0, 0, TILE, TILE] => {
                if writes {
                    self.depth.follow(depths);
                }
                if tests.pipeline.color_bits != 0 {
                    self.seen.as_flattened_mut().fill(tests.number);
                }
                true
            }
            _ => false,
        }
    }
}

/// Whether all depths of a range pass the test against all of another one, or none does; `None` if that isn't known. What
/// holds at both ends of both ranges holds between them, but for equality.
fn passes(func: u32, incoming: [f32; 2], stored: [f32; 2]) -> Option<bool> {
    if matches!(func, gl::EQUAL | gl::NOTEQUAL) {
        return None;
    }
    let first = compare(func, incoming[0], stored[0]);
    let all = [(0, 1), (1, 0), (1, 1)];
    all.iter().all(|&(at, of)| compare(func, incoming[at], stored[of]) == first).then_some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_4_1_6_what_is_known_of_ranges_holds_for_all_depths_between() {
        let ranges = || (0..4).flat_map(|low| (low..4).map(move |high| [low, high]));
        for func in gl::NEVER..=gl::ALWAYS {
            for (incoming, stored) in ranges().flat_map(|a| ranges().map(move |b| (a, b))) {
                let of = |[low, high]: [i32; 2]| [low as f32, high as f32];
                let known = passes(func, of(incoming), of(stored));
                for (z, before) in (incoming[0]..=incoming[1])
                    .flat_map(|z| (stored[0]..=stored[1]).map(move |before| (z, before)))
                {
                    let pass = compare(func, z as f32, before as f32);
                    assert!(known.is_none_or(|known| known == pass), "{func:#x}: {z}, {before}");
                }
            }
        }
        assert_eq!(passes(gl::LESS, [1.0, 2.0], [3.0, 4.0]), Some(true));
        assert_eq!(passes(gl::GEQUAL, [1.0, 2.0], [3.0, 4.0]), Some(false));
    }
}
