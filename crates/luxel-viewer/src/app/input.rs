//! What mouse and keys do: for the panels where they are theirs, for the camera elsewhere.

use super::App;
use crate::help::scrolled_by;
use crate::keys::{Action, Chord, KeyName, next_mode};
use crate::opener::Opener;
use crate::ui::Wish;
use luxel::navigation::{Event, Gesture, Mode};
use luxel::scene::DVec2;
use std::time::{Duration, Instant};
use winit::event::{ElementState, KeyEvent, MouseButton, MouseScrollDelta};
use winit::event_loop::ActiveEventLoop;
use winit::keyboard::{Key, ModifiersState, NamedKey};

/// Two clicks within this time, and this many pixels, are a double click.
const DOUBLE_CLICK: (Duration, f64) = (Duration::from_millis(350), 5.0);
/// A key that is down for longer is held.
const PEEK: Duration = Duration::from_millis(350);
/// Pixels of smooth scrolling that are a notch of a wheel.
const PIXELS_A_NOTCH: f64 = 50.0;

impl App {
    pub(super) fn press(&mut self, event_loop: &ActiveEventLoop, key: Key) {
        if self.ui.shows_help && self.is_for_help(&key) {
            return;
        }
        let Some(chord) = chord(&key, self.modifiers) else { return };
        let mode = self.session.as_ref().map_or_else(Mode::default, |one| one.state.mode());
        let Some(action) = self.ui.keys.action(&chord, mode) else { return };
        // Of a picture that is there, what is being read is no part yet.
        let escapes = key == Key::Named(NamedKey::Escape) && self.session.is_some();
        if escapes && action == Action::Quit && self.reading.is_some() {
            self.stop_reading();
            return;
        }
        if self.session.is_none() && !matches!(action, Action::Quit | Action::Open) {
            return;
        }
        match action {
            Action::Open => self.ask_for_file(),
            Action::Quit => event_loop.exit(),
            Action::Screenshot => self.wants_screenshot = true,
            Action::View(view) => self.happen(Event::View(view)),
            Action::Level => self.happen(Event::Level),
            Action::Mode(mode) => self.happen(Event::Mode(mode)),
            Action::NextMode => self.happen(Event::Mode(next_mode(mode))),
            Action::Hold(command) => {
                self.happen(Event::Press(command));
                self.held.push((key, command));
            }
            Action::Fit | Action::FitAll | Action::Lens if self.playing.is_some() => {}
            Action::Fit | Action::FitAll | Action::Lens => {
                let seconds = self.seconds();
                if let Some(session) = &mut self.session {
                    match action {
                        Action::Fit => session.fit_selected(seconds),
                        Action::FitAll => session.fit(seconds),
                        _ => session.switch_lens(seconds),
                    }
                }
            }
            Action::Show(_)
            | Action::NextEdges
            | Action::NextShading
            | Action::StepLayer(_)
            | Action::Split
            | Action::Difference => self.look_otherwise(action),
            Action::Measure => self.measure(),
            Action::Line => self.copy_line(),
            Action::Save => self.save(),
            Action::Step(is_forward) => self.step(is_forward),
            Action::Hide | Action::Isolate | Action::ShowAll => {
                if let Some(session) = &mut self.session {
                    let count = session.objects.len();
                    match action {
                        Action::Hide => session.marks.hide_selected(),
                        Action::Isolate => session.marks.isolate(count),
                        _ => session.marks.show_all(),
                    }
                }
                self.redraw();
            }
            Action::Help => {
                self.ui.shows_help = !self.ui.shows_help;
                self.redraw();
            }
            Action::IntoPanels => {
                self.ui.enter_panels();
                self.redraw();
            }
            Action::Explain => {
                let before = self.ui.panels();
                self.ui.toggle_ledger();
                self.peeking = self.ui.explains().then(|| (key, Instant::now(), before));
                self.redraw();
            }
            Action::Panels => {
                self.ui.shows_panels = !self.ui.shows_panels;
                self.redraw();
            }
        }
    }

    /// While the help is there, Esc puts it away, and the keys that scroll pages scroll it.
    pub(super) fn is_for_help(&mut self, key: &Key) -> bool {
        let Key::Named(key) = key else { return false };
        if *key == NamedKey::Escape {
            self.ui.shows_help = false;
        } else if let Some(by) = scrolled_by(*key) {
            self.ui.help_by += by;
        } else {
            return false;
        }
        self.redraw();
        true
    }

    /// Changes how the scene is looked at.
    fn look_otherwise(&mut self, action: Action) {
        let Some(session) = &mut self.session else { return };
        session.look_otherwise(action);
        if matches!(action, Action::NextShading | Action::StepLayer(_)) {
            self.status.note = Some(session.look().told());
            self.noted = Some(Instant::now() + Duration::from_secs(2));
        }
        self.redraw();
    }

    /// A key has come up: whatever it was when it went down.
    pub(super) fn lift(&mut self, key: &Key) {
        // Held for a while, it shows the ledger no longer than that.
        if let Some((_, since, before)) = self.peeking.take_if(|(down, ..)| down == key)
            && since.elapsed() > PEEK
        {
            self.ui.show_panels_as(before);
            self.redraw();
        }
        let lower = |key: &Key| match key {
            Key::Character(text) => Key::Character(text.to_lowercase().into()),
            other => other.clone(),
        };
        while let Some(at) = self.held.iter().position(|(down, _)| lower(down) == lower(key)) {
            let (_, command) = self.held.remove(at);
            self.happen(Event::Lift(command));
        }
    }

    pub(super) fn lift_all(&mut self) {
        for (_, command) in std::mem::take(&mut self.held) {
            self.happen(Event::Lift(command));
        }
        self.pressed = None;
        let was_band = self.band.take().is_some();
        self.ui.band = None;
        if self.holding.take().is_some() && !was_band {
            self.happen(Event::Release);
        }
    }

    pub(super) fn press_button(&mut self, button: MouseButton) {
        if self.is_for_panels(button, true) || self.holding.is_some() {
            return;
        }
        let gesture = match button {
            MouseButton::Left if self.modifiers.control_key() => {
                self.band = Some(self.pointer);
                self.holding = Some(button);
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
            let is_second = self.clicked.is_some_and(|(when, place)| {
                when.elapsed() < time && place.distance(at) < distance
            });
            if is_second {
                self.clicked = None;
                if let Some(point) = self.point_under() {
                    self.happen(Event::Pivot(point));
                }
                return;
            }
            self.clicked = Some((Instant::now(), at));
        }
        let point = if gesture == Gesture::Turn { None } else { self.point_under() };
        self.holding = Some(button);
        self.pressed = (button == MouseButton::Left).then_some(at);
        self.happen(Event::Grab { gesture, at, point });
    }

    pub(super) fn release_button(&mut self, button: MouseButton) {
        if self.holding == Some(button) {
            self.holding = None;
            if let Some(from) = self.band.take() {
                self.select_in_band(from);
            } else {
                self.happen(Event::Release);
            }
            if self.pressed.take().is_some() {
                self.click();
            }
        }
        self.is_for_panels(button, false);
    }

    /// Does what was asked for in the panels.
    pub(super) fn grant(&mut self, wish: Wish) {
        match wish {
            Wish::View(view) => self.happen(Event::View(view)),
            Wish::Mode(mode) => self.happen(Event::Mode(mode)),
            Wish::Line => self.copy_line(),
            Wish::Save => self.save(),
            Wish::Ask => self.ask_for_file(),
            Wish::Open(path) => self.open(path),
            Wish::StopReading => self.stop_reading(),
            Wish::Copy(text) => {
                if let Err(what) = self.clipboard.put(&text) {
                    self.note(format!("there is no clipboard: {what}"));
                }
            }
            Wish::Fit(Some(bounds)) => self.happen(Event::Fit(Some(bounds))),
            Wish::Fit(None) | Wish::Lens if self.playing.is_some() => {}
            Wish::Fit(None) | Wish::Lens => {
                let seconds = self.seconds();
                if let Some(session) = &mut self.session {
                    match wish {
                        Wish::Lens => session.switch_lens(seconds),
                        _ => session.fit(seconds),
                    }
                }
            }
        }
    }

    /// Opens the dialog in the folder of the file that is seen.
    fn ask_for_file(&mut self) {
        if self.playing.is_none() {
            self.lift_all();
            self.ui.opener = Some(Opener::beside(self.files.seen()));
            self.redraw();
        }
    }

    /// The pointer, in the points of the panels.
    pub(super) fn pointer_in_points(&self) -> egui::Pos2 {
        self.in_points(self.pointer)
    }

    /// A place of the window in the points of the panels.
    pub(super) fn in_points(&self, place: DVec2) -> egui::Pos2 {
        let scale = self.screen.as_ref().map_or(1.0, |screen| screen.window.scale_factor());
        egui::pos2((place.x / scale) as f32, (place.y / scale) as f32)
    }

    /// Tells the panels of a button; whether the pointer is theirs.
    pub(super) fn is_for_panels(&mut self, button: MouseButton, pressed: bool) -> bool {
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

    /// Tells the panels of a key that is typed into one of their fields; whether it was.
    pub(super) fn is_typed(&mut self, event: &KeyEvent) -> bool {
        if !self.ui.has_keyboard() {
            return false;
        }
        let pressed = event.state == ElementState::Pressed;
        if pressed && self.modifiers.control_key() && self.is_about_clipboard(&event.logical_key) {
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

    /// Ctrl and a letter, in a field: what is marked into the clipboard, or its text into the field.
    fn is_about_clipboard(&mut self, key: &Key) -> bool {
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

    pub(super) fn turn_wheel(&mut self, delta: MouseScrollDelta) {
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
        self.happen(Event::Wheel { notches, at: self.pointer, point });
    }
}

/// A key of the window, as bindings name it.
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
