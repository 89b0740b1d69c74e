//! Small scenes whose pictures are known.

use luxel_lighting::{Light, LightKind, Material, PictureEncoding, Reflection};
use luxel_math::SimdLevel;
use luxel_render::{Cull, EnvironmentChoice, Execution, Renderer, Shading, View};
use luxel_scene::{
    AlphaMode, Camera, DMat4, DVec3, Lens, MaterialId, Mesh, MeshId, Node, Part, Placement,
    Projection, Scene, SceneLight, SceneMaterial, Size, Viewpoint, fit_view,
};

/// A square of 2x2 units at z, facing +Z.
pub(crate) fn square(z: f32) -> Mesh {
    Mesh {
        positions: vec![[-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z], [-1.0, 1.0, z]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        normals: vec![[0.0, 0.0, 1.0]; 4],
        uvs: [vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]], Vec::new()],
        polygons: Some(vec![0, 0]),
        ..Mesh::default()
    }
}

/// A material of one colour without a highlight.
pub(crate) fn matte(color: [f32; 3]) -> SceneMaterial {
    let constants =
        Material { reflection: Reflection::Lambert, diffuse: color, ..Material::default() };
    SceneMaterial { constants, ..SceneMaterial::default() }
}

/// Meshes, each with its material, as objects of one scene.
pub(crate) fn scene(things: Vec<(Mesh, SceneMaterial)>) -> Scene {
    let mut scene = Scene::default();
    for (number, (mut mesh, material)) in (0..).zip(things) {
        let count = mesh.triangles.len() as u32;
        mesh.parts = vec![Part { first: 0, count, material: MaterialId(number) }];
        scene.meshes.push(mesh);
        scene.materials.push(material);
        scene.nodes.push(Node {
            parent_from_node: DMat4::IDENTITY.into(),
            ..Node::root(format!("thing {number}"), Some(MeshId(number)))
        });
    }
    scene
}

/// A directional light along -Z.
pub(crate) fn frontal(color: [f32; 3]) -> SceneLight {
    SceneLight {
        name: "frontal".to_owned(),
        light: Light::new(LightKind::Directional, color),
        placement: Placement::World,
        position: DVec3::ZERO,
        direction: DVec3::NEG_Z,
    }
}

/// Four by four units seen straight from the front, a unit light in the eye's direction.
pub(crate) fn view(side: u32) -> View {
    let projection = Projection { lens: Lens::Orthographic { height: 4.0 }, near: 1.0, far: 20.0 };
    View::new(
        Size { width: side, height: side },
        Camera {
            view_from_world: Camera::look_at(DVec3::Z * 10.0, DVec3::ZERO, DVec3::Y),
            projection,
        },
    )
    .with_samples(1)
    .with_cull(Cull::Auto)
    .with_lights(vec![frontal([1.0; 3])])
    .with_ambient([0.0; 3])
    .with_environment(EnvironmentChoice::default())
    .with_fog(None)
    .with_background([0.0; 4])
    .with_encoding(PictureEncoding::Srgb)
    .with_edges(None)
    .with_shading(Shading::default())
}

/// One way of running.
pub(crate) fn execution(threads: usize, simd: SimdLevel) -> Execution {
    Execution { threads, simd, ..Execution::default() }
}

/// The bytes of a view.
pub(crate) fn bytes(scene: &Scene, view: &View) -> Vec<[u8; 4]> {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    renderer.rgba8(view).unwrap().pixels
}

/// The linear pixels of a view.
pub(crate) fn linear(scene: &Scene, view: &View) -> Vec<[f32; 4]> {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    renderer.linear(view).unwrap().pixels
}

/// The pixel in the middle of a square picture.
pub(crate) fn middle<T: Copy>(pixels: &[T]) -> T {
    let side = pixels.len().isqrt();
    pixels[side / 2 * side + side / 2]
}

/// A scene from its fitted viewpoint.
pub(crate) fn fitted(scene: &Scene, size: Size) -> View {
    let viewpoint = Viewpoint {
        up: scene.up,
        azimuth_radians: 30_f64.to_radians(),
        elevation_radians: 20_f64.to_radians(),
    };
    let lens = Lens::Perspective { fov_y_radians: 45_f64.to_radians() };
    view(1).with_size(size).with_camera(fit_view(scene, &viewpoint, lens, size))
}

/// Squares turned every way, some of them of glass.
pub(crate) fn glass() -> Scene {
    let mut things = Vec::new();
    for number in 0..12 {
        let mut material = matte([0.2 + 0.05 * number as f32, 0.5, 0.8]);
        if number % 3 == 0 {
            material.alpha_mode = AlphaMode::Blend;
            material.opacity = 0.4;
        }
        things.push((square(0.0), material));
    }
    let mut scene = scene(things);
    for (number, node) in scene.nodes.iter_mut().enumerate() {
        let turn = DMat4::from_rotation_x(0.3 * number as f64)
            * DMat4::from_rotation_y(0.7 * number as f64);
        node.parent_from_node = turn.into();
    }
    scene
}

/// The largest difference of two pictures in any channel.
pub(crate) fn largest_difference(a: &[[u8; 4]], b: &[[u8; 4]]) -> u8 {
    let pairs = a.as_flattened().iter().zip(b.as_flattened());
    pairs.map(|(a, b)| a.abs_diff(*b)).max().unwrap()
}
