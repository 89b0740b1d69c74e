//! Which boxes and points a search may leave out.
//!
//! The points where a measure reaches a value lie in a half-space: (x - e) / (h - z) >= b is
//! x - e - b (h - z) >= 0 in front of the eye. Its normal is transformed into the coordinates of the
//! mesh, where three products give how far a point or a bound reaches along it.
//!
//! **Rounding.** Let A be the sum of magnitudes |m| |p| + |t| that a transformed coordinate is made
//! of, for the largest point of the object. The transformed coordinate is off by less than 5 u A,
//! with u = 2^-53; the measures round at most 5 times more, the half-space at most 16 times, each
//! in proportion to such magnitudes. [`ROUNDING`] allows for 64 u of all magnitudes together.
//!
//! Reaches are computed in `f32`, of which a vector holds twice as many as of `f64`, from
//! coordinates without the mesh's origin. They are sums of three products with at most 4 roundings
//! on the way to each factor, in proportion to |n| |p|: [`REACH_ROUNDING`] allows for 16 times
//! 2^-24.
//!
//! Where magnitudes aren't finite, nothing is left out.

use super::Object;
use super::measure::{HalfSpace, Measure};
use crate::point_tree::{Node, WIDTH, nearest_sides};
use glam::DVec3;

/// Bound of the rounding error, relative to all magnitudes involved.
const ROUNDING: f64 = 64.0 * (f64::EPSILON / 2.0);
/// More than products lose that are too small for `f64`, if 1e151 of it count.
const UNDERFLOW: f64 = 1e-150;
/// Magnitudes from here on may overflow on the way.
const LARGE: f64 = 1e300;

/// Bound of the rounding error of reaches, relative to |n| |p|.
const REACH_ROUNDING: f64 = 16.0 * (f32::EPSILON as f64 / 2.0);
/// More than reaches lose where numbers are too small for `f32`, as a part of |p|.
const REACH_UNDERFLOW: f64 = 1e-40;
/// Reaches from here on may overflow.
const REACH_LARGE: f64 = 1e38;

/// A half-space in the coordinates of a mesh, without its origin: points that reach less far are
/// outside of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cut {
    /// 1 along its longest axis.
    normal: [f32; 3],
    /// The sides of polytopes that bound points along the normal, and how much of each is in it.
    sides: [usize; 3],
    parts: [f32; 3],
    least_reach: f32,
    /// The value that the half-space is made for.
    pub(super) best: f64,
}

impl Cut {
    pub(super) fn new(measure: &impl Measure, best: f64, object: &Object<'_>) -> Self {
        let HalfSpace { normal, constant, magnitude } = measure.half_space(best);
        let target_from_mesh = object.target_from_mesh.matrix();
        let [x, y, z, translation] =
            [0, 1, 2, 3].map(|column| target_from_mesh.col(column).truncate());
        let in_mesh = DVec3::new(normal.dot(x), normal.dot(y), normal.dot(z));
        let constant = constant + normal.dot(translation) + in_mesh.dot(object.mesh.origin);
        let magnitude = magnitude + normal.abs().dot(object.magnitudes);
        let least_reach = -(constant + ROUNDING * magnitude + UNDERFLOW);

        let scale = in_mesh.abs().max_element().recip();
        let normal = (in_mesh * scale).as_vec3();
        let largest = normal.as_dvec3().abs().dot(object.largest);
        let slack =
            REACH_ROUNDING * largest + REACH_UNDERFLOW * (1.0 + object.largest.element_sum());
        let least_reach = (least_reach * scale - slack) as f32;
        // False for NaN, and for a zero normal.
        let is_certain =
            magnitude < LARGE && object.largest.element_sum() < REACH_LARGE && scale < LARGE;
        let least_reach = if is_certain { least_reach } else { f32::NEG_INFINITY };
        let (sides, parts) = nearest_sides(normal.to_array());
        Self { normal: normal.to_array(), sides, parts, least_reach, best }
    }

    pub(super) fn is_reached(&self, reach: f32) -> bool {
        // NaN may be anything.
        reach >= self.least_reach || reach.is_nan()
    }

    /// Which of some children are reached, a bit each.
    pub(super) fn reached(&self, reaches: &[f32; WIDTH]) -> u32 {
        let mut reached = 0;
        for (child, &reach) in reaches.iter().enumerate() {
            reached |= u32::from(self.is_reached(reach)) << child;
        }
        reached
    }

    /// How far a point, or the farthest corner of a box, reaches along the normal.
    pub(super) fn reach_of(&self, low: [f32; 3], high: [f32; 3]) -> f32 {
        let along = |axis: usize| {
            let normal = self.normal[axis];
            normal * if normal > 0.0 { high[axis] } else { low[axis] }
        };
        along(0) + along(1) + along(2)
    }

    /// How far each child reaches along the normal, at most.
    pub(super) fn reaches_of(&self, node: &Node) -> [f32; WIDTH] {
        let [first, second, third] = self.sides.map(|side| &node.reaches[side]);
        let [of_first, of_second, of_third] = self.parts;
        std::array::from_fn(|child| {
            of_first * first[child] + of_second * second[child] + of_third * third[child]
        })
    }
}
