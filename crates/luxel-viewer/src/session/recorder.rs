//! Records the session's log.

use luxel::navigation::{Change, Entry, Event, Log, Settings, State};

/// Records every event with its time, so that a replay is bit-identical.
#[derive(Debug, Default)]
pub(crate) struct Recorder {
    log: Option<Log>,
}

impl Recorder {
    /// Starts with the present settings and state.
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

    pub(crate) fn record(&mut self, entry: Entry) {
        if let Some(log) = &mut self.log {
            log.entries.push(entry);
        }
    }

    /// The log's text, if a log is recorded.
    pub(crate) fn text(&self) -> Option<String> {
        self.log.as_ref().map(ToString::to_string)
    }
}
