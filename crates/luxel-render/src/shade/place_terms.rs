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
        let kept = [0, 1, 2].map(|channel| match sum[channel] == light[channel] {
            true => 1.0,
            false => light[channel] / sum[channel],
        });
        Self { emission, scene_ambient, environment, environment_diffuse, lights, kept }
    }
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

/// The terms that reach samples: each place's terms by its weight, as much of them as clamping leaves, times a
/// texture.
pub(crate) struct MixedTerms<N> {
    pub(crate) emission: Rgb<N>,
    pub(crate) scene_ambient: Rgb<N>,
    pub(crate) environment: Rgb<N>,
    pub(crate) environment_diffuse: Option<Rgb<N>>,
    pub(crate) lights: Vec<MixedLight<N>>,
}

/// The terms of one light that reach samples.
pub(crate) struct MixedLight<N> {
    /// The place in the list of lights.
    pub(crate) index: usize,
    pub(crate) ambient: Rgb<N>,
    pub(crate) diffuse: Rgb<N>,
    pub(crate) specular: Rgb<N>,
    /// The mean of the places'.
    pub(crate) n_dot_l: N,
    /// V; `None` without shadows.
    pub(crate) visibility: Option<N>,
}

impl<N: Lanes> MixedTerms<N> {
    /// Of places with their weights at each lane's sample.
    #[inline(always)]
    pub(crate) fn of(places: &[(N, &PlaceTerms)], texture: Rgb<N>) -> Self {
        let mut lights = Vec::new();
        for (at, light) in
            places.first().map_or(&[][..], |(_, place)| &place.lights).iter().enumerate()
        {
            let mut n_dot_l = texture.r.zero();
            for (weight, place) in places {
                n_dot_l = n_dot_l + *weight * n_dot_l.constant(place.lights[at].terms.n_dot_l);
            }
            lights.push(MixedLight {
                index: light.index,
                ambient: mixed(places, texture, |place| place.lights[at].terms.ambient.lane(0)),
                diffuse: mixed(places, texture, |place| place.lights[at].terms.diffuse.lane(0)),
                specular: mixed(places, texture, |place| place.lights[at].terms.specular.lane(0)),
                n_dot_l,
                visibility: None,
            });
        }
        let mut environment_diffuse = None;
        if places.first().is_some_and(|(_, place)| place.environment_diffuse.is_some()) {
            let of = |place: &PlaceTerms| place.environment_diffuse.unwrap_or_default();
            environment_diffuse = Some(mixed(places, texture, of));
        }
        Self {
            emission: mixed(places, texture, |place| place.emission),
            scene_ambient: mixed(places, texture, |place| place.scene_ambient),
            environment: mixed(places, texture, |place| place.environment),
            environment_diffuse,
            lights,
        }
    }

    /// The same where light is kept away from a sample: each light's terms times its V, what comes from
    /// all around times the openness.
    #[inline(always)]
    pub(crate) fn visible(mut self, scene: &ShadingContext<'_>, visible: &VisibleLights) -> Self {
        let simd = self.emission.r;
        let openness = simd.constant(visible.openness);
        self.scene_ambient = self.scene_ambient * openness;
        self.environment = self.environment * openness;
        self.environment_diffuse = self.environment_diffuse.map(|light| light * openness);
        let has_shadows = scene.shadows.is_some_and(|shadows| !shadows.sources.is_empty());
        for light in &mut self.lights {
            let visibility = simd.constant(visible.visibility[light.index].unwrap_or(1.0));
            light.visibility = has_shadows.then_some(visibility);
            light.ambient = light.ambient * (visibility * openness);
            light.diffuse = light.diffuse * visibility;
            light.specular = light.specular * visibility;
        }
        self
    }
}

/// A term of all places.
#[inline(always)]
fn mixed<N: Lanes>(
    places: &[(N, &PlaceTerms)],
    texture: Rgb<N>,
    of: impl Fn(&PlaceTerms) -> [f32; 3],
) -> Rgb<N> {
    let mut sum = Rgb::black(texture.r);
    for (weight, place) in places {
        let kept = Rgb::splat(*weight, place.kept);
        sum = sum + kept * *weight * Rgb::splat(*weight, of(place)) * texture;
    }
    sum
}
