//! Rigid motions, orthonormalised after each composition.

use glam::{DMat3, DMat4, DVec3};

/// A rotation followed by a translation; for a camera, from world to camera space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rigid {
    pub(crate) rotation: DMat3,
    pub(crate) translation: DVec3,
}

impl Rigid {
    /// The motion of a matrix, without orthonormalisation.
    pub(crate) fn from_matrix(matrix: &DMat4) -> Self {
        Self { rotation: DMat3::from_mat4(*matrix), translation: matrix.w_axis.truncate() }
    }

    /// The matrix, column by column.
    pub(crate) fn to_matrix(self) -> DMat4 {
        let [x, y, z] = [self.rotation.x_axis, self.rotation.y_axis, self.rotation.z_axis];
        DMat4::from_cols(x.extend(0.0), y.extend(0.0), z.extend(0.0), self.translation.extend(1.0))
    }

    pub(crate) fn shift(translation: DVec3) -> Self {
        Self { rotation: DMat3::IDENTITY, translation }
    }

    /// A rotation about an axis through a point; the vector's length is the angle in radians.
    pub(crate) fn turn_about(turn: DVec3, centre: DVec3) -> Self {
        let rotation = rotation(turn);
        Self { rotation, translation: centre - rotation * centre }
    }

    /// The motion at constant angular and linear velocity over unit time: the exponential of a twist.
    ///
    /// A body that turns with the angular velocity w and moves with the velocity v, both in its
    /// *own* axes, is afterwards at exp(w), V v with V = I + B K + C K^2, where K v = w x v, t = |w|,
    /// B = (1 - cos t) / t^2, C = (t - sin t) / t^3 (Murray, Li and Sastry 1994, A Mathematical
    /// Introduction to Robotic Manipulation, proposition 2.9). Two half
    /// steps give the same as a whole one, so that motion doesn't depend on the frame rate.
    pub(crate) fn screw(turn: DVec3, shift: DVec3) -> Self {
        let [_, b, c] = coefficients(turn.dot(turn));
        let once = turn.cross(shift);
        Self { rotation: rotation(turn), translation: shift + once * b + turn.cross(once) * c }
    }

    /// The composition `next * self`, orthonormalised.
    pub(crate) fn then(self, next: Self) -> Self {
        Self {
            rotation: orthonormal(next.rotation * self.rotation),
            translation: next.rotation * self.translation + next.translation,
        }
    }

    pub(crate) fn apply(&self, point: DVec3) -> DVec3 {
        self.rotation * point + self.translation
    }

    /// The inverse motion of a point.
    pub(crate) fn undo(&self, point: DVec3) -> DVec3 {
        self.rotation.transpose() * (point - self.translation)
    }

    /// The eye of a camera.
    pub(crate) fn eye(&self) -> DVec3 {
        self.undo(DVec3::ZERO)
    }

    /// The view direction of a camera in world space.
    pub(crate) fn direction(&self) -> DVec3 {
        -self.rotation.row(2)
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.rotation.is_finite() && self.translation.is_finite()
    }
}

/// The rotation about an axis by the right-hand rule; the vector's length is the angle.
/// Rodrigues: I + A K + B K^2, with K v = turn x v.
pub(crate) fn rotation(turn: DVec3) -> DMat3 {
    let [a, b, _] = coefficients(turn.dot(turn));
    let column = |axis: DVec3| {
        let once = turn.cross(axis);
        axis + once * a + turn.cross(once) * b
    };
    DMat3::from_cols(column(DVec3::X), column(DVec3::Y), column(DVec3::Z))
}

/// sin t / t, (1 - cos t) / t^2 and (t - sin t) / t^3 for t^2.
fn coefficients(squared: f64) -> [f64; 3] {
    /// Below this, the closed forms cancel, and the series is exact.
    const SMALL: f64 = 1e-2;
    if squared < SMALL {
        // The first omitted term is below 1e-17 of the sum.
        let series = |first: f64, factors: [f64; 4]| {
            factors.iter().rev().fold(1.0, |sum, factor| 1.0 - squared * sum / factor) * first
        };
        [
            series(1.0, [6.0, 20.0, 42.0, 72.0]),
            series(0.5, [12.0, 30.0, 56.0, 90.0]),
            series(1.0 / 6.0, [20.0, 42.0, 72.0, 110.0]),
        ]
    } else {
        let angle = squared.sqrt();
        let (sine, half_sine) = (libm::sin(angle), libm::sin(angle * 0.5));
        // 1 - cos t = 2 sin^2(t/2) doesn't cancel.
        [sine / angle, 2.0 * half_sine * half_sine / squared, (angle - sine) / (squared * angle)]
    }
}

/// The rotation nearest to a matrix with rounding errors: one Newton step of the polar
/// decomposition, R (3 I - R^T R) / 2 (Higham 1986, Computing the Polar Decomposition). It squares
/// the deviation, favours no axis, and leaves exact rotations unchanged.
fn orthonormal(matrix: DMat3) -> DMat3 {
    matrix * (DMat3::IDENTITY * 3.0 - matrix.transpose() * matrix) * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn series_and_closed_forms_agree_at_the_threshold() {
        for squared in [0.009_999, 0.01, 0.010_001] {
            let t: f64 = f64::sqrt(squared);
            let [a, b, c] = coefficients(squared);
            assert!((a - libm::sin(t) / t).abs() < 1e-15);
            assert!((b - (1.0 - libm::cos(t)) / squared).abs() < 1e-13);
            assert!((c - (t - libm::sin(t)) / (t * squared)).abs() < 1e-12);
        }
    }

    #[test]
    fn a_quarter_turn_about_z_takes_x_to_y() {
        let quarter = rotation(DVec3::Z * std::f64::consts::FRAC_PI_2);
        assert!((quarter * DVec3::X).abs_diff_eq(DVec3::Y, 1e-15));
        let about = Rigid::turn_about(DVec3::Z * std::f64::consts::FRAC_PI_2, DVec3::X);
        assert!(about.apply(DVec3::ZERO).abs_diff_eq(DVec3::new(1.0, -1.0, 0.0), 1e-15));
    }

    #[test]
    fn a_constant_turn_while_moving_ahead_is_a_circle() {
        // Moving ahead along x by pi / 2 while turning left by a quarter: a quarter of a circle of
        // radius 1, which ends at (1, 1).
        let quarter = std::f64::consts::FRAC_PI_2;
        let end = Rigid::screw(DVec3::Z * quarter, DVec3::X * quarter);
        assert!(end.translation.abs_diff_eq(DVec3::new(1.0, 1.0, 0.0), 1e-15), "{end:?}");
    }
}
