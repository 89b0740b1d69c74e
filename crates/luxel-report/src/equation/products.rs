//! The terms of one point as products.

use super::light::why_not;
use super::point::ShadingPoint;
use super::symbols::*;
use super::term::{Factor, PartTerm, Term, TermKind};
use luxel_lighting::{
    DiffuseTerms, Material, MirrorTerms, ModelFactor, PartTerms, Quantity, Reflection,
};
use luxel_math::Rgb;
use luxel_render::ExplainedLight;

/// The terms of one light.
pub(crate) struct LightEntry<'a> {
    pub(crate) light: &'a ExplainedLight,
    /// The parts of a mix of reflection models.
    pub(crate) parts: Vec<PartTerm>,
    pub(crate) terms: Vec<Term>,
    /// Why it adds no diffuse and no specular light.
    pub(crate) why_not: Option<String>,
}

/// The terms of one point.
pub(crate) struct PointTerms<'a> {
    /// Emission and ambient light.
    pub(crate) own: Vec<Term>,
    pub(crate) lights: Vec<LightEntry<'a>>,
    /// The environment reflected by the parts of a mixture.
    pub(crate) mirrors: Vec<PartTerm>,
    /// What is mirrored, and what is reflected to all sides.
    pub(crate) environment: Vec<Term>,
}

/// The terms of the light at a point.
pub(crate) fn point_terms<'a>(point: &ShadingPoint<'a>) -> PointTerms<'a> {
    let ShadingPoint { constants, reflectance, .. } = point;
    let unlit = constants.reflection == Reflection::Unlit;
    let emission = Term {
        kind: TermKind::Emission,
        name: "emission",
        factors: if unlit {
            vec![
                Factor::Number(K_D, constants.k_d),
                Factor::Color(O_D, reflectance.diffuse.lane(0)),
            ]
        } else {
            vec![Factor::Color(O_E, reflectance.emission.lane(0))]
        },
        value: point.emission,
    };
    let ambient = Term {
        kind: TermKind::Ambient,
        name: "ambient",
        factors: ambient_factors(point, Factor::Color(I_A, point.ambient_light)),
        value: point.scene_ambient,
    };
    PointTerms {
        // Black emission is not worth a line.
        own: (point.emission != [0.0; 3])
            .then_some(emission)
            .into_iter()
            .chain([ambient])
            .collect(),
        lights: point.lights.iter().map(|light| light_entry(point, light)).collect(),
        mirrors: mirror_terms(point).into_iter().chain(diffuse_terms(point)).collect(),
        environment: mirrored_term(point).into_iter().chain(diffused_term(point)).collect(),
    }
}

fn light_entry<'a>(point: &ShadingPoint<'_>, light: &'a ExplainedLight) -> LightEntry<'a> {
    let terms = &light.terms;
    let f = Factor::Number(F, terms.attenuation * terms.spot);
    let with_f = |rest: Vec<Factor>| -> Vec<Factor> {
        let fades = light.light.kind.has_place();
        let visible = terms.visibility.filter(|visibility| *visibility != 1.0);
        let visible = visible.map(|visibility| Factor::Number(VISIBILITY, visibility));
        visible.into_iter().chain(fades.then(|| f.clone())).chain(rest).collect()
    };
    let mut own = Vec::new();
    if light.light.ambient != [0.0; 3] {
        let intensity = Factor::Color(I_A, light.light.ambient);
        own.push(Term {
            kind: TermKind::Ambient,
            name: "ambient",
            factors: with_f(ambient_factors(point, intensity)),
            value: terms.ambient.lane(0),
        });
    }
    let why_not = light.unlit().map(why_not);
    if why_not.is_none() {
        own.push(Term {
            kind: TermKind::Diffuse,
            name: "diffuse",
            factors: with_f(diffuse_factors(point, light)),
            value: terms.diffuse.lane(0),
        });
        if let Some(factors) = specular_factors(point, light) {
            own.push(Term {
                kind: TermKind::Specular,
                name: "specular",
                factors: with_f(factors),
                value: terms.specular.lane(0),
            });
        }
    }
    let parts = if why_not.is_none() { part_terms(point, light) } else { Vec::new() };
    LightEntry { light, parts, terms: own, why_not }
}

fn ambient_factors(point: &ShadingPoint<'_>, intensity: Factor) -> Vec<Factor> {
    let Material { k_a, reflection, .. } = point.constants;
    let reflectance = point.reflectance;
    let mut factors =
        vec![intensity, Factor::Number(K_A, *k_a), Factor::Color(O_A, reflectance.ambient.lane(0))];
    if reflectance.occlusion != 1.0 {
        factors.push(Factor::Number(OCCLUSION, reflectance.occlusion));
    }
    if point.openness != 1.0 {
        factors.push(Factor::Number(OPENNESS, point.openness));
    }
    // With an environment, metals have no other ambient light.
    if *reflection == Reflection::Microfacet && point.environment != [0.0; 3] {
        factors.push(Factor::Number(NOT_METAL, 1.0 - reflectance.metallic));
    }
    factors
}

/// The mirrored environment, if it has any light.
fn mirrored_term(point: &ShadingPoint<'_>) -> Option<Term> {
    let diffuse = point.environment_diffuse.unwrap_or_default();
    let value = [0, 1, 2].map(|channel| point.environment[channel] - diffuse[channel]);
    if value == [0.0; 3] || point.mirrors.is_empty() {
        return None;
    }
    let ShadingPoint { constants, reflectance, mirrors, .. } = point;
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
    factors.extend(what_arrives(point));
    let (kind, name) = (TermKind::Environment, "environment");
    Some(Term { kind, name, factors, value })
}

/// The factors of what arrives from all around, unless they are 1.
fn what_arrives(point: &ShadingPoint<'_>) -> impl Iterator<Item = Factor> {
    let factors = [(OCCLUSION, point.reflectance.occlusion), (OPENNESS, point.openness)];
    let is_less = |(_, factor): &(_, f32)| *factor != 1.0;
    factors.into_iter().filter(is_less).map(|(symbol, factor)| Factor::Number(symbol, factor))
}

/// The diffuse reflection of the environment, if it has any light.
fn diffused_term(point: &ShadingPoint<'_>) -> Option<Term> {
    let value = point.environment_diffuse.filter(|value| *value != [0.0; 3])?;
    let ShadingPoint { constants, reflectance, diffused, .. } = point;
    let mut factors =
        vec![Factor::Number(K_D, constants.k_d), Factor::Color(O_D, reflectance.diffuse.lane(0))];
    match (&constants.reflection, diffused) {
        (Reflection::Mixed(_), diffused) => {
            let sum = diffused.iter().fold(Rgb::black(0.0), |sum, (_, terms)| {
                sum + terms.share * terms.irradiance * terms.weight
            });
            factors.push(Factor::Color(MIXED_AROUND, sum.lane(0)));
        }
        (model, [(_, only)]) => factors.extend(of_irradiance(model, only)),
        _ => {}
    }
    factors.extend(what_arrives(point));
    Some(Term { kind: TermKind::Environment, name: "environment, diffuse", factors, value })
}

/// The environment reflected to all sides by each part of a mixture.
fn diffuse_terms(point: &ShadingPoint<'_>) -> Vec<PartTerm> {
    let Reflection::Mixed(_) = point.constants.reflection else { return Vec::new() };
    let part = |(index, terms): &(usize, DiffuseTerms<f32>)| {
        let (model, _) = point.constants.reflection.part(*index);
        let weight = Factor::Number(WEIGHT, terms.weight);
        let term = Term {
            kind: TermKind::Environment,
            name: model.name(),
            factors: [weight].into_iter().chain(of_irradiance(model, terms)).collect(),
            value: (terms.share * terms.irradiance * terms.weight).lane(0),
        };
        PartTerm { of: MIXED_AROUND, term }
    };
    point.diffused.iter().map(part).collect()
}

/// The environment reflected to all sides by one model, without k_d O_d.
fn of_irradiance(model: &Reflection, terms: &DiffuseTerms<f32>) -> Vec<Factor> {
    let share = Factor::Color(NOT_SPLIT_SUM, terms.share.lane(0));
    let irradiance = Factor::Color(E_OF_N, terms.irradiance.lane(0));
    if *model == Reflection::Microfacet { vec![share, irradiance] } else { vec![irradiance] }
}

/// The environment reflected by each part of a mixture.
fn mirror_terms(point: &ShadingPoint<'_>) -> Vec<PartTerm> {
    let Reflection::Mixed(_) = point.constants.reflection else { return Vec::new() };
    let part = |(index, terms): &(usize, MirrorTerms<f32>)| {
        let (model, _) = point.constants.reflection.part(*index);
        let weight = Factor::Number(WEIGHT, terms.weight);
        let term = Term {
            kind: TermKind::Environment,
            name: model.name(),
            factors: [weight].into_iter().chain(mirrored(model, terms)).collect(),
            value: (terms.share * terms.radiance * terms.weight).lane(0),
        };
        PartTerm { of: MIXED_MIRROR, term }
    };
    point.mirrors.iter().map(part).collect()
}

/// The environment reflected by one model, without k_s O_s.
fn mirrored(model: &Reflection, terms: &MirrorTerms<f32>) -> Vec<Factor> {
    let share = Factor::Color(SPLIT_SUM, terms.share.lane(0));
    let radiance = Factor::Color(E_OF_R, terms.radiance.lane(0));
    if *model == Reflection::Microfacet { vec![share, radiance] } else { vec![radiance] }
}

/// The factors that go with I_d: of a mix the sum of its parts, of all others the model's own.
fn diffuse_factors(point: &ShadingPoint<'_>, light: &ExplainedLight) -> Vec<Factor> {
    let intensity = Factor::Color(I_D, light.light.diffuse);
    let share = match (&point.constants.reflection, &light.parts[..]) {
        (Reflection::Mixed(_), parts) => {
            vec![Factor::Color(MIXED_DIFFUSE, mixed(parts, |part| part.diffuse))]
        }
        (model, [(_, part)]) => diffuse_share(point, light, model, part),
        _ => Vec::new(),
    };
    [intensity].into_iter().chain(share).collect()
}

/// The factors that go with I_s; `None` where the model has no highlight.
fn specular_factors(point: &ShadingPoint<'_>, light: &ExplainedLight) -> Option<Vec<Factor>> {
    let intensity = Factor::Color(I_S, light.light.specular);
    let share = match (&point.constants.reflection, &light.parts[..]) {
        (Reflection::Mixed(_), parts) => {
            vec![Factor::Color(MIXED_SPECULAR, mixed(parts, |part| part.specular))]
        }
        (model, [(_, part)]) => specular_share(point, light, model, part)?,
        _ => return None,
    };
    Some([intensity].into_iter().chain(share).collect())
}

/// The weighted sum of the parts of a mix, as the equation adds them up.
fn mixed(parts: &[(usize, PartTerms<f32>)], of: impl Fn(&PartTerms<f32>) -> Rgb<f32>) -> [f32; 3] {
    let sum = parts.iter().fold(Rgb::black(0.0), |sum, (_, part)| sum + of(part) * part.weight);
    sum.lane(0)
}

/// The parts of a mixture: the factors of I_d, then of I_s, of each.
fn part_terms(point: &ShadingPoint<'_>, light: &ExplainedLight) -> Vec<PartTerm> {
    let Reflection::Mixed(_) = point.constants.reflection else { return Vec::new() };
    let model = |index: usize| point.constants.reflection.part(index).0;
    let part_term = |of, kind, index, share: Vec<Factor>, value: Rgb<f32>, weight: f32| {
        let value = (value * weight).lane(0);
        let factors = [Factor::Number(WEIGHT, weight)].into_iter().chain(share).collect();
        let term = Term { kind, name: model(index).name(), factors, value };
        (value != [0.0; 3]).then_some(PartTerm { of, term })
    };
    let diffuse = light.parts.iter().filter_map(|(index, part)| {
        let share = diffuse_share(point, light, model(*index), part);
        part_term(MIXED_DIFFUSE, TermKind::Diffuse, *index, share, part.diffuse, part.weight)
    });
    let specular = light.parts.iter().filter_map(|(index, part)| {
        let share = specular_share(point, light, model(*index), part)?;
        part_term(MIXED_SPECULAR, TermKind::Specular, *index, share, part.specular, part.weight)
    });
    diffuse.chain(specular).collect()
}

/// The factors of I_d of one model.
fn diffuse_share(
    point: &ShadingPoint<'_>,
    light: &ExplainedLight,
    model: &Reflection,
    part: &PartTerms<f32>,
) -> Vec<Factor> {
    let ShadingPoint { constants, reflectance, .. } = point;
    let mut factors =
        vec![Factor::Number(K_D, constants.k_d), Factor::Color(O_D, reflectance.diffuse.lane(0))];
    let model = model.model().map_or(&[][..], |model| model.diffuse);
    factors.extend(model.iter().map(|factor| model_factor(factor, point, light, part)));
    factors
}

/// The factors of I_s of one model; `None` without a highlight.
fn specular_share(
    point: &ShadingPoint<'_>,
    light: &ExplainedLight,
    model: &Reflection,
    part: &PartTerms<f32>,
) -> Option<Vec<Factor>> {
    let ShadingPoint { constants, reflectance, .. } = point;
    let mut factors =
        vec![Factor::Number(K_S, constants.k_s), Factor::Color(O_S, reflectance.specular.lane(0))];
    let model = model.model()?.specular?;
    factors.extend(model.iter().map(|factor| model_factor(factor, point, light, part)));
    Some(factors)
}

/// A factor of a reflection model, with its number.
fn model_factor(
    factor: &ModelFactor,
    point: &ShadingPoint<'_>,
    light: &ExplainedLight,
    part: &PartTerms<f32>,
) -> Factor {
    let ModelFactor { symbol, quantity } = *factor;
    let reflectance = point.reflectance;
    match quantity {
        Quantity::Cosine => Factor::Cosine(symbol, light.terms.n_dot_l),
        Quantity::Power => {
            Factor::Power(symbol, part.specular_cosine.unwrap_or_default(), reflectance.shininess)
        }
        Quantity::NotMetal => Factor::Number(symbol, 1.0 - reflectance.metallic),
        Quantity::Number(_, of) => Factor::Number(symbol, of(&part.lobe)),
        Quantity::Color(_, of) => Factor::Color(symbol, of(&part.lobe)),
    }
}
