//! From space to a grid of whole numbers.

use super::Vertex;
use glam::DVec3;

/// Bits of the largest coordinate on the grid: products of three coordinates fit into 128 bits.
const BITS: i32 = 40;

/// A position on the grid; ordered by x, then y, as a sweep goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Point {
    pub(super) x: i64,
    pub(super) y: i64,
}

/// Twice the area of a triangle: positive if it is counter-clockwise.
pub(super) fn area(a: Point, b: Point, c: Point) -> i128 {
    let (ux, uy) = (i128::from(b.x - a.x), i128::from(b.y - a.y));
    let (vx, vy) = (i128::from(c.x - a.x), i128::from(c.y - a.y));
    ux * vy - uy * vx
}

/// The projection along the normal: it drops the coordinate in which the normal is longest, which changes shapes but
/// neither crossings nor turns.
pub(super) struct Plane {
    axes: [usize; 2],
    signs: [f64; 2],
}

impl Plane {
    /// The plane of some contours, seen from `normal`, or from where their area is positive if that is 0. `None` if
    /// nothing is in it.
    pub(super) fn of(contours: &[Vec<Vertex>], normal: [f64; 3]) -> Option<Self> {
        let mut normal = DVec3::from_array(normal);
        if normal == DVec3::ZERO || !normal.is_finite() {
            normal = normal_of(contours)?;
        }
        let lengths = normal.abs().to_array();
        let mut dropped = 0;
        for axis in 1..3 {
            if lengths[axis] > lengths[dropped] {
                dropped = axis;
            }
        }
        let axes = [(dropped + 1) % 3, (dropped + 2) % 3];
        let sign = if normal.to_array()[dropped] > 0.0 { 1.0 } else { -1.0 };
        let mut plane = Self { axes, signs: [1.0, sign] };
        let vertices = contours.iter().flatten();
        let largest = vertices
            .flat_map(|vertex| axes.map(|axis| vertex.coordinates[axis].abs()))
            .fold(0.0, f64::max);
        if largest > 0.0 {
            // A power of two, so that the grid rounds as little as can be.
            let (_, exponent) = libm::frexp(largest);
            // Tiny polygons get fewer bits, since no power above the 1023rd is a number.
            let scale = libm::ldexp(1.0, (BITS - exponent).min(1023));
            plane.signs = plane.signs.map(|sign| sign * scale);
        }
        Some(plane)
    }

    /// Where a vertex is on the grid.
    pub(super) fn point(&self, coordinates: [f64; 3]) -> Point {
        let on_grid = |at: usize| (coordinates[self.axes[at]] * self.signs[at]).round() as i64;
        Point { x: on_grid(0), y: on_grid(1) }
    }
}

/// The direction from which the sum of all areas is largest (Newell); of contours whose areas cancel, the normal of a
/// large triangle. `None` if all lie on a line.
fn normal_of(contours: &[Vec<Vertex>]) -> Option<DVec3> {
    let position = |vertex: &Vertex| DVec3::from_array(vertex.coordinates);
    let first = position(contours.iter().flatten().next()?);
    let farthest = contours
        .iter()
        .flatten()
        .map(|v| (position(v) - first).abs().max_element())
        .fold(0.0, f64::max);
    if farthest == 0.0 {
        return None;
    }
    // Relative to the first vertex and of unit size, so that products neither cancel nor overflow.
    let local = |vertex: &Vertex| (position(vertex) - first) / farthest;
    let mut sum = DVec3::ZERO;
    let mut scale = 0.0;
    for contour in contours {
        for (at, vertex) in contour.iter().enumerate() {
            let term = local(vertex).cross(local(&contour[(at + 1) % contour.len()]));
            sum += term;
            scale += term.abs().max_element();
        }
    }
    if sum.abs().max_element() > 1e-9 * scale {
        return Some(sum);
    }
    let vertices = || contours.iter().flatten().map(local);
    let far = vertices().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    let normal = vertices()
        .map(|vertex| far.cross(vertex))
        .max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
    (normal.length_squared() > 1e-24).then_some(normal)
}
