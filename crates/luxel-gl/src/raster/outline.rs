//! The part of a smooth polygon in each pixel (OpenGL 1.5, section 3.5), and which of its triangles colours the pixel.

use super::smooth::{HALF_DIAGONAL, area, cut};
use luxel_math::SUBPIXELS;
use luxel_visibility::WindowVertex;

/// The most corners of an outline; pixels are compared with all of its edges.
const MOST_CORNERS: usize = 256;

/// A step of the grid that corners are rounded to, in pixels.
const STEP: f64 = 1.0 / SUBPIXELS as f64;

/// A convex outline, filled by triangles about one of its corners. In pixels of the window, counter-clockwise.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    about: [f64; 2],
    /// The other two corners of each triangle, in order.
    triangles: Vec<[[f64; 2]; 2]>,
    /// The edges' ends.
    hull: Vec<[f64; 2]>,
}

/// Twice the area of a triangle, positive where it runs counter-clockwise.
fn doubled_area(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (b[0] - a[0]).hypot(b[1] - a[1])
}

/// The edges of a polygon.
fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    corners.iter().zip(corners.iter().cycle().skip(1)).map(|(from, to)| [*from, *to])
}

/// How far to the left of an edge a place lies.
fn to_the_left([from, to]: [[f64; 2]; 2], place: [f64; 2]) -> f64 {
    doubled_area(from, to, place) / distance(from, to)
}

/// The place of an edge that is the nearest.
fn nearest([from, to]: [[f64; 2]; 2], place: [f64; 2]) -> [f64; 2] {
    let way = [to[0] - from[0], to[1] - from[1]];
    let along = (place[0] - from[0]) * way[0] + (place[1] - from[1]) * way[1];
    let part = (along / (way[0] * way[0] + way[1] * way[1])).clamp(0.0, 1.0);
    [from[0] + way[0] * part, from[1] + way[1] * part]
}

/// The smallest convex polygon about places, counter-clockwise, by Andrew's monotone chain (1979).
fn convex_hull(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    places.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    places.dedup();
    let mut hull: Vec<[f64; 2]> = Vec::new();
    let mut chain = |places: &mut dyn Iterator<Item = [f64; 2]>| {
        let first = hull.len();
        for place in places {
            while let [.., a, b] = hull[first..]
                && doubled_area(a, b, place) <= 0.0
            {
                hull.pop();
            }
            hull.push(place);
        }
        // The other chain begins there.
        hull.pop();
    };
    chain(&mut places.iter().copied());
    chain(&mut places.iter().rev().copied());
    hull
}

impl Outline {
    /// The outline of a polygon that is filled by triangles about its first corner, with the numbers of those that have an
    /// area; `None` unless it is convex but for rounding, or if it has too many corners.
    pub(super) fn new(window: &[WindowVertex]) -> Option<(Self, Vec<usize>)> {
        if !(3..=MOST_CORNERS).contains(&window.len()) {
            return None;
        }
        let pixels = |place: &WindowVertex| [f64::from(place.x) * STEP, f64::from(place.y) * STEP];
        let corners: Vec<[f64; 2]> = window.iter().map(pixels).collect();
        let signed = area(&corners);
        let hull = convex_hull(corners.clone());
        let length: f64 = edges(&corners).map(|[from, to]| distance(from, to)).sum();
        // Rounding moves a corner by 0.7 of a step at most, and so it does edges.
        if hull.len() < 3 || area(&hull) - signed.abs() > length * STEP {
            return None;
        }
        let mut triangles: Vec<(usize, [[f64; 2]; 2])> = (1..corners.len() - 1)
            .map(|number| (number - 1, [corners[number], corners[number + 1]]))
            .collect();
        if signed < 0.0 {
            triangles.reverse();
            triangles.iter_mut().for_each(|(_, ends)| ends.reverse());
        }
        let about = corners[0];
        triangles.retain(|(_, [from, to])| doubled_area(about, *from, *to) > 0.0);
        let (numbers, triangles) = triangles.into_iter().unzip();
        Some((Self { about, triangles, hull }, numbers))
    }

    /// The part of a pixel that it covers, if the triangle at a place of the list colours that: one of them does.
    pub(super) fn coverage(&self, triangle: usize, pixel: [i32; 2]) -> Option<f64> {
        let [x, y] = pixel.map(f64::from);
        let middle = [x + 0.5, y + 0.5];
        let [from, to] = self.triangles[triangle];
        // Rounding may put the triangle's corners a step outside.
        let reach = HALF_DIAGONAL + 2.0 * STEP;
        if edges(&[self.about, from, to]).any(|edge| to_the_left(edge, middle) < -reach) {
            return None;
        }
        let mut place = middle;
        let mut least = f64::INFINITY;
        let mut is_whole = true;
        for edge in edges(&self.hull) {
            let left = to_the_left(edge, middle);
            if left <= -HALF_DIAGONAL {
                return None;
            }
            is_whole &= left >= HALF_DIAGONAL;
            if left < 0.0 {
                let on_edge = nearest(edge, middle);
                let away = distance(on_edge, middle);
                if away < least {
                    (place, least) = (on_edge, away);
                }
            }
        }
        // The first that has the nearest place of the polygon on its side of the diagonal; the last has all the rest.
        let has = |[_, to]: &[[f64; 2]; 2]| doubled_area(self.about, *to, place) < 0.0;
        let last = self.triangles.len() - 1;
        if self.triangles[..last].iter().position(has).unwrap_or(last) != triangle {
            return None;
        }
        if is_whole {
            return Some(1.0);
        }
        let mut part = vec![[x, y], [x + 1.0, y], [x + 1.0, y + 1.0], [x, y + 1.0]];
        part.resize(self.hull.len() + 4, [0.0; 2]);
        let mut spare = part.clone();
        let mut count = 4;
        for edge in edges(&self.hull) {
            if to_the_left(edge, middle) < HALF_DIAGONAL {
                count = cut(&mut part, &mut spare, count, |place| to_the_left(edge, place));
            }
        }
        let part = area(&part[..count]).clamp(0.0, 1.0);
        (part > 0.0).then_some(part)
    }

    /// Pixels that a triangle may colour: left, bottom, right, top, the last two beyond.
    pub(super) fn bounds(&self, triangle: usize) -> [i32; 4] {
        let [from, to] = self.triangles[triangle];
        let range = |axis: usize| {
            let [a, b, c] = [self.about, from, to].map(|corner| corner[axis]);
            let (low, high) = (a.min(b).min(c) - 1.0, a.max(b).max(c) + 1.0);
            [low.floor() as i32, high.floor() as i32 + 1]
        };
        let ([left, right], [bottom, top]) = (range(0), range(1));
        [left, bottom, right, top]
    }

    /// Bytes that it takes.
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self)
            + size_of_val(self.triangles.as_slice())
            + size_of_val(self.hull.as_slice())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn outline(places: &[[i32; 2]]) -> Option<(Outline, Vec<usize>)> {
        let window: Vec<_> = places.iter().map(|&[x, y]| WindowVertex { x, y, z: 0.0 }).collect();
        Outline::new(&window)
    }

    /// The sum of the parts of all pixels, each of which one triangle colours.
    fn summed(outline: &Outline) -> f64 {
        let mut colored = std::collections::HashMap::new();
        for triangle in 0..outline.triangles.len() {
            let [left, bottom, right, top] = outline.bounds(triangle);
            for pixel in (bottom..top).flat_map(|y| (left..right).map(move |x| [x, y])) {
                if let Some(part) = outline.coverage(triangle, pixel) {
                    assert!(colored.insert(pixel, part).is_none(), "two triangles at {pixel:?}");
                }
            }
        }
        colored.values().sum()
    }

    proptest! {
        #[test]
        fn section_3_5_the_parts_of_all_pixels_are_the_area(
            places in proptest::collection::vec([0..4096_i32, 0..4096_i32], 3..5),
        ) {
            let Some((outline, _)) = outline(&places) else { return Ok(()) };
            let (sum, expected) = (summed(&outline), area(&outline.hull));
            prop_assert!((sum - expected).abs() < 1e-6, "{} of {}", sum, expected);
        }

        #[test]
        fn circles_of_many_corners_lose_parts(count in 5..200_usize, radius in 3.0..20.0_f64, turned in any::<bool>()) {
            let mut places: Vec<[i32; 2]> = (0..count)
                .map(|number| {
                    let (sine, cosine) = libm::sincos(number as f64 / count as f64 * std::f64::consts::TAU);
                    [cosine, sine].map(|of| ((24.0 + radius * of) * 256.0).round() as i32)
                })
                .collect();
            if turned {
                places.reverse();
            }
            let (outline, _) = outline(&places).unwrap();
            let (sum, expected) = (summed(&outline), area(&outline.hull));
            prop_assert!((sum - expected).abs() < 1e-6, "{} of {}", sum, expected);
        }
    }

    #[test]
    fn stars_and_dents_have_outlines() {
        let pentagon = [[1000, 0], [310, 950], [-810, 590], [-810, -590], [310, -950]];
        assert!(outline(&pentagon).is_some());
        let star = [0, 2, 4, 1, 3].map(|at: usize| pentagon[at]);
        assert!(outline(&star).is_none());
        assert!(outline(&[[0, 0], [1000, 0], [200, 200], [0, 1000]]).is_none());
        assert!(outline(&[[0, 0], [100, 0], [200, 0]]).is_none());
        assert!(outline(&[[0, 0], [1000, 1000], [1000, 0], [0, 1000]]).is_none());
    }

    #[test]
    fn corners_on_edges_are_dents() {
        // A step inside of the square's lower edge; the triangle there has no area.
        let (outline, numbers) =
            outline(&[[0, 0], [500, 1], [1024, 0], [1024, 1024], [0, 1024]]).unwrap();
        assert_eq!(numbers, [1, 2]);
        assert!((summed(&outline) - 16.0).abs() < 1e-6);
    }
}
