//! The dialog in which a model is named: a path, and the entries that it may become.

use super::{Opener, Taken};
use crate::focus;
use crate::theme;
use egui::{
    Align, Align2, Button, Context, Frame, Id, Key, Layout, Margin, Modifiers, Order, RichText,
    Stroke, TextEdit, Ui, vec2,
};
use std::path::PathBuf;

/// The dialog's width and the height of its list, where the window has room for them.
const WIDTH: f32 = 520.0;
const HEIGHT: f32 = 264.0;

/// What comes of a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Answer {
    /// This model is to be opened.
    Open(PathBuf),
    /// It is to go away.
    Closed,
}

/// Shows the dialog; what comes of it, if it has come to an end.
pub(crate) fn dialog(context: &Context, opener: &mut Opener) -> Option<Answer> {
    let theme = theme::of(context);
    let room = (context.content_rect().size() - vec2(48.0, 220.0)).max(vec2(0.0, 0.0));
    let frame = Frame::new().fill(theme.panel).corner_radius(4).inner_margin(Margin::same(16));
    let frame = frame.stroke(Stroke::new(1.0, theme.line));
    let area =
        egui::Area::new(Id::new("open")).sense(egui::Sense::hover()).order(Order::Foreground);
    let area = area.anchor(Align2::CENTER_CENTER, vec2(0.0, -14.0));
    let shown = area.show(context, |ui| {
        frame
            .show(ui, |ui| {
                ui.set_width(WIDTH.min(room.x));
                ui.style_mut().spacing.item_spacing.y = 8.0;
                ui.horizontal(|ui| {
                    ui.label(RichText::new("Open a model").color(theme.heading));
                    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                        ui.label(RichText::new("glb  gltf  obj  stl  ply  toml").small().weak());
                    });
                });
                let mut answer = keys(ui, opener);
                field(ui, opener);
                let height = HEIGHT.min(room.y).max(48.0);
                answer = list(ui, opener, height).or(answer);
                let hint = "Up and Down choose    Tab completes    Enter opens    Esc leaves";
                ui.label(RichText::new(hint).small().weak());
                answer
            })
            .inner
    });
    // A press beside it.
    let is_beside = !opener.is_new && shown.response.clicked_elsewhere();
    opener.is_new = false;
    shown.inner.or(is_beside.then_some(Answer::Closed))
}

/// The keys that are not for the field.
fn keys(ui: &mut Ui, opener: &mut Opener) -> Option<Answer> {
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let [down, up, tab, enter, escape] =
        [Key::ArrowDown, Key::ArrowUp, Key::Tab, Key::Enter, Key::Escape].map(pressed);
    if down || up {
        opener.step(down);
    }
    if tab {
        opener.complete();
    }
    if escape {
        return Some(Answer::Closed);
    }
    enter.then(|| opener.take()).and_then(answer_of)
}

fn answer_of(taken: Taken) -> Option<Answer> {
    match taken {
        Taken::Model(path) => Some(Answer::Open(path)),
        Taken::Nothing => None,
    }
}

fn field(ui: &mut Ui, opener: &mut Opener) {
    let before = opener.text.clone();
    // Tab completes here.
    let field = TextEdit::singleline(&mut opener.text)
        .lock_focus(true)
        .hint_text(RichText::new("a path").color(theme::of(ui.ctx()).quiet));
    let field = field.margin(Margin::symmetric(8, 6)).desired_width(f32::INFINITY);
    let mut output = field.id_salt("path").show(ui);
    output.response.request_focus();
    if opener.text != before {
        opener.typed();
    }
    // What was completed or entered is gone on with at its end.
    let end = egui::text::CCursor::new(opener.text.chars().count());
    let is_at_end = output.state.cursor.char_range().is_some_and(|range| range.primary == end);
    if opener.is_moved && !is_at_end && opener.text == before {
        let range = egui::text::CCursorRange::one(end);
        output.state.cursor.set_char_range(Some(range));
        output.state.store(ui.ctx(), output.response.id);
        ui.ctx().request_repaint();
    }
}

fn list(ui: &mut Ui, opener: &mut Opener, height: f32) -> Option<Answer> {
    let theme = theme::of(ui.ctx());
    let mut clicked = None;
    let is_moved = std::mem::take(&mut opener.is_moved);
    Frame::new().fill(theme.field).corner_radius(4).inner_margin(Margin::same(4)).show(ui, |ui| {
        ui.set_min_size(vec2(ui.available_width(), height));
        ui.spacing_mut().item_spacing.y = 0.0;
        let area = focus::scrolled(ui).max_height(height).auto_shrink([false, false]);
        area.show(ui, |ui| {
            if let Some(trouble) = &opener.trouble {
                ui.label(RichText::new(trouble).color(theme.heading));
            } else if opener.found.is_empty() {
                ui.label(RichText::new("nothing here goes with that").weak());
            }
            for (at, entry) in opener.found.iter().map(|at| &opener.entries[*at]).enumerate() {
                let is_chosen = opener.chosen == Some(at);
                let slash = if entry.is_folder { "/" } else { "" };
                let color = if entry.is_folder { theme.quiet } else { theme.text };
                let text = RichText::new(format!("{}{slash}", entry.text)).color(color);
                let row = Button::selectable(is_chosen, text).truncate();
                let row = row.min_size(vec2(ui.available_width(), 0.0));
                let row = ui.with_layout(Layout::top_down_justified(Align::LEFT), |ui| ui.add(row));
                if row.inner.clicked() {
                    clicked = Some(at);
                }
                if is_chosen && is_moved {
                    row.inner.scroll_to_me(None);
                }
            }
        });
    });
    clicked.and_then(|at| {
        opener.chosen = Some(at);
        answer_of(opener.take())
    })
}
