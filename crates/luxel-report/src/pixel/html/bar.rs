//! The terms of a surface as stacked bars, one for each channel, to one scale.

use super::escape::escaped;
use crate::equation::TermKind;
use crate::words::number;
use luxel_lighting::{Display, Tone};
use luxel_render::ExplainedSurface;
use std::fmt::Write;

/// A term that reaches the eye.
struct Part {
    kind: TermKind,
    /// The label, long and short.
    name: String,
    short: &'static str,
    value: [f32; 3],
}

/// The light of a surface, by term and channel.
pub(crate) fn terms(surface: &ExplainedSurface, display: &Display) -> String {
    let parts = parts(surface);
    let sum = |channel: usize| parts.iter().map(|part| part.value[channel].max(0.0)).sum::<f32>();
    let most = sum(0).max(sum(1)).max(sum(2));
    if most <= 0.0 || !most.is_finite() {
        return String::new();
    }
    let percent = |value: f32| value / most * 100.0;
    let mut text = format!("<figure class=\"bar\" aria-label=\"{}\">\n", spoken(&parts));
    for (channel, letter) in ["R", "G", "B"].into_iter().enumerate() {
        let _ = write!(text, "<div class=\"channel\"><b>{letter}</b><div class=\"stack\">");
        for part in &parts {
            let width = percent(part.value[channel].max(0.0));
            if width < 0.01 {
                continue;
            }
            let Part { kind, name, short, value } = part;
            let (class, name) = (kind.name(), escaped(name));
            let _ = write!(
                text,
                "<span class=\"{class}\" style=\"width:{width:.3}%\" title=\"{name}: {}\"><em>{name}\
                 </em><i>{short}</i></span>",
                number(value[channel]),
            );
        }
        text.push_str("</div></div>\n");
    }
    // The scale: its ends, and what the exposure makes white, beyond which a picture has no brighter.
    let white = display.white();
    let _ = write!(text, "<div class=\"channel scale num\"><b></b><div class=\"stack\"><u>0</u>");
    if most > white {
        let _ = write!(text, "<u style=\"left:{:.3}%\">{}</u>", percent(white), number(white));
    }
    let steps = if display.is_identity() { "encoding" } else { "exposure and encoding" };
    let beyond = match display.tone() {
        Tone::None if most > white => format!("; what lies beyond {} is clamped", number(white)),
        _ => String::new(),
    };
    let _ = write!(
        text,
        "<u class=\"most\">{}</u></div></div>\n<figcaption>What reaches the eye, term by term, \
         before {steps}{beyond}.</figcaption></figure>\n",
        number(most)
    );
    text
}

/// The terms, as much of them as fog leaves, and the fog.
fn parts(surface: &ExplainedSurface) -> Vec<Part> {
    let (clear, fog) = surface.fog.unwrap_or((1.0, [0.0; 3]));
    let mut parts = Vec::new();
    let mut add = |kind, name: String, short, value: [f32; 3]| {
        let value = value.map(|channel| channel * clear);
        if value != [0.0; 3] {
            parts.push(Part { kind, name, short, value });
        }
    };
    add(TermKind::Emission, "emission".into(), "emission", surface.emission);
    add(TermKind::Ambient, "ambient".into(), "ambient", surface.scene_ambient);
    for light in &surface.lights {
        let terms = &light.terms;
        let name = &light.name;
        add(TermKind::Ambient, format!("{name}, ambient"), "ambient", terms.ambient.lane(0));
        add(TermKind::Diffuse, format!("{name}, diffuse"), "diffuse", terms.diffuse.lane(0));
        add(TermKind::Specular, format!("{name}, specular"), "specular", terms.specular.lane(0));
    }
    add(TermKind::Environment, "environment".into(), "environment", surface.environment);
    let veil = fog.map(|channel| channel * (1.0 - clear));
    if veil != [0.0; 3] {
        parts.push(Part { kind: TermKind::Fog, name: "fog".into(), short: "fog", value: veil });
    }
    parts
}

/// The bars in words.
fn spoken(parts: &[Part]) -> String {
    let one = |part: &Part| {
        let [r, g, b] = part.value.map(number);
        format!("{} {r}, {g}, {b}", escaped(&part.name))
    };
    let parts: Vec<_> = parts.iter().map(one).collect();
    format!("terms in red, green, blue: {}", parts.join("; "))
}
