//! Matrices of many copies of a mesh, which are turned and scaled alike.

use glam::{DMat4, DVec4};
use std::sync::Arc;

/// A matrix that shares its first three columns, the axes, with others: of a million copies of a mesh, all turned and
/// scaled alike, each keeps its last column alone: 40 bytes with the pointer instead of 128.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedAxes {
    axes: Arc<[DVec4; 3]>,
    origin: DVec4,
}

impl SharedAxes {
    /// The bytes that axes of its own take, beside its own size.
    pub const BYTES: usize = size_of::<[DVec4; 3]>() + 2 * size_of::<usize>();

    /// A matrix with axes of its own.
    #[must_use]
    pub fn new(matrix: &DMat4) -> Self {
        let DMat4 { x_axis, y_axis, z_axis, w_axis } = *matrix;
        Self { axes: Arc::new([x_axis, y_axis, z_axis]), origin: w_axis }
    }

    /// The same matrix, with the axes of another if these have the same bits.
    #[must_use]
    pub fn sharing(mut self, other: &Self) -> Self {
        if self.has_axes_of(other) {
            self.axes = Arc::clone(&other.axes);
        }
        self
    }

    /// Whether its axes have the same bits as another one's.
    #[must_use]
    pub fn has_axes_of(&self, other: &Self) -> bool {
        let bits = |axes: &[DVec4; 3]| axes.map(|axis| axis.to_array().map(f64::to_bits));
        Arc::ptr_eq(&self.axes, &other.axes) || bits(&self.axes) == bits(&other.axes)
    }

    /// Whether both keep their axes in one place.
    #[cfg(test)]
    pub(crate) fn shares_axes_with(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.axes, &other.axes)
    }

    /// The matrix.
    #[inline]
    #[must_use]
    pub fn matrix(&self) -> DMat4 {
        let [x_axis, y_axis, z_axis] = *self.axes;
        DMat4::from_cols(x_axis, y_axis, z_axis, self.origin)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn copies_that_are_turned_alike_share_axes_and_others_keep_their_own_bits() {
        let turned = DMat4::from_rotation_y(0.3);
        let moved = DMat4::from_translation(DVec3::new(1.0, 2.0, 3.0)) * turned;
        let first = SharedAxes::new(&turned);
        let second = SharedAxes::new(&moved).sharing(&first);
        assert!(second.shares_axes_with(&first));
        assert_eq!(second.matrix(), moved);

        let mut negative_zero = moved;
        negative_zero.x_axis.y = -0.0;
        let third = SharedAxes::new(&negative_zero).sharing(&second);
        assert!(!third.shares_axes_with(&first));
        assert!(third.matrix().x_axis.y.is_sign_negative());
    }
}
