//! Things of the scene put where a frame wants them: instances before the camera, lights about the
//! eye.

use crate::view::View;
use glam::{DMat3, DMat4, DVec3};
use luxel_lighting::{Coefficients, LightKind, PlacedLight, Uniform};
use luxel_scene::{AlphaMode, Camera, Object, Placement, Scene, SceneLight, SceneMaterial};
use luxel_visibility::{Clusters, Coverage, Cull, CullFaces, Instance, PartUse, Strokes};

/// How surfaces cover what lies behind them, by what their materials say.
#[derive(Clone, Copy)]
pub(crate) struct CoveragePolicy {
    opaque: Coverage,
    masked: Coverage,
    blended: Coverage,
}

impl CoveragePolicy {
    /// As they are drawn.
    pub(crate) const DRAWN: Self =
        Self { opaque: Coverage::Opaque, masked: Coverage::Cutout, blended: Coverage::Blended };
    /// The nearest surface counts, unless it is wholly transparent.
    pub(crate) const NEAREST: Self = Self { blended: Coverage::Cutout, ..Self::DRAWN };
    /// What is blended hides what lies behind it, too.
    pub(crate) const SOLID: Self = Self { blended: Coverage::Opaque, ..Self::DRAWN };
    /// One surface behind the other, as if all were of glass.
    pub(crate) const LAYERS: Self =
        Self { opaque: Coverage::Blended, masked: Coverage::Blended, blended: Coverage::Blended };
}

/// The instances of a scene before the camera: the objects, then the points and lines of some.
pub(crate) fn instances<'a>(
    scene: &'a Scene,
    objects: &[Object],
    clusters: &'a [Clusters],
    strokes: &'a [Strokes],
    view: &View,
    covers: CoveragePolicy,
) -> Vec<Instance<'a>> {
    let part_use = |object: &Object, material: usize| {
        let material = &scene.materials[material];
        let mirrored = object.world_from_mesh.determinant() < 0.0;
        let cull = view.cull.faces(material.sides, mirrored);
        let wires = view.edges.is_some_and(|edges| edges.wireframe);
        let coverage = match material.alpha_mode {
            AlphaMode::Opaque if wires => Coverage::Cutout,
            AlphaMode::Opaque => covers.opaque,
            AlphaMode::Mask { .. } => covers.masked,
            AlphaMode::Blend => covers.blended,
        };
        // Wires are seen from both sides.
        PartUse {
            cull: if wires && view.cull == Cull::Auto { CullFaces::None } else { cull },
            coverage,
        }
    };
    let faces = objects.iter().map(|object| {
        let mesh = &scene.meshes[object.mesh.index()];
        let parts = mesh.parts.iter().map(|part| part_use(object, part.material.index()));
        Instance {
            mesh,
            clusters: &clusters[object.mesh.index()],
            view_from_mesh: view.camera.view_from_world * object.world_from_mesh,
            parts: parts.collect(),
        }
    });
    let strokes = strokes.iter().map(|strokes| Instance {
        mesh: &strokes.mesh,
        clusters: &strokes.clusters,
        view_from_mesh: DMat4::IDENTITY,
        parts: vec![
            PartUse { coverage: covers.opaque, ..PartUse::default() };
            strokes.mesh.parts.len()
        ],
    });
    faces.chain(strokes).collect()
}

/// A light about the eye, along the world's axes; `None` for ambient lights.
pub(crate) fn light(
    light: &SceneLight,
    camera: &Camera,
    world_from_nodes: &[DMat4],
) -> Option<PlacedLight> {
    if light.light.kind == LightKind::Ambient {
        return None;
    }
    let eye = camera.eye();
    let world_from_view = DMat3::from_mat4(camera.view_from_world).transpose();
    let (position, direction) = match light.placement {
        Placement::World => (light.position - eye, light.direction),
        Placement::Camera => (world_from_view * light.position, world_from_view * light.direction),
        Placement::Node(node) => {
            let world_from_node = &world_from_nodes[node.index()];
            let position = world_from_node.transform_point3(light.position) - eye;
            (position, world_from_node.transform_vector3(light.direction))
        }
    };
    let f32s = |vector: DVec3| vector.as_vec3().to_array();
    Some(PlacedLight::new(light.light.clone(), f32s(position), f32s(direction.normalize_or_zero())))
}

/// The ambient light of the scene and of all ambient lights.
pub(crate) fn ambient(view: &View) -> [f32; 3] {
    let lights = view.lights.iter().filter(|light| light.light.kind == LightKind::Ambient);
    lights.fold(view.ambient, |sum, light| {
        std::array::from_fn(|channel| sum[channel] + light.light.ambient[channel])
    })
}

/// What each material reflects that is the same at all its points, but for vertex colours; `None`
/// where textures change it.
pub(crate) fn uniform(materials: &[SceneMaterial]) -> Vec<Option<Coefficients<Uniform>>> {
    let of = |material: &SceneMaterial| {
        let SceneMaterial { base_color, ambient, specular, emission, .. } = material;
        let SceneMaterial { metallic_roughness, occlusion, .. } = material;
        let textures = [base_color, ambient, specular, emission, metallic_roughness, occlusion];
        let has_none = textures.into_iter().all(Option::is_none);
        has_none.then(|| Coefficients::uniform(&material.constants))
    };
    materials.iter().map(of).collect()
}
