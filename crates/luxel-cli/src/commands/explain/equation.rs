//! The lighting equation of one place as rows: what each term is the product of.

use crate::values::reflection_name;
use luxel::lighting::{Attenuation, Light, LightKind, Material, Reflectance, Reflection};
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
    /// A function that is named and not taken apart.
    Named(Symbol),
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

/// The rows of one light.
pub(super) struct LightRows<'a> {
    pub(super) light: &'a ExplainedLight,
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
    ambient_light: [f32; 3],
    pub(super) emission: [f32; 3],
    pub(super) scene_ambient: [f32; 3],
    pub(super) lights: &'a [ExplainedLight],
    pub(super) environment: [f32; 3],
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
        sum: place.sum,
    });
    places.collect()
}

/// The rows of one place.
pub(super) struct Rows<'a> {
    /// Emission and ambient light.
    pub(super) own: Vec<Row>,
    pub(super) lights: Vec<LightRows<'a>>,
    pub(super) environment: Option<Row>,
}

impl Factor {
    pub(super) fn symbol(&self) -> Symbol {
        match *self {
            Self::Number(symbol, _)
            | Self::Color(symbol, _)
            | Self::Cosine(symbol, _)
            | Self::Power(symbol, ..)
            | Self::Named(symbol) => symbol,
        }
    }
}

const fn symbol(text: &'static str, latex: &'static str, html: &'static str) -> Symbol {
    Symbol { text, latex, html }
}

const F: Symbol = symbol("f", "f", "<i>f</i>");
const I_A: Symbol = symbol("I_a", "I_a", "<i>I</i><sub>a</sub>");
const I_D: Symbol = symbol("I_d", "I_d", "<i>I</i><sub>d</sub>");
const I_S: Symbol = symbol("I_s", "I_s", "<i>I</i><sub>s</sub>");
const K_A: Symbol = symbol("k_a", "k_a", "<i>k</i><sub>a</sub>");
const K_D: Symbol = symbol("k_d", "k_d", "<i>k</i><sub>d</sub>");
const K_S: Symbol = symbol("k_s", "k_s", "<i>k</i><sub>s</sub>");
const O_A: Symbol = symbol("O_a", "O_a", "<i>O</i><sub>a</sub>");
const O_D: Symbol = symbol("O_d", "O_d", "<i>O</i><sub>d</sub>");
const O_E: Symbol = symbol("O_e", "O_e", "<i>O</i><sub>e</sub>");
const O_S: Symbol = symbol("O_s", "O_s", "<i>O</i><sub>s</sub>");
const OCCLUSION: Symbol = symbol("occlusion", r"\mathrm{occlusion}", "occlusion");
const NOT_METAL: Symbol = symbol("(1 - metallic)", r"(1 - \mathrm{metallic})", "(1 − metallic)");
const N_DOT_L: Symbol = symbol("N.L", r"\mathbf N\cdot\mathbf L", "<b>N</b>·<b>L</b>");
const R_DOT_V: Symbol = symbol("R.V", r"\mathbf R\cdot\mathbf V", "<b>R</b>·<b>V</b>");
const N_DOT_H: Symbol = symbol("N.H", r"\mathbf N\cdot\mathbf H", "<b>N</b>·<b>H</b>");
const V_DOT_L: Symbol = symbol("V.L", r"\mathbf V\cdot\mathbf L", "<b>V</b>·<b>L</b>");
const ROUGH: Symbol = symbol(
    "(A + B max(q, 0) / max(N.L, N.V))",
    r"\Bigl(A + B\,\tfrac{\max(q, 0)}{\max(\mathbf N\cdot\mathbf L,\,\mathbf N\cdot\mathbf V)}\Bigr)",
    "(A + B max(q, 0) / max(<b>N</b>·<b>L</b>, <b>N</b>·<b>V</b>))",
);
const NOT_MIRRORED: Symbol = symbol("(1 - F)", "(1 - F)", "(1 − F)");
const FACETS: Symbol = symbol("pi D V F", r"\pi D V F", "π D V F");
const MIXED: Symbol = symbol("mixed lobe", r"\rho", "mixed lobe");
const E_OF_R: Symbol = symbol("E(R)", r"E(\mathbf R)", "E(<b>R</b>)");
const SPLIT_SUM: Symbol = symbol("(F0 A + B)", "(F_0 A + B)", "(F<sub>0</sub> A + B)");

/// The rows of a place's light.
pub(super) fn rows<'a>(place: &LitPlace<'a>) -> Rows<'a> {
    let LitPlace { constants, reflectance, .. } = place;
    let unlit = constants.reflection == Reflection::Unlit;
    let emission = Row {
        role: Role::Emission,
        name: "emission",
        factors: if unlit {
            vec![
                Factor::Number(K_D, constants.k_d),
                Factor::Color(O_D, reflectance.diffuse.lane(0)),
            ]
        } else {
            vec![Factor::Color(O_E, reflectance.emission.lane(0))]
        },
        value: place.emission,
    };
    let ambient = Row {
        role: Role::Ambient,
        name: "ambient",
        factors: ambient_factors(place, Factor::Color(I_A, place.ambient_light)),
        value: place.scene_ambient,
    };
    let mirrors = place.environment != [0.0; 3];
    Rows {
        // An emission of nothing is not worth a line.
        own: (place.emission != [0.0; 3])
            .then_some(emission)
            .into_iter()
            .chain([ambient])
            .collect(),
        lights: place.lights.iter().map(|light| light_rows(place, light)).collect(),
        environment: mirrors.then(|| Row {
            role: Role::Environment,
            name: "environment",
            factors: environment_factors(place),
            value: place.environment,
        }),
    }
}

fn ambient_factors(place: &LitPlace<'_>, intensity: Factor) -> Vec<Factor> {
    let Material { k_a, reflection, .. } = place.constants;
    let reflectance = place.reflectance;
    let mut factors =
        vec![intensity, Factor::Number(K_A, *k_a), Factor::Color(O_A, reflectance.ambient.lane(0))];
    if reflectance.occlusion != 1.0 {
        factors.push(Factor::Number(OCCLUSION, reflectance.occlusion));
    }
    // With an environment, metals have no other ambient light.
    if *reflection == Reflection::Microfacet && place.environment != [0.0; 3] {
        factors.push(Factor::Number(NOT_METAL, 1.0 - reflectance.metallic));
    }
    factors
}

fn environment_factors(place: &LitPlace<'_>) -> Vec<Factor> {
    let reflectance = place.reflectance;
    let mut factors = vec![
        Factor::Number(K_S, place.constants.k_s),
        Factor::Color(O_S, reflectance.specular.lane(0)),
    ];
    match place.constants.reflection {
        Reflection::Microfacet => factors.push(Factor::Named(SPLIT_SUM)),
        Reflection::Mixed(_) => factors.push(Factor::Named(MIXED)),
        _ => {}
    }
    factors.push(Factor::Named(E_OF_R));
    if reflectance.occlusion != 1.0 {
        factors.push(Factor::Number(OCCLUSION, reflectance.occlusion));
    }
    factors
}

fn light_rows<'a>(place: &LitPlace<'_>, light: &'a ExplainedLight) -> LightRows<'a> {
    let terms = &light.terms;
    let f = Factor::Number(F, terms.attenuation * terms.spot);
    let with_f = |rest: Vec<Factor>| -> Vec<Factor> {
        let fades = light.light.kind != LightKind::Directional;
        fades.then(|| f.clone()).into_iter().chain(rest).collect()
    };
    let mut rows = Vec::new();
    if light.light.ambient != [0.0; 3] {
        let intensity = Factor::Color(I_A, light.light.ambient);
        rows.push(Row {
            role: Role::Ambient,
            name: "ambient",
            factors: with_f(ambient_factors(place, intensity)),
            value: terms.ambient.lane(0),
        });
    }
    let why_not = light.unlit().map(why_not);
    if why_not.is_none() {
        rows.push(Row {
            role: Role::Diffuse,
            name: "diffuse",
            factors: with_f(diffuse_factors(place, light)),
            value: terms.diffuse.lane(0),
        });
        if let Some(factors) = specular_factors(place, light) {
            rows.push(Row {
                role: Role::Specular,
                name: "specular",
                factors: with_f(factors),
                value: terms.specular.lane(0),
            });
        }
    }
    LightRows { light, rows, why_not }
}

fn diffuse_factors(place: &LitPlace<'_>, light: &ExplainedLight) -> Vec<Factor> {
    let LitPlace { constants, reflectance, .. } = place;
    let mut factors = vec![
        Factor::Color(I_D, light.light.diffuse),
        Factor::Number(K_D, constants.k_d),
        Factor::Color(O_D, reflectance.diffuse.lane(0)),
    ];
    let cosine = Factor::Cosine(N_DOT_L, light.terms.n_dot_l);
    match constants.reflection {
        Reflection::OrenNayar => factors.extend([cosine, Factor::Named(ROUGH)]),
        Reflection::Microfacet => factors.extend([
            Factor::Named(NOT_MIRRORED),
            Factor::Number(NOT_METAL, 1.0 - reflectance.metallic),
            cosine,
        ]),
        Reflection::Mixed(_) => factors.push(Factor::Named(MIXED)),
        _ => factors.push(cosine),
    }
    factors
}

/// The factors of the highlight; `None` where the model has none.
fn specular_factors(place: &LitPlace<'_>, light: &ExplainedLight) -> Option<Vec<Factor>> {
    let LitPlace { constants, reflectance, .. } = place;
    let mut factors = vec![
        Factor::Color(I_S, light.light.specular),
        Factor::Number(K_S, constants.k_s),
        Factor::Color(O_S, reflectance.specular.lane(0)),
    ];
    let cosine = light.terms.specular_cosine.unwrap_or_default();
    let lobe = |symbol| Factor::Power(symbol, cosine, reflectance.shininess);
    match constants.reflection {
        Reflection::Phong => factors.push(lobe(R_DOT_V)),
        Reflection::BlinnPhong => factors.push(lobe(N_DOT_H)),
        Reflection::Retro => factors.push(lobe(V_DOT_L)),
        Reflection::Microfacet => {
            factors.extend([Factor::Named(FACETS), Factor::Cosine(N_DOT_L, light.terms.n_dot_l)]);
        }
        Reflection::Mixed(_) => factors.push(Factor::Named(MIXED)),
        _ => return None,
    }
    Some(factors)
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
    let l = light.terms.to_light.lane(0);
    let (n, v) = (place.normal, place.view);
    let vector = match place.constants.reflection {
        Reflection::Phong => {
            let twice = 2.0 * light.terms.n_dot_l;
            ("R", [0, 1, 2].map(|axis| twice * n[axis] - l[axis]))
        }
        Reflection::BlinnPhong | Reflection::Microfacet => {
            let sum = [0, 1, 2].map(|axis| l[axis] + v[axis]);
            let length = sum.iter().map(|side| side * side).sum::<f32>().sqrt();
            ("H", sum.map(|side| if length > 0.0 { side / length } else { 0.0 }))
        }
        _ => return None,
    };
    Some(vector)
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
