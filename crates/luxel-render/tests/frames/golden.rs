//! Golden pictures: PNG files, which may change only when the pictures are meant to.
//!
//! `LUXEL_BLESS=1` writes the files of `tests/golden` instead of comparing with them, and fails.

use luxel_render::{EnvironmentChoice, Renderer};
use luxel_scene::{Size, default_lights, demos};
use luxel_testing::golden::{Golden, Pixels};
use std::path::Path;

use crate::scenes::{execution, fitted};
use luxel_math::SimdLevel;

/// Each demo's picture, 320x180 with 4 samples a pixel, from its fitted view.
#[test]
fn demos_look_as_they_did() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let output = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    let mut golden = Golden::new(&folder, &output);
    for (name, _) in demos::names() {
        let scene = demos::demo(name).unwrap();
        let size = Size { width: 320, height: 180 };
        let mut lights = scene.lights.clone();
        if lights.is_empty() {
            lights = default_lights();
        }
        let view = fitted(&scene, size)
            .with_samples(4)
            .with_lights(lights)
            .with_ambient([0.1; 3])
            .with_environment(EnvironmentChoice::StudioForMicrofacets);
        let renderer = Renderer::new(scene.clone(), &execution(0, SimdLevel::Auto)).unwrap();
        let rgba = renderer.rgba8(&view).unwrap().pixels;
        golden.compare(name, &Pixels { width: size.width, rgba });
    }
    golden.finish();
}
