//! The contribution of one light at one point, in words.

use super::point::ShadingPoint;
use crate::words::number;
use luxel_lighting::{Attenuation, Light, LightKind};
use luxel_render::{ExplainedLight, Unlit};

/// Why a light adds nothing, in words.
pub(crate) fn why_not(unlit: Unlit) -> String {
    let degrees = |cosine: f32| libm::acos(f64::from(cosine.clamp(-1.0, 1.0))).to_degrees();
    match unlit {
        Unlit::Behind => {
            "it stands behind the surface, or in its plane: N.L is not above 0".to_owned()
        }
        Unlit::OutsideCone { cos_angle, cos_cutoff } => format!(
            "the surface lies {:.1} degrees off its axis, outside of its cone of {:.1} degrees",
            degrees(cos_angle),
            degrees(cos_cutoff)
        ),
        Unlit::OutOfRange { distance, range } => format!(
            "the surface lies {} away, beyond its range of {}",
            number(distance),
            number(range)
        ),
        Unlit::AtTheSurface => "it stands at the surface itself".to_owned(),
        Unlit::Dark => "it has no intensity".to_owned(),
        Unlit::Absorbed => "the surface reflects nothing of its colour".to_owned(),
    }
}

/// The vector that the highlight depends on, and its name: R, H or L.
pub(crate) fn highlight_vector(
    point: &ShadingPoint<'_>,
    light: &ExplainedLight,
) -> Option<(&'static str, [f32; 3])> {
    light.highlight(&point.constants.reflection, point.normal, point.view)
}

/// The attenuation of a light, in words.
pub(crate) fn reach(light: &ExplainedLight) -> Option<String> {
    let Light { kind, attenuation, .. } = &light.light;
    let terms = &light.terms;
    let distance = terms.distance?;
    let [c1, c2, c3] = attenuation.coefficients;
    let mut text = format!("d = {}", number(distance));
    if *attenuation != Attenuation::NONE {
        let shown = number(terms.attenuation);
        let cut = match attenuation.limit {
            Attenuation::NO_LIMIT => String::new(),
            limit => format!(", cut at {limit}"),
        };
        let window = match attenuation.range {
            Some(range) => format!(", ending at {range}"),
            None => String::new(),
        };
        text += &format!(", attenuation 1 / ({c1} + {c2} d + {c3} d^2){cut}{window} = {shown}");
    }
    if matches!(kind, LightKind::Spot(_)) {
        text += &format!(", cone {}", number(terms.spot));
    }
    Some(text)
}
