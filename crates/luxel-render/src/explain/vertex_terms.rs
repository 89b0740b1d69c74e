//! The ledger where light is computed elsewhere than at the pixel: the terms of each place, and what
//! interpolation makes of them.

use super::ledger::{EvaluatedAt, ExplainedLight};
use super::shadow::shadow_of;
use super::written::Written;
use crate::context::ShadingContext;
use crate::material::{Corner, light_at, light_under};
use crate::shade::{LitTriangle, VisibleLights};
use crate::shadow::Receiver;
use luxel_lighting::{DiffuseTerms, LightTerms, MirrorTerms, Reflectance};
use luxel_math::{Rgb, Vec3};
use luxel_scene::SceneLight;

/// Lights a place again, with its terms written down: under a texel, if pieces are lit for every texel.
pub(crate) fn evaluated_at(
    scene: &ShadingContext<'_>,
    triangle: &LitTriangle,
    (weight, corner): &(f32, Corner),
    texel: Option<[f32; 3]>,
    (eye, lights): ([f64; 3], &[&SceneLight]),
) -> EvaluatedAt {
    let mut written = Written::default();
    let (has, material) = (triangle.has, triangle.material);
    let light = match texel {
        Some(texel) => light_under(scene, corner, has, material, texel, &mut written),
        None => light_at(scene, corner, has, material, &mut written),
    };
    let point = written.point;
    let ledger = &written.ledger;
    let constants = &scene.scene.materials[triangle.material as usize].constants;
    EvaluatedAt {
        weight: *weight,
        position: [0, 1, 2].map(|axis| eye[axis] + f64::from(corner.position[axis])),
        normal: point.map(|point| point.normal.lane(0)).unwrap_or_default(),
        view: point.map(|point| point.view.lane(0)).unwrap_or_default(),
        reflectance: written.reflectance.unwrap_or_else(|| Reflectance::of(0.0, constants)),
        lights: written.explained_lights(scene, eye, lights, None),
        emission: ledger.emission,
        scene_ambient: ledger.scene_ambient,
        environment: ledger.environment,
        mirrors: ledger.mirrors.clone(),
        environment_diffuse: ledger.environment_diffuse,
        diffused: ledger.diffused.clone(),
        sum: ledger.sum,
        light,
    }
}

/// The terms that reach the pixel: each place's terms by its weight, as much of them as clamping
/// leaves, times the texture.
pub(crate) struct Interpolated {
    pub(crate) emission: [f32; 3],
    pub(crate) scene_ambient: [f32; 3],
    pub(crate) environment: [f32; 3],
    pub(crate) mirrors: Vec<(usize, MirrorTerms<f32>)>,
    pub(crate) environment_diffuse: Option<[f32; 3]>,
    pub(crate) diffused: Vec<(usize, DiffuseTerms<f32>)>,
    pub(crate) lights: Vec<ExplainedLight>,
}

impl Interpolated {
    pub(crate) fn of(places: &[EvaluatedAt], texture: [f32; 3]) -> Self {
        let color = |of: &dyn Fn(&EvaluatedAt) -> [f32; 3]| -> [f32; 3] {
            std::array::from_fn(|channel| {
                let part = |place: &EvaluatedAt| {
                    place.weight * place.kept(channel) * of(place)[channel] * texture[channel]
                };
                places.iter().map(part).sum()
            })
        };
        let count = places.first().map_or(0, |place| place.lights.len());
        let light = |number: usize| {
            let terms = |place: &EvaluatedAt| place.lights[number].terms;
            let mean = |of: &dyn Fn(&LightTerms<f32>) -> f32| -> f32 {
                places.iter().map(|place| place.weight * of(&terms(place))).sum()
            };
            let first = &places[0].lights[number];
            let rgb = |[r, g, b]: [f32; 3]| Rgb::new(r, g, b);
            let towards = Vec3::new(
                mean(&|terms| terms.to_light.x),
                mean(&|terms| terms.to_light.y),
                mean(&|terms| terms.to_light.z),
            );
            ExplainedLight {
                name: first.name.clone(),
                light: first.light.clone(),
                position: first.position,
                direction: first.direction,
                parts: Vec::new(),
                shadow: None,
                terms: LightTerms {
                    to_light: if places.len() == 1 {
                        first.terms.to_light
                    } else {
                        towards.normalized_or_zero()
                    },
                    distance: first
                        .terms
                        .distance
                        .map(|_| mean(&|terms| terms.distance.unwrap_or_default())),
                    attenuation: mean(&|terms| terms.attenuation),
                    spot: mean(&|terms| terms.spot),
                    visibility: None,
                    n_dot_l: mean(&|terms| terms.n_dot_l),
                    specular_cosine: first
                        .terms
                        .specular_cosine
                        .map(|_| mean(&|terms| terms.specular_cosine.unwrap_or_default())),
                    ambient: rgb(color(&|place| terms(place).ambient.lane(0))),
                    diffuse: rgb(color(&|place| terms(place).diffuse.lane(0))),
                    specular: rgb(color(&|place| terms(place).specular.lane(0))),
                },
            }
        };
        Self {
            emission: color(&|place| place.emission),
            scene_ambient: color(&|place| place.scene_ambient),
            environment: color(&|place| place.environment),
            mirrors: Vec::new(),
            environment_diffuse: places
                .first()
                .and_then(|place| place.environment_diffuse)
                .map(|_| color(&|place| place.environment_diffuse.unwrap_or_default())),
            diffused: Vec::new(),
            lights: (0..count).map(light).collect(),
        }
    }
}

impl Interpolated {
    /// The same where light is kept away from a sample: each light's terms times its V, what comes from
    /// all around times the openness.
    pub(crate) fn visible(
        mut self,
        scene: &ShadingContext<'_>,
        receiver: &Receiver,
        visible: &VisibleLights,
    ) -> Self {
        let around = |light: [f32; 3]| light.map(|channel| channel * visible.openness);
        self.scene_ambient = around(self.scene_ambient);
        self.environment = around(self.environment);
        self.environment_diffuse = self.environment_diffuse.map(around);
        let has_shadows = scene.shadows.is_some_and(|shadows| !shadows.sources.is_empty());
        for (number, (light, &visibility)) in
            self.lights.iter_mut().zip(&visible.visibility).enumerate()
        {
            let terms = &mut light.terms;
            let is_asked = visibility.is_some();
            let visibility = visibility.unwrap_or(1.0);
            terms.visibility = has_shadows.then_some(visibility);
            terms.ambient = terms.ambient * (visibility * visible.openness);
            terms.diffuse = terms.diffuse * visibility;
            terms.specular = terms.specular * visibility;
            light.shadow = shadow_of(scene, receiver, number, is_asked);
        }
        self
    }
}

impl EvaluatedAt {
    /// The part of a channel that clamping leaves.
    fn kept(&self, channel: usize) -> f32 {
        let (sum, light) = (self.sum[channel], self.light[channel]);
        if sum == light { 1.0 } else { light / sum }
    }
}
