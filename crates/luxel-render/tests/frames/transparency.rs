//! Transparent surfaces: exact mixtures, whatever the order in the file.

use crate::scenes::{linear, matte, middle, scene, square, view};
use luxel_lighting::Reflection;
use luxel_scene::{AlphaMode, Encoding, Image, Mesh, Sampler, SceneMaterial, Texture, TextureUse};
use std::sync::Arc;

/// A surface that shines with its own colour.
fn glass(color: [f32; 3], opacity: f32) -> SceneMaterial {
    let mut material = matte(color);
    material.constants.reflection = Reflection::Unlit;
    material.opacity = opacity;
    material.alpha_mode = if opacity < 1.0 { AlphaMode::Blend } else { AlphaMode::Opaque };
    material
}

/// Red glass before green glass before a blue wall.
fn stack() -> Vec<(Mesh, SceneMaterial)> {
    vec![
        (square(2.0), glass([1.0, 0.0, 0.0], 0.5)),
        (square(1.0), glass([0.0, 1.0, 0.0], 0.25)),
        (square(0.0), glass([0.0, 0.0, 1.0], 1.0)),
    ]
}

#[test]
fn layers_are_mixed_from_back_to_front() {
    let pixel = middle(&linear(&scene(stack()), &view(16)));
    assert_eq!(pixel, [0.5, 0.125, 0.375, 1.0]);
}

#[test]
fn the_order_in_the_file_changes_nothing() {
    let expected = linear(&scene(stack()), &view(16));
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let stack = stack();
        let reordered = order.map(|at| stack[at].clone()).to_vec();
        assert_eq!(linear(&scene(reordered), &view(16)), expected, "{order:?}");
    }
}

#[test]
fn glass_before_nothing_keeps_its_colour_and_has_its_alpha() {
    let things = vec![(square(0.0), glass([1.0, 0.5, 0.0], 0.25))];
    assert_eq!(middle(&linear(&scene(things), &view(16))), [1.0, 0.5, 0.0, 0.25]);
}

#[test]
fn samples_see_the_same_mixture_as_the_centre() {
    let mut view = view(16);
    view.samples = 8;
    assert_eq!(middle(&linear(&scene(stack()), &view)), [0.5, 0.125, 0.375, 1.0]);
}

#[test]
fn pixels_without_glass_are_the_same_beside_it() {
    // Half of the wall behind glass: the other half must not know.
    let wall = || (square(0.0), matte([0.3, 0.7, 0.2]));
    let mut half = square(1.0);
    half.positions.iter_mut().for_each(|position| position[0] = position[0].min(0.0));
    let mut view = view(50);
    view.samples = 4;
    let alone = linear(&scene(vec![wall()]), &view);
    let beside = linear(&scene(vec![wall(), (half, glass([1.0; 3], 0.5))]), &view);
    for y in 0..50 {
        for x in 26..50 {
            assert_eq!(alone[y * 50 + x], beside[y * 50 + x], "({x}, {y})");
        }
    }
}

#[test]
fn masked_texels_are_holes() {
    let mut material = matte([1.0; 3]);
    material.alpha_mode = AlphaMode::Mask { cutoff: 0.5 };
    material.base_color = Some(TextureUse::new(luxel_scene::TextureId(0)).into());
    let mut scene =
        scene(vec![(square(1.0), material), (square(0.0), glass([0.0, 0.0, 1.0], 1.0))]);
    // Left half opaque, right half cut away.
    let texels = vec![[255, 255, 255, 255], [255, 255, 255, 0]];
    let image = Arc::new(Image::new("halves", Encoding::Srgb, 2, 1, texels));
    let sampler = Sampler { magnify: luxel_scene::Filter::Nearest, ..Sampler::default() };
    scene.textures = vec![Texture { image, sampler }];
    let pixels = linear(&scene, &view(16));
    assert_eq!(pixels[8 * 16 + 6], [1.0; 4]);
    assert_eq!(pixels[8 * 16 + 10], [0.0, 0.0, 1.0, 1.0]);
}
