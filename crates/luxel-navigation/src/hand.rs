//! The hand: what it grabs, where it drags it, and what goes on when it lets go.

use crate::event::Gesture;
use crate::modes;
use crate::motion::Rigid;
use crate::settings::{Number, Settings};
use crate::state::{Glide, Hold, State};
use crate::window::{point_at, upwards};
use glam::{DVec2, DVec3};
use luxel_scene::Lens;

/// Seconds over which the hand's velocity is smoothed.
const SMOOTHING: f64 = 0.04;
/// Pixels a second below which motion has come to rest.
const AT_REST: f64 = 2.0;
/// How near to what is zoomed to, and how far from it, in radii of the scene, the eye may come.
const NEAREST: f64 = 1e-6;
const FARTHEST: f64 = 1e6;

pub(crate) fn grab(mut state: State, gesture: Gesture, at: DVec2, point: Option<DVec3>) -> State {
    let depth = depth_of(&state, point);
    let still = DVec2::ZERO;
    state.glide = None;
    state.hold =
        Some(Hold { gesture, start: at, at, depth, velocity: still, pending: (still, 0.0) });
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
        && hold.velocity.length() > AT_REST;
    state.glide = goes_on.then_some(Glide {
        gesture: hold.gesture,
        depth: hold.depth,
        velocity: hold.velocity,
    });
    state
}

/// What goes on for some seconds after the hand has let go: with v the velocity at first and T the
/// time of inertia, a way of v T (1 - exp(-t / T)).
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
    state.glide = (velocity.length() > AT_REST).then_some(Glide { velocity, ..glide });
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

/// How far what is held lies in front of the eye: what is there, if anything is, else the pivot.
fn depth_of(state: &State, point: Option<DVec3>) -> f64 {
    let of_point = point.map(|point| state.depth_of(point));
    of_point.filter(|depth| *depth > 0.0).unwrap_or_else(|| state.pivot_depth())
}

/// Moves the camera across its view, so that what was seen at one place of the window, at a depth,
/// is seen at another. The pivot keeps its place in the picture.
fn pan(mut state: State, settings: &Settings, from: DVec2, to: DVec2, depth: f64) -> State {
    let lens = state.lens(settings.lens);
    let place = |at| point_at(lens, settings.size, at, depth);
    let shift = place(to) - place(from);
    state.place.pivot -= state.place.view.rotation.transpose() * shift;
    state.moved(Rigid::shift(shift))
}

/// Brings what is seen at a place of the window, at a depth, to that depth times a factor, along its
/// ray, so that it is seen at the same place; answers with the new depth, too.
///
/// The pivot keeps its place in the picture, and its distance from what is zoomed to. Parallel rays
/// show things larger by a lower height: the scale changes by the same factor.
fn zoom(state: State, settings: &Settings, factor: f64, at: DVec2, depth: f64) -> (State, f64) {
    let radius = settings.bounds.radius();
    let reach = if radius > 0.0 && radius.is_finite() { radius } else { 1.0 };
    let is_parallel = matches!(settings.lens, Lens::Orthographic { .. });
    let (lowest, highest) = (NEAREST * reach, FARTHEST * reach);
    let after = (depth * factor).clamp(lowest.min(depth), highest.max(depth));
    let mut factor = after / depth;
    if is_parallel {
        // Scales stay within the same range, or several sensible depths would add up to a wild one.
        let scale = state.place.scale;
        factor = (scale * factor).clamp(NEAREST.min(scale), FARTHEST.max(scale)) / scale;
    }
    let lens = state.lens(settings.lens);
    let shift = point_at(lens, settings.size, at, depth) * (factor - 1.0);
    let mut state = state;
    let pivot_in_view = state.place.view.apply(state.place.pivot);
    state = state.moved(Rigid::shift(shift));
    if is_parallel {
        state.place.scale *= factor;
    }
    // Ahead, the pivot stays where it is in the world unless the eye would reach it.
    let depth = depth * factor;
    let ahead = -(pivot_in_view.z + shift.z);
    let was_ahead = pivot_in_view.z < 0.0;
    let ahead = if was_ahead && ahead < NEAREST * reach { depth } else { ahead };
    state.place.pivot = state.place.view.undo(pivot_in_view.with_z(-ahead));
    (state, depth)
}

impl Hold {
    /// Takes the way since the last time into the velocity; without time passing, it waits.
    fn update_velocity(&mut self) {
        let (way, seconds) = self.pending;
        if seconds > 0.0 {
            let weight = -libm::expm1(-seconds / SMOOTHING);
            self.velocity += (way / seconds - self.velocity) * weight;
            self.pending = (DVec2::ZERO, 0.0);
        }
    }
}
