//! Mouse and keyboard input: to the user interface where it has pointer or focus, else to the camera.

use super::App;
use super::surface::WindowSurface;
use crate::keys::{Action, Chord, KeyName, next_mode};
use crate::projection::WindowPart;
use crate::ui::{PathCompletion, UiCommand, help_scroll_step};
use luxel::navigation::{Event, Gesture, Mode};
use luxel::scene::DVec2;
use std::time::{Duration, Instant};
use winit::event::{ElementState, KeyEvent, MouseButton, MouseScrollDelta};
use winit::event_loop::ActiveEventLoop;
use winit::keyboard::{Key, ModifiersState};

/// The longest time and the largest distance, in pixels, between the clicks of a double click.
const DOUBLE_CLICK: (Duration, f64) = (Duration::from_millis(350), 5.0);
/// The time after which a pressed key counts as held.
const HOLD_TIME: Duration = Duration::from_millis(350);
/// Pixels of smooth scrolling for one notch of a wheel.
const PIXELS_A_NOTCH: f64 = 50.0;

impl App {
    /// Handles a key press outside of text fields.
    pub(super) fn press_key(&mut self, event_loop: &ActiveEventLoop, key: Key) {
        if self.ui.shows_help && self.handle_help_key(&key) {
            return;
        }
        let Some(chord) = chord(&key, self.modifiers) else { return };
        let mode = self.session.as_ref().map_or_else(Mode::default, |one| one.state.mode());
        let Some(action) = self.ui.keys.action(&chord, mode) else { return };
        if self.session.is_none() && !matches!(action, Action::Close | Action::Quit | Action::Open)
        {
            return;
        }
        match action {
            Action::Open => self.open_dialog(),
            Action::Close => self.close(event_loop),
            Action::Quit => event_loop.exit(),
            Action::Screenshot => self.wants_screenshot = true,
            Action::View(view) => self.navigate(Event::View(view)),
            Action::Level => self.navigate(Event::Level),
            Action::Mode(mode) => self.navigate(Event::Mode(mode)),
            Action::NextMode => self.navigate(Event::Mode(next_mode(mode))),
            Action::Motion(command) => {
                self.navigate(Event::Press(command));
                self.held_keys.push((key, command));
            }
            Action::Fit | Action::FitAll | Action::ToggleLens if self.replay.is_some() => {}
            Action::Fit | Action::FitAll | Action::ToggleLens => {
                let (part, seconds) = (self.free_part(), self.seconds());
                if let Some(session) = &mut self.session {
                    match action {
                        Action::Fit => session.fit_selected(part, seconds),
                        Action::FitAll => session.fit(part, seconds),
                        _ => session.toggle_lens(seconds),
                    }
                }
            }
            Action::ToggleGuide(_)
            | Action::NextEdges
            | Action::NextShading
            | Action::StepLayer(_)
            | Action::Compare
            | Action::Difference => self.apply_display_action(action),
            Action::Measure => self.measure(),
            Action::CopyCommand => self.copy_command(),
            Action::SaveScene => self.save_scene(),
            Action::StepFile(is_forward) => self.step_file(is_forward),
            Action::Hide | Action::Isolate | Action::ShowAll => {
                if let Some(session) = &mut self.session {
                    let count = session.objects.len();
                    match action {
                        Action::Hide => session.selection.hide_selected(),
                        Action::Isolate => session.selection.isolate(count),
                        _ => session.selection.show_all(),
                    }
                }
                self.redraw();
            }
            Action::Help => {
                self.ui.shows_help = !self.ui.shows_help;
                self.redraw();
            }
            Action::FocusPanels => {
                self.ui.panels.focus_first();
                self.redraw();
            }
            Action::Explain => {
                let before = self.ui.panels.layout();
                self.ui.panels.toggle_explanation();
                self.peek =
                    self.ui.panels.shows_explanation().then(|| (key, Instant::now(), before));
                self.redraw();
            }
            Action::Panels => {
                self.ui.panels.is_shown = !self.ui.panels.is_shown;
                self.redraw();
            }
        }
    }

    /// Scrolls the help; true if the key was handled.
    pub(super) fn handle_help_key(&mut self, key: &Key) -> bool {
        let Key::Named(key) = key else { return false };
        let Some(step) = help_scroll_step(*key) else { return false };
        self.ui.help_scroll += step;
        self.redraw();
        true
    }

    /// Applies an action to the display settings.
    fn apply_display_action(&mut self, action: Action) {
        let Some(session) = &mut self.session else { return };
        session.apply_display_action(action);
        if matches!(action, Action::NextShading | Action::StepLayer(_)) {
            self.status.note = Some(session.display().summary());
            self.note_until = Some(Instant::now() + Duration::from_secs(2));
        }
        self.redraw();
    }

    /// Handles a key release. Shift may have changed since the key was pressed.
    pub(super) fn release_key(&mut self, key: &Key) {
        // A held key shows the explanation only while held.
        if let Some((_, since, before)) = self.peek.take_if(|(down, ..)| down == key)
            && since.elapsed() > HOLD_TIME
        {
            self.ui.panels.set_layout(before);
            self.redraw();
        }
        let lower = |key: &Key| match key {
            Key::Character(text) => Key::Character(text.to_lowercase().into()),
            other => other.clone(),
        };
        while let Some(at) = self.held_keys.iter().position(|(down, _)| lower(down) == lower(key)) {
            let (_, command) = self.held_keys.remove(at);
            self.navigate(Event::Lift(command));
        }
    }

    /// Releases all keys and buttons.
    pub(super) fn release_all(&mut self) {
        for (_, command) in std::mem::take(&mut self.held_keys) {
            self.navigate(Event::Lift(command));
        }
        self.press_position = None;
        let was_band = self.band_start.take().is_some();
        self.ui.band = None;
        if self.held_button.take().is_some() && !was_band {
            self.navigate(Event::Release);
        }
    }

    /// Starts a gesture, a click or a rubber band.
    pub(super) fn press_button(&mut self, button: MouseButton) {
        if self.forward_button(button, true) || self.held_button.is_some() {
            return;
        }
        let gesture = match button {
            MouseButton::Left if self.modifiers.control_key() => {
                self.band_start = Some(self.pointer);
                self.held_button = Some(button);
                return;
            }
            MouseButton::Left if self.modifiers.shift_key() => Gesture::Pan,
            MouseButton::Left => Gesture::Turn,
            MouseButton::Middle => Gesture::Pan,
            MouseButton::Right => Gesture::Zoom,
            _ => return,
        };
        let at = self.pointer;
        if gesture == Gesture::Turn {
            let (time, distance) = DOUBLE_CLICK;
            let is_second = self.last_click.is_some_and(|(when, position)| {
                when.elapsed() < time && position.distance(at) < distance
            });
            if is_second {
                self.last_click = None;
                if let Some(point) = self.point_under() {
                    self.navigate(Event::Pivot(point));
                }
                return;
            }
            self.last_click = Some((Instant::now(), at));
        }
        let point = if gesture == Gesture::Turn { None } else { self.point_under() };
        self.held_button = Some(button);
        self.press_position = (button == MouseButton::Left).then_some(at);
        self.navigate(Event::Grab { gesture, at, point });
    }

    pub(super) fn release_button(&mut self, button: MouseButton) {
        if self.held_button == Some(button) {
            self.held_button = None;
            if let Some(from) = self.band_start.take() {
                self.select_in_band(from);
            } else {
                self.navigate(Event::Release);
            }
            if self.press_position.take().is_some() {
                self.click();
            }
        }
        self.forward_button(button, false);
    }

    /// Executes a command of the user interface.
    pub(super) fn execute(&mut self, command: UiCommand) {
        match command {
            UiCommand::View(view) => self.navigate(Event::View(view)),
            UiCommand::Mode(mode) => self.navigate(Event::Mode(mode)),
            UiCommand::CopyCommand => self.copy_command(),
            UiCommand::SaveScene => self.save_scene(),
            UiCommand::OpenDialog => self.open_dialog(),
            UiCommand::Open(path) => self.open(path),
            UiCommand::StopLoading => self.stop_loading(),
            UiCommand::CopyText(text) => {
                if let Err(what) = self.clipboard.put(&text) {
                    self.note(format!("there is no clipboard: {what}"));
                }
            }
            UiCommand::Fit(_) | UiCommand::ToggleLens if self.replay.is_some() => {}
            UiCommand::Fit(_) | UiCommand::ToggleLens => {
                let (part, seconds) = (self.free_part(), self.seconds());
                if let Some(session) = &mut self.session {
                    match command {
                        UiCommand::Fit(Some(bounds)) => session.fit_bounds(&bounds, part, seconds),
                        UiCommand::Fit(None) => session.fit(part, seconds),
                        _ => session.toggle_lens(seconds),
                    }
                }
            }
        }
    }

    /// Opens the dialog in the folder of the file on display.
    fn open_dialog(&mut self) {
        if self.replay.is_none() {
            self.release_all();
            self.ui.dialog = Some(PathCompletion::beside(self.files.shown()));
            self.redraw();
        }
    }

    /// The part of the window that no panel covers.
    pub(super) fn free_part(&mut self) -> WindowPart {
        let scale = self.surface.as_ref().map_or(1.0, |surface| surface.window.scale_factor());
        let size = self.surface.as_ref().map_or(self.options.size, WindowSurface::size);
        self.ui.free_part(size, scale as f32)
    }

    /// The pointer in logical points.
    pub(super) fn pointer_in_points(&self) -> egui::Pos2 {
        self.in_points(self.pointer)
    }

    /// A window position in logical points.
    pub(super) fn in_points(&self, position: DVec2) -> egui::Pos2 {
        let scale = self.surface.as_ref().map_or(1.0, |surface| surface.window.scale_factor());
        egui::pos2((position.x / scale) as f32, (position.y / scale) as f32)
    }

    /// Forwards a button to the user interface; true if the pointer belongs to it.
    pub(super) fn forward_button(&mut self, button: MouseButton, pressed: bool) -> bool {
        let button = match button {
            MouseButton::Left => egui::PointerButton::Primary,
            MouseButton::Right => egui::PointerButton::Secondary,
            _ => return self.ui.has_pointer(),
        };
        let (pos, modifiers) = (self.pointer_in_points(), self.ui.modifiers);
        self.ui.events.push(egui::Event::PointerButton { pos, button, pressed, modifiers });
        self.redraw();
        self.ui.has_pointer()
    }

    /// Forwards a key to the focused control; false if there is none.
    pub(super) fn forward_key(&mut self, event: &KeyEvent) -> bool {
        if !self.ui.has_keyboard() {
            return false;
        }
        let pressed = event.state == ElementState::Pressed;
        if pressed && self.modifiers.control_key() && self.clipboard_shortcut(&event.logical_key) {
            self.redraw();
            return true;
        }
        if let (true, Some(text)) = (pressed, &event.text)
            && !text.chars().any(char::is_control)
        {
            self.ui.events.push(egui::Event::Text(text.to_string()));
        }
        let name = match &event.logical_key {
            Key::Named(named) => format!("{named:?}"),
            Key::Character(text) => text.to_uppercase(),
            _ => String::new(),
        };
        if let Some(key) = egui::Key::from_name(&name) {
            self.ui.events.push(egui::Event::Key {
                key,
                physical_key: None,
                pressed,
                repeat: event.repeat,
                modifiers: self.ui.modifiers,
            });
        }
        self.redraw();
        true
    }

    /// Handles copy, cut and paste in a text field; false for other keys.
    fn clipboard_shortcut(&mut self, key: &Key) -> bool {
        let Key::Character(letter) = key else { return false };
        let event = match letter.to_lowercase().as_str() {
            "c" => Some(egui::Event::Copy),
            "x" => Some(egui::Event::Cut),
            // Fields have one line.
            "v" => self.clipboard.text().map(|text| {
                let line = text.lines().next().unwrap_or_default();
                egui::Event::Paste(line.to_owned())
            }),
            _ => return false,
        };
        self.ui.events.extend(event);
        true
    }

    pub(super) fn handle_wheel(&mut self, delta: MouseScrollDelta) {
        let notches = match delta {
            MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
            MouseScrollDelta::PixelDelta(way) => way.y / PIXELS_A_NOTCH,
        };
        if self.ui.has_pointer() {
            self.ui.events.push(egui::Event::MouseWheel {
                unit: egui::MouseWheelUnit::Line,
                delta: egui::vec2(0.0, notches as f32),
                modifiers: self.ui.modifiers,
            });
            self.redraw();
            return;
        }
        let point = self.point_under();
        self.navigate(Event::Wheel { notches, at: self.pointer, point });
    }
}

/// The chord of a window system's key.
fn chord(key: &Key, modifiers: ModifiersState) -> Option<Chord> {
    let key = match key {
        Key::Character(text) => {
            let mut letters = text.chars();
            let one = letters.next()?;
            letters.next().is_none().then(|| KeyName::of(one))?
        }
        Key::Named(named) => KeyName::named(&format!("{named:?}"))?,
        _ => return None,
    };
    let (ctrl, shift) = (modifiers.control_key(), modifiers.shift_key());
    Some(Chord::new(key, ctrl, shift, modifiers.alt_key()))
}
