//! A view to report on.

use luxel_lighting::PictureEncoding;
use luxel_render::{
    At, Cull, EnvironmentChoice, Execution, Explanation, Renderer, Shading, Unseen, View,
};
use luxel_scene::{
    DEFAULT_AMBIENT, DVec3, Lens, Scene, Size, Viewpoint, default_lights, demos, fit_view,
};

/// The window of all tests.
pub(crate) const SIZE: Size = Size { width: 96, height: 54 };
/// A pixel that the teapot covers.
pub(crate) const ON_THE_TEAPOT: [u32; 2] = [48, 30];

/// The teapot.
pub(crate) fn teapot() -> Scene {
    demos::demo("teapot").unwrap()
}

/// A view of a whole scene under the default lights.
pub(crate) fn view(scene: &Scene) -> View {
    view_from(scene, 0.3)
}

/// The same from another elevation.
pub(crate) fn view_from(scene: &Scene, elevation_radians: f64) -> View {
    let viewpoint = Viewpoint { up: DVec3::Y, azimuth_radians: 0.5, elevation_radians };
    View::new(SIZE, fit_view(scene, &viewpoint, Lens::Perspective { fov_y_radians: 0.8 }, SIZE))
        .with_samples(4)
        .with_cull(Cull::Auto)
        .with_lights(default_lights())
        .with_ambient(DEFAULT_AMBIENT)
        .with_environment(EnvironmentChoice::StudioForMicrofacets)
        .with_fog(None)
        .with_background([0.0; 4])
        .with_encoding(PictureEncoding::Srgb)
        .with_edges(None)
        .with_shading(Shading::default())
}

/// The ledger of a pixel, with its hidden surfaces.
pub(crate) fn explain(scene: &Scene, view: &View, pixel: [u32; 2]) -> (Explanation, Unseen) {
    let renderer = Renderer::new(scene.clone(), &Execution::default()).unwrap();
    let explanation = renderer.explain(view, At::Pixel(pixel)).unwrap();
    let unseen = Unseen::new(&renderer, view, &explanation).unwrap();
    (explanation, unseen)
}
