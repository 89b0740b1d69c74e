//! The symbols of the lighting equation, for each format.

use super::term::Symbol;

const fn symbol(text: &'static str, latex: &'static str, html: &'static str) -> Symbol {
    Symbol { text, latex, html }
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
pub(crate) const NOT_METAL: Symbol =
    symbol("(1 - metallic)", r"(1 - \mathrm{metallic})", "(1 − metallic)");
pub(crate) const N_DOT_L: Symbol = symbol("N.L", r"\mathbf N\cdot\mathbf L", "<b>N</b>·<b>L</b>");
pub(crate) const R_DOT_V: Symbol = symbol("R.V", r"\mathbf R\cdot\mathbf V", "<b>R</b>·<b>V</b>");
pub(crate) const N_DOT_H: Symbol = symbol("N.H", r"\mathbf N\cdot\mathbf H", "<b>N</b>·<b>H</b>");
pub(crate) const V_DOT_L: Symbol = symbol("V.L", r"\mathbf V\cdot\mathbf L", "<b>V</b>·<b>L</b>");
pub(crate) const ROUGH: Symbol = symbol(
    "(A + B max(q, 0) / max(N.L, N.V))",
    r"\Bigl(A + B\,\tfrac{\max(q, 0)}{\max(\mathbf N\cdot\mathbf L,\,\mathbf N\cdot\mathbf V)}\Bigr)",
    "(A + B max(q, 0) / max(<b>N</b>·<b>L</b>, <b>N</b>·<b>V</b>))",
);
pub(crate) const NOT_MIRRORED: Symbol = symbol("(1 - F)", "(1 - F)", "(1 − F)");
pub(crate) const PI_D: Symbol = symbol("pi D", r"\pi D", "π D");
pub(crate) const VISIBILITY: Symbol = symbol("V", "V", "V");
pub(crate) const FRESNEL: Symbol = symbol("F", "F", "F");
pub(crate) const WEIGHT: Symbol = symbol("w", "w", "<i>w</i>");
pub(crate) const MIXED_DIFFUSE: Symbol = symbol("rho_d", r"\rho_d", "ρ<sub>d</sub>");
pub(crate) const MIXED_SPECULAR: Symbol = symbol("rho_s", r"\rho_s", "ρ<sub>s</sub>");
pub(crate) const MIXED_MIRROR: Symbol = symbol("rho_e", r"\rho_e", "ρ<sub>e</sub>");
pub(crate) const E_OF_R: Symbol = symbol("E(R)", r"E(\mathbf R)", "E(<b>R</b>)");
pub(crate) const SPLIT_SUM: Symbol = symbol("(F0 A + B)", "(F_0 A + B)", "(F<sub>0</sub> A + B)");
