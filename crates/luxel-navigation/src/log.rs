//! Logs: events as lines of text that replay bit-identically.
//!
//! The first line is `luxel-navigation 1`. Settings and events follow, one per line; empty lines and
//! everything from `#` on are comments. An event's line may start with the seconds since the previous
//! one. Numbers are written so that they read back to the same bits.
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

/// The version of the format.
pub const LOG_VERSION: u32 = 1;

/// The first word of a log.
const NAME: &str = "luxel-navigation";

/// A log: changes of settings and events, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Log {
    /// The lines without comments.
    pub entries: Vec<Entry>,
}

/// A line of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// A change of settings; no time passes.
    Set(Change),
    /// An event after some seconds.
    Event {
        /// The seconds, at least 0.
        seconds: f64,
        /// The event.
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
    /// The up direction.
    Up(DVec3),
    /// The bounds of the scene.
    Bounds(Bounds),
    /// A number.
    Number(Number, f64),
}

impl Change {
    /// Applies the change.
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

    /// All settings as changes: the beginning of a log that replays bit-identically anywhere.
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
