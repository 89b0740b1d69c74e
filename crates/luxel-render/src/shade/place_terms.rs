//! Terms of light that was computed elsewhere than at a sample: those of each place, and what reaches the sample.

use super::shadowed::VisibleLights;
use crate::context::{AttributeMask, ShadingContext};
use crate::material::{Corner, SurfaceWitness, light_at, light_under};
use luxel_lighting::{Ledger, LedgerLight, LightTerms, Terms, Witness};
use luxel_math::{Lanes, Rgb};

/// A place of a triangle where light was computed, and how much of it a sample takes.
pub(crate) struct LitPlace {
    pub(crate) weight: f32,
    /// Among the triangle's places.
    pub(crate) number: u32,
    pub(crate) corner: Corner,
}

/// The terms of one place.
#[derive(Clone, Debug)]
pub(crate) struct PlaceTerms {
    pub(crate) emission: [f32; 3],
    pub(crate) scene_ambient: [f32; 3],
    pub(crate) environment: [f32; 3],
    environment_diffuse: Option<[f32; 3]>,
    pub(crate) lights: Vec<LedgerLight>,
    /// The part of each channel that clamping leaves.
    pub(crate) kept: [f32; 3],
}

impl PlaceTerms {
    /// Lights a place again, with its terms written down: under a texel, if pieces are lit for every texel.
    pub(super) fn of(
        scene: &ShadingContext<'_>,
        corner: &Corner,
        (has, material): (AttributeMask, u32),
        texel: Option<[f32; 3]>,
    ) -> Self {
        let mut heard = TermsAlone(Ledger::default());
        let light = match texel {
            Some(texel) => light_under(scene, corner, has, material, texel, &mut heard),
            None => light_at(scene, corner, has, material, &mut heard),
        };
        let Ledger { emission, scene_ambient, environment, environment_diffuse, .. } = heard.0;
        let Ledger { sum, lights, .. } = heard.0;
        let kept = kept_of(Rgb::splat(0.0, sum), Rgb::splat(0.0, light)).lane(0);
        Self { emission, scene_ambient, environment, environment_diffuse, lights, kept }
    }

    fn environment_diffuse(&self) -> Option<Rgb<f32>> {
        self.environment_diffuse.map(|light| Rgb::splat(0.0, light))
    }
}

/// The part of each channel of a sum of terms that clamping leaves as light.
#[inline(always)]
pub(super) fn kept_of<N: Lanes>(sum: Rgb<N>, light: Rgb<N>) -> Rgb<N> {
    let kept = |sum: N, light: N| sum.one().select(sum.equal(light), light / sum);
    Rgb::new(kept(sum.r, light.r), kept(sum.g, light.g), kept(sum.b, light.b))
}

/// Writes down the terms of a place, without the parts of models.
struct TermsAlone(Ledger);

impl Witness<f32> for TermsAlone {
    fn light(&mut self, index: usize, terms: &LightTerms<f32>) {
        self.0.light(index, terms);
    }

    fn environment_diffuse(&mut self, diffuse: Rgb<f32>) {
        self.0.environment_diffuse(diffuse);
    }

    fn terms(&mut self, terms: &Terms<f32>) {
        self.0.terms(terms);
    }
}

impl SurfaceWitness<f32> for TermsAlone {}

/// A colour among the terms of a place.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Term {
    Emission,
    SceneAmbient,
    Environment,
    /// Of a light, by its number.
    Ambient(usize),
    Diffuse(usize),
    Specular(usize),
}

/// The terms of a place, or of one of each lane; `None` for a term that is not kept.
pub(crate) trait TermsOfPlace<N>: Copy {
    /// The part of each channel that clamping leaves; `None` for all of it.
    fn kept(self, simd: N) -> Option<Rgb<N>>;
    fn term(self, simd: N, term: Term) -> Option<Rgb<N>>;
    /// How many lights there are.
    fn lights(self) -> usize;
    fn n_dot_l(self, simd: N, light: usize) -> Option<N>;
}

impl TermsOfPlace<f32> for &PlaceTerms {
    fn kept(self, simd: f32) -> Option<Rgb<f32>> {
        Some(Rgb::splat(simd, self.kept))
    }

    fn term(self, simd: f32, term: Term) -> Option<Rgb<f32>> {
        Some(match term {
            Term::Emission => Rgb::splat(simd, self.emission),
            Term::SceneAmbient => Rgb::splat(simd, self.scene_ambient),
            Term::Environment => Rgb::splat(simd, self.environment),
            Term::Ambient(light) => self.lights[light].terms.ambient,
            Term::Diffuse(light) => self.lights[light].terms.diffuse,
            Term::Specular(light) => self.lights[light].terms.specular,
        })
    }

    fn lights(self) -> usize {
        self.lights.len()
    }

    fn n_dot_l(self, _: f32, light: usize) -> Option<f32> {
        Some(self.lights[light].terms.n_dot_l)
    }
}

/// What reaches samples of the terms of places: those of each place by its weight, as much of them as clamping leaves,
/// times a texture.
pub(crate) struct TermMix<'p, N, P> {
    /// Each with its weight at each lane's sample.
    pub(crate) places: &'p [(N, P)],
    pub(crate) texture: Rgb<N>,
}

/// The terms of one light that reach samples.
pub(crate) struct MixedLight<N> {
    pub(crate) ambient: Rgb<N>,
    pub(crate) diffuse: Rgb<N>,
    pub(crate) specular: Rgb<N>,
    /// The mean of the places'.
    pub(crate) n_dot_l: N,
    /// V; `None` without shadows.
    pub(crate) visibility: Option<N>,
}

impl<N: Lanes, P: TermsOfPlace<N>> TermMix<'_, N, P> {
    /// How many lights there are.
    #[inline(always)]
    pub(crate) fn lights(&self) -> usize {
        self.places.first().map_or(0, |(_, place)| place.lights())
    }

    /// The terms of a light; 0 for those that are not kept.
    #[inline(always)]
    pub(crate) fn light(&self, light: usize) -> MixedLight<N> {
        let simd = self.texture.r.zero();
        let mut n_dot_l = simd;
        for (weight, place) in self.places {
            let Some(cosine) = place.n_dot_l(simd, light) else { break };
            n_dot_l = n_dot_l + *weight * cosine;
        }
        MixedLight {
            ambient: self.sum(Term::Ambient(light)),
            diffuse: self.sum(Term::Diffuse(light)),
            specular: self.sum(Term::Specular(light)),
            n_dot_l,
            visibility: None,
        }
    }

    /// What reaches samples of a term that all places keep, or none.
    ///
    /// Outlined: one copy per lane type.
    #[inline(never)]
    pub(crate) fn sum(&self, term: Term) -> Rgb<N> {
        self.texture.r.vectorized(
            #[inline(always)]
            || {
                self.sum_of(
                    #[inline(always)]
                    |place| place.term(self.texture.r, term),
                )
            },
        )
    }

    #[inline(always)]
    fn sum_of(&self, of: impl Fn(P) -> Option<Rgb<N>>) -> Rgb<N> {
        let mut sum = Rgb::black(self.texture.r);
        for (weight, place) in self.places {
            let Some(term) = of(*place) else { break };
            let arriving = match place.kept(*weight) {
                Some(kept) => kept * *weight * term,
                None => term * *weight,
            };
            sum = sum + arriving * self.texture;
        }
        sum
    }
}

/// The terms that reach one sample.
pub(crate) struct MixedTerms {
    pub(crate) emission: Rgb<f32>,
    pub(crate) scene_ambient: Rgb<f32>,
    pub(crate) environment: Rgb<f32>,
    pub(crate) environment_diffuse: Option<Rgb<f32>>,
    pub(crate) lights: Vec<MixedLight<f32>>,
}

impl MixedTerms {
    /// Of places with their weights.
    pub(crate) fn of(places: &[(f32, &PlaceTerms)], texture: Rgb<f32>) -> Self {
        let mix = TermMix { places, texture };
        let first = places.first();
        let is_map = first.is_some_and(|(_, place)| place.environment_diffuse.is_some());
        Self {
            emission: mix.sum(Term::Emission),
            scene_ambient: mix.sum(Term::SceneAmbient),
            environment: mix.sum(Term::Environment),
            environment_diffuse: is_map.then(|| mix.sum_of(PlaceTerms::environment_diffuse)),
            lights: (0..mix.lights()).map(|light| mix.light(light)).collect(),
        }
    }

    /// The same where light is kept away from a sample: each light's terms times its V, what comes from
    /// all around times the openness.
    pub(crate) fn visible(mut self, scene: &ShadingContext<'_>, visible: &VisibleLights) -> Self {
        let openness = visible.openness;
        self.scene_ambient = self.scene_ambient * openness;
        self.environment = self.environment * openness;
        self.environment_diffuse = self.environment_diffuse.map(|light| light * openness);
        let has_shadows = scene.shadows.is_some_and(|shadows| !shadows.sources.is_empty());
        for (light, visibility) in self.lights.iter_mut().zip(&visible.visibility) {
            let visibility = visibility.unwrap_or(1.0);
            light.visibility = has_shadows.then_some(visibility);
            light.ambient = light.ambient * (visibility * openness);
            light.diffuse = light.diffuse * visibility;
            light.specular = light.specular * visibility;
        }
        self
    }
}

impl MixedLight<f32> {
    /// The same in every lane.
    #[inline(always)]
    pub(crate) fn in_all_lanes<N: Lanes>(&self, simd: N) -> MixedLight<N> {
        let all = |light: Rgb<f32>| Rgb::splat(simd, light.lane(0));
        MixedLight {
            ambient: all(self.ambient),
            diffuse: all(self.diffuse),
            specular: all(self.specular),
            n_dot_l: simd.constant(self.n_dot_l),
            visibility: self.visibility.map(|visibility| simd.constant(visibility)),
        }
    }
}
