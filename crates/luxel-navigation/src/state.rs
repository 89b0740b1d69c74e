//! The state of navigation.

use crate::event::{Axis, Command, Drive, Gesture, Mode, Named};
use crate::motion::Rigid;
use crate::place::Place;
use crate::transition::Transition;
use glam::{DMat4, DVec2, DVec3, DVec4};
use luxel_scene::Lens;

/// The camera's pose, and everything that moves it. A plain value: it can be stored, compared and
/// restored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub(crate) mode: Mode,
    pub(crate) place: Place,
    /// The forward speed in world units per second.
    pub(crate) speed: f64,
    pub(crate) held: Held,
    pub(crate) hold: Option<ActiveGesture>,
    pub(crate) glide: Option<Glide>,
    pub(crate) transition: Option<Transition>,
}

/// A pointer gesture in progress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ActiveGesture {
    pub(crate) gesture: Gesture,
    /// The start position in the window.
    pub(crate) start: DVec2,
    /// The present position.
    pub(crate) at: DVec2,
    /// The depth of the grabbed point.
    pub(crate) depth: f64,
    /// The pointer's smoothed velocity, in pixels per second.
    pub(crate) velocity: DVec2,
    /// The pointer's displacement and the time since the last update of the velocity.
    pub(crate) pending: (DVec2, f64),
}

/// Inertial motion after a gesture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Glide {
    pub(crate) gesture: Gesture,
    pub(crate) depth: f64,
    pub(crate) velocity: DVec2,
}

/// The held keys: a bit for each command.
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

    /// The combined motion of all held keys.
    pub(crate) fn drives(self) -> Drives {
        let held = Command::NAMES.iter().enumerate().filter(|(bit, _)| self.0 >> bit & 1 == 1);
        held.fold(Drives::default(), |mut drives, (_, (_, command))| {
            drives.add(*command, 1.0);
            drives
        })
    }
}

/// Amounts of each kind of motion.
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

    /// Scales translations to world units, rotations to radians, throttle to speed.
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
    /// A camera at rest. The matrix must be a rotation and a translation ([`is_rigid`]); it is kept
    /// bit for bit until something moves the camera.
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

    /// The navigation mode.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// From world to camera space.
    #[must_use]
    pub fn view_from_world(&self) -> DMat4 {
        self.place.view.to_matrix()
    }

    /// The pivot of rotations, and the target of look-at, in world space.
    #[must_use]
    pub fn pivot(&self) -> DVec3 {
        self.place.pivot
    }

    /// The eye, in world space.
    #[must_use]
    pub fn eye(&self) -> DVec3 {
        self.place.view.eye()
    }

    /// The factor of the orthographic height: orthographic cameras zoom by it, and the projection belongs to
    /// the host.
    #[must_use]
    pub fn scale(&self) -> f64 {
        self.place.scale
    }

    /// The lens to use now: orthographic heights scaled, others unchanged.
    #[must_use]
    pub fn lens(&self, lens: Lens) -> Lens {
        match lens {
            Lens::Orthographic { height } => Lens::Orthographic { height: height * self.scale() },
            Lens::Perspective { .. } | Lens::Intrinsics { .. } => lens,
        }
    }

    /// The flying speed, in world units per second.
    #[must_use]
    pub fn speed(&self) -> f64 {
        self.speed
    }

    /// Whether a gesture is in progress.
    #[must_use]
    pub fn is_held(&self) -> bool {
        self.hold.is_some()
    }

    /// Whether the camera moves without further events.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.transition.is_some()
            || self.glide.is_some()
            || !self.held.is_empty()
            || (self.mode == Mode::Flying && self.speed != 0.0)
    }

    /// The state after the transition in progress.
    pub(crate) fn settled(&self) -> Self {
        match &self.transition {
            Some(transition) => Self { place: transition.goal(), transition: None, ..*self },
            None => *self,
        }
    }

    /// A point's depth in front of the eye.
    pub(crate) fn depth_of(&self, point: DVec3) -> f64 {
        -self.place.view.apply(point).z
    }

    /// The pivot's depth in front of the eye; its distance if it lies behind.
    pub(crate) fn pivot_depth(&self) -> f64 {
        let in_view = self.place.view.apply(self.place.pivot);
        if in_view.z < 0.0 { -in_view.z } else { in_view.length().max(f64::MIN_POSITIVE) }
    }

    /// Moves the camera by an increment in camera space, multiplied from the left: p' = I C p.
    pub(crate) fn moved(self, increment: Rigid) -> Self {
        let view = self.place.view.then(increment);
        Self { place: Place { view, ..self.place }, ..self }
    }
}

/// Whether a matrix is a rotation and a translation, within 1e-4, the precision of printed matrices.
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
    // The comparison rejects NaN from overflows, too.
    matrix.row(3) == DMat4::IDENTITY.row(3)
        && matrix.is_finite()
        && deviations.iter().all(|deviation| deviation.abs() <= TOLERANCE)
}
