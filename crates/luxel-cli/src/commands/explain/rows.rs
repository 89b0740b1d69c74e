//! The terms of one place, and what each is the product of.

use super::equation::{Factor, LightRows, LitPlace, PartRow, Role, Row, Rows, Symbol, why_not};
use crate::values::reflection_name;
use luxel::lighting::{LightKind, Lobe, Material, MirrorTerms, PartTerms, Reflection};
use luxel::math::Rgb;
use luxel::render::ExplainedLight;

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
const PI_D: Symbol = symbol("pi D", r"\pi D", "π D");
const VISIBILITY: Symbol = symbol("V", "V", "V");
const FRESNEL: Symbol = symbol("F", "F", "F");
const WEIGHT: Symbol = symbol("w", "w", "<i>w</i>");
const MIXED_DIFFUSE: Symbol = symbol("rho_d", r"\rho_d", "ρ<sub>d</sub>");
const MIXED_SPECULAR: Symbol = symbol("rho_s", r"\rho_s", "ρ<sub>s</sub>");
const MIXED_MIRROR: Symbol = symbol("rho_e", r"\rho_e", "ρ<sub>e</sub>");
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
    Rows {
        // An emission of nothing is not worth a line.
        own: (place.emission != [0.0; 3])
            .then_some(emission)
            .into_iter()
            .chain([ambient])
            .collect(),
        lights: place.lights.iter().map(|light| light_rows(place, light)).collect(),
        mirrors: mirror_rows(place),
        environment: environment_row(place),
    }
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
    let parts = if why_not.is_none() { part_rows(place, light) } else { Vec::new() };
    LightRows { light, parts, rows, why_not }
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

/// What is mirrored of the environment, if that is any light.
fn environment_row(place: &LitPlace<'_>) -> Option<Row> {
    if place.environment == [0.0; 3] {
        return None;
    }
    let LitPlace { constants, reflectance, mirrors, .. } = place;
    let mut factors =
        vec![Factor::Number(K_S, constants.k_s), Factor::Color(O_S, reflectance.specular.lane(0))];
    match (&constants.reflection, mirrors) {
        (Reflection::Mixed(_), mirrors) => {
            let sum = mirrors.iter().fold(Rgb::black(0.0), |sum, (_, terms)| {
                sum + terms.share * terms.radiance * terms.weight
            });
            factors.push(Factor::Color(MIXED_MIRROR, sum.lane(0)));
        }
        (model, [(_, only)]) => factors.extend(mirrored(model, only)),
        _ => {}
    }
    if reflectance.occlusion != 1.0 {
        factors.push(Factor::Number(OCCLUSION, reflectance.occlusion));
    }
    let (role, name) = (Role::Environment, "environment");
    Some(Row { role, name, factors, value: place.environment })
}

/// What the parts of a mix mirror.
fn mirror_rows(place: &LitPlace<'_>) -> Vec<PartRow> {
    let Reflection::Mixed(_) = place.constants.reflection else { return Vec::new() };
    let row = |(index, terms): &(usize, MirrorTerms<f32>)| {
        let (model, _) = place.constants.reflection.part(*index);
        let weight = Factor::Number(WEIGHT, terms.weight);
        let row = Row {
            role: Role::Environment,
            name: reflection_name(model),
            factors: [weight].into_iter().chain(mirrored(model, terms)).collect(),
            value: (terms.share * terms.radiance * terms.weight).lane(0),
        };
        PartRow { of: MIXED_MIRROR, row }
    };
    place.mirrors.iter().map(row).collect()
}

/// What one model mirrors, but for k_s O_s.
fn mirrored(model: &Reflection, terms: &MirrorTerms<f32>) -> Vec<Factor> {
    let share = Factor::Color(SPLIT_SUM, terms.share.lane(0));
    let radiance = Factor::Color(E_OF_R, terms.radiance.lane(0));
    if *model == Reflection::Microfacet { vec![share, radiance] } else { vec![radiance] }
}

/// The factors that go with I_d: of a mix the sum of its parts, of all others the model's own.
fn diffuse_factors(place: &LitPlace<'_>, light: &ExplainedLight) -> Vec<Factor> {
    let intensity = Factor::Color(I_D, light.light.diffuse);
    let share = match (&place.constants.reflection, &light.parts[..]) {
        (Reflection::Mixed(_), parts) => {
            vec![Factor::Color(MIXED_DIFFUSE, mixed(parts, |part| part.diffuse))]
        }
        (model, [(_, part)]) => diffuse_share(place, light, model, part),
        _ => Vec::new(),
    };
    [intensity].into_iter().chain(share).collect()
}

/// The factors that go with I_s; `None` where the model has no highlight.
fn specular_factors(place: &LitPlace<'_>, light: &ExplainedLight) -> Option<Vec<Factor>> {
    let intensity = Factor::Color(I_S, light.light.specular);
    let share = match (&place.constants.reflection, &light.parts[..]) {
        (Reflection::Mixed(_), parts) => {
            vec![Factor::Color(MIXED_SPECULAR, mixed(parts, |part| part.specular))]
        }
        (model, [(_, part)]) => specular_share(place, light, model, part)?,
        _ => return None,
    };
    Some([intensity].into_iter().chain(share).collect())
}

/// The weighted sum of the parts of a mix, as the equation adds them up.
fn mixed(parts: &[(usize, PartTerms<f32>)], of: impl Fn(&PartTerms<f32>) -> Rgb<f32>) -> [f32; 3] {
    let sum = parts.iter().fold(Rgb::black(0.0), |sum, (_, part)| sum + of(part) * part.weight);
    sum.lane(0)
}

/// The parts of a mix: what each sends of I_d, then of I_s.
fn part_rows(place: &LitPlace<'_>, light: &ExplainedLight) -> Vec<PartRow> {
    let Reflection::Mixed(_) = place.constants.reflection else { return Vec::new() };
    let model = |index: usize| place.constants.reflection.part(index).0;
    let row = |of, role, index, share: Vec<Factor>, value: Rgb<f32>, weight: f32| {
        let value = (value * weight).lane(0);
        let factors = [Factor::Number(WEIGHT, weight)].into_iter().chain(share).collect();
        let row = Row { role, name: reflection_name(model(index)), factors, value };
        (value != [0.0; 3]).then_some(PartRow { of, row })
    };
    let diffuse = light.parts.iter().filter_map(|(index, part)| {
        let share = diffuse_share(place, light, model(*index), part);
        row(MIXED_DIFFUSE, Role::Diffuse, *index, share, part.diffuse, part.weight)
    });
    let specular = light.parts.iter().filter_map(|(index, part)| {
        let share = specular_share(place, light, model(*index), part)?;
        row(MIXED_SPECULAR, Role::Specular, *index, share, part.specular, part.weight)
    });
    diffuse.chain(specular).collect()
}

/// What one model sends of I_d.
fn diffuse_share(
    place: &LitPlace<'_>,
    light: &ExplainedLight,
    model: &Reflection,
    part: &PartTerms<f32>,
) -> Vec<Factor> {
    let LitPlace { constants, reflectance, .. } = place;
    let mut factors =
        vec![Factor::Number(K_D, constants.k_d), Factor::Color(O_D, reflectance.diffuse.lane(0))];
    let cosine = Factor::Cosine(N_DOT_L, light.terms.n_dot_l);
    match (model, part.lobe) {
        (_, Lobe::Rough(factor)) => factors.extend([cosine, Factor::Number(ROUGH, factor)]),
        (_, Lobe::Facets { fresnel, .. }) => factors.extend([
            Factor::Color(NOT_MIRRORED, fresnel.lane(0).map(|f| 1.0 - f)),
            Factor::Number(NOT_METAL, 1.0 - reflectance.metallic),
            cosine,
        ]),
        _ => factors.push(cosine),
    }
    factors
}

/// What one model sends of I_s; `None` where it has no highlight.
fn specular_share(
    place: &LitPlace<'_>,
    light: &ExplainedLight,
    model: &Reflection,
    part: &PartTerms<f32>,
) -> Option<Vec<Factor>> {
    let LitPlace { constants, reflectance, .. } = place;
    let mut factors =
        vec![Factor::Number(K_S, constants.k_s), Factor::Color(O_S, reflectance.specular.lane(0))];
    let cosine = part.specular_cosine.unwrap_or_default();
    let lobe = |symbol| Factor::Power(symbol, cosine, reflectance.shininess);
    match (model, part.lobe) {
        (Reflection::Phong, _) => factors.push(lobe(R_DOT_V)),
        (Reflection::BlinnPhong, _) => factors.push(lobe(N_DOT_H)),
        (Reflection::Retro, _) => factors.push(lobe(V_DOT_L)),
        (_, Lobe::Facets { pi_d, visibility, fresnel }) => factors.extend([
            Factor::Number(PI_D, pi_d),
            Factor::Number(VISIBILITY, visibility),
            Factor::Color(FRESNEL, fresnel.lane(0)),
            Factor::Cosine(N_DOT_L, light.terms.n_dot_l),
        ]),
        _ => return None,
    }
    Some(factors)
}
