//! Settings: window, scene and preferences.

use glam::DVec3;
use luxel_scene::{Bounds, Lens, Size};

/// Window, scene and preferences. Only the host changes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The window's size, in the pixels of pointer positions.
    pub size: Size,
    /// The camera's lens, for pan, zoom and fit. An orthographic height is the one at scale 1
    /// ([`State::lens`](crate::State::lens)).
    pub lens: Lens,
    /// The up direction in world space, of any length but 0.
    pub up: DVec3,
    /// The bounds that [`Event::Fit`](crate::Event::Fit) fits by default, in world space.
    pub bounds: Bounds,
    /// The numbers.
    pub numbers: [f64; NUMBERS],
}

/// The count of numbers.
const NUMBERS: usize = Number::ALL.len();

macro_rules! numbers {
    ($($(#[doc = $doc:literal])* $name:ident $text:literal $default:expr, $range:ident;)*) => {
        /// A numeric setting.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Number {
            $($(#[doc = $doc])* $name,)*
        }

        impl Number {
            /// All numbers.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            const DEFAULTS: [f64; NUMBERS] = [$($default,)*];

            /// Its name in a log.
            #[must_use]
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$name => $text,)*
                }
            }

            /// Whether a value is in range.
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
    /// The radius of the rolling ball in pixels; 0 means 0.4 of the window's shorter side, about half of a
    /// fitted model. Turntable and rolling ball rotate by the pointer's displacement over it.
    BallRadius "ball-radius" 0.0, NotNegative;
    /// The rotation of mouselook and flying, in radians per pixel.
    LookRate "look-radians-per-pixel" 0.0025, NotNegative;
    /// The rotation rate of held keys, in radians per second.
    TurnRate "turn-radians-per-second" 1.0, NotNegative;
    /// The rotation of a tap, in radians.
    TurnStep "turn-step-radians" std::f64::consts::PI / 36.0, NotNegative;
    /// The speed of held keys, in world units per second.
    MoveRate "move-per-second" 1.0, NotNegative;
    /// The step of a tap, in world units.
    MoveStep "move-step" 0.05, NotNegative;
    /// The acceleration of the throttle, in world units per second squared.
    ThrottleRate "throttle-per-second" 1.0, NotNegative;
    /// The change of speed of a throttle tap, in world units per second.
    ThrottleStep "throttle-step" 0.1, NotNegative;
    /// The flying speed limit, forwards and backwards, in world units per second.
    SpeedLimit "speed-limit" 10.0, NotNegative;
    /// The divisor of the distance for a notch of the wheel.
    WheelFactor "wheel-factor" 1.2, Factor;
    /// The logarithm of the divisor of the distance for a pixel of a zoom gesture.
    ZoomRate "zoom-per-pixel" 0.005, NotNegative;
    /// The largest elevation of mouselook, up and down, in radians; at most a quarter turn.
    PitchLimit "pitch-limit-radians" 89.0 / 180.0 * std::f64::consts::PI, Elevation;
    /// The time constant of inertia, in seconds; 0 turns it off.
    Inertia "inertia-seconds" 0.0, NotNegative;
    /// The duration of transitions, in seconds; 0 disables them. 0.15 is short but visible.
    Transition "transition-seconds" 0.0, NotNegative;
}

/// The valid range of a number.
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
    /// Default settings for a scene and a window: speeds scale with the scene. A held key moves by the
    /// scene's radius per second, a tap by a twentieth of it.
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

    /// Sets a number; values out of range are ignored.
    #[must_use]
    pub fn with(mut self, number: Number, value: f64) -> Self {
        if number.allows(value) {
            self.numbers[number as usize] = value;
        }
        self
    }

    /// The radius of the rolling ball, in pixels.
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

    /// The unit up axis.
    pub(crate) fn up_axis(&self) -> DVec3 {
        let largest = self.up.abs().max_element();
        // Dividing first avoids under- and overflow of squares.
        (self.up / largest).try_normalize().unwrap_or(DVec3::Y)
    }
}
