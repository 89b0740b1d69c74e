//! A k-d tree of points (Bentley 1975), for queries along line segments.

use luxel_scene::DVec3;

/// A k-d tree: halves the points along x, y and z in turn.
pub(crate) struct KdTree {
    /// In tree order: the middle of each run divides it.
    points: Vec<(DVec3, u32)>,
}

/// Shorter runs are searched linearly.
const LEAF: usize = 8;

/// More than the rounding of places along a segment, as a fraction of its largest coordinate.
const ROUNDING: f64 = 1e-12;

/// The most results of a query.
pub(crate) const MAX_RESULTS: usize = 256;

impl KdTree {
    /// Builds a tree of points with their ids.
    pub(crate) fn new(mut points: Vec<(DVec3, u32)>) -> Self {
        sort(&mut points, 0);
        Self { points }
    }

    /// Finds the ids of points within `reach` of a line segment, in order; [`MAX_RESULTS`] at most.
    pub(crate) fn along(&self, from: DVec3, to: DVec3, reach: f64, found: &mut Vec<u32>) {
        found.clear();
        let way = to - from;
        let squared = way.length_squared();
        let is_near = |point: DVec3| {
            let t = if squared > 0.0 { (point - from).dot(way) / squared } else { 0.0 };
            (from + way * t.clamp(0.0, 1.0)).distance_squared(point) <= reach * reach
        };
        let margin = reach + ROUNDING * from.abs().max(to.abs()).max_element();
        // Each run with the part of the segment that its points may be near.
        let mut rest = vec![(0, self.points.len(), 0, [0.0, 1.0])];
        while let Some((start, end, axis, part)) = rest.pop() {
            if found.len() >= MAX_RESULTS {
                break;
            }
            if end - start <= LEAF {
                let run = self.points[start..end].iter().filter(|(point, _)| is_near(*point));
                found.extend(run.map(|(_, number)| *number));
                continue;
            }
            let middle = start.midpoint(end);
            let (point, number) = self.points[middle];
            if is_near(point) {
                found.push(number);
            }
            let next = (axis + 1) % 3;
            let (begin, way) = (from[axis] - point[axis], way[axis]);
            if let Some(part) = below(begin, way, margin, part) {
                rest.push((start, middle, next, part));
            }
            if let Some(part) = below(-begin, -way, margin, part) {
                rest.push((middle + 1, end, next, part));
            }
        }
        found.sort_unstable();
        found.truncate(MAX_RESULTS);
    }
}

/// The part of an interval in which `begin` + t `way` is `limit` or less; `None` if there is none.
fn below(begin: f64, way: f64, limit: f64, [first, last]: [f64; 2]) -> Option<[f64; 2]> {
    let crossing = (limit - begin) / way;
    let part = if way > 0.0 {
        [first, last.min(crossing)]
    } else if way < 0.0 {
        [first.max(crossing), last]
    } else if begin <= limit {
        [first, last]
    } else {
        return None;
    };
    (part[0] <= part[1]).then_some(part)
}

/// Sorts a run into tree order. Ids break ties of coordinates.
fn sort(points: &mut [(DVec3, u32)], axis: usize) {
    /// Shorter runs aren't worth a thread.
    const MIN_PARALLEL: usize = 1 << 14;
    if points.len() <= LEAF {
        return;
    }
    let middle = points.len() / 2;
    points.select_nth_unstable_by(middle, |(one, first), (other, second)| {
        one[axis].total_cmp(&other[axis]).then(first.cmp(second))
    });
    let (low, high) = points.split_at_mut(middle);
    let high = &mut high[1..];
    let next = (axis + 1) % 3;
    if low.len() > MIN_PARALLEL {
        luxel_parallel::join(|| sort(low, next), || sort(high, next));
    } else {
        sort(low, next);
        sort(high, next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = DVec3> {
        // Integers, so that many coordinates are equal.
        (-4..5_i8, -4..5_i8, -4..5_i8)
            .prop_map(|(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)))
    }

    proptest! {
        #[test]
        fn the_tree_agrees_with_a_linear_search(
            points in prop::collection::vec(point(), 0..120),
            from in point(),
            to in point(),
            reach in 0.1..3.0_f64,
        ) {
            let numbered: Vec<_> = points.iter().copied().zip(0_u32..).collect();
            let mut found = Vec::new();
            KdTree::new(numbered).along(from, to, reach, &mut found);
            let distance = |point: DVec3| {
                let way = to - from;
                let t = if way == DVec3::ZERO {
                    0.0
                } else {
                    ((point - from).dot(way) / way.dot(way)).clamp(0.0, 1.0)
                };
                (from + way * t - point).length()
            };
            let near = |number: &u32| distance(points[*number as usize]) <= reach;
            let sure = |number: &u32| (distance(points[*number as usize]) - reach).abs() > 1e-9;
            let expected: Vec<u32> = (0..points.len() as u32).filter(near).filter(sure).collect();
            found.retain(|number| sure(number));
            prop_assert_eq!(found, expected);
        }
    }
}
