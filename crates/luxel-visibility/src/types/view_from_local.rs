//! Where an instance's vertices are in view space, in f64.

use glam::{DMat4, DVec3};
use luxel_math::{F64Lanes, Lanes};
use luxel_scene::SharedAxes;

/// From a mesh's coordinates about its origin to view space.
#[derive(Clone, Debug, PartialEq)]
pub struct ViewFromLocal(SharedAxes);

impl ViewFromLocal {
    /// For a mesh about `origin` (its [`Mesh::origin`](luxel_scene::Mesh::origin)).
    #[must_use]
    pub fn new(view_from_mesh: &DMat4, origin: DVec3) -> Self {
        Self(SharedAxes::new(&(*view_from_mesh * DMat4::from_translation(origin))))
    }

    /// The same, with the axes of another if these have the same bits.
    #[must_use]
    pub fn sharing(self, other: &Self) -> Self {
        Self(self.0.sharing(&other.0))
    }

    /// The matrix. Its last row is (0, 0, 0, 1), but for meshes that are given in clip coordinates.
    #[inline]
    #[must_use]
    pub fn matrix(&self) -> DMat4 {
        self.0.matrix()
    }

    /// A triangle's corners in view space.
    #[inline(always)]
    #[must_use]
    pub fn corners<D: F64Lanes>(&self, [a, b, c]: [[D::F32; 3]; 3]) -> [[D; 3]; 3] {
        [self.place(a), self.place(b), self.place(c)]
    }

    /// A place in view space.
    #[inline(always)]
    #[must_use]
    pub fn place<D: F64Lanes>(&self, [x, y, z]: [D::F32; 3]) -> [D; 3] {
        let (x, y, z) = (x.to_f64(), y.to_f64(), z.to_f64());
        let [along_x, along_y, along_z, origin] = self.matrix().to_cols_array_2d();
        let mut place = [x; 3];
        for axis in 0..3 {
            place[axis] = x * x.constant(along_x[axis])
                + y * x.constant(along_y[axis])
                + z * x.constant(along_z[axis])
                + x.constant(origin[axis]);
        }
        place
    }
}
