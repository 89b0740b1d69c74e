//! Reflection of lights and environment, for all models.

use super::microfacet;
use crate::coefficients::broadcast;
use crate::environment::split_sum;
use crate::{
    Broadcast, Coefficients, DiffuseTerms, Environment, Lobe, MirrorTerms, OrientedMap, PartTerms,
    Reflection, SurfacePoint, Witness,
};
use luxel_math::{Lanes, Mask, Rgb, Vec3};

/// A surface point, prepared once for all lights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a, N, K> {
    /// N
    pub(crate) normal: Vec3<N>,
    /// V
    pub(crate) view: Vec3<N>,
    /// N.V as it is, for [`Reflection::Phong`], alone or in a mix; 0 for others.
    ///
    /// Computed light by light, the compiler would move it before the loop over lights, for all models.
    pub(crate) phong_n_dot_v: N,
    /// The coefficients, independent of N and V.
    pub(crate) of: &'a Coefficients<K>,
}

/// The reflected fraction of a light's intensity.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reflected<N> {
    /// Of I_d.
    pub(crate) diffuse: Rgb<N>,
    /// Of I_s.
    pub(crate) specular: Rgb<N>,
    /// The cosine of the highlight as it is.
    pub(crate) specular_cosine: Option<N>,
    /// Factors of the model's own.
    pub(crate) lobe: Lobe<N>,
}

impl<N: Lanes> Reflected<N> {
    /// Nothing of any light; `simd` selects the lane type.
    #[inline(always)]
    pub(crate) fn nothing(simd: N) -> Self {
        let (diffuse, specular) = (Rgb::black(simd), Rgb::black(simd));
        Self { diffuse, specular, specular_cosine: None, lobe: Lobe::Plain }
    }
}

/// A light as one surface point meets it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Incidence<N> {
    /// L
    pub(crate) to_light: Vec3<N>,
    /// N.L as it is.
    pub(crate) n_dot_l: N,
}

impl<'a, N: Lanes, K: Broadcast<N>> Surface<'a, N, K> {
    /// The surface at a point.
    #[inline(always)]
    pub(crate) fn new(
        point: &SurfacePoint<N>,
        coefficients: &'a Coefficients<K>,
        reflection: &Reflection,
    ) -> Self {
        let SurfacePoint { normal, view, .. } = *point;
        let phong_n_dot_v = match reflection {
            Reflection::Phong | Reflection::Mixed(_) => normal.dot(view),
            _ => normal.x.zero(),
        };
        Self { normal, view, phong_n_dot_v, of: coefficients }
    }

    /// N.V as it is.
    #[inline(always)]
    pub(crate) fn n_dot_v(&self) -> N {
        self.normal.dot(self.view)
    }

    /// Selects the lane type.
    #[inline(always)]
    pub(crate) fn simd(&self) -> N {
        self.normal.x
    }

    /// k_d O_d
    #[inline(always)]
    pub(crate) fn diffuse(&self) -> Rgb<N> {
        broadcast(self.of.diffuse, self.simd())
    }

    /// k_s O_s
    #[inline(always)]
    pub(crate) fn specular(&self) -> Rgb<N> {
        broadcast(self.of.specular, self.simd())
    }

    /// Perceptual roughness, within 0 and 1.
    #[inline(always)]
    pub(crate) fn roughness(&self) -> N {
        self.of.roughness.broadcast(self.simd())
    }

    /// Within 0 and 1.
    #[inline(always)]
    pub(crate) fn metallic(&self) -> N {
        self.of.metallic.broadcast(self.simd())
    }

    /// The light of one source reflected to the eye.
    #[inline(always)]
    pub(crate) fn reflected<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        incidence: &Incidence<N>,
        witness: &mut W,
    ) -> Reflected<N> {
        if let Some(whole) = self.by_cosines(reflection, incidence) {
            let Reflected { diffuse, specular, specular_cosine, lobe } = whole;
            let terms = PartTerms { weight: 1.0, diffuse, specular, specular_cosine, lobe };
            witness.part(0, &terms);
            return whole;
        }
        // Copies, because a witness needs its arguments in memory, and only here.
        let (surface, incidence) = (*self, *incidence);
        let mut whole = Reflected::nothing(self.simd());
        surface.sum_parts(reflection, &incidence, witness, &mut whole);
        whole
    }

    /// Sums the parts of a model. Outlined, because it is much code: inlined into its callers,
    /// it would take the registers of simpler models.
    #[inline(never)]
    fn sum_parts<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        incidence: &Incidence<N>,
        witness: &mut W,
        whole: &mut Reflected<N>,
    ) {
        self.simd().vectorized(
            #[inline(always)]
            || {
                for index in 0..reflection.part_count() {
                    let (kind, weight) = reflection.part(index);
                    let part = self.part_reflected(kind, incidence);
                    let Reflected { diffuse, specular, specular_cosine, lobe } = part;
                    let terms = PartTerms { weight, diffuse, specular, specular_cosine, lobe };
                    witness.part(index, &terms);
                    let weight = self.simd().constant(weight);
                    whole.diffuse = whole.diffuse + diffuse * weight;
                    whole.specular = whole.specular + specular * weight;
                    whole.specular_cosine = specular_cosine;
                }
                if reflection.part_count() > 1 {
                    whole.specular_cosine = None;
                }
            },
        );
    }

    /// The reflection of the environment.
    ///
    /// An ideal mirror: k_s O_s E(R), R = 2 N (N.V) - V. A microfacet surface: k_s O_s (F0 A + B)
    /// E(R) with E blurred by its roughness (see [`split_sum`]). All of it occluded.
    #[inline(never)]
    pub(crate) fn mirrored<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        environment: &Environment,
        witness: &mut W,
    ) -> Rgb<N> {
        self.simd().vectorized(
            #[inline(always)]
            || self.mirrored_of(reflection, environment, witness),
        )
    }

    #[inline(always)]
    fn mirrored_of<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        environment: &Environment,
        witness: &mut W,
    ) -> Rgb<N> {
        let simd = self.simd();
        let mut mirrored = Rgb::black(simd);
        let n_dot_v = self.n_dot_v();
        let direction = self.normal * (n_dot_v + n_dot_v) - self.view;
        for index in 0..reflection.part_count() {
            let (kind, weight) = reflection.part(index);
            let part = match kind {
                Reflection::Mirror => {
                    let radiance = environment.radiance(direction, simd.zero());
                    let share = Rgb::new(simd.one(), simd.one(), simd.one());
                    witness.mirror(index, &MirrorTerms { weight, share, radiance });
                    radiance
                }
                Reflection::Microfacet => {
                    let (a, b) = split_sum(n_dot_v.clamped(0.0, 1.0), self.roughness());
                    let share = microfacet::facing_reflectance(self) * a + Rgb::new(b, b, b);
                    let radiance = environment.radiance(direction, self.roughness());
                    witness.mirror(index, &MirrorTerms { weight, share, radiance });
                    radiance * share
                }
                _ => continue,
            };
            mirrored = mirrored + part * simd.constant(weight);
        }
        mirrored * self.specular() * self.of.occlusion.broadcast(simd)
    }

    /// The diffuse reflection of the environment's light: k_d O_d E(N) / pi, E the irradiance.
    ///
    /// That is Lambert's law, also for models with another one: Oren and Nayar's differs little under light
    /// from all around, and steps of toon shading are steps of a light's cosine. Of a microfacet surface
    /// it is the part that is neither mirrored nor a metal's: (1 - metallic) (1 - (F0 A + B)). An ideal mirror has
    /// none. All of it occluded.
    #[inline(never)]
    pub(crate) fn diffused<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        map: &OrientedMap,
        witness: &mut W,
    ) -> Rgb<N> {
        self.simd().vectorized(
            #[inline(always)]
            || self.diffused_of(reflection, map, witness),
        )
    }

    #[inline(always)]
    fn diffused_of<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        map: &OrientedMap,
        witness: &mut W,
    ) -> Rgb<N> {
        let simd = self.simd();
        let irradiance = map.irradiance(self.normal);
        let mut whole = Rgb::black(simd);
        for index in 0..reflection.part_count() {
            let (kind, weight) = reflection.part(index);
            let white = Rgb::splat(simd, [1.0; 3]);
            let share = match kind {
                Reflection::Unlit | Reflection::Mirror | Reflection::Mixed(_) => continue,
                Reflection::Microfacet => {
                    let (a, b) = split_sum(self.n_dot_v().clamped(0.0, 1.0), self.roughness());
                    let mirrored = microfacet::facing_reflectance(self) * a + Rgb::new(b, b, b);
                    (white - mirrored) * (simd.one() - self.metallic())
                }
                _ => white,
            };
            witness.diffuse(index, &DiffuseTerms { weight, share, irradiance });
            whole = whole + share * irradiance * simd.constant(weight);
        }
        whole * self.diffuse() * self.of.occlusion.broadcast(simd)
    }

    /// The coefficient of ambient light: k_a O_a.
    ///
    /// Of a microfacet surface that has an environment to mirror, only (1 - metallic) k_a O_a: a
    /// metal reflects its surroundings as a mirror does and not as paper does, and the environment
    /// is these surroundings. Without one, the ambient light is all that a metal has of them.
    #[inline(always)]
    pub(crate) fn ambient(&self, reflection: &Reflection, has_environment: bool) -> Rgb<N> {
        let simd = self.simd();
        match reflection {
            Reflection::Unlit => Rgb::black(simd),
            Reflection::Microfacet if has_environment => {
                broadcast(self.of.ambient, simd) * (simd.one() - self.metallic())
            }
            _ => broadcast(self.of.ambient, simd),
        }
    }
}

/// Whether any lane has the light before it.
#[inline(always)]
pub(super) fn any_lit<N: Lanes>(incidence: &Incidence<N>) -> bool {
    incidence.n_dot_l.zero().less(incidence.n_dot_l).any()
}
