//! The contribution of one light at one point, in words.

use super::point::ShadingPoint;
use crate::words::number;
use luxel_lighting::{Attenuation, Light, LightKind};
use luxel_render::{BlockedBy, ExplainedLight, Unlit};

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
        Unlit::Shadowed => "something stands in its way".to_owned(),
        Unlit::BeyondTerminator => "the surface under the normal map turns away from it".to_owned(),
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

/// What stands in a light's way, in words, and the terminator's factor and offset where they act.
pub(crate) fn in_the_way(light: &ExplainedLight) -> Option<String> {
    let shadow = light.shadow.as_ref()?;
    let blocked = |by: &BlockedBy| {
        let BlockedBy { name, triangle, distance, share, .. } = by;
        let part = if *share == 1.0 { String::new() } else { format!(" keeps {}", number(*share)) };
        format!("triangle {triangle} of {name}, {} away{part}", number(*distance as f32))
    };
    let mut parts = Vec::new();
    if !shadow.blocked_by.is_empty() {
        let blocked: Vec<_> = shadow.blocked_by.iter().map(blocked).collect();
        parts.push(format!("in its way: {}", blocked.join("; ")));
    }
    if shadow.terminator < 1.0 {
        parts.push(format!("terminator {}", number(shadow.terminator)));
    }
    if shadow.raised > 0.0 {
        let raised = number(shadow.raised as f32);
        parts.push(format!("its ray leaves {raised} above the triangle, from the curved surface"));
    }
    (!parts.is_empty()).then(|| parts.join(", "))
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
