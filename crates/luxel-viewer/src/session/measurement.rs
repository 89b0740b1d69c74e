//! The distance between two points of the scene.

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
                let [x, y, z] = (to - from).to_array().map(format_length);
                format!("distance {} (x {x}, y {y}, z {z})", format_length(from.distance(to)))
            }
        }
    }
}

/// Formats a length to four digits, the precision of points in a picture.
pub(crate) fn format_length(length: f64) -> String {
    if length == 0.0 {
        return "0".to_owned();
    }
    let text = format!("{length:.3e}");
    let exponent = text.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    match exponent {
        Some(exponent @ -3..=5) => format!("{length:.*}", (3 - exponent).max(0) as usize),
        _ => text,
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
        assert_eq!(both.summary(), "distance 5.000 (x 0, y 3.000, z -4.000)");
        assert_eq!(both.with_point(Some(b)), Measurement::From(b));
        assert_eq!(from.with_point(None), Measurement::None);
        assert_eq!(both.with_point(None), Measurement::None);
    }

    #[test]
    fn lengths_have_four_digits_whatever_the_model_s_unit() {
        for (length, text) in [
            (0.0, "0"),
            (0.012_346, "0.01235"),
            (1.0, "1.000"),
            (-98.7654, "-98.77"),
            (4321.2, "4321"),
            (123_456.7, "123457"),
            (2.5e-7, "2.500e-7"),
            (1.5e9, "1.500e9"),
        ] {
            assert_eq!(format_length(length), text);
        }
    }
}
