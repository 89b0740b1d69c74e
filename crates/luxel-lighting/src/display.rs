//! From a surface's light to the picture's: exposure, then a tone curve.

use crate::Tone;
use luxel_math::{Lanes, Rgb};

/// The exposure, and the tone curve: what happens to the colour of a surface at a sample, after fog and
/// before samples are averaged, clamped and encoded. Backgrounds stay as they are.
///
/// ```
/// use luxel_lighting::{Display, Tone};
/// use luxel_math::Rgb;
///
/// let dimmed = Display::new(-3.0, Tone::None);
/// assert_eq!(dimmed.factor(), 0.125);
/// assert_eq!(dimmed.shown(Rgb::new(8.0, 4.0, 0.0)), Rgb::new(1.0, 0.5, 0.0));
/// assert!(Display::new(0.0, Tone::None).is_identity());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Display {
    ev: f32,
    factor: f32,
    tone: Tone,
}

impl Default for Display {
    fn default() -> Self {
        Self::new(0.0, Tone::None)
    }
}

impl Display {
    /// The largest exposure, either way.
    pub const MAX_EV: f32 = 64.0;

    /// An exposure in stops, each of which doubles the light, and a tone curve. Exposures are kept within
    /// [`Self::MAX_EV`]; NaN counts as 0.
    #[must_use]
    pub fn new(ev: f32, tone: Tone) -> Self {
        let ev = if ev.is_nan() { 0.0 } else { ev.clamp(-Self::MAX_EV, Self::MAX_EV) };
        Self { ev, factor: libm::exp2(f64::from(ev)) as f32, tone }
    }

    /// The exposure in stops.
    #[must_use]
    pub const fn ev(&self) -> f32 {
        self.ev
    }

    /// 2^EV: what light is multiplied by.
    #[must_use]
    pub const fn factor(&self) -> f32 {
        self.factor
    }

    /// The tone curve.
    #[must_use]
    pub const fn tone(&self) -> Tone {
        self.tone
    }

    /// Whether colours stay as they are.
    #[must_use]
    pub fn is_identity(&self) -> bool {
        self.factor == 1.0 && self.tone == Tone::None
    }

    /// The light that an exposure alone makes 1: white.
    #[must_use]
    pub fn white(&self) -> f32 {
        1.0 / self.factor
    }

    /// A surface's colour as the picture shows it. Always finite.
    #[inline(always)]
    #[must_use]
    pub fn shown<N: Lanes>(&self, color: Rgb<N>) -> Rgb<N> {
        let Rgb { r, g, b } = color;
        let factor = r.constant(self.factor);
        let most = f32::MAX;
        self.tone.curve(Rgb::new(
            (r * factor).clamped(-most, most),
            (g * factor).clamped(-most, most),
            (b * factor).clamped(-most, most),
        ))
    }
}
