//! What may happen: the hand, the wheel, commands of the keyboard, and what the host asks for.

use glam::{DMat4, DVec2, DVec3};
use luxel_scene::Bounds;

/// Something that happens to a camera.
///
/// Positions are in window coordinates, from the upper left, in pixels. Where the host knows which
/// point of the world lies under them, it may say so; without, the pivot's distance is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Event {
    /// Nothing: only time passes.
    Wait,
    /// Another way to navigate. Motion stops; turntable and mouselook set the camera upright.
    Mode(Mode),
    /// The hand takes hold.
    Grab {
        /// Of what.
        gesture: Gesture,
        /// Where.
        at: DVec2,
        /// What is there, in world space.
        point: Option<DVec3>,
    },
    /// The hand moves to a place. Without a grab nothing happens.
    Drag {
        /// Where to.
        at: DVec2,
    },
    /// The hand lets go.
    Release,
    /// The wheel turns: by positive notches towards what lies under the pointer, by negative ones
    /// away from it.
    Wheel {
        /// How far.
        notches: f64,
        /// Where the pointer is.
        at: DVec2,
        /// What is there, in world space.
        point: Option<DVec3>,
    },
    /// A command's key goes down, and stays down until it is lifted.
    Press(Command),
    /// A command's key goes up.
    Lift(Command),
    /// A command is carried out by some steps at once, without time passing.
    Tap {
        /// Which.
        command: Command,
        /// How many steps.
        steps: f64,
    },
    /// The point of the world that the camera turns about and looks to. The picture stays.
    Pivot(DVec3),
    /// A side to look at the pivot from; the distance stays.
    View(StandardView),
    /// The whole scene, or a part of it, comes into view; the direction stays.
    Fit(Option<Bounds>),
    /// The horizon comes level; eye and direction stay.
    Level,
    /// The camera moves, as if by a view or a fit, to a place that the host has chosen.
    Go {
        /// The camera to come to.
        view_from_world: DMat4,
        /// The pivot there.
        pivot: DVec3,
        /// The scale of parallel rays there, above 0.
        scale: f64,
    },
    /// The camera is put in a place, at once. The scale of parallel rays is 1 again.
    Place(DMat4),
}

/// The ways to navigate.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The keyboard turns and moves the camera about and along the axes of the world.
    Absolute,
    /// The keyboard moves eye and target along the axes of the world.
    LookAt,
    /// The scene turns under the hand like a ball that rolls under it.
    RollingBall,
    /// Roll, pitch, yaw about the camera's own axes, and a throttle.
    Flying,
    /// The mouse turns, the keys walk.
    Mouselook,
    /// The camera moves around the pivot, the horizon stays level.
    #[default]
    Turntable,
}

/// What the hand takes hold of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// Turns, in the way of the mode.
    Turn,
    /// Moves the picture: what is grabbed stays under the pointer.
    Pan,
    /// Upwards nearer to what is grabbed, downwards away from it.
    Zoom,
}

/// Sides to look from. The front is where +Z points if +Y is up; with another axis up, that frame is
/// turned along ([`luxel_scene::Viewpoint::axes`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StandardView {
    /// From the front.
    Front,
    /// From behind.
    Back,
    /// From the right.
    Right,
    /// From the left.
    Left,
    /// From above, the front at the bottom.
    Top,
    /// From below, the front at the top.
    Bottom,
}

/// An axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// x.
    X,
    /// y.
    Y,
    /// z.
    Z,
}

/// What a key can do: one kind of motion, forwards or backwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Command {
    /// The motion.
    pub drive: Drive,
    /// Along the axis, or by the right-hand rule about it; else the other way.
    pub is_positive: bool,
}

/// Kinds of motion. A mode obeys those that make sense in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Drive {
    /// The camera, or the eye alone, along an axis of the world.
    Move(Axis),
    /// The camera about an axis of the world.
    Turn(Axis),
    /// The target along an axis of the world.
    Target(Axis),
    /// The camera along an axis of its own: right, up, back.
    Walk(Axis),
    /// The camera about an axis of its own: pitch up, yaw left, roll left.
    Own(Axis),
    /// Around the pivot, to the right.
    OrbitSideways,
    /// Around the pivot, upwards.
    OrbitUpwards,
    /// The speed ahead.
    Throttle,
}

/// What has one name in a log.
pub(crate) trait Named: Copy + PartialEq + 'static {
    /// All of them, with their names.
    const NAMES: &'static [(&'static str, Self)];

    fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, one)| *one == self).map_or("", |(name, _)| name)
    }

    fn named(name: &str) -> Option<Self> {
        Self::NAMES.iter().find(|(own, _)| *own == name).map(|(_, one)| *one)
    }
}

impl Named for Mode {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("absolute", Self::Absolute),
        ("look-at", Self::LookAt),
        ("rolling-ball", Self::RollingBall),
        ("flying", Self::Flying),
        ("mouselook", Self::Mouselook),
        ("turntable", Self::Turntable),
    ];
}

impl Named for Gesture {
    const NAMES: &'static [(&'static str, Self)] =
        &[("turn", Self::Turn), ("pan", Self::Pan), ("zoom", Self::Zoom)];
}

impl Named for StandardView {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("front", Self::Front),
        ("back", Self::Back),
        ("right", Self::Right),
        ("left", Self::Left),
        ("top", Self::Top),
        ("bottom", Self::Bottom),
    ];
}

const fn plus(drive: Drive) -> Command {
    Command { drive, is_positive: true }
}

const fn minus(drive: Drive) -> Command {
    Command { drive, is_positive: false }
}

impl Named for Command {
    const NAMES: &'static [(&'static str, Self)] = &[
        ("x+", plus(Drive::Move(Axis::X))),
        ("x-", minus(Drive::Move(Axis::X))),
        ("y+", plus(Drive::Move(Axis::Y))),
        ("y-", minus(Drive::Move(Axis::Y))),
        ("z+", plus(Drive::Move(Axis::Z))),
        ("z-", minus(Drive::Move(Axis::Z))),
        ("turn-x+", plus(Drive::Turn(Axis::X))),
        ("turn-x-", minus(Drive::Turn(Axis::X))),
        ("turn-y+", plus(Drive::Turn(Axis::Y))),
        ("turn-y-", minus(Drive::Turn(Axis::Y))),
        ("turn-z+", plus(Drive::Turn(Axis::Z))),
        ("turn-z-", minus(Drive::Turn(Axis::Z))),
        ("target-x+", plus(Drive::Target(Axis::X))),
        ("target-x-", minus(Drive::Target(Axis::X))),
        ("target-y+", plus(Drive::Target(Axis::Y))),
        ("target-y-", minus(Drive::Target(Axis::Y))),
        ("target-z+", plus(Drive::Target(Axis::Z))),
        ("target-z-", minus(Drive::Target(Axis::Z))),
        ("right", plus(Drive::Walk(Axis::X))),
        ("left", minus(Drive::Walk(Axis::X))),
        ("up", plus(Drive::Walk(Axis::Y))),
        ("down", minus(Drive::Walk(Axis::Y))),
        ("back", plus(Drive::Walk(Axis::Z))),
        ("forward", minus(Drive::Walk(Axis::Z))),
        ("pitch-up", plus(Drive::Own(Axis::X))),
        ("pitch-down", minus(Drive::Own(Axis::X))),
        ("yaw-left", plus(Drive::Own(Axis::Y))),
        ("yaw-right", minus(Drive::Own(Axis::Y))),
        ("roll-left", plus(Drive::Own(Axis::Z))),
        ("roll-right", minus(Drive::Own(Axis::Z))),
        ("orbit-right", plus(Drive::OrbitSideways)),
        ("orbit-left", minus(Drive::OrbitSideways)),
        ("orbit-up", plus(Drive::OrbitUpwards)),
        ("orbit-down", minus(Drive::OrbitUpwards)),
        ("faster", plus(Drive::Throttle)),
        ("slower", minus(Drive::Throttle)),
    ];
}

macro_rules! in_text {
    ($($named:ty, $what:literal;)*) => {$(
        impl std::fmt::Display for $named {
            fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                formatter.write_str(self.name())
            }
        }

        impl std::str::FromStr for $named {
            type Err = UnknownName;

            fn from_str(text: &str) -> Result<Self, UnknownName> {
                Self::named(text).ok_or_else(|| UnknownName {
                    what: $what,
                    name: text.to_owned(),
                    known: Self::NAMES.iter().map(|(name, _)| *name).collect(),
                })
            }
        }
    )*};
}

in_text! {
    Mode, "mode";
    Gesture, "gesture";
    StandardView, "view";
    Command, "command";
}

/// A name that nothing has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("there is no {what} `{name}`: use {}", known.join(", "))]
pub struct UnknownName {
    /// What was to be named.
    pub what: &'static str,
    /// The name.
    pub name: String,
    /// The names that there are.
    pub known: Vec<&'static str>,
}

impl Event {
    /// Whether its numbers make sense; what isn't has no effect.
    pub(crate) fn is_sound(&self) -> bool {
        match *self {
            Self::Grab { at, point, .. } => at.is_finite() && point.is_none_or(DVec3::is_finite),
            Self::Wheel { notches, at, point } => {
                notches.is_finite() && at.is_finite() && point.is_none_or(DVec3::is_finite)
            }
            Self::Drag { at } => at.is_finite(),
            Self::Tap { steps, .. } => steps.is_finite(),
            Self::Pivot(point) => point.is_finite(),
            Self::Fit(Some(bounds)) => bounds.min.is_finite() && bounds.max.is_finite(),
            Self::Go { view_from_world, pivot, scale } => {
                view_from_world.is_finite() && pivot.is_finite() && scale.is_finite() && scale > 0.0
            }
            Self::Place(view_from_world) => view_from_world.is_finite(),
            Self::Wait
            | Self::Mode(_)
            | Self::Release
            | Self::Press(_)
            | Self::Lift(_)
            | Self::View(_)
            | Self::Fit(None)
            | Self::Level => true,
        }
    }
}
