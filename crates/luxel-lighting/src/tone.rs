//! Tone curves: light of any intensity into what a picture can show.
//!
//! Each maps linear light in the primaries of sRGB to linear values from 0 to 1, ready for the picture's
//! encoding. Negative light counts as 0, and light beyond 1e9 as 1e9, where every curve has reached its end.

mod aces;
mod agx;
mod neutral;

use luxel_math::{Lanes, Rgb};

/// A tone curve.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Tone {
    /// None: light beyond 1 is clamped.
    #[default]
    None,
    /// Khronos PBR Neutral.
    Neutral,
    /// The film look of ACES, by Hill's fit.
    Aces,
    /// `AgX`, by Wrensch's fit.
    Agx,
}

impl Tone {
    /// All curves, in the order of lists.
    pub const ALL: [Self; 4] = [Self::None, Self::Neutral, Self::Aces, Self::Agx];

    /// The name, as flags and scene files have it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Neutral => "neutral",
            Self::Aces => "aces",
            Self::Agx => "agx",
        }
    }

    /// A few words of help.
    #[must_use]
    pub const fn help(self) -> &'static str {
        match self {
            Self::None => "light beyond white is clamped",
            Self::Neutral => "Khronos PBR Neutral: colours as they are, highlights compressed",
            Self::Aces => "the film look of ACES, Hill's fit",
            Self::Agx => "AgX, Wrensch's fit: bright colours fade to white",
        }
    }

    /// The curve of a colour.
    #[inline(always)]
    pub fn curve<N: Lanes>(self, color: Rgb<N>) -> Rgb<N> {
        match self {
            Self::None => color,
            Self::Neutral => neutral::curve(limited(color)),
            Self::Aces => aces::curve(limited(color)),
            Self::Agx => agx::curve(limited(color)),
        }
    }
}

/// Light beyond this is at the end of every curve, and its square no infinity.
const LIMIT: f32 = 1e9;

/// Light as the curves take it.
#[inline(always)]
fn limited<N: Lanes>(color: Rgb<N>) -> Rgb<N> {
    clamped(color, LIMIT)
}

#[inline(always)]
fn clamped<N: Lanes>(Rgb { r, g, b }: Rgb<N>, most: f32) -> Rgb<N> {
    Rgb::new(r.clamped(0.0, most), g.clamped(0.0, most), b.clamped(0.0, most))
}

/// A matrix, row by row, times a colour.
#[inline(always)]
fn transformed<N: Lanes>([r, g, b]: [[f32; 3]; 3], color: Rgb<N>) -> Rgb<N> {
    Rgb::new(combined(r, color), combined(g, color), combined(b, color))
}

#[inline(always)]
fn combined<N: Lanes>([r, g, b]: [f32; 3], color: Rgb<N>) -> N {
    color.r * color.r.constant(r) + color.g * color.g.constant(g) + color.b * color.b.constant(b)
}
