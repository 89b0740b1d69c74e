//! The symbols of the lighting equation, for each format. Those of reflection models are in their
//! descriptions.

use luxel_lighting::Symbol;

const fn symbol(text: &'static str, latex: &'static str, html: &'static str) -> Symbol {
    Symbol::new(text, latex, html)
}

pub(crate) const F: Symbol = symbol("f", "f", "<i>f</i>");
pub(crate) const I_A: Symbol = symbol("I_a", "I_a", "<i>I</i><sub>a</sub>");
pub(crate) const I_D: Symbol = symbol("I_d", "I_d", "<i>I</i><sub>d</sub>");
pub(crate) const I_S: Symbol = symbol("I_s", "I_s", "<i>I</i><sub>s</sub>");
pub(crate) const K_A: Symbol = symbol("k_a", "k_a", "<i>k</i><sub>a</sub>");
pub(crate) const K_D: Symbol = symbol("k_d", "k_d", "<i>k</i><sub>d</sub>");
pub(crate) const K_S: Symbol = symbol("k_s", "k_s", "<i>k</i><sub>s</sub>");
pub(crate) const O_A: Symbol = symbol("O_a", "O_a", "<i>O</i><sub>a</sub>");
pub(crate) const O_D: Symbol = symbol("O_d", "O_d", "<i>O</i><sub>d</sub>");
pub(crate) const O_E: Symbol = symbol("O_e", "O_e", "<i>O</i><sub>e</sub>");
pub(crate) const O_S: Symbol = symbol("O_s", "O_s", "<i>O</i><sub>s</sub>");
pub(crate) const OCCLUSION: Symbol = symbol("occlusion", r"\mathrm{occlusion}", "occlusion");
pub(crate) const NOT_METAL: Symbol = luxel_lighting::NOT_METAL.symbol;
pub(crate) const WEIGHT: Symbol = symbol("w", "w", "<i>w</i>");
pub(crate) const MIXED_DIFFUSE: Symbol = symbol("rho_d", r"\rho_d", "ρ<sub>d</sub>");
pub(crate) const MIXED_SPECULAR: Symbol = symbol("rho_s", r"\rho_s", "ρ<sub>s</sub>");
pub(crate) const MIXED_MIRROR: Symbol = symbol("rho_e", r"\rho_e", "ρ<sub>e</sub>");
pub(crate) const E_OF_R: Symbol = symbol("E(R)", r"E(\mathbf R)", "E(<b>R</b>)");
pub(crate) const SPLIT_SUM: Symbol = symbol("(F0 A + B)", "(F_0 A + B)", "(F<sub>0</sub> A + B)");
