//! What an instance's transform does to a triangle: its corners in view space and about the eye,
//! which side of it is seen, and the normals and tangents of its corners in world space.
//!
//! Written once for one triangle and for sixteen. Corners in view space are f64; what light is
//! computed from is f32.

use crate::types::ViewFromLocal;
use glam::{DMat3, DVec3};
use luxel_math::{F64Lanes, Lanes, Vec3};
use luxel_scene::{Camera, Mesh, SharedMatrix};
use std::sync::Arc;

/// How a camera is turned: the same for all instances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewSpace {
    /// From view space to world axes about the eye: a rotation.
    pub world_from_view: DMat3,
    /// Its rows.
    rotation: [[f32; 3]; 3],
    /// Whether the camera's rays are parallel.
    pub parallel: bool,
}

impl ViewSpace {
    /// Of a camera.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        let world_from_view = DMat3::from_mat4(camera.view_from_world).transpose();
        Self {
            world_from_view,
            rotation: rows(world_from_view),
            parallel: camera.projection.is_orthographic(),
        }
    }
}

/// An instance's transforms.
#[derive(Clone, Debug, PartialEq)]
pub struct InstanceSpace {
    /// For places.
    pub view_from_local: ViewFromLocal,
    orientation: Arc<Orientation>,
}

/// How an instance is turned and scaled: the same for instances that are moved only.
#[derive(Clone, Debug)]
struct Orientation {
    /// The camera's.
    view: Arc<ViewSpace>,
    /// From the mesh's coordinates to the world's, for one of the instances.
    world_from_mesh: SharedMatrix,
    /// Rows of [`InstanceSpace::normal_from_mesh`], scaled to a largest entry of 1.
    normals: [[f32; 3]; 3],
    /// -1 where the transform mirrors, else 1.
    handedness: f32,
}

impl InstanceSpace {
    /// The transforms of a mesh in its place before a camera, of which `view` is.
    #[must_use]
    pub fn new(
        world_from_mesh: &SharedMatrix,
        view_from_local: ViewFromLocal,
        view: &Arc<ViewSpace>,
    ) -> Self {
        let (normal_from_mesh, handedness) = normal_from_mesh(&axes(world_from_mesh));
        let largest =
            normal_from_mesh.to_cols_array().into_iter().fold(0.0, |largest: f64, value| {
                if value.abs() > largest { value.abs() } else { largest }
            });
        let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
        let orientation = Orientation {
            view: Arc::clone(view),
            world_from_mesh: world_from_mesh.clone(),
            normals: rows(normal_from_mesh * scale),
            handedness,
        };
        Self { view_from_local, orientation: Arc::new(orientation) }
    }

    /// The same, with what another one has alike.
    pub(crate) fn sharing(self, other: &Self) -> Self {
        let alike = if self.orientation == other.orientation { other } else { &self };
        let orientation = Arc::clone(&alike.orientation);
        Self { view_from_local: self.view_from_local.sharing(&other.view_from_local), orientation }
    }

    /// The camera's.
    #[inline]
    #[must_use]
    pub fn view(&self) -> &ViewSpace {
        &self.orientation.view
    }

    /// For normals: the inverse transpose of the mesh's transform, up to a positive factor.
    #[must_use]
    pub fn normal_from_mesh(&self) -> DMat3 {
        normal_from_mesh(&axes(&self.orientation.world_from_mesh)).0
    }

    /// A vector in view space, along the world's axes.
    #[inline(always)]
    #[must_use]
    pub fn along_world<N: Lanes>(&self, in_view: Vec3<N>) -> Vec3<N> {
        transformed(&self.view().rotation, in_view)
    }

    /// A place in view space, about the eye along the world's axes.
    #[inline(always)]
    #[must_use]
    pub fn about_eye<D: F64Lanes>(&self, [x, y, z]: [D; 3]) -> Vec3<D::F32> {
        transformed(&self.view().rotation, Vec3::new(x.to_f32(), y.to_f32(), z.to_f32()))
    }

    /// The normals of a triangle's corners as the mesh has them; `None` where it has none.
    ///
    /// # Panics
    /// If the mesh has normals, but not for these attribute vertices.
    #[must_use]
    pub fn normals_in_mesh(mesh: &Mesh, attributes: [usize; 3]) -> Option<[Vec3<f32>; 3]> {
        if mesh.normals.is_empty() {
            return None;
        }
        let [a, b, c] = attributes;
        let normal = |attribute: usize| {
            let [x, y, z] = mesh.normals[attribute];
            Vec3::new(x, y, z)
        };
        Some([normal(a), normal(b), normal(c)])
    }

    /// A vertex normal in world space, of unit length.
    #[inline(always)]
    #[must_use]
    pub fn unit_normal<N: Lanes>(&self, in_mesh: Vec3<N>) -> Vec3<N> {
        transformed(&self.orientation.normals, in_mesh).normalized_or_zero()
    }

    /// A triangle's unit vertex normals in world space, turned to the side that is seen. Without
    /// normals of the mesh (`None`) they are the face's own.
    ///
    /// Which side is seen, the face's plane decides, pointed along the sum of the vertex normals (by
    /// winding where that is 0), so that a file with reversed winding is not black. `sides` lead from the
    /// first corner to the others in view space; `towards_eye` is
    /// [`WindowRays::towards_eye`](crate::WindowRays::towards_eye).
    #[inline(always)]
    #[must_use]
    pub fn facing_normals<D: F64Lanes>(
        &self,
        sides: [Vec3<D::F32>; 2],
        towards_eye: D,
        in_mesh: Option<[Vec3<D::F32>; 3]>,
    ) -> [Vec3<D::F32>; 3] {
        let handedness = self.orientation.handedness;
        let by_winding = transformed(&self.view().rotation, face_normal(sides));
        let by_winding = by_winding * by_winding.x.constant(handedness);
        let [a, b, c] = match in_mesh {
            Some([a, b, c]) => [self.unit_normal(a), self.unit_normal(b), self.unit_normal(c)],
            None => [by_winding.normalized_or_zero(); 3],
        };
        let zero = a.x.zero();
        let inwards = by_winding.dot(a + b + c).less(zero);
        let towards_eye = towards_eye * towards_eye.constant(handedness.into());
        let (counterclockwise, clockwise) =
            (towards_eye.is_positive(), (-towards_eye).is_positive());
        let from_behind = (inwards & counterclockwise) | (!inwards & clockwise);
        [(-a).select(from_behind, a), (-b).select(from_behind, b), (-c).select(from_behind, c)]
    }

    /// An attribute vertex's unit tangent in world space with the bitangent's sign; 0 where the
    /// mesh has none.
    #[must_use]
    pub fn tangent(&self, mesh: &Mesh, attribute: usize) -> [f32; 4] {
        let Some(&[x, y, z, sign]) = mesh.tangents.get(attribute) else { return [0.0; 4] };
        let Orientation { world_from_mesh, handedness, .. } = &*self.orientation;
        let tangent = axes(world_from_mesh) * DVec3::new(x.into(), y.into(), z.into());
        let [x, y, z] = tangent.normalize_or_zero().as_vec3().to_array();
        [x, y, z, if *handedness < 0.0 { -sign } else { sign }]
    }
}

impl PartialEq for Orientation {
    /// Whether both are before one camera, and turned and scaled alike: the rest follows from these.
    fn eq(&self, other: &Self) -> bool {
        self.view == other.view && self.world_from_mesh.has_axes_of(&other.world_from_mesh)
    }
}

/// From the mesh's axes to the world's.
fn axes(world_from_mesh: &SharedMatrix) -> DMat3 {
    DMat3::from_mat4(world_from_mesh.matrix())
}

/// The inverse transpose of a transform, up to a positive factor, and -1 if the transform mirrors, else 1.
fn normal_from_mesh(linear: &DMat3) -> (DMat3, f32) {
    // The cofactor matrix is the inverse transpose times the determinant, and exists even where
    // a flattening transform has no inverse.
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    let handedness = if linear.determinant() < 0.0 { -1.0 } else { 1.0 };
    (cofactors * f64::from(handedness), handedness)
}

/// The rows of a matrix, in f32.
fn rows(matrix: DMat3) -> [[f32; 3]; 3] {
    [0, 1, 2].map(|row| matrix.row(row).as_vec3().to_array())
}

/// A matrix, given by rows, times a vector.
#[inline(always)]
fn transformed<N: Lanes>([x, y, z]: &[[f32; 3]; 3], vector: Vec3<N>) -> Vec3<N> {
    Vec3::new(
        Vec3::splat(vector.x, *x).dot(vector),
        Vec3::splat(vector.x, *y).dot(vector),
        Vec3::splat(vector.x, *z).dot(vector),
    )
}

/// From the first corner of a triangle to the others: differences are taken in f64, so that small
/// triangles far away keep their digits.
#[inline(always)]
#[must_use]
pub fn sides<D: F64Lanes>([a, b, c]: &[[D; 3]; 3]) -> [Vec3<D::F32>; 2] {
    [side(a, b), side(a, c)]
}

#[inline(always)]
fn side<D: F64Lanes>(from: &[D; 3], to: &[D; 3]) -> Vec3<D::F32> {
    Vec3::new((to[0] - from[0]).to_f32(), (to[1] - from[1]).to_f32(), (to[2] - from[2]).to_f32())
}

/// A triangle's normal by the right-hand rule, of a length about 1 whatever the triangle's size.
#[inline(always)]
fn face_normal<N: Lanes>([along, aside]: [Vec3<N>; 2]) -> Vec3<N> {
    let largest = along
        .x
        .constant(f32::MIN_POSITIVE)
        .maximum(along.x.abs())
        .maximum(along.y.abs())
        .maximum(along.z.abs())
        .maximum(aside.x.abs())
        .maximum(aside.y.abs())
        .maximum(aside.z.abs());
    let scale = largest.one() / largest;
    (along * scale).cross(aside * scale)
}
