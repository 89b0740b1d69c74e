//! The kinds of reflection: which part of a light's intensity a surface sends to the eye.
//!
//! A model gives two factors for each light, one for I_d and one for I_s, without the light's own
//! attenuation; the equation does the rest. No hidden factors: where physics has a BRDF f, the
//! factor is pi f (N.L), so that a white Lambert surface facing a light of intensity 1 sends 1.

mod lambert;
mod microfacet;
mod oren_nayar;
mod phong;

use crate::environment::split_sum;
use crate::witness::{Lobe, MirrorTerms, PartTerms};
use crate::{Coefficients, Environment, Reflection, SurfacePoint, Witness};
use luxel_math::{Mask, Number, Rgb, Vec3};

/// What a surface reflects at one point, prepared once for all lights.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a, N> {
    /// N
    pub(crate) normal: Vec3<N>,
    /// V
    pub(crate) view: Vec3<N>,
    /// N.V as it is.
    pub(crate) n_dot_v: N,
    /// What it reflects, whatever N and V.
    pub(crate) of: &'a Coefficients<N>,
}

/// Which part of a light's intensity goes to the eye.
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

/// A light as one surface point meets it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Incidence<N> {
    /// L
    pub(crate) to_light: Vec3<N>,
    /// N.L as it is.
    pub(crate) n_dot_l: N,
}

impl<'a, N: Number> Surface<'a, N> {
    /// The surface at a point.
    #[inline(always)]
    pub(crate) fn new(point: &SurfacePoint<N>, coefficients: &'a Coefficients<N>) -> Self {
        Self {
            normal: point.normal,
            view: point.view,
            n_dot_v: point.normal.dot(point.view),
            of: coefficients,
        }
    }

    /// What goes to the eye of a light.
    #[inline(always)]
    pub(crate) fn reflected<W: Witness<N>>(
        &self,
        reflection: &Reflection,
        incidence: &Incidence<N>,
        witness: &mut W,
    ) -> Reflected<N> {
        let like = self.n_dot_v;
        let mut whole = Reflected {
            diffuse: Rgb::black(like),
            specular: Rgb::black(like),
            specular_cosine: None,
            lobe: Lobe::Plain,
        };
        for index in 0..reflection.part_count() {
            let (kind, weight) = reflection.part(index);
            let part = self.part_reflected(kind, incidence);
            let Reflected { diffuse, specular, specular_cosine, lobe } = part;
            witness.part(index, &PartTerms { weight, diffuse, specular, specular_cosine, lobe });
            let weight = like.constant(weight);
            whole.diffuse = whole.diffuse + part.diffuse * weight;
            whole.specular = whole.specular + part.specular * weight;
            whole.specular_cosine = part.specular_cosine;
        }
        if reflection.part_count() > 1 {
            whole.specular_cosine = None;
        }
        whole
    }

    #[inline(always)]
    fn part_reflected(&self, kind: &Reflection, incidence: &Incidence<N>) -> Reflected<N> {
        let like = self.n_dot_v;
        match kind {
            Reflection::Lambert => Reflected {
                diffuse: lambert::diffuse(self, incidence),
                specular: Rgb::black(like),
                specular_cosine: None,
                lobe: Lobe::Plain,
            },
            Reflection::OrenNayar => oren_nayar::reflected(self, incidence),
            // One power for the three: code of lanes is long, and the compiler's time dear.
            Reflection::Phong | Reflection::BlinnPhong | Reflection::Retro => {
                let cosine = match kind {
                    Reflection::Phong => phong::r_dot_v(self, incidence),
                    Reflection::BlinnPhong => phong::n_dot_h(self, incidence),
                    _ => self.view.dot(incidence.to_light),
                };
                phong::with_lobe(self, incidence, cosine)
            }
            Reflection::Microfacet => microfacet::reflected(self, incidence),
            // A mirror sends a light to the eye from single points only, of no extent. A mix within
            // a mix has no meaning here: `Reflection::mixed` dissolves it.
            Reflection::Unlit | Reflection::Mirror | Reflection::Mixed(_) => Reflected {
                diffuse: Rgb::black(like),
                specular: Rgb::black(like),
                specular_cosine: None,
                lobe: Lobe::Plain,
            },
        }
    }

    /// What the surface mirrors of its surroundings.
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
        self.n_dot_v.vectorized(
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
        let like = self.n_dot_v;
        let mut mirrored = Rgb::black(like);
        let direction = self.normal * (self.n_dot_v + self.n_dot_v) - self.view;
        for index in 0..reflection.part_count() {
            let (kind, weight) = reflection.part(index);
            let part = match kind {
                Reflection::Mirror => {
                    let radiance = environment.radiance(direction, like.zero());
                    let share = Rgb::new(like.one(), like.one(), like.one());
                    witness.mirror(index, &MirrorTerms { weight, share, radiance });
                    radiance
                }
                Reflection::Microfacet => {
                    let (a, b) = split_sum(self.n_dot_v.limited(0.0, 1.0), self.of.roughness);
                    let share = microfacet::facing_reflectance(self) * a + Rgb::new(b, b, b);
                    let radiance = environment.radiance(direction, self.of.roughness);
                    witness.mirror(index, &MirrorTerms { weight, share, radiance });
                    radiance * share
                }
                _ => continue,
            };
            mirrored = mirrored + part * like.constant(weight);
        }
        mirrored * self.of.specular * self.of.occlusion
    }

    /// The part of ambient light that goes to the eye: k_a O_a.
    ///
    /// Of a microfacet surface that has an environment to mirror, only (1 - metallic) k_a O_a: a
    /// metal reflects its surroundings as a mirror does and not as paper does, and the environment
    /// is these surroundings. Without one, the ambient light is all that a metal has of them.
    #[inline(always)]
    pub(crate) fn ambient(&self, reflection: &Reflection, environment: &Environment) -> Rgb<N> {
        let like = self.n_dot_v;
        match reflection {
            Reflection::Unlit => Rgb::black(like),
            Reflection::Microfacet if !environment.is_none() => {
                self.of.ambient * (like.one() - self.of.metallic)
            }
            _ => self.of.ambient,
        }
    }
}

/// Whether any lane has the light before it.
#[inline(always)]
fn any_lit<N: Number>(incidence: &Incidence<N>) -> bool {
    incidence.n_dot_l.zero().less(incidence.n_dot_l).any()
}
