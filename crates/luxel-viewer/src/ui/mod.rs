//! The user interface over the picture: panels, overlays, dialog, status line.

mod command;
mod focus;
mod icons;
mod ledger;
mod names;
mod open_dialog;
mod overlays;
mod paint;
mod panels;
mod status_line;
mod symbols;

use crate::keys::Keys;
use crate::picture::PictureDifference;
use crate::projection::WindowPart;
use crate::session::Session;
use crate::theme::{self, Theme};
pub(crate) use command::UiCommand;
use egui::{Context, RawInput, Rect, Stroke, vec2};
use luxel::scene::Size;
pub(crate) use open_dialog::PathCompletion;
use open_dialog::{DialogResult, open_dialog};
use overlays::{
    Grab, axes, difference_scale, divider, help, light_handles, loading_bar, measurement,
    open_hint, vectors,
};
pub(crate) use overlays::{PendingModel, help_scroll_step};
use paint::Painter;
pub(crate) use panels::PanelLayout;
use panels::{PanelState, Tab};
pub(crate) use status_line::Status;
use status_line::status_line;
use std::time::{Duration, Instant};

/// The user interface's state, and its painter.
pub(crate) struct Ui {
    pub(crate) events: Vec<egui::Event>,
    pub(crate) modifiers: egui::Modifiers,
    pub(crate) panels: PanelState,
    pub(crate) shows_help: bool,
    /// The pending scroll distance of the help, in points.
    pub(crate) help_scroll: f32,
    /// The dialog for a model, while it is open.
    pub(crate) dialog: Option<PathCompletion>,
    /// The handle of a light being dragged.
    grab: Option<Grab>,
    pub(crate) theme: &'static Theme,
    pub(crate) keys: Keys,
    /// The difference of two compared pictures, while it is shown.
    pub(crate) difference: Option<PictureDifference>,
    /// Two corners of the rubber band, while it is drawn.
    pub(crate) band: Option<[egui::Pos2; 2]>,
    context: Context,
    painter: Painter,
    /// What the last pass shows, and the textures that go after it.
    shapes: Vec<egui::epaint::ClippedShape>,
    textures: egui::TexturesDelta,
    started: Instant,
}

/// Events by passes. At the beginning of a pass egui moves the focus of the keyboard, as keys and clicks
/// of it want: letters that came before them begin a pass of their own, or they would be lost, as
/// several may come while a frame is drawn.
fn passes(events: Vec<egui::Event>) -> Vec<Vec<egui::Event>> {
    let mut passes: Vec<Vec<egui::Event>> = vec![Vec::new()];
    for event in events {
        let moves_focus = match &event {
            egui::Event::Key { key, pressed: true, .. } => {
                matches!(key, egui::Key::Escape | egui::Key::Tab)
            }
            egui::Event::PointerButton { pressed, .. } => *pressed,
            _ => false,
        };
        match passes.last_mut() {
            Some(last) if !moves_focus || last.is_empty() => last.push(event),
            _ => passes.push(vec![event]),
        }
    }
    passes
}

impl Ui {
    pub(crate) fn new(theme: &'static Theme, keys: Keys) -> Self {
        let context = Context::default();
        context.set_style(theme.style());
        Self {
            events: Vec::new(),
            modifiers: egui::Modifiers::NONE,
            panels: PanelState::default(),
            shows_help: false,
            help_scroll: 0.0,
            dialog: None,
            grab: None,
            theme,
            keys,
            difference: None,
            band: None,
            context,
            painter: Painter::default(),
            shapes: Vec::new(),
            textures: egui::TexturesDelta::default(),
            started: Instant::now(),
        }
    }

    /// Sets the theme.
    pub(crate) fn set_theme(&mut self, theme: &'static Theme) {
        self.theme = theme;
        self.context.set_style(theme.style());
    }

    /// Whether the pointer belongs to the interface rather than to the picture.
    pub(crate) fn has_pointer(&self) -> bool {
        self.dialog.is_some()
            || self.context.wants_pointer_input()
            || self.context.is_pointer_over_area()
    }

    /// Closes a list or a colour picker that has popped up; false if there is none.
    pub(crate) fn close_popup(&self) -> bool {
        let is_open = egui::Popup::is_any_open(&self.context);
        egui::Popup::close_all(&self.context);
        is_open
    }

    /// Whether a control has keyboard focus.
    pub(crate) fn has_keyboard(&self) -> bool {
        self.dialog.is_some() || self.context.wants_keyboard_input()
    }

    /// The part of the window that no panel covers.
    pub(crate) fn free_part(&mut self, size: Size, pixels_per_point: f32) -> WindowPart {
        let width = size.width as f32 / pixels_per_point;
        self.panels.fold_if_narrow(width);
        let pixels = |points: f32| (points * pixels_per_point).round() as u32;
        let [left, right] = self.panels.covered(width).map(pixels);
        let free = Size {
            width: size.width.saturating_sub(left + right).max(1),
            height: size.height.saturating_sub(pixels(status_line::HEIGHT)).max(1),
        };
        WindowPart { left: left.min(size.width - 1), top: 0, size: free }
    }

    /// Lays the interface out, which [`paint`](Self::paint) shows. Returns commands to the window, and the
    /// time until the next repaint.
    pub(crate) fn update(
        &mut self,
        mut session: Option<&mut Session>,
        status: &Status,
        (size, pixels_per_point): (Size, f32),
    ) -> (Vec<UiCommand>, Duration) {
        let points = vec2(size.width as f32, size.height as f32) / pixels_per_point;
        self.context.set_pixels_per_point(pixels_per_point);
        let mut input = RawInput {
            screen_rect: Some(Rect::from_min_size(egui::Pos2::ZERO, points)),
            time: Some(self.started.elapsed().as_secs_f64()),
            modifiers: self.modifiers,
            ..RawInput::default()
        };
        let mut commands = Vec::new();
        let context = self.context.clone();
        let mut passes = passes(std::mem::take(&mut self.events));
        let last = passes.pop().unwrap_or_default();
        let mut lay_out = |ui: &mut Self, events: Vec<egui::Event>| {
            input.events = events;
            let output = context.run(input.clone(), |context| {
                ui.lay_out(context, session.as_deref_mut(), status, &mut commands);
            });
            for command in output.platform_output.commands {
                if let egui::OutputCommand::CopyText(text) = command {
                    commands.push(UiCommand::CopyText(text));
                }
            }
            // What the pass before showed is painted by now.
            ui.painter.free(&ui.textures);
            ui.painter.update(&output.textures_delta);
            (ui.shapes, ui.textures) = (output.shapes, output.textures_delta);
            output.viewport_output
        };
        for events in passes {
            lay_out(self, events);
        }
        let viewports = lay_out(self, last);
        let repaint = viewports.values().map(|viewport| viewport.repaint_delay).min();
        (commands, repaint.unwrap_or(Duration::MAX))
    }

    /// Paints the interface over the window's pixels.
    pub(crate) fn paint(&self, (size, pixels_per_point): (Size, f32), pixels: &mut [u32]) {
        let primitives = self.context.tessellate(self.shapes.clone(), pixels_per_point);
        self.painter.paint(&primitives, pixels_per_point, size, pixels);
    }

    fn lay_out(
        &mut self,
        context: &Context,
        session: Option<&mut Session>,
        status: &Status,
        commands: &mut Vec<UiCommand>,
    ) {
        status_line(context, status, session.as_deref(), (&self.keys, self.space_effect()));
        self.show_loading(context, status, session.is_some(), commands);
        let Some(session) = session else { return };
        self.panels.fold_if_narrow(context.content_rect().width());
        if self.panels.is_shown {
            self.show_panels(context, session, commands);
        }
        if let Some(difference) = self.difference.filter(|_| session.comparison().is_some()) {
            difference_scale(context, &difference);
        } else if let Some((comparison, display)) = session.comparison_mut() {
            divider(context, comparison, display);
        }
        measurement(context, session);
        axes(context, session, commands);
        if let Some([from, to]) = self.band {
            rubber_band(context, Rect::from_two_pos(from, to));
        }
        if self.shows_help {
            let scroll = std::mem::take(&mut self.help_scroll);
            let mode = (session.state.mode(), status.position.is_some());
            help(context, mode, &self.keys, scroll);
        }
    }

    /// The effect of the key that explains, which pages the help while it is open.
    fn space_effect(&self) -> &'static str {
        if self.shows_help {
            "scrolls the help"
        } else if self.panels.shows_explanation() {
            "hides the explanation"
        } else {
            "explains the pixel"
        }
    }

    /// The panels, and what they show in the picture.
    fn show_panels(
        &mut self,
        context: &Context,
        session: &mut Session,
        commands: &mut Vec<UiCommand>,
    ) {
        let panels = &mut self.panels;
        if panels.is_narrow {
            panels::folded(panels, context);
        }
        if panels.shows_tree() {
            panels::tree(panels, context, session, commands);
        }
        if panels.shows_settings() {
            panels::settings(panels, context, session, &self.keys, commands);
        }
        if let (true, Some(pixel)) = (panels.shows_explanation(), &panels.explanation) {
            vectors(context, session, &pixel.explanation);
        }
        if panels.shows_settings() && panels.tab == Tab::Light {
            light_handles(context, session, &mut panels.chosen_light, &mut self.grab);
        }
    }

    /// The loading bar, the hint how to open a model, and the dialog.
    fn show_loading(
        &mut self,
        context: &Context,
        status: &Status,
        has_model: bool,
        commands: &mut Vec<UiCommand>,
    ) {
        if let Some(pending) = &status.loading {
            loading_bar(context, pending, commands);
        } else if self.dialog.is_none() && (!status.is_chosen || !has_model) {
            open_hint(context, &self.keys);
        }
        let result = self.dialog.as_mut().and_then(|dialog| open_dialog(context, dialog));
        if let Some(result) = result {
            self.dialog = None;
            // Keys control the picture again.
            context.memory_mut(|memory| {
                if let Some(field) = memory.focused() {
                    memory.surrender_focus(field);
                }
            });
            if let DialogResult::Open(path) = result {
                commands.push(UiCommand::Open(path));
            }
            context.request_repaint();
        }
    }
}

/// The rubber band: objects inside are selected when the button is released.
fn rubber_band(context: &Context, rect: Rect) {
    let painter = context.layer_painter(egui::LayerId::background());
    let accent = theme::of(context).accent;
    painter.rect_filled(rect, 0, accent.gamma_multiply(0.1));
    let line = Stroke::new(1.0, accent);
    painter.rect_stroke(rect, 0, line, egui::StrokeKind::Inside);
}

#[cfg(test)]
mod tests;
