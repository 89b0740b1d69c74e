//! The vectors of the lighting equation at an explained surface, for a drawing.

use super::sums::luminance;
use luxel_render::{ExplainedLight, ExplainedSurface};

/// What a vector is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VectorKind {
    /// N, the normal.
    Normal,
    /// V, to the eye.
    View,
    /// L, to a light.
    ToLight,
    /// R or H, by which the highlight goes.
    Highlight,
}

/// A unit vector at the surface, in world space.
#[derive(Clone, Debug, PartialEq)]
pub struct LedgerVector {
    /// What it is.
    pub kind: VectorKind,
    /// `N`, `V`, `L`, `R` or `H`.
    pub name: &'static str,
    /// The vector.
    pub vector: [f32; 3],
    /// The cosine that the equation takes of it: N.V, N.L, R.V or N.H. None of N.
    pub cosine: Option<f32>,
    /// The light's name, if it is of one.
    pub light: Option<String>,
}

/// N, V, the L of each light that contributes, and R or H of the one with the strongest highlight: one for each
/// light would hide the rest. N comes last, to be drawn over the others.
#[must_use]
pub fn ledger_vectors(surface: &ExplainedSurface) -> Vec<LedgerVector> {
    let n_dot_v = surface.normal.iter().zip(surface.view).map(|(a, b)| a * b).sum();
    let mut vectors = vec![LedgerVector {
        kind: VectorKind::View,
        name: "V",
        vector: surface.view,
        cosine: Some(n_dot_v),
        light: None,
    }];
    let lit = || surface.lights.iter().filter(|light| light.unlit().is_none());
    vectors.extend(lit().map(|light| LedgerVector {
        kind: VectorKind::ToLight,
        name: "L",
        vector: light.terms.to_light.lane(0),
        cosine: Some(light.terms.n_dot_l),
        light: Some(light.name.clone()),
    }));
    let strength = |light: &&ExplainedLight| luminance(light.terms.specular.lane(0));
    let strongest = lit().max_by(|a, b| strength(a).total_cmp(&strength(b)));
    if let Some(light) = strongest.filter(|light| strength(light) > 0.0)
        && let Some(cosine) = light.terms.specular_cosine
        && let Some((name, vector)) =
            light.highlight(&surface.material.constants.reflection, surface.normal, surface.view)
    {
        let kind = VectorKind::Highlight;
        let light = Some(light.name.clone());
        vectors.push(LedgerVector { kind, name, vector, cosine: Some(cosine), light });
    }
    let vector = surface.normal;
    vectors.push(LedgerVector {
        kind: VectorKind::Normal,
        name: "N",
        vector,
        cosine: None,
        light: None,
    });
    vectors
}
