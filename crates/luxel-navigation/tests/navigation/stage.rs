//! A camera five units before the origin, and how to play with it.

use glam::{DMat4, DVec2, DVec3};
use luxel_navigation::{Entry, Event, Gesture, Log, Mode, Settings, State, advance};
use luxel_scene::{Bounds, Lens, Projection, Size};

pub(crate) const SIZE: Size = Size { width: 1280, height: 720 };
pub(crate) const LENS: Lens = Lens::Perspective { fov_y_radians: 0.8 };
pub(crate) const MODES: [Mode; 6] = [
    Mode::Absolute,
    Mode::LookAt,
    Mode::RollingBall,
    Mode::Flying,
    Mode::Mouselook,
    Mode::Turntable,
];

pub(crate) fn settings(lens: Lens) -> Settings {
    let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };
    Settings::new(bounds, DVec3::Y, lens, SIZE)
}

/// At (0, 0, 5), looking along -Z, the pivot at the origin.
pub(crate) fn before_origin(mode: Mode) -> State {
    State::new(mode, &DMat4::from_translation(DVec3::new(0.0, 0.0, -5.0)), DVec3::ZERO)
}

/// A camera anywhere, but level.
pub(crate) fn somewhere(mode: Mode) -> State {
    let eye = DVec3::new(2.0, 1.5, 3.5);
    let view = luxel_scene::Camera::look_at(eye, DVec3::new(0.1, 0.2, -0.1), DVec3::Y);
    State::new(mode, &view, DVec3::new(0.1, 0.2, -0.1))
}

/// Plays lines of a log, without its first.
#[track_caller]
pub(crate) fn play(state: State, settings: Settings, lines: &str) -> (State, Settings) {
    let log: Log = format!("luxel-navigation 1\n{lines}").parse().unwrap();
    log.entries
        .iter()
        .fold((state, settings), |(state, settings), entry: &Entry| entry.play(&state, &settings))
}

/// The hand takes hold, goes a way in window pixels, and lets go.
pub(crate) fn pulled(state: State, settings: &Settings, gesture: Gesture, ways: &[DVec2]) -> State {
    let mut at = DVec2::new(640.0, 360.0);
    let mut state = advance(&state, settings, &Event::Grab { gesture, at, point: None }, 0.0);
    for &way in ways {
        at += way;
        state = advance(&state, settings, &Event::Drag { at }, 0.0);
    }
    advance(&state, settings, &Event::Release, 0.0)
}

/// Where a point of the world is seen in the window.
pub(crate) fn seen(state: &State, settings: &Settings, point: DVec3) -> DVec2 {
    let lens = state.lens(settings.lens);
    let projection = Projection { lens, near: 1e-3, far: 1e3 };
    let clip =
        projection.clip_from_view(settings.size) * state.view_from_world() * point.extend(1.0);
    let size = DVec2::new(f64::from(settings.size.width), f64::from(settings.size.height));
    (DVec2::new(clip.x, -clip.y) / clip.w + 1.0) * 0.5 * size
}

#[track_caller]
pub(crate) fn assert_near(found: &DMat4, expected: &DMat4, tolerance: f64) {
    assert!(found.abs_diff_eq(*expected, tolerance), "found {found}\nexpected {expected}");
}

/// How far a view is from a rotation.
pub(crate) fn deviation(state: &State) -> f64 {
    let rotation = glam::DMat3::from_mat4(state.view_from_world());
    let off = rotation * rotation.transpose() - glam::DMat3::IDENTITY;
    let most = off.to_cols_array().into_iter().map(f64::abs).fold(0.0, f64::max);
    most.max((rotation.determinant() - 1.0).abs())
}
