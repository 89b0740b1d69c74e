//! The view in a terminal, for whoever has nothing else: the same scene, the same keys, pictures by
//! whatever the terminal can show.

mod graphics;
mod query;
mod screen;

use crate::app::ViewerError;
use crate::compare::{heat, join};
use crate::compose::compose;
use crate::files::Files;
use crate::keys::{Action, Chord, KeyName, Keys, next_mode};
use crate::lines::{Depths, draw};
use crate::model::Model;
use crate::probe::{depths, under};
use crate::session::Session;
use crate::sheet::Sheet;
use crate::snapshot::{keep, rgba_of};
use crate::theme::Theme;
use crossterm::event::{
    Event as Input, KeyCode, KeyEvent, KeyEventKind, KeyModifiers, MouseButton, MouseEvent,
    MouseEventKind,
};
pub use graphics::{Graphics, GraphicsChoice};
use luxel::navigation::{Event, Gesture, Mode};
use luxel::render::{Execution, Renderer};
use luxel::scene::{DVec2, DVec3, Size};
use screen::Screen;
pub use screen::leave_terminal;
use std::ffi::OsStr;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How long nothing may change until the picture sharpens.
const REST: Duration = Duration::from_millis(200);
/// How long the line at the bottom shows a note.
const NOTED: Duration = Duration::from_secs(4);
/// Samples a pixel while something moves; half blocks are so large that they need some.
const MOVING_SAMPLES: u32 = 2;

/// How the terminal is used.
pub struct TerminalOptions {
    /// The file's name, for the line at the bottom and for pictures.
    pub file: std::ffi::OsString,
    /// The way to navigate at first.
    pub mode: Mode,
    /// What keys do.
    pub keys: Keys,
    /// The colours of the ground.
    pub theme: crate::ThemeChoice,
    /// By what pictures are shown.
    pub graphics: GraphicsChoice,
    /// How pictures are drawn.
    pub execution: Execution,
    /// Writes a file, whole or not at all; answers with what went wrong, for the user.
    pub write: crate::Write,
}

/// Shows a model in the terminal until the user leaves.
///
/// # Errors
/// [`ViewerError`], if there is no terminal, or the scene can't be drawn.
pub fn view_in_terminal(model: Model, options: &TerminalOptions) -> Result<(), ViewerError> {
    let scene = Arc::clone(&model.scene);
    let renderer = Renderer::new(Arc::clone(&scene), &options.execution)
        .map_err(|error| ViewerError::Draw(error.to_string()))?;
    let screen = Screen::open(options.graphics).map_err(no_terminal)?;
    let size = screen.size();
    let mut view = View {
        session: Session::new(model, size, options.mode, false),
        renderer: &renderer,
        screen,
        theme: options.theme.theme(None),
        options,
        drawn: None,
        changed: Instant::now(),
        last: Instant::now(),
        note: None,
        holding: None,
        gesture: Gesture::Turn,
    };
    view.run()
}

fn no_terminal(error: std::io::Error) -> ViewerError {
    ViewerError::NoTerminal(error.to_string())
}

/// What is shown of the scene: the camera, the size, the session's revision, and whether it is sharp.
type Drawn = (luxel::scene::Camera, Size, u64, bool);

struct View<'a> {
    session: Session,
    renderer: &'a Renderer,
    screen: Screen,
    theme: &'static Theme,
    options: &'a TerminalOptions,
    drawn: Option<Drawn>,
    changed: Instant,
    /// Up to when time has passed for navigation.
    last: Instant,
    note: Option<(String, Instant)>,
    holding: Option<MouseButton>,
    gesture: Gesture,
}

impl View<'_> {
    fn run(&mut self) -> Result<(), ViewerError> {
        loop {
            self.draw()?;
            let patience = if self.session.state.is_moving() {
                Duration::from_millis(1)
            } else {
                match self.drawn {
                    Some((.., true)) => {
                        self.note.as_ref().map_or(Duration::from_secs(3600), |_| NOTED)
                    }
                    _ => REST.saturating_sub(self.changed.elapsed()),
                }
            };
            if crossterm::event::poll(patience).map_err(no_terminal)? {
                // All that has come before the next picture.
                loop {
                    let input = crossterm::event::read().map_err(no_terminal)?;
                    if self.take(input) {
                        return Ok(());
                    }
                    if !crossterm::event::poll(Duration::ZERO).map_err(no_terminal)? {
                        break;
                    }
                }
            }
            if self.session.state.is_moving() {
                self.happen(Event::Wait);
            }
        }
    }

    fn happen(&mut self, event: Event) {
        let seconds = self.last.elapsed().as_secs_f64().min(0.25);
        self.last = Instant::now();
        self.session.happen(event, seconds);
    }

    /// Brings the picture up to date.
    fn draw(&mut self) -> Result<(), ViewerError> {
        let wanted = (self.session.camera(), self.screen.size(), self.session.revision());
        let is_new =
            self.drawn.is_none_or(|(camera, size, revision, _)| (camera, size, revision) != wanted);
        let is_noted = self.note.is_some();
        self.note = self.note.take().filter(|(_, since)| since.elapsed() < NOTED);
        if is_new {
            self.changed = Instant::now();
        }
        let is_sharp = match self.drawn {
            None => true,
            _ => !self.session.state.is_moving() && self.changed.elapsed() >= REST,
        };
        let is_due = is_new || (is_sharp && self.drawn.is_some_and(|(.., was_sharp)| !was_sharp));
        if is_due {
            let mut sheets = self.session.sheets();
            if !is_sharp {
                for Sheet { view, .. } in &mut sheets {
                    view.samples = view.samples.min(MOVING_SAMPLES);
                }
            }
            let pixels = self.picture(&sheets)?;
            let (camera, size, revision) = wanted;
            self.screen.show(&pixels, size).map_err(no_terminal)?;
            self.drawn = Some((camera, size, revision, is_sharp));
        }
        if is_due || is_noted {
            let line = self.line();
            self.screen.write_line(&line).map_err(no_terminal)?;
        }
        Ok(())
    }

    /// The terminal's pixels, 0RGB.
    fn picture(&self, sheets: &[Sheet]) -> Result<Vec<u32>, ViewerError> {
        let drawn: Result<Vec<_>, _> =
            sheets.iter().map(|sheet| sheet.draw(self.renderer)).collect();
        let drawn = drawn.map_err(|error| ViewerError::Draw(error.to_string()))?;
        let Some(Sheet { view, .. }) = sheets.first() else { return Ok(Vec::new()) };
        let size = view.size;
        let mut pixels = vec![0; size.width as usize * size.height as usize];
        match (drawn.as_slice(), self.session.split()) {
            ([one, other], Some(split)) if split.is_difference => {
                compose((&heat(one, other).0, size), self.theme, size, &mut pixels);
            }
            ([one, other], Some(_)) => {
                compose((one, size), self.theme, size, &mut pixels);
                let mut right = vec![0; pixels.len()];
                compose((other, size), self.theme, size, &mut right);
                join(&mut pixels, &right, size.width as usize, size.width as usize / 2);
            }
            ([one, ..], _) => compose((one, size), self.theme, size, &mut pixels),
            ([], _) => {}
        }
        if self.session.guides.is_any()
            && let Some(z) = depths(self.renderer, view)
        {
            let lines = self.session.guides.lines(&self.session.subject(), self.theme);
            let depths = Depths { z: &z, size };
            draw(&lines, &view.camera, depths, (size, 1.0), &mut pixels);
        }
        Ok(pixels)
    }

    /// The line at the bottom.
    fn line(&self) -> String {
        let name = Files::title(&self.options.file);
        match &self.note {
            Some((note, _)) => format!(" {name}   {note}"),
            None => {
                let keys = &self.options.keys;
                let first = |action| keys.first_of(action);
                format!(
                    " {name}   {} triangles   {}   {}   {} help   {} quit",
                    self.session.model.scene.triangle_count(),
                    self.session.state.mode(),
                    self.session.look().told(),
                    first(Action::Help),
                    first(Action::Quit),
                )
            }
        }
    }

    /// Takes what has come from the terminal; whether the user leaves.
    fn take(&mut self, input: Input) -> bool {
        match input {
            Input::Key(key) if key.kind != KeyEventKind::Release => return self.press(key),
            Input::Mouse(mouse) => self.point(mouse),
            Input::Resize(..) => {
                self.screen.resized();
                self.session.resize(self.screen.size());
                self.drawn = None;
            }
            _ => {}
        }
        false
    }

    fn press(&mut self, key: KeyEvent) -> bool {
        // Whatever else it is bound to, in a terminal it leaves.
        if key.code == KeyCode::Char('c') && key.modifiers == KeyModifiers::CONTROL {
            return true;
        }
        let mode = self.session.state.mode();
        let Some(action) = chord(key).and_then(|chord| self.options.keys.action(&chord, mode))
        else {
            return false;
        };
        match action {
            Action::Quit => return true,
            Action::View(view) => self.happen(Event::View(view)),
            Action::Level => self.happen(Event::Level),
            Action::Mode(mode) => self.happen(Event::Mode(mode)),
            Action::NextMode => self.happen(Event::Mode(next_mode(mode))),
            // Terminals do not tell when a key comes up.
            Action::Hold(command) => self.happen(Event::Tap { command, steps: 1.0 }),
            Action::Fit | Action::FitAll => self.session.fit(0.0),
            Action::Lens => self.session.switch_lens(0.0),
            Action::Screenshot => self.note = Some((self.screenshot(), Instant::now())),
            Action::Help => {
                let keys = &self.options.keys;
                let of = |action| keys.first_of(action);
                let motions: Vec<_> = keys.motions(mode).into_iter().map(|(key, _)| key).collect();
                let note = format!(
                    "{} move   {} fit   {} mode   {} shading   {} layer   {} edges   {} grid   {} quit",
                    motions.join(" "),
                    of(Action::FitAll),
                    of(Action::NextMode),
                    of(Action::NextShading),
                    of(Action::StepLayer(true)),
                    of(Action::NextEdges),
                    of(Action::Show(crate::keys::Shown::Grid)),
                    of(Action::Quit),
                );
                self.note = Some((note, Instant::now()));
            }
            other => {
                if !self.session.look_otherwise(other) {
                    let note = "this takes a window: luxel view without --terminal".to_owned();
                    self.note = Some((note, Instant::now()));
                }
            }
        }
        false
    }

    /// The mouse, by the terminal's cells.
    fn point(&mut self, mouse: MouseEvent) {
        let at = self.screen.place(mouse.column, mouse.row);
        match mouse.kind {
            MouseEventKind::Down(button) if self.holding.is_none() => {
                self.gesture = match button {
                    MouseButton::Left if mouse.modifiers.contains(KeyModifiers::SHIFT) => {
                        Gesture::Pan
                    }
                    MouseButton::Left => Gesture::Turn,
                    MouseButton::Middle => Gesture::Pan,
                    MouseButton::Right => Gesture::Zoom,
                };
                self.holding = Some(button);
                let gesture = self.gesture;
                let point = if gesture == Gesture::Turn { None } else { self.point_at(at) };
                self.happen(Event::Grab { gesture, at, point });
            }
            MouseEventKind::Drag(button) if self.holding == Some(button) => {
                self.happen(Event::Drag { at });
            }
            MouseEventKind::Up(button) if self.holding == Some(button) => {
                self.holding = None;
                self.happen(Event::Release);
            }
            MouseEventKind::ScrollUp | MouseEventKind::ScrollDown => {
                let notches = if mouse.kind == MouseEventKind::ScrollUp { 1.0 } else { -1.0 };
                let point = self.point_at(at);
                self.happen(Event::Wheel { notches, at, point });
            }
            _ => {}
        }
    }

    /// The point of the world at a place of the picture.
    fn point_at(&self, at: DVec2) -> Option<DVec3> {
        let view = self.session.view();
        let is_in = at.x >= 0.0
            && at.y >= 0.0
            && at.x < f64::from(view.size.width)
            && at.y < f64::from(view.size.height);
        let pixel = is_in.then_some([at.x as u32, at.y as u32])?;
        under(self.renderer, &view, pixel).map(|found| found.point)
    }

    fn screenshot(&self) -> String {
        let pixels = match self.picture(&self.session.sheets()) {
            Ok(pixels) => pixels,
            Err(error) => return error.to_string(),
        };
        let encoding = self.session.look().view().encoding;
        let stem = Files::stem(OsStr::new(&self.options.file));
        let rgba = rgba_of(&pixels);
        keep(&stem, &rgba, self.screen.size(), encoding, &self.options.write)
            .unwrap_or_else(|what| what)
    }
}

/// A key of the terminal, as bindings name it.
fn chord(key: KeyEvent) -> Option<Chord> {
    let has = |modifier| key.modifiers.contains(modifier);
    let (mut shift, ctrl) = (has(KeyModifiers::SHIFT), has(KeyModifiers::CONTROL));
    let name = match key.code {
        KeyCode::Char(letter) => {
            shift |= letter.is_uppercase();
            KeyName::of(letter)
        }
        KeyCode::BackTab => {
            shift = true;
            KeyName::named("Tab")?
        }
        KeyCode::F(number) => KeyName::named(&format!("F{number}"))?,
        KeyCode::Esc => KeyName::named("Escape")?,
        other => KeyName::named(&format!("{other:?}"))?,
    };
    Some(Chord::new(name, ctrl, shift, has(KeyModifiers::ALT)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_of_the_terminal_are_those_of_the_window() {
        let none = KeyModifiers::NONE;
        for (code, modifiers, expected) in [
            (KeyCode::Char('f'), none, "f"),
            (KeyCode::Char('H'), KeyModifiers::SHIFT, "Shift+h"),
            (KeyCode::Char('H'), none, "Shift+h"),
            (KeyCode::Char('?'), KeyModifiers::SHIFT, "?"),
            (KeyCode::Char('1'), KeyModifiers::CONTROL, "Ctrl+1"),
            (KeyCode::Char('h'), KeyModifiers::ALT, "Alt+h"),
            (KeyCode::F(12), none, "F12"),
            (KeyCode::BackTab, KeyModifiers::SHIFT, "Shift+Tab"),
            (KeyCode::Home, none, "Home"),
            (KeyCode::PageDown, none, "PageDown"),
            (KeyCode::Left, none, "Left"),
            (KeyCode::Esc, none, "Escape"),
            (KeyCode::Char(' '), none, "Space"),
        ] {
            let found = chord(KeyEvent::new(code, modifiers));
            assert_eq!(found, Some(expected.parse().unwrap()), "{code:?}");
        }
    }
}
