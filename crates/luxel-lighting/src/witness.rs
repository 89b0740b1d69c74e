//! Observers of the terms of the equation.

use luxel_math::{Rgb, Vec3};

/// The contribution of one light, factor by factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightTerms<N> {
    /// L: towards the light, of unit length.
    pub to_light: Vec3<N>,
    /// d: the distance to the light; `None` for directional lights.
    pub distance: Option<N>,
    /// The factor for distance.
    pub attenuation: N,
    /// The factor of the cone.
    pub spot: N,
    /// V: the part of the light that nothing keeps away, which is a factor of all three terms; `None`
    /// without shadows.
    pub visibility: Option<N>,
    /// N.L as it is, negative where the light is behind.
    pub n_dot_l: N,
    /// The cosine of the highlight as it is: R.V, N.H or V.L; `None` where the model has none, or
    /// several.
    pub specular_cosine: Option<N>,
    /// f I_a k_a O_a
    pub ambient: Rgb<N>,
    /// The diffuse term.
    pub diffuse: Rgb<N>,
    /// The specular term.
    pub specular: Rgb<N>,
}

/// The reflection of one light by one model, before intensity and attenuation.
///
/// A mix has several parts, all other models one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PartTerms<N> {
    /// w: how much of the part is in the mix; 1 outside of mixes.
    pub weight: f32,
    /// The factor of I_d, not weighted.
    pub diffuse: Rgb<N>,
    /// The factor of I_s, not weighted.
    pub specular: Rgb<N>,
    /// The cosine of the highlight as it is: R.V, N.H or V.L; `None` where the model has none.
    pub specular_cosine: Option<N>,
    /// Factors that only this model has.
    pub lobe: Lobe<N>,
}

/// Factors that only some models of reflection have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Lobe<N> {
    /// Nothing beyond cosines and their powers.
    Plain,
    /// Factors that replace the cosines: one of I_d, one of I_s.
    Factors {
        /// The factor of the diffuse term.
        diffuse: N,
        /// The factor of the specular term.
        specular: N,
    },
    /// Oren and Nayar's A + B max(cos(phi_r - phi_i), 0) sin(alpha) tan(beta).
    Rough(N),
    /// Torrance and Sparrow's facets.
    Facets {
        /// pi D: how many of the facets mirror the light to the eye.
        pi_d: N,
        /// V: masking and shadowing, over 4 (N.L) (N.V).
        visibility: N,
        /// F: the Fresnel reflectance.
        fresnel: Rgb<N>,
    },
}

/// The environment reflected by one model, before k_s O_s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorTerms<N> {
    /// w: how much of it is in the mix; 1 outside of mixes.
    pub weight: f32,
    /// The part that is mirrored: F0 A + B of a microfacet surface, 1 of a mirror.
    pub share: Rgb<N>,
    /// E(R), as blurred as the surface is rough.
    pub radiance: Rgb<N>,
}

/// The diffuse reflection of the environment by one model, before k_d O_d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DiffuseTerms<N> {
    /// w: how much of it is in the mix; 1 outside of mixes.
    pub weight: f32,
    /// The part that is reflected to all sides: 1 but for microfacet surfaces.
    pub share: Rgb<N>,
    /// E(N) / pi: the irradiance over pi.
    pub irradiance: Rgb<N>,
}

/// The terms that belong to no single light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terms<N> {
    /// The emitted light.
    pub emission: Rgb<N>,
    /// I_a k_a O_a
    pub scene_ambient: Rgb<N>,
    /// The reflected environment, mirrored and diffuse.
    pub environment: Rgb<N>,
    /// ((emission + scene_ambient) + every light's ambient, diffuse and specular) + environment,
    /// from left to right.
    pub sum: Rgb<N>,
}

/// Hears every term of the equation. Each method does nothing unless it is written.
pub trait Witness<N> {
    /// A part of the model, by its index in the mixture, for the light that [`Self::light`] reports
    /// next.
    #[inline(always)]
    fn part(&mut self, index: usize, terms: &PartTerms<N>) {
        let _ = (index, terms);
    }

    /// A part of the model that mirrors the environment, by its place in the mix.
    #[inline(always)]
    fn mirror(&mut self, index: usize, terms: &MirrorTerms<N>) {
        let _ = (index, terms);
    }

    /// A part of the model that reflects the environment to all sides, by its place in the mix.
    #[inline(always)]
    fn diffuse(&mut self, index: usize, terms: &DiffuseTerms<N>) {
        let _ = (index, terms);
    }

    /// The diffuse part of the environment's term, if the environment is a map.
    #[inline(always)]
    fn environment_diffuse(&mut self, diffuse: Rgb<N>) {
        let _ = diffuse;
    }

    /// Openness, a factor of the ambient terms and of the environment.
    #[inline(always)]
    fn openness(&mut self, openness: N) {
        let _ = openness;
    }

    /// The terms of the light at this place of the list.
    #[inline(always)]
    fn light(&mut self, index: usize, terms: &LightTerms<N>) {
        let _ = (index, terms);
    }

    /// The terms that belong to no single light, and the sum of all.
    #[inline(always)]
    fn terms(&mut self, terms: &Terms<N>) {
        let _ = terms;
    }

    /// s and I_dc, where there is fog.
    #[inline(always)]
    fn fog(&mut self, factor: N, color: Rgb<N>) {
        let _ = (factor, color);
    }

    /// The sum, after fog.
    #[inline(always)]
    fn color(&mut self, color: Rgb<N>) {
        let _ = color;
    }
}

/// Hears nothing, and costs nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Silent;

impl<N> Witness<N> for Silent {}

/// Writes every term of one point down.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ledger {
    /// The contribution of each light, in the order of the list.
    pub lights: Vec<LedgerLight>,
    /// The reflected environment, by parts of the model.
    pub mirrors: Vec<(usize, MirrorTerms<f32>)>,
    /// The environment reflected to all sides, by parts of the model.
    pub diffused: Vec<(usize, DiffuseTerms<f32>)>,
    /// The parts of the light that comes next.
    parts: Vec<(usize, PartTerms<f32>)>,
    /// The emitted light.
    pub emission: [f32; 3],
    /// I_a k_a O_a
    pub scene_ambient: [f32; 3],
    /// The reflected environment, mirrored and diffuse.
    pub environment: [f32; 3],
    /// The diffuse part of it; `None` where the environment isn't a map.
    pub environment_diffuse: Option<[f32; 3]>,
    /// The sum of all terms.
    pub sum: [f32; 3],
    /// s and I_dc, where there is fog.
    pub fog: Option<(f32, [f32; 3])>,
    /// The sum, after fog.
    pub color: [f32; 3],
}

/// The contribution of one light in a [`Ledger`].
#[derive(Clone, Debug, PartialEq)]
pub struct LedgerLight {
    /// The place in the list of lights.
    pub index: usize,
    /// The parts of the model, by their index in the mixture.
    pub parts: Vec<(usize, PartTerms<f32>)>,
    /// The terms.
    pub terms: LightTerms<f32>,
}

impl Witness<f32> for Ledger {
    fn light(&mut self, index: usize, terms: &LightTerms<f32>) {
        let parts = std::mem::take(&mut self.parts);
        self.lights.push(LedgerLight { index, parts, terms: *terms });
    }

    fn part(&mut self, index: usize, terms: &PartTerms<f32>) {
        self.parts.push((index, *terms));
    }

    fn mirror(&mut self, index: usize, terms: &MirrorTerms<f32>) {
        self.mirrors.push((index, *terms));
    }

    fn diffuse(&mut self, index: usize, terms: &DiffuseTerms<f32>) {
        self.diffused.push((index, *terms));
    }

    fn environment_diffuse(&mut self, diffuse: Rgb<f32>) {
        self.environment_diffuse = Some(diffuse.lane(0));
    }

    fn terms(&mut self, terms: &Terms<f32>) {
        self.emission = terms.emission.lane(0);
        self.scene_ambient = terms.scene_ambient.lane(0);
        self.environment = terms.environment.lane(0);
        self.sum = terms.sum.lane(0);
    }

    fn fog(&mut self, factor: f32, color: Rgb<f32>) {
        self.fog = Some((factor, color.lane(0)));
    }

    fn color(&mut self, color: Rgb<f32>) {
        self.color = color.lane(0);
    }
}
