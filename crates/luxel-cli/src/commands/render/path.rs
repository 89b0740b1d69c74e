//! Cameras along a path: renders a log of events.

use crate::camera;
use crate::failure::Failure;
use crate::navigation;
use crate::options::{ExecutionOptions, FrameOptions};
use crate::values::positive;
use clap::Args;
use luxel::navigation::{Entry, Event, Mode, Settings, State, advance};
use luxel::scene::{Camera, Scene};
use std::ffi::OsString;

/// The path and its frame rate.
#[derive(Args, Clone, Debug)]
pub(super) struct PathOptions {
    /// Replay a log of events, like `luxel navigate`, and render an image after each, into
    /// numbered files, such as frame_{n:4}.png
    #[arg(long, value_name = "FILE", conflicts_with = "turntable")]
    path: Option<OsString>,

    /// With --path: images per second of log time, instead of one after each event
    #[arg(long, value_name = "N", value_parser = positive, allow_hyphen_values = true)]
    #[arg(requires = "path")]
    fps: Option<f64>,
}

/// Maximum images of one path: more than four hours at 60 per second.
const MAX_FRAMES: usize = 1_000_000;

impl PathOptions {
    pub(super) fn is_given(&self) -> bool {
        self.path.is_some()
    }

    /// The cameras along the path, if there is one.
    ///
    /// # Errors
    /// [`Failure`] if the log can't be read, or gives no images or too many.
    pub(super) fn cameras(
        &self,
        frame: &FrameOptions,
        execution: &ExecutionOptions,
        scene: &Scene,
    ) -> Result<Option<Vec<Camera>>, Failure> {
        let Some(path) = &self.path else { return Ok(None) };
        let (log, _) = navigation::read_log(path, execution.max_memory)?;
        let (state, settings, _) = navigation::start(frame, scene, Mode::default())?;
        let moments = match self.fps {
            None => after_events(state, settings, &log.entries),
            Some(fps) => at_rate(state, settings, &log.entries, fps),
        };
        if moments.is_empty() {
            let remedy = "docs/navigation.md describes the log format";
            return Err(Failure::work(format!("{}: no events", path.to_string_lossy()), remedy));
        }
        if moments.len() > MAX_FRAMES {
            let what = format!("{}: more than {MAX_FRAMES} images", path.to_string_lossy());
            return Err(Failure::work(what, "use a lower --fps, or shorten the log"));
        }
        let bounds = scene.bounds();
        let camera = |(state, settings): &(State, Settings)| {
            let lens = state.lens(settings.lens);
            camera::with_planes(frame, &bounds, state.view_from_world(), lens)
        };
        moments.iter().map(camera).collect::<Result<_, _>>().map(Some)
    }
}

/// The camera after each event.
fn after_events(
    mut state: State,
    mut settings: Settings,
    entries: &[Entry],
) -> Vec<(State, Settings)> {
    let mut moments = Vec::new();
    for entry in entries {
        (state, settings) = entry.play(&state, &settings);
        if let Entry::Event { .. } = entry {
            moments.push((state, settings));
        }
        if moments.len() > MAX_FRAMES {
            break;
        }
    }
    moments
}

/// The cameras at times 0, 1 / fps, 2 / fps, ... until the last event, including events at exactly
/// that time. Times between events are evaluated on a copy, so that they don't change the
/// state after later events.
fn at_rate(
    mut state: State,
    mut settings: Settings,
    entries: &[Entry],
    fps: f64,
) -> Vec<(State, Settings)> {
    let mut moments = Vec::new();
    let mut now = 0.0;
    for entry in entries {
        if let Entry::Event { seconds, .. } = entry {
            let then = now + seconds;
            while (moments.len() as f64) / fps < then && moments.len() <= MAX_FRAMES {
                let part = moments.len() as f64 / fps - now;
                moments.push((advance(&state, &settings, &Event::Wait, part), settings));
            }
            now = then;
        }
        (state, settings) = entry.play(&state, &settings);
    }
    moments.push((state, settings));
    moments
}
