//! Tests of the user interface without a window.

mod closing;
mod dialog;
mod keyboard;
mod layout;

use super::*;
use crate::model::Model;
use crate::theme::DARK;
use egui::{Event, Id, Key, Modifiers};
use luxel::navigation::Mode;
use luxel::scene::{Scene, demos};
use std::sync::Arc;

/// The user interface without a window.
struct Stage {
    ui: Ui,
    session: Session,
    size: Size,
    scale: f32,
    commands: Vec<UiCommand>,
}

impl Stage {
    fn new(demo: &str, (width, height): (u32, u32)) -> Self {
        Self::of(demos::demo(demo).unwrap(), (width, height))
    }

    fn of(scene: Scene, (width, height): (u32, u32)) -> Self {
        let size = Size { width, height };
        let view = luxel::default_view(&scene, size);
        let model = Model::fitted(scene, view);
        let session = Session::new(model, size, Mode::Turntable, false);
        let mut ui = Ui::new(&DARK, Keys::default());
        (ui.panels.is_shown, ui.panels.is_narrow) = (true, false);
        Self { ui, session, size, scale: 1.0, commands: Vec::new() }
    }

    fn pass(&mut self, events: Vec<Event>) {
        self.ui.events = events;
        let status = Status { name: "a model".to_owned(), is_chosen: true, ..Status::default() };
        let size = (self.size, self.scale);
        let updated = self.ui.update(Some(&mut self.session), &status, size);
        self.commands.extend(updated.0);
    }

    /// The window's pixels after the last pass.
    fn pixels(&self) -> Vec<u32> {
        let mut pixels = vec![0x0020_2428; self.size.width as usize * self.size.height as usize];
        self.ui.paint((self.size, self.scale), &mut pixels);
        pixels
    }

    fn click(&mut self, pos: egui::Pos2) {
        let button = egui::PointerButton::Primary;
        let modifiers = Modifiers::NONE;
        self.pass(vec![Event::PointerMoved(pos)]);
        for pressed in [true, false] {
            self.pass(vec![Event::PointerButton { pos, button, pressed, modifiers }]);
        }
    }

    fn press_with(&mut self, key: Key, modifiers: Modifiers) {
        self.ui.modifiers = modifiers;
        let event =
            |pressed| Event::Key { key, physical_key: None, pressed, repeat: false, modifiers };
        self.pass(vec![event(true), event(false)]);
        self.ui.modifiers = Modifiers::NONE;
        self.pass(Vec::new());
    }

    fn press(&mut self, key: Key) {
        self.press_with(key, Modifiers::NONE);
    }

    fn focused(&self) -> Option<Id> {
        self.ui.context.memory(egui::Memory::focused)
    }

    fn focus(&mut self, id: Option<Id>) {
        self.ui.context.memory_mut(|memory| match (id, memory.focused()) {
            (Some(id), _) => memory.request_focus(id),
            (None, Some(id)) => memory.surrender_focus(id),
            (None, None) => {}
        });
        self.pass(Vec::new());
    }

    /// Focuses the tree's search field by Tab: the first wide control.
    fn focus_search(&mut self) {
        let is_wide = |stage: &Self, id| {
            stage.ui.context.read_response(id).is_some_and(|field| field.rect.width() >= 100.0)
        };
        self.focus(None);
        self.press(Key::Tab);
        while !self.focused().is_some_and(|id| is_wide(self, id)) {
            self.press(Key::Tab);
        }
    }

    /// All controls that the pointer can press or drag.
    fn controls(&self) -> Vec<(Id, Rect)> {
        self.ui.context.viewport(|viewport| {
            let widgets = viewport.prev_pass.widgets.layers().flat_map(|(_, widgets)| widgets);
            let is_control = |widget: &&egui::WidgetRect| {
                let sense = widget.sense;
                widget.enabled
                    && (sense.senses_click() || sense.senses_drag())
                    && widget.interact_rect.is_positive()
            };
            widgets.filter(is_control).map(|widget| (widget.id, widget.rect)).collect()
        })
    }

    /// The controls that Tab focuses, in order; asserts that each is in view and shows its focus.
    fn walk(&mut self, name: &str) -> Vec<Id> {
        let mut stops = Vec::new();
        self.focus(None);
        for _ in 0..2000 {
            self.press(Key::Tab);
            let Some(id) = self.focused() else { continue };
            if stops.contains(&id) {
                return stops;
            }
            stops.push(id);
            // Lets scrolling settle.
            self.pass(Vec::new());
            self.pass(Vec::new());
            let rect = self.ui.context.read_response(id).unwrap().rect;
            assert!(self.window().contains_rect(rect), "{name}: {id:?} is out of view at {rect:?}");
            let lit = self.pixels();
            self.focus(None);
            let is_shown = self.differs(&lit, rect.expand(6.0));
            assert!(is_shown, "{name}: {id:?} at {rect:?} doesn't show its focus");
            self.focus(Some(id));
        }
        panic!("{name}: Tab never cycles: {}", stops.len())
    }

    /// The window without the status line, in points.
    fn window(&self) -> Rect {
        let size = vec2(self.size.width as f32, self.size.height as f32) / self.scale;
        Rect::from_min_size(egui::Pos2::ZERO, size - vec2(0.0, 28.0)).expand(0.5)
    }

    /// Whether pixels differ from the present ones within a rectangle.
    fn differs(&self, pixels: &[u32], within: Rect) -> bool {
        let within = within.intersect(self.window().shrink(0.5));
        let (left, right) = (within.left() as usize, within.right() as usize);
        let mut rows = within.top() as usize..within.bottom() as usize;
        let width = self.size.width as usize;
        let present = self.pixels();
        rows.any(|y| {
            let row = y * width + left..y * width + right;
            pixels[row.clone()] != present[row]
        })
    }
}
