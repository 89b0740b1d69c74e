//! Lights where they stand: how much of them reaches a point, and from where.

use crate::light::bounded;
use crate::{Attenuation, Cone, Light, LightKind};
use luxel_math::{Lanes, Mask, Rgb, Vec3, elementary};

/// A light in its place: world directions, with the eye as the origin.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLight {
    light: Light,
    /// Whether the light has any ambient intensity, which few have.
    has_ambient: bool,
    position: [f32; 3],
    direction: [f32; 3],
    /// Against `direction`.
    upstream: [f32; 3],
}

/// The incident light of one source at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightSample<N> {
    /// L: the unit vector towards the light; 0 if the light is at the point itself.
    pub(crate) to_light: Vec3<N>,
    /// d; `None` for directional lights.
    pub(crate) distance: Option<N>,
    /// min(1 / (c1 + c2 d + c3 d^2), limit) times the window of the range.
    pub(crate) attenuation: N,
    /// The spot factor of this direction.
    pub(crate) spot: N,
    /// V: the part that nothing keeps away; `None` without shadows.
    pub(crate) visibility: Option<N>,
}

impl<N: Lanes> LightSample<N> {
    /// The attenuated intensity: V f I with f = attenuation x spot, which is 1 for
    /// lights without a place.
    #[inline(always)]
    pub(crate) fn attenuated(&self, intensity: Rgb<N>) -> Rgb<N> {
        let attenuated = match self.distance {
            Some(_) => intensity * (self.attenuation * self.spot),
            None => intensity,
        };
        match self.visibility {
            Some(visibility) => attenuated * visibility,
            None => attenuated,
        }
    }
}

impl PlacedLight {
    /// A light at `position`, shining along `direction`; of a light that has no place or no
    /// direction, either may be anything.
    ///
    /// The direction is brought to unit length. Coordinates that aren't finite become 0, and
    /// intensities are kept within 1e10, so that no later product overflows.
    #[must_use]
    pub fn new(mut light: Light, position: [f32; 3], direction: [f32; 3]) -> Self {
        for color in [&mut light.ambient, &mut light.diffuse, &mut light.specular] {
            *color = bounded(*color);
        }
        let limit = light.attenuation.limit;
        light.attenuation.limit =
            if limit.is_nan() { 0.0 } else { limit.clamp(0.0, Attenuation::NO_LIMIT) };
        let position = position.map(finite);
        let direction = direction.map(finite);
        // Brought near 1 first: the square of a huge or tiny length is not an `f32`.
        let largest = direction.into_iter().fold(0.0_f32, |largest, c| largest.max(c.abs()));
        let direction = if largest > 0.0 { direction.map(|c| c / largest) } else { direction };
        let [x, y, z] = direction;
        let direction = Vec3::new(x, y, z).normalized_or_zero().lane(0);
        let has_ambient = light.ambient != [0.0; 3];
        let upstream = direction.map(|component| -component);
        Self { light, has_ambient, position, direction, upstream }
    }

    /// Kind, intensities and attenuation.
    #[must_use]
    pub fn light(&self) -> &Light {
        &self.light
    }

    /// Whether it has any ambient intensity.
    pub(crate) fn has_ambient(&self) -> bool {
        self.has_ambient
    }

    /// The position, relative to the eye.
    #[must_use]
    pub fn position(&self) -> [f32; 3] {
        self.position
    }

    /// The direction in which its light travels, of unit length.
    #[must_use]
    pub fn direction(&self) -> [f32; 3] {
        self.direction
    }

    /// How much light arrives at `position`, relative to the eye, in its strongest channel: what a white
    /// Lambert surface that faces the light reflects, and the light's ambient part.
    #[must_use]
    pub fn arriving(&self, [x, y, z]: [f32; 3]) -> f32 {
        let sample = self.sample(Vec3::new(x, y, z));
        let Light { ambient, diffuse, .. } = &self.light;
        let sum = |at: usize| ambient[at] + diffuse[at];
        sample.attenuation * sample.spot * sum(0).max(sum(1)).max(sum(2)).max(0.0)
    }

    /// L at a place about the eye: the unit vector towards the light; 0 at the light itself.
    #[inline(always)]
    pub fn to_light<N: Lanes>(&self, position: Vec3<N>) -> Vec3<N> {
        self.sample(position).to_light
    }

    /// The incident light at `position`.
    #[inline(always)]
    pub(crate) fn sample<N: Lanes>(&self, position: Vec3<N>) -> LightSample<N> {
        let simd = position.x;
        if matches!(self.light.kind, LightKind::Directional | LightKind::Ambient) {
            return LightSample {
                to_light: Vec3::splat(simd, self.upstream),
                distance: None,
                attenuation: simd.one(),
                spot: simd.one(),
                visibility: None,
            };
        }
        let way = Vec3::splat(simd, self.position) - position;
        let squared = way.dot(way);
        // False at the light itself, and where the way is too long for its square.
        let apart = squared.zero().less(squared) & squared.less(simd.constant(f32::INFINITY));
        let distance = squared.masked(apart).sqrt();
        let to_light = way.select(apart, Vec3::splat(simd, [0.0; 3]))
            * (simd.one() / distance.select(apart, simd.one()));
        let attenuation = self.attenuation(distance).masked(apart);
        let spot = match self.light.kind {
            LightKind::Spot(cone) => {
                cone.brightness((-to_light).dot(Vec3::splat(simd, self.direction)))
            }
            _ => simd.one(),
        };
        LightSample { to_light, distance: Some(distance), attenuation, spot, visibility: None }
    }

    /// min(1 / (c1 + c2 d + c3 d^2), limit), 0 where that isn't positive; times glTF's window.
    #[inline(always)]
    fn attenuation<N: Lanes>(&self, distance: N) -> N {
        let [c1, c2, c3] = self.light.attenuation.coefficients;
        let divisor = distance.constant(c1)
            + distance.constant(c2) * distance
            + distance.constant(c3) * distance * distance;
        let positive = divisor.zero().less(divisor);
        let attenuation = (divisor.one() / divisor.select(positive, divisor.one()))
            .minimum(divisor.constant(self.light.attenuation.limit))
            .masked(positive);
        match self.light.attenuation.range {
            Some(range) => attenuation * window(distance, range),
            None => attenuation,
        }
    }
}

/// max(min(1 - (d / range)^4, 1), 0) (glTF `KHR_lights_punctual`).
#[inline(always)]
fn window<N: Lanes>(distance: N, range: f32) -> N {
    let ratio = distance / distance.constant(range.max(f32::MIN_POSITIVE));
    let square = ratio * ratio;
    (ratio.one() - square * square).clamped(0.0, 1.0)
}

impl Cone {
    /// The spot factor at this cosine of the angle to the axis.
    ///
    /// Lights at infinity have no cone here; OpenGL 1.x gives them one (section 2.13.1), whose factor is the same at all
    /// points: it can be put into their intensities.
    #[inline(always)]
    pub fn brightness<N: Lanes>(self, cosine: N) -> N {
        match self {
            Self::Exponent { cos_cutoff, exponent } => {
                // A negative exponent would make light grow without bound at the cone's edge.
                let base = cosine.clamped(0.0, 1.0);
                let brightness = elementary::power_of_one_exponent(base, exponent.max(0.0));
                // Rounding may take a cosine below -1: without a cone everything is inside.
                let everywhere = cosine.equal(cosine).splat_like(cos_cutoff <= -1.0);
                brightness.masked(cosine.constant(cos_cutoff).less_or_equal(cosine) | everywhere)
            }
            Self::Smooth { cos_inner, cos_outer } => {
                // The specification's own guard against cones of equal angles.
                let width = (cos_inner - cos_outer).max(1e-3);
                let t = ((cosine - cosine.constant(cos_outer)) / cosine.constant(width))
                    .clamped(0.0, 1.0);
                t * t
            }
        }
    }
}

fn finite(value: f32) -> f32 {
    if value.is_finite() { value } else { 0.0 }
}
