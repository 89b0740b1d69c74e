//! The dialog that opens a model: a path, and the list of its completions.

mod completion;

use crate::theme;
use crate::ui::{focus, names};
use completion::Accepted;
pub(crate) use completion::PathCompletion;
use egui::{
    Align, Align2, Context, Frame, Id, Key, Layout, Margin, Modifiers, Order, RichText, Stroke,
    TextEdit, Ui, vec2,
};
use std::path::PathBuf;

/// The dialog's width and the height of its list, if the window has room.
const WIDTH: f32 = 520.0;
const HEIGHT: f32 = 264.0;

/// How the dialog was closed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum DialogResult {
    /// With a model to open.
    Open(PathBuf),
    /// Without one.
    Closed,
}

/// Shows the dialog; returns its result once it is closed.
pub(crate) fn open_dialog(
    context: &Context,
    completion: &mut PathCompletion,
) -> Option<DialogResult> {
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
                let mut result = keys(ui, completion);
                field(ui, completion);
                let height = HEIGHT.min(room.y).max(48.0);
                result = list(ui, completion, height).or(result);
                let hint = "Up and Down choose    Tab completes    Enter opens    Esc leaves";
                ui.label(RichText::new(hint).small().weak());
                result
            })
            .inner
    });
    // A click beside the dialog closes it.
    let is_beside = !completion.is_new && shown.response.clicked_elsewhere();
    completion.is_new = false;
    shown.inner.or(is_beside.then_some(DialogResult::Closed))
}

/// Handles the keys that the field doesn't.
fn keys(ui: &mut Ui, completion: &mut PathCompletion) -> Option<DialogResult> {
    let pressed = |key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key));
    let [down, up, tab, enter, escape] =
        [Key::ArrowDown, Key::ArrowUp, Key::Tab, Key::Enter, Key::Escape].map(pressed);
    if down || up {
        completion.step(down);
    }
    if tab {
        completion.complete();
    }
    if escape {
        return Some(DialogResult::Closed);
    }
    enter.then(|| completion.accept()).and_then(result_of)
}

fn result_of(taken: Accepted) -> Option<DialogResult> {
    match taken {
        Accepted::Model(path) => Some(DialogResult::Open(path)),
        Accepted::Continue => None,
    }
}

fn field(ui: &mut Ui, completion: &mut PathCompletion) {
    let before = completion.text.clone();
    // Tab completes instead of moving focus.
    let field = TextEdit::singleline(&mut completion.text)
        .lock_focus(true)
        .hint_text(RichText::new("a path").color(theme::of(ui.ctx()).quiet));
    let field = field.margin(Margin::symmetric(8, 6)).desired_width(f32::INFINITY);
    let pasted = ui.input(|input| {
        input.events.iter().rev().find_map(|event| match event {
            egui::Event::Paste(text) => Some(text.clone()),
            _ => None,
        })
    });
    let mut output = field.id_salt("path").show(ui);
    output.response.request_focus();
    let is_replaced = completion.text != before && completion.edited(pasted.as_deref());
    // The cursor follows the end of a completed or replaced text.
    let end = egui::text::CCursor::new(completion.text.chars().count());
    let is_at_end = output.state.cursor.char_range().is_some_and(|range| range.primary == end);
    let is_completed = completion.scrolls_to_selected && completion.text == before;
    if is_replaced || (is_completed && !is_at_end) {
        let range = egui::text::CCursorRange::one(end);
        output.state.cursor.set_char_range(Some(range));
        output.state.store(ui.ctx(), output.response.id);
        ui.ctx().request_repaint();
    }
}

fn list(ui: &mut Ui, completion: &mut PathCompletion, height: f32) -> Option<DialogResult> {
    let theme = theme::of(ui.ctx());
    let mut clicked = None;
    let scrolls_to_selected = std::mem::take(&mut completion.scrolls_to_selected);
    Frame::new().fill(theme.field).corner_radius(4).inner_margin(Margin::same(4)).show(ui, |ui| {
        ui.set_min_size(vec2(ui.available_width(), height));
        ui.spacing_mut().item_spacing.y = 0.0;
        let area = focus::scrolled(ui).max_height(height).auto_shrink([false, false]);
        area.show(ui, |ui| {
            if let Some(error) = &completion.error {
                ui.label(RichText::new(error).color(theme.heading));
            } else if completion.matches.is_empty() {
                ui.label(RichText::new("nothing here matches").weak());
            }
            for (at, entry) in
                completion.matches.iter().map(|at| &completion.entries[*at]).enumerate()
            {
                let is_selected = completion.selected == Some(at);
                let slash = if entry.is_folder { "/" } else { "" };
                let color = if entry.is_folder { theme.quiet } else { theme.text };
                let text = format!("{}{slash}", entry.text);
                let row = ui.with_layout(Layout::top_down_justified(Align::LEFT), |ui| {
                    let width = ui.available_width();
                    names::button(ui, is_selected, &text, Some(color), width)
                });
                if row.inner.clicked() {
                    clicked = Some(at);
                }
                if is_selected && scrolls_to_selected {
                    row.inner.scroll_to_me(None);
                }
            }
        });
    });
    clicked.and_then(|at| {
        completion.selected = Some(at);
        result_of(completion.accept())
    })
}
