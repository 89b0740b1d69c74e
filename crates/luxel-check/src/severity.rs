//! Severity: pictures of the mesh as it is and repaired, compared.

use luxel_render::{Execution, Renderer, View};
use luxel_scene::{
    Camera, DMat4, DVec3, Lens, Mesh, MeshId, Node, NormalOptions, Projection, Scene,
    SceneMaterial, Size,
};

/// The directions from which a mesh is rendered, with their up vectors.
const SIDES: [(DVec3, DVec3); 6] = [
    (DVec3::X, DVec3::Y),
    (DVec3::NEG_X, DVec3::Y),
    (DVec3::Y, DVec3::Z),
    (DVec3::NEG_Y, DVec3::Z),
    (DVec3::Z, DVec3::Y),
    (DVec3::NEG_Z, DVec3::Y),
];

/// Width and height in pixels.
const SIDE: u32 = 384;

/// The pictures of a mesh from all sides.
pub(crate) struct Pictures {
    pixels: Vec<Vec<[u8; 4]>>,
}

impl Pictures {
    /// Renders a mesh orthographically, with the default material and lights; `None` if it can't be
    /// rendered.
    pub(crate) fn of(
        mesh: &Mesh,
        scene: &Scene,
        normals: &NormalOptions,
        execution: &Execution,
    ) -> Option<Self> {
        let bounds = mesh.bounds(&DMat4::IDENTITY);
        let radius = bounds.radius();
        if bounds.is_empty() || !radius.is_finite() || radius <= 0.0 {
            return None;
        }
        let mut isolated = Scene {
            nodes: vec![Node::root("", Some(MeshId(0)))],
            meshes: vec![Mesh { uvs: Default::default(), colors: Vec::new(), ..mesh.clone() }]
                .into(),
            // Default materials, but for the sides that are drawn.
            materials: scene
                .materials
                .iter()
                .map(|material| SceneMaterial { sides: material.sides, ..SceneMaterial::default() })
                .collect(),
            ..Scene::default()
        };
        isolated.compute_normals(normals);
        let renderer = Renderer::new(isolated, execution).ok()?;
        let view = |(side, up): (DVec3, DVec3)| {
            View::new(
                Size { width: SIDE, height: SIDE },
                Camera {
                    view_from_world: Camera::look_at(
                        bounds.centre() + side * (2.0 * radius),
                        bounds.centre(),
                        up,
                    ),
                    projection: Projection {
                        lens: Lens::Orthographic { height: 2.0 * radius },
                        near: 0.5 * radius,
                        far: 3.5 * radius,
                    },
                },
            )
            .with_samples(1)
        };
        let draw = |side| renderer.rgba8(&view(side)).map(|picture| picture.pixels);
        let pixels = SIDES.into_iter().map(draw).collect::<Result<_, _>>().ok()?;
        Some(Self { pixels })
    }

    /// The largest difference of a colour or alpha, in 8-bit steps.
    pub(crate) fn difference(&self, other: &Self) -> f32 {
        let pairs = self.pixels.iter().zip(&other.pixels);
        pairs.map(|(one, other)| largest_difference(one, other)).fold(0.0, f32::max)
    }
}

/// The largest difference of a colour or alpha between two pictures, in 8-bit steps.
pub(crate) fn largest_difference(one: &[[u8; 4]], other: &[[u8; 4]]) -> f32 {
    let of_pixel = |(one, other): (&[u8; 4], &[u8; 4])| {
        let steps = one.iter().zip(other).map(|(one, other)| one.abs_diff(*other));
        steps.max().unwrap_or(0)
    };
    f32::from(one.iter().zip(other).map(of_pixel).max().unwrap_or(0))
}
