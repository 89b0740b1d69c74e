//! Keyboard focus in the panels: focused controls are marked and scrolled into view.

use crate::theme;
use egui::scroll_area::ScrollSource;
use egui::{
    Context, EventFilter, FocusDirection, Id, Key, Rect, Response, ScrollArea, Stroke, StrokeKind,
    Ui, Vec2, vec2,
};

/// The id salt of scroll areas.
const SCROLLED: &str = "scrolled";

/// A vertical scroll area that follows keyboard focus: Tab passes over its bar, and dragging its content
/// doesn't scroll. One for each part of the window.
pub(crate) fn scrolled(ui: &Ui) -> ScrollArea {
    /// The index of the vertical bar in its id.
    const VERTICAL: usize = 1;
    let bar = ui.make_persistent_id(Id::new(SCROLLED)).with(VERTICAL);
    let is_back = ui.input(|input| input.modifiers.shift);
    let is_at_bar = ui.memory_mut(|memory| {
        let is_at_bar = memory.has_focus(bar);
        if is_at_bar {
            memory.move_focus(if is_back {
                FocusDirection::Previous
            } else {
                FocusDirection::Next
            });
        }
        is_at_bar
    });
    if is_at_bar {
        ui.ctx().request_repaint();
    }
    let source = ScrollSource { drag: false, ..ScrollSource::ALL };
    ScrollArea::vertical().id_salt(SCROLLED).scroll_source(source)
}

/// Scrolls a control of this area that has just got focus into view. Called at the area's end.
pub(crate) fn follow(ui: &Ui) {
    let Some(id) = ui.memory(egui::Memory::focused) else { return };
    let Some(response) = ui.ctx().read_response(id).filter(Response::gained_focus) else { return };
    let is_here = response.layer_id == ui.layer_id();
    if is_here && ui.min_rect().x_range().contains(response.rect.center().x) {
        ui.scroll_to_rect(response.rect.expand(8.0), None);
    }
}

/// Draws a focus ring around a custom-drawn control.
pub(crate) fn ring(ui: &Ui, response: &Response, rect: Rect) {
    if response.has_focus() {
        let line = Stroke::new(1.0, theme::of(ui.ctx()).accent);
        ui.painter().rect_stroke(rect, 4, line, StrokeKind::Inside);
    }
}

/// The arrow keys pressed since the last pass, as a vector with y downwards. Locks the arrows to the
/// focused control.
pub(crate) fn arrows(context: &Context, id: Id) -> Vec2 {
    let filter =
        EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    context.memory_mut(|memory| memory.set_focus_lock_filter(id, filter));
    context.input(|input| {
        let count = |wanted| {
            let pressed = |event: &&egui::Event| {
                matches!(event, egui::Event::Key { key, pressed: true, .. } if *key == wanted)
            };
            input.events.iter().filter(pressed).count() as f32
        };
        vec2(
            count(Key::ArrowRight) - count(Key::ArrowLeft),
            count(Key::ArrowDown) - count(Key::ArrowUp),
        )
    })
}
