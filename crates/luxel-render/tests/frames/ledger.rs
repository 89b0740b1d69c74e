//! The ledger against the frame: what is explained is what was drawn.

use crate::scenes::{execution, fitted, glass, matte, scene, square};
use luxel_lighting::{
    Attenuation, Cone, Fog, FogLaw, Light, LightKind, REFLECTION_MODELS, Reflection, Tone,
};
use luxel_math::SimdLevel;
use luxel_render::{
    At, Background, Clamp, Interpolation, Layer, LayerValues, NormalLength, RenderError, Renderer,
    Shading, ShadingMode, View,
};
use luxel_scene::{DVec3, Placement, Scene, SceneLight, Size};
use luxel_scene::{default_lights, demos, primitives};
use luxel_view::AmbientOcclusion;

/// Numbers without a pattern: a multiplier and an increment of Knuth's MMIX.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, limit: u32) -> u32 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(limit)) as u32
    }
}

/// Lights of all kinds, with everything that a light can have.
pub(crate) fn many_lights(scene: &Scene) -> Vec<SceneLight> {
    let bounds = scene.bounds();
    let (centre, radius) = (bounds.centre(), bounds.radius());
    let light = |name: &str, kind, color, placement, position, direction| SceneLight {
        name: name.to_owned(),
        light: Light {
            ambient: [0.02, 0.0, 0.05],
            specular: [0.5, 0.8, 1.5],
            ..Light::new(kind, color)
        },
        placement,
        position,
        direction,
    };
    let cone = Cone::Exponent { cos_cutoff: 0.8, exponent: 7.0 };
    let mut lights = vec![
        light(
            "sun",
            LightKind::Directional,
            [0.4; 3],
            Placement::World,
            DVec3::ZERO,
            DVec3::new(-1.0, -2.0, -1.0),
        ),
        light(
            "lamp",
            LightKind::Point,
            [2.0, 1.0, 0.5],
            Placement::World,
            centre + DVec3::new(0.5, 0.9, 0.7) * radius,
            DVec3::ZERO,
        ),
        light(
            "torch",
            LightKind::Spot(cone),
            [1.5; 3],
            Placement::Camera,
            DVec3::new(0.3, 0.2, 0.0) * radius,
            DVec3::NEG_Z,
        ),
    ];
    lights[1].light.attenuation = Attenuation {
        range: Some(3.0 * radius as f32),
        ..Attenuation::new([0.5, 0.0, 1.0 / (radius * radius) as f32])
    };
    lights.push(SceneLight { light: Light::ambient([0.05, 0.06, 0.08]), ..lights[0].clone() });
    lights
}

/// Every model, and a mix.
pub(crate) fn reflections() -> Vec<Reflection> {
    let parts = vec![
        (Reflection::OrenNayar, 0.4),
        (Reflection::Microfacet, 0.3),
        (Reflection::Retro, 0.2),
        (Reflection::Mirror, 0.1),
    ];
    let models = REFLECTION_MODELS.iter().map(|model| model.reflection.clone());
    models.chain([Reflection::mixed(parts)]).collect()
}

const fn shading(mode: ShadingMode, interpolation: Interpolation, clamp: Clamp) -> Shading {
    Shading { mode, interpolation, clamp, normal_length: NormalLength::Unit }
}

const SHADINGS: [Shading; 8] = [
    shading(ShadingMode::Phong, Interpolation::Perspective, Clamp::Vertex),
    shading(ShadingMode::Gouraud, Interpolation::Perspective, Clamp::Vertex),
    shading(ShadingMode::Flat, Interpolation::Perspective, Clamp::Vertex),
    shading(ShadingMode::Subdivided { tolerance: 2.0 }, Interpolation::Perspective, Clamp::Vertex),
    shading(ShadingMode::Gouraud, Interpolation::Scanline, Clamp::End),
    shading(ShadingMode::Phong, Interpolation::Scanline, Clamp::Vertex),
    shading(ShadingMode::Gouraud, Interpolation::Screen, Clamp::Vertex),
    shading(ShadingMode::Flat, Interpolation::Screen, Clamp::End),
];

/// All demos, and glass.
pub(crate) fn scenes() -> Vec<(String, Scene)> {
    let demos =
        demos::names().into_iter().map(|(name, _)| (name.to_owned(), demos::demo(name).unwrap()));
    demos.chain([("glass".to_owned(), glass())]).collect()
}

#[test]
fn ten_thousand_explained_pixels_are_the_pictures() {
    const PIXELS_OF_EACH: u32 = 50;
    let mut random = Random(1);
    let mut compared = 0;
    for (name, scene) in scenes() {
        for round in 0..8 {
            let mut scene = scene.clone();
            if round > 0 {
                for (number, material) in scene.materials.iter_mut().enumerate() {
                    let reflections = reflections();
                    let reflection = &reflections[(round + number) % reflections.len()];
                    material.constants.reflection = reflection.clone();
                }
            }
            let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
            for (number, samples) in [1, 2, 4, 8, 16].into_iter().enumerate() {
                // Each mode of shading with every fourth scene; a tree of a million triangles takes long to build.
                let shadows =
                    name != "blob" && samples == 2 && (name.len() + round).is_multiple_of(4);
                let mut view = occluded(styled(&scene, round, samples), shadows);
                // A ground with and without what it does to surfaces, over all backgrounds.
                let has_ground = name != "blob" && (name.len() + round + number) % 3 == 0;
                view.ground = has_ground;
                if has_ground && round % 2 == 0 {
                    view.background = Background::Studio;
                }
                // Without exposure and tone curve, and with every curve.
                view.exposure = [0.0, -1.5, 0.0, 0.8, 0.3][number];
                view.tone = Tone::ALL[number % Tone::ALL.len()];
                let Size { width, height } = view.size;
                // A quarter of the picture where there is a ground, whose rays take long.
                let ([left, top], picture) = if has_ground {
                    let middle = [random.below(width), random.below(height)];
                    let quarter = Size { width: width / 2, height: height / 2 };
                    renderer.rgba8_around(&view, middle, quarter).unwrap()
                } else {
                    ([0, 0], renderer.rgba8(&view).unwrap())
                };
                let Size { width, height } = picture.size;
                let mut pixels: Vec<_> = (0..PIXELS_OF_EACH)
                    .map(|_| [left + random.below(width), top + random.below(height)])
                    .collect();
                // Those of one tile together.
                pixels.sort_by_key(|pixel| pixel.map(|side| side / 64));
                for explained in renderer.explain_pixels(&view, &pixels).unwrap() {
                    let [x, y] = explained.pixel;
                    let drawn = picture.pixels[((y - top) * width + x - left) as usize];
                    let place = format!("{name}, round {round}, {samples} samples: {x}, {y}");
                    assert_eq!(explained.rgba8, drawn, "{place}");
                    compared += 1;
                }
            }
        }
    }
    assert!(compared >= 10_000, "{compared}");
}

#[test]
fn triangles_kept_from_block_to_block_are_lit_as_each_is_explained() {
    // From triangles of many blocks to many triangles a block, of two objects through one another.
    for columns in [8, 30, 60, 110, 200, 400] {
        let ball = (primitives::sphere(1.0, columns, columns / 2), matte([0.9, 0.5, 0.3]));
        let ring = (primitives::torus(0.9, 0.3, columns, columns / 3), matte([0.2, 0.5, 0.8]));
        let scene = scene(vec![ball, ring]);
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let size = Size { width: 150, height: 120 };
        for (mode, samples) in
            [(ShadingMode::Phong, 1), (ShadingMode::Gouraud, 1), (ShadingMode::Phong, 4)]
        {
            let shading = shading(mode, Interpolation::Perspective, Clamp::Vertex);
            let view = fitted(&scene, size).with_samples(samples).with_shading(shading);
            let picture = renderer.rgba8(&view).unwrap();
            let mut pixels: Vec<_> =
                (0..150 * 120).step_by(29).map(|number| [number % 150, number / 150]).collect();
            pixels.sort_by_key(|pixel| pixel.map(|side| side / 64));
            for explained in renderer.explain_pixels(&view, &pixels).unwrap() {
                let [x, y] = explained.pixel;
                let drawn = picture.pixels[(y * 150 + x) as usize];
                let place = format!("{columns} columns, {mode:?}, {samples} samples: {x}, {y}");
                assert_eq!(explained.rgba8, drawn, "{place}");
            }
        }
    }
}

/// A view with another mixture of lights, fog and background each round.
pub(crate) fn styled(scene: &Scene, round: usize, samples: u32) -> View {
    let size = Size { width: 90, height: 70 };
    let mut view = fitted(scene, size)
        .with_samples(samples)
        .with_lights(default_lights())
        .with_ambient([0.1; 3]);
    if round % 2 == 1 {
        view.lights = many_lights(scene);
    }
    if round % 3 == 1 {
        let away =
            (scene.bounds().centre() - view.camera.eye()).dot(view.camera.direction()) as f32;
        let law = match round {
            1 => FogLaw::DepthCue { near: away * 0.7, far: away * 1.3, front: 1.0, back: 0.2 },
            4 => FogLaw::Exponential { density: 1.0 / away },
            _ => FogLaw::ExponentialSquared { density: 0.7 / away },
        };
        view.fog = Some(Fog { color: [0.5, 0.6, 0.9], law });
    }
    if round % 4 == 2 {
        view.background = [0.1, 0.3, 0.2, 0.4].into();
    }
    view.shading = SHADINGS[round % SHADINGS.len()];
    view
}

/// A view with soft shadows and openness, or without.
pub(crate) fn occluded(mut view: View, is_occluded: bool) -> View {
    if is_occluded {
        let radius = 0.1 * view.camera.eye().length() as f32;
        for light in &mut view.lights {
            light.light.radius = radius;
        }
        view = view.with_shadows(true).with_light_rays(3);
        view.ambient_occlusion = Some(AmbientOcclusion { rays: 3, ..AmbientOcclusion::default() });
    }
    view
}

#[test]
fn a_single_sample_at_the_centre_is_the_pixel_of_one_sample() {
    let scene = demos::demo("teapot").unwrap();
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let view = styled(&scene, 0, 1);
    for pixel in [[45_u32, 35], [20, 40], [0, 0], [89, 69]] {
        let whole = renderer.explain(&view, At::Pixel(pixel)).unwrap();
        let centre = pixel.map(|side| f64::from(side) + 0.5);
        let many = view.clone().with_samples(16);
        let point = renderer.explain(&many, At::Point(centre)).unwrap();
        assert_eq!(point.samples, whole.samples);
        assert_eq!(point.position, Some(centre));
    }
}

#[test]
fn a_part_of_a_picture_is_the_pictures_part() {
    for (name, scene) in scenes().into_iter().filter(|(name, _)| name != "blob") {
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let view = occluded(styled(&scene, 1, 4), true).with_ground(true);
        let whole = renderer.rgba8(&view).unwrap().pixels;
        let Size { width, height } = view.size;
        for (pixel, size) in [([45, 35], [33, 21]), ([0, 69], [33, 21]), ([66, 65], [500, 3])] {
            let asked = Size { width: size[0], height: size[1] };
            let ([left, top], part) = renderer.rgba8_around(&view, pixel, asked).unwrap();
            assert_eq!(part.size.width, size[0].min(width));
            assert!((left..left + part.size.width).contains(&pixel[0]), "{name}");
            assert!((top..top + part.size.height).contains(&pixel[1]), "{name}");
            let rows = part.pixels.chunks(part.size.width as usize);
            for (y, row) in (top..).zip(rows) {
                assert!(y < height);
                let first = (y * width + left) as usize;
                assert_eq!(row, &whole[first..first + row.len()], "{name}, row {y}");
            }
        }
        let outside = renderer.rgba8_around(&view, [90, 3], view.size);
        assert!(matches!(outside, Err(RenderError::Outside(_))));
    }
}

#[test]
fn what_lies_below_a_place_begins_with_what_is_seen_there() {
    for (name, scene) in scenes().into_iter().filter(|(name, _)| name != "blob") {
        let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
        let view = styled(&scene, 0, 1);
        let mut random = Random(9);
        let mut several = 0;
        for _ in 0..40 {
            let place = [90.0, 70.0].map(|side| side * f64::from(random.below(1000)) / 1000.0);
            let below = renderer.below(&view, place).unwrap();
            let explained = renderer.explain(&view, At::Point(place)).unwrap();
            let seen: Vec<_> = explained.samples[0]
                .seen
                .iter()
                .filter_map(|seen| seen.surface())
                .map(|surface| (surface.object, surface.triangle))
                .collect();
            let found: Vec<_> =
                below.iter().map(|surface| (surface.object, surface.triangle)).collect();
            assert!(found.starts_with(&seen), "{name} {place:?}: {found:?}, {seen:?}");
            assert!(seen.is_empty() == found.is_empty(), "{name} {place:?}");
            assert!(below.windows(2).all(|two| two[0].z <= two[1].z + 1e-4), "{name} {place:?}");
            if let Some(surface) = explained.samples[0].seen[0].surface() {
                assert!((below[0].z - f64::from(surface.z)).abs() < 1e-4 * below[0].z, "{name}");
            }
            several += usize::from(below.len() > 1);
        }
        // Solids have a far side, glass is there to be looked through.
        let is_deep = ["teapot", "spheres", "glass"].contains(&name.as_str());
        assert!(several > 3 || !is_deep, "{name}: {several}");
    }
}

/// Sheets in one plane, which slopes away and which each cuts into other triangles.
fn sheets() -> Scene {
    let sheet = |turns: usize| {
        let mut sheet = square(0.0);
        sheet.positions.rotate_left(turns % 4);
        for (number, [x, y, z]) in (0_u8..).zip(&mut sheet.positions) {
            let wider = 1.0 + 0.1 * f32::from(number) * (turns as f32);
            (*x, *y) = (*x * wider, *y * wider);
            *z = 0.37 * *x - 0.61 * *y;
        }
        (sheet, matte([0.2 * turns as f32, 0.5, 0.5]))
    };
    scene((0..4).map(sheet).collect())
}

#[test]
fn of_surfaces_in_one_plane_the_first_lies_before_the_others() {
    let scene = sheets();
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let view = styled(&scene, 0, 1);
    let mut random = Random(5);
    let mut deep = 0;
    for _ in 0..1000 {
        let place = [90.0, 70.0].map(|side| side * f64::from(random.below(1000)) / 1000.0);
        let below = renderer.below(&view, place).unwrap();
        let objects: Vec<_> = below.iter().map(|surface| surface.object).collect();
        assert!(objects.is_sorted(), "{place:?}: {objects:?}");
        deep += usize::from(objects.len() == 4);
    }
    assert!(deep > 40, "{deep}");
}

#[test]
fn the_nearest_object_is_the_nearest_pixel_that_is_covered() {
    let scene = demos::demo("spheres").unwrap();
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let view = styled(&scene, 0, 1);
    let layers = renderer.layers(&view, &[Layer::Object]).unwrap();
    let LayerValues::U32(objects) = &layers[0] else { panic!("objects are numbers") };
    for pixel in [[0_u32, 0], [89, 69], [45, 0], [44, 35], [3, 40]] {
        let away = |place: usize| {
            let [x, y] = [place as u32 % 90, place as u32 / 90];
            f64::from(x.abs_diff(pixel[0])).hypot(f64::from(y.abs_diff(pixel[1])))
        };
        let covered = (0..objects.len()).filter(|&place| objects[place] != u32::MAX);
        let expected = covered.map(away).fold(f64::INFINITY, f64::min);
        let nearest = renderer.nearest_object(&view, pixel, 100).unwrap().unwrap();
        assert!((nearest.distance - expected).abs() < 1e-9, "{pixel:?}: {nearest:?}, {expected}");
        let place = (nearest.pixel[1] * 90 + nearest.pixel[0]) as usize;
        assert_eq!(objects[place] as usize, nearest.object);
        if expected > 1.0 {
            let within = renderer.nearest_object(&view, pixel, expected as u32 - 1).unwrap();
            assert_eq!(within, None);
        }
    }
}

#[test]
fn a_point_is_rounded_to_256ths_and_must_lie_in_the_picture() {
    let scene = demos::demo("teapot").unwrap();
    let renderer = Renderer::new(scene.clone(), &execution(1, SimdLevel::Auto)).unwrap();
    let view = styled(&scene, 0, 4);
    let explained = renderer.explain(&view, At::Point([10.001, 20.999])).unwrap();
    assert_eq!((explained.pixel, explained.position), ([10, 21], Some([10.0, 21.0])));
    for outside in [
        At::Pixel([90, 0]),
        At::Pixel([0, 70]),
        At::Point([-0.01, 3.0]),
        At::Point([90.0, 3.0]),
        At::Point([f64::NAN, 3.0]),
    ] {
        assert!(matches!(renderer.explain(&view, outside), Err(RenderError::Outside(_))));
    }
}
