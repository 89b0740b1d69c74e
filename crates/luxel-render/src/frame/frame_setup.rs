//! Things of the scene put where a frame wants them: instances before the camera, lights about the
//! eye.

use glam::{DMat3, DVec3};
use luxel_lighting::{Coefficients, Display, LightKind, PlacedLight, Uniform};
use luxel_scene::{Camera, Placement, Scene, SceneLight, SceneMaterial};
use luxel_view::View;
use luxel_visibility::{CoveragePolicy, SurfaceRules};

/// Which faces a view draws, and how.
pub(crate) fn surface_rules(view: &View, coverage: CoveragePolicy) -> SurfaceRules {
    let wireframe = view.edges.is_some_and(|edges| edges.wireframe);
    SurfaceRules { cull: view.cull, coverage, wireframe, point_size: view.point_size }
}

/// A light about the eye, along the world's axes; `None` for ambient lights.
fn light(light: &SceneLight, camera: &Camera, scene: &Scene) -> Option<PlacedLight> {
    if light.light.kind == LightKind::Ambient {
        return None;
    }
    let eye = camera.eye();
    let world_from_view = DMat3::from_mat4(camera.view_from_world).transpose();
    let (position, direction) = match light.placement {
        Placement::World => (light.position - eye, light.direction),
        Placement::Camera => (world_from_view * light.position, world_from_view * light.direction),
        Placement::Node(node) => {
            let world_from_node = scene.world_from_node(node);
            let position = world_from_node.transform_point3(light.position) - eye;
            (position, world_from_node.transform_vector3(light.direction))
        }
    };
    let f32s = |vector: DVec3| vector.as_vec3().to_array();
    Some(PlacedLight::new(light.light.clone(), f32s(position), f32s(direction.normalize_or_zero())))
}

/// The lights of a view about its eye; ambient ones have no place.
pub(crate) fn placed_lights(view: &View, scene: &Scene) -> Vec<PlacedLight> {
    let lights = view.lights.iter();
    lights.filter_map(|one| light(one, &view.camera, scene)).collect()
}

/// The ambient light of the scene and of all ambient lights.
pub(crate) fn ambient(view: &View) -> [f32; 3] {
    let lights = view.lights.iter().filter(|light| light.light.kind == LightKind::Ambient);
    lights.fold(view.ambient, |sum, light| {
        std::array::from_fn(|channel| sum[channel] + light.light.ambient[channel])
    })
}

/// How much darker wires are drawn over a light background, in stops.
const WIRES_ON_LIGHT: f32 = 2.0;

/// From which luminance on a background, as far as it is opaque, is light.
const LIGHT: f32 = 0.35;

/// Exposure and tone curve, if they change anything. Wires are lit like their faces, of which light ones
/// would vanish over a light background: they are drawn darker there.
pub(crate) fn display(view: &View) -> Option<Display> {
    let [r, g, b, alpha] = view.background.color(0.5);
    let is_light = (r * 0.2126 + g * 0.7152 + b * 0.0722) * alpha > LIGHT;
    let has_wires = view.edges.is_some_and(|edges| edges.wireframe);
    let darker = if has_wires && is_light { WIRES_ON_LIGHT } else { 0.0 };
    let display = Display::new(view.exposure - darker, view.tone);
    (!display.is_identity()).then_some(display)
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
