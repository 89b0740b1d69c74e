//! Regions of the window: rectangles and polygons.
//!
//! Polygons may be concave and cross themselves; the even-odd rule decides their inside. They are
//! decomposed into trapezoids between the heights of corners and crossings, so that all queries work on
//! convex pieces.

use crate::window::PhysicalPosition;

/// A part of the window, in pixels from the upper left.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    pieces: Vec<Piece>,
    /// The polygon's corners; empty for a rectangle.
    outline: Vec<[f64; 2]>,
    /// Left, top, right, bottom.
    bounds: [f64; 4],
}

/// A convex piece: a x + b y + c >= 0 for each side.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Piece {
    pub(crate) sides: [[f64; 3]; 4],
    /// Left, top, right, bottom.
    pub(crate) bounds: [f64; 4],
}

/// Why a region is invalid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum RegionError {
    /// A coordinate isn't finite.
    #[error("a region of the window has finite coordinates")]
    NotFinite,
    /// A rectangle's size isn't positive.
    #[error("a rectangle's width and height are above 0")]
    Empty,
    /// A polygon has fewer than three corners, or too many.
    #[error("a polygon has 3 to {MAX_CORNERS} corners, not {0}")]
    Corners(usize),
}

/// The most corners of a polygon; crossings are searched pair by pair.
pub const MAX_CORNERS: usize = 4096;

impl Region {
    /// A rectangle, by upper left corner and size.
    ///
    /// # Errors
    /// [`RegionError`] if a number isn't finite or the size isn't above 0.
    pub fn rectangle(x: f64, y: f64, width: f64, height: f64) -> Result<Self, RegionError> {
        let bounds = [x, y, x + width, y + height];
        if !bounds.iter().all(|bound| bound.is_finite()) {
            return Err(RegionError::NotFinite);
        }
        if width <= 0.0 || height <= 0.0 {
            return Err(RegionError::Empty);
        }
        let sides =
            [[1.0, 0.0, -x], [-1.0, 0.0, bounds[2]], [0.0, 1.0, -y], [0.0, -1.0, bounds[3]]];
        Ok(Self { pieces: vec![Piece { sides, bounds }], outline: Vec::new(), bounds })
    }

    /// The rectangle between two corners of a rubber band; at least one pixel each way, so that a click is
    /// a rectangle, too.
    ///
    /// # Errors
    /// [`RegionError::NotFinite`]
    pub fn between(a: PhysicalPosition, b: PhysicalPosition) -> Result<Self, RegionError> {
        let side = |a: f64, b: f64| (a - b).abs().max(1.0);
        Self::rectangle(a.x.min(b.x), a.y.min(b.y), side(a.x, b.x), side(a.y, b.y))
    }

    /// A polygon, by its corners; the last connects to the first.
    ///
    /// # Errors
    /// [`RegionError`] if a number isn't finite or there are too few or too many corners.
    pub fn polygon<P: Into<PhysicalPosition> + Copy>(corners: &[P]) -> Result<Self, RegionError> {
        if !(3..=MAX_CORNERS).contains(&corners.len()) {
            return Err(RegionError::Corners(corners.len()));
        }
        let corners: Vec<[f64; 2]> =
            corners.iter().map(|&corner| corner.into().to_array()).collect();
        if !corners.as_flattened().iter().all(|number| number.is_finite()) {
            return Err(RegionError::NotFinite);
        }
        let mut bounds = [corners[0][0], corners[0][1], corners[0][0], corners[0][1]];
        for &[x, y] in &corners {
            bounds = [bounds[0].min(x), bounds[1].min(y), bounds[2].max(x), bounds[3].max(y)];
        }
        Ok(Self { pieces: trapezoids(&corners), outline: corners, bounds })
    }

    /// Left, top, right, bottom.
    #[must_use]
    pub fn bounds(&self) -> [f64; 4] {
        self.bounds
    }

    /// Whether a position lies inside. Left and top sides of a rectangle are inside, right and bottom
    /// ones outside, so that adjacent rectangles share no pixel.
    #[must_use]
    pub fn contains(&self, x: f64, y: f64) -> bool {
        let [left, top, right, bottom] = self.bounds;
        if self.outline.is_empty() {
            return left <= x && x < right && top <= y && y < bottom;
        }
        let mut inside = false;
        for [[px, py], [qx, qy]] in edges(&self.outline) {
            if (py > y) != (qy > y) && x < px + (qx - px) * ((y - py) / (qy - py)) {
                inside = !inside;
            }
        }
        inside
    }

    pub(crate) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// The bounding box of all pieces, as a piece.
    pub(crate) fn hull(&self) -> Piece {
        let [left, top, right, bottom] = self.bounds;
        let sides = [[1.0, 0.0, -left], [-1.0, 0.0, right], [0.0, 1.0, -top], [0.0, -1.0, bottom]];
        Piece { sides, bounds: self.bounds }
    }

    /// Whether a convex polygon lies entirely inside.
    pub(crate) fn encloses(&self, polygon: &[[f64; 2]]) -> bool {
        let [left, top, right, bottom] = self.bounds;
        let boxed = |&[x, y]: &[f64; 2]| left <= x && x <= right && top <= y && y <= bottom;
        if !polygon.iter().all(boxed) {
            return false;
        }
        if self.outline.is_empty() {
            return true;
        }
        let crosses = |a: [[f64; 2]; 2]| edges(&self.outline).any(|b| crossing(a, b).is_some());
        let holds_corner = || {
            self.outline.iter().any(|&corner| {
                let side = |[p, q]: [[f64; 2]; 2]| {
                    (q[0] - p[0]) * (corner[1] - p[1]) - (q[1] - p[1]) * (corner[0] - p[0])
                };
                let sides: Vec<f64> = edges(polygon).map(side).collect();
                sides.iter().all(|side| *side > 0.0) || sides.iter().all(|side| *side < 0.0)
            })
        };
        polygon.iter().all(|&[x, y]| self.contains(x, y))
            && !edges(polygon).any(crosses)
            && !holds_corner()
    }
}

/// The edges of a closed polygon.
fn edges(corners: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> + '_ {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(&p, &q)| [p, q])
}

/// The y at which two edges cross between their ends.
fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> Option<f64> {
    let (ab, cd) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let cross = ab[0] * cd[1] - ab[1] * cd[0];
    let ac = [c[0] - a[0], c[1] - a[1]];
    let (s, t) = ((ac[0] * cd[1] - ac[1] * cd[0]) / cross, (ac[0] * ab[1] - ac[1] * ab[0]) / cross);
    let between = |at: f64| at > 0.0 && at < 1.0;
    (between(s) && between(t)).then(|| a[1] + ab[1] * s)
}

/// Decomposes a polygon into trapezoids between the heights of its corners and crossings.
fn trapezoids(corners: &[[f64; 2]]) -> Vec<Piece> {
    let all: Vec<[[f64; 2]; 2]> = edges(corners).collect();
    let mut heights: Vec<f64> = corners.iter().map(|corner| corner[1]).collect();
    for (place, &a) in all.iter().enumerate() {
        heights.extend(all[place + 1..].iter().filter_map(|&b| crossing(a, b)));
    }
    heights.sort_by(f64::total_cmp);
    heights.dedup();
    let mut pieces = Vec::new();
    for band in heights.windows(2) {
        let (top, bottom) = (band[0], band[1]);
        let middle = top + (bottom - top) * 0.5;
        let at =
            |[p, q]: [[f64; 2]; 2], y: f64| p[0] + (q[0] - p[0]) * ((y - p[1]) / (q[1] - p[1]));
        let mut crossed: Vec<(f64, [[f64; 2]; 2])> = all
            .iter()
            .filter(|[p, q]| (p[1] > middle) != (q[1] > middle))
            .map(|&edge| (at(edge, middle), edge))
            .collect();
        crossed.sort_by(|a, b| a.0.total_cmp(&b.0));
        for pair in crossed.chunks_exact(2) {
            let (left, right) = (pair[0].1, pair[1].1);
            // To the right of the left edge, to the left of the right one.
            let side = |edge: [[f64; 2]; 2], sign: f64| {
                let [upper, lower] =
                    if edge[0][1] < edge[1][1] { edge } else { [edge[1], edge[0]] };
                let (dx, dy) = (lower[0] - upper[0], lower[1] - upper[1]);
                [sign * dy, -sign * dx, sign * (dx * upper[1] - dy * upper[0])]
            };
            let sides = [side(left, 1.0), side(right, -1.0), [0.0, 1.0, -top], [0.0, -1.0, bottom]];
            let bounds = [
                at(left, top).min(at(left, bottom)),
                top,
                at(right, top).max(at(right, bottom)),
                bottom,
            ];
            pieces.push(Piece { sides, bounds });
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn inside(piece: &Piece, [x, y]: [f64; 2]) -> bool {
        piece.sides.iter().all(|[a, b, c]| a * x + b * y + c >= 0.0)
    }

    proptest! {
        #[test]
        fn trapezoids_cover_the_polygon(
            corners in prop::collection::vec(prop::array::uniform2(0.0..100.0), 3..12),
            at in prop::array::uniform2(0.0..100.0),
        ) {
            let region = Region::polygon(&corners).unwrap();
            let pieces = region.pieces().iter().filter(|piece| inside(piece, at)).count();
            prop_assert_eq!(pieces > 0, region.contains(at[0], at[1]));
        }
    }

    #[test]
    fn a_triangle_around_a_corner_of_the_outline_is_not_enclosed() {
        let notched =
            Region::polygon(&[[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [5.0, 4.0], [0.0, 10.0]])
                .unwrap();
        assert!(notched.encloses(&[[1.0, 1.0], [9.0, 1.0], [5.0, 3.0]]));
        assert!(!notched.encloses(&[[1.0, 1.0], [9.0, 1.0], [5.0, 4.5]]));
        assert!(!notched.encloses(&[[1.0, 7.0], [9.0, 7.0], [5.0, 1.0]]));
    }

    #[test]
    fn invalid_regions_are_refused() {
        assert_eq!(Region::rectangle(0.0, 0.0, 0.0, 1.0), Err(RegionError::Empty));
        assert_eq!(Region::rectangle(f64::NAN, 0.0, 1.0, 1.0), Err(RegionError::NotFinite));
        assert_eq!(Region::polygon(&[[0.0; 2]; 2]), Err(RegionError::Corners(2)));
    }
}
