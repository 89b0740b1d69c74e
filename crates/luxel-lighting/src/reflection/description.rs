//! The description of a reflection model, from which names, lists, sliders and documents derive.

use super::Reflection;
use crate::{Lobe, Parameter};

/// The description of a reflection model, in the file of its formula.
#[derive(Debug)]
pub struct ReflectionModel {
    /// The model, its own parameters at their defaults.
    pub reflection: Reflection,
    /// Its name, on the command line and in scene files.
    pub name: &'static str,
    /// One line of help.
    pub help: &'static str,
    /// The formula of its diffuse and specular term.
    pub formula: &'static str,
    /// Where the formula is from.
    pub source: &'static str,
    /// Those of the parameters shared by all materials that it heeds.
    pub parameters: &'static [&'static Parameter],
    /// Parameters that no other model has: fields of its variant.
    pub own: &'static [OwnParameter],
    /// The vector of its highlight, if it depends on both surface and light.
    pub highlight: Option<HighlightVector>,
    /// The factors of its diffuse term behind k_d O_d, as `explain` writes them.
    pub diffuse: &'static [ModelFactor],
    /// The factors of its specular term behind k_s O_s; `None` where it has no such term.
    pub specular: Option<&'static [ModelFactor]>,
}

/// A parameter that only one model has.
#[derive(Clone, Debug)]
pub struct OwnParameter {
    /// The description.
    pub parameter: Parameter,
    /// The field of the model's variant; `None` in other variants.
    pub field: fn(&mut Reflection) -> Option<&mut f32>,
}

/// The vector of a highlight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HighlightVector {
    /// R = 2 (N.L) N - L
    Reflected,
    /// H = (L + V) / |L + V|
    Halfway,
}

/// One factor of a model's term.
#[derive(Clone, Copy, Debug)]
pub struct ModelFactor {
    /// How the equation writes it.
    pub symbol: Symbol,
    /// The quantity that it stands for.
    pub quantity: Quantity,
}

/// The kind of a factor.
#[derive(Clone, Copy, Debug)]
pub enum Quantity {
    /// max(N.L, 0)
    Cosine,
    /// max(c, 0)^n, c the cosine of the highlight.
    Power,
    /// 1 - metallic
    NotMetal,
    /// A number that the model computes, with its key in JSON.
    Number(&'static str, fn(&Lobe<f32>) -> f32),
    /// A colour that the model computes, with its key in JSON, unless another factor has it.
    Color(Option<&'static str>, fn(&Lobe<f32>) -> [f32; 3]),
}

/// A symbol of the equation, for each format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Symbol {
    /// For plain text.
    pub text: &'static str,
    /// For LaTeX.
    pub latex: &'static str,
    /// For HTML.
    pub html: &'static str,
    /// What it means: one line that begins with the symbol as plain text.
    pub meaning: &'static str,
}

impl Symbol {
    /// A symbol as plain text, LaTeX and HTML, and what it means.
    #[must_use]
    pub const fn new(
        text: &'static str,
        latex: &'static str,
        html: &'static str,
        meaning: &'static str,
    ) -> Self {
        Self { text, latex, html, meaning }
    }
}

/// max(N.L, 0)
pub(super) const COSINE: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "N.L",
        r"\mathbf N\cdot\mathbf L",
        "<b>N</b>·<b>L</b>",
        "N.L: the cosine of the angle between the normal and the direction to the light",
    ),
    quantity: Quantity::Cosine,
};

/// 1 - metallic
pub const NOT_METAL: ModelFactor = ModelFactor {
    symbol: Symbol::new(
        "(1 - metallic)",
        r"(1 - \mathrm{metallic})",
        "(1 − metallic)",
        "1 - metallic: the share of the surface that is no metal, which alone reflects diffusely",
    ),
    quantity: Quantity::NotMetal,
};
