//! Factors and sums as plain text.

use super::term::Factor;
use crate::words::{color, number};

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
