//! What mirrors and metals see.

use crate::light::bounded;
use luxel_math::{Number, Rgb, Vec3, elementary};

/// The surroundings that mirrors and metals reflect: no picture, a formula.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Environment {
    /// Nothing: black.
    #[default]
    None,
    /// A plain studio: bright above, a soft horizon, dark below.
    Studio {
        /// Upwards, of unit length, in world space.
        up: [f32; 3],
    },
    /// One colour all around.
    Constant([f32; 3]),
}

/// The studio's light straight above: soft white, a little warm.
const ZENITH: [f32; 3] = [1.25, 1.22, 1.17];
/// Just above the horizon: the far wall, a little cool.
const WALL: [f32; 3] = [0.46, 0.48, 0.51];
/// Just below the horizon: the floor.
const FLOOR: [f32; 3] = [0.155, 0.15, 0.148];
/// Straight below.
const NADIR: [f32; 3] = [0.05, 0.05, 0.054];
/// Half the width of the horizon for a perfect mirror, as a sine of elevation.
const HORIZON: f32 = 0.12;
/// How much wider a fully rough surface sees the horizon.
const BLUR: f32 = 1.4;

impl Environment {
    /// Whether there is nothing to mirror.
    #[inline(always)]
    #[must_use]
    pub fn is_none(&self) -> bool {
        matches!(self, Self::None)
    }

    /// The light that arrives from `direction` (of unit length), averaged over the lobe of a
    /// surface of this perceptual roughness.
    ///
    /// The studio is a gradient over h, the sine of elevation, that is steep about the horizon; what
    /// a rougher surface sees is the same gradient with a wider horizon. With
    /// t = h / (0.12 + 1.4 roughness^2) limited to -1..1 and s = 1/2 + (3 t - t^3) / 4, the light is
    /// (1 - s) below + s above, where `above` and `below` go from the horizon's colour to the
    /// zenith's and to the nadir's with |h|.
    #[inline(always)]
    pub fn radiance<N: Number>(&self, direction: Vec3<N>, roughness: N) -> Rgb<N> {
        let like = roughness;
        match *self {
            Self::None => Rgb::black(like),
            Self::Constant(color) => Rgb::splat(like, bounded(color)),
            Self::Studio { up } => {
                let height = direction.dot(Vec3::splat(like, up)).limited(-1.0, 1.0);
                let roughness = roughness.limited(0.0, 1.0);
                let width = like.constant(HORIZON) + like.constant(BLUR) * roughness * roughness;
                let t = (height / width).limited(-1.0, 1.0);
                let s =
                    like.constant(0.5) + (like.constant(3.0) * t - t * t * t) * like.constant(0.25);
                let above = mix(like, WALL, ZENITH, height.positive_part());
                let below = mix(like, FLOOR, NADIR, (-height).positive_part());
                below * (like.one() - s) + above * s
            }
        }
    }
}

/// The part of the light of its surroundings that a microfacet surface reflects: F0 A + B, with A
/// and B as fitted by Karis (*Physically Based Shading on Mobile*, 2014) to the integral of GGX, the
/// second factor of his split sum (*Real Shading in Unreal Engine 4*, 2013). Returns (A, B).
#[inline(always)]
pub(crate) fn split_sum<N: Number>(n_dot_v: N, roughness: N) -> (N, N) {
    let one = roughness.one();
    let steep = one - roughness;
    let offset = roughness.constant(0.0425) - roughness.constant(0.0275) * roughness;
    let scale = roughness.constant(1.04) - roughness.constant(0.572) * roughness;
    let shift = roughness.constant(0.022) * roughness - roughness.constant(0.04);
    let grazing = elementary::exp2(n_dot_v * n_dot_v.constant(-9.28));
    let share = ((steep * steep).minimum(grazing) * steep + offset) * roughness.constant(1.04);
    ((scale - share).limited(0.0, 1.0), (shift + share).limited(0.0, 1.0))
}

#[inline(always)]
fn mix<N: Number>(like: N, from: [f32; 3], to: [f32; 3], t: N) -> Rgb<N> {
    Rgb::splat(like, from) * (like.one() - t) + Rgb::splat(like, to) * t
}
