//! A mesh made in memory becomes a picture:
//! `cargo run --release -p luxel --example in_memory_mesh [PICTURE.png]`

use luxel::lighting::Reflection;
use luxel::prelude::*;
use luxel::scene::{
    MaterialId, Mesh, MeshId, Node, NormalOptions, Part, SceneLight, SceneMaterial, Viewpoint,
    fit_view,
};
use std::error::Error;

/// z = (1 - r^2) e^(-r^2) over a square, as a grid of triangles. `libm` gives the same bits everywhere.
fn hat(side: u32) -> Mesh {
    let at = |step: u32| 6.0 * step as f32 / side as f32 - 3.0;
    let positions = (0..=side).flat_map(|row| {
        (0..=side).map(move |column| {
            let (x, y) = (at(column), at(row));
            let squared = x * x + y * y;
            [x, y, (1.0 - squared) * libm::expf(-squared)]
        })
    });
    let triangles = (0..side).flat_map(|row| {
        (0..side).flat_map(move |column| {
            let corner = row * (side + 1) + column;
            let above = corner + side + 1;
            [[corner, corner + 1, above + 1], [corner, above + 1, above]]
        })
    });
    let (positions, triangles): (Vec<_>, Vec<_>) = (positions.collect(), triangles.collect());
    let count = triangles.len() as u32;
    let parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    Mesh { positions, triangles, parts, ..Mesh::default() }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut material = SceneMaterial::default();
    material.constants.diffuse = [0.1, 0.45, 0.6];
    material.constants.reflection = Reflection::BlinnPhong;
    let mut scene = Scene { up: DVec3::Z, materials: vec![material], ..Scene::default() };
    scene.meshes.push(hat(96));
    scene.nodes.push(Node::root("hat", Some(MeshId(0))));
    // Vertex normals, as files bring them.
    scene.compute_normals(&NormalOptions::default());

    let size = Size { width: 640, height: 360 };
    let viewpoint = Viewpoint { up: scene.up, azimuth_radians: 0.6, elevation_radians: 0.6 };
    let camera = fit_view(&scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.6 }, size);
    let view = View::new(size, camera)
        .with_lights(vec![SceneLight::directional(DVec3::new(-1.0, 1.0, -1.5), [0.9; 3])])
        .with_background([0.9, 0.9, 0.92, 1.0]);

    let path = std::env::args_os().nth(1).map(Into::into);
    let path = path.unwrap_or_else(|| std::env::temp_dir().join("luxel-hat.png"));
    let picture = Renderer::new(scene, &Execution::default())?.rgba8(&view)?;
    picture.save(&path)?;
    println!("{} bytes of pixels drawn to {}", picture.as_bytes().len(), path.display());
    Ok(())
}
