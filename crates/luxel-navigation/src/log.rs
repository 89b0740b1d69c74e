//! Logs: events as lines of text that play back to the same bits.
//!
//! The first line is `luxel-navigation 1`. After it, a line each, come settings and events; empty
//! lines, and everything from `#` on, are comments. An event's line may begin with the seconds that
//! have passed since the one before. Numbers are written so that they read back to the same bits.
//!
//! ```text
//! luxel-navigation 1
//! set size 1280 720
//! mode rolling-ball
//! grab turn 640 360
//! +0.016 drag 652.5 360
//! release
//! ```

mod read;
mod write;

use crate::event::Event;
use crate::navigator::advance;
use crate::settings::{Number, Settings};
use crate::state::State;
use glam::DVec3;
use luxel_scene::{Bounds, Lens, Size};
pub use read::{LogError, LogErrorKind};

/// The version of the format that is written, and the only one that is read.
pub const LOG_VERSION: u32 = 1;

/// The first word of a log.
const NAME: &str = "luxel-navigation";

/// A log: what was set and what happened, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// The lines that say something.
    pub entries: Vec<Entry>,
}

/// A line of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// The host or the user has set something; no time passes.
    Set(Change),
    /// Some seconds have passed, then something has happened.
    Event {
        /// The seconds, at least 0.
        seconds: f64,
        /// What has happened.
        event: Event,
    },
}

/// A change of the settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The window's size in pixels.
    Size(Size),
    /// The lens.
    Lens(Lens),
    /// What is up.
    Up(DVec3),
    /// The bounds of the scene.
    Bounds(Bounds),
    /// A number.
    Number(Number, f64),
}

impl Change {
    /// The settings with the change.
    #[must_use]
    pub fn apply(&self, settings: &Settings) -> Settings {
        match *self {
            Self::Size(size) => Settings { size, ..*settings },
            Self::Lens(lens) => Settings { lens, ..*settings },
            Self::Up(up) => Settings { up, ..*settings },
            Self::Bounds(bounds) => Settings { bounds, ..*settings },
            Self::Number(number, value) => settings.with(number, value),
        }
    }

    /// Everything that settings say, as changes: with them a log begins that is to play back to the
    /// same bits wherever it is played.
    pub fn all_of(settings: &Settings) -> impl Iterator<Item = Self> + use<> {
        let Settings { size, lens, up, bounds, .. } = *settings;
        let bounds = (!bounds.is_empty()).then_some(Self::Bounds(bounds));
        let settings = *settings;
        let numbers = Number::ALL.iter();
        [Self::Size(size), Self::Lens(lens), Self::Up(up)]
            .into_iter()
            .chain(bounds)
            .chain(numbers.map(move |&number| Self::Number(number, settings.number(number))))
    }
}

impl Entry {
    /// State and settings after the entry.
    #[must_use]
    pub fn play(&self, state: &State, settings: &Settings) -> (State, Settings) {
        match self {
            Self::Set(change) => (*state, change.apply(settings)),
            Self::Event { seconds, event } => {
                (advance(state, settings, event, *seconds), *settings)
            }
        }
    }
}
