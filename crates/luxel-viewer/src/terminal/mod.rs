//! The viewer in a terminal: the same scene, keys and navigation, with pictures in whatever way the
//! terminal supports.

mod graphics;
mod query;
mod screen;

use crate::keys::{Action, Chord, Guide, KeyName, Keys, next_mode};
use crate::model::{FileList, Model};
use crate::options::{ViewerError, WriteFile};
use crate::picture::{
    Depths, compose, difference_map, draw_lines, join_columns, rgba_of, save_png,
};
use crate::projection::WindowPart;
use crate::render::{RenderJob, hit_at_pixel, render_depths};
use crate::session::Session;
use crate::theme::{Theme, ThemeChoice};
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
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

/// The time at rest after which the picture is refined.
const REFINE_DELAY: Duration = Duration::from_millis(200);
/// How long the bottom line shows a note.
const NOTE_DURATION: Duration = Duration::from_secs(4);
/// The most samples per pixel during motion; half blocks are so large that they need more than one.
const MOVING_SAMPLES: u32 = 2;

/// Options of the viewer in a terminal.
pub struct TerminalOptions {
    /// The file's name, for the bottom line and screenshots.
    pub file: std::ffi::OsString,
    /// The initial navigation mode.
    pub mode: Mode,
    /// Key bindings.
    pub keys: Keys,
    /// The colours of the background.
    pub theme: ThemeChoice,
    /// How pictures are shown.
    pub graphics: GraphicsChoice,
    /// Threads and vector level of rendering.
    pub execution: Execution,
    /// Writes a file.
    pub write: WriteFile,
}

/// Shows a model in the terminal until the user leaves.
///
/// # Errors
/// [`ViewerError`], if there is no terminal, or the scene can't be drawn.
pub fn view_in_terminal(mut model: Model, options: &TerminalOptions) -> Result<(), ViewerError> {
    model.separate();
    let scene = Arc::clone(&model.scene);
    let renderer = Renderer::new(Arc::clone(&scene), &options.execution)
        .map_err(|error| ViewerError::Draw(error.to_string()))?;
    let screen = Screen::open(options.graphics).map_err(no_terminal)?;
    let size = screen.size();
    let mut view = TerminalView {
        session: Session::new(model, size, options.mode, false),
        renderer: &renderer,
        screen,
        theme: options.theme.theme(None),
        options,
        shown: None,
        moved_at: Instant::now(),
        navigated_until: Instant::now(),
        note: None,
        held_button: None,
        gesture: Gesture::Turn,
    };
    view.run()
}

fn no_terminal(error: std::io::Error) -> ViewerError {
    ViewerError::NoTerminal(error.to_string())
}

/// What the picture shows: camera, size, the session's revision, and whether it is refined.
type FrameKey = (luxel::scene::Camera, Size, u64, bool);

struct TerminalView<'a> {
    session: Session,
    renderer: &'a Renderer,
    screen: Screen,
    theme: &'static Theme,
    options: &'a TerminalOptions,
    shown: Option<FrameKey>,
    moved_at: Instant,
    /// The time up to which navigation has advanced.
    navigated_until: Instant,
    note: Option<(String, Instant)>,
    held_button: Option<MouseButton>,
    gesture: Gesture,
}

impl TerminalView<'_> {
    fn run(&mut self) -> Result<(), ViewerError> {
        loop {
            self.draw()?;
            let timeout = if self.session.state.is_moving() {
                Duration::from_millis(1)
            } else {
                match self.shown {
                    Some((.., true)) => {
                        self.note.as_ref().map_or(Duration::from_secs(3600), |_| NOTE_DURATION)
                    }
                    _ => REFINE_DELAY.saturating_sub(self.moved_at.elapsed()),
                }
            };
            if crossterm::event::poll(timeout).map_err(no_terminal)? {
                // Handles all pending input before the next picture.
                loop {
                    let input = crossterm::event::read().map_err(no_terminal)?;
                    if self.handle(input) {
                        return Ok(());
                    }
                    if !crossterm::event::poll(Duration::ZERO).map_err(no_terminal)? {
                        break;
                    }
                }
            }
            if self.session.state.is_moving() {
                self.navigate(Event::Wait);
            }
        }
    }

    fn navigate(&mut self, event: Event) {
        let seconds = self.navigated_until.elapsed().as_secs_f64().min(0.25);
        self.navigated_until = Instant::now();
        self.session.navigate(event, seconds);
    }

    /// Brings the picture up to date.
    fn draw(&mut self) -> Result<(), ViewerError> {
        let wanted = (self.session.camera(), self.screen.size(), self.session.revision());
        let is_new =
            self.shown.is_none_or(|(camera, size, revision, _)| (camera, size, revision) != wanted);
        let is_noted = self.note.is_some();
        self.note = self.note.take().filter(|(_, since)| since.elapsed() < NOTE_DURATION);
        if is_new {
            self.moved_at = Instant::now();
        }
        let is_refined = match self.shown {
            None => true,
            _ => !self.session.state.is_moving() && self.moved_at.elapsed() >= REFINE_DELAY,
        };
        let is_due =
            is_new || (is_refined && self.shown.is_some_and(|(.., was_refined)| !was_refined));
        if is_due {
            let mut jobs = self.session.render_jobs();
            if !is_refined {
                for job in &mut jobs {
                    let samples = job.view.samples.min(MOVING_SAMPLES);
                    *job = job.clone().while_moving();
                    job.view.samples = samples;
                }
            }
            let pixels = self.picture(&jobs)?;
            let (camera, size, revision) = wanted;
            self.screen.show(&pixels, size).map_err(no_terminal)?;
            self.shown = Some((camera, size, revision, is_refined));
        }
        if is_due || is_noted {
            let line = self.bottom_line();
            self.screen.write_line(&line).map_err(no_terminal)?;
        }
        Ok(())
    }

    /// Renders the terminal's pixels, 0RGB.
    fn picture(&self, jobs: &[RenderJob]) -> Result<Vec<u32>, ViewerError> {
        let never = AtomicBool::new(false);
        let pictures = jobs.iter().map(|job| job.render(self.renderer, &never));
        let pictures: Result<Vec<_>, _> = pictures.filter_map(Result::transpose).collect();
        let pictures = pictures.map_err(|error| ViewerError::Draw(error.to_string()))?;
        let Some(RenderJob { view, .. }) = jobs.first() else { return Ok(Vec::new()) };
        let size = view.size;
        let mut pixels = vec![0; size.width as usize * size.height as usize];
        match (pictures.as_slice(), self.session.comparison()) {
            ([one, other], Some(comparison)) if comparison.is_difference => {
                compose((&difference_map(one, other).0, size), self.theme, size, &mut pixels);
            }
            ([one, other], Some(_)) => {
                compose((one, size), self.theme, size, &mut pixels);
                let mut right = vec![0; pixels.len()];
                compose((other, size), self.theme, size, &mut right);
                join_columns(&mut pixels, &right, size.width as usize, size.width as usize / 2);
            }
            ([one, ..], _) => compose((one, size), self.theme, size, &mut pixels),
            ([], _) => {}
        }
        if self.session.guides.is_any()
            && let Some(z) = render_depths(self.renderer, view)
        {
            let lines = self.session.guides.lines(&self.session.guide_scene(), self.theme);
            let depths = Depths { z: &z, size };
            draw_lines(&lines, &view.camera, depths, (size, 1.0), &mut pixels);
        }
        Ok(pixels)
    }

    /// The bottom line.
    fn bottom_line(&self) -> String {
        let name = FileList::title(&self.options.file);
        match &self.note {
            Some((note, _)) => format!(" {name}   {note}"),
            None => {
                let keys = &self.options.keys;
                let first = |action| keys.first_of(action);
                format!(
                    " {name}   {} triangles   {}   {}   {} help   {} quit",
                    self.session.model.scene.triangle_count(),
                    self.session.state.mode(),
                    self.session.display().summary(),
                    first(Action::Help),
                    first(Action::Quit),
                )
            }
        }
    }

    /// Handles input; true if the user quits.
    fn handle(&mut self, input: Input) -> bool {
        match input {
            Input::Key(key) if key.kind != KeyEventKind::Release => return self.press(key),
            Input::Mouse(mouse) => self.handle_mouse(mouse),
            Input::Resize(..) => {
                self.screen.update_size();
                self.session.resize(self.screen.size());
                self.shown = None;
            }
            _ => {}
        }
        false
    }

    fn press(&mut self, key: KeyEvent) -> bool {
        // In a terminal Ctrl+C quits, whatever it is bound to.
        if key.code == KeyCode::Char('c') && key.modifiers == KeyModifiers::CONTROL {
            return true;
        }
        let mode = self.session.state.mode();
        let Some(action) = chord(key).and_then(|chord| self.options.keys.action(&chord, mode))
        else {
            return false;
        };
        match action {
            Action::Close => return !self.session.close_innermost(),
            Action::Quit => return true,
            Action::View(view) => self.navigate(Event::View(view)),
            Action::Level => self.navigate(Event::Level),
            Action::Mode(mode) => self.navigate(Event::Mode(mode)),
            Action::NextMode => self.navigate(Event::Mode(next_mode(mode))),
            // Terminals don't report key releases.
            Action::Motion(command) => self.navigate(Event::Tap { command, steps: 1.0 }),
            Action::Fit | Action::FitAll => {
                self.session.fit(WindowPart::whole(self.screen.size()), 0.0);
            }
            Action::ToggleLens => self.session.toggle_lens(0.0),
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
                    of(Action::ToggleGuide(Guide::Grid)),
                    of(Action::Quit),
                );
                self.note = Some((note, Instant::now()));
            }
            other => {
                if !self.session.apply_display_action(other) {
                    let note = "this needs a window: luxel view without --terminal".to_owned();
                    self.note = Some((note, Instant::now()));
                }
            }
        }
        false
    }

    /// Handles the mouse, to a cell's precision.
    fn handle_mouse(&mut self, mouse: MouseEvent) {
        let at = self.screen.cell_centre(mouse.column, mouse.row);
        match mouse.kind {
            MouseEventKind::Down(button) if self.held_button.is_none() => {
                self.gesture = match button {
                    MouseButton::Left if mouse.modifiers.contains(KeyModifiers::SHIFT) => {
                        Gesture::Pan
                    }
                    MouseButton::Left => Gesture::Turn,
                    MouseButton::Middle => Gesture::Pan,
                    MouseButton::Right => Gesture::Zoom,
                };
                self.held_button = Some(button);
                let gesture = self.gesture;
                let point = if gesture == Gesture::Turn { None } else { self.unproject_point(at) };
                self.navigate(Event::Grab { gesture, at, point });
            }
            MouseEventKind::Drag(button) if self.held_button == Some(button) => {
                self.navigate(Event::Drag { at });
            }
            MouseEventKind::Up(button) if self.held_button == Some(button) => {
                self.held_button = None;
                self.navigate(Event::Release);
            }
            MouseEventKind::ScrollUp | MouseEventKind::ScrollDown => {
                let notches = if mouse.kind == MouseEventKind::ScrollUp { 1.0 } else { -1.0 };
                let point = self.unproject_point(at);
                self.navigate(Event::Wheel { notches, at, point });
            }
            _ => {}
        }
    }

    /// The point in world space at a position in the picture.
    fn unproject_point(&self, at: DVec2) -> Option<DVec3> {
        let view = self.session.view();
        let is_in = at.x >= 0.0
            && at.y >= 0.0
            && at.x < f64::from(view.size.width)
            && at.y < f64::from(view.size.height);
        let pixel = is_in.then_some([at.x as u32, at.y as u32])?;
        hit_at_pixel(self.renderer, &view, pixel).map(|hit| hit.point)
    }

    fn screenshot(&self) -> String {
        let pixels = match self.picture(&self.session.render_jobs()) {
            Ok(pixels) => pixels,
            Err(error) => return error.to_string(),
        };
        let encoding = self.session.display().view().encoding;
        let stem = FileList::stem(OsStr::new(&self.options.file));
        let rgba = rgba_of(&pixels);
        save_png(&stem, &rgba, self.screen.size(), encoding, &self.options.write)
            .unwrap_or_else(|what| what)
    }
}

/// The chord of a terminal's key.
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
    fn terminal_keys_are_those_of_the_window() {
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
