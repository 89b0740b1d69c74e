//! The progress bar of a model being loaded, and the hint how to open one.

use crate::keys::{Action, Keys};
use crate::model::LoadProgress;
use crate::number::number;
use crate::theme;
use crate::ui::{UiCommand, names};
use egui::{Align, Align2, Context, Frame, Id, Label, Layout, Margin, RichText, Stroke, vec2};
use std::time::{Duration, Instant};

/// A model being loaded.
#[derive(Clone, Debug)]
pub(crate) struct PendingModel {
    pub(crate) name: String,
    progress: LoadProgress,
    since: Instant,
}

impl PendingModel {
    pub(crate) fn new(name: String, progress: LoadProgress) -> Self {
        Self { name, progress, since: Instant::now() }
    }
}

/// Models that load sooner show no bar.
const BAR_DELAY: Duration = Duration::from_millis(250);
/// The interval between updates of the bar.
const UPDATE_INTERVAL: Duration = Duration::from_millis(60);
/// The offset from the window's bottom.
const OFFSET: egui::Vec2 = vec2(0.0, -44.0);

/// The progress of a model, with a button that cancels it.
pub(crate) fn loading_bar(
    context: &Context,
    pending: &PendingModel,
    commands: &mut Vec<UiCommand>,
) {
    let elapsed = pending.since.elapsed();
    if elapsed < BAR_DELAY {
        context.request_repaint_after(BAR_DELAY - elapsed);
        return;
    }
    context.request_repaint_after(UPDATE_INTERVAL);
    let theme = theme::of(context);
    let frame = Frame::new().fill(theme.panel).corner_radius(4).inner_margin(Margin::same(12));
    let frame = frame.stroke(Stroke::new(1.0, theme.line));
    let area = egui::Area::new(Id::new("on its way"))
        .sense(egui::Sense::hover())
        .anchor(Align2::CENTER_BOTTOM, OFFSET);
    area.order(egui::Order::Foreground).show(context, |ui| {
        frame.show(ui, |ui| {
            ui.set_width((context.content_rect().width() - 48.0).clamp(0.0, 360.0));
            ui.horizontal(|ui| {
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if ui.button("stop").on_hover_text("Esc").clicked() {
                        commands.push(UiCommand::StopLoading);
                    }
                    let rest = vec2(ui.available_width(), ui.spacing().interact_size.y);
                    ui.allocate_ui_with_layout(rest, Layout::left_to_right(Align::Center), |ui| {
                        names::label(ui, &pending.name);
                    });
                });
            });
            let (rect, _) =
                ui.allocate_exact_size(vec2(ui.available_width(), 4.0), egui::Sense::hover());
            ui.painter().rect_filled(rect, 2, theme.line);
            let done = vec2(rect.width() * pending.progress.fraction().max(0.02), rect.height());
            ui.painter().rect_filled(egui::Rect::from_min_size(rect.min, done), 2, theme.accent);
            let seconds = number((elapsed.as_secs_f64() * 10.0).round() / 10.0);
            let status = format!("{}, {seconds} s", pending.progress.status());
            ui.label(RichText::new(status).small().weak());
        });
    });
}

/// The hint how to open a model.
pub(crate) fn open_hint(context: &Context, keys: &Keys) {
    let theme = theme::of(context);
    // As printed on the key.
    let open = keys.first_of(Action::Open).to_uppercase();
    let text = if open.is_empty() {
        "drop a model here".to_owned()
    } else {
        format!("drop a model here, or press {open}")
    };
    let area = egui::Area::new(Id::new("hint")).anchor(Align2::CENTER_BOTTOM, OFFSET);
    area.order(egui::Order::Background).interactable(false).show(context, |ui| {
        let background = theme.panel.gamma_multiply(0.85);
        let frame = Frame::new().fill(background).corner_radius(4);
        frame.inner_margin(Margin::symmetric(12, 6)).show(ui, |ui| {
            ui.add(Label::new(RichText::new(text).color(theme.text)).extend());
        });
    });
}
