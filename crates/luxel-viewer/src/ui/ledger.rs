//! The lighting equation with its values, as lines of a panel.

use crate::number::number;
use crate::theme::{self, Theme};
use crate::ui::symbols;
use egui::{Align, Color32, FontId, Layout, RichText, TextStyle, Ui, vec2};
use luxel::report::{LedgerFactor, LedgerLine, TermKind};

/// The type size of symbols and notes.
const NOTE_SIZE: f32 = 11.0;

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
            LedgerLine::Term { kind, name, factors, value, is_part } => {
                ui.add_space(4.0);
                ui.spacing_mut().item_spacing.y = 0.0;
                if *is_part {
                    value_row(ui, None, name, *value);
                } else {
                    value_row(ui, Some(term_color(*kind, theme)), name, *value);
                }
                product(ui, factors);
                let numbers: Vec<_> = factors.iter().map(|one| one.number.as_str()).collect();
                quiet(ui, &format!("= {}", numbers.join(" x ")));
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

/// A product in symbols, each with its meaning as tooltip.
fn product(ui: &mut Ui, factors: &[LedgerFactor]) {
    let (font, color) = (FontId::monospace(NOTE_SIZE), theme::of(ui.ctx()).text);
    // No taller than its text.
    let height = std::mem::replace(&mut ui.spacing_mut().interact_size.y, 0.0);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.label(symbols::layout("=", &font, color));
        for factor in factors {
            let label = ui.label(symbols::layout(&factor.symbol, &font, color));
            symbols::with_meanings(label, &[factor.meaning]);
        }
    });
    ui.spacing_mut().interact_size.y = height;
}

/// A secondary note, wrapped.
fn quiet(ui: &mut Ui, text: &str) {
    let color = ui.visuals().weak_text_color();
    symbols::label(ui, text, &FontId::monospace(NOTE_SIZE), color);
}

/// A row of a colour swatch, a name and three values in columns.
pub(super) fn value_row(ui: &mut Ui, color: Option<Color32>, name: &str, value: [f32; 3]) {
    let height = std::mem::replace(&mut ui.spacing_mut().interact_size.y, 18.0);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let (rect, _) = ui.allocate_exact_size(vec2(8.0, 8.0), egui::Sense::hover());
        if let Some(color) = color {
            ui.painter().rect_filled(rect, 2, color);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let [r, g, b] = value.map(|part| number(f64::from(part)));
            let numbers = RichText::new(format!("{r:>7} {g:>7} {b:>7}"));
            ui.label(numbers.monospace().size(NOTE_SIZE));
            let rest = vec2(ui.available_width(), ui.spacing().interact_size.y);
            ui.allocate_ui_with_layout(rest, Layout::left_to_right(Align::Center), |ui| {
                let font = TextStyle::Body.resolve(ui.style());
                symbols::label(ui, name, &font, theme::of(ui.ctx()).text);
            });
        });
    });
    ui.spacing_mut().interact_size.y = height;
}
