//! Settings of views where they go beyond the line of the program: maps of environments, cameras of one's own, no lights.

use luxel::Settings;
use luxel::lighting::{EnvironmentMap, EquirectangularImage};
use luxel::scene::{DVec3, Lens, Size, Viewpoint, demos, fit_view};
use std::sync::Arc;

#[test]
fn the_file_of_an_environment_is_named_and_its_map_is_used_when_given() {
    let scene = demos::demo("teapot").unwrap();
    let mut settings =
        Settings::new([("environment", "sky.hdr"), ("environment-rotation", "90")]).unwrap();
    assert_eq!(settings.environment_file().unwrap(), Some("sky.hdr".into()));
    assert_eq!(
        settings.view(&scene).unwrap_err().to_string(),
        "`environment`: sky.hdr is a file: open it before"
    );

    let image = EquirectangularImage { width: 2, height: 1, light: vec![[1.0, 2.0, 3.0]; 2] };
    settings.set_environment_map(Arc::new(EnvironmentMap::new("sky", image)));
    let view = settings.view(&scene).unwrap();
    let used = view.environment.map().expect("the map");
    assert_eq!((used.map().name(), used.rotation_degrees()), ("sky", 90.0));
}

#[test]
fn a_camera_of_ones_own_takes_the_place_of_the_settings() {
    let scene = demos::demo("teapot").unwrap();
    let size = Size { width: 40, height: 30 };
    let lens = Lens::Orthographic { height: 3.0 };
    let viewpoint = Viewpoint { up: DVec3::Y, azimuth_radians: 1.0, elevation_radians: 0.1 };
    let camera = fit_view(&scene, &viewpoint, lens, size);
    let settings = Settings::new([("size", "9x9"), ("fov", "20"), ("samples", "8")]).unwrap();
    let view = settings.view_from(&scene, camera, size).unwrap();
    assert_eq!((view.size, view.camera, view.samples), (size, camera, 8));
}

#[test]
fn lights_that_replace_the_scenes_may_be_none() {
    let scene = demos::demo("teapot").unwrap();
    let mut settings = Settings::default();
    assert!(!settings.view(&scene).unwrap().lights.is_empty());
    settings.replace_lights();
    let view = settings.view(&scene).unwrap();
    assert_eq!((view.lights.len(), view.ambient), (0, [0.0; 3]));
}
