//! Depth cueing and fog: how distance takes a colour towards another.

use crate::light::bounded;
use luxel_math::{Lanes, Rgb, elementary};

/// Fog: I' = s I + (1 - s) I_dc, where s falls with the distance along the viewing axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fog {
    /// I_dc: the colour that things take on, linear.
    pub color: [f32; 3],
    /// How s depends on the distance.
    pub law: FogLaw,
}

/// How the scale factor s depends on z, the distance from the eye along the viewing axis, in units
/// of the world.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum FogLaw {
    /// Depth cueing (Foley et al., *Computer Graphics: Principles and Practice*, 1990, section
    /// 16.1.3): s goes linearly from `front` at `near` to `back` at `far` and is constant beyond.
    ///
    /// Foley's z is the normalised one after projection, from 0 at the back plane to 1 at the
    /// front plane; here it is a distance, so that the cue doesn't depend on the clipping planes.
    /// `front` 1 and `back` 0 are the linear fog of OpenGL 1.x.
    DepthCue {
        /// z_f: the front plane.
        near: f32,
        /// z_b: the back plane.
        far: f32,
        /// s_f: the scale factor up to the front plane.
        front: f32,
        /// s_b: the scale factor beyond the back plane.
        back: f32,
    },
    /// s = exp(-density z) (OpenGL 1.x, section 3.10).
    Exponential {
        /// How much of the light is lost in a unit of length, for small losses.
        density: f32,
    },
    /// s = exp(-(density z)^2) (OpenGL 1.x, section 3.10).
    ExponentialSquared {
        /// The inverse of the distance at which s is 1/e.
        density: f32,
    },
}

impl Fog {
    /// s at the distance z along the viewing axis.
    #[inline(always)]
    pub fn factor<N: Lanes>(&self, z: N) -> N {
        match self.law {
            FogLaw::DepthCue { near, far, front, back } => {
                let t = if far > near {
                    ((z - z.constant(near)) / z.constant(far - near)).clamped(0.0, 1.0)
                } else {
                    z.zero().select(z.less(z.constant(near)), z.one())
                };
                // So weighted, both ends are met exactly.
                z.constant(front) * (z.one() - t) + z.constant(back) * t
            }
            FogLaw::Exponential { density } => {
                exp_of_negative((z * z.constant(density)).positive_part())
            }
            FogLaw::ExponentialSquared { density } => {
                let way = (z * z.constant(density)).clamped(0.0, 1e9);
                exp_of_negative(way * way)
            }
        }
    }

    /// I_dc in every lane.
    #[inline(always)]
    pub(crate) fn color_like<N: Lanes>(&self, simd: N) -> Rgb<N> {
        Rgb::splat(simd, bounded(self.color))
    }
}

/// exp(-x) for x >= 0
#[inline(always)]
fn exp_of_negative<N: Lanes>(x: N) -> N {
    elementary::exp2(x * x.constant(-std::f32::consts::LOG2_E))
}
