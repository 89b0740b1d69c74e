//! The state of navigation.

use crate::event::{Axis, Command, Drive, Gesture, Mode, Named};
use crate::motion::Rigid;
use crate::place::Place;
use crate::transition::Transition;
use glam::{DMat4, DVec2, DVec3, DVec4};
use luxel_scene::Lens;

/// Where the camera is, and what moves it. A plain value: keep it, compare it, go back to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub(crate) mode: Mode,
    pub(crate) place: Place,
    /// World units a second, ahead.
    pub(crate) speed: f64,
    pub(crate) held: Held,
    pub(crate) hold: Option<Hold>,
    pub(crate) glide: Option<Glide>,
    pub(crate) transition: Option<Transition>,
}

/// What the hand holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hold {
    pub(crate) gesture: Gesture,
    /// Where it was taken, in the window.
    pub(crate) start: DVec2,
    /// Where the hand is.
    pub(crate) at: DVec2,
    /// How far what is held lies in front of the eye.
    pub(crate) depth: f64,
    /// The hand's velocity, smoothed, in pixels a second.
    pub(crate) velocity: DVec2,
    /// The hand's way and the time since the velocity was last brought up to date.
    pub(crate) pending: (DVec2, f64),
}

/// Motion that goes on after the hand has let go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Glide {
    pub(crate) gesture: Gesture,
    pub(crate) depth: f64,
    pub(crate) velocity: DVec2,
}

/// The keys that are down: a bit for each command.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Held(u64);

const _: () = assert!(Command::NAMES.len() <= u64::BITS as usize);

impl Held {
    pub(crate) fn set(&mut self, command: Command, is_down: bool) {
        if let Some(bit) = Command::NAMES.iter().position(|(_, one)| *one == command) {
            let mask = 1 << bit;
            self.0 = if is_down { self.0 | mask } else { self.0 & !mask };
        }
    }

    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// What all held keys together ask for.
    pub(crate) fn drives(self) -> Drives {
        let held = Command::NAMES.iter().enumerate().filter(|(bit, _)| self.0 >> bit & 1 == 1);
        held.fold(Drives::default(), |mut drives, (_, (_, command))| {
            drives.add(*command, 1.0);
            drives
        })
    }
}

/// How much of each kind of motion is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Drives {
    pub(crate) shift: DVec3,
    pub(crate) turn: DVec3,
    pub(crate) target: DVec3,
    pub(crate) walk: DVec3,
    pub(crate) own: DVec3,
    /// To the right, upwards.
    pub(crate) orbit: DVec2,
    pub(crate) throttle: f64,
}

impl Drives {
    pub(crate) fn add(&mut self, command: Command, steps: f64) {
        let amount = if command.is_positive { steps } else { -steps };
        match command.drive {
            Drive::Move(axis) => self.shift += unit(axis) * amount,
            Drive::Turn(axis) => self.turn += unit(axis) * amount,
            Drive::Target(axis) => self.target += unit(axis) * amount,
            Drive::Walk(axis) => self.walk += unit(axis) * amount,
            Drive::Own(axis) => self.own += unit(axis) * amount,
            Drive::OrbitSideways => self.orbit.x += amount,
            Drive::OrbitUpwards => self.orbit.y += amount,
            Drive::Throttle => self.throttle += amount,
        }
    }

    /// Ways of `length` world units, turns of `angle` radians, speeds higher by `speed`.
    pub(crate) fn scaled(self, length: f64, angle: f64, speed: f64) -> Self {
        Self {
            shift: self.shift * length,
            turn: self.turn * angle,
            target: self.target * length,
            walk: self.walk * length,
            own: self.own * angle,
            orbit: self.orbit * angle,
            throttle: self.throttle * speed,
        }
    }
}

fn unit(axis: Axis) -> DVec3 {
    match axis {
        Axis::X => DVec3::X,
        Axis::Y => DVec3::Y,
        Axis::Z => DVec3::Z,
    }
}

impl State {
    /// A camera at rest. The matrix must be a rotation and a translation ([`is_rigid`]); it stays as
    /// it is, to the bit, until something moves the camera.
    #[must_use]
    pub fn new(mode: Mode, view_from_world: &DMat4, pivot: DVec3) -> Self {
        let place = Place { view: Rigid::from_matrix(view_from_world), pivot, scale: 1.0 };
        Self {
            mode,
            place,
            speed: 0.0,
            held: Held::default(),
            hold: None,
            glide: None,
            transition: None,
        }
    }

    /// The way to navigate that is on.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// From world to camera space.
    #[must_use]
    pub fn view_from_world(&self) -> DMat4 {
        self.place.view.to_matrix()
    }

    /// What the camera turns about, and the target of look-at, in world space.
    #[must_use]
    pub fn pivot(&self) -> DVec3 {
        self.place.pivot
    }

    /// The eye, in world space.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        self.place.view.eye()
    }

    /// What the height of parallel rays is to be multiplied by: they show something larger not by
    /// coming nearer, and the projection is the host's.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.place.scale
    }

    /// A lens as it is to be used now: parallel rays scaled, others unchanged.
    #[must_use]
    pub fn lens(&self, lens: Lens) -> Lens {
        match lens {
            Lens::Orthographic { height } => Lens::Orthographic { height: height * self.scale() },
            Lens::Perspective { .. } | Lens::Intrinsics { .. } => lens,
        }
    }

    /// The speed of flying, in world units a second.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether the hand holds something.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.hold.is_some()
    }

    /// Whether the passing of time alone moves the camera.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.transition.is_some()
            || self.glide.is_some()
            || !self.held.is_empty()
            || (self.mode == Mode::Flying && self.speed != 0.0)
    }

    /// The state at the end of the way to another view.
    pub(crate) fn settled(&self) -> Self {
        match &self.transition {
            Some(transition) => Self { place: transition.goal(), transition: None, ..*self },
            None => *self,
        }
    }

    /// How far a point lies in front of the eye.
    pub(crate) fn depth_of(&self, point: DVec3) -> f64 {
        -self.place.view.apply(point).z
    }

    /// How far the pivot lies in front of the eye; where it is behind, how far it is at all.
    pub(crate) fn pivot_depth(&self) -> f64 {
        let in_view = self.place.view.apply(self.place.pivot);
        if in_view.z < 0.0 { -in_view.z } else { in_view.length().max(f64::MIN_POSITIVE) }
    }

    /// Moves the camera by an increment in camera coordinates, on the left of what was used so far:
    /// p' = I C p.
    pub(crate) fn moved(self, increment: Rigid) -> Self {
        let view = self.place.view.then(increment);
        Self { place: Place { view, ..self.place }, ..self }
    }
}

/// Whether a matrix is a rotation and a translation, to 1e-4: what printed digits leave.
#[must_use]
pub fn is_rigid(matrix: &DMat4) -> bool {
    const TOLERANCE: f64 = 1e-4;
    let [x, y, z] = [matrix.x_axis, matrix.y_axis, matrix.z_axis].map(DVec4::truncate);
    let deviations = [
        x.length() - 1.0,
        y.length() - 1.0,
        z.length() - 1.0,
        x.dot(y),
        y.dot(z),
        z.dot(x),
        x.cross(y).dot(z) - 1.0,
    ];
    // Written so that an overflow to NaN is refused too.
    matrix.row(3) == DMat4::IDENTITY.row(3)
        && matrix.is_finite()
        && deviations.iter().all(|deviation| deviation.abs() <= TOLERANCE)
}
