//! Solids seen by perspective cameras: what the tests with rays and with clipping look at.

use crate::scene::{Picture, best};
use glam::{DMat4, DVec3};
use luxel_math::Level;
use luxel_scene::{Camera, Lens, MaterialId, Mesh, Part, Projection, Size};
use luxel_visibility::{
    Clusters, Frame, Frames, Instance, PartUse, Region, Samples, ViewFromLocal,
};
use proptest::prelude::*;

/// A mesh and a camera.
#[derive(Clone, Debug)]
pub(crate) struct View {
    pub(crate) mesh: Mesh,
    pub(crate) view_from_mesh: DMat4,
    pub(crate) projection: Projection,
    pub(crate) size: Size,
    pub(crate) samples: u32,
    pub(crate) part: PartUse,
}

impl View {
    pub(crate) fn look(
        mesh: Mesh,
        eye: DVec3,
        target: DVec3,
        lens: Lens,
        planes: [f64; 2],
    ) -> Self {
        Self {
            mesh,
            view_from_mesh: Camera::look_at(eye, target, DVec3::Y),
            projection: Projection { lens, near: planes[0], far: planes[1] },
            size: Size { width: 101, height: 79 },
            samples: 1,
            part: PartUse::default(),
        }
    }

    /// Draws the mesh as one instance.
    pub(crate) fn draw(&self, level: Level) -> Picture {
        self.with_frame(level, |frame| Picture::opaque(frame, level))
    }

    /// Draws the mesh as one instance, for a part of the window.
    pub(crate) fn draw_part(&self, part: Region, level: Level) -> Picture {
        self.with_part(part, level, |frame| Picture::opaque(frame, level))
    }

    pub(crate) fn with_frame<R>(&self, level: Level, ask: impl FnOnce(&Frame<'_>) -> R) -> R {
        self.with_part(Region::whole(self.size), level, ask)
    }

    fn with_part<R>(&self, part: Region, level: Level, ask: impl FnOnce(&Frame<'_>) -> R) -> R {
        let clusters = Clusters::new(&self.mesh, Frames::Many);
        ask(&self.frame(vec![self.instance(&self.mesh, &clusters, &self.place())], part, level))
    }

    /// Draws each triangle as an instance of its own; numbers are those of the whole mesh.
    pub(crate) fn draw_one_by_one(&self) -> Picture {
        let pieces: Vec<(Mesh, Clusters)> = self
            .mesh
            .triangles
            .iter()
            .map(|&triangle| {
                let mesh = Mesh {
                    origin: self.mesh.origin,
                    positions: triangle.map(|corner| self.mesh.positions[corner as usize]).to_vec(),
                    triangles: vec![[0, 1, 2]],
                    parts: vec![Part { first: 0, count: 1, material: MaterialId(0) }],
                    ..Mesh::default()
                };
                let clusters = Clusters::new(&mesh, Frames::One);
                (mesh, clusters)
            })
            .collect();
        let place = self.place();
        let instances =
            pieces.iter().map(|(mesh, clusters)| self.instance(mesh, clusters, &place)).collect();
        let mut picture =
            Picture::opaque(&self.frame(instances, Region::whole(self.size), best()), best());
        for (_, submitted) in picture.seen.iter_mut().flatten() {
            *submitted = (0, submitted.0 as u32);
        }
        picture
    }

    fn place(&self) -> ViewFromLocal {
        ViewFromLocal::new(&self.view_from_mesh, self.mesh.origin)
    }

    fn instance<'a>(
        &self,
        mesh: &'a Mesh,
        clusters: &'a Clusters,
        view_from_local: &'a ViewFromLocal,
    ) -> Instance<'a> {
        let parts = vec![self.part; mesh.parts.len()].into();
        Instance { mesh, clusters, view_from_local, parts, ranks: &[], is_repeated: false }
    }

    fn frame<'a>(&self, instances: Vec<Instance<'a>>, part: Region, level: Level) -> Frame<'a> {
        let samples = Samples::new(self.samples).unwrap();
        Frame::of_part(instances, &self.projection, self.size, part, samples, level).unwrap()
    }

    /// Every sample's number in a picture and its position.
    pub(crate) fn sample_positions(&self) -> impl Iterator<Item = (usize, [i32; 2])> + use<> {
        let empty =
            crate::scene::Scene { size: self.size, samples: self.samples, instances: Vec::new() };
        empty.sample_positions()
    }
}

/// A direction of unit length, or near it.
pub(crate) fn direction() -> impl Strategy<Value = DVec3> {
    (-1.0..1.0, -1.0..1.0, -1.0..1.0)
        .prop_map(|(x, y, z)| DVec3::new(x, y, z).normalize_or(DVec3::new(0.6, 0.0, 0.8)))
}

/// A sphere of facets with dents and bumps, all of it within radius 1.2.
pub(crate) fn bumpy(frequency: u32) -> Mesh {
    let mut mesh = luxel_scene::primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = *position;
        let scale = 1.0 + 0.2 * (4.0 * x * x - 1.0) * (2.0 * y * z + x) * 0.25;
        *position = [x, y, z].map(|value| value * scale);
    }
    mesh
}
