//! Meshes by formula, and how they are checked.

use luxel_check::{Kind, Report, Setup, check};
use luxel_render::{Execution, View};
use luxel_scene::{
    Lens, MaterialId, Mesh, MeshId, Node, NormalOptions, Part, Scene, SceneMaterial, Size,
    Viewpoint, fit_view,
};

/// A scene that shows a mesh.
pub(crate) fn scene_of(mesh: Mesh) -> Scene {
    Scene {
        nodes: vec![Node::root("made", Some(MeshId(0)))],
        meshes: vec![with_part(mesh)].into(),
        materials: vec![SceneMaterial::default()],
        ..Scene::default()
    }
}

fn with_part(mut mesh: Mesh) -> Mesh {
    if mesh.parts.is_empty() {
        let count = mesh.triangles.len() as u32;
        mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    }
    mesh
}

/// A setup for a scene that is seen as the program sees it.
pub(crate) fn setup(scene: &Scene) -> Setup {
    let viewpoint = Viewpoint {
        up: scene.up,
        azimuth_radians: 30_f64.to_radians(),
        elevation_radians: 20_f64.to_radians(),
    };
    let lens = Lens::Perspective { fov_y_radians: 45_f64.to_radians() };
    let size = Size { width: 1280, height: 720 };
    let view = View::new(size, fit_view(scene, &viewpoint, lens, size)).with_samples(1);
    Setup { view, normals: NormalOptions::default(), execution: Execution::default() }
}

pub(crate) fn checked(mesh: Mesh) -> Report {
    let scene = scene_of(mesh);
    check(&scene, &setup(&scene))
}

/// Kinds with their counts.
pub(crate) fn counts(mesh: Mesh) -> Vec<(Kind, u64)> {
    checked(mesh).findings.iter().map(|finding| (finding.kind, finding.count)).collect()
}

/// A square of n x n quadrilaterals from (0, 0, 0) to (1, 0, 1), facing +Y, raised by a height over
/// x and z.
pub(crate) fn field(n: u32, height: impl Fn(f32, f32) -> f32) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..=n {
        for column in 0..=n {
            let (x, z) = (column as f32 / n as f32, row as f32 / n as f32);
            mesh.positions.push([x, height(x, z), z]);
        }
    }
    let at = |column: u32, row: u32| row * (n + 1) + column;
    for row in 0..n {
        for column in 0..n {
            let (a, b) = (at(column, row), at(column, row + 1));
            let (c, d) = (at(column + 1, row + 1), at(column + 1, row));
            mesh.triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    mesh
}

/// A gently bent field.
pub(crate) fn hill(n: u32) -> Mesh {
    field(n, |x, z| 0.2 * (1.0 - (x - 0.5) * (x - 0.5) - (z - 0.5) * (z - 0.5)))
}

/// A sphere without normals, from the built-in shape.
pub(crate) fn ball() -> Mesh {
    let mesh = luxel_scene::primitives::icosphere(1.0, 8);
    Mesh { positions: mesh.positions, triangles: mesh.triangles, ..Mesh::default() }
}

/// The same with normals.
pub(crate) fn ball_with_normals() -> Mesh {
    let mut mesh = ball();
    mesh.normals = mesh.positions.clone();
    mesh
}
