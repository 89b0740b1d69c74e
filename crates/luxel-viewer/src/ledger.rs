//! The lighting equation with its numbers filled in, as lines below the bar of terms.

use crate::theme::{self, Theme};
use egui::{Align, Color32, Label, Layout, RichText, Ui, vec2};

/// What a term is; it has the same colour everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TermKind {
    /// Light from everywhere.
    Ambient,
    /// Light reflected to all sides.
    Diffuse,
    /// A highlight.
    Specular,
    /// The surface's own light.
    Emission,
    /// What is mirrored.
    Environment,
    /// Depth cueing.
    Fog,
    /// What terms add up to.
    Sum,
}

/// A line of the equation.
#[derive(Clone, Debug, PartialEq)]
pub enum LedgerLine {
    /// What the lines that follow are about: a corner, a light; with what is known of it.
    About {
        /// Its name.
        name: String,
        /// Facts, one a line.
        facts: Vec<String>,
    },
    /// A term: what it is the product of, the same with numbers, and what comes of it.
    Term {
        /// What it is.
        kind: TermKind,
        /// Its name.
        name: String,
        /// The product in symbols.
        symbols: String,
        /// The product in numbers.
        numbers: String,
        /// Red, green, blue.
        value: [f32; 3],
        /// Whether it is a factor of a term that follows, and no term itself.
        is_part: bool,
    },
    /// Why something adds nothing.
    Nothing(String),
    /// What the terms add up to.
    Sum {
        /// What it is.
        kind: TermKind,
        /// Its name.
        name: String,
        /// Red, green, blue.
        value: [f32; 3],
        /// What became of it.
        note: String,
    },
}

impl TermKind {
    pub(crate) fn color(self, theme: &Theme) -> Color32 {
        match self {
            Self::Ambient => theme.terms[0],
            Self::Diffuse => theme.terms[1],
            Self::Specular => theme.terms[2],
            Self::Emission => theme.terms[3],
            Self::Environment => theme.vectors[2],
            Self::Fog => theme.terms[4],
            Self::Sum => theme.accent,
        }
    }
}

/// Shows the equation.
pub(crate) fn equation(ui: &mut Ui, lines: &[LedgerLine]) {
    let theme = theme::of(ui.ctx());
    for line in lines {
        match line {
            LedgerLine::About { name, facts } => {
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
                    value_row(ui, Some(kind.color(theme)), name, *value);
                }
                let symbols = RichText::new(format!("= {symbols}")).monospace().size(11.0);
                ui.add(Label::new(symbols).wrap());
                quiet(ui, &format!("= {numbers}"));
                ui.spacing_mut().item_spacing.y = 4.0;
            }
            LedgerLine::Nothing(why) => quiet(ui, why),
            LedgerLine::Sum { kind, name, value, note } => {
                ui.add_space(8.0);
                value_row(ui, Some(kind.color(theme)), name, *value);
                if !note.is_empty() {
                    quiet(ui, note);
                }
            }
        }
    }
}

/// Something to be read when it is looked for, as long as it is.
fn quiet(ui: &mut Ui, text: &str) {
    ui.add(Label::new(RichText::new(text).monospace().size(11.0).weak()).wrap());
}

/// A name with its colour before it, and three numbers in columns.
pub(crate) fn value_row(ui: &mut Ui, color: Option<Color32>, name: &str, value: [f32; 3]) {
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

/// A number of about 1 in a column of six.
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
    fn numbers_stand_in_columns_and_small_ones_are_not_0() {
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
