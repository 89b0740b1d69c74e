//! Values of curves and surfaces (OpenGL 1.5, section 5.1): p(u) = sum B_i^n(u) R_i, by de Casteljau's steps, which give
//! the derivative with it.

use crate::state::evaluator::Map;

/// A vector that points are mixed in.
type Point = [f64; 4];

fn mix(a: Point, b: Point, t: f64) -> Point {
    std::array::from_fn(|axis| a[axis] * (1.0 - t) + b[axis] * t)
}

/// Value and derivative of the curve of control points.
fn curve(points: &mut [Point], t: f64) -> (Point, Point) {
    let mut count = points.len();
    let degree = count.saturating_sub(1) as f64;
    let mut slope = [0.0; 4];
    while count > 1 {
        if count == 2 {
            slope = std::array::from_fn(|axis| degree * (points[1][axis] - points[0][axis]));
        }
        count -= 1;
        for at in 0..count {
            points[at] = mix(points[at], points[at + 1], t);
        }
    }
    (points.first().copied().unwrap_or_default(), slope)
}

/// Where a coordinate lies in a domain, from 0 to 1 within.
fn within([from, to]: [f64; 2], at: f64) -> f64 {
    (at - from) / (to - from)
}

/// The value of a curve.
pub(crate) fn value_1(map: &Map, u: f64) -> Point {
    curve(&mut map.points.clone(), within(map.domain[0], u)).0
}

/// The value of a surface, and its derivatives by u and by v over the whole domain.
pub(crate) fn value_2(map: &Map, [u, v]: [f64; 2]) -> (Point, [Point; 2]) {
    let [u, v] = [within(map.domain[0], u), within(map.domain[1], v)];
    let (mut values, mut slopes) = (Vec::new(), Vec::new());
    for row in map.points.chunks(map.order[1].max(1)) {
        let (value, slope) = curve(&mut row.to_vec(), v);
        values.push(value);
        slopes.push(slope);
    }
    let (value, by_u) = curve(&mut values, u);
    let (by_v, _) = curve(&mut slopes, u);
    (value, [by_u, by_v])
}

/// The unit normal of a surface of points in homogeneous coordinates: dp/du x dp/dv. As a domain that runs backwards
/// turns a derivative, so it turns the normal.
pub(crate) fn normal(value: Point, [by_u, by_v]: [Point; 2], domain: [[f64; 2]; 2]) -> [f32; 3] {
    let w = value[3];
    // (p / w)' = (p' w - p w') / w^2, of which the length doesn't count.
    let direction = |slope: Point| -> glam::DVec3 {
        let of = |axis: usize| slope[axis] * w - value[axis] * slope[3];
        glam::DVec3::new(of(0), of(1), of(2))
    };
    let sign = domain.iter().fold(1.0, |sign, [from, to]| if to < from { -sign } else { sign });
    let normal = direction(by_u).cross(direction(by_v)) * sign;
    normal.normalize_or_zero().as_vec3().to_array()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(order: [usize; 2], points: Vec<Point>) -> Map {
        Map { order, domain: [[0.0, 2.0], [1.0, 3.0]], points }
    }

    #[test]
    fn section_5_1_a_curve_is_the_sum_of_bernstein_polynomials() {
        let points = vec![
            [0.0, 0.0, 0.0, 1.0],
            [1.0, 2.0, 0.0, 1.0],
            [3.0, 2.0, 5.0, 1.0],
            [4.0, 0.0, 1.0, 1.0],
        ];
        let curve = map([4, 1], points.clone());
        for step in 0..=10 {
            let t = f64::from(step) / 10.0;
            let weights = [
                (1.0 - t) * (1.0 - t) * (1.0 - t),
                3.0 * t * (1.0 - t) * (1.0 - t),
                3.0 * t * t * (1.0 - t),
                t * t * t,
            ];
            let value = value_1(&curve, 2.0 * t);
            for axis in 0..4 {
                let expected: f64 =
                    points.iter().zip(weights).map(|(point, weight)| point[axis] * weight).sum();
                assert!((value[axis] - expected).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn section_5_1_the_normal_of_a_surface_is_that_of_its_tangents() {
        // z = x y over (0..2) x (1..3), as control points of degree 1.
        let corner = |x: f64, y: f64| [x, y, x * y, 1.0];
        let points = vec![corner(0.0, 1.0), corner(0.0, 3.0), corner(2.0, 1.0), corner(2.0, 3.0)];
        let surface = map([2, 2], points);
        let (value, slopes) = value_2(&surface, [1.5, 2.0]);
        assert_eq!(value, [1.5, 2.0, 3.0, 1.0]);
        let [x, y, z] = normal(value, slopes, surface.domain).map(f64::from);
        let length = (2.0_f64 * 2.0 + 1.5 * 1.5 + 1.0).sqrt();
        for (value, expected) in [(x, -2.0), (y, -1.5), (z, 1.0)] {
            assert!((value - expected / length).abs() < 1e-6);
        }
    }
}
