use super::*;
use crate::scene_toml::read;
use glam::DMat4;
use luxel_lighting::{Attenuation, Cone, Light, LightKind, Reflection, SHARED, own_parameters};
use luxel_scene::{Camera, NodeId, Scene, SceneMaterial};
use proptest::prelude::*;

fn loaded(text: &str) -> Scene {
    let read = read(text.as_bytes(), None, &Limits::default());
    read.unwrap_or_else(|error| panic!("{error}\n{text}")).scene
}

fn plain() -> SceneText<'static> {
    SceneText {
        models: SceneModels::One("demo:plane"),
        changes: Vec::new(),
        up: DVec3::Y,
        ambient: [0.0; 3],
        environment: Some(EnvironmentChoice::Always(Environment::None)),
        environment_file: None,
        background: [0.0; 4].into(),
        fog: None,
        lights: Vec::new(),
        cameras: Vec::new(),
        settings: Vec::new(),
    }
}

/// The path and the node index of the ground in the scene read back.
fn ground() -> Vec<String> {
    let plane = luxel_scene::demos::demo("plane").unwrap();
    let at = plane.nodes.iter().position(|node| node.name == "ground").unwrap();
    assert_eq!(at as u32 + 1, GROUND, "the model's own node comes first");
    let path = plane.path(NodeId(at as u32)).into_iter().map(str::to_owned);
    std::iter::once("plane".to_owned()).chain(path).collect()
}

const GROUND: u32 = 2;

/// Any finite number of single precision that is not below 0.
fn share() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0), 0.0..1.0_f32, (0..f32::MAX.to_bits()).prop_map(f32::from_bits),]
}

fn shares() -> impl Strategy<Value = [f32; 3]> {
    [share(), share(), share()]
}

fn place() -> impl Strategy<Value = DVec3> {
    let part = prop_oneof![-1e3..1e3_f64, proptest::num::f64::NORMAL.prop_map(|n| n % 1e9)];
    [part.clone(), part.clone(), part].prop_map(DVec3::from_array)
}

fn direction() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]
        .prop_map(|way| DVec3::from_array(way).normalize_or(DVec3::NEG_Z))
}

fn kind() -> impl Strategy<Value = LightKind> {
    let exponent = (0.0..=1.0_f32, share())
        .prop_map(|(cos_cutoff, exponent)| Cone::Exponent { cos_cutoff, exponent });
    let smooth = (0.0..0.99_f32, 0.0..1.0_f32).prop_map(|(cos_outer, part)| Cone::Smooth {
        cos_outer,
        cos_inner: (cos_outer + 0.002 + part * (0.998 - cos_outer)).min(1.0),
    });
    let open = Just(Cone::Exponent { cos_cutoff: -1.0, exponent: 0.0 });
    prop_oneof![
        Just(LightKind::Directional),
        Just(LightKind::Point),
        prop_oneof![exponent, smooth, open].prop_map(LightKind::Spot),
    ]
}

fn light() -> impl Strategy<Value = SceneLight> {
    let attenuation =
        (shares(), prop_oneof![Just(Attenuation::NO_LIMIT), 1e-3..1e9_f32], any::<bool>())
            .prop_map(|(coefficients, limit, ends)| {
                let coefficients =
                    if coefficients == [0.0; 3] { [1.0, 0.0, 0.0] } else { coefficients };
                Attenuation { coefficients, limit, range: ends.then_some(7.25) }
            });
    let placement = prop_oneof![
        Just(Placement::World),
        Just(Placement::Camera),
        Just(Placement::Node(NodeId(GROUND)))
    ];
    ((kind(), shares(), shares(), shares()), attenuation, placement, place(), direction(), ".{1,8}")
        .prop_map(|(what, attenuation, placement, position, direction, name)| {
            let (kind, ambient, diffuse, specular) = what;
            let light = Light {
                kind,
                ambient,
                diffuse,
                specular,
                attenuation,
                ..Light::new(kind, [0.0; 3])
            };
            // Fields that a kind lacks have the reader's defaults.
            let position = if kind == LightKind::Directional { DVec3::ZERO } else { position };
            let direction = if kind == LightKind::Point { DVec3::NEG_Z } else { direction };
            SceneLight { name, light, placement, position, direction }
        })
}

fn restyle() -> impl Strategy<Value = Restyle> {
    let reflection = prop_oneof![
        Just(Reflection::Phong),
        Just(Reflection::Mixed(vec![(Reflection::Lambert, 0.7), (Reflection::Mirror, 0.1)])),
    ];
    (
        (option(shares()), option(shares()), option(shares()), option(shares())),
        [option(share()), option(share()), option(share()), option(share())],
        [option(0.0..=1.0_f32), option(0.0..=1.0_f32), option(0.0..=1.0_f32)],
        option(reflection),
    )
        .prop_map(|(colors, [k_a, k_d, k_s, shininess], shares, reflection)| {
            let (color, ambient, specular, emission) = colors;
            let [metallic, roughness, opacity] = shares;
            let mut restyle = Restyle {
                color,
                ambient,
                specular,
                emission,
                opacity,
                reflection,
                ..Restyle::default()
            };
            for own in own_parameters() {
                restyle.set_parameter(&own.parameter, own.parameter.default);
            }
            let shared = [k_a, k_d, k_s, shininess, roughness, metallic];
            for (parameter, value) in SHARED.into_iter().zip(shared) {
                if let Some(value) = value {
                    restyle.set_parameter(parameter, value);
                }
            }
            restyle
        })
}

fn option<S: Strategy>(strategy: S) -> impl Strategy<Value = Option<S::Value>> {
    proptest::option::of(strategy)
}

fn camera() -> impl Strategy<Value = SceneCamera> {
    let lens = prop_oneof![
        // Any angle in degrees.
        (0.01..179.9_f64)
            .prop_map(|degrees| Lens::Perspective { fov_y_radians: degrees.to_radians() }),
        (1e-6..1e6_f64).prop_map(|height| Lens::Orthographic { height }),
        [1.0..5e3_f64, 1.0..5e3, -9e3..9e3, -9e3..9e3]
            .prop_map(|[fx, fy, cx, cy]| Lens::Intrinsics { fx, fy, cx, cy }),
    ];
    (place(), direction(), lens).prop_map(|(eye, way, lens)| SceneCamera {
        name: "window".to_owned(),
        node: None,
        view_from_node: Camera::look_at(eye, eye - way * 10.0, DVec3::Y),
        lens,
        planes: None,
    })
}

proptest! {
    // Each case reads a demo.
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn what_is_written_is_read_bit_by_bit(
        lights in proptest::collection::vec(light(), 0..4),
        camera in camera(),
        ambient in shares(),
        background in shares(),
        up in direction(),
        fog in (shares(), share(), 0.0..=1.0_f32, 0..3),
    ) {
        let mut lights = lights;
        for (at, light) in lights.iter_mut().enumerate() {
            light.name.push_str(&at.to_string());
        }
        let (fog_color, density, part, law) = fog;
        let law = match law {
            0 => FogLaw::Exponential { density },
            1 => FogLaw::ExponentialSquared { density },
            _ => FogLaw::DepthCue { near: -part, far: 1.0 + density.min(1e9), front: part, back: 0.5 },
        };
        let [r, g, b] = background;
        let node = ground();
        let text = SceneText {
            up,
            ambient,
            background: [r, g, b, part].into(),
            fog: Some(Fog { color: fog_color, law }),
            lights: lights.iter().map(|light| (light.clone(), node.clone())).collect(),
            cameras: vec![camera.clone()],
            ..plain()
        };
        let scene = loaded(&text.write().unwrap());
        if !lights.is_empty() {
            prop_assert_eq!(&scene.lights, &lights);
        }
        prop_assert_eq!(&scene.cameras[0], &camera);
        prop_assert_eq!((scene.up, scene.ambient), (up, Some(ambient)));
        prop_assert_eq!((scene.fog, scene.background), (text.fog, Some(text.background)));
    }

    #[test]
    fn a_change_to_surfaces_is_read_as_it_was_written(all in restyle(), one in restyle()) {
        let change = SurfaceChange {
            object: Some(ground()),
            surface: None,
            restyle: one.clone(),
        };
        let for_all = SurfaceChange { object: None, surface: None, restyle: all.clone() };
        let text = SceneText {
            changes: vec![for_all, change],
            ..plain()
        };
        let scene = loaded(&text.write().unwrap());
        let before = luxel_scene::demos::demo("plane").unwrap();
        let material_of = |scene: &Scene, name: &str| -> SceneMaterial {
            let is_named = |object: &&luxel_scene::Object| {
                scene.nodes[object.node.index()].name == name
            };
            let objects = scene.objects();
            let object = objects.iter().find(is_named).unwrap();
            let mesh = &scene.meshes[object.mesh.index()];
            scene.materials[mesh.parts[0].material.index()].clone()
        };
        for object in before.objects() {
            let name = &before.nodes[object.node.index()].name;
            let mut expected = material_of(&before, name);
            all.apply(&mut expected);
            expected.name = "surface".into();
            if name == "ground" {
                one.apply(&mut expected);
                expected.name = "ground".into();
            }
            prop_assert_eq!(material_of(&scene, name), expected);
        }
    }
}

#[test]
fn models_and_materials_are_copied_in_any_toml_spelling() {
    let other = "format = \"luxel-scene\"\nversion = 1\n\
        models = [{ source = 'demo:teapot', name = \"a \\\"pot\\\"\", rotate = { axis = \"Y\", degrees = 3_0 } },\n\
        { source = \"demo:plane\", scale = 0x2, translate = [1, -.5e0, 0] }]\n\
        [material]\nkd = 0.25\n\
        [[materials]]\nname = 'shine'\nks = 0.9\n[[overrides]]\nmaterial = \"shine\"\nmodel = \"plane\"\n";
    let other = other.replace("-.5e0", "-0.5e0");
    let text = SceneText { models: SceneModels::AsIn(other.as_bytes()), ..plain() };
    let (before, after) = (loaded(&other), loaded(&text.write().unwrap()));
    assert_eq!(after.nodes, before.nodes);
    assert_eq!(after.materials, before.materials);
    assert_eq!(after.meshes, before.meshes);
}

#[test]
fn settings_read_back() {
    let one = |text: &str| SettingValue::One(text.to_owned());
    let settings = vec![
        ("size".to_owned(), one("640x480")),
        ("samples".to_owned(), one("8")),
        ("edges".to_owned(), SettingValue::Switch(true)),
        ("far".to_owned(), one("infinity")),
    ];
    let text = SceneText { settings: settings.clone(), ..plain() }.write().unwrap();
    let read = crate::scene_settings(text.as_bytes(), &Limits::default()).unwrap();
    let read: Vec<_> = read.into_iter().map(|setting| (setting.name, setting.value)).collect();
    assert_eq!(read, settings);
}

#[test]
fn distant_cameras_read_back_bit_for_bit() {
    let view_from_node =
        DMat4::from_rotation_y(0.3) * DMat4::from_translation(DVec3::new(4.5e6, -1.0 / 3.0, 1e-7));
    let lens = Lens::Perspective { fov_y_radians: 0.7 };
    let camera =
        SceneCamera { name: "far".to_owned(), node: None, view_from_node, lens, planes: None };
    let text = SceneText { cameras: vec![camera.clone()], ..plain() };
    assert_eq!(loaded(&text.write().unwrap()).cameras[0], camera);
}
