//! The environment: the light all around, which mirrors and metals reflect.

mod blur;
mod harmonics;
mod map;
mod octahedron;
mod resample;
#[cfg(test)]
mod tests;

use crate::light::bounded;
use luxel_math::{Lanes, Rgb, Vec3};

pub use map::{EnvironmentMap, EquirectangularImage, OrientedMap};

/// The surroundings that mirrors and metals reflect. Formulas are reflected by these alone; a map lights matt
/// surfaces, too.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// A picture.
    Map(OrientedMap),
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

    /// The mean of the light from all around.
    #[must_use]
    pub fn mean(&self) -> [f32; 3] {
        match self {
            Self::None => [0.0; 3],
            Self::Constant(color) => bounded(*color),
            Self::Map(map) => map.map().mean(),
            // From the horizon to the poles, the colours change linearly over equal areas.
            Self::Studio { .. } => {
                [0, 1, 2].map(|at| (ZENITH[at] + WALL[at] + FLOOR[at] + NADIR[at]) * 0.25)
            }
        }
    }

    /// The light that arrives from `direction` (of unit length), averaged over the lobe of a
    /// surface of this perceptual roughness.
    ///
    /// A map has this for roughnesses of 0, 0.1, ... 1, the lobes being those of GGX seen from above, and goes
    /// linearly from one to the next.
    ///
    /// The studio is a gradient over h, the sine of elevation, that is steep about the horizon; a
    /// rougher surface reflects the same gradient with a wider horizon. With
    /// t = h / (0.12 + 1.4 roughness^2) limited to -1..1 and s = 1/2 + (3 t - t^3) / 4, the light is
    /// (1 - s) below + s above, where `above` and `below` go from the horizon's colours to the
    /// zenith's and to the nadir's with |h| (1 - roughness^2 / 2).
    #[inline(always)]
    pub fn radiance<N: Lanes>(&self, direction: Vec3<N>, roughness: N) -> Rgb<N> {
        let simd = roughness;
        match self {
            Self::None => Rgb::black(simd),
            Self::Constant(color) => Rgb::splat(simd, bounded(*color)),
            Self::Map(map) => map.radiance(direction, roughness),
            Self::Studio { up } => {
                let height = direction.dot(Vec3::splat(simd, *up)).clamped(-1.0, 1.0);
                let roughness = roughness.clamped(0.0, 1.0);
                let width = simd.constant(HORIZON) + simd.constant(BLUR) * roughness * roughness;
                let t = (height / width).clamped(-1.0, 1.0);
                let s =
                    simd.constant(0.5) + (simd.constant(3.0) * t - t * t * t) * simd.constant(0.25);
                let reach = simd.one() - simd.constant(0.5) * roughness * roughness;
                let above = mix(simd, WALL, ZENITH, height.positive_part() * reach);
                let below = mix(simd, FLOOR, NADIR, (-height).positive_part() * reach);
                below * (simd.one() - s) + above * s
            }
        }
    }
}

/// The part of the light of its surroundings that a microfacet surface reflects, F0 A + B, the
/// second factor of the split sum (Karis, *Real Shading in Unreal Engine 4*, 2013). Returns (A, B).
///
/// With r the perceptual roughness and u = 1 - N.V:
///
/// - A + B, the reflectance of a white metal, is 1 - r^2 (p0 + p1 r + p2 r^2), each p a combination
///   of 1, u and u^4;
/// - B is u^5 + r (q0 + q1 r + q2 r^2), each q a combination of u^2 and u^5.
///
/// Fitted by least squares to the integrals over GGX with height-correlated masking and Schlick's
/// F, for N.V and r from 0.05 to 1; the error is 0.015 in the mean square and 0.09 at most, at
/// grazing angles. Light that is reflected more than once is missing, as in the integrals.
#[inline(always)]
pub(crate) fn split_sum<N: Lanes>(n_dot_v: N, roughness: N) -> (N, N) {
    let one = roughness.one();
    let u = one - n_dot_v;
    let u2 = u * u;
    let u4 = u2 * u2;
    let u5 = u4 * u;
    let p0 = combination(LOSS[0], [one, u, u4]);
    let p1 = combination(LOSS[1], [one, u, u4]);
    let p2 = combination(LOSS[2], [one, u, u4]);
    let loss = roughness * roughness * (p0 + roughness * (p1 + roughness * p2));
    let q0 = combination(GRAZING[0], [one, u2, u5]);
    let q1 = combination(GRAZING[1], [one, u2, u5]);
    let q2 = combination(GRAZING[2], [one, u2, u5]);
    let b = (u5 + roughness * (q0 + roughness * (q1 + roughness * q2))).clamped(0.0, 1.0);
    ((one - loss - b).clamped(0.0, 1.0), b)
}

/// The coefficients of p0, p1, p2.
const LOSS: [[f32; 3]; 3] =
    [[-1.090, 2.122, 1.812], [3.958, -4.345, -6.326], [-2.169, 1.960, 4.194]];
/// The coefficients of q0, q1, q2.
const GRAZING: [[f32; 3]; 3] = [[0.0, 0.946, -2.630], [0.0, -2.058, 1.919], [0.0, 1.125, -0.213]];

#[inline(always)]
fn combination<N: Lanes>([a, b, c]: [f32; 3], [x, y, z]: [N; 3]) -> N {
    x * x.constant(a) + y * y.constant(b) + z * z.constant(c)
}

#[inline(always)]
fn mix<N: Lanes>(simd: N, from: [f32; 3], to: [f32; 3], t: N) -> Rgb<N> {
    Rgb::splat(simd, from) * (simd.one() - t) + Rgb::splat(simd, to) * t
}
