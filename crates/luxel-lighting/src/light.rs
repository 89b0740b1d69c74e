//! Light sources, without position and direction.

use crate::LightKind;

/// A source of light, without its place.
///
/// Intensities are linear and may exceed 1. I_a, I_d and I_s are separate, as in Foley et al.
/// (*Computer Graphics: Principles and Practice*, 1990, section 16.1) with the specular colour of
/// its own that OpenGL 1.x gives every light.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Light {
    /// How the light spreads.
    pub kind: LightKind,
    /// I_a: the intensity for the ambient term, 0 by default.
    pub ambient: [f32; 3],
    /// I_d: the intensity for diffuse reflection.
    pub diffuse: [f32; 3],
    /// I_s: the intensity for specular reflection.
    pub specular: [f32; 3],
    /// How the light weakens with distance; directional and ambient lights don't.
    pub attenuation: Attenuation,
    /// The radius of the ball that a point or spot light is, in the world's units: its shadows are soft.
    /// Light itself comes from the middle. 0 by default.
    pub radius: f32,
    /// The angle under which a directional light is seen, in degrees, 0.53 for the sun's: its shadows are
    /// soft. 0 by default.
    pub angle_degrees: f32,
}

/// Attenuation min(1 / (c1 + c2 d + c3 d^2), limit) over the distance d to the light, with glTF's
/// window.
///
/// OpenGL 1.x has no limit (section 2.13.1), and so the default is none; Foley et al. cut the
/// factor at 1 (*Computer Graphics: Principles and Practice*, 1990, section 16.1.2), so that no
/// light is brighter nearby than at its source.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Attenuation {
    /// c1, c2, c3; not all 0.
    pub coefficients: [f32; 3],
    /// The quotient is cut at this, before the window: 1 as Foley et al. have it, or
    /// [`Attenuation::NO_LIMIT`].
    pub limit: f32,
    /// The distance where the light ends: the factor max(min(1 - (d / range)^4, 1), 0) of glTF
    /// `KHR_lights_punctual`. `None`: it never ends.
    pub range: Option<f32>,
}

impl Attenuation {
    /// Attenuation beyond this is taken as this in any case, so that no product overflows: the
    /// surface nearly touches the light.
    pub const NO_LIMIT: f32 = 1e10;
    /// No attenuation: c = (1, 0, 0).
    pub const NONE: Self = Self::new([1.0, 0.0, 0.0]);
    /// The physical law 1 / d^2.
    pub const INVERSE_SQUARE: Self = Self::new([0.0, 0.0, 1.0]);

    /// 1 / (c1 + c2 d + c3 d^2), not cut, without a window.
    #[must_use]
    pub const fn new(coefficients: [f32; 3]) -> Self {
        Self { coefficients, limit: Self::NO_LIMIT, range: None }
    }
}

impl Light {
    /// Makes all its intensities this many times as strong.
    pub fn scale(&mut self, by: f32) {
        for intensity in [&mut self.ambient, &mut self.diffuse, &mut self.specular] {
            *intensity = intensity.map(|channel| channel * by);
        }
    }

    /// A light of one colour for diffuse and specular reflection, unattenuated.
    #[must_use]
    pub const fn new(kind: LightKind, color: [f32; 3]) -> Self {
        Self {
            kind,
            ambient: [0.0; 3],
            diffuse: color,
            specular: color,
            attenuation: Attenuation::NONE,
            radius: 0.0,
            angle_degrees: 0.0,
        }
    }

    /// An ambient light.
    #[must_use]
    pub const fn ambient(color: [f32; 3]) -> Self {
        Self {
            kind: LightKind::Ambient,
            ambient: color,
            diffuse: [0.0; 3],
            specular: [0.0; 3],
            attenuation: Attenuation::NONE,
            radius: 0.0,
            angle_degrees: 0.0,
        }
    }
}

/// Intensities beyond this (either way) are taken as this, so that no product overflows.
const INTENSITY_LIMIT: f32 = 1e10;

/// The intensity as the equation takes it: within 1e10; 0 for NaN.
#[inline(always)]
pub(crate) fn bounded(intensity: [f32; 3]) -> [f32; 3] {
    let [r, g, b] = intensity;
    [bounded_component(r), bounded_component(g), bounded_component(b)]
}

#[inline(always)]
fn bounded_component(value: f32) -> f32 {
    if value.is_nan() { 0.0 } else { value.clamp(-INTENSITY_LIMIT, INTENSITY_LIMIT) }
}
