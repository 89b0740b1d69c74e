//! Depths as planes keep them: whole steps of 24 bits, or floats (ARB_depth_buffer_float).

use crate::plane::{Plane, PlaneValue};
use luxel_math::{
    F64Lanes, LANES, Lanes, Level, SUBPIXELS, Simd, dispatch_long, i32x16, prelude::*,
};
use luxel_visibility::{DepthPlane as TriangleDepths, TILE};

/// The largest depth in steps of 24 bits.
const LARGEST_STEP: f32 = 16_777_215.0;

/// How a plane keeps depths from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum DepthKind {
    /// Whole numbers, times 2^24 - 1.
    #[default]
    Steps,
    /// As they are.
    Floats,
}

impl DepthKind {
    /// What the depth 1 is kept as.
    #[inline(always)]
    pub(crate) fn largest(self) -> f32 {
        match self {
            Self::Steps => LARGEST_STEP,
            Self::Floats => 1.0,
        }
    }

    /// Bits of a depth.
    pub(crate) fn bits(self) -> usize {
        match self {
            Self::Steps => 24,
            Self::Floats => 32,
        }
    }

    /// A depth as it is kept, moved by an offset: whole offsets move by as many steps.
    #[inline(always)]
    pub(crate) fn moved<N: Lanes>(self, z: N, offset: f32) -> N {
        let kept = self.limited(z);
        if offset == 0.0 { kept } else { self.limited(kept + z.constant(offset)) }
    }

    #[inline(always)]
    fn limited<N: Lanes>(self, z: N) -> N {
        let within = z.clamped(0.0, self.largest());
        match self {
            Self::Steps => within.round_ties_even(),
            Self::Floats => within,
        }
    }

    /// A depth from 0 to 1 as it is kept.
    pub(crate) fn kept(self, unit: f64) -> f32 {
        match self {
            Self::Steps => (unit * f64::from(LARGEST_STEP)).round_ties_even() as f32,
            Self::Floats => unit as f32,
        }
    }

    /// The depth from 0 to 1 that is kept as `value`.
    #[inline(always)]
    pub(crate) fn unit<N: Lanes>(self, value: N) -> N {
        match self {
            // As exact as the division: no quotient of whole steps is as near to the middle between two `f32`.
            Self::Steps => {
                let value = value.to_f64();
                (value * value.constant(1.0 / f64::from(LARGEST_STEP))).to_f32()
            }
            Self::Floats => value,
        }
    }

    /// The smallest difference that surely tells two depths apart, r of section 3.5.5, beside a depth: 2^(e - 23) for
    /// floats with the exponent e.
    pub(crate) fn resolution(self, beside: f32) -> f32 {
        match self {
            Self::Steps => 2.0,
            Self::Floats => {
                let exponent = beside.abs().clamp(f32::MIN_POSITIVE, 1.0).to_bits() >> 23;
                f32::from_bits(exponent << 23) * f32::EPSILON
            }
        }
    }
}

/// The depths of a tile that lies in one triangle: they are computed where they are read, as where they are written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthRule {
    kind: DepthKind,
    /// Positions are counted from the tile's first sample.
    depths: TriangleDepths,
    /// What they are moved by.
    offset: f32,
}

impl DepthRule {
    /// The same depth everywhere, as it is kept.
    pub(crate) fn even(kind: DepthKind, value: f32) -> Self {
        let depths = TriangleDepths {
            x: 0,
            y: 0,
            z: value,
            dz_dx: 0.0,
            dz_dy: 0.0,
            low: value,
            high: value,
        };
        Self { kind, depths, offset: 0.0 }
    }

    /// Those of a triangle, moved by an offset, in the tile whose first sample lies at `first`.
    pub(crate) fn of_triangle(
        kind: DepthKind,
        depths: &TriangleDepths,
        offset: f32,
        first: [i32; 2],
    ) -> Self {
        Self { kind, depths: depths.from_origin(first), offset }
    }

    /// The least and the greatest depth, as they are kept: each rounded step from pixel to pixel along a row goes the same
    /// way, and along a column, so that both lie at corners of the tile.
    pub(crate) fn range(&self) -> [f32; 2] {
        let last = TILE - 1;
        let corners = [[0, 0], [last, 0], [0, last], [last, last]];
        let depths = corners.map(|corner| f32::by_rule(self, corner));
        depths[1..]
            .iter()
            .fold([depths[0]; 2], |[low, high], depth| [low.min(*depth), high.max(*depth)])
    }
}

impl PlaneValue for f32 {
    type Rule = DepthRule;

    #[inline(always)]
    fn by_rule(rule: &DepthRule, pixel: [i32; 2]) -> Self {
        let depth = rule.depths.at([pixel[0] * SUBPIXELS, pixel[1] * SUBPIXELS]);
        rule.kind.moved(depth, rule.offset)
    }

    #[inline(always)]
    fn by_rule_in_lanes<S: Simd>(rule: &DepthRule, [x, y]: [i32x16<S>; 2]) -> [Self; LANES] {
        let depths = rule.depths.at_lanes([x * SUBPIXELS, y * SUBPIXELS]);
        rule.kind.moved(depths, rule.offset).into()
    }

    fn row_by_rule(rule: &DepthRule, y: i32, row: &mut [Self]) {
        dispatch_long!(Level::baseline(), simd => {
            let columns = i32x16::simd_from(simd, std::array::from_fn(|lane| lane as i32));
            let rows = i32x16::splat(simd, y);
            for (number, part) in row.chunks_mut(LANES).enumerate() {
                let first = (number * LANES) as i32;
                let depths = Self::by_rule_in_lanes(rule, [columns + first, rows]);
                part.copy_from_slice(&depths[..part.len()]);
            }
        });
    }
}

/// Depths of all pixels.
#[derive(Clone, Debug)]
pub(crate) struct DepthPlane {
    pub(crate) kind: DepthKind,
    /// As they are kept.
    pub(crate) values: Plane<f32>,
}

impl DepthPlane {
    /// The same depth from 0 to 1 everywhere; `None` if there is no memory for it.
    pub(crate) fn new(kind: DepthKind, size: [u32; 2], samples: usize, unit: f64) -> Option<Self> {
        Some(Self { kind, values: Plane::new(size, samples, kind.kept(unit))? })
    }

    /// A depth from 0 to 1; `None` outside.
    #[inline]
    pub(crate) fn unit(&self, at: [u32; 2], sample: usize) -> Option<f32> {
        self.values.get(at, sample).map(|value| self.kind.unit(value))
    }

    /// Changes a depth, from 0 to 1.
    pub(crate) fn set_unit(&mut self, at: [u32; 2], sample: usize, unit: f32) {
        self.values.set(at, sample, self.kind.kept(unit.into()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_math::dispatch;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_triangles_depths_in_a_tile_lie_within_their_range_and_are_the_same_in_lanes(
            corner in [-9000..9000_i32, -9000..9000_i32], slope in [-90.0..90.0_f32, -90.0..90.0_f32],
            z in 0.0..LARGEST_STEP, reach in 0.0..1e6_f32, offset in prop::sample::select(vec![0.0, 3.0, -700.25]),
            first in [-9000..9000_i32, -9000..9000_i32], kind in prop::sample::select(vec![DepthKind::Steps, DepthKind::Floats]),
        ) {
            let depths = TriangleDepths {
                x: corner[0],
                y: corner[1],
                z: z / LARGEST_STEP * kind.largest(),
                dz_dx: slope[0] / LARGEST_STEP * kind.largest(),
                dz_dy: slope[1] / LARGEST_STEP * kind.largest(),
                low: (z - reach) / LARGEST_STEP * kind.largest(),
                high: (z + reach) / LARGEST_STEP * kind.largest(),
            };
            let rule = DepthRule::of_triangle(kind, &depths, offset, first);
            let [low, high] = rule.range();
            let (mut least, mut greatest) = (f32::INFINITY, f32::NEG_INFINITY);
            for y in 0..TILE {
                for x in 0..TILE {
                    let depth = f32::by_rule(&rule, [x, y]);
                    let at = [first[0] + x * SUBPIXELS, first[1] + y * SUBPIXELS];
                    prop_assert_eq!(depth, kind.moved(depths.at(at), offset));
                    (least, greatest) = (least.min(depth), greatest.max(depth));
                }
            }
            prop_assert_eq!([low, high], [least, greatest]);
            dispatch!(Level::baseline(), simd => {
                for y in 0..TILE {
                    let columns = i32x16::simd_from(simd, std::array::from_fn(|lane| 4 * lane as i32));
                    let lanes = f32::by_rule_in_lanes(&rule, [columns, i32x16::splat(simd, y)]);
                    let alone: [f32; LANES] = std::array::from_fn(|lane| f32::by_rule(&rule, [4 * lane as i32, y]));
                    assert_eq!(lanes, alone);
                }
            });
        }
    }

    #[test]
    fn depths_are_found_again_as_exactly_as_their_kind_keeps_them() {
        for unit in [0.0, 0.1, 0.5, 0.9, 1.0] {
            let kept = DepthKind::Steps.unit(DepthKind::Steps.kept(unit));
            assert!((f64::from(kept) - unit).abs() <= 0.5 / 16_777_215.0 + 3e-8);
        }
        for unit in [0.0_f32, 1e-30, 0.1, 1.0] {
            assert_eq!(DepthKind::Floats.unit(DepthKind::Floats.kept(unit.into())), unit);
        }
        assert_eq!(DepthKind::Steps.moved(0.4_f32, 3.0), 3.0);
        assert_eq!(DepthKind::Steps.moved(16_777_214.0_f32, 3.0), 16_777_215.0);
        assert_eq!(DepthKind::Floats.moved(0.25_f32, 0.5), 0.75);
        assert_eq!(DepthKind::Floats.moved(0.75_f32, 0.5), 1.0);
    }

    #[test]
    fn steps_become_depths_as_a_division_rounds_them() {
        for step in 0..1_u32 << 24 {
            let expected = (f64::from(step) / f64::from(LARGEST_STEP)) as f32;
            assert_eq!(DepthKind::Steps.unit(step as f32), expected, "{step}");
        }
    }

    #[test]
    fn section_3_5_5_the_resolution_of_floats_is_one_unit_in_the_last_place() {
        for depth in [1.0_f32, 0.75, 0.5, 0.3, 1e-6] {
            let next = f32::from_bits(depth.to_bits() + 1);
            assert_eq!(DepthKind::Floats.resolution(depth), next - depth);
        }
        assert_eq!(DepthKind::Steps.resolution(0.5), 2.0);
        assert!(DepthKind::Floats.resolution(0.0) > 0.0);
    }
}
