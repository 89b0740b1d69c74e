//! Symbols of the lighting equation with lowered and raised letters, and their meanings as tooltips.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId, Response, Ui};
use luxel::report::meanings_in;

/// The size of lowered and raised letters, as a part of the font's.
const SMALL: f32 = 0.72;
/// The heights of their lines, as parts of the font's size. Lines are aligned at the bottom, so a low
/// one lowers its letters by a fifth of the font's size, and a high one raises them by a third.
const LOWERED: f32 = 0.70;
const RAISED: f32 = 1.25;

/// A text in which letters behind `_` are lowered, those behind `^` raised.
pub(crate) fn layout(text: &str, font: &FontId, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    let plain = TextFormat { font_id: font.clone(), color, ..TextFormat::default() };
    let mut rest = text;
    while let Some((at, is_lowered)) = next_shifted(rest) {
        job.append(&greek(&rest[..at]), 0.0, plain.clone());
        let shifted = &rest[at + 1..];
        let end = shifted.find(|letter: char| !letter.is_alphanumeric()).unwrap_or(shifted.len());
        job.append(&shifted[..end], 0.0, shifted_format(font, color, is_lowered));
        rest = &shifted[end..];
    }
    job.append(&greek(rest), 0.0, plain);
    job
}

/// The next `_` or `^` between letters or digits, and whether it lowers.
fn next_shifted(text: &str) -> Option<(usize, bool)> {
    let marks = text.char_indices().filter(|(_, letter)| matches!(letter, '_' | '^'));
    let is_shift = |at: usize| {
        let (before, behind) = (&text[..at], &text[at + 1..]);
        before.ends_with(|letter: char| letter.is_alphanumeric() || letter == ')')
            && behind.starts_with(char::is_alphanumeric)
    };
    marks.filter(|(at, _)| is_shift(*at)).map(|(at, mark)| (at, mark == '_')).next()
}

/// Greek letters that plain text spells out.
fn greek(text: &str) -> String {
    let text =
        text.strip_suffix("rho").map_or_else(|| text.to_owned(), |text| format!("{text}\u{3c1}"));
    if text == "pi D" { "\u{3c0} D".to_owned() } else { text }
}

fn shifted_format(font: &FontId, color: Color32, is_lowered: bool) -> TextFormat {
    let FontId { size, family } = font.clone();
    let font_id = FontId::new(size * SMALL, family);
    let line_height = Some(size * if is_lowered { LOWERED } else { RAISED });
    TextFormat { font_id, color, line_height, valign: Align::BOTTOM, ..TextFormat::default() }
}

/// Explains the symbols of a text in the tooltip of its label.
pub(crate) fn explained(response: Response, text: &str) -> Response {
    with_meanings(response, &meanings_in(text))
}

/// Adds a tooltip of meanings, if there are any.
pub(crate) fn with_meanings(response: Response, meanings: &[&str]) -> Response {
    if meanings.is_empty() {
        return response;
    }
    response.on_hover_ui(|ui| {
        for meaning in meanings {
            let font = egui::TextStyle::Body.resolve(ui.style());
            ui.label(layout(meaning, &font, Color32::PLACEHOLDER));
        }
    })
}

/// A label that explains its symbols.
pub(crate) fn label(ui: &mut Ui, text: &str, font: &FontId, color: Color32) -> Response {
    let response = ui.add(egui::Label::new(layout(text, font, color)).wrap());
    explained(response, text)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(text: &str) -> Vec<(String, f32, Option<f32>)> {
        let job = layout(text, &FontId::proportional(10.0), Color32::WHITE);
        let part = |section: &egui::text::LayoutSection| {
            let format = &section.format;
            (
                job.text[section.byte_range.clone()].to_owned(),
                format.font_id.size,
                format.line_height,
            )
        };
        job.sections.iter().map(part).filter(|(text, ..)| !text.is_empty()).collect()
    }

    #[test]
    fn symbols_are_shown_with_lowered_letters_and_powers_with_raised_ones() {
        let shifted = |height: f32| (10.0 * SMALL, Some(10.0 * height));
        let [whole, low, high] = [(10.0, None), shifted(LOWERED), shifted(RAISED)];
        for (text, expected) in [
            ("I_d", &[("I", whole), ("d", low)][..]),
            ("s I_dc", &[("s I", whole), ("dc", low)]),
            ("max(N.L, 0)^n x", &[("max(N.L, 0)", whole), ("n", high), (" x", whole)]),
            ("rho_d", &[("\u{3c1}", whole), ("d", low)]),
            ("_a b_ ^", &[("_a b_ ^", whole)]),
        ] {
            let expected: Vec<_> = expected
                .iter()
                .map(|(part, (size, align))| ((*part).to_owned(), *size, *align))
                .collect();
            assert_eq!(parts(text), expected, "{text}");
        }
    }
}
