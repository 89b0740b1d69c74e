//! Explanations against pictures, byte for byte, with all that keeps light away and all that is done to it.

use crate::view;
use luxel::formats::{Limits, open_environment};
use luxel::lighting::Tone;
use luxel::render::{EnvironmentChoice, Execution, Renderer, View};
use luxel::scene::{NormalOptions, Size, Viewpoint, demos};
use luxel::view::AmbientOcclusion;
use std::sync::Arc;

/// An environment from a file: a Radiance picture of 8x4 texels, each of another colour and up to 4 bright.
fn environment(up: luxel::scene::DVec3) -> EnvironmentChoice {
    let mut bytes = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n".to_vec();
    for texel in 0..32_u8 {
        bytes.extend([40 + 6 * texel, 255 - 7 * texel, 90 + 40 * (texel % 5), 126 + texel % 5]);
    }
    let path = std::env::temp_dir().join(format!("luxel-explained-{}.hdr", std::process::id()));
    std::fs::write(&path, bytes).unwrap();
    let map = open_environment(&path, &Limits::default()).unwrap().map;
    std::fs::remove_file(&path).unwrap();
    EnvironmentChoice::of_map(Arc::new(map), Viewpoint::frame(up), 50.0)
}

#[test]
fn explain_gives_the_bytes_of_the_picture_with_everything_on() {
    let size = Size { width: 40, height: 30 };
    let tones = [Tone::Neutral, Tone::Aces, Tone::Agx];
    let names = [
        "teapot",
        "spheres",
        "cornell",
        "plane",
        "welcome",
        "lab-corrugated",
        "lab-contact",
        "lab-terminator",
        "lab-silhouette",
        "lab-lamp",
    ];
    for (number, name) in names.into_iter().enumerate() {
        let mut scene = demos::demo(name).unwrap();
        scene.compute_normals(&NormalOptions::default());
        let environment = environment(scene.up);
        let radius = scene.bounds().radius();
        let mut view: View = view(&scene, 0.6 + 0.4 * number as f64)
            .with_size(size)
            .with_samples([1, 4, 8][number % 3])
            .with_light_rays(4)
            .with_ambient([0.2, 0.15, 0.1])
            .with_ambient_occlusion(Some(AmbientOcclusion { radius: Some(radius), rays: 5 }))
            .with_ground(true)
            .with_environment(environment)
            .with_environment_background(number % 2 == 0)
            .with_background([0.1, 0.2, 0.4, 0.5])
            .with_exposure(0.7 - 0.3 * number as f32)
            .with_tone(tones[number % 3]);
        view.lights[0].light.angle_degrees = 6.0;
        view.lights[1].light.radius = 0.1 * radius as f32;
        let renderer = Renderer::new(scene, &Execution::default()).unwrap();
        let picture = renderer.rgba8(&view).unwrap().pixels;
        let pixels: Vec<_> =
            (0..size.height).flat_map(|y| (0..size.width).map(move |x| [x, y])).collect();
        let explained = renderer.explain_pixels(&view, &pixels).unwrap();
        assert_eq!(explained.len(), picture.len());
        for (explained, drawn) in explained.iter().zip(&picture) {
            assert_eq!(explained.rgba8, *drawn, "{name} at {:?}", explained.pixel);
        }
    }
}
