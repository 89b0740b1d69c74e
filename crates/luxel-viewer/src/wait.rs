//! What lies over the lower end of the picture while there is something to wait for, or nothing to see:
//! how far a model has come, or how to open one.

use crate::keys::{Action, Keys};
use crate::loading::Loading;
use crate::theme;
use crate::ui::Wish;
use egui::{Align, Align2, Context, Frame, Id, Label, Layout, Margin, RichText, Stroke, vec2};
use std::time::{Duration, Instant};

/// A model that is being read.
#[derive(Clone, Debug)]
pub(crate) struct OnItsWay {
    pub(crate) name: String,
    loading: Loading,
    since: Instant,
}

impl OnItsWay {
    pub(crate) fn new(name: String, loading: Loading) -> Self {
        Self { name, loading, since: Instant::now() }
    }
}

/// What is there sooner needs no bar.
const PATIENCE: Duration = Duration::from_millis(250);
/// How often the bar is looked at again.
const AGAIN: Duration = Duration::from_millis(60);
/// Above the line at the bottom.
const ABOVE: egui::Vec2 = vec2(0.0, -44.0);

/// How far a model has come, with a button that stops it.
pub(crate) fn bar(context: &Context, coming: &OnItsWay, wishes: &mut Vec<Wish>) {
    let waited = coming.since.elapsed();
    if waited < PATIENCE {
        context.request_repaint_after(PATIENCE - waited);
        return;
    }
    context.request_repaint_after(AGAIN);
    let theme = theme::of(context);
    let frame = Frame::new().fill(theme.panel).corner_radius(4).inner_margin(Margin::same(12));
    let frame = frame.stroke(Stroke::new(1.0, theme.line));
    let area = egui::Area::new(Id::new("on its way"))
        .sense(egui::Sense::hover())
        .anchor(Align2::CENTER_BOTTOM, ABOVE);
    area.order(egui::Order::Foreground).show(context, |ui| {
        frame.show(ui, |ui| {
            ui.set_width((context.content_rect().width() - 48.0).clamp(0.0, 360.0));
            ui.horizontal(|ui| {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if ui.button("stop").on_hover_text("Esc").clicked() {
                        wishes.push(Wish::StopReading);
                    }
                    let rest = vec2(ui.available_width(), ui.spacing().interact_size.y);
                    ui.allocate_ui_with_layout(rest, Layout::left_to_right(Align::Center), |ui| {
                        ui.add(Label::new(&coming.name).truncate());
                    });
                });
            });
            let (rect, _) =
                ui.allocate_exact_size(vec2(ui.available_width(), 4.0), egui::Sense::hover());
            ui.painter().rect_filled(rect, 2, theme.line);
            let done = vec2(rect.width() * coming.loading.part().max(0.02), rect.height());
            ui.painter().rect_filled(egui::Rect::from_min_size(rect.min, done), 2, theme.accent);
            let seconds = waited.as_secs_f64();
            let told = format!("{}, {seconds:.1} s", coming.loading.told());
            ui.label(RichText::new(told).small().weak());
        });
    });
}

/// One line for whoever has no model of their own here yet.
pub(crate) fn hint(context: &Context, keys: &Keys) {
    let theme = theme::of(context);
    // As it stands on the key.
    let open = keys.first_of(Action::Open).to_uppercase();
    let text = if open.is_empty() {
        "drop a model here".to_owned()
    } else {
        format!("drop a model here, or press {open}")
    };
    let area = egui::Area::new(Id::new("hint")).anchor(Align2::CENTER_BOTTOM, ABOVE);
    area.order(egui::Order::Background).interactable(false).show(context, |ui| {
        let ground = theme.panel.gamma_multiply(0.85);
        let frame = Frame::new().fill(ground).corner_radius(4);
        frame.inner_margin(Margin::symmetric(12, 6)).show(ui, |ui| {
            ui.add(Label::new(RichText::new(text).color(theme.text)).extend());
        });
    });
}
