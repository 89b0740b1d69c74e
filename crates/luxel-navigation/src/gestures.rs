//! Pointer gestures: turn, pan, zoom, the wheel, and inertia.

use crate::event::Gesture;
use crate::modes;
use crate::motion::Rigid;
use crate::settings::{Number, Settings};
use crate::state::{ActiveGesture, Glide, State};
use crate::window::{point_at, upwards};
use glam::{DVec2, DVec3};
use luxel_scene::Lens;

/// The time constant of velocity smoothing, in seconds.
const SMOOTHING: f64 = 0.04;
/// The pointer speed below which inertia stops, in pixels per second.
const MIN_GLIDE_SPEED: f64 = 2.0;
/// The range of distances of the eye from the zoomed point, in radii of the scene.
const MIN_DISTANCE: f64 = 1e-6;
const MAX_DISTANCE: f64 = 1e6;

pub(crate) fn grab(mut state: State, gesture: Gesture, at: DVec2, point: Option<DVec3>) -> State {
    let depth = depth_of(&state, point);
    let still = DVec2::ZERO;
    state.glide = None;
    state.hold = Some(ActiveGesture {
        gesture,
        start: at,
        at,
        depth,
        velocity: still,
        pending: (still, 0.0),
    });
    state
}

pub(crate) fn drag(mut state: State, settings: &Settings, to: DVec2) -> State {
    let Some(mut hold) = state.hold else { return state };
    let from = std::mem::replace(&mut hold.at, to);
    hold.pending.0 += to - from;
    hold.update_velocity();
    match hold.gesture {
        Gesture::Turn => state = modes::turn(state, settings, upwards(to - from)),
        Gesture::Pan => state = pan(state, settings, from, to, hold.depth),
        Gesture::Zoom => {
            let way = upwards(to - from).y * settings.number(Number::ZoomRate);
            let before = hold.depth;
            let zoomed = zoom(state, settings, libm::exp(-way), hold.start, before);
            (state, hold.depth) = zoomed;
        }
    }
    state.hold = Some(hold);
    state
}

pub(crate) fn release(mut state: State, settings: &Settings) -> State {
    let Some(mut hold) = state.hold.take() else { return state };
    hold.update_velocity();
    let goes_on = settings.number(Number::Inertia) > 0.0
        && hold.gesture != Gesture::Zoom
        && hold.velocity.length() > MIN_GLIDE_SPEED;
    state.glide = goes_on.then_some(Glide {
        gesture: hold.gesture,
        depth: hold.depth,
        velocity: hold.velocity,
    });
    state
}

/// Inertia after a gesture: with initial velocity v and time constant T, a displacement of
/// v T (1 - exp(-t / T)).
pub(crate) fn glide(mut state: State, settings: &Settings, seconds: f64) -> State {
    let Some(glide) = state.glide.take() else { return state };
    let time = settings.number(Number::Inertia);
    if time <= 0.0 {
        return state;
    }
    let left = libm::exp(-seconds / time);
    let way = glide.velocity * (time * -libm::expm1(-seconds / time));
    let mut state = match glide.gesture {
        Gesture::Turn => modes::turn(state, settings, upwards(way)),
        Gesture::Pan => pan(state, settings, DVec2::ZERO, way, glide.depth),
        Gesture::Zoom => state,
    };
    let velocity = glide.velocity * left;
    state.glide = (velocity.length() > MIN_GLIDE_SPEED).then_some(Glide { velocity, ..glide });
    state
}

pub(crate) fn wheel(
    state: State,
    settings: &Settings,
    notches: f64,
    at: DVec2,
    point: Option<DVec3>,
) -> State {
    let depth = depth_of(&state, point);
    let factor = libm::pow(settings.number(Number::WheelFactor), -notches);
    zoom(state, settings, factor, at, depth).0
}

/// The depth of the grabbed point, or of the pivot without one.
fn depth_of(state: &State, point: Option<DVec3>) -> f64 {
    let of_point = point.map(|point| state.depth_of(point));
    of_point.filter(|depth| *depth > 0.0).unwrap_or_else(|| state.pivot_depth())
}

/// Moves the camera parallel to the picture, so that the point at one window position and depth moves to
/// another. The pivot keeps its position in the picture.
fn pan(mut state: State, settings: &Settings, from: DVec2, to: DVec2, depth: f64) -> State {
    let lens = state.lens(settings.lens);
    let place = |at| point_at(lens, settings.size, at, depth);
    let shift = place(to) - place(from);
    state.place.pivot -= state.place.view.rotation.transpose() * shift;
    state.moved(Rigid::shift(shift))
}

/// Scales the depth of the point at a window position by a factor, along its ray, so that it keeps its
/// position; also returns the new depth.
///
/// The pivot keeps its position in the picture and its distance from the zoomed point. For orthographic
/// cameras the scale of the height changes by the same factor.
fn zoom(state: State, settings: &Settings, factor: f64, at: DVec2, depth: f64) -> (State, f64) {
    let radius = settings.bounds.radius();
    let reach = if radius > 0.0 && radius.is_finite() { radius } else { 1.0 };
    let is_parallel = matches!(settings.lens, Lens::Orthographic { .. });
    let (lowest, highest) = (MIN_DISTANCE * reach, MAX_DISTANCE * reach);
    let after = (depth * factor).clamp(lowest.min(depth), highest.max(depth));
    let mut factor = after / depth;
    if is_parallel {
        // Scales stay within the same range, however many zooms accumulate.
        let scale = state.place.scale;
        factor = (scale * factor).clamp(MIN_DISTANCE.min(scale), MAX_DISTANCE.max(scale)) / scale;
    }
    let lens = state.lens(settings.lens);
    let shift = point_at(lens, settings.size, at, depth) * (factor - 1.0);
    let mut state = state;
    let pivot_in_view = state.place.view.apply(state.place.pivot);
    state = state.moved(Rigid::shift(shift));
    if is_parallel {
        state.place.scale *= factor;
    }
    // The pivot ahead stays in place in the world unless the eye would pass it.
    let depth = depth * factor;
    let ahead = -(pivot_in_view.z + shift.z);
    let was_ahead = pivot_in_view.z < 0.0;
    let ahead = if was_ahead && ahead < MIN_DISTANCE * reach { depth } else { ahead };
    state.place.pivot = state.place.view.undo(pivot_in_view.with_z(-ahead));
    (state, depth)
}

impl ActiveGesture {
    /// Updates the smoothed velocity, once time has passed.
    fn update_velocity(&mut self) {
        let (way, seconds) = self.pending;
        if seconds > 0.0 {
            let weight = -libm::expm1(-seconds / SMOOTHING);
            self.velocity += (way / seconds - self.velocity) * weight;
            self.pending = (DVec2::ZERO, 0.0);
        }
    }
}
