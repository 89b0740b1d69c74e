//! Factors and sums as plain text.

use super::term::Factor;
use crate::words::{color, number};
use luxel_lighting::{Display, Tone};

/// The weighted sum of interpolated light.
pub(crate) fn interpolation_text(parts: &[(f32, [f32; 3])], texture: Option<[f32; 3]>) -> String {
    let parts: Vec<_> = parts
        .iter()
        .map(|(weight, light)| format!("{} x {}", number(*weight), color(*light)))
        .collect();
    match texture {
        Some(texture) => format!("({}) x texture {}", parts.join(" + "), color(texture)),
        None => parts.join(" + "),
    }
}

/// The range that the intensity of a point was clamped to: up to what the exposure makes white.
pub(crate) fn clamp_range(sum: [f32; 3], light: [f32; 3]) -> String {
    let cut = (0..3).find(|&at| sum[at] > light[at]);
    format!("0..{}", number(cut.map_or(1.0, |at| light[at])))
}

/// How what is shown comes from the light: `2^-3 I = 0.125 I, then the tone curve neutral`; `None` if it is
/// the light.
pub(crate) fn display_text(display: &Display, light: &str) -> Option<String> {
    let factor = display.factor();
    let mut steps = Vec::new();
    if factor != 1.0 {
        steps.push(format!("2^{} {light} = {} {light}", number(display.ev()), number(factor)));
    }
    if display.tone() != Tone::None {
        steps.push(format!("the tone curve {}", display.tone().name()));
    }
    (!steps.is_empty()).then(|| steps.join(", then "))
}

/// A factor as its symbol.
pub(crate) fn symbol_text(factor: &Factor) -> String {
    let text = factor.symbol().text;
    match factor {
        Factor::Cosine(..) => format!("max({text}, 0)"),
        Factor::Power(..) => format!("max({text}, 0)^n"),
        _ => text.to_owned(),
    }
}

/// A factor as its number.
pub(crate) fn factor_text(factor: &Factor) -> String {
    match factor {
        Factor::Number(_, value) => number(*value),
        Factor::Color(_, value) => color(*value),
        Factor::Cosine(_, value) => number(value.max(0.0)),
        Factor::Power(_, value, n) => format!("{}^{}", number(value.max(0.0)), number(*n)),
    }
}
