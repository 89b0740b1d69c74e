//! The lighting equation with its values, as lines of a panel.

use crate::theme::{self, Theme};
use egui::{Align, Color32, Label, Layout, RichText, Ui, vec2};
use luxel::report::{LedgerLine, TermKind};

/// The colour of a kind of term, the same everywhere.
pub(super) fn term_color(kind: TermKind, theme: &Theme) -> Color32 {
    match kind {
        TermKind::Ambient => theme.terms[0],
        TermKind::Diffuse => theme.terms[1],
        TermKind::Specular => theme.terms[2],
        TermKind::Emission => theme.terms[3],
        TermKind::Environment => theme.vectors[2],
        TermKind::Fog => theme.terms[4],
        _ => theme.accent,
    }
}

/// Relative luminance (ITU-R BT.709).
pub(super) fn luminance([r, g, b]: [f32; 3]) -> f32 {
    0.2126 * r + 0.7152 * g + 0.0722 * b
}

/// Shows the equation.
pub(super) fn equation(ui: &mut Ui, lines: &[LedgerLine]) {
    let theme = theme::of(ui.ctx());
    for line in lines {
        match line {
            LedgerLine::Heading { name, facts } => {
                ui.add_space(8.0);
                ui.label(RichText::new(name).color(theme.heading));
                for fact in facts {
                    quiet(ui, fact);
                }
            }
            LedgerLine::Term { kind, name, symbols, numbers, value, is_part } => {
                ui.add_space(4.0);
                ui.spacing_mut().item_spacing.y = 0.0;
                if *is_part {
                    value_row(ui, None, name, *value);
                } else {
                    value_row(ui, Some(term_color(*kind, theme)), name, *value);
                }
                let symbols = RichText::new(format!("= {symbols}")).monospace().size(11.0);
                ui.add(Label::new(symbols).wrap());
                quiet(ui, &format!("= {numbers}"));
                ui.spacing_mut().item_spacing.y = 4.0;
            }
            LedgerLine::Note(why) => quiet(ui, why),
            LedgerLine::Sum { kind, name, value, note } => {
                ui.add_space(8.0);
                value_row(ui, Some(term_color(*kind, theme)), name, *value);
                if !note.is_empty() {
                    quiet(ui, note);
                }
            }
            _ => {}
        }
    }
}

/// A secondary note, wrapped.
fn quiet(ui: &mut Ui, text: &str) {
    ui.add(Label::new(RichText::new(text).monospace().size(11.0).weak()).wrap());
}

/// A row of a colour swatch, a name and three values in columns.
pub(super) fn value_row(ui: &mut Ui, color: Option<Color32>, name: &str, value: [f32; 3]) {
    let height = std::mem::replace(&mut ui.spacing_mut().interact_size.y, 18.0);
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(8.0, 8.0), egui::Sense::hover());
        if let Some(color) = color {
            ui.painter().rect_filled(rect, 2, color);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let [r, g, b] = value.map(column);
            ui.monospace(format!("{r} {g} {b}"));
            let rest = vec2(ui.available_width(), ui.spacing().interact_size.y);
            ui.allocate_ui_with_layout(rest, Layout::left_to_right(Align::Center), |ui| {
                ui.add(Label::new(name).truncate());
            });
        });
    });
    ui.spacing_mut().interact_size.y = height;
}

/// Formats a value in a column of six characters.
fn column(value: f32) -> String {
    if value == 0.0 || (1e-3..1e2).contains(&value.abs()) {
        format!("{value:6.3}")
    } else if value.abs() < 1e-3 {
        format!("{value:6.0e}")
    } else {
        format!("{value:6.0}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_fit_their_columns_and_small_ones_are_not_0() {
        for (value, text) in [
            (0.0, " 0.000"),
            (0.5, " 0.500"),
            (12.34567, "12.346"),
            (2e-5, "  2e-5"),
            (512.4, "   512"),
        ] {
            assert_eq!(column(value), text);
        }
    }
}
