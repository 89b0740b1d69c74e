//! `near=Z:far=Z:front=S:back=S:color=COLOR`: depth cueing; `law=exp:density=D`: fog.

use super::color::color;
use super::fields::{FieldError, Fields};
use super::number::{finite, non_negative_f32, unit_interval};
use luxel_lighting::{Fog, FogLaw};

/// Parses fog from one string.
///
/// # Errors
/// As [`fog_of`], and duplicate fields.
pub fn fog(text: &str) -> Result<Fog, String> {
    let fields = Fields::parse(text).map_err(|error| error.to_string())?;
    fog_of(fields).map_err(|error| error.to_string())
}

/// Depth cueing, I' = s I + (1 - s) color, with s from `front` at `near` to `back` at `far`, which
/// are distances along the viewing axis. `near` and `far` are required; `front` is 1, `back` 0, the
/// colour black by default. With `law=exp` or `law=exp2` s is exp(-density z) or
/// exp(-(density z)^2) instead, and `density` is required.
///
/// # Errors
/// Missing, unknown or wrong fields.
pub fn fog_of(mut fields: Fields<'_>) -> Result<Fog, FieldError> {
    let law = fields.take("law", law)?.unwrap_or_default();
    let color = fields.take("color", color)?.unwrap_or_default();
    let law = match law {
        Law::Linear => return Ok(Fog { color, law: depth_cue(fields)? }),
        Law::Exp | Law::Exp2 => {
            let density = fields.take("density", non_negative_f32)?;
            if let Some(key) = fields.unknown_key() {
                let message = format!("`{key}` is not for this law: use density, color");
                return Err(FieldError::new(message));
            }
            let density = density.ok_or_else(|| FieldError::new("it needs density=D"))?;
            match law {
                Law::Exp2 => FogLaw::ExponentialSquared { density },
                _ => FogLaw::Exponential { density },
            }
        }
    };
    Ok(Fog { color, law })
}

/// How s falls with distance.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Law {
    #[default]
    Linear,
    Exp,
    Exp2,
}

fn law(text: &str) -> Result<Law, String> {
    match text {
        "linear" => Ok(Law::Linear),
        "exp" => Ok(Law::Exp),
        "exp2" => Ok(Law::Exp2),
        _ => Err(format!("`{text}` is not a fog law: use linear, exp or exp2")),
    }
}

fn depth_cue(mut fields: Fields<'_>) -> Result<FogLaw, FieldError> {
    let near = fields.take("near", finite)?;
    let far = fields.take("far", finite)?;
    let front = fields.take("front", unit_interval)?;
    let back = fields.take("back", unit_interval)?;
    if let Some(key) = fields.unknown_key() {
        let message = format!("`{key}` is unknown: use law, near, far, front, back, color");
        return Err(FieldError::new(message));
    }
    // In single precision, as shading uses it.
    let near = near.ok_or_else(|| FieldError::new("it needs near=Z"))? as f32;
    let far = far.ok_or_else(|| FieldError::new("it needs far=Z"))? as f32;
    if near >= far {
        return Err(FieldError::new("near must be less than far"));
    }
    Ok(FogLaw::DepthCue { near, far, front: front.unwrap_or(1.0), back: back.unwrap_or(0.0) })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_of_fog_is_read() {
        let all = fog("near=1:far=5:front=.9:back=.1:color=.5,.6,.7").unwrap();
        let law = FogLaw::DepthCue { near: 1.0, far: 5.0, front: 0.9, back: 0.1 };
        assert_eq!(all, Fog { color: [0.5, 0.6, 0.7], law });
    }

    #[test]
    fn by_default_fog_fades_to_black() {
        let law = FogLaw::DepthCue { near: -1.0, far: 5.0, front: 1.0, back: 0.0 };
        assert_eq!(fog("far=5:near=-1"), Ok(Fog { color: [0.0; 3], law }));
    }

    #[test]
    fn laws_of_density_are_exp_and_exp2() {
        let color = [0.1, 0.2, 0.3];
        let law = FogLaw::Exponential { density: 0.5 };
        assert_eq!(fog("law=exp:density=.5:color=.1,.2,.3"), Ok(Fog { color, law }));
        let law = FogLaw::ExponentialSquared { density: 2.0 };
        assert_eq!(fog("density=2:law=exp2"), Ok(Fog { color: [0.0; 3], law }));
    }

    #[test]
    fn invalid_fog_is_refused() {
        for text in [
            "",
            "near=1",
            "far=1",
            "near=1:far=1",
            "near=2:far=1",
            "near=1:far=nan",
            "near=1:far=2:front=2",
            "near=1:far=2:back=-1",
            "near=1:far=2:color=1,1",
            "near=1:near=1:far=2",
            "near=1:far=2:density=3",
            "near:far",
            "law=exp",
            "law=thick:near=1:far=2",
            "law=exp:density=-1",
            "law=exp2:density=1:near=1:far=2",
        ] {
            assert!(fog(text).is_err(), "{text}");
        }
    }
}
