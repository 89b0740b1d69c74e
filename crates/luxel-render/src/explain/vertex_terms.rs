//! The ledger where light is computed elsewhere than at the pixel: the terms of each place, and what
//! interpolation makes of them.

use super::ledger::{EvaluatedAt, ExplainedLight};
use super::shadow::shadow_of;
use super::written::Written;
use crate::context::ShadingContext;
use crate::material::{light_at, light_under};
use crate::shade::{LitPlace, LitTriangle, MixedLight, MixedTerms, VisibleLights};
use crate::shadow::Receiver;
use luxel_lighting::{DiffuseTerms, LightTerms, MirrorTerms, Reflectance};
use luxel_math::Vec3;
use luxel_scene::SceneLight;

/// Lights a place again, with its terms written down: under a texel, if pieces are lit for every texel.
pub(crate) fn evaluated_at(
    scene: &ShadingContext<'_>,
    triangle: &LitTriangle,
    LitPlace { weight, corner, .. }: &LitPlace,
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

/// The terms that reach the pixel.
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
    /// What reaches the pixel of the light of places.
    pub(crate) fn of(places: &[EvaluatedAt], mixed: MixedTerms) -> Self {
        let light = |(number, mixed): (usize, &MixedLight<f32>)| {
            let terms = |place: &EvaluatedAt| place.lights[number].terms;
            let mean = |of: &dyn Fn(&LightTerms<f32>) -> f32| -> f32 {
                places.iter().map(|place| place.weight * of(&terms(place))).sum()
            };
            let first = &places[0].lights[number];
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
                    visibility: mixed.visibility,
                    n_dot_l: mixed.n_dot_l,
                    specular_cosine: first
                        .terms
                        .specular_cosine
                        .map(|_| mean(&|terms| terms.specular_cosine.unwrap_or_default())),
                    ambient: mixed.ambient,
                    diffuse: mixed.diffuse,
                    specular: mixed.specular,
                },
            }
        };
        Self {
            emission: mixed.emission.lane(0),
            scene_ambient: mixed.scene_ambient.lane(0),
            environment: mixed.environment.lane(0),
            mirrors: Vec::new(),
            environment_diffuse: mixed.environment_diffuse.map(|light| light.lane(0)),
            diffused: Vec::new(),
            lights: mixed.lights.iter().enumerate().map(light).collect(),
        }
    }

    /// With what keeps lights away from a receiver.
    pub(crate) fn in_shadow(
        mut self,
        scene: &ShadingContext<'_>,
        receiver: &Receiver,
        visible: &VisibleLights,
    ) -> Self {
        for (number, light) in self.lights.iter_mut().enumerate() {
            let is_asked = visible.visibility[number].is_some();
            light.shadow = shadow_of(scene, receiver, number, is_asked);
        }
        self
    }
}
