//! A grid of voxels over a scene, and the planes of triangles in each of them.

use super::{Body, Facet, ROUNDING};
use glam::DVec3;

/// Cubes that fill the box of a scene.
pub(super) struct Voxels {
    low: DVec3,
    side: f64,
    /// Voxels for each unit of length.
    density: f64,
    counts: [u32; 3],
}

/// Voxels along the longest side of a scene, at most.
const MOST: f64 = 64.0;
/// Triangles that are looked at to learn how large they are.
const SAMPLED: usize = 1 << 12;
/// Classes of each component of a normal, for its absolute value.
const NORMALS: f64 = 32.0;
/// Classes of a plane's distance from the middle of a voxel, for each of its sides.
const DISTANCES: f64 = 64.0;

impl Voxels {
    /// Over a box, of twice the size of triangles as the mean of squares gives it: then triangles reach into
    /// few voxels, all of them together, however large some are.
    pub(super) fn new(bodies: &[Body<'_>], [low, high]: [DVec3; 2]) -> Self {
        let triangles: usize = bodies.iter().map(|body| body.mesh.triangles.len()).sum();
        let step = (triangles / SAMPLED).max(1);
        let (mut squares, mut count, mut next) = (0.0, 0.0, 0);
        for body in bodies {
            let own = body.mesh.triangles.len();
            while next < own {
                let [a, b, c] = body.corners(next as u32);
                let extent = (a.max(b).max(c) - a.min(b).min(c)).length_squared();
                if extent.is_finite() {
                    (squares, count) = (squares + extent, count + 1.0);
                }
                next += step;
            }
            next -= own;
        }
        let size = if count > 0.0 { (squares / count).sqrt() } else { 0.0 };
        let extent = (high - low).max_element();
        let side = (2.0 * size).max(extent / MOST);
        let side = if side.is_finite() && side > 0.0 { side } else { 1.0 };
        let counts = ((high - low) / side).min(DVec3::splat(MOST)).to_array();
        Self { low, side, density: 1.0 / side, counts: counts.map(|count| count as u32 + 1) }
    }

    pub(super) fn count(&self) -> usize {
        self.counts.into_iter().map(|count| count as usize).product()
    }

    /// Visits the voxels that a box reaches into, by their numbers and middles.
    #[inline]
    pub(super) fn visit(&self, [low, high]: &[DVec3; 2], visit: &mut impl FnMut(usize, DVec3)) {
        // What rounding may move across a side counts as on both.
        let margin = ROUNDING * 16.0 * (low.abs().max(high.abs())).max_element().max(self.side);
        let place = |at: DVec3| {
            let [x, y, z] = ((at - self.low) * self.density).to_array();
            let [across, down, deep] = self.counts;
            [(x as u32).min(across - 1), (y as u32).min(down - 1), (z as u32).min(deep - 1)]
        };
        let (first, last) = (place(*low - margin), place(*high + margin));
        for z in first[2]..=last[2] {
            for y in first[1]..=last[1] {
                for x in first[0]..=last[0] {
                    let number = (z * self.counts[1] + y) * self.counts[0] + x;
                    let middle = DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + 0.5;
                    visit(number as usize, self.low + middle * self.side);
                }
            }
        }
    }

    /// Visits the classes of planes, in the voxels that a triangle reaches into, to which its plane may
    /// belong. A plane's class tells its sizes along the axes and its distance from the voxel's middle: the
    /// same for both of its sides.
    pub(super) fn visit_planes(&self, facet: &Facet, visit: &mut impl FnMut(u64)) {
        let Facet { corners: [a, b, c], normal, error, tilt } = facet;
        let classes = |value: f64, error: f64, count: f64| {
            let [low, high] = [(value.abs() - error).max(0.0), value.abs() + error];
            (low * count) as u32..=(high * count) as u32
        };
        let [x, y, z] = normal.to_array().map(|value| classes(value, 2.0 * tilt, NORMALS));
        // As far as a voxel's corner is from its middle.
        let reach = self.side * 0.87;
        let off = 2.0 * (error + tilt * reach);
        let bounds = [a.min(*b).min(*c) - *error, a.max(*b).max(*c) + *error];
        self.visit(&bounds, &mut |voxel, middle| {
            let distance = normal.dot(middle - *a);
            if distance.abs() > reach + off {
                return;
            }
            for x in x.clone() {
                for y in y.clone() {
                    for z in z.clone() {
                        let [x, y, z] = [x, y, z].map(u64::from);
                        let normal = ((voxel as u64 * 64 + x) * 64 + y) * 64 + z;
                        let distances = classes(distance, off, DISTANCES * self.density);
                        distances.for_each(|at| visit(normal << 8 | u64::from(at & 0xff)));
                    }
                }
            }
        });
    }
}
