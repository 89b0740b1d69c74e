//! The vocabulary of the lighting equation: factors, terms.

use luxel_lighting::Symbol;

/// The kind of a term; formats give each kind a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum TermKind {
    /// Light from everywhere: f I_a k_a O_a.
    Ambient,
    /// Light reflected to all sides: f I_d k_d O_d max(N.L, 0).
    Diffuse,
    /// A highlight: f I_s k_s O_s max(N.H, 0)^n, or the term that replaces it in other models.
    Specular,
    /// The surface's own light.
    Emission,
    /// The environment's mirror image.
    Environment,
    /// Depth cueing.
    Fog,
    /// A sum of terms.
    Sum,
}

impl TermKind {
    /// Its name, which is also its class in pages.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Specular => "specular",
            Self::Emission => "emission",
            Self::Environment => "environment",
            Self::Fog => "fog",
            Self::Sum => "sum",
        }
    }
}

/// One factor of a product.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Factor {
    /// A number.
    Number(Symbol, f32),
    /// A colour.
    Color(Symbol, [f32; 3]),
    /// The larger of a cosine and 0.
    Cosine(Symbol, f32),
    /// The larger of a cosine and 0, to the power n.
    Power(Symbol, f32, f32),
}

/// One term: a product and its value.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    pub(crate) kind: TermKind,
    pub(crate) name: &'static str,
    pub(crate) factors: Vec<Factor>,
    /// Linear red, green, blue.
    pub(crate) value: [f32; 3],
}

/// One term of a sum that is itself a factor: a part of a mix of reflection models.
#[derive(Clone, Debug)]
pub(crate) struct PartTerm {
    /// The sum.
    pub(crate) of: Symbol,
    pub(crate) term: Term,
}

impl Factor {
    pub(crate) fn symbol(&self) -> Symbol {
        match *self {
            Self::Number(symbol, _)
            | Self::Color(symbol, _)
            | Self::Cosine(symbol, _)
            | Self::Power(symbol, ..) => symbol,
        }
    }
}
