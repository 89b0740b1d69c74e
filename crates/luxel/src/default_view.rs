//! The default camera, lights and environment of a scene.

use luxel_lighting::Environment;
use luxel_scene::{
    Camera, DEFAULT_AMBIENT, DMat4, DVec3, Lens, Scene, SceneCamera, SceneLight, Size, Viewpoint,
    default_lights, fit_planes, fit_view,
};
use luxel_view::{EnvironmentChoice, View};

/// The angle of view from bottom to top of cameras that no file brings.
pub const DEFAULT_FOV_DEGREES: f64 = 45.0;
/// From where a model without a camera is looked at: from the front towards the right.
pub const DEFAULT_AZIMUTH_DEGREES: f64 = 30.0;
/// From where a model without a camera is looked at: from the horizon upwards.
pub const DEFAULT_ELEVATION_DEGREES: f64 = 20.0;

/// The view of a scene: [`default_camera`], [`lights_of`] and [`environment_of`] it, on transparent
/// black. Its fields are there to be changed.
#[must_use]
pub fn default_view(scene: &Scene, size: Size) -> View {
    default_view_from(scene, default_camera(scene, size), size)
}

/// As [`default_view`], from a given camera: none is fitted.
#[must_use]
pub fn default_view_from(scene: &Scene, camera: Camera, size: Size) -> View {
    let (lights, ambient) = lights_of(scene);
    View::new(size, camera)
        .with_lights(lights)
        .with_ambient(ambient)
        .with_environment(environment_of(scene))
        .with_fog(scene.fog)
        .with_background(scene.background.unwrap_or_default())
}

/// The scene's first camera; without one, a camera that sees all of it from the front, a little
/// from the right and from above.
#[must_use]
pub fn default_camera(scene: &Scene, size: Size) -> Camera {
    let Some(camera) = scene.cameras.first() else {
        let viewpoint = Viewpoint {
            up: scene.up,
            azimuth_radians: DEFAULT_AZIMUTH_DEGREES.to_radians(),
            elevation_radians: DEFAULT_ELEVATION_DEGREES.to_radians(),
        };
        let fov_y_radians = DEFAULT_FOV_DEGREES.to_radians();
        return fit_view(scene, &viewpoint, Lens::Perspective { fov_y_radians }, size);
    };
    let view_from_world = view_from_world_of(camera, scene);
    let (near, far) = fit_planes(&scene.bounds(), &view_from_world);
    let projection = luxel_scene::Projection { lens: camera.lens, near, far };
    Camera { view_from_world, projection }
}

/// From world space to that of a camera of the scene. Scale on its nodes doesn't reach it (glTF
/// 2.0, section 3.10).
#[must_use]
pub fn view_from_world_of(camera: &SceneCamera, scene: &Scene) -> DMat4 {
    let world_from_node =
        camera.node.and_then(|node| scene.world_from_nodes().get(node.index()).copied());
    let Some(world_from_node) = world_from_node else { return camera.view_from_node };
    let world_from_camera = world_from_node * camera.view_from_node.inverse();
    let eye = world_from_camera.w_axis.truncate();
    let back = world_from_camera.z_axis.truncate().normalize_or(DVec3::Z);
    Camera::look_at(eye, eye - back, world_from_camera.y_axis.truncate())
}

/// The scene's own lights, and its own ambient light or none; without any lights, a key and a fill
/// that move with the camera, and a little ambient light.
#[must_use]
pub fn lights_of(scene: &Scene) -> (Vec<SceneLight>, [f32; 3]) {
    let (lights, ambient) = if scene.lights.is_empty() {
        (default_lights(), DEFAULT_AMBIENT)
    } else {
        (scene.lights.clone(), [0.0; 3])
    };
    (lights, scene.ambient.unwrap_or(ambient))
}

/// The scene's own environment; without one, a studio for microfacet materials of scenes without
/// lights of their own, else nothing.
#[must_use]
pub fn environment_of(scene: &Scene) -> EnvironmentChoice {
    if let Some(choice) = &scene.environment {
        choice.clone()
    } else if scene.lights.is_empty() {
        EnvironmentChoice::StudioForMicrofacets
    } else {
        EnvironmentChoice::Always(Environment::None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_scene::{Node, NodeId, demos};

    #[test]
    fn a_camera_s_scale_changes_nothing() {
        let mut scene = Scene::default();
        let turned = DMat4::from_rotation_y(0.5) * DMat4::from_translation(DVec3::Z);
        for scale in [1.0, 20.0] {
            let parent_from_node = turned * DMat4::from_scale(DVec3::splat(scale));
            scene.nodes.push(Node::root("camera", None).at(None, parent_from_node));
        }
        let view = |node| {
            let camera = SceneCamera {
                name: String::new(),
                node: Some(NodeId(node)),
                view_from_node: DMat4::IDENTITY,
                lens: Lens::Orthographic { height: 1.0 },
                planes: None,
            };
            view_from_world_of(&camera, &scene)
        };
        assert!(view(0).abs_diff_eq(turned.inverse(), 1e-14));
        assert!(view(1).abs_diff_eq(view(0), 1e-14));
    }

    #[test]
    fn a_scene_without_lights_is_lit() {
        let (lights, ambient) = lights_of(&Scene::default());
        assert!(!lights.is_empty() && ambient != [0.0; 3]);
        let room = demos::demo("cornell").unwrap();
        assert_eq!(lights_of(&room), (room.lights.clone(), [0.0; 3]));
    }
}
