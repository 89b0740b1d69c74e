//! The place of a polygon that is lit as a whole: its centroid, with its own normal.

use crate::context::ShadingContext;
use crate::polygons::{Face, Polygons};
use glam::{DMat3, DMat4};
use luxel_scene::Mesh;
use luxel_visibility::{SeenCluster, TriangleId};

/// The places of one instance's polygons.
pub(super) struct WholePlaces<'a> {
    pub(super) instance: usize,
    pub(super) mesh: &'a Mesh,
    polygons: Option<&'a Polygons>,
    view_from_mesh: DMat4,
    world_from_view: DMat3,
    normal_from_mesh: DMat3,
    is_parallel: bool,
}

impl<'a> WholePlaces<'a> {
    pub(super) fn of(scene: &ShadingContext<'a>, number: usize) -> Self {
        let instance = &scene.placed.instances()[number];
        let space = scene.placed.space(number);
        Self {
            instance: number,
            mesh: scene.placed.mesh(instance),
            polygons: scene.polygons[number],
            view_from_mesh: scene.placed.view_from_mesh(instance),
            world_from_view: space.view().world_from_view,
            normal_from_mesh: space.normal_from_mesh(),
            is_parallel: space.view().parallel,
        }
    }

    /// The place of the polygon that a triangle is part of: its centroid about the eye, along the world's axes, and its
    /// own unit normal in world space, turned to the eye.
    pub(super) fn place(&self, triangle: u32) -> [[f32; 3]; 2] {
        let polygons = self.polygons.unwrap_or(const { &Polygons::TRIANGLES });
        self.place_of(polygons.face(self.mesh, triangle))
    }

    /// [`WholePlaces::place`] for a triangle of a cluster, whose corners are near.
    pub(super) fn place_seen(&self, cluster: &SeenCluster<'_>, id: TriangleId) -> [[f32; 3]; 2] {
        match self.polygons.is_none_or(Polygons::are_triangles) {
            true => self.place_of(Face::of_triangle(self.mesh, cluster.positions(id))),
            false => self.place(cluster.triangle(id)),
        }
    }

    fn place_of(&self, face: Face) -> [[f32; 3]; 2] {
        let place = self.world_from_view * self.view_from_mesh.transform_point3(face.centroid);
        let normal = (self.normal_from_mesh * face.area).normalize_or_zero();
        let to_eye = if self.is_parallel { self.world_from_view.z_axis } else { -place };
        let normal = if normal.dot(to_eye) < 0.0 { -normal } else { normal };
        [place.as_vec3().to_array(), normal.as_vec3().to_array()]
    }
}
