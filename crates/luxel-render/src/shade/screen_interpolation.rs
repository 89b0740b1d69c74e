//! Interpolation in the window, without perspective: over triangles, or along the edges and rows of
//! polygons.
//!
//! What lies before the near plane is cut off first, linearly in space, as a pipeline of old did;
//! what is left has a place in the window, and everything between is linear there.

use crate::material::Corner;
use glam::DVec3;
use luxel_visibility::WindowRays;

/// A polygon in the window.
#[derive(Clone, Debug)]
pub(crate) struct Outline {
    points: Vec<Point>,
    /// The corners of the polygon before it was cut.
    pub(crate) corners: Vec<Corner>,
    /// Along edges and rows; else over the triangle.
    scan: bool,
}

#[derive(Clone, Debug)]
struct Point {
    x: f64,
    y: f64,
    corner: Corner,
    /// The two corners it lies between, and how far from the first.
    between: ([usize; 2], f32),
}

/// What interpolation at one sample starts from.
#[derive(Clone, Debug)]
pub(crate) struct InWindow {
    pub(crate) corners: [Corner; 3],
    /// At the sample, one pixel to the right and one below: how textures learn what a pixel covers.
    pub(crate) weights: [[f32; 3]; 3],
}

/// Between two points, and how far from the first.
type Along = ([usize; 2], f32);

/// Where a row crosses a polygon about a sample.
struct Row {
    left: Along,
    right: Along,
    x: [f64; 2],
}

impl Row {
    /// How far from left to right.
    fn share(&self, x: f64) -> f32 {
        let [left, right] = self.x;
        if right > left { ((x - left) / (right - left)) as f32 } else { 0.0 }
    }
}

impl Outline {
    /// A polygon by its corners, each with its place in view space.
    pub(crate) fn new(
        rays: &WindowRays,
        near: f64,
        parallel: bool,
        scan: bool,
        corners: &[(DVec3, Corner)],
    ) -> Self {
        let mut points = Vec::with_capacity(corners.len() + 1);
        let mut push = |place: DVec3, corner: Corner, between: ([usize; 2], f32)| {
            if let Some([x, y]) = rays.window(place) {
                points.push(Point { x, y, corner, between });
            }
        };
        let inside = |place: DVec3| parallel || -place.z >= near;
        for (number, &(place, corner)) in corners.iter().enumerate() {
            if inside(place) {
                push(place, corner, ([number; 2], 0.0));
            }
            let next = (number + 1) % corners.len();
            let (other, other_corner) = corners[next];
            if inside(place) != inside(other) {
                let t = (near + place.z) / (place.z - other.z);
                let cut = corner.mixed(&other_corner, t as f32);
                push(place.lerp(other, t), cut, ([number, next], t as f32));
            }
        }
        Self { points, corners: corners.iter().map(|(_, corner)| *corner).collect(), scan }
    }

    /// What interpolation at a position starts from; `None` where nothing is left of the polygon.
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> Option<InWindow> {
        if self.scan { self.row_at(x, y) } else { self.triangle_at(x, y) }
    }

    /// How much each corner of the whole polygon weighs at a position.
    pub(crate) fn corner_weights(&self, [x, y]: [f64; 2]) -> Vec<f32> {
        let mut weights = vec![0.0; self.corners.len()];
        let mut add = |point: usize, weight: f32| {
            let ([from, to], t) = self.points[point].between;
            weights[from] += weight * (1.0 - t);
            weights[to] += weight * t;
        };
        if self.scan {
            if let Some(row) = self.row(y, x) {
                let s = row.share(x).clamp(0.0, 1.0);
                for (([from, to], t), share) in [(row.left, 1.0 - s), (row.right, s)] {
                    add(from, share * (1.0 - t));
                    add(to, share * t);
                }
            }
        } else if let Some((points, weight)) = self.triangle(x, y) {
            for (point, weight) in points.into_iter().zip(weight) {
                add(point, weight);
            }
        }
        weights
    }

    fn triangle_at(&self, x: f64, y: f64) -> Option<InWindow> {
        let (points, weights) = self.triangle(x, y)?;
        let beside = |x: f64, y: f64| self.weights(points, x, y).unwrap_or([1.0, 0.0, 0.0]);
        Some(InWindow {
            corners: points.map(|point| self.points[point].corner),
            weights: [
                weights,
                beside(x + 1.0, y).map(|weight| weight as f32),
                beside(x, y + 1.0).map(|weight| weight as f32),
            ],
        })
    }

    /// The triangle of the fan that holds a position, and its weights there.
    fn triangle(&self, x: f64, y: f64) -> Option<([usize; 3], [f32; 3])> {
        let mut best: Option<(f64, [usize; 3], [f64; 3])> = None;
        for second in 1..self.points.len().saturating_sub(1) {
            let points = [0, second, second + 1];
            let Some(weights) = self.weights(points, x, y) else { continue };
            let least = weights[0].min(weights[1]).min(weights[2]);
            if best.is_none_or(|(most, ..)| least > most) {
                best = Some((least, points, weights));
            }
        }
        // Samples are covered by the snapped triangle and may lie a little outside of this one.
        let (_, points, weights) = best?;
        let weights = weights.map(|weight| weight.max(0.0));
        let sum = weights[0] + weights[1] + weights[2];
        Some((points, weights.map(|weight| (weight / sum) as f32)))
    }

    /// The weights of three points at a position, linear in the window, with the sum 1; `None` if
    /// the points lie on a line.
    fn weights(&self, points: [usize; 3], x: f64, y: f64) -> Option<[f64; 3]> {
        let [a, b, c] = points.map(|point| &self.points[point]);
        let twice = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
            (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
        };
        let [a, b, c] = [[a.x, a.y], [b.x, b.y], [c.x, c.y]];
        let whole = twice(a, b, c);
        let at = [x, y];
        let weights = [twice(at, b, c) / whole, twice(a, at, c) / whole, twice(a, b, at) / whole];
        weights.iter().all(|weight| weight.is_finite()).then_some(weights)
    }

    fn row_at(&self, x: f64, y: f64) -> Option<InWindow> {
        let row = self.row(y, x)?;
        let mixed =
            |([from, to], t): Along| self.points[from].corner.mixed(&self.points[to].corner, t);
        let between = |row: &Row, x: f64| {
            mixed(row.left).mixed(&mixed(row.right), row.share(x).clamp(0.0, 1.0))
        };
        let s = row.share(x).clamp(0.0, 1.0);
        let right = row.share(x + 1.0);
        let below = self.row(y + 1.0, x).map_or_else(|| between(&row, x), |row| between(&row, x));
        Some(InWindow {
            // Left end, right end, and the place below.
            corners: [mixed(row.left), mixed(row.right), below],
            weights: [[1.0 - s, s, 0.0], [1.0 - right, right, 0.0], [0.0, 0.0, 1.0]],
        })
    }

    /// The crossings of a row with the polygon's edges that lie about x, or else nearest to it.
    fn row(&self, y: f64, x: f64) -> Option<Row> {
        let lowest = self.points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
        let highest = self.points.iter().map(|point| point.y).fold(f64::NEG_INFINITY, f64::max);
        if lowest >= highest {
            return None;
        }
        // Rows beyond the ends are taken for the ends; a row along the lowest corner crosses
        // nothing, as edges don't hold their far end.
        let y = y.clamp(lowest, highest - (highest - lowest) * 1e-9);
        let mut crossings: Vec<(f64, Along)> = Vec::new();
        for from in 0..self.points.len() {
            let to = (from + 1) % self.points.len();
            let (p, q) = (&self.points[from], &self.points[to]);
            if (p.y <= y) == (q.y <= y) {
                continue;
            }
            // From the upper end, so that both polygons of an edge do the same.
            let ([upper, lower], p, q) =
                if p.y <= q.y { ([from, to], p, q) } else { ([to, from], q, p) };
            let t = (y - p.y) / (q.y - p.y);
            crossings.push((p.x + (q.x - p.x) * t, ([upper, lower], t as f32)));
        }
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let outside = |[left, right]: [f64; 2]| (left - x).max(x - right).max(0.0);
        let mut best: Option<Row> = None;
        for pair in crossings.chunks_exact(2) {
            let row = Row { left: pair[0].1, right: pair[1].1, x: [pair[0].0, pair[1].0] };
            if best.as_ref().is_none_or(|best| outside(row.x) < outside(best.x)) {
                best = Some(row);
            }
        }
        best
    }
}
