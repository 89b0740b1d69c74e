//! The distance between two points of the scene.

use crate::number::number;
use luxel::scene::DVec3;

/// The chosen points, in world space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Measurement {
    #[default]
    None,
    /// The first point.
    From(DVec3),
    /// Both points.
    Between([DVec3; 2]),
}

impl Measurement {
    /// Adds a point. A third point starts again; `None`, the background, ends the measurement.
    pub(crate) fn with_point(self, point: Option<DVec3>) -> Self {
        match (self, point) {
            (_, None) => Self::None,
            (Self::From(from), Some(to)) => Self::Between([from, to]),
            (_, Some(from)) => Self::From(from),
        }
    }

    /// The distance, and its components along the axes, in the model's unit.
    pub(crate) fn summary(self) -> String {
        match self {
            Self::None => "nothing is measured".to_owned(),
            Self::From(_) => "r again: to where it is measured".to_owned(),
            Self::Between([from, to]) => {
                let [x, y, z] = (to - from).to_array().map(number);
                format!("distance {} (x {x}, y {y}, z {z})", number(from.distance(to)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_points_are_measured_a_third_starts_again_the_background_ends() {
        let [a, b] = [DVec3::new(1.0, 0.0, 0.0), DVec3::new(1.0, 3.0, -4.0)];
        let from = Measurement::default().with_point(Some(a));
        let both = from.with_point(Some(b));
        assert_eq!((from, both), (Measurement::From(a), Measurement::Between([a, b])));
        assert_eq!(both.summary(), "distance 5 (x 0, y 3, z -4)");
        assert_eq!(both.with_point(Some(b)), Measurement::From(b));
        assert_eq!(from.with_point(None), Measurement::None);
        assert_eq!(both.with_point(None), Measurement::None);
    }
}
