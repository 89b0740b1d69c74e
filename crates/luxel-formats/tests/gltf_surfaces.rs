//! glTF materials, textures, lights and cameras.

mod documents;

use documents::Document;
use luxel_formats::{Format, Limits, Loaded, read};
use luxel_lighting::{Cone, LightKind, Reflection};
use luxel_scene::{AlphaMode, DVec3, Encoding, Filter, Lens, NodeId, Placement, Sides, Wrap};
use serde_json::{Value, json};

/// A grey texel, as PNG.
const PIXEL: &str = "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4\
                     nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";

/// A triangle with one material.
fn with_material(material: Value) -> Document {
    let mut document = Document::triangle();
    document.push("materials", material);
    document.primitive()["material"] = json!(0);
    document.push("images", json!({"uri": PIXEL, "name": "grey"}));
    document.push("textures", json!({"source": 0}));
    document
}

fn load(material: Value) -> Loaded {
    with_material(material).load()
}

#[test]
fn factors_are_taken_over() {
    let loaded = load(json!({
        "name": "brass",
        "pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.25, 0.125, 0.75],
            "metallicFactor": 0.5,
            "roughnessFactor": 0.25,
        },
        "emissiveFactor": [1.0, 0.5, 0.0],
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 4.0}},
        "doubleSided": true,
    }));
    let material = &loaded.scene.materials[0];
    let constants = &material.constants;
    assert_eq!(material.name, "brass");
    assert_eq!(constants.reflection, Reflection::Microfacet);
    assert_eq!(constants.diffuse, [0.5, 0.25, 0.125]);
    assert_eq!(material.opacity, 0.75);
    assert_eq!((constants.metallic, constants.roughness), (0.5, 0.25));
    assert_eq!(constants.emission, [4.0, 2.0, 0.0]);
    assert_eq!((constants.k_a, constants.k_d, constants.k_s), (1.0, 1.0, 1.0));
    assert_eq!(material.sides, Sides::Both);
}

#[test]
fn an_empty_material_has_the_specifications_defaults() {
    let loaded = load(json!({}));
    let material = &loaded.scene.materials[0];
    assert_eq!(material.constants.diffuse, [1.0; 3]);
    assert_eq!((material.constants.metallic, material.constants.roughness), (1.0, 1.0));
    assert_eq!(material.alpha_mode, AlphaMode::Opaque);
    assert_eq!(material.sides, Sides::Front);
}

#[test]
fn alpha_modes_are_distinguished() {
    let mode = |material| load(material).scene.materials[0].alpha_mode;
    assert_eq!(mode(json!({"alphaMode": "MASK"})), AlphaMode::Mask { cutoff: 0.5 });
    let cut = json!({"alphaMode": "MASK", "alphaCutoff": 0.25});
    assert_eq!(mode(cut), AlphaMode::Mask { cutoff: 0.25 });
    assert_eq!(mode(json!({"alphaMode": "BLEND"})), AlphaMode::Blend);
    let (pointer, _) = with_material(json!({"alphaMode": "GLASS"})).fault();
    assert_eq!(pointer, "/materials/0/alphaMode");
}

#[test]
fn unlit_surfaces_are_unlit() {
    let loaded = load(json!({"extensions": {"KHR_materials_unlit": {}}}));
    assert_eq!(loaded.scene.materials[0].constants.reflection, Reflection::Unlit);
}

#[test]
fn an_image_of_two_encodings_becomes_two() {
    let loaded = load(json!({
        "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0},
            "metallicRoughnessTexture": {"index": 0, "texCoord": 1},
        },
        "occlusionTexture": {"index": 0, "strength": 0.5},
        "normalTexture": {"index": 0, "scale": 2.0},
        "emissiveTexture": {"index": 0},
    }));
    let scene = &loaded.scene;
    assert!(loaded.warnings.is_empty(), "{:?}", loaded.warnings);
    let encodings: Vec<_> = scene.textures.iter().map(|texture| texture.image.encoding).collect();
    assert_eq!(encodings, [Encoding::Srgb, Encoding::Linear]);
    assert_eq!(scene.textures[0].image.name, "grey");
    let material = &scene.materials[0];
    assert_eq!(material.base_color.as_ref().unwrap().texture.index(), 0);
    assert_eq!(material.metallic_roughness.as_ref().unwrap().uv_set, 1);
    assert_eq!(material.occlusion.as_ref().unwrap().strength, 0.5);
    assert_eq!(material.normal.as_ref().unwrap().strength, 2.0);
    assert_eq!(material.emission.as_ref().unwrap().texture.index(), 0);
}

#[test]
fn textures_are_scaled_then_turned_then_moved() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let loaded = load(json!({"pbrMetallicRoughness": {"baseColorTexture": {
        "index": 0,
        "extensions": {"KHR_texture_transform": {
            "offset": [0.25, 0.5], "rotation": quarter, "scale": [2.0, 4.0], "texCoord": 1,
        }},
    }}}));
    let usage = loaded.scene.materials[0].base_color.clone().unwrap();
    assert_eq!(usage.uv_set, 1);
    // The extension's matrix for a quarter turn takes (u, v) to (v, -u).
    let expected = [0.0, 4.0, 0.25, -2.0, 0.0, 0.5];
    for (entry, expected) in usage.transform.iter().zip(expected) {
        assert!((entry - expected).abs() < 1e-6, "{:?}", usage.transform);
    }
}

#[test]
fn samplers_keep_their_rules() {
    let mut document =
        with_material(json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
    document.json["textures"][0]["sampler"] = json!(0);
    let sampler = json!({"magFilter": 9728, "minFilter": 9985, "wrapS": 33071, "wrapT": 33648});
    document.push("samplers", sampler);
    let sampler = document.load().scene.textures[0].sampler;
    assert_eq!((sampler.wrap_u, sampler.wrap_v), (Wrap::ClampToEdge, Wrap::MirroredRepeat));
    assert_eq!(sampler.magnify, Filter::Nearest);
    assert_eq!((sampler.minify, sampler.mipmap), (Filter::Linear, Some(Filter::Nearest)));
}

#[test]
fn images_that_cannot_be_read_are_warnings_and_stand_ins() {
    for uri in ["missing.png", "../outside.png", "http://example.org/x.png", "data:,nothing"] {
        let mut document = with_material(json!({
            "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
            "normalTexture": {"index": 0},
        }));
        document.json["images"][0] = json!({"uri": uri});
        let folder = std::env::temp_dir();
        let loaded =
            read(&document.glb(), Format::Glb, "test", Some(&folder), &Limits::default()).unwrap();
        assert!(!loaded.warnings.is_empty(), "{uri}");
        let material = &loaded.scene.materials[0];
        assert!(material.base_color.is_some() && material.normal.is_none(), "{uri}");
        assert!(!loaded.scene.textures[0].image.levels.is_empty());
    }
}

#[cfg(unix)]
#[test]
fn images_that_are_no_regular_files_in_the_folder_are_errors() {
    let folder = std::env::temp_dir().join(format!("luxel-images-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("inner/folder.png")).unwrap();
    std::fs::write(folder.join("outside.png"), b"x").unwrap();
    std::os::unix::fs::symlink("../outside.png", folder.join("inner/link.png")).unwrap();
    for uri in ["folder.png", "link.png", "../outside.png", "%2e%2e/outside.png", "/dev/zero"] {
        let mut document =
            with_material(json!({"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}));
        document.json["images"][0] = json!({"uri": uri});
        let inner = folder.join("inner");
        let read = read(&document.glb(), Format::Glb, "test", Some(&inner), &Limits::default());
        let message = read.expect_err(uri).to_string();
        let name = uri.rsplit('/').next().unwrap();
        assert!(message.contains("/images/0/uri") && message.contains(name), "{message}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn lights_are_divided_by_pi_and_stand_at_their_nodes() {
    let mut document = Document::triangle();
    document.json["extensions"] = json!({"KHR_lights_punctual": {"lights": [
        {"type": "point", "color": [1.0, 0.5, 0.0], "intensity": 10.0, "range": 5.0},
        {"type": "spot", "spot": {"innerConeAngle": 0.5, "outerConeAngle": 0.5}},
        {"type": "directional", "name": "sun"},
    ]}});
    document.json["nodes"] = json!([
        {"mesh": 0, "children": [1, 2, 3]},
        {"extensions": {"KHR_lights_punctual": {"light": 2}}},
        {"name": "lamp", "extensions": {"KHR_lights_punctual": {"light": 0}}},
        {"extensions": {"KHR_lights_punctual": {"light": 1}}},
    ]);
    let lights = document.load().scene.lights;
    let names: Vec<_> = lights.iter().map(|light| light.name.as_str()).collect();
    assert_eq!(names, ["sun", "lamp", "light_1"]);
    let per_pi = std::f32::consts::FRAC_1_PI;
    assert_eq!(lights[0].light.kind, LightKind::Directional);
    assert!((lights[0].light.diffuse[0] - per_pi).abs() < 1e-7);
    assert_eq!(lights[0].light.attenuation.coefficients, [1.0, 0.0, 0.0]);
    assert_eq!(lights[1].light.attenuation.coefficients, [0.0, 0.0, 1.0]);
    assert_eq!(lights[1].light.attenuation.range, Some(5.0));
    assert!((lights[1].light.diffuse[1] - 5.0 * per_pi).abs() < 1e-6);
    assert_eq!(lights[1].placement, Placement::Node(NodeId(2)));
    assert_eq!(lights[1].direction, DVec3::NEG_Z);
    let LightKind::Spot(Cone::Smooth { cos_inner, cos_outer }) = lights[2].light.kind else {
        panic!("{:?}", lights[2].light.kind);
    };
    assert!(cos_inner > cos_outer, "a hard edge still has a width");
}

#[test]
fn cameras_hang_on_their_nodes() {
    let mut document = Document::triangle();
    document.json["cameras"] = json!([
        {"type": "perspective", "perspective": {"yfov": 0.75, "znear": 0.5, "aspectRatio": 2.0}},
        {"type": "orthographic", "name": "plan",
         "orthographic": {"xmag": 3.0, "ymag": 2.0, "znear": 0.0, "zfar": 9.0}},
    ]);
    document.json["nodes"] =
        json!([{"mesh": 0, "children": [1, 2]}, {"camera": 0, "name": "eye"}, {"camera": 1}]);
    let cameras = document.load().scene.cameras;
    assert_eq!(cameras[0].name, "eye");
    assert_eq!(cameras[0].lens, Lens::Perspective { fov_y_radians: 0.75 });
    assert_eq!(cameras[0].planes, Some((0.5, f64::INFINITY)));
    assert_eq!(cameras[1].name, "plan");
    assert_eq!(cameras[1].lens, Lens::Orthographic { height: 4.0 });
    assert_eq!(cameras[1].node, Some(NodeId(2)));
}

#[test]
fn extensions_are_refused_warned_of_or_shown() {
    let mut document = Document::triangle();
    document.json["extensionsUsed"] = json!(["KHR_materials_clearcoat", "KHR_materials_unlit"]);
    let warnings = document.load().warnings;
    assert_eq!(warnings.len(), 1);
    assert!(warnings[0].message.contains("KHR_materials_clearcoat"));
    document.json["extensionsRequired"] = json!(["KHR_materials_unlit", "KHR_texture_basisu"]);
    let (pointer, message) = document.fault();
    assert_eq!(pointer, "/extensionsRequired/1");
    assert!(message.contains("KHR_texture_basisu"));
}
