//! Terms of light that was computed elsewhere than at a sample: those of each place, and what reaches the sample.

use super::shadowed::VisibleLights;
use crate::context::{AttributeMask, ShadingContext};
use crate::material::{Corner, SurfaceWitness, light_at, light_under};
use luxel_lighting::{Ledger, LedgerLight, LightTerms, Terms, Witness};
use luxel_math::Rgb;

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
    /// The sum of all terms.
    sum: [f32; 3],
    /// What is interpolated: the sum, clamped if the view says so.
    light: [f32; 3],
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
        Self { emission, scene_ambient, environment, environment_diffuse, lights, sum, light }
    }

    /// The part of a channel that clamping leaves.
    pub(crate) fn kept(&self, channel: usize) -> f32 {
        let (sum, light) = (self.sum[channel], self.light[channel]);
        if sum == light { 1.0 } else { light / sum }
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

/// The terms that reach a sample: each place's terms by its weight, as much of them as clamping leaves, times a
/// texture.
pub(crate) struct MixedTerms {
    pub(crate) emission: [f32; 3],
    pub(crate) scene_ambient: [f32; 3],
    pub(crate) environment: [f32; 3],
    pub(crate) environment_diffuse: Option<[f32; 3]>,
    pub(crate) lights: Vec<MixedLight>,
}

/// The terms of one light that reach a sample.
pub(crate) struct MixedLight {
    /// The place in the list of lights.
    pub(crate) index: usize,
    pub(crate) ambient: [f32; 3],
    pub(crate) diffuse: [f32; 3],
    pub(crate) specular: [f32; 3],
    /// The mean of the places'.
    pub(crate) n_dot_l: f32,
    /// V; `None` without shadows.
    pub(crate) visibility: Option<f32>,
}

impl MixedTerms {
    pub(crate) fn of(places: &[(f32, &PlaceTerms)], texture: [f32; 3]) -> Self {
        let color = |of: &dyn Fn(&PlaceTerms) -> [f32; 3]| -> [f32; 3] {
            std::array::from_fn(|channel| {
                let part = |&(weight, place): &(f32, &PlaceTerms)| {
                    weight * place.kept(channel) * of(place)[channel] * texture[channel]
                };
                places.iter().map(part).sum()
            })
        };
        let first = places.first().map_or(&[][..], |(_, place)| &place.lights);
        let light = |(number, light): (usize, &LedgerLight)| {
            let terms = |place: &PlaceTerms| place.lights[number].terms;
            MixedLight {
                index: light.index,
                ambient: color(&|place| terms(place).ambient.lane(0)),
                diffuse: color(&|place| terms(place).diffuse.lane(0)),
                specular: color(&|place| terms(place).specular.lane(0)),
                n_dot_l: places.iter().map(|(weight, place)| weight * terms(place).n_dot_l).sum(),
                visibility: None,
            }
        };
        Self {
            emission: color(&|place| place.emission),
            scene_ambient: color(&|place| place.scene_ambient),
            environment: color(&|place| place.environment),
            environment_diffuse: places
                .first()
                .and_then(|(_, place)| place.environment_diffuse)
                .map(|_| color(&|place| place.environment_diffuse.unwrap_or_default())),
            lights: first.iter().enumerate().map(light).collect(),
        }
    }

    /// The same where light is kept away from a sample: each light's terms times its V, what comes from
    /// all around times the openness.
    pub(crate) fn visible(mut self, scene: &ShadingContext<'_>, visible: &VisibleLights) -> Self {
        let around = |light: [f32; 3]| light.map(|channel| channel * visible.openness);
        self.scene_ambient = around(self.scene_ambient);
        self.environment = around(self.environment);
        self.environment_diffuse = self.environment_diffuse.map(around);
        let has_shadows = scene.shadows.is_some_and(|shadows| !shadows.sources.is_empty());
        for light in &mut self.lights {
            let visibility = visible.visibility[light.index].unwrap_or(1.0);
            light.visibility = has_shadows.then_some(visibility);
            light.ambient = light.ambient.map(|channel| channel * (visibility * visible.openness));
            light.diffuse = light.diffuse.map(|channel| channel * visibility);
            light.specular = light.specular.map(|channel| channel * visibility);
        }
        self
    }
}
