//! Any text as a log of events.

use luxel_navigation::{Log, Mode, Settings, State};
use luxel_scene::{Bounds, DMat4, DVec3, Lens, Size};

/// What is read is written so that it reads back to the same bits, and replays without a panic.
pub(crate) fn event_log(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Ok(log) = text.parse::<Log>() else { return };
    let written = log.to_string();
    let again: Log = written.parse().expect("a log that was written is read");
    assert_eq!(written, again.to_string());
    let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let mut settings = Settings::new(bounds, DVec3::Y, lens, Size { width: 640, height: 480 });
    let eye = DMat4::from_translation(DVec3::new(0.0, 0.0, -5.0));
    let mut state = State::new(Mode::Turntable, &eye, DVec3::ZERO);
    for entry in &log.entries {
        (state, settings) = entry.play(&state, &settings);
    }
}
