//! `KIND:KEY=VALUE:...`: a light.

use super::color::color;
use super::fields::{FieldError, Fields};
use super::light_text::cos_cutoff;
use super::number::{finite, non_negative_f32, positive, single};
use super::vector::{direction, numbers, point};
use luxel_lighting::{
    Attenuation, CUTOFF, Cone, EXPONENT, INNER, LIGHT_KINDS, Light, LightKind, LightKindDescription,
};
use luxel_scene::{DVec3, Placement, SceneLight};

/// A parsed light; lights without a name are numbered later.
#[derive(Clone, Debug, PartialEq)]
pub struct LightSpec {
    name: Option<String>,
    light: Light,
    placement: Placement,
    position: DVec3,
    direction: DVec3,
}

impl LightSpec {
    /// The light; one without a name is called `light1` and so on, by its place.
    #[must_use]
    pub fn named(self, place: usize) -> SceneLight {
        SceneLight {
            name: self.name.unwrap_or_else(|| format!("light{}", place + 1)),
            light: self.light,
            placement: self.placement,
            position: self.position,
            direction: self.direction,
        }
    }
}

/// Parses a light from one string.
///
/// # Errors
/// As [`light_of`], and duplicate fields.
pub fn light(text: &str) -> Result<LightSpec, String> {
    let (kind, rest) = text.split_once(':').unwrap_or((text, ""));
    let fields = if rest.is_empty() { Ok(Fields::default()) } else { Fields::parse(rest) };
    fields.and_then(|fields| light_of(kind, fields)).map_err(|error| error.to_string())
}

/// Builds a light from its kind and fields.
///
/// # Errors
/// An unknown kind; missing, unknown or wrong fields.
pub fn light_of(kind: &str, mut fields: Fields<'_>) -> Result<LightSpec, FieldError> {
    let name = fields.take("name", light_name)?;
    let placement = fields.take("in", placement)?.unwrap_or_default();
    let needs = |what: &str| FieldError::new(format!("a light of kind `{kind}` needs {what}"));

    let mut position = DVec3::ZERO;
    let mut towards = DVec3::NEG_Z;
    let description = LightKindDescription::by_name(kind).ok_or_else(|| {
        FieldError::new(format!("`{kind}` is not a kind of light: use {}", light_kind_names()))
    })?;
    let light = if description.kind == LightKind::Ambient {
        Light::ambient(fields.take("color", color)?.ok_or_else(|| needs("color=COLOR"))?)
    } else {
        let kind = match description.kind {
            LightKind::Spot(_) => LightKind::Spot(cone(&mut fields)?),
            other => other,
        };
        if description.has_position {
            position = fields.take("pos", point)?.ok_or_else(|| needs("pos=X,Y,Z"))?;
        }
        if description.has_direction {
            towards = fields.take("dir", direction)?.ok_or_else(|| needs("dir=X,Y,Z"))?;
        }
        let mut light = Light::new(kind, fields.take("diffuse", color)?.unwrap_or([1.0; 3]));
        light.ambient = fields.take("ambient", color)?.unwrap_or_default();
        light.specular = fields.take("specular", color)?.unwrap_or(light.diffuse);
        light.attenuation = attenuation_of(&mut fields)?;
        if description.has_position {
            light.radius = fields.take("radius", non_negative_f32)?.unwrap_or_default();
        } else {
            light.angle_degrees = fields.take("angle", apparent_angle)?.unwrap_or_default();
        }
        light
    };
    match fields.unknown_key() {
        Some(key) => Err(FieldError::new(format!("a light of kind `{kind}` has no `{key}`"))),
        None => Ok(LightSpec { name, light, placement, position, direction: towards }),
    }
}

/// The names of the kinds of light: `a, b or c`.
fn light_kind_names() -> String {
    either(LIGHT_KINDS.iter().map(|kind| kind.name.to_owned()))
}

/// The form of each kind for [`light`], without optional fields.
#[must_use]
pub fn light_usage() -> String {
    either(LIGHT_KINDS.iter().map(|kind| {
        let LightKindDescription { name, has_position, has_direction, usage, .. } = kind;
        let position = has_position.then_some("pos=X,Y,Z");
        let direction = has_direction.then_some("dir=X,Y,Z");
        let own = (!usage.is_empty()).then_some(*usage);
        let fields = [Some(*name), position, direction, own];
        fields.into_iter().flatten().collect::<Vec<_>>().join(":")
    }))
}

/// `a, b or c`
fn either(choices: impl Iterator<Item = String>) -> String {
    let mut choices: Vec<String> = choices.collect();
    let last = choices.pop().unwrap_or_default();
    if choices.is_empty() { last } else { format!("{} or {last}", choices.join(", ")) }
}

fn light_name(text: &str) -> Result<String, String> {
    if text.is_empty() {
        Err("a name needs at least one letter".to_owned())
    } else {
        Ok(text.into())
    }
}

fn placement(text: &str) -> Result<Placement, String> {
    match text {
        "world" => Ok(Placement::World),
        "camera" => Ok(Placement::Camera),
        _ => Err(format!("`{text}` is not a space: use world or camera")),
    }
}

fn cone(fields: &mut Fields<'_>) -> Result<Cone, FieldError> {
    let cos_cutoff = fields.take(CUTOFF.name, cos_cutoff_of)?.unwrap_or(-1.0);
    let exponent = fields.take(EXPONENT.name, non_negative_f32)?;
    let Some(inner) = fields.take(INNER.name, cos_cutoff_of)? else {
        return Ok(Cone::Exponent { cos_cutoff, exponent: exponent.unwrap_or(0.0) });
    };
    let refused =
        |message: &str| FieldError { key: Some(INNER.name.into()), message: message.into() };
    if exponent.is_some() {
        Err(refused("use either an inner angle or an exponent"))
    } else if cos_cutoff < 0.0 || inner < cos_cutoff {
        Err(refused("the inner angle needs a cutoff, and must be between 0 and it"))
    } else {
        Ok(Cone::smooth(inner, cos_cutoff))
    }
}

fn attenuation_of(fields: &mut Fields<'_>) -> Result<Attenuation, FieldError> {
    let mut law = fields.take("attenuation", attenuation)?.unwrap_or(Attenuation::NONE);
    let above_0 = |text: &str| positive(text).and_then(single);
    if let Some(limit) = fields.take("limit", above_0)? {
        law.limit = limit.min(Attenuation::NO_LIMIT);
    }
    law.range = fields.take("range", above_0)?;
    Ok(law)
}

/// The angle under which a light is seen.
fn apparent_angle(text: &str) -> Result<f32, String> {
    let degrees = non_negative_f32(text)?;
    if degrees < 180.0 { Ok(degrees) } else { Err("use 0 to less than 180 degrees".to_owned()) }
}

fn cos_cutoff_of(text: &str) -> Result<f32, String> {
    cos_cutoff(finite(text)?).ok_or_else(|| "use 0 to 90 degrees, or 180 for no cone".to_owned())
}

fn attenuation(text: &str) -> Result<Attenuation, String> {
    let coefficients: [f64; 3] = numbers(text)?;
    let single = coefficients.map(|coefficient| coefficient as f32);
    if single.iter().any(|coefficient| !coefficient.is_finite() || *coefficient < 0.0) {
        Err("coefficients must not be below 0".to_owned())
    } else if single == [0.0; 3] {
        Err("the coefficients are all 0: the light would be infinitely bright".to_owned())
    } else {
        Ok(Attenuation::new(single))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::values::light_text;

    fn parsed(text: &str) -> SceneLight {
        light(text).unwrap().named(0)
    }

    #[test]
    fn a_new_spot_has_a_cone_of_30_degrees_to_the_bit() {
        let spot = LightKindDescription::by_name("spot").unwrap();
        let cone = Cone::Exponent { cos_cutoff: cos_cutoff(30.0).unwrap(), exponent: 8.0 };
        assert_eq!(spot.kind, LightKind::Spot(cone));
    }

    #[test]
    fn a_directional_light_has_white_diffuse_and_specular_by_default() {
        let sun = parsed("directional:dir=0,-2,0");
        assert_eq!(sun.light, Light::new(LightKind::Directional, [1.0; 3]));
        assert_eq!(sun.direction, DVec3::NEG_Y);
        assert_eq!(sun.placement, Placement::World);
        assert_eq!(sun.name, "light1");
    }

    #[test]
    fn the_specular_colour_is_the_diffuse_one_unless_it_is_given() {
        let red = parsed("point:pos=1,2,3:diffuse=3,0,0");
        assert_eq!(red.light.specular, [3.0, 0.0, 0.0]);
        let both = parsed("point:pos=1,2,3:diffuse=3,0,0:specular=0,1,0:ambient=.1,.1,.1");
        assert_eq!(both.light.specular, [0.0, 1.0, 0.0]);
        assert_eq!(both.light.ambient, [0.1; 3]);
        assert_eq!(both.position, DVec3::new(1.0, 2.0, 3.0));
    }

    #[test]
    fn a_spot_has_its_cone_exponent_attenuation_name_and_space() {
        let spot = parsed(
            "spot:pos=0,0,1:dir=0,0,-1:cutoff=60:exponent=12:attenuation=0,1,.5:name=lamp:in=camera",
        );
        let cone = Cone::Exponent { cos_cutoff: 0.5, exponent: 12.0 };
        assert_eq!(spot.light.kind, LightKind::Spot(cone));
        assert_eq!(spot.light.attenuation.coefficients, [0.0, 1.0, 0.5]);
        assert_eq!(spot.name, "lamp");
        assert_eq!(spot.placement, Placement::Camera);
    }

    #[test]
    fn attenuation_has_a_limit_and_a_range_if_they_are_given() {
        let plain = parsed("point:pos=0,0,0:attenuation=0,0,1").light.attenuation;
        assert_eq!(plain, Attenuation::INVERSE_SQUARE);
        let cut = parsed("point:pos=0,0,0:attenuation=0,0,1:limit=1:range=8").light.attenuation;
        assert_eq!((cut.limit, cut.range), (1.0, Some(8.0)));
    }

    #[test]
    fn a_cone_with_an_inner_angle_is_soft() {
        let soft = parsed("spot:pos=0,0,0:dir=1,0,0:cutoff=60:inner=0").light.kind;
        assert_eq!(soft, LightKind::Spot(Cone::Smooth { cos_inner: 1.0, cos_outer: 0.5 }));
        let LightKind::Spot(Cone::Smooth { cos_inner, cos_outer }) =
            parsed("spot:pos=0,0,0:dir=1,0,0:cutoff=60:inner=60").light.kind
        else {
            panic!("not soft")
        };
        assert!(cos_inner > cos_outer, "its edge has a width");
    }

    #[test]
    fn cutoffs_end_at_90_except_180_which_is_no_cone() {
        assert_eq!(cos_cutoff_of("0"), Ok(1.0));
        assert_eq!(cos_cutoff_of("90"), Ok(0.0));
        assert_eq!(cos_cutoff_of("180"), Ok(-1.0));
        for text in ["-1", "91", "179", "181", "nan"] {
            assert!(cos_cutoff_of(text).is_err(), "{text}");
        }
        let open = Cone::Exponent { cos_cutoff: -1.0, exponent: 0.0 };
        assert_eq!(parsed("spot:pos=0,0,0:dir=1,0,0").light.kind, LightKind::Spot(open));
    }

    #[test]
    fn a_written_light_reads_back_as_the_same() {
        for text in [
            "ambient:color=0.1,0.2,0.3:name=sky",
            "directional:dir=0,-1,0:diffuse=1,0.5,0.25:in=camera:name=sun",
            "point:pos=1,-2,3.5:ambient=0.1,0,0:diffuse=1,1,1:specular=0,0,0:attenuation=1,0,0.25:name=a",
            "spot:pos=0,0,1:dir=0,0,-1:cutoff=60:exponent=12:diffuse=2,2,2:limit=1:range=8:name=b c",
            "spot:pos=0,0,1:dir=1,0,0:cutoff=40:inner=30:diffuse=1,1,1:name=c",
            "directional:dir=0,-1,0:diffuse=1,1,1:angle=0.53:name=sun",
            "point:pos=0,0,0:diffuse=1,1,1:range=3:radius=0.25:name=ball",
        ] {
            let light = parsed(text);
            let written = light_text(&light).unwrap();
            assert_eq!(written, text);
            assert_eq!(parsed(&written), light);
        }
        let odd = SceneLight { name: "a:b".to_owned(), ..parsed("point:pos=0,0,0") };
        assert_eq!(parsed(&light_text(&odd).unwrap()).name, "ab");
    }

    #[test]
    fn an_ambient_light_is_its_colour() {
        assert_eq!(parsed("ambient:color=.1,.2,.3").light, Light::ambient([0.1, 0.2, 0.3]));
    }

    #[test]
    fn invalid_lights_are_refused() {
        for text in [
            "",
            "sun",
            "directional",
            "directional:",
            "directional:dir=0,0,0",
            "directional:dir=1,0",
            "directional:dir=1,0,0:dir=1,0,0",
            "directional:dir=1,0,0:",
            "directional:dir",
            "directional:dir=1,0,0:pos=1,2,3",
            "directional:dir=nan,0,0",
            "point",
            "point:pos=1,2,inf",
            "point:pos=1,2,3:dir=1,0,0",
            "point:pos=1,2,3:cutoff=20",
            "point:pos=1,2,3:attenuation=0,0,0",
            "point:pos=1,2,3:attenuation=1e-99,0,0",
            "point:pos=1,2,3:attenuation=-1,0,0",
            "point:pos=1,2,3:limit=0",
            "point:pos=1,2,3:radius=-1",
            "point:pos=1,2,3:radius=nan",
            "point:pos=1,2,3:angle=1",
            "directional:dir=1,0,0:radius=1",
            "directional:dir=1,0,0:angle=180",
            "point:pos=1,2,3:range=-1",
            "directional:dir=1,0,0:inner=3",
            "spot:pos=1,2,3:dir=1,0,0:inner=20",
            "spot:pos=1,2,3:dir=1,0,0:cutoff=20:inner=21",
            "spot:pos=1,2,3:dir=1,0,0:cutoff=20:inner=2:exponent=1",
            "point:pos=1,2,3:in=space",
            "point:pos=1,2,3:name=",
            "spot:pos=1,2,3",
            "spot:pos=1,2,3:dir=1,0,0:cutoff=100",
            "spot:pos=1,2,3:dir=1,0,0:exponent=-1",
            "ambient",
            "ambient:color=1,2",
            "ambient:color=1,1,1:diffuse=1,1,1",
        ] {
            assert!(light(text).is_err(), "{text}");
        }
    }
}
