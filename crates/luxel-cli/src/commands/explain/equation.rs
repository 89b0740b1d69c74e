//! The lighting equation of one place as rows: what each term is the product of.

use crate::values::reflection_name;
use luxel::lighting::{
    Attenuation, Light, LightKind, Material, MirrorTerms, Reflectance, Reflection,
};
use luxel::render::{ExplainedLight, ExplainedSurface, Unlit};

/// What a row is about; pages give each its colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    Ambient,
    Diffuse,
    Specular,
    Emission,
    Environment,
    Fog,
    Sum,
}

/// One factor of a product.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Factor {
    /// A number.
    Number(Symbol, f32),
    /// A colour.
    Color(Symbol, [f32; 3]),
    /// The larger of a cosine and 0.
    Cosine(Symbol, f32),
    /// The larger of a cosine and 0, to the power n.
    Power(Symbol, f32, f32),
}

/// A symbol of the equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Symbol {
    /// For plain text.
    pub(super) text: &'static str,
    /// For LaTeX.
    pub(super) latex: &'static str,
    /// For HTML.
    pub(super) html: &'static str,
}

/// One term.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) role: Role,
    pub(super) name: &'static str,
    pub(super) factors: Vec<Factor>,
    pub(super) value: [f32; 3],
}

/// One term of a sum that is itself a factor: a part of a mix of models.
#[derive(Clone, Debug)]
pub(super) struct PartRow {
    /// The sum.
    pub(super) of: Symbol,
    pub(super) row: Row,
}

/// The rows of one light.
pub(super) struct LightRows<'a> {
    pub(super) light: &'a ExplainedLight,
    /// Of a mix its parts.
    pub(super) parts: Vec<PartRow>,
    pub(super) rows: Vec<Row>,
    /// Why it adds no diffuse and no specular light.
    pub(super) why_not: Option<String>,
}

/// A place where light was computed: the sample itself, or one of those between which light is
/// interpolated.
pub(super) struct LitPlace<'a> {
    /// Its part in the light of the sample, and its light as it is interpolated; `None` for the
    /// sample itself.
    pub(super) share: Option<(f32, [f32; 3])>,
    pub(super) normal: [f32; 3],
    pub(super) view: [f32; 3],
    pub(super) constants: &'a Material,
    pub(super) reflectance: &'a Reflectance<f32>,
    pub(super) ambient_light: [f32; 3],
    pub(super) emission: [f32; 3],
    pub(super) scene_ambient: [f32; 3],
    pub(super) lights: &'a [ExplainedLight],
    pub(super) environment: [f32; 3],
    pub(super) mirrors: &'a [(usize, MirrorTerms<f32>)],
    pub(super) sum: [f32; 3],
}

/// The places where a surface's light was computed.
pub(super) fn lit_places(surface: &ExplainedSurface) -> Vec<LitPlace<'_>> {
    let constants = &surface.material.constants;
    let ambient_light = surface.ambient_light;
    if surface.evaluated_at.is_empty() {
        return vec![LitPlace {
            share: None,
            normal: surface.normal,
            view: surface.view,
            constants,
            reflectance: &surface.material.reflectance,
            ambient_light,
            emission: surface.emission,
            scene_ambient: surface.scene_ambient,
            lights: &surface.lights,
            environment: surface.environment,
            mirrors: &surface.mirrors,
            sum: surface.sum,
        }];
    }
    let places = surface.evaluated_at.iter().map(|place| LitPlace {
        share: Some((place.weight, place.light)),
        normal: place.normal,
        view: place.view,
        constants,
        reflectance: &place.reflectance,
        ambient_light,
        emission: place.emission,
        scene_ambient: place.scene_ambient,
        lights: &place.lights,
        environment: place.environment,
        mirrors: &place.mirrors,
        sum: place.sum,
    });
    places.collect()
}

/// The rows of one place.
pub(super) struct Rows<'a> {
    /// Emission and ambient light.
    pub(super) own: Vec<Row>,
    pub(super) lights: Vec<LightRows<'a>>,
    /// What of the environment the parts of a mix mirror.
    pub(super) mirrors: Vec<PartRow>,
    pub(super) environment: Option<Row>,
}

impl Factor {
    pub(super) fn symbol(&self) -> Symbol {
        match *self {
            Self::Number(symbol, _)
            | Self::Color(symbol, _)
            | Self::Cosine(symbol, _)
            | Self::Power(symbol, ..) => symbol,
        }
    }
}

/// Why a light adds nothing, in words.
pub(super) fn why_not(unlit: Unlit) -> String {
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

/// The vector that the highlight goes by, and its name.
pub(super) fn highlight_vector(
    place: &LitPlace<'_>,
    light: &ExplainedLight,
) -> Option<(&'static str, [f32; 3])> {
    light.highlight(&place.constants.reflection, place.normal, place.view)
}

/// The model, and for mixes its parts.
pub(super) fn model_name(reflection: &Reflection) -> String {
    match reflection {
        Reflection::Mixed(parts) => {
            let part =
                |(part, weight): &(Reflection, f32)| format!("{weight} {}", reflection_name(part));
            parts.iter().map(part).collect::<Vec<_>>().join(" + ")
        }
        simple => reflection_name(simple).to_owned(),
    }
}

/// What weakens a light, in words.
pub(super) fn reach(light: &ExplainedLight) -> Option<String> {
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

/// A number with four digits that count; as it is where it needs no more.
pub(super) fn number(value: f32) -> String {
    let shortest = value.to_string();
    if value == 0.0 {
        return "0".to_owned();
    }
    let size = value.abs();
    let rounded = if (1e-3..1e5).contains(&size) {
        format!("{value:.*}", 4_usize.saturating_sub(digits_before_point(size)))
    } else {
        format!("{value:.3e}")
    };
    if shortest.len() <= rounded.len() { shortest } else { rounded }
}

/// Digits before the point.
fn digits_before_point(value: f32) -> usize {
    let (mut digits, mut rest) = (0, value.abs());
    while rest >= 1.0 {
        rest /= 10.0;
        digits += 1;
    }
    digits
}

/// A colour: one number where its three are equal.
pub(super) fn color([r, g, b]: [f32; 3]) -> String {
    if r == g && g == b {
        number(r)
    } else {
        format!("({}, {}, {})", number(r), number(g), number(b))
    }
}
