//! A log of what is done in the window.

use luxel::navigation::{Change, Entry, Event, Log, Settings, State};

/// Keeps every event with its time, so that the log plays back to the same bits.
#[derive(Debug, Default)]
pub(crate) struct Recorder {
    log: Option<Log>,
}

impl Recorder {
    /// Begins with what the settings and the state are.
    pub(crate) fn start(settings: &Settings, state: &State) -> Self {
        let mut entries: Vec<_> = Change::all_of(settings).map(Entry::Set).collect();
        let event = |event| Entry::Event { seconds: 0.0, event };
        entries.extend([
            event(Event::Mode(state.mode())),
            event(Event::Place(state.view_from_world())),
            event(Event::Pivot(state.pivot())),
        ]);
        Self { log: Some(Log { entries }) }
    }

    pub(crate) fn keep(&mut self, entry: Entry) {
        if let Some(log) = &mut self.log {
            log.entries.push(entry);
        }
    }

    /// The text, if there is one.
    pub(crate) fn text(&self) -> Option<String> {
        self.log.as_ref().map(ToString::to_string)
    }
}
