//! Which points lie near a place or along an edge: a k-d tree (Bentley 1975).

use luxel_scene::DVec3;

/// Points in a tree that halves them along one axis after the other.
pub(crate) struct Nearby {
    /// In the order of the tree: the middle of each run divides it.
    points: Vec<(DVec3, u32)>,
}

/// Runs this short are walked through.
const LEAF: usize = 8;

/// So many answers to one question are enough.
pub(crate) const MOST: usize = 256;

impl Nearby {
    /// Takes points with their numbers.
    pub(crate) fn new(mut points: Vec<(DVec3, u32)>) -> Self {
        sort(&mut points, 0);
        Self { points }
    }

    /// The numbers of the points whose distance from the line between two places is at most
    /// `reach`, in order; the first few of them if there are too many.
    pub(crate) fn along(&self, from: DVec3, to: DVec3, reach: f64, found: &mut Vec<u32>) {
        found.clear();
        let low = from.min(to) - reach;
        let high = from.max(to) + reach;
        let way = to - from;
        let squared = way.length_squared();
        let is_near = |point: DVec3| {
            let t = if squared > 0.0 { (point - from).dot(way) / squared } else { 0.0 };
            (from + way * t.clamp(0.0, 1.0)).distance_squared(point) <= reach * reach
        };
        let mut rest = vec![(0, self.points.len(), 0)];
        while let Some((start, end, axis)) = rest.pop() {
            if found.len() >= MOST {
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
            if low[axis] <= point[axis] {
                rest.push((start, middle, next));
            }
            if high[axis] >= point[axis] {
                rest.push((middle + 1, end, next));
            }
        }
        found.sort_unstable();
        found.truncate(MOST);
    }
}

/// Sorts a run into a tree. Equal coordinates are told apart by the points' numbers.
fn sort(points: &mut [(DVec3, u32)], axis: usize) {
    /// Shorter runs are not worth a thread.
    const ALONE: usize = 1 << 14;
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
    if low.len() > ALONE {
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
        // Whole numbers, so that many coordinates are equal.
        (-4..5_i8, -4..5_i8, -4..5_i8)
            .prop_map(|(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)))
    }

    proptest! {
        #[test]
        fn the_tree_finds_what_a_walk_finds(
            points in prop::collection::vec(point(), 0..120),
            from in point(),
            to in point(),
            reach in 0.1..3.0_f64,
        ) {
            let numbered: Vec<_> = points.iter().copied().zip(0_u32..).collect();
            let mut found = Vec::new();
            Nearby::new(numbered).along(from, to, reach, &mut found);
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
