//! Which file the window shows: the first, another one, the same again when it has changed.

use super::App;
use crate::files::{Files, Watch};
use crate::model::Model;
use crate::screen::Screen;
use crate::session::Session;
use crate::worker::Changes;
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
        if self.reading.is_some() || self.playing.is_some() {
            return;
        }
        if self.files.step(is_forward) {
            self.read(Reading::Other);
        } else {
            self.note("there is no other file: drop one here, or name several".to_owned());
        }
    }

    /// A file was dropped onto the window.
    pub(super) fn drop_file(&mut self, path: PathBuf) {
        if self.playing.is_some() {
            return;
        }
        self.files.add(path.into());
        if self.reading.is_none() {
            self.read(Reading::Other);
        }
    }

    fn read(&mut self, reading: Reading) {
        self.reading = Some(reading);
        let name = self.files.asked().to_owned();
        // As it is before it is read: whatever changes meanwhile is seen afterwards.
        self.coming = Watch::of(&name);
        self.status.reading = Some(Files::title(&name));
        self.requested = name.clone();
        self.worker.load(name);
        self.redraw();
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
    pub(super) fn loaded(&mut self, model: Model) {
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
        let wanted = self.files.asked() != self.requested;
        if !wanted {
            self.files.arrived();
        }
        self.watched = std::mem::take(&mut self.coming);
        self.next_look = Instant::now() + LOOKS;
        self.status.name = Files::title(&self.requested);
        self.status.place = self.files.place();
        self.stem = Files::stem(&self.requested);
        if let Some(screen) = &self.screen {
            screen.window.set_title(&format!("{} - luxel", self.status.name));
        }
        // What was known of the last scene.
        self.changes = Changes::default();
        (self.asked, self.under, self.explained) = (None, None, None);
        self.ui.explanation = None;
        if let Some(shown) = &mut self.shown {
            shown.seen = None;
        }
        self.redraw();
        // Something else was dropped meanwhile.
        if wanted {
            self.read(Reading::Other);
        }
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
        if self.files.asked() != self.requested {
            self.read(Reading::Other);
        }
        true
    }
}
