//! Loading of files: the first, others, and new versions of the file on display.

use super::App;
use super::surface::WindowSurface;
use crate::keys::Action;
use crate::model::{FileList, FileWatch, WELCOME};
use crate::options::ViewerError;
use crate::render::{LoadedModel, SceneOverrides};
use crate::session::Session;
use crate::ui::PendingModel;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// The interval between polls of a file.
const POLL_INTERVAL: Duration = Duration::from_millis(300);

/// Why a file is being loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum LoadReason {
    /// It is the first file.
    First,
    /// Another file was requested.
    Other,
    /// The file has changed.
    Reload,
}

impl App {
    /// Opens the next or previous file.
    pub(super) fn step_file(&mut self, is_forward: bool) {
        if self.replay.is_some() {
            return;
        }
        if self.files.step(is_forward) {
            self.load(LoadReason::Other);
        } else {
            let open = self.ui.keys.first_of(Action::Open);
            self.note(format!("there is no other file: drop one here, or press {open}"));
        }
    }

    /// Opens a file that was dropped on the window or chosen in its dialog.
    pub(super) fn open(&mut self, path: PathBuf) {
        if self.replay.is_some() {
            return;
        }
        self.files.add(path.into());
        self.load(LoadReason::Other);
    }

    fn load(&mut self, reason: LoadReason) {
        let name = self.files.requested().to_owned();
        // The state before loading: changes during loading are noticed afterwards.
        self.requested_watch = FileWatch::of(&name);
        self.requested_file = name.clone();
        if let Err(error) = self.worker.load(name.clone()) {
            self.load_reason = None;
            self.status.loading = None;
            self.note(ViewerError::from(error).to_string());
            return;
        }
        self.load_reason = Some(reason);
        let progress = self.worker.progress().clone();
        self.status.loading = Some(PendingModel::new(FileList::title(&name), progress));
        self.redraw();
    }

    /// Cancels loading; the display stays.
    pub(super) fn stop_loading(&mut self) {
        let Some(reason) = self.load_reason.take() else { return };
        self.worker.cancel_loading();
        self.status.loading = None;
        let name = FileList::title(&self.requested_file);
        if reason == LoadReason::Reload {
            // Loaded when it changes again.
            self.shown_watch = std::mem::take(&mut self.requested_watch);
        }
        if self.session.is_some() {
            self.files.request_shown();
        }
        self.note(format!("{name} is not read any further"));
    }

    /// Polls the file on display for changes; returns the time of the next poll.
    pub(super) fn poll_file(&mut self) -> Option<Instant> {
        if !self.shown_watch.is_needed() || self.load_reason.is_some() || self.replay.is_some() {
            return None;
        }
        let now = Instant::now();
        if self.next_poll <= now {
            self.next_poll = now + POLL_INTERVAL;
            if self.shown_watch.poll() {
                self.files.request_shown();
                self.load(LoadReason::Reload);
                return None;
            }
        }
        Some(self.next_poll)
    }

    /// Shows a loaded model.
    pub(super) fn load_finished(&mut self, loaded: LoadedModel) {
        self.model_number = self.worker.requested();
        let mut model = self.worker.show(loaded);
        let part = self.free_part();
        let reason = self.load_reason.take().unwrap_or(LoadReason::Other);
        self.status.loading = None;
        if let Some(note) = model.exposure_note.take() {
            self.note(note);
        }
        self.status.triangles = model.scene.triangle_count();
        match (&mut self.session, reason) {
            (Some(session), LoadReason::Reload) => session.reload(model),
            (session, _) => {
                let size = self.surface.as_ref().map_or(self.options.size, WindowSurface::size);
                model.fit_into(part, size);
                let records = self.options.record.is_some();
                let mode = session.as_ref().map_or(self.options.mode, |one| one.state.mode());
                let mut other = Session::new(model, size, mode, records);
                if let Some(session) = session {
                    other.copy_display_from(session);
                }
                *session = Some(other);
                self.navigated_until = Instant::now();
            }
        }
        if reason == LoadReason::First {
            self.replay = self.options.replay.as_ref().map(|_| (0, self.navigated_until));
        }
        self.files.set_shown();
        self.shown_watch = std::mem::take(&mut self.requested_watch);
        self.next_poll = Instant::now() + POLL_INTERVAL;
        self.status.name = FileList::title(&self.requested_file);
        self.status.is_chosen = self.requested_file != WELCOME.0;
        self.status.position = self.files.position();
        self.stem = FileList::stem(&self.requested_file);
        if let Some(surface) = &self.surface {
            surface.window.set_title(&format!("{} - luxel", self.status.name));
        }
        // Drops everything known of the last scene.
        self.overrides = SceneOverrides::default();
        (self.last_request, self.pointer_hit, self.explain_request) = (None, None, None);
        self.ui.panels.set_explanation(None);
        if let Some(frame) = &mut self.frame {
            (frame.visible, frame.selected) = (None, None);
        }
        self.redraw();
    }

    /// Reports a file that failed to load; false if there is nothing else to show.
    pub(super) fn load_failed(&mut self, what: String) -> bool {
        let was_first = self.load_reason.take() == Some(LoadReason::First);
        if was_first {
            return false;
        }
        self.status.loading = None;
        // A new version of the file may load.
        if self.requested_file == self.files.shown() {
            self.shown_watch = std::mem::take(&mut self.requested_watch);
        }
        self.note(what);
        true
    }
}
