//! Feedback against OpenGL's: the figures are those that Mesa 22.3.6 (llvmpipe) wrote into its own
//! feedback buffer for the same triangles, lights and material.
//!
//! Mesa cuts polygons into triangles before it writes them; here they are whole. So corners are
//! compared as a set, and polygons by the corners in order where Mesa's are whole too.

use crate::scenes::{execution, matte, scene, square, view};
use luxel_lighting::{Attenuation, Cone, Light, LightKind, Material, Reflection};
use luxel_math::SimdLevel;
use luxel_render::{Feedback, FeedbackBuffer, FeedbackType, Renderer, Shading, ShadingMode, View};
use luxel_scene::{
    Camera, DMat4, DVec3, Lens, Lines, MaterialId, Mesh, Placement, Points, Projection, Scene,
    SceneLight, SceneMaterial, Size,
};

const SIZE: Size = Size { width: 200, height: 100 };

/// The material of the GL program: ambient and diffuse (.6, .5, .4), specular .3, shininess 20.
fn material() -> SceneMaterial {
    let constants = Material {
        reflection: Reflection::BlinnPhong,
        diffuse: [0.6, 0.5, 0.4],
        specular: [1.0; 3],
        emission: [0.02, 0.01, 0.0],
        k_s: 0.3,
        shininess: 20.0,
        ..matte([0.0; 3]).constants
    };
    SceneMaterial { constants, ..SceneMaterial::default() }
}

/// A directional light, and a spot with attenuation, as the GL program has them.
fn lights() -> Vec<SceneLight> {
    let sun = SceneLight {
        name: "sun".to_owned(),
        light: Light::new(LightKind::Directional, [0.5, 0.4, 0.3]),
        placement: Placement::World,
        position: DVec3::ZERO,
        direction: DVec3::new(-1.0, -2.0, -3.0),
    };
    let cone = Cone::Exponent { cos_cutoff: 0.5, exponent: 2.0 };
    let spot = SceneLight {
        name: "spot".to_owned(),
        light: Light {
            ambient: [0.1, 0.0, 0.0],
            specular: [0.7; 3],
            attenuation: Attenuation { coefficients: [1.0, 0.1, 0.05], ..Attenuation::NONE },
            ..Light::new(LightKind::Spot(cone), [0.9; 3])
        },
        position: DVec3::new(0.5, 1.0, -1.0),
        direction: DVec3::new(0.0, -0.3, -1.0),
        ..sun.clone()
    };
    vec![sun, spot]
}

/// `glFrustum(-1, 1, -.5, .5, 1, 20)`.
fn frustum() -> View {
    let fov_y_radians = 2.0 * libm::atan(0.5);
    seen(Projection { lens: Lens::Perspective { fov_y_radians }, near: 1.0, far: 20.0 })
}

/// `glOrtho(-4, 4, -2, 2, 1, 20)`.
fn ortho() -> View {
    seen(Projection { lens: Lens::Orthographic { height: 4.0 }, near: 1.0, far: 20.0 })
}

fn seen(projection: Projection) -> View {
    view(1)
        .with_size(SIZE)
        .with_camera(Camera { view_from_world: DMat4::IDENTITY, projection })
        .with_lights(lights())
        .with_ambient([0.1, 0.1, 0.2])
        .with_shading(Shading { mode: ShadingMode::Gouraud, ..Shading::default() })
}

fn triangle(positions: [[f32; 3]; 3], normals: [[f32; 3]; 3]) -> Mesh {
    Mesh {
        positions: positions.to_vec(),
        triangles: vec![[0, 1, 2]],
        normals: normals.to_vec(),
        uvs: [vec![[0.0, 0.0], [1.0, 0.0], [0.25, 0.5]], Vec::new()],
        ..Mesh::default()
    }
}

const NORMALS: [[f32; 3]; 3] = [[0.0, 0.6, 0.8], [0.6, 0.0, 0.8], [0.0, 0.0, 1.0]];
const INSIDE: [[f32; 3]; 3] = [[-1.0, -0.5, -4.0], [1.5, -0.5, -3.0], [0.0, 0.8, -5.0]];
const CROSSING: [[f32; 3]; 3] = [[-9.0, -0.5, -4.0], [1.5, -0.5, -0.2], [0.0, 0.8, -5.0]];

fn buffer(scene: &Scene, view: &View, of: FeedbackType, room: usize) -> FeedbackBuffer {
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    renderer.feedback_buffer(view, of, room).unwrap()
}

fn near(found: &[f32], expected: &[f32]) -> bool {
    // Mesa clips and interpolates in f32.
    let close = |(a, b): (&f32, &f32)| (a - b).abs() <= 2e-5 * b.abs().max(1.0);
    found.len() == expected.len() && found.iter().zip(expected).all(close)
}

#[test]
fn a_triangle_inside_has_mesa_s_corners_and_light() {
    let scene = scene(vec![(triangle(INSIDE, NORMALS), material())]);
    let found = buffer(&scene, &frustum(), FeedbackType::ThreeDColor, 1000);
    #[rustfmt::skip]
    let mesa = [
        1795.0, 3.0,
        75.0, 37.5, 0.7894737, 0.623727, 0.4453403, 0.3499584, 1.0,
        150.0, 33.33334, 0.7017543, 0.441888, 0.2982073, 0.2384918, 1.0,
        100.0, 66.0, 0.8421053, 0.7303786, 0.5520144, 0.4547974, 1.0,
    ];
    assert_eq!(&found.values()[..2], [FeedbackBuffer::PASS_THROUGH_TOKEN, 0.0]);
    assert!(near(&found.values()[2..], &mesa), "{:?}", found.values());
}

#[test]
fn a_triangle_that_leaves_by_three_planes_has_mesa_s_corners_light_and_texture_coordinates() {
    let scene = scene(vec![(triangle(CROSSING, NORMALS), material())]);
    let found = buffer(&scene, &frustum(), FeedbackType::FourDColorTexture, 1000);
    // x, y, z, w, red, green, blue, alpha, s, t, r, q
    #[rustfmt::skip]
    let mesa = [
        [0.0, 53.33334, 0.8187134, 4.5, 0.5496786, 0.4023558, 0.325228, 1.0, 0.125, 0.25, 0.0, 1.0],
        [0.0, 7.051285, 0.148448, 1.164179, 0.3328267, 0.2285625, 0.1811478, 1.0, 0.7462686, 0.0, 0.0, 1.0],
        [28.94736, 0.0, 0.0, 1.0, 0.3307337, 0.2271653, 0.1803077, 1.0, 0.7894737, 0.0, 0.0, 1.0],
        [200.0, 18.90381, 0.0, 1.0, 0.3814325, 0.2694526, 0.217246, 1.0, 0.864094, 0.07270695, 0.0, 1.0],
        [200.0, 30.53333, 0.1684209, 1.190476, 0.405106, 0.288794, 0.2336995, 1.0, 0.8452381, 0.1031746, 0.0, 1.0],
        [100.0, 66.0, 0.8421053, 5.0, 0.7303786, 0.5520144, 0.4547974, 1.0, 0.25, 0.5, 0.0, 1.0],
    ];
    let values = &found.values()[2..];
    assert_eq!(values[0], FeedbackBuffer::POLYGON_TOKEN);
    // Mesa's own corner in (28.9, 0) is written twice: two planes meet there.
    let mut corners: Vec<&[f32]> = Vec::new();
    for corner in values[2..].chunks(12) {
        if corners.iter().all(|other| !near(other, corner)) {
            corners.push(corner);
        }
    }
    for corner in mesa {
        assert!(corners.iter().any(|found| near(found, &corner)), "{corner:?} of {corners:?}");
    }
    assert_eq!(corners.len(), mesa.len(), "{corners:?}");
}

#[test]
fn points_lines_and_a_polygon_beyond_far_are_mesa_s() {
    let positions = vec![
        [1.0, 1.0, -5.0],
        [-3.0, 0.5, -5.0],
        [9.0, 1.0, -5.0],
        [-6.0, 0.0, -5.0],
        [2.0, 1.0, -5.0],
        [0.0, 0.0, -9.0],
        [0.0, 1.0, -9.0],
        [-1.5, -1.0, -5.0],
        [9.0, -1.0, -5.0],
        [0.0, 1.5, -25.0],
    ];
    let (of, normals) = (MaterialId(0), vec![[0.0, 0.6, 0.8]; 10]);
    let mesh = Mesh {
        positions,
        normals,
        triangles: vec![[7, 8, 9]],
        points: vec![Points { indices: vec![0, 1, 2], material: of }],
        lines: vec![Lines { segments: vec![[3, 4], [5, 6]], material: of }],
        ..Mesh::default()
    };
    let scene = scene(vec![(mesh, material())]);
    let found = buffer(&scene, &ortho(), FeedbackType::ThreeDColor, 1000);
    // The polygon first, as luxel draws; each corner x, y, z, red, green, blue, alpha.
    #[rustfmt::skip]
    let polygon = [
        [200.0, 25.0, 0.2105263, 0.483519, 0.3403683, 0.2650521, 1.0],
        [200.0, 59.72222, 0.7953216, 0.4100952, 0.2850691, 0.220222, 1.0],
        [156.25, 71.875, 1.0, 0.4127559, 0.2870151, 0.2217811, 1.0],
        [90.625, 71.875, 1.0, 0.4552943, 0.3189662, 0.2476554, 1.0],
        [62.5, 25.0, 0.2105263, 0.5726472, 0.4073135, 0.3192649, 1.0],
    ];
    #[rustfmt::skip]
    let points_and_lines = [
        1793.0, 125.0, 75.0, 0.2105263, 0.6986495, 0.5270342, 0.4359169, 1.0,
        1793.0, 25.0, 62.5, 0.2105263, 0.470719, 0.3360988, 0.2687564, 1.0,
        // Mesa says GL_LINE_TOKEN here, as it does not begin a stipple anew.
        1799.0, 0.0, 56.25, 0.2105263, 0.4510943, 0.3231078, 0.2590362, 1.0,
        150.0, 75.0, 0.2105263, 0.6200384, 0.4596998, 0.3760231, 1.0,
        1799.0, 100.0, 50.0, 0.4210527, 0.5252152, 0.3859823, 0.3142473, 1.0,
        100.0, 75.0, 0.4210527, 0.5204251, 0.3823753, 0.3112967, 1.0,
    ];
    let values = found.values();
    assert_eq!(&values[..4], [1792.0, 0.0, 1795.0, 5.0]);
    let (corners, rest) = values[4..].split_at(5 * 7);
    for corner in polygon {
        assert!(corners.chunks(7).any(|found| near(found, &corner)), "{corner:?} of {corners:?}");
    }
    assert!(near(rest, &points_and_lines), "{rest:?}");
}

#[test]
fn each_type_writes_its_values_of_a_corner() {
    let scene = scene(vec![(triangle(INSIDE, NORMALS), material())]);
    let values = |of| buffer(&scene, &frustum(), of, 1000).values().to_vec();
    let all = values(FeedbackType::FourDColorTexture);
    let first = |count: usize| all[4..4 + count].to_vec();
    assert_eq!(values(FeedbackType::TwoD)[4..6], first(2));
    assert_eq!(values(FeedbackType::ThreeD)[4..7], first(3));
    let colored = values(FeedbackType::ThreeDColorTexture);
    assert_eq!((&colored[4..7], &colored[7..15]), (&all[4..7], &all[8..16]));
    let counts = [
        (FeedbackType::TwoD, 2),
        (FeedbackType::ThreeD, 3),
        (FeedbackType::ThreeDColor, 7),
        (FeedbackType::ThreeDColorTexture, 11),
        (FeedbackType::FourDColorTexture, 12),
    ];
    for (of, each) in counts {
        assert_eq!(buffer(&scene, &frustum(), of, 1000).count(), 4 + 3 * each, "{of:?}");
    }
}

#[test]
fn a_full_buffer_is_told_by_a_negative_count() {
    let scene = scene(vec![(triangle(INSIDE, NORMALS), material())]);
    let needed = 4 + 9;
    let count = |room| buffer(&scene, &frustum(), FeedbackType::ThreeD, room).count();
    assert_eq!(count(needed), needed as i64);
    assert_eq!(count(needed - 1), -1);
    assert_eq!(count(0), -1);
}

#[test]
fn flat_shading_gives_a_polygon_one_colour_and_culling_leaves_it_out() {
    let scene = scene(vec![(triangle(INSIDE, NORMALS), material())]);
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let shading = Shading { mode: ShadingMode::Flat, ..Shading::default() };
    let flat = frustum().with_shading(shading);
    let mut colors = Vec::new();
    let mut marks = Vec::new();
    renderer
        .feedback(&flat, |item| match item {
            Feedback::Polygon(corners) => colors.extend(corners.iter().map(|corner| corner.color)),
            Feedback::PassThrough(mark) => marks.push(*mark),
            _ => panic!("there are only triangles"),
        })
        .unwrap();
    assert_eq!((colors.len(), marks), (3, vec![0.0]));
    assert!(colors.iter().all(|color| *color == colors[0]));
    // The same light as the picture's in the middle of the triangle.
    let [r, ..] = renderer.linear(&flat).unwrap().pixels[54 * 200 + 105];
    assert_eq!(r, colors[0][0]);

    let mut turned = triangle(INSIDE, NORMALS);
    turned.triangles = vec![[2, 1, 0]];
    let turned = crate::scenes::scene(vec![(turned, material())]);
    let culled = frustum().with_cull(luxel_render::Cull::Back);
    assert_eq!(buffer(&turned, &culled, FeedbackType::ThreeD, 100).values(), [1792.0, 0.0]);
    assert_eq!(buffer(&turned, &frustum(), FeedbackType::ThreeD, 100).count(), 13);
}

#[test]
fn colours_are_those_of_gouraud_pixels_at_the_corners() {
    // A square before a frontal light: red 1, and a corner of it in the middle of a pixel.
    let scene = scene(vec![(square(0.0), matte([0.7, 0.5, 0.25]))]);
    let found = buffer(&scene, &view(16), FeedbackType::ThreeDColor, 1000);
    let corners: Vec<&[f32]> = found.values()[4..25].chunks(7).collect();
    for corner in corners {
        assert_eq!(corner[3..], [0.7, 0.5, 0.25, 1.0]);
    }
}
