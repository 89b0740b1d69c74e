//! What an instance's transform does to directions: which side of a triangle is seen, and the
//! normals and tangents of its corners in world space.

use glam::{DMat3, DMat4, DVec3};
use luxel_scene::{Camera, Mesh};

/// An instance's transforms for directions.
#[derive(Clone, Copy, Debug)]
pub struct InstanceSpace {
    /// From view space to world axes about the eye: a rotation.
    pub world_from_view: DMat3,
    /// For normals: the inverse transpose of the mesh's transform, up to a positive factor.
    pub normal_from_mesh: DMat3,
    /// For tangents.
    pub world_from_mesh: DMat3,
    /// -1 where the transform mirrors, else 1.
    pub handedness: f64,
    /// Whether the camera's rays are parallel.
    pub parallel: bool,
}

impl InstanceSpace {
    /// The transforms of a mesh in its place before a camera.
    #[must_use]
    pub fn new(world_from_mesh: &DMat4, camera: &Camera) -> Self {
        let world_from_mesh = DMat3::from_mat4(*world_from_mesh);
        let determinant = world_from_mesh.determinant();
        // The cofactor matrix is the inverse transpose times the determinant, and exists even where
        // a flattening transform has no inverse.
        let [x, y, z] = [world_from_mesh.x_axis, world_from_mesh.y_axis, world_from_mesh.z_axis];
        let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
        let handedness = if determinant < 0.0 { -1.0 } else { 1.0 };
        Self {
            world_from_view: DMat3::from_mat4(camera.view_from_world).transpose(),
            normal_from_mesh: cofactors * handedness,
            world_from_mesh,
            handedness,
            parallel: camera.projection.is_orthographic(),
        }
    }

    /// A triangle's unit vertex normals in world space, turned to the side that is seen; its
    /// corners' places are given along the world's axes about the eye.
    ///
    /// Which side that is, the face's plane decides, pointed along the sum of the vertex normals
    /// (by winding where that is 0), so that a file with reversed winding is not black.
    ///
    /// # Panics
    /// If the mesh has normals, but not for these attribute vertices.
    #[must_use]
    pub fn facing_normals(
        &self,
        mesh: &Mesh,
        attributes: [usize; 3],
        [a, b, c]: [DVec3; 3],
    ) -> [[f32; 3]; 3] {
        let by_winding = (b - a).cross(c - a) * self.handedness;
        let normals = if mesh.normals.is_empty() {
            [by_winding.normalize_or_zero(); 3]
        } else {
            attributes.map(|attribute| {
                let [x, y, z] = mesh.normals[attribute];
                let normal = self.normal_from_mesh * DVec3::new(x.into(), y.into(), z.into());
                normal.normalize_or_zero()
            })
        };
        let sum = normals[0] + normals[1] + normals[2];
        let outwards = if by_winding.dot(sum) < 0.0 { -by_winding } else { by_winding };
        let to_eye = if self.parallel { self.world_from_view.z_axis } else { -a };
        let from_behind = outwards.dot(to_eye) < 0.0;
        normals.map(|normal| (if from_behind { -normal } else { normal }).as_vec3().to_array())
    }

    /// An attribute vertex's unit tangent in world space with the bitangent's sign; 0 where the
    /// mesh has none.
    #[must_use]
    pub fn tangent(&self, mesh: &Mesh, attribute: usize) -> [f32; 4] {
        let Some(&[x, y, z, sign]) = mesh.tangents.get(attribute) else { return [0.0; 4] };
        let tangent = self.world_from_mesh * DVec3::new(x.into(), y.into(), z.into());
        let [x, y, z] = tangent.normalize_or_zero().as_vec3().to_array();
        [x, y, z, if self.handedness < 0.0 { -sign } else { sign }]
    }
}
