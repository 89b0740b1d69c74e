//! Matrices that nodes and objects share.

use crate::SharedAxes;
use glam::DMat4;
use std::sync::{Arc, LazyLock};

/// A matrix whose copies take one place in memory. Those that turn and scale alike may also share their
/// [axes](SharedAxes), as copies of a mesh side by side do.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(from = "DMat4", into = "DMat4"))]
pub struct SharedMatrix(Arc<SharedAxes>);

/// The place of most nodes.
static IDENTITY: LazyLock<SharedMatrix> =
    LazyLock::new(|| SharedMatrix(Arc::new(SharedAxes::new(&DMat4::IDENTITY))));

impl SharedMatrix {
    /// The bytes that a matrix of its own takes whose axes are shared.
    pub const BYTES: usize = size_of::<SharedAxes>() + 2 * size_of::<usize>();

    /// The matrix. Identities are copies of one, and translations share its axes.
    #[must_use]
    pub fn new(matrix: &DMat4) -> Self {
        Self::sharing(matrix, &IDENTITY)
    }

    /// The matrix, with as much of another as has the same bits: all of it, or the axes.
    #[must_use]
    pub fn sharing(matrix: &DMat4, other: &Self) -> Self {
        let is_whole = |other: &&Self| other.has_bits_of(matrix);
        [other, &*IDENTITY].into_iter().find(is_whole).cloned().unwrap_or_else(|| {
            let axes = SharedAxes::new(matrix);
            Self(Arc::new(axes.sharing(&IDENTITY.0).sharing(&other.0)))
        })
    }

    /// The matrix.
    #[inline]
    #[must_use]
    pub fn matrix(&self) -> DMat4 {
        self.0.matrix()
    }

    /// Whether it is this matrix, bit by bit: 0 and -0 differ, which == takes for the same.
    #[must_use]
    pub fn has_bits_of(&self, matrix: &DMat4) -> bool {
        let bits = |matrix: &DMat4| matrix.to_cols_array().map(f64::to_bits);
        bits(&self.matrix()) == bits(matrix)
    }

    /// Whether it turns and scales as another one: whether their first three columns have the same bits.
    #[must_use]
    pub fn has_axes_of(&self, other: &Self) -> bool {
        self.0.has_axes_of(&other.0)
    }

    /// Whether both are copies of one.
    #[must_use]
    pub fn is_copy_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Default for SharedMatrix {
    fn default() -> Self {
        IDENTITY.clone()
    }
}

impl From<DMat4> for SharedMatrix {
    fn from(matrix: DMat4) -> Self {
        Self::new(&matrix)
    }
}

impl From<SharedMatrix> for DMat4 {
    fn from(shared: SharedMatrix) -> Self {
        shared.matrix()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn equal_matrices_are_copies_and_those_turned_alike_share_axes() {
        let turned = DMat4::from_rotation_y(0.3);
        let moved = DMat4::from_translation(DVec3::X) * turned;
        let first = SharedMatrix::new(&turned);
        assert!(SharedMatrix::sharing(&turned, &first).is_copy_of(&first));
        let second = SharedMatrix::sharing(&moved, &first);
        assert!(!second.is_copy_of(&first));
        assert!(second.0.shares_axes_with(&first.0));
        assert_eq!(second.matrix(), moved);
    }

    #[test]
    fn identities_are_copies_of_one_and_a_negative_zero_keeps_its_bits() {
        assert!(SharedMatrix::new(&DMat4::IDENTITY).is_copy_of(&SharedMatrix::default()));
        let moved = SharedMatrix::new(&DMat4::from_translation(DVec3::X));
        assert!(moved.0.shares_axes_with(&IDENTITY.0));
        let mut negative_zero = DMat4::IDENTITY;
        negative_zero.w_axis.y = -0.0;
        let shared = SharedMatrix::new(&negative_zero);
        assert!(!shared.is_copy_of(&SharedMatrix::default()));
        assert!(shared.matrix().w_axis.y.is_sign_negative());
    }
}
