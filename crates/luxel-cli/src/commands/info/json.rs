//! The JSON document of `luxel info`.
//!
//! It is written as it is made: a file may have a million objects, whose values would take a kilobyte
//! each.

use super::Survey;
use crate::camera;
use crate::model::Model;
use crate::options::FrameOptions;
use luxel::lighting::{Attenuation, Cone, LightKind, SHARED, own_parameters};
use luxel::scene::{
    AlphaMode, Bounds, Camera, Lens, Object, Placement, SceneCamera, SceneLight, SceneMaterial,
    Sides,
};
use serde::{Serialize, Serializer};
use serde_json::{Map, Value, json};

/// The members, in alphabetical order as in the program's other documents.
#[derive(Serialize)]
pub(super) struct Document<'a> {
    bounds: Value,
    camera: Value,
    cameras: List<'a, SceneCamera>,
    format: &'a str,
    lights: List<'a, SceneLight>,
    lines: u64,
    materials: List<'a, SceneMaterial>,
    objects: List<'a, (Object, Bounds)>,
    points: u64,
    triangles: u64,
    vertices: u64,
    warnings: &'a [String],
}

/// What things say of themselves, each when it is written.
struct List<'a, T>(&'a [T], Box<dyn Fn(&T) -> Value + 'a>);

impl<T> Serialize for List<'_, T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self(things, to_json) = self;
        serializer.collect_seq(things.iter().map(to_json))
    }
}

impl Survey<'_> {
    pub(super) fn to_json<'a>(
        &'a self,
        model: &'a Model,
        camera: &Camera,
        frame: &FrameOptions,
    ) -> Document<'a> {
        let scene = self.scene;
        Document {
            bounds: bounds_to_json(&self.bounds),
            camera: camera::to_json(camera, frame.size),
            cameras: List(&scene.cameras, Box::new(|camera| self.camera_to_json(camera))),
            format: model.format,
            lights: List(&scene.lights, Box::new(|light| self.light_to_json(light))),
            lines: self.lines,
            materials: List(&scene.materials, Box::new(material_to_json)),
            objects: List(&self.objects, Box::new(|object| self.object_to_json(object))),
            points: self.points,
            triangles: scene.triangle_count(),
            vertices: self.vertices,
            warnings: &model.warnings,
        }
    }

    fn object_to_json(&self, (object, bounds): &(Object, Bounds)) -> Value {
        json!({
            "name": self.scene.nodes[object.node.index()].name.as_str(),
            "path": self.scene.path(object.node),
            "triangles": self.triangles(object),
            "bounds": bounds_to_json(bounds),
        })
    }

    fn light_to_json(&self, light: &SceneLight) -> Value {
        let mut entry = Map::new();
        entry.insert("name".into(), json!(light.name));
        entry.insert("kind".into(), json!(light.light.kind.name()));
        match light.placement {
            Placement::World => entry.insert("in".into(), json!("world")),
            Placement::Camera => entry.insert("in".into(), json!("camera")),
            Placement::Node(node) => {
                entry.insert("path".into(), json!(self.scene.path(node)));
                entry.insert("in".into(), json!("node"))
            }
        };
        let kind = light.light.kind;
        if kind.description().has_position {
            entry.insert("position".into(), json!(light.position.to_array()));
        }
        if kind.description().has_direction {
            entry.insert("direction".into(), json!(light.direction.to_array()));
        }
        entry.insert("ambient".into(), json!(light.light.ambient));
        entry.insert("diffuse".into(), json!(light.light.diffuse));
        entry.insert("specular".into(), json!(light.light.specular));
        entry.insert("attenuation".into(), json!(light.light.attenuation.coefficients));
        let limit = light.light.attenuation.limit;
        let limit = (limit < Attenuation::NO_LIMIT).then_some(limit);
        entry.insert("limit".into(), json!(limit));
        entry.insert("range".into(), json!(light.light.attenuation.range));
        if let LightKind::Spot(cone) = kind {
            entry.insert("cone".into(), cone_to_json(cone));
        }
        Value::Object(entry)
    }

    fn camera_to_json(&self, camera: &SceneCamera) -> Value {
        json!({
            "name": camera.name,
            "path": camera.node.map(|node| self.scene.path(node)),
            "lens": match camera.lens {
                Lens::Perspective { fov_y_radians } => json!({
                    "kind": "perspective",
                    "fov_degrees": fov_y_radians.to_degrees(),
                }),
                Lens::Orthographic { height } => json!({
                    "kind": "orthographic",
                    "height": height,
                }),
                Lens::Intrinsics { fx, fy, cx, cy } => json!({
                    "kind": "intrinsics",
                    "intrinsics": [fx, fy, cx, cy],
                }),
            },
        })
    }
}

fn bounds_to_json(bounds: &Bounds) -> Value {
    if bounds.is_empty() {
        return Value::Null;
    }
    json!({ "min": bounds.min.to_array(), "max": bounds.max.to_array() })
}

fn cone_to_json(cone: Cone) -> Value {
    let degrees = |cosine: f32| libm::acos(f64::from(cosine)).to_degrees();
    match cone {
        Cone::Exponent { cos_cutoff, exponent } => {
            json!({ "cutoff_degrees": degrees(cos_cutoff), "exponent": exponent })
        }
        Cone::Smooth { cos_inner, cos_outer } => {
            json!({ "inner_degrees": degrees(cos_inner), "outer_degrees": degrees(cos_outer) })
        }
    }
}

fn material_to_json(material: &SceneMaterial) -> Value {
    let constants = &material.constants;
    let textures = [
        ("base_color", &material.base_color),
        ("metallic_roughness", &material.metallic_roughness),
        ("normal", &material.normal),
        ("occlusion", &material.occlusion),
        ("emission", &material.emission),
        ("specular", &material.specular),
        ("ambient", &material.ambient),
        ("opacity", &material.opacity_map),
    ];
    let used = textures.iter().filter(|(_, texture)| texture.is_some()).map(|(name, _)| *name);
    let mut value = json!({
        "name": material.name.as_str(),
        "reflection": constants.reflection.name(),
        "ambient": constants.ambient,
        "diffuse": constants.diffuse,
        "specular": constants.specular,
        "emission": constants.emission,
        "opacity": material.opacity,
        "alpha": match material.alpha_mode {
            AlphaMode::Opaque => "opaque",
            AlphaMode::Mask { .. } => "mask",
            AlphaMode::Blend => "blend",
        },
        "double_sided": material.sides == Sides::Both,
        "textures": used.collect::<Value>(),
    });
    for parameter in SHARED {
        value[parameter.name] = json!(constants.value(parameter));
    }
    for own in own_parameters() {
        let name = own.parameter.name;
        if let Some(number) = constants.reflection.own(name) {
            value[name.replace('-', "_")] = json!(number);
        }
    }
    value
}
