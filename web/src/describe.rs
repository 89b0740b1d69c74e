//! What is in a scene, as JSON with the keys of `luxel info --json`.

use luxel::formats::values::{light_text, reflection_text};
use luxel::lighting::{SHARED, own_parameters};
use luxel::scene::{Bounds, Scene, SceneMaterial};
use serde_json::{Map, Value, json};

/// The scene.
pub(crate) fn describe(scene: &Scene, warnings: &[String]) -> Value {
    let objects = scene.objects();
    let object = |object: &luxel::scene::Object| {
        let node = &scene.nodes[object.node.index()];
        let triangles = scene.mesh_of(object).triangles.len();
        json!({ "name": node.name, "path": scene.path(object.node), "triangles": triangles })
    };
    let camera = |camera: &luxel::scene::SceneCamera| json!({ "name": camera.name });
    let (lights, ambient) = luxel::lights_of(scene);
    json!({
        "triangles": scene.triangle_count(),
        "bounds": bounds(&scene.bounds()),
        "up": scene.up.to_array(),
        "objects": objects.iter().map(object).collect::<Value>(),
        "materials": scene.materials.iter().map(material).collect::<Value>(),
        "lights": lights.iter().filter_map(light_text).collect::<Value>(),
        "ambient": ambient,
        "has_own_lights": !scene.lights.is_empty(),
        "cameras": scene.cameras.iter().map(camera).collect::<Value>(),
        "warnings": warnings,
    })
}

fn bounds(bounds: &Bounds) -> Value {
    match bounds.is_empty() {
        true => Value::Null,
        false => json!({ "min": bounds.min.to_array(), "max": bounds.max.to_array() }),
    }
}

fn material(material: &SceneMaterial) -> Value {
    let constants = &material.constants;
    let mut entry = Map::new();
    entry.insert("name".into(), json!(material.name));
    entry.insert("reflection".into(), json!(reflection_text(&constants.reflection)));
    entry.insert("color".into(), json!(constants.diffuse));
    entry.insert("emission".into(), json!(constants.emission));
    let own = own_parameters().map(|own| &own.parameter);
    for parameter in SHARED.into_iter().chain(own) {
        entry.insert(parameter.name.into(), json!(constants.value(parameter)));
    }
    Value::Object(entry)
}
