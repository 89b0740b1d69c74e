//! Severity: pictures of the mesh as it is and repaired, compared.

use luxel_render::{Execution, Renderer, View};
use luxel_scene::{
    Camera, DMat4, DVec3, Lens, MaterialId, Mesh, MeshId, Node, NormalOptions, Projection, Scene,
    SceneMaterial, Sides, Size,
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

/// The materials of the pictures: defaults, but for the sides that are drawn.
const SHOWN_SIDES: [Sides; 2] = [Sides::Both, Sides::Front];

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
        let material = |sides| SceneMaterial { sides, ..SceneMaterial::default() };
        let mut isolated = Scene {
            nodes: vec![Node::root("", Some(MeshId(0)))],
            meshes: vec![plain(mesh, scene)].into(),
            materials: SHOWN_SIDES.map(material).to_vec(),
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

/// A mesh without textures and colours, whose materials are those of [`SHOWN_SIDES`].
fn plain(mesh: &Mesh, scene: &Scene) -> Mesh {
    let material = |MaterialId(number): MaterialId| {
        let sides = scene.materials.get(number as usize).map_or(Sides::Both, |of| of.sides);
        MaterialId(SHOWN_SIDES.iter().position(|shown| *shown == sides).unwrap_or(0) as u32)
    };
    let mut mesh = Mesh { uvs: Default::default(), colors: Vec::new(), ..mesh.clone() };
    mesh.parts.iter_mut().for_each(|part| part.material = material(part.material));
    // Parts that follow one another are one, if they are drawn alike.
    mesh.parts.dedup_by(|next, part| {
        let follows = next.material == part.material && next.first == part.first + part.count;
        part.count += if follows { next.count } else { 0 };
        follows
    });
    mesh.lines.iter_mut().for_each(|lines| lines.material = material(lines.material));
    mesh.points.iter_mut().for_each(|points| points.material = material(points.material));
    mesh
}

/// The largest difference of a colour or alpha between two pictures, in 8-bit steps.
pub(crate) fn largest_difference(one: &[[u8; 4]], other: &[[u8; 4]]) -> f32 {
    let of_pixel = |(one, other): (&[u8; 4], &[u8; 4])| {
        let steps = one.iter().zip(other).map(|(one, other)| one.abs_diff(*other));
        steps.max().unwrap_or(0)
    };
    f32::from(one.iter().zip(other).map(of_pixel).max().unwrap_or(0))
}
