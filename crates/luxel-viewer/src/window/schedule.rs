//! What is rendered when: quick frames while the camera moves, finer ones at rest, explanations after
//! them.

use super::{App, FrameKey, scale_camera};
use crate::render::{FramePurpose, RenderJob, RenderRequest};
use luxel::navigation::{Entry, Event};
use luxel::render::View;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// The time at rest after which the picture is refined.
const REFINE_DELAY: Duration = Duration::from_millis(120);

/// A time longer than any wait in a log.
const MAX_WAIT: Duration = Duration::from_secs(1 << 30);

impl App {
    /// Brings navigation and the requested frame up to date; returns the time of the next update without
    /// an event.
    pub(super) fn update(&mut self) -> Option<Instant> {
        let due = self.advance_replay();
        if self.is_rendering {
            self.interrupt_unwanted();
            return due;
        }
        if self.surface.is_none() {
            return due;
        }
        if self.replay.is_none() && self.session.as_ref().is_some_and(|one| one.state.is_moving()) {
            self.navigate(Event::Wait);
        }
        let session = self.session.as_mut()?;
        let overrides = session.scene_overrides();
        if overrides != self.overrides {
            self.worker.set_overrides(overrides.clone());
            self.overrides = overrides;
            session.changed();
        }
        let view = session.view();
        let wanted = (view.camera, view.size, session.revision());
        if self.wants_screenshot {
            self.wants_screenshot = false;
            let jobs = session.render_jobs();
            self.request_frame(jobs, FramePurpose::Screenshot);
            return due;
        }
        match self.last_request {
            None => {
                let jobs = session.render_jobs();
                self.refine(wanted, jobs);
            }
            Some((last, _)) if last != wanted => {
                self.moved_at = Instant::now();
                self.last_request = Some((wanted, FramePurpose::Interactive));
                let size = self.scaling.interactive_size(view.size);
                let camera = scale_camera(view.camera, view.size, size);
                let jobs = session.render_jobs().into_iter().map(|job| {
                    let mut job = job.while_moving();
                    (job.view.camera, job.view.size) = (camera, size);
                    job
                });
                let jobs = jobs.collect();
                self.request_frame(jobs, FramePurpose::Interactive);
            }
            Some((_, FramePurpose::Interactive)) => {
                let refine_at = self.moved_at + REFINE_DELAY;
                if Instant::now() < refine_at {
                    return Some(due.map_or(refine_at, |due| due.min(refine_at)));
                }
                let jobs = session.render_jobs();
                self.refine(wanted, jobs);
            }
            Some((_, FramePurpose::Refining)) => {
                self.last_request = Some((wanted, FramePurpose::Refined));
                let jobs = session.render_jobs();
                self.request_frame(jobs, FramePurpose::Refined);
            }
            Some((key, FramePurpose::Refined | FramePurpose::Screenshot)) => {
                let selected = session.selection.selected().clone();
                let known = self.frame.as_ref().and_then(|frame| frame.selected.as_ref());
                let is_known = known.is_some_and(|known| known.objects == selected);
                let view = session.view_at(self.pointer.x);
                if !selected.is_empty() && !is_known && !self.is_selecting {
                    self.is_selecting = true;
                    self.worker.select(session.view(), selected);
                }
                self.explain(view, key);
            }
        }
        due
    }

    /// Requests the explanation of the pixel under the pointer, if it is shown.
    fn explain(&mut self, view: View, key: FrameKey) {
        let Some(pixel) = self.pixel_under_pointer().filter(|_| self.ui.panels.shows_explanation())
        else {
            return;
        };
        if self.is_explaining || self.ui.has_pointer() || self.explain_request == Some((key, pixel))
        {
            return;
        }
        self.explain_request = Some((key, pixel));
        self.is_explaining = true;
        self.worker.explain(view, pixel);
    }

    /// Requests the first frame at rest: the full one, unless that takes long.
    fn refine(&mut self, wanted: FrameKey, jobs: Vec<RenderJob>) {
        let (jobs, purpose) = if jobs.iter().any(RenderJob::traces_rays) {
            (jobs.into_iter().map(RenderJob::first).collect(), FramePurpose::Refining)
        } else {
            (jobs, FramePurpose::Refined)
        };
        self.last_request = Some((wanted, purpose));
        self.request_frame(jobs, purpose);
    }

    /// Ends a frame at rest that is being rendered when something else is to be seen.
    fn interrupt_unwanted(&mut self) {
        let Some(session) = &self.session else { return };
        let view = session.view();
        let wanted = (view.camera, view.size, session.revision());
        let is_wanted = self.last_request.is_some_and(|(key, _)| key == wanted);
        if !is_wanted || session.state.is_moving() {
            self.is_interrupted.store(true, Ordering::Relaxed);
        }
    }

    /// Goes on after a frame that was interrupted.
    pub(super) fn interrupted(&mut self) {
        self.is_rendering = false;
        self.moved_at = Instant::now();
        if let Some((_, purpose)) = &mut self.last_request {
            *purpose = FramePurpose::Interactive;
        }
        self.update();
    }

    fn request_frame(&mut self, jobs: Vec<RenderJob>, purpose: FramePurpose) {
        self.is_rendering = true;
        let is_interrupted = Arc::new(AtomicBool::new(false));
        // Others are quick, or wanted in any case.
        if matches!(purpose, FramePurpose::Refining | FramePurpose::Refined) {
            self.is_interrupted = Arc::clone(&is_interrupted);
        }
        let session = self.session.as_ref();
        let selected = session.map(|session| session.selection.selected().clone());
        let selected = selected.unwrap_or_default();
        let needs_depths = session.is_some_and(|session| session.guides.is_any());
        self.worker.render(RenderRequest { jobs, purpose, selected, needs_depths, is_interrupted });
    }

    /// Replays the entries of the log that are due; returns the time of the next one.
    fn advance_replay(&mut self) -> Option<Instant> {
        let (Some(log), Some(session)) = (&self.options.replay, &mut self.session) else {
            return None;
        };
        let (mut next, mut start) = self.replay?;
        let now = Instant::now();
        loop {
            let Some(entry) = log.entries.get(next) else {
                self.replay = None;
                self.navigated_until = now;
                return None;
            };
            let due = start + duration_of(entry);
            if due > now {
                self.replay = Some((next, start));
                return Some(due);
            }
            session.play(entry);
            (next, start) = (next + 1, due);
        }
    }
}

/// The time that an entry of a log takes.
fn duration_of(entry: &Entry) -> Duration {
    match entry {
        Entry::Set(_) => Duration::ZERO,
        Entry::Event { seconds, .. } => Duration::try_from_secs_f64(*seconds).unwrap_or(MAX_WAIT),
    }
}
