//! Where the keyboard is among the panels' controls: what has it is seen, and comes into view.

use crate::theme;
use egui::scroll_area::ScrollSource;
use egui::{
    Context, EventFilter, FocusDirection, Id, Key, Rect, Response, ScrollArea, Stroke, StrokeKind,
    Ui, Vec2, vec2,
};

/// The part of what is scrolled's id that is its own.
const SCROLLED: &str = "scrolled";

/// What is scrolled by its bar and by the wheel; by the keyboard too, as it follows that: neither its bar
/// nor its ground is a control. One in each part of the window.
pub(crate) fn scrolled(ui: &Ui) -> ScrollArea {
    /// The bar at the side, as its id counts them.
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

/// Brings what has just got the keyboard into view, if it is in this area; to be called at its end.
pub(crate) fn follow(ui: &Ui) {
    let Some(id) = ui.memory(egui::Memory::focused) else { return };
    let Some(response) = ui.ctx().read_response(id).filter(Response::gained_focus) else { return };
    let is_here = response.layer_id == ui.layer_id();
    if is_here && ui.min_rect().x_range().contains(response.rect.center().x) {
        ui.scroll_to_rect(response.rect.expand(8.0), None);
    }
}

/// A frame about what draws itself, while it has the keyboard.
pub(crate) fn ring(ui: &Ui, response: &Response, rect: Rect) {
    if response.has_focus() {
        let line = Stroke::new(1.0, theme::of(ui.ctx()).accent);
        ui.painter().rect_stroke(rect, 4, line, StrokeKind::Inside);
    }
}

/// How far the arrows ask for something to be moved that has the keyboard: in their presses, y
/// downwards. They are its own from now on.
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
