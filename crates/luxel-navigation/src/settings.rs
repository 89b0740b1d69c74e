//! What the host says about window and scene, and what users like.

use glam::DVec3;
use luxel_scene::{Bounds, Lens, Size};

/// Window, scene and preferences. None of it changes while navigating, unless the host changes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The window, in the pixels of pointer positions.
    pub size: Size,
    /// The camera's lens, which pan, zoom and fit go by. Its height, if rays are parallel, is that
    /// at scale 1 ([`State::lens`](crate::State::lens)).
    pub lens: Lens,
    /// What is up, in world space; any length but 0.
    pub up: DVec3,
    /// What [`Event::Fit`](crate::Event::Fit) without bounds fits, in world space.
    pub bounds: Bounds,
    /// The numbers.
    pub numbers: [f64; NUMBERS],
}

/// How many numbers there are.
const NUMBERS: usize = Number::ALL.len();

macro_rules! numbers {
    ($($(#[doc = $doc:literal])* $name:ident $text:literal $default:expr, $range:ident;)*) => {
        /// A setting that is a number.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Number {
            $($(#[doc = $doc])* $name,)*
        }

        impl Number {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            const DEFAULTS: [f64; NUMBERS] = [$($default,)*];

            /// Its name in a log.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            /// Whether it may have a value.
            #[must_use]
            pub fn allows(self, value: f64) -> bool {
                match self {
                    $(Self::$name => Range::$range.holds(value),)*
                }
            }
        }
    };
}

numbers! {
    /// The radius of the rolling ball in pixels; 0 stands for 0.4 of the window's shorter side, which
    /// a fitted model about fills. Turntable and rolling ball turn by the hand's way over it.
    BallRadius "ball-radius" 0.0, NotNegative;
    /// By how many radians mouselook and flying turn for a pixel.
    LookRate "look-radians-per-pixel" 0.0025, NotNegative;
    /// By how many radians a second held keys turn.
    TurnRate "turn-radians-per-second" 1.0, NotNegative;
    /// By how many radians a tap turns.
    TurnStep "turn-step-radians" std::f64::consts::PI / 36.0, NotNegative;
    /// By how many world units a second held keys move.
    MoveRate "move-per-second" 1.0, NotNegative;
    /// By how many world units a tap moves.
    MoveStep "move-step" 0.05, NotNegative;
    /// By how many world units a second, in a second, the throttle changes the speed.
    ThrottleRate "throttle-per-second" 1.0, NotNegative;
    /// By how many world units a second a tap of the throttle changes the speed.
    ThrottleStep "throttle-step" 0.1, NotNegative;
    /// The highest speed of flying, ahead and back, in world units a second.
    SpeedLimit "speed-limit" 10.0, NotNegative;
    /// What a notch of the wheel divides the distance by.
    WheelFactor "wheel-factor" 1.2, Factor;
    /// The logarithm of what a pixel of zooming by hand divides the distance by.
    ZoomRate "zoom-per-pixel" 0.005, NotNegative;
    /// How far mouselook may look up and down from the horizon, in radians; at most a quarter turn.
    PitchLimit "pitch-limit-radians" 89.0 / 180.0 * std::f64::consts::PI, Elevation;
    /// The time, in seconds, in which a released hand's motion falls to 1/e; 0 turns it off.
    Inertia "inertia-seconds" 0.0, NotNegative;
    /// How long the way to another view takes, in seconds; 0 is at once. 0.15 shows where it went.
    Transition "transition-seconds" 0.0, NotNegative;
}

/// What values a number may have.
enum Range {
    NotNegative,
    Factor,
    Elevation,
}

impl Range {
    fn holds(&self, value: f64) -> bool {
        value.is_finite()
            && match self {
                Self::NotNegative => value >= 0.0,
                Self::Factor => value >= 1.0,
                Self::Elevation => (0.0..=std::f64::consts::FRAC_PI_2).contains(&value),
            }
    }
}

impl Settings {
    /// The settings for a scene and a window: speeds fit the scene's size. In a second a held key
    /// moves by the scene's radius, a tap by a twentieth of it.
    #[must_use]
    pub fn new(bounds: Bounds, up: DVec3, lens: Lens, size: Size) -> Self {
        let mut settings = Self { size, lens, up, bounds, numbers: Number::DEFAULTS };
        let radius = if bounds.is_empty() { 0.0 } else { bounds.radius() };
        if radius > 0.0 && radius.is_finite() {
            for number in [
                Number::MoveRate,
                Number::MoveStep,
                Number::ThrottleRate,
                Number::ThrottleStep,
                Number::SpeedLimit,
            ] {
                settings.numbers[number as usize] *= radius;
            }
        }
        settings
    }

    /// The value of a number.
    #[must_use]
    pub fn number(&self, number: Number) -> f64 {
        self.numbers[number as usize]
    }

    /// The settings with another value of a number; a value out of its range changes nothing.
    #[must_use]
    pub fn with(mut self, number: Number, value: f64) -> Self {
        if number.allows(value) {
            self.numbers[number as usize] = value;
        }
        self
    }

    /// The radius of the ball that rolls under the hand, in pixels.
    #[must_use]
    pub fn ball_radius(&self) -> f64 {
        /// Half of the 80 % of the window that a fitted model takes.
        const PART_OF_WINDOW: f64 = 0.4;
        let radius = self.number(Number::BallRadius);
        if radius > 0.0 {
            radius
        } else {
            f64::from(self.size.width.min(self.size.height).max(1)) * PART_OF_WINDOW
        }
    }

    /// The axis that is up, of unit length.
    pub(crate) fn up_axis(&self) -> DVec3 {
        let largest = self.up.abs().max_element();
        // Dividing first keeps tiny and huge vectors from under- and overflowing when squared.
        (self.up / largest).try_normalize().unwrap_or(DVec3::Y)
    }
}
