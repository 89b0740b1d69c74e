//! Colours that can be computed by hand.

use crate::scenes::{bytes, execution, frontal, linear, matte, middle, scene, square, view};
use luxel_lighting::{Attenuation, Fog, FogLaw, Light, LightKind, Material, Reflection};
use luxel_math::SimdLevel;
use luxel_render::{Background, Cull, Edges, Layer, LayerValues, Renderer};
use luxel_scene::{DMat4, DVec3, Node, NodeId, Placement, SceneLight, Sides};

#[test]
fn a_white_surface_facing_a_unit_light_is_white() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    assert_eq!(middle(&bytes(&scene, &view(16))), [255; 4]);
}

#[test]
fn half_the_light_is_byte_188_by_the_curve_of_srgb() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut view = view(16);
    view.lights = vec![frontal([0.5; 3])];
    assert_eq!(middle(&bytes(&scene, &view)), [188, 188, 188, 255]);
}

#[test]
fn every_model_that_promises_it_gives_the_same_white() {
    for reflection in [Reflection::Lambert, Reflection::Phong, Reflection::BlinnPhong] {
        let mut material = matte([1.0; 3]);
        material.constants = Material { reflection, k_s: 0.0, ..material.constants };
        let scene = scene(vec![(square(0.0), material)]);
        assert_eq!(middle(&linear(&scene, &view(16))), [1.0; 4]);
    }
}

#[test]
fn a_tilted_surface_gets_the_cosine_of_the_light() {
    let mut scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    scene.nodes[0].parent_from_node = DMat4::from_rotation_x(std::f64::consts::FRAC_PI_3).into();
    let [r, ..] = middle(&linear(&scene, &view(16)));
    assert!((r - 0.5).abs() < 1e-6, "{r}");
}

#[test]
fn reversed_winding_is_lit_like_the_right_one() {
    let right = scene(vec![(square(0.0), matte([0.3, 0.6, 0.9]))]);
    let mut mesh = square(0.0);
    mesh.triangles = vec![[2, 1, 0], [3, 2, 0]];
    let reversed = scene(vec![(mesh, matte([0.3, 0.6, 0.9]))]);
    assert_eq!(bytes(&right, &view(16)), bytes(&reversed, &view(16)));
}

#[test]
fn a_surface_seen_from_behind_is_lit_on_the_side_that_is_seen() {
    let mut scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    scene.nodes[0].parent_from_node = DMat4::from_rotation_y(std::f64::consts::PI).into();
    assert_eq!(middle(&bytes(&scene, &view(16))), [255; 4]);
}

#[test]
fn back_faces_are_left_out_where_the_material_or_the_view_says_so() {
    let mut material = matte([1.0; 3]);
    let mut mesh = square(0.0);
    mesh.triangles = vec![[2, 1, 0], [3, 2, 0]];
    let both = scene(vec![(mesh.clone(), material.clone())]);
    material.sides = Sides::Front;
    let front = scene(vec![(mesh, material)]);
    let alpha = |scene, cull| middle(&bytes(scene, &view(16).with_cull(cull)))[3];
    assert_eq!(alpha(&both, Cull::Auto), 255);
    assert_eq!(alpha(&both, Cull::Back), 0);
    assert_eq!(alpha(&front, Cull::Auto), 0);
    assert_eq!(alpha(&front, Cull::None), 255);
}

#[test]
fn a_mirroring_transform_turns_neither_culling_nor_light_round() {
    let mut material = matte([1.0; 3]);
    material.sides = Sides::Front;
    let mut scene = scene(vec![(square(0.0), material)]);
    scene.nodes[0].parent_from_node = DMat4::from_scale(DVec3::new(-1.0, 1.0, 1.0)).into();
    assert_eq!(middle(&bytes(&scene, &view(16))), [255; 4]);
}

#[test]
fn fog_goes_by_the_distance_along_the_view() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut view = view(16);
    let law = FogLaw::DepthCue { near: 8.0, far: 12.0, front: 1.0, back: 0.0 };
    view.fog = Some(Fog { color: [0.0, 0.0, 1.0], law });
    // The square lies 10 in front of the eye: half light, half fog.
    assert_eq!(middle(&linear(&scene, &view)), [0.5, 0.5, 1.0, 1.0]);
}

#[test]
fn edge_pixels_weigh_their_samples() {
    // The square's left edge at x = -1 lies at pixel 4.5 of 18: half of the pixel is covered.
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut view = view(18);
    view.samples = 16;
    let pixels = linear(&scene, &view);
    let [r, g, b, alpha] = pixels[9 * 18 + 4];
    assert_eq!([r, g, b, alpha], [1.0, 1.0, 1.0, 0.5]);
    view.background = [0.0, 0.0, 1.0, 1.0].into();
    let pixels = linear(&scene, &view);
    assert_eq!(pixels[9 * 18 + 4], [0.5, 0.5, 1.0, 1.0]);
}

#[test]
fn wires_are_drawn_along_polygons_and_not_along_diagonals() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut view = view(64);
    view.edges = Some(Edges::WIREFRAME);
    let pixels = bytes(&scene, &view);
    let alpha = |x: usize, y: usize| pixels[y * 64 + x][3];
    assert_eq!(alpha(32, 16), 255, "upper edge");
    assert_eq!(alpha(16, 32), 255, "left edge");
    assert_eq!(alpha(32, 31), 0, "middle, where the diagonal runs");
    view.edges = Some(Edges::OVER_FACES);
    let pixels = bytes(&scene, &view);
    assert_eq!(pixels[32 * 64 + 32], [255; 4]);
    // The pixel's centre is half a pixel from the edge: half covered by a line one pixel wide.
    assert!(pixels[16 * 64 + 32][0] < 192, "an edge over the face is dark");
}

#[test]
fn wires_are_read_on_white_paper() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut view = view(64);
    view.edges = Some(Edges::WIREFRAME);
    let upper_edge = |view: &_| linear(&scene, view)[16 * 64 + 32];
    assert_eq!(upper_edge(&view), [1.0; 4], "over nothing, it is lit like its face");
    for background in [[0.0, 0.0, 0.0, 1.0].into(), [1.0, 1.0, 1.0, 0.2].into()] {
        view.background = background;
        assert_eq!(upper_edge(&view), [1.0; 4], "{background:?}");
    }
    for background in [[1.0; 4].into(), Background::Studio] {
        view.background = background;
        assert_eq!(upper_edge(&view), [0.25, 0.25, 0.25, 1.0], "{background:?}");
    }
}

#[test]
fn the_studio_is_a_gradient_from_the_top_of_the_picture_to_its_bottom() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let view = view(64).with_background(Background::Studio).with_samples(4);
    let pixels = linear(&scene, &view);
    for row in 0..64 {
        let [r, g, b, alpha] = Background::Studio.color((row as f32 + 0.5) / 64.0);
        let [shown_r, shown_g, shown_b, shown_alpha] = pixels[row * 64];
        assert_eq!((shown_alpha, alpha), (1.0, 1.0));
        let off = (shown_r - r).abs().max((shown_g - g).abs()).max((shown_b - b).abs());
        assert!(off < 1e-3, "row {row}: off by {off}");
    }
    assert_eq!(pixels[32 * 64 + 32], [1.0; 4], "the square is before it");
}

#[test]
fn a_red_light_leaves_a_green_surface_black() {
    let scene = scene(vec![(square(0.0), matte([0.0, 1.0, 0.0]))]);
    let mut view = view(16);
    view.lights = vec![frontal([1.0, 0.0, 0.0])];
    assert_eq!(middle(&bytes(&scene, &view)), [0, 0, 0, 255]);
    view.lights = vec![frontal([1.0, 1.0, 0.0])];
    assert_eq!(middle(&bytes(&scene, &view)), [0, 255, 0, 255]);
}

/// A lamp of intensity 1 that fades with the square of the distance.
fn lamp(placement: Placement, position: DVec3) -> SceneLight {
    let light = Light {
        attenuation: Attenuation::INVERSE_SQUARE,
        ..Light::new(LightKind::Point, [1.0; 3])
    };
    SceneLight { light, placement, position, ..frontal([0.0; 3]) }
}

#[test]
fn a_light_on_a_node_moves_with_it() {
    let mut scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let arm = DMat4::from_translation(DVec3::new(0.0, 3.0, 0.0))
        * DMat4::from_rotation_x(std::f64::consts::FRAC_PI_2);
    scene.nodes.push(Node::root("arm", None).at(None, arm));
    let on_arm = Placement::Node(NodeId(scene.nodes.len() as u32 - 1));
    // A quarter turn about x takes (0, 2, 3) to (0, -3, 2), and the arm's place that to (0, 0, 2).
    let mut by_node = view(16);
    by_node.lights = vec![lamp(on_arm, DVec3::new(0.0, 2.0, 3.0))];
    let mut by_world = view(16);
    by_world.lights = vec![lamp(Placement::World, DVec3::new(0.0, 0.0, 2.0))];
    let (on_node, in_world) = (linear(&scene, &by_node), linear(&scene, &by_world));
    assert!(middle(&in_world)[0] > 0.2);
    let differ = |(one, other): (&[f32; 4], &[f32; 4])| (one[0] - other[0]).abs() > 1e-6;
    assert!(!on_node.iter().zip(&in_world).any(differ), "the same place, the same light");
    let last = scene.nodes.len() - 1;
    scene.nodes[last].parent_from_node = DMat4::IDENTITY.into();
    assert!(on_node.iter().zip(&linear(&scene, &by_node)).any(differ), "the light has moved");
}

#[test]
fn a_light_in_the_camera_stays_where_the_eye_goes() {
    let scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    let mut front = view(16);
    front.lights = vec![lamp(Placement::Camera, DVec3::new(0.0, 0.0, -8.5))];
    // The eye stands at z = 10, so the lamp is 1.5 before the square.
    let expected = 1.0 / 2.25;
    assert!((middle(&linear(&scene, &front))[0] - expected).abs() < 0.01);
    let mut nearer = front.clone();
    nearer.camera.view_from_world =
        luxel_scene::Camera::look_at(DVec3::Z * 11.0, DVec3::ZERO, DVec3::Y);
    assert!((middle(&linear(&scene, &nearer))[0] - 1.0 / 6.25).abs() < 0.01);
}

#[test]
fn the_layer_of_n_dot_l_is_the_cosine_of_the_first_light_negative_behind() {
    let mut scene = scene(vec![(square(0.0), matte([1.0; 3]))]);
    scene.nodes[0].parent_from_node = DMat4::from_rotation_x(std::f64::consts::FRAC_PI_3).into();
    let mut view = view(16);
    let of = |view: &luxel_render::View| {
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let LayerValues::F32(values) = renderer.layers(view, &[Layer::NDotL]).unwrap().remove(0)
        else {
            panic!("a cosine is no id")
        };
        (middle(&values), values[0])
    };
    view.lights.push(frontal([1.0; 3]));
    view.lights[1].direction = DVec3::X;
    let (cosine, outside) = of(&view);
    assert!((cosine - 0.5).abs() < 1e-6 && outside == 0.0, "{cosine} {outside}");
    view.lights[0].direction = DVec3::Z;
    assert!((of(&view).0 + 0.5).abs() < 1e-6);
}
