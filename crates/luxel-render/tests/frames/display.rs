//! Exposure and tone curves in frames, ledgers, layers and vectors.

use crate::ledger::many_lights;
use crate::scenes::{
    bytes, execution, fitted, frontal, glass, linear, matte, middle, scene, square, view,
};
use luxel_lighting::{Display, Fog, FogLaw, Tone, encode_srgb};
use luxel_math::{Rgb, SimdLevel};
use luxel_render::{
    Edges, Feedback, Layer, Picture, Renderer, Shading, ShadingMode, SvgOptions, View,
};
use luxel_scene::{Scene, Size, demos};

fn renderer(scene: &Scene) -> Renderer {
    Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap()
}

/// A square of 0.9, 0.6, 0.3 in the middle of the picture, lit this brightly.
fn lit_square(light: f32) -> (Scene, View) {
    let scene = scene(vec![(square(0.0), matte([0.9, 0.6, 0.3]))]);
    (scene, view(40).with_lights(vec![frontal([light; 3])]))
}

#[test]
fn every_pixel_of_ten_scenes_is_explained_with_exposure_and_tone() {
    let size = Size { width: 75, height: 50 };
    let mut scenes: Vec<_> = demos::names()
        .into_iter()
        .filter(|(name, _)| *name != "blob")
        .map(|(name, _)| (name, demos::demo(name).unwrap()))
        .collect();
    scenes.truncate(9);
    scenes.push(("glass", glass()));
    assert_eq!(scenes.len(), 10);
    let modes = [
        ShadingMode::Phong,
        ShadingMode::Gouraud,
        ShadingMode::Phong,
        ShadingMode::Flat,
        ShadingMode::Subdivided { tolerance: 2.0 },
    ];
    for (number, (name, scene)) in scenes.into_iter().enumerate() {
        let renderer = renderer(&scene);
        let away = scene.bounds().radius() as f32;
        let law = FogLaw::Exponential { density: 0.2 / away };
        for (at, tone) in Tone::ALL.into_iter().enumerate() {
            let mode = modes[(number + at) % modes.len()];
            let view = fitted(&scene, size)
                .with_samples([4, 1][at % 2])
                .with_lights(many_lights(&scene))
                .with_fog((at == 2).then_some(Fog { color: [0.3, 0.4, 0.9], law }))
                .with_background([0.9, 0.2, 0.1, 0.6])
                .with_shading(Shading { mode, ..Shading::default() })
                .with_exposure([-2.5, 1.0, 0.3, -0.4][at])
                .with_tone(tone);
            let drawn = renderer.rgba8(&view).unwrap().pixels;
            let pixels: Vec<_> = (0..size.width * size.height)
                .map(|at| [at % size.width, at / size.width])
                .collect();
            let explained = renderer.explain_pixels(&view, &pixels).unwrap();
            for (explained, drawn) in explained.into_iter().zip(drawn) {
                let place = format!("{name}, {mode:?}, {tone:?}: {:?}", explained.pixel);
                assert_eq!(explained.rgba8, drawn, "{place}");
                assert_eq!(explained.display, view.display());
                for surface in explained
                    .samples
                    .iter()
                    .flat_map(|entry| &entry.seen)
                    .filter_map(|s| s.surface())
                {
                    let [r, g, b] = surface.color;
                    let shown = view.display().shown(Rgb::new(r, g, b)).lane(0);
                    assert_eq!(shown, surface.display, "{place}");
                }
            }
        }
    }
}

#[test]
fn surfaces_are_exposed_and_the_background_is_not() {
    let (scene, view) = lit_square(8.0);
    let view = view.with_background([1.0; 4]);
    for tone in Tone::ALL {
        let exposed = view.clone().with_exposure(-3.0).with_tone(tone);
        let pixels = bytes(&scene, &exposed);
        assert_eq!(pixels[0], [255; 4], "{tone:?}: the background is white");
        let shown = Display::new(0.0, tone).shown(Rgb::new(0.9, 0.6, 0.3)).lane(0);
        let expected = shown.map(|light| (255.0 * encode_srgb(light.into())).round() as u8);
        assert_eq!(middle(&pixels)[..3], expected, "{tone:?}");
    }
}

#[test]
fn samples_are_exposed_before_their_mean() {
    // Half of a pixel's samples see light of 16, the others white: of a mean before the curve, the light
    // alone would be left.
    let (scene, view) = lit_square(16.0);
    let mut view = view.with_samples(16).with_background([1.0; 4]).with_tone(Tone::Neutral);
    view.size = Size { width: 39, height: 39 };
    let surface = middle(&linear(&scene, &view));
    let mixed = linear(&scene, &view).into_iter().filter(|pixel| {
        let is_between = |at: usize| (surface[at]..1.0).contains(&pixel[at]);
        *pixel != surface && *pixel != [1.0; 4] && (0..3).all(is_between)
    });
    let mut count = 0;
    for pixel in mixed {
        let share = |at: usize| (pixel[at] - surface[at]) / (1.0 - surface[at]);
        assert!((share(1) - share(2)).abs() < 1e-4, "{pixel:?} lies between {surface:?} and white");
        count += 1;
    }
    assert!(count > 20, "{count}");
}

#[test]
fn layers_of_light_are_before_exposure_and_tone() {
    let scene = demos::demo("spheres").unwrap();
    let renderer = renderer(&scene);
    let size = Size { width: 60, height: 40 };
    let plain = fitted(&scene, size).with_lights(many_lights(&scene));
    let exposed = plain.clone().with_exposure(-2.0).with_tone(Tone::Agx);
    let layers = [Layer::Diffuse, Layer::Specular, Layer::NDotL, Layer::Depth];
    assert_eq!(renderer.layers(&plain, &layers), renderer.layers(&exposed, &layers));
    // A picture that comes from the same pass as layers is exposed.
    let exposed = exposed.with_samples(1);
    let (mut picture, mut values) = (Default::default(), Vec::new());
    renderer.rgba8_with_layers(&exposed, &layers, &mut picture, &mut values).unwrap();
    assert!(picture.pixels == renderer.rgba8(&exposed).unwrap().pixels);
}

#[test]
fn edges_over_faces_are_not_exposed() {
    let (scene, view) = lit_square(1.0);
    let edges = Edges { width: 4.0, color: [0.5, 0.1, 0.8], ..Edges::OVER_FACES };
    let view = view.with_edges(Some(edges));
    let has_ink = |view: &View| {
        let ink = |pixel: &[f32; 4]| {
            pixel.iter().zip(edges.color).all(|(drawn, ink)| (drawn - ink).abs() < 1e-6)
        };
        linear(&scene, view).iter().filter(|pixel| ink(pixel)).count()
    };
    let plain = has_ink(&view);
    assert!(plain > 20);
    assert_eq!(has_ink(&view.with_exposure(-4.0).with_tone(Tone::Aces)), plain);
}

#[test]
fn corners_are_clamped_to_what_the_exposure_makes_white() {
    let (scene, view) = lit_square(1024.0);
    let view = view.with_exposure(-10.0);
    let phong = middle(&bytes(&scene, &view));
    assert_eq!(phong, middle(&bytes(&scene, &lit_square(1.0).1)));
    for mode in
        [ShadingMode::Gouraud, ShadingMode::Flat, ShadingMode::Subdivided { tolerance: 1.0 }]
    {
        let view = view.clone().with_shading(Shading { mode, ..Shading::default() });
        assert_eq!(middle(&bytes(&scene, &view)), phong, "{mode:?}");
        // Light beyond white is cut there.
        let bright = view.with_exposure(-9.0);
        assert_eq!(middle(&bytes(&scene, &bright))[..2], [255, 255], "{mode:?}");
    }
}

#[test]
fn subdivided_light_keeps_its_tolerance_in_exposed_pictures() {
    let scene = demos::demo("teapot").unwrap();
    let renderer = renderer(&scene);
    let view = fitted(&scene, Size { width: 90, height: 60 })
        .with_samples(1)
        .with_lights(vec![frontal([40.0; 3])])
        .with_exposure(-4.0)
        .with_tone(Tone::Neutral);
    let phong = renderer.linear(&view).unwrap().pixels;
    let mode = ShadingMode::Subdivided { tolerance: 3.0 };
    let clamp = luxel_render::Clamp::End;
    let view = view.with_shading(Shading { mode, clamp, ..Shading::default() });
    let subdivided = renderer.linear(&view).unwrap();
    assert!(subdivided.subdivision.unwrap().triangles > 100);
    let mut worst = 0.0_f64;
    for (a, b) in subdivided.pixels.iter().zip(&phong) {
        for channel in 0..3 {
            let steps =
                |pixel: &[f32; 4]| 255.0 * encode_srgb(pixel[channel].clamp(0.0, 1.0).into());
            worst = worst.max((steps(a) - steps(b)).abs());
        }
    }
    assert!(worst <= 3.5, "{worst} steps");
}

#[test]
fn vectors_are_exposed_as_pictures_are() {
    let (scene, view) = lit_square(8.0);
    let renderer = renderer(&scene);
    for tone in Tone::ALL {
        let view = view.clone().with_exposure(-2.0).with_tone(tone);
        let [r, g, b, _] = middle(&bytes(&scene, &view));
        let svg = renderer.svg(&view, &SvgOptions::default()).unwrap().text;
        let fills: Vec<_> = svg.match_indices("fill=\"#").map(|(at, _)| &svg[at + 7..]).collect();
        let near = |text: &&str| {
            let channel = |at: usize| i32::from_str_radix(text.get(at..at + 2).unwrap_or("x"), 16);
            let (Ok(x), Ok(y), Ok(z)) = (channel(0), channel(2), channel(4)) else { return false };
            [(x, r), (y, g), (z, b)].iter().all(|(a, b)| (a - i32::from(*b)).abs() <= 1)
        };
        assert!(fills.iter().any(near), "{tone:?}: {r} {g} {b} in {svg}");

        let mut colors = Vec::new();
        renderer
            .feedback(&view, |item| {
                if let Feedback::Polygon(corners) = item {
                    colors.extend(corners.iter().map(|corner| corner.color));
                }
            })
            .unwrap();
        // Feedback clamps intensities at corners, as it always does.
        let shown = view.display().shown(Rgb::new(4.0_f32, 4.0, 2.4)).lane(0);
        assert!(!colors.is_empty());
        for [r, g, b, alpha] in colors {
            assert_eq!(([r, g, b], alpha), (shown, 1.0), "{tone:?}");
        }
    }
}

#[test]
fn a_picture_may_be_burnt_out_by_its_covered_pixels_alone() {
    let picture = |full: [u8; 4], of_it: usize| {
        let mut pixels = vec![[254, 254, 254, 255]; 100];
        pixels[..of_it].fill(full);
        // However bright the background is.
        pixels.extend([[255, 255, 255, 0]; 300]);
        Picture { size: Size { width: 20, height: 20 }, pixels, ..Picture::default() }
    };
    for channel in 0..3 {
        let mut full = [0, 0, 0, 1];
        full[channel] = 255;
        assert!(!picture(full, 5).may_be_burnt_out(), "a twentieth in channel {channel}");
        assert!(picture(full, 6).may_be_burnt_out(), "more in channel {channel}");
    }
    assert!(!Picture::<[u8; 4]>::default().may_be_burnt_out());
}
