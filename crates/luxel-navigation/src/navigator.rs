//! One step of navigation.

use crate::event::Event;
use crate::gestures;
use crate::modes;
use crate::motion::Rigid;
use crate::place::Place;
use crate::settings::{Number, Settings};
use crate::state::{Drives, State};
use crate::transition::Transition;
use crate::views;

/// Advances the state by a time, then handles an event.
///
/// A pure function: equal arguments give equal bits on every machine. It never fails: events with
/// non-finite numbers or results have no effect, nor do negative or non-finite times.
///
/// ```
/// use luxel_navigation::{Event, Gesture, Mode, Settings, State, advance};
/// use luxel_scene::{Bounds, DMat4, DVec2, DVec3, Lens, Size};
///
/// let bounds = Bounds { min: DVec3::NEG_ONE, max: DVec3::ONE };
/// let lens = Lens::Perspective { fov_y_radians: 0.8 };
/// let settings = Settings::new(bounds, DVec3::Y, lens, Size { width: 1280, height: 720 });
/// let start = DMat4::from_translation(DVec3::new(0.0, 0.0, -4.0));
/// let mut state = State::new(Mode::RollingBall, &start, bounds.centre());
///
/// let at = DVec2::new(640.0, 360.0);
/// let grab = Event::Grab { gesture: Gesture::Turn, at, point: None };
/// for event in [grab, Event::Drag { at: at + DVec2::X * 100.0 }, Event::Release] {
///     state = advance(&state, &settings, &event, 0.0);
/// }
/// // The ball has a radius of 0.4 * 720 pixels.
/// let eye = state.eye();
/// assert!((eye.x / eye.z + (100.0_f64 / 288.0).tan()).abs() < 1e-12);
/// ```
#[must_use]
pub fn advance(state: &State, settings: &Settings, event: &Event, seconds: f64) -> State {
    let passed = valid_or(advance_time(*state, settings, seconds), state);
    if !event.is_valid() {
        return passed;
    }
    valid_or(handle(passed, settings, event), &passed)
}

/// The state if it is valid, else the previous one.
fn valid_or(state: State, before: &State) -> State {
    let Place { view, pivot, scale } = state.place;
    let is_valid = view.is_finite() && pivot.is_finite() && scale.is_finite() && scale > 0.0;
    if is_valid { state } else { *before }
}

/// Advances held keys, transition and inertia.
fn advance_time(mut state: State, settings: &Settings, seconds: f64) -> State {
    if !(seconds > 0.0 && seconds.is_finite()) {
        return state;
    }
    if let Some(hold) = &mut state.hold {
        hold.pending.1 += seconds;
    }
    if let Some(transition) = state.transition {
        (state.place, state.transition) = transition.later(seconds);
    }
    let drives = state.held.drives().scaled(
        settings.number(Number::MoveRate) * seconds,
        settings.number(Number::TurnRate) * seconds,
        settings.number(Number::ThrottleRate) * seconds,
    );
    if drives != Drives::default() || state.speed != 0.0 {
        state = modes::drive(state.settled(), settings, &drives, seconds);
    }
    gestures::glide(state, settings, seconds)
}

/// Handles an event. Camera motion starts from the end of a transition in progress.
fn handle(state: State, settings: &Settings, event: &Event) -> State {
    let settled = state.settled();
    match *event {
        Event::Wait => state,
        Event::Lift(command) => {
            let mut state = state;
            state.held.set(command, false);
            state
        }
        Event::Press(command) => {
            let mut state = settled;
            state.held.set(command, true);
            state
        }
        Event::Tap { command, steps } => {
            let mut drives = Drives::default();
            drives.add(command, steps);
            let drives = drives.scaled(
                settings.number(Number::MoveStep),
                settings.number(Number::TurnStep),
                settings.number(Number::ThrottleStep),
            );
            modes::drive(settled, settings, &drives, 0.0)
        }
        Event::Grab { gesture, at, point } => gestures::grab(settled, gesture, at, point),
        Event::Drag { at } => gestures::drag(state, settings, at),
        Event::Release => gestures::release(state, settings),
        Event::Wheel { notches, at, point } => {
            gestures::wheel(settled, settings, notches, at, point)
        }
        Event::Mode(mode) => {
            let entered = State { mode, ..settled.at_rest() };
            start_transition(&state, entered, settings, modes::entered(&entered, settings))
        }
        Event::Pivot(pivot) => State { place: Place { pivot, ..settled.place }, ..settled },
        Event::View(view) => {
            let goal = views::standard(&settled, settings, view);
            start_transition(&state, settled, settings, goal)
        }
        Event::Fit(bounds) => {
            let bounds = bounds.unwrap_or(settings.bounds);
            start_transition(&state, settled, settings, views::fitted(&settled, settings, &bounds))
        }
        Event::Level => {
            start_transition(&state, settled, settings, modes::level(&settled.place, settings))
        }
        Event::Go { view_from_world, pivot, scale } => {
            let goal = Place { view: Rigid::from_matrix(&view_from_world), pivot, scale };
            start_transition(&state, settled, settings, goal)
        }
        Event::Place(view_from_world) => {
            let view = Rigid::from_matrix(&view_from_world);
            let pivot = settled.place.pivot;
            State { place: Place { view, pivot, scale: 1.0 }, ..settled.at_rest() }
        }
    }
}

/// Starts a transition from the pose shown now.
fn start_transition(shown: &State, settled: State, settings: &Settings, goal: Place) -> State {
    let from = shown.place;
    let arrived = State { place: goal, glide: None, transition: None, ..settled };
    let duration = settings.number(Number::Transition);
    if duration == 0.0 || from == goal {
        return arrived;
    }
    let transition = Some(Transition::new(from, goal, duration));
    State { place: from, transition, ..arrived }
}

impl State {
    /// The state without motion.
    fn at_rest(self) -> Self {
        let place = self.place;
        Self { place, ..Self::new(self.mode, &place.view.to_matrix(), place.pivot) }
    }
}
