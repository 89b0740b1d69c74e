//! Objects that share a mesh, beside the same objects with a mesh each.

use crate::scenes::{execution, fitted, matte, square};
use luxel_lighting::Attenuation;
use luxel_math::SimdLevel;
use luxel_render::{
    At, Edges, Interpolation, Layer, Renderer, Shading, ShadingMode, SvgOptions, Unseen, View,
    auto_exposure,
};
use luxel_scene::{
    AlphaMode, DVec3, Joiner, MaterialId, Mesh, NormalOptions, Part, Scene, SceneLight,
    SceneMaterial, Size,
};
use luxel_view::AmbientOcclusion;

/// A square of a material, turned, with its middle at a place.
fn turned_square([x, y, z]: [f32; 3], angle: f32, material: u32) -> Mesh {
    let mut mesh = square(0.0);
    let (sin, cos) = libm::sincosf(angle);
    for position in &mut mesh.positions {
        let [px, py, _] = *position;
        *position = [x + px * cos, y + py, z + px * sin];
    }
    mesh.parts = vec![Part { first: 0, count: 2, material: MaterialId(material) }];
    mesh
}

/// Squares that lie behind and beside one another and cross, quads and pairs of triangles, of several
/// materials: one mesh with a section for each.
fn joined() -> Scene {
    let glass =
        SceneMaterial { alpha_mode: AlphaMode::Blend, opacity: 0.4, ..matte([0.2, 0.9, 0.3]) };
    let mut joiner = Joiner::new(1000);
    for (number, material) in (0_u8..).zip([0, 1, 1, 2, 0, 2, 1]) {
        let at = f32::from(number);
        let place = [0.4 * at - 1.2, 0.25 * (at - 3.0), 0.6 * (at % 3.0)];
        let mut mesh = turned_square(place, 0.5 * at, material);
        if number == 4 {
            mesh.polygons = None;
        }
        if number == 5 {
            // Computed ones split vertices where the two triangles meet.
            mesh.positions[3][2] += 1.4;
        }
        mesh.normals = Vec::new();
        joiner.push(format!("square {number}"), mesh);
    }
    let mut scene = Scene::default();
    joiner.finish(&mut scene);
    scene.materials = vec![matte([0.9, 0.3, 0.2]), matte([0.2, 0.4, 0.9]), glass];
    scene.compute_normals(&NormalOptions::default());
    scene
}

/// Joined objects, and the same with a mesh each.
fn both() -> [Scene; 2] {
    let joined = joined();
    assert_eq!((joined.meshes.len(), joined.objects().len()), (1, 7));
    let separate = joined.separated().into_owned();
    assert_eq!((separate.meshes.len(), separate.objects().len()), (7, 7));
    [joined, separate]
}

fn renderers() -> [Renderer; 2] {
    both().map(|scene| Renderer::new(scene, &execution(1, SimdLevel::Auto)).unwrap())
}

fn views() -> Vec<View> {
    let view = fitted(&both()[1], Size { width: 120, height: 90 }).with_samples(4);
    let mut views = Vec::new();
    for mode in ShadingMode::ALL {
        for interpolation in Interpolation::ALL {
            let shading = Shading { mode, interpolation, ..Shading::default() };
            views.push(view.clone().with_shading(shading));
        }
    }
    let occlusion = Some(AmbientOcclusion { rays: 4, ..AmbientOcclusion::default() });
    let occluded = view.clone().with_ambient([0.4; 3]).with_ambient_occlusion(occlusion);
    views.push(occluded.with_shadows(true));
    for wireframe in [false, true] {
        views.push(view.clone().with_edges(Some(Edges { wireframe, ..Edges::WIREFRAME })));
    }
    views
}

#[test]
fn sections_look_like_meshes_of_their_own() {
    let [joined, separate] = renderers();
    for view in views() {
        let pixels = joined.linear(&view).unwrap().pixels;
        assert!(pixels.iter().filter(|pixel| pixel[3] > 0.0).count() > 300);
        assert!(
            pixels == separate.linear(&view).unwrap().pixels,
            "{:?} {:?}",
            view.shading,
            view.edges
        );
    }
}

/// Rays meet objects of which nothing or all lets light through as one, others apart.
#[test]
fn sections_cast_shadows_as_meshes_of_their_own_whatever_they_are_made_of() {
    for mode in [AlphaMode::Opaque, AlphaMode::Blend] {
        let [joined, separate] = both().map(|mut scene| {
            for material in &mut scene.materials {
                (material.alpha_mode, material.opacity) = (mode, 0.6);
            }
            Renderer::new(scene, &execution(1, SimdLevel::Auto)).unwrap()
        });
        let view = views().into_iter().find(|view| view.shadows).unwrap();
        let pixels = joined.linear(&view).unwrap().pixels;
        assert!(pixels == separate.linear(&view).unwrap().pixels, "{mode:?}");
        let without = joined.linear(&view.clone().with_shadows(false)).unwrap().pixels;
        assert!(pixels != without, "{mode:?}");
        for pixel in [[60, 45], [30, 40], [80, 50], [70, 60]] {
            let explained = [&joined, &separate]
                .map(|renderer| renderer.explain(&view, At::Pixel(pixel)).unwrap());
            assert_eq!(format!("{:?}", explained[0]), format!("{:?}", explained[1]));
        }
    }
}

/// More triangles than are metered: each of them counts once, not once for each object.
#[test]
fn exposure_is_that_of_the_triangles_which_a_light_reaches_as_sections_or_as_meshes() {
    let mut joiner = Joiner::new(1000);
    for number in 0..1500_u16 {
        let at = f32::from(number);
        joiner.push(format!("square {number}"), turned_square([at * 0.01, 0.0, 0.0], at, 0));
    }
    let mut joined = Scene { materials: vec![matte([0.5; 3])], ..Scene::default() };
    joiner.finish(&mut joined);
    let separate = joined.separated().into_owned();
    assert_eq!((joined.meshes.len(), separate.meshes.len()), (1, 1500));
    let mut view = fitted(&separate, Size { width: 120, height: 90 });
    view.lights = vec![SceneLight::point(DVec3::new(-1.0, 0.5, 0.0), [9e3; 3])];
    view.lights[0].light.attenuation = Attenuation::INVERSE_SQUARE;
    let [joined, separate] = [joined, separate].map(|scene| auto_exposure(&scene, &view));
    assert_eq!(joined, separate);
    assert!(joined.ev < -4.0, "{joined:?}");
}

#[test]
fn layers_number_sections_as_objects() {
    let [joined, separate] = renderers();
    for view in views() {
        let found = joined.layers(&view, &Layer::ALL).unwrap();
        assert_eq!(
            format!("{found:?}"),
            format!("{:?}", separate.layers(&view, &Layer::ALL).unwrap())
        );
    }
}

#[test]
fn explanations_name_sections_as_objects() {
    let [joined, separate] = renderers();
    let view = &views()[0];
    for [x, y] in [[60, 45], [30, 40], [80, 50], [70, 60], [2, 2]] {
        let explained = [&joined, &separate].map(|renderer| {
            let explanation = renderer.explain(view, At::Pixel([x, y])).unwrap();
            let unseen = Unseen::new(renderer, view, &explanation).unwrap();
            format!("{explanation:?} {unseen:?}")
        });
        assert!(explained[0] == explained[1], "{x} {y}: {} {}", explained[0], explained[1]);
    }
}

#[test]
fn vectors_of_sections_are_those_of_meshes() {
    let [joined, separate] = renderers();
    let view = &views()[0];
    let options = SvgOptions::default();
    assert_eq!(
        joined.svg(view, &options).unwrap().text,
        separate.svg(view, &options).unwrap().text
    );
    let fed = [joined, separate].map(|renderer| {
        let mut items = Vec::new();
        renderer.feedback(view, |item| items.push(format!("{item:?}"))).unwrap();
        items
    });
    assert_eq!(fed[0], fed[1]);
}

#[test]
fn some_sections_alone_look_like_some_meshes_alone() {
    let [mut joined, mut separate] = renderers();
    let view = &views()[0];
    let all = joined.linear(view).unwrap().pixels;
    for renderer in [&mut joined, &mut separate] {
        renderer.draw_only(|object| object % 2 == 1);
    }
    let some = joined.linear(view).unwrap().pixels;
    assert!(some == separate.linear(view).unwrap().pixels && some != all);
}

#[test]
fn a_mesh_of_sections_is_shown_in_several_places() {
    let scenes = both().map(|mut scene| {
        let again = scene.nodes.clone();
        let place = luxel_scene::DMat4::from_translation(DVec3::new(0.3, 1.1, -0.8));
        scene.nodes.extend(again.into_iter().map(|node| node.at(None, place)));
        scene
    });
    let view = fitted(&scenes[1], Size { width: 120, height: 90 });
    let found = scenes.map(|scene| {
        let renderer = Renderer::new(scene, &execution(1, SimdLevel::Auto)).unwrap();
        renderer.layers(&view, &[Layer::Object, Layer::Triangle, Layer::Z]).unwrap()
    });
    assert!(found[0] == found[1]);
}
