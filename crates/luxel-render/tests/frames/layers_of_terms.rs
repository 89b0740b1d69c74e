//! Layers of terms: they add up to the picture, and are the sums of the ledger's terms.

use crate::ledger::{many_lights, occluded, scenes, styled};
use crate::scenes::{execution, matte, scene, square};
use luxel_math::{Rgb, SimdLevel};
use luxel_render::{Clamp, Layer, LayerValues, RenderError, Renderer, Shading, ShadingMode, View};
use luxel_scene::{DMat4, DVec3, MeshId, Node, Scene, demos};

/// What layers add up to, and what the picture has, at each pixel.
fn sums_of_layers(scene: &Scene, view: &View, layers: &[Layer]) -> Vec<([f32; 3], [f32; 4])> {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let values = renderer.layers(view, layers).unwrap();
    let picture = renderer.linear(view).unwrap();
    let mut sums = vec![[0.0_f32; 3]; picture.pixels.len()];
    for layer in values {
        let LayerValues::F32(values) = layer else { panic!("terms are no whole numbers") };
        for (sum, value) in sums.iter_mut().zip(values.chunks_exact(3)) {
            *sum = [sum[0] + value[0], sum[1] + value[1], sum[2] + value[2]];
        }
    }
    sums.into_iter().zip(picture.pixels).collect()
}

#[test]
fn the_layers_of_terms_add_up_to_the_picture() {
    let terms = [
        Layer::Ambient,
        Layer::Diffuse,
        Layer::Specular,
        Layer::Emission,
        Layer::Environment,
        Layer::Fog,
    ];
    for (name, scene) in scenes().into_iter().filter(|(name, _)| name != "blob") {
        let is_occluded = |round: usize| (name.len() + round).is_multiple_of(4);
        for round in (0..8).chain((8..16).filter(|round| is_occluded(*round))) {
            let view = styled(&scene, round % 8, 1).with_background([0.0; 4]);
            let view = occluded(view, round >= 8);
            for (sum, [r, g, b, alpha]) in sums_of_layers(&scene, &view, &terms) {
                // Colours are straight.
                for (sum, drawn) in sum.into_iter().zip([r, g, b].map(|channel| channel * alpha)) {
                    let off = (sum - drawn).abs();
                    assert!(off <= 2e-5 * drawn.abs().max(1.0), "{name} {round}: {sum} {drawn}");
                }
            }
        }
    }
}

/// Compares layers of terms with sums of the ledger's at each 23rd pixel; how many show a surface.
fn compared_with_ledgers(scene: &Scene, view: &View, name: &str) -> u32 {
    let layers = [Layer::Diffuse, Layer::Specular, Layer::Light("lamp".to_owned())];
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let values = renderer.layers(view, &layers).unwrap();
    // What is kept of a term does not depend on which others are.
    for (layer, values) in layers.iter().zip(&values) {
        assert!(renderer.layers(view, std::slice::from_ref(layer)).unwrap()[0] == *values);
    }
    let pixels: Vec<_> = (0..6300).step_by(23).map(|at| [at % 90, at / 90]).collect();
    let mut compared = 0;
    for explained in renderer.explain_pixels(view, &pixels).unwrap() {
        let [x, y] = explained.pixel;
        let Some(surface) = explained.samples[0].seen[0].surface() else { continue };
        let mut sums = [Rgb::splat(0.0, [0.0; 3]); 3];
        for (number, light) in surface.lights.iter().enumerate() {
            let terms = &light.terms;
            sums = [sums[0] + terms.diffuse, sums[1] + terms.specular, sums[2]];
            if number == 1 {
                sums[2] = terms.ambient + terms.diffuse + terms.specular;
            }
        }
        for (layer, sum) in values.iter().zip(sums) {
            let LayerValues::F32(values) = layer else { panic!("light is no whole number") };
            let at = 3 * (y * 90 + x) as usize;
            assert_eq!(values[at..at + 3], sum.lane(0), "{name}: {x}, {y}");
        }
        compared += 1;
    }
    compared
}

#[test]
fn layers_of_light_from_elsewhere_than_pixels_are_sums_of_the_ledgers_terms() {
    let mut compared = 0;
    for name in ["plane", "cornell", "spheres"] {
        let scene = demos::demo(name).unwrap();
        // Every mode but light at pixels, and in shadow.
        for (round, in_shadow) in [1, 2, 3, 4, 6, 7].map(|round| (round, round < 3)) {
            let view = styled(&scene, round, 1).with_lights(many_lights(&scene)).with_fog(None);
            let view = occluded(view, in_shadow);
            compared += compared_with_ledgers(&scene, &view, &format!("{name}, round {round}"));
        }
    }
    assert!(compared > 1000, "{compared}");
}

/// Squares side by side, smaller than two pixels, whose rows have the same low bits in their triangles' ids.
fn mosaic() -> Scene {
    let colors = [[0.9, 0.2, 0.1], [0.1, 0.3, 0.8]];
    let mut mosaic = scene(colors.map(|color| (square(0.0), matte(color))).to_vec());
    mosaic.nodes = (0..64 * 50)
        .map(|number| {
            let (column, row) = (number % 64, number / 64);
            let tilt = DMat4::from_rotation_y(0.01 * f64::from(number % 97));
            let place = DVec3::new(2.1 * f64::from(column), 2.1 * f64::from(row), 0.0);
            Node {
                parent_from_node: (DMat4::from_translation(place) * tilt).into(),
                ..Node::root(format!("square {number}"), Some(MeshId(number % 2)))
            }
        })
        .collect();
    mosaic
}

#[test]
fn layers_of_many_triangles_and_materials_are_sums_of_the_ledgers_terms() {
    let demo = |name: &'static str| (name, demos::demo(name).unwrap());
    for (name, scene) in [demo("blob"), demo("spheres"), ("mosaic", mosaic())] {
        for mode in [ShadingMode::Flat, ShadingMode::Gouraud] {
            for clamp in [Clamp::End, Clamp::Vertex] {
                let shading = Shading { mode, clamp, ..Shading::default() };
                let view = styled(&scene, 0, 1).with_lights(many_lights(&scene));
                let view = view.with_fog(None).with_shading(shading);
                let compared =
                    compared_with_ledgers(&scene, &view, &format!("{name}, {shading:?}"));
                assert!(compared > 50, "{compared}");
            }
        }
    }
}

#[test]
fn the_layers_of_shadows_and_openness_are_those_of_the_ledger() {
    let scene = demos::demo("plane").unwrap();
    for mode in [ShadingMode::Phong, ShadingMode::Gouraud] {
        let view = occluded(styled(&scene, 0, 1).with_lights(many_lights(&scene)), true)
            .with_shading(Shading { mode, ..Shading::default() });
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let shadow = Layer::Shadow("lamp".to_owned());
        let values = renderer.layers(&view, &[Layer::Openness, shadow]).unwrap();
        let value = |layer: usize, [x, y]: [u32; 2]| match &values[layer] {
            LayerValues::F32(values) => values[(y * 90 + x) as usize],
            LayerValues::U32(_) => panic!("parts of light are no whole numbers"),
        };
        let pixels: Vec<_> = (0..70).flat_map(|y| (0..90).map(move |x| [x, y])).collect();
        let mut partly = [0; 2];
        for explained in renderer.explain_pixels(&view, &pixels).unwrap() {
            let found = [0, 1].map(|layer| value(layer, explained.pixel));
            let Some(surface) = explained.samples[0].seen[0].surface() else {
                assert_eq!(found, [0.0; 2]);
                continue;
            };
            let visibility = surface.lights[1].terms.visibility.unwrap();
            assert_eq!(found, [surface.openness.unwrap(), visibility], "{:?}", explained.pixel);
            for (count, found) in partly.iter_mut().zip(found) {
                *count += u32::from(found > 0.0 && found < 1.0);
            }
        }
        assert!(partly.iter().all(|count| *count > 2), "{mode:?}: {partly:?}");
    }
}

#[test]
fn the_layers_of_lights_add_up_to_their_terms() {
    let scene = demos::demo("spheres").unwrap();
    let view = styled(&scene, 1, 1).with_lights(many_lights(&scene));
    let by_term = sums_of_layers(&scene, &view, &[Layer::Diffuse, Layer::Specular]);
    let lights = ["sun", "lamp", "torch"].map(|name| Layer::Light(name.to_owned()));
    let by_light = sums_of_layers(&scene, &view, &lights);
    let mut seen = 0;
    for ((terms, _), (lights, _)) in by_term.into_iter().zip(by_light) {
        // The lights have an ambient term of their own, too.
        seen += u32::from(lights[0] > 0.01);
        assert!((0..3).all(|channel| lights[channel] >= terms[channel] - 1e-5));
    }
    assert!(seen > 100);
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let unknown = renderer.layers(&view, &[Layer::Light("moon".to_owned())]);
    let lights = ["sun", "lamp", "torch"].map(str::to_owned).to_vec();
    assert_eq!(unknown, Err(RenderError::NoSuchLight { name: "moon".to_owned(), lights }));
    let message = unknown.unwrap_err().to_string();
    assert!(message.contains("`moon`: use `sun`, `lamp`, `torch`"), "{message}");
}
