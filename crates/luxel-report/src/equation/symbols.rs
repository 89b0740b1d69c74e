//! The symbols of the lighting equation, for each format, with their meanings. Those of reflection models
//! are in their descriptions.

use luxel_lighting::{REFLECTION_MODELS, Symbol, parameters};

const fn symbol(
    text: &'static str,
    latex: &'static str,
    html: &'static str,
    meaning: &'static str,
) -> Symbol {
    Symbol::new(text, latex, html, meaning)
}

pub(crate) const F: Symbol =
    symbol("f", "f", "<i>f</i>", "f: attenuation by distance, times the cone of a spot light");
pub(crate) const VISIBILITY: Symbol = symbol(
    "Vis",
    r"\mathit{Vis}",
    "<i>Vis</i>",
    "Vis: the part of the light that nothing stands in the way of",
);
pub(crate) const I_A: Symbol =
    symbol("I_a", "I_a", "<i>I</i><sub>a</sub>", "I_a: the intensity of ambient light");
pub(crate) const I_D: Symbol = symbol(
    "I_d",
    "I_d",
    "<i>I</i><sub>d</sub>",
    "I_d: the light's intensity where it is reflected diffusely",
);
pub(crate) const I_S: Symbol = symbol(
    "I_s",
    "I_s",
    "<i>I</i><sub>s</sub>",
    "I_s: the light's intensity where it is reflected in the highlight",
);
pub(crate) const K_A: Symbol =
    symbol("k_a", "k_a", "<i>k</i><sub>a</sub>", luxel_lighting::K_A.help);
pub(crate) const K_D: Symbol =
    symbol("k_d", "k_d", "<i>k</i><sub>d</sub>", luxel_lighting::K_D.help);
pub(crate) const K_S: Symbol =
    symbol("k_s", "k_s", "<i>k</i><sub>s</sub>", luxel_lighting::K_S.help);
pub(crate) const O_A: Symbol = symbol(
    "O_a",
    "O_a",
    "<i>O</i><sub>a</sub>",
    "O_a: the surface's ambient colour; O_d unless the material has its own",
);
pub(crate) const O_D: Symbol =
    symbol("O_d", "O_d", "<i>O</i><sub>d</sub>", "O_d: the surface's diffuse colour");
pub(crate) const O_E: Symbol =
    symbol("O_e", "O_e", "<i>O</i><sub>e</sub>", "O_e: the light that the surface emits");
pub(crate) const O_S: Symbol =
    symbol("O_s", "O_s", "<i>O</i><sub>s</sub>", "O_s: the colour of the surface's highlights");
pub(crate) const OCCLUSION: Symbol = symbol(
    "occlusion",
    r"\mathrm{occlusion}",
    "occlusion",
    "occlusion: how much ambient light reaches the surface",
);
pub(crate) const OPENNESS: Symbol = symbol(
    "openness",
    r"\mathrm{openness}",
    "openness",
    "openness: the part of the directions above the surface in which nothing is near",
);
pub(crate) const NOT_METAL: Symbol = luxel_lighting::NOT_METAL.symbol;
pub(crate) const WEIGHT: Symbol =
    symbol("w", "w", "<i>w</i>", "w: the weight of a model in a mix of reflection models");
pub(crate) const MIXED_DIFFUSE: Symbol = symbol(
    "rho_d",
    r"\rho_d",
    "ρ<sub>d</sub>",
    "rho_d: diffuse reflection, the sum of the mixed models",
);
pub(crate) const MIXED_SPECULAR: Symbol = symbol(
    "rho_s",
    r"\rho_s",
    "ρ<sub>s</sub>",
    "rho_s: reflection in the highlight, the sum of the mixed models",
);
pub(crate) const MIXED_MIRROR: Symbol = symbol(
    "rho_e",
    r"\rho_e",
    "ρ<sub>e</sub>",
    "rho_e: the mirrored environment, the sum of the mixed models",
);
pub(crate) const MIXED_AROUND: Symbol = symbol(
    "rho_a",
    r"\rho_a",
    "ρ<sub>a</sub>",
    "rho_a: diffuse reflection of the environment, the sum of the mixed models",
);
pub(crate) const E_OF_N: Symbol = symbol(
    "E_d(N)",
    r"E_d(\mathbf N)",
    "E<sub>d</sub>(<b>N</b>)",
    "E_d(N): the environment's light on a surface that faces N, its irradiance over pi",
);
pub(crate) const NOT_SPLIT_SUM: Symbol = symbol(
    "(1 - metallic) (1 - F0 A - B)",
    r"(1 - \mathrm{metallic}) (1 - F_0 A - B)",
    "(1 − metallic) (1 − F<sub>0</sub> A − B)",
    "1 - F0 A - B: the share of the environment that the surface doesn't mirror",
);
pub(crate) const E_OF_R: Symbol = symbol(
    "E(R)",
    r"E(\mathbf R)",
    "E(<b>R</b>)",
    "E(R): the environment in the mirrored direction to the eye",
);
pub(crate) const SPLIT_SUM: Symbol = symbol(
    "(F0 A + B)",
    "(F_0 A + B)",
    "(F<sub>0</sub> A + B)",
    "F0 A + B: the share of the environment that the surface mirrors, by its roughness and angle",
);

/// The symbols above, those that name lights and surfaces, and those of fog and attenuation.
const TABLE: [Symbol; 30] = [
    symbol("N", r"\mathbf N", "<b>N</b>", "N: the normal, the direction that the surface faces"),
    symbol("L", r"\mathbf L", "<b>L</b>", "L: the direction to the light"),
    symbol("V", r"\mathbf V", "<b>V</b>", "V: the direction to the eye"),
    symbol("R", r"\mathbf R", "<b>R</b>", "R: L mirrored at N"),
    symbol("H", r"\mathbf H", "<b>H</b>", "H: the direction halfway between L and V"),
    F,
    VISIBILITY,
    I_A,
    I_D,
    I_S,
    O_A,
    O_D,
    O_E,
    O_S,
    OCCLUSION,
    OPENNESS,
    WEIGHT,
    MIXED_DIFFUSE,
    MIXED_SPECULAR,
    MIXED_MIRROR,
    MIXED_AROUND,
    symbol("I", "I", "<i>I</i>", "I: the light that reaches the eye, the sum of all terms"),
    symbol("I_dc", "I_{dc}", "<i>I</i><sub>dc</sub>", "I_dc: the colour of the fog"),
    symbol("s", "s", "<i>s</i>", "s: the share of I that the fog lets through"),
    symbol("d", "d", "<i>d</i>", "d: the distance to the light"),
    symbol("c_1", "c_1", "<i>c</i><sub>1</sub>", "c_1: the constant part of 1 / attenuation"),
    symbol(
        "c_2",
        "c_2",
        "<i>c</i><sub>2</sub>",
        "c_2: the part of 1 / attenuation that grows with d",
    ),
    symbol(
        "c_3",
        "c_3",
        "<i>c</i><sub>3</sub>",
        "c_3: the part of 1 / attenuation that grows with d^2",
    ),
    symbol(
        "E_d",
        "E_d",
        "<i>E</i><sub>d</sub>",
        "E_d: the environment's light on a matt surface, its irradiance over pi",
    ),
    symbol("E", "E", "<i>E</i>", "E: the environment"),
];

/// The meanings of the symbols in a text, each a line that begins with its symbol, in the order of the
/// text.
#[must_use]
pub fn meanings_in(text: &str) -> Vec<&'static str> {
    let is_part = |letter: char| letter.is_alphanumeric() || matches!(letter, '_' | '.');
    let words = text.split(|letter: char| !is_part(letter));
    let mut found = Vec::new();
    for word in words.map(|word| word.trim_matches('.')) {
        found.extend(meaning(word).filter(|meaning| !found.contains(meaning)));
    }
    found
}

/// The meaning of a symbol.
fn meaning(text: &str) -> Option<&'static str> {
    let of_models = REFLECTION_MODELS.iter().flat_map(|model| {
        model.diffuse.iter().chain(model.specular.into_iter().flatten()).map(|factor| factor.symbol)
    });
    let of_table = TABLE.into_iter().chain(of_models).find(|symbol| symbol.text == text);
    let of_parameters = || parameters().find(|parameter| parameter.symbol == text);
    of_table.map(|symbol| symbol.meaning).or_else(|| Some(of_parameters()?.help))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meanings_begin_with_their_symbol_and_none_is_there_twice() {
        for (at, symbol) in TABLE.iter().enumerate() {
            assert!(symbol.meaning.starts_with(&format!("{}: ", symbol.text)), "{symbol:?}");
            assert!(TABLE[..at].iter().all(|other| other.text != symbol.text), "{symbol:?}");
        }
        for model in REFLECTION_MODELS {
            for factor in model.diffuse.iter().chain(model.specular.into_iter().flatten()) {
                let Symbol { text, meaning, .. } = factor.symbol;
                let bare = text.strip_prefix('(').and_then(|text| text.strip_suffix(')'));
                assert!(meaning.starts_with(bare.unwrap_or(text)), "{text}: {meaning}");
            }
        }
        for symbol in [K_A, K_D, K_S] {
            assert!(symbol.meaning.starts_with(symbol.text), "{symbol:?}");
        }
    }

    #[test]
    fn symbols_are_found_in_a_text_and_words_are_none() {
        assert_eq!(meanings_in("scene I_a"), [I_A.meaning]);
        let found = meanings_in("d = 3, attenuation 1 / (c_1 + c_2 d + c_3 d^2) = 0.1");
        let symbols: Vec<_> = found.iter().map(|one| one.split(':').next().unwrap()).collect();
        assert_eq!(symbols, ["d", "c_1", "c_2", "c_3"]);
        let found =
            meanings_in("it stands behind the surface, or in its plane: N.L is not above 0.");
        assert_eq!(found.len(), 1);
        assert!(found[0].starts_with("N.L: the cosine"));
        assert_eq!(meanings_in("k_d"), [luxel_lighting::K_D.help]);
        assert!(meanings_in("emission, opacity 1 - 2").is_empty());
    }
}
