//! The ledger as JSON. Numbers are written with all their digits, so that they read back exactly.

use super::report::Report;
use crate::equation::why_not;
use luxel_lighting::{
    DiffuseTerms, Display, Light, Material, MirrorTerms, PartTerms, Quantity, Reflectance,
    Reflection, own_parameters,
};
use luxel_render::{
    BlockedBy, EvaluatedAt, ExplainedGround, ExplainedLight, ExplainedSample, ExplainedShadow,
    ExplainedSurface, Hidden, Seen, SurfaceBelow,
};
use luxel_scene::Scene;
use serde_json::{Map, Value, json};

/// The whole document.
pub(crate) fn document(report: &Report<'_>) -> Value {
    let explanation = report.explanation;
    let unseen = report.unseen;
    let samples = explanation.samples.iter().enumerate().map(|(index, entry)| {
        sample(entry, unseen.and_then(|unseen| unseen.entries.get(index)), report.scene)
    });
    let nearest = unseen.and_then(|unseen| unseen.nearest).map(|nearest| {
        let mut object = object_of(nearest.object, report.scene);
        object.insert("pixel".to_owned(), json!(nearest.pixel));
        object.insert("pixels".to_owned(), json!(nearest.distance));
        object
    });
    let [(_, exposure), (_, tone)] = display_to_json(&explanation.display);
    json!({
        "pixel": explanation.pixel,
        "position": explanation.position,
        "exposure": exposure,
        "tone": tone,
        "samples": samples.collect::<Vec<_>>(),
        "linear": explanation.linear,
        "rgba8": explanation.rgba8,
        "nearest": nearest,
    })
}

/// The keys `exposure`, in stops with the factor of light, and `tone`.
#[must_use]
pub fn display_to_json(display: &Display) -> [(&'static str, Value); 2] {
    [
        ("exposure", json!({ "ev": display.ev(), "factor": display.factor() })),
        ("tone", json!({ "name": display.tone().name() })),
    ]
}

/// Samples that see the same.
fn sample(entry: &ExplainedSample, hidden: Option<&Hidden>, scene: &Scene) -> Value {
    let mut object = match &*entry.seen {
        [only] => seen(only, scene),
        // Terms are those of the layers; position and normal those of the nearest.
        [nearest, ..] => {
            let mut object = seen(nearest, scene);
            for key in TERMS {
                object.insert((*key).to_owned(), Value::Null);
            }
            let layers: Vec<_> = entry.seen.iter().map(|layer| seen(layer, scene)).collect();
            object.insert("layers".to_owned(), json!(layers));
            object
        }
        [] => Map::new(),
    };
    let surfaces = |of: fn(&Hidden) -> &[SurfaceBelow]| {
        hidden.map(|hidden| of(hidden).iter().map(|one| below(one, scene)).collect::<Value>())
    };
    object.insert("at".to_owned(), json!(entry.at));
    object.insert("behind".to_owned(), json!(surfaces(|hidden| &hidden.behind)));
    object.insert("culled".to_owned(), json!(surfaces(|hidden| &hidden.culled)));
    object.insert("weight".to_owned(), json!(entry.weight));
    object.insert("covers".to_owned(), json!(entry.covers));
    object.insert("color".to_owned(), json!(entry.color));
    object.insert("display".to_owned(), json!(entry.display));
    object.insert("alpha".to_owned(), json!(entry.alpha));
    Value::Object(object)
}

/// An object by its place, name and path.
fn object_of(index: usize, scene: &Scene) -> Map<String, Value> {
    let path = scene.objects().get(index).map(|object| scene.path(object.node));
    let mut object = Map::new();
    object.insert("index".to_owned(), json!(index));
    object.insert("object".to_owned(), json!(path.as_ref().and_then(|path| path.last())));
    object.insert("path".to_owned(), json!(path));
    object
}

/// A surface that isn't seen.
fn below(surface: &SurfaceBelow, scene: &Scene) -> Map<String, Value> {
    let mut object = object_of(surface.object, scene);
    object.insert("triangle".to_owned(), json!(surface.triangle));
    object.insert("position".to_owned(), json!(surface.position));
    object.insert("z".to_owned(), json!(surface.z));
    object.insert("depth".to_owned(), json!(surface.depth));
    object
}

/// The keys that belong to one surface's light.
const TERMS: &[&str] = &["emission", "scene_ambient", "lights", "environment", "sum", "fog"];

/// The visible surface, as an entry.
fn seen(seen: &Seen, scene: &Scene) -> Map<String, Value> {
    let value = match seen {
        Seen::Background { color, alpha, ground } => {
            let mut value = json!({
                "index": null,
                "object": null,
                "triangle": null,
                "color": color,
                "display": color,
                "alpha": alpha,
            });
            if let Some(seen) = ground {
                value["ground"] = on_ground(seen);
            }
            value
        }
        Seen::Surface(seen) => surface(seen, scene),
    };
    match value {
        Value::Object(map) => map,
        _ => Map::new(),
    }
}

fn on_ground(seen: &ExplainedGround) -> Value {
    let white = Material { reflection: Reflection::Lambert, ..Material::default() };
    json!({
        "position": seen.position,
        "behind": seen.behind,
        "openness": seen.openness,
        "ambient_light": seen.ambient_light,
        "scene_ambient": seen.scene_ambient,
        "lights": lights(&seen.lights, &white),
        "light": seen.light,
        "unoccluded": seen.unoccluded,
        "fog": seen.fog,
        "darkness": seen.darkness,
        "alpha": seen.alpha,
    })
}

fn surface(seen: &ExplainedSurface, scene: &Scene) -> Value {
    let objects = scene.objects();
    let path = objects.get(seen.object).map(|object| scene.path(object.node));
    let mut value = json!({
        "index": seen.object,
        "object": seen.name,
        "path": path,
        "triangle": seen.triangle,
        "barycentric": seen.barycentric,
        "evaluated_at": evaluated(seen),
        "texture": seen.texture,
        "position": seen.position,
        "normal": seen.normal,
        "view": seen.view,
        "z": seen.z,
        "uv": seen.uv,
        "material": material(&seen.material.name, &seen.material.constants, &seen.material.reflectance),
        "emission": seen.emission,
        "ambient_light": seen.ambient_light,
        "scene_ambient": seen.scene_ambient,
        "lights": lights(&seen.lights, &seen.material.constants),
        "environment": seen.environment,
        "mirrors": mirrors(&seen.mirrors, &seen.material.constants),
        "sum": seen.sum,
        "fog": seen.fog.map(|(factor, color)| json!({ "factor": factor, "color": color })),
        "color": seen.color,
        "display": seen.display,
        "alpha": seen.alpha,
    });
    if let Some(openness) = seen.openness {
        value["openness"] = json!(openness);
    }
    diffused(&mut value, seen.environment_diffuse, &seen.diffused, &seen.material.constants);
    value
}

/// Adds the diffuse part of the environment's term, if the environment is a map.
fn diffused(
    value: &mut Value,
    diffuse: Option<[f32; 3]>,
    parts: &[(usize, DiffuseTerms<f32>)],
    constants: &Material,
) {
    let Some(diffuse) = diffuse else { return };
    let part = |(index, terms): &(usize, DiffuseTerms<f32>)| {
        json!({
            "reflection": constants.reflection.part(*index).0.name(),
            "weight": terms.weight,
            "share": terms.share.lane(0),
            "irradiance": terms.irradiance.lane(0),
        })
    };
    value["environment_diffuse"] = json!(diffuse);
    value["diffused"] = parts.iter().map(part).collect();
}

/// The points at which light was evaluated; null if that is the sample itself.
fn evaluated(seen: &ExplainedSurface) -> Value {
    let point = |point: &EvaluatedAt| {
        let mut value = json!({
            "weight": point.weight,
            "position": point.position,
            "normal": point.normal,
            "view": point.view,
            "material": material(&seen.material.name, &seen.material.constants, &point.reflectance),
            "emission": point.emission,
            "scene_ambient": point.scene_ambient,
            "lights": lights(&point.lights, &seen.material.constants),
            "environment": point.environment,
            "mirrors": mirrors(&point.mirrors, &seen.material.constants),
            "sum": point.sum,
            "light": point.light,
        });
        let constants = &seen.material.constants;
        diffused(&mut value, point.environment_diffuse, &point.diffused, constants);
        value
    };
    if seen.evaluated_at.is_empty() {
        Value::Null
    } else {
        seen.evaluated_at.iter().map(point).collect()
    }
}

fn material(name: &str, constants: &Material, reflectance: &Reflectance<f32>) -> Value {
    let mut value = json!({
        "name": name,
        "reflection": constants.reflection.name(),
        "ambient": reflectance.ambient.lane(0),
        "diffuse": reflectance.diffuse.lane(0),
        "specular": reflectance.specular.lane(0),
        "emission": reflectance.emission.lane(0),
        "k_a": constants.k_a,
        "k_d": constants.k_d,
        "k_s": constants.k_s,
        "shininess": reflectance.shininess,
        "metallic": reflectance.metallic,
        "roughness": reflectance.roughness,
        "occlusion": reflectance.occlusion,
    });
    for own in own_parameters() {
        let name = own.parameter.name;
        if let Some(number) = constants.reflection.own(name) {
            value[name.replace('-', "_")] = json!(number);
        }
    }
    if let Reflection::Mixed(parts) = &constants.reflection {
        let parts = parts.iter().map(|(part, weight)| json!([part.name(), weight]));
        value["mixed"] = parts.collect();
    }
    value
}

fn lights(lights: &[ExplainedLight], constants: &Material) -> Value {
    lights.iter().map(|one| light(one, constants)).collect()
}

/// The reflection of a light by a part of the model: factors of I_d and I_s.
fn part(index: usize, part: &PartTerms<f32>, constants: &Material) -> Value {
    let (reflection, _) = constants.reflection.part(index);
    let mut value = json!({
        "reflection": reflection.name(),
        "weight": part.weight,
        "diffuse": part.diffuse.lane(0),
        "specular": part.specular.lane(0),
        "specular_cosine": part.specular_cosine,
    });
    let model = reflection.model();
    let specular = model.and_then(|model| model.specular).unwrap_or_default();
    for factor in model.map_or(&[][..], |model| model.diffuse).iter().chain(specular) {
        match factor.quantity {
            Quantity::Number(key, of) => value[key] = json!(of(&part.lobe)),
            Quantity::Color(Some(key), of) => value[key] = json!(of(&part.lobe)),
            _ => {}
        }
    }
    value
}

/// The environment reflected by the parts of the model.
fn mirrors(mirrors: &[(usize, MirrorTerms<f32>)], constants: &Material) -> Value {
    let mirror = |(index, mirror): &(usize, MirrorTerms<f32>)| {
        json!({
            "reflection": constants.reflection.part(*index).0.name(),
            "weight": mirror.weight,
            "share": mirror.share.lane(0),
            "radiance": mirror.radiance.lane(0),
        })
    };
    mirrors.iter().map(mirror).collect()
}

fn light(light: &ExplainedLight, constants: &Material) -> Value {
    let terms = &light.terms;
    let Light { kind, ambient, diffuse, specular, .. } = light.light;
    let mut value = json!({
        "name": light.name,
        "kind": light.light.kind.name(),
        "intensity": { "ambient": ambient, "diffuse": diffuse, "specular": specular },
        "position": kind.description().has_position.then_some(light.position),
        "direction": kind.description().has_direction.then_some(light.direction),
        "to_light": terms.to_light.lane(0),
        "distance": terms.distance,
        "attenuation": terms.attenuation,
        "spot": terms.spot,
        "n_dot_l": terms.n_dot_l,
        "specular_cosine": terms.specular_cosine,
        "parts": light.parts.iter().map(|(index, one)| part(*index, one, constants)).collect::<Vec<_>>(),
        "ambient": terms.ambient.lane(0),
        "diffuse": terms.diffuse.lane(0),
        "specular": terms.specular.lane(0),
        "why_not": light.unlit().map(why_not),
    });
    if let Some(ExplainedShadow { terminator, raised, ray, blocked_by }) = &light.shadow {
        value["visibility"] = json!(terms.visibility.unwrap_or(1.0));
        value["terminator"] = json!(terminator);
        value["terminator_offset"] = json!(raised);
        value["shadow_ray"] = json!(
            ray.map(|[origin, direction]| json!({ "origin": origin, "direction": direction }))
        );
        if terms.visibility.is_some_and(|visibility| visibility < 1.0) {
            value["blocked_by"] = blocked_by.iter().map(blocked).collect();
        }
    }
    value
}

fn blocked(by: &BlockedBy) -> Value {
    json!({
        "index": by.object,
        "object": by.name,
        "triangle": by.triangle,
        "distance": by.distance,
        "share": by.share,
    })
}
