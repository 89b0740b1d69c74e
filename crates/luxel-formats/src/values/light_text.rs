//! The text form of a light, field by field.

use luxel_lighting::{Attenuation, LightKind, LightNumber};
use luxel_scene::{DVec3, Placement, SceneLight};

/// The value of a light's field.
#[derive(Clone, Copy, Debug)]
pub(crate) enum FieldValue {
    Vector(DVec3),
    Color([f32; 3]),
    Degrees(f64),
    Number(f32),
}

/// The fields of a light, without kind, name and space. Fields with default values are left out.
pub(crate) fn light_fields(scene_light: &SceneLight) -> Vec<(&'static str, FieldValue)> {
    let SceneLight { light, position, direction, .. } = scene_light;
    if light.kind == LightKind::Ambient {
        return vec![("color", FieldValue::Color(light.ambient))];
    }
    let description = light.kind.description();
    let mut fields = Vec::new();
    if description.has_position {
        fields.push(("pos", FieldValue::Vector(*position)));
    }
    if description.has_direction {
        fields.push(("dir", FieldValue::Vector(*direction)));
    }
    fields.extend(light.kind.fields().map(|(field, number)| match number {
        LightNumber::HalfAngle(cosine) => (field.name, FieldValue::Degrees(cutoff_degrees(cosine))),
        LightNumber::Plain(value) => (field.name, FieldValue::Number(value)),
    }));
    if light.ambient != [0.0; 3] {
        fields.push(("ambient", FieldValue::Color(light.ambient)));
    }
    fields.push(("diffuse", FieldValue::Color(light.diffuse)));
    if light.specular != light.diffuse {
        fields.push(("specular", FieldValue::Color(light.specular)));
    }
    let Attenuation { coefficients, limit, range } = light.attenuation;
    let none = Attenuation::NONE;
    if coefficients != none.coefficients {
        fields.push(("attenuation", FieldValue::Color(coefficients)));
    }
    if limit < Attenuation::NO_LIMIT {
        fields.push(("limit", FieldValue::Number(limit)));
    }
    fields.extend(range.map(|range| ("range", FieldValue::Number(range))));
    for (key, value) in [("radius", light.radius), ("angle", light.angle_degrees)] {
        if value != 0.0 {
            fields.push((key, FieldValue::Number(value)));
        }
    }
    fields
}

/// The string that [`light`](super::light()) reads as this light; `None` if a node places it.
/// Characters that a name can't have there are dropped.
#[must_use]
pub fn light_text(light: &SceneLight) -> Option<String> {
    let mut text = light.light.kind.name().to_owned();
    let mut field = |key: &str, value: &str| text.extend([":", key, "=", value]);
    for (key, value) in light_fields(light) {
        let value = match value {
            FieldValue::Vector(v) => format!("{},{},{}", v.x, v.y, v.z),
            FieldValue::Color([r, g, b]) => format!("{r},{g},{b}"),
            FieldValue::Degrees(number) => number.to_string(),
            FieldValue::Number(number) => number.to_string(),
        };
        field(key, &value);
    }
    match light.placement {
        Placement::World => {}
        Placement::Camera => field("in", "camera"),
        Placement::Node(_) => return None,
    }
    let name: String = light.name.chars().filter(|letter| *letter != ':').collect();
    if !name.is_empty() {
        field("name", &name);
    }
    Some(text)
}

/// The cosine of a cone's half-angle of 0 to 90 degrees; -1 for 180, which means no cone; `None`
/// for other angles.
#[must_use]
pub fn cos_cutoff(degrees: f64) -> Option<f32> {
    if degrees == 180.0 {
        Some(-1.0)
    } else if degrees == 90.0 {
        // The cosine of the f64 next to pi / 2 is not quite 0.
        Some(0.0)
    } else if (0.0..90.0).contains(&degrees) {
        Some(libm::cos(degrees.to_radians()) as f32)
    } else {
        None
    }
}

/// The half-angle with the fewest digits that [`cos_cutoff`] maps to this cosine; 180 for
/// negative ones. Cosines below 1e-8 count as that of a right angle, from which degrees
/// can't distinguish them.
#[must_use]
pub fn cutoff_degrees(cosine: f32) -> f64 {
    if cosine < 0.0 {
        return 180.0;
    }
    if cosine < 1e-8 {
        return 90.0;
    }
    let degrees = libm::acos(f64::from(cosine.min(1.0))).to_degrees();
    let rounded = [1.0, 1e3, 1e6, 1e9].map(|unit| (degrees * unit).round() / unit);
    let is_same = |angle: &f64| cos_cutoff(*angle) == Some(cosine);
    rounded.into_iter().find(is_same).unwrap_or(degrees)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cosine_is_that_of_its_angle() {
        for degrees in 0..=90 {
            let degrees = f64::from(degrees);
            assert_eq!(cutoff_degrees(cos_cutoff(degrees).unwrap()), degrees);
        }
        for bits in
            (1e-8_f32.to_bits()..1_f32.to_bits()).step_by(99_991).chain([1_f32.to_bits() - 1])
        {
            let cosine = f32::from_bits(bits);
            assert_eq!(cos_cutoff(cutoff_degrees(cosine)), Some(cosine), "{cosine}");
        }
        assert_eq!(cutoff_degrees(-1.0), 180.0);
    }
}
