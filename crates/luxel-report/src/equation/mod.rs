//! The lighting equation of one point: its terms as products of factors, which every format writes.

mod ground;
mod light;
mod plain;
mod point;
mod products;
mod symbols;
mod term;

pub(crate) use ground::ground_facts;
pub(crate) use light::{highlight_vector, in_the_way, reach, why_not};
pub(crate) use plain::{clamp_range, display_text, factor_text, interpolation_text, symbol_text};
pub(crate) use point::{Interpolation, ShadingPoint, shading_points};
pub(crate) use products::{LightEntry, point_terms};
pub use symbols::meanings_in;
pub use term::TermKind;
pub(crate) use term::{Factor, PartTerm, Term};
