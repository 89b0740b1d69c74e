//! The explanation of the pixel under the pointer: its lighting terms, the equation with its values, and
//! hidden surfaces.

use crate::number::{number, percent};
use crate::render::ExplainedPixel;
use crate::session::Session;
use crate::theme;
use crate::ui::ledger::{self, term_color, value_row};
use egui::{Color32, RichText, pos2, vec2};
use luxel::render::{Hidden, NEAREST_WITHIN, Seen, SurfaceBelow, Unseen};
use luxel::report::{Hint, LedgerLine, TermKind, luminance, term_sums};

/// The explanation of a pixel.
pub(super) fn explanation(
    ui: &mut egui::Ui,
    session: &Session,
    explained: Option<&ExplainedPixel>,
    equation: Option<&[LedgerLine]>,
) {
    let Some(explained) = explained else {
        ui.label(RichText::new("Point at something.").weak());
        return;
    };
    let ExplainedPixel { explanation, unseen } = explained;
    let [r, g, b, _] = explanation.rgba8;
    ui.horizontal(|ui| {
        let (rect, _) = ui.allocate_exact_size(vec2(24.0, 24.0), egui::Sense::hover());
        ui.painter().rect_filled(rect, 4, Color32::from_rgb(r, g, b));
        let [x, y] = explanation.pixel;
        ui.monospace(format!("{r:3} {g:3} {b:3}"));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.label(RichText::new(format!("pixel {x}, {y}")).small().weak());
        });
    });
    let dominant_sample = explained.dominant_sample();
    let hidden = dominant_sample.and_then(|(at, _)| unseen.entries.get(at));
    let surface = explained.surface();
    let (Some((_, sample)), Some(surface)) = (dominant_sample, surface) else {
        ui.label(RichText::new("nothing covers this pixel").weak());
        note(ui, &nearest(unseen, session));
        hidden_surfaces(ui, session, hidden);
        return;
    };
    let what = match surface.triangle {
        Some(triangle) => format!("{}, triangle {triangle}", surface.name),
        None => surface.name.clone(),
    };
    ui.label(what);
    if sample.weight < 1.0 {
        let share = format!("{} of the pixel's samples", percent(f64::from(sample.weight)));
        ui.label(RichText::new(share).small().weak());
    }
    ui.add_space(8.0);
    let theme = theme::of(ui.ctx());
    let terms = term_sums(surface);
    bar(ui, &terms);
    ui.add_space(4.0);
    ui.spacing_mut().item_spacing.y = 2.0;
    for (kind, value) in &terms {
        if *value != [0.0; 3] {
            value_row(ui, Some(term_color(*kind, theme)), kind.name(), *value);
        }
    }
    value_row(ui, Some(theme.accent), "sum", surface.sum);
    ui.spacing_mut().item_spacing.y = 4.0;
    if let Some(lines) = equation {
        ui.add_space(8.0);
        ui.label(RichText::new("The equation here").color(theme.heading));
        ledger::equation(ui, lines);
    }
    if sample.seen.len() > 1 {
        ui.add_space(8.0);
        ui.label(RichText::new("Seen through it").color(theme.heading));
        for below in &sample.seen[1..] {
            note(
                ui,
                &match below {
                    Seen::Surface(below) => {
                        format!("{}, alpha {}", below.name, number(f64::from(below.alpha)))
                    }
                    Seen::Background { .. } => "the background".to_owned(),
                },
            );
        }
    }
    hidden_surfaces(ui, session, hidden);
}

/// A secondary sentence, wrapped.
fn note(ui: &mut egui::Ui, text: &str) {
    ui.add(egui::Label::new(RichText::new(text).small().weak()).wrap());
}

/// The most surfaces behind the visible one that are listed.
const MAX_BEHIND: usize = 5;

/// The hidden surfaces at a pixel, and why they are hidden.
fn hidden_surfaces(ui: &mut egui::Ui, session: &Session, hidden: Option<&Hidden>) {
    let Some(hidden) = hidden.filter(|hidden| **hidden != Hidden::default()) else { return };
    let what = |surface: &SurfaceBelow| {
        let part = surface.triangle.map_or_else(String::new, |number| format!(" {number}"));
        format!("{}{part}, {} away", name_of(session, surface.object), number(surface.z))
    };
    ui.add_space(8.0);
    ui.label(RichText::new("Here, but not seen").color(theme::of(ui.ctx()).heading));
    let why = match Hint::of_culling(session.display().view().cull) {
        Hint::ViewCullsBackFaces => "back faces are left out",
        _ => "its material has one side",
    };
    for back in &hidden.culled {
        note(ui, &format!("{}: shows its back, and {why}", what(back)));
    }
    for behind in hidden.behind.iter().take(MAX_BEHIND) {
        note(ui, &format!("{}: behind what is seen", what(behind)));
    }
    if let more @ 1.. = hidden.behind.len().saturating_sub(MAX_BEHIND) {
        note(ui, &format!("and {more} more behind"));
    }
}

/// The object nearest to an uncovered pixel.
fn nearest(unseen: &Unseen, session: &Session) -> String {
    match unseen.nearest {
        Some(nearest) => {
            let [x, y] = nearest.pixel;
            let name = name_of(session, nearest.object);
            format!("nearest is {name}, {} pixels away at {x}, {y}", number(nearest.distance))
        }
        None => format!("and nothing lies within {NEAREST_WITHIN} pixels of it"),
    }
}

fn name_of(session: &Session, object: usize) -> String {
    let node = session.objects.get(object).map(|object| object.node.index());
    let node = node.and_then(|node| session.model.scene.nodes.get(node));
    node.map(|node| node.name.to_string()).unwrap_or_default()
}

/// A bar divided by the luminance of the terms.
fn bar(ui: &mut egui::Ui, terms: &[(TermKind, [f32; 3])]) {
    let width = ui.available_width();
    let (rect, _) = ui.allocate_exact_size(vec2(width, 12.0), egui::Sense::hover());
    let theme = theme::of(ui.ctx());
    ui.painter().rect_filled(rect, 2, theme.line);
    let all: f32 = terms.iter().map(|(_, value)| luminance(*value).max(0.0)).sum();
    let mut left = rect.left();
    for (kind, value) in terms {
        let part = if all > 0.0 { luminance(*value).max(0.0) / all * width } else { 0.0 };
        let part = egui::Rect::from_min_size(pos2(left, rect.top()), vec2(part, rect.height()));
        ui.painter().rect_filled(part, 0, term_color(*kind, theme));
        left = part.right();
    }
}
