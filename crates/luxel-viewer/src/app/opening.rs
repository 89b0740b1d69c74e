//! Which file the window shows: the first, another one, the same again when it has changed.

use super::App;
use crate::app::ViewerError;
use crate::files::{Files, WELCOME, Watch};
use crate::keys::Action;
use crate::screen::Screen;
use crate::session::Session;
use crate::ui::OnItsWay;
use crate::worker::{Changes, Ready};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How often a file is looked at.
const LOOKS: Duration = Duration::from_millis(300);

/// Why a file is being read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Reading {
    /// It is the first one.
    First,
    /// Another one is asked for.
    Other,
    /// It has changed.
    Again,
}

impl App {
    /// Asks for the next file, or the one before.
    pub(super) fn step(&mut self, is_forward: bool) {
        if self.playing.is_some() {
            return;
        }
        if self.files.step(is_forward) {
            self.read(Reading::Other);
        } else {
            let open = self.ui.keys.first_of(Action::Open);
            self.note(format!("there is no other file: drop one here, or press {open}"));
        }
    }

    /// A file was dropped onto the window, or named in it.
    pub(super) fn open(&mut self, path: PathBuf) {
        if self.playing.is_some() {
            return;
        }
        self.files.add(path.into());
        self.read(Reading::Other);
    }

    fn read(&mut self, reading: Reading) {
        let name = self.files.asked().to_owned();
        // As it is before it is read: whatever changes meanwhile is seen afterwards.
        self.coming = Watch::of(&name);
        self.requested = name.clone();
        if let Err(error) = self.worker.load(name.clone()) {
            self.reading = None;
            self.status.reading = None;
            self.note(ViewerError::from(error).to_string());
            return;
        }
        self.reading = Some(reading);
        let loading = self.worker.loading().clone();
        self.status.reading = Some(OnItsWay::new(Files::title(&name), loading));
        self.redraw();
    }

    /// What is being read is not wanted any more; what was seen stays.
    pub(super) fn stop_reading(&mut self) {
        let Some(reading) = self.reading.take() else { return };
        self.worker.stop();
        self.status.reading = None;
        let name = Files::title(&self.requested);
        if reading == Reading::Again {
            // Until it changes again.
            self.watched = std::mem::take(&mut self.coming);
        }
        if self.session.is_some() {
            self.files.again();
        }
        self.note(format!("{name} is not read any further"));
    }

    /// Looks whether the file has changed, now and then; when to do so again.
    pub(super) fn watch(&mut self) -> Option<Instant> {
        if !self.watched.is_needed() || self.reading.is_some() || self.playing.is_some() {
            return None;
        }
        let now = Instant::now();
        if self.next_look <= now {
            self.next_look = now + LOOKS;
            if self.watched.look() {
                self.files.again();
                self.read(Reading::Again);
                return None;
            }
        }
        Some(self.next_look)
    }

    /// A file has been read.
    pub(super) fn loaded(&mut self, ready: Ready) {
        self.number = self.worker.asked();
        let model = self.worker.show(ready);
        let reading = self.reading.take().unwrap_or(Reading::Other);
        self.status.reading = None;
        self.status.triangles = model.scene.triangle_count();
        match (&mut self.session, reading) {
            (Some(session), Reading::Again) => session.reload(model),
            (session, _) => {
                let size = self.screen.as_ref().map_or(self.options.size, Screen::size);
                let records = self.options.record.is_some();
                let mode = session.as_ref().map_or(self.options.mode, |one| one.state.mode());

                let mut other = Session::new(model, size, mode, records);
                if let Some(session) = session {
                    other.look_like(session);
                }
                *session = Some(other);
                self.now = Instant::now();
            }
        }
        if reading == Reading::First {
            self.playing = self.options.replay.as_ref().map(|_| (0, self.now));
        }
        self.files.arrived();
        self.watched = std::mem::take(&mut self.coming);
        self.next_look = Instant::now() + LOOKS;
        self.status.name = Files::title(&self.requested);
        self.status.is_chosen = self.requested != WELCOME.0;
        self.status.place = self.files.place();
        self.stem = Files::stem(&self.requested);
        if let Some(screen) = &self.screen {
            screen.window.set_title(&format!("{} - luxel", self.status.name));
        }
        // What was known of the last scene.
        self.changes = Changes::default();
        (self.asked, self.under, self.explained) = (None, None, None);
        (self.ui.explanation, self.ui.equation) = (None, None);
        if let Some(shown) = &mut self.shown {
            shown.seen = None;
        }
        self.redraw();
    }

    /// A file can't be read; whether there is still something to look at.
    pub(super) fn not_loaded(&mut self, what: String) -> bool {
        let was_first = self.reading.take() == Some(Reading::First);
        if was_first {
            return false;
        }
        self.status.reading = None;
        // It may be put right.
        if self.requested == self.files.seen() {
            self.watched = std::mem::take(&mut self.coming);
        }
        self.note(what);
        true
    }
}
