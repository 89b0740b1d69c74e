//! Where a surface would be if it were as round as its normals say.

use crate::scene_rays::SceneRays;
use crate::surface_place::SurfacePlace;
use glam::{DMat3, DVec3};

impl SceneRays {
    /// From a place on an object's triangle to where rays to lights leave from the curved surface that the
    /// triangle stands for. With the corners P_i, their normals n_i on the side of the place's normal and
    /// the barycentrics b_i of the place P:
    ///
    /// ```text
    /// offset = sum of b_i max(0, (P_i - P).n_i) n_i
    /// ```
    ///
    /// It leads to the mean of the places that P has on the corners' tangent planes, where these lie above
    /// the triangle, as they do on convex surfaces (Hanika, *Hacking the Shadow Terminator*, Ray Tracing
    /// Gems II, 2021). It is 0 at corners, on flat and on hollow surfaces, in meshes without normals, and
    /// never longer than the triangle's longest side.
    ///
    /// # Panics
    /// If there is no such object or triangle.
    #[must_use]
    pub fn terminator_offset(
        &self,
        (object, triangle): (usize, u32),
        barycentric: [f32; 3],
        place: &SurfacePlace,
    ) -> DVec3 {
        let (body, triangle) = self.in_body(object, triangle);
        let mesh = self.mesh(body);
        let corners = mesh.triangles[triangle as usize];
        let attributes = mesh.attribute_corners()[triangle as usize];
        let tree = self.tree(body);
        let world_from_mesh = DMat3::from_mat4(self.objects()[object].world_from_mesh.matrix());
        let turned = world_from_mesh.inverse().transpose();
        let world_from_tree = tree.world_from_tree.matrix();
        let mut offset = DVec3::ZERO;
        for ((weight, vertex), attribute) in barycentric.into_iter().zip(corners).zip(attributes) {
            let Some(&normal) = mesh.normals.get(attribute as usize) else { return DVec3::ZERO };
            let normal = turned * DVec3::from_array(normal.map(f64::from));
            let normal = normal.normalize_or_zero();
            let outwards = if normal.dot(place.normal) < 0.0 { -normal } else { normal };
            let corner = DVec3::from_array(tree.positions[vertex as usize].map(f64::from));
            let corner = world_from_tree.transform_point3(corner);
            let below = (corner - place.position).dot(outwards).max(0.0);
            offset += f64::from(weight) * below * outwards;
        }
        if offset.is_finite() { offset } else { DVec3::ZERO }
    }
}
