//! Light that was computed elsewhere than at a sample, of which lights are kept away there.

use super::lit_triangle::LitTriangle;
use super::place_terms::LitPlace;
use crate::context::ShadingContext;
use crate::shadow::Receiver;
use luxel_lighting::{LightTerms, PlacedLight};
use luxel_math::Vec3;
use luxel_visibility::TriangleId;

/// The lights that reach a sample whose light was computed elsewhere.
pub(crate) struct VisibleLights {
    /// The normal between the places where light was computed, of unit length.
    pub(crate) normal: [f32; 3],
    /// V of each light at the sample; `None` where it lights none of the places, and no ray is traced.
    pub(crate) visibility: Vec<Option<f32>>,
    /// Openness at the sample.
    pub(crate) openness: f32,
}

impl VisibleLights {
    /// Of a sample of a triangle; `None` without shadows.
    ///
    /// V is computed wherever the light lights one of the places: between them, it reaches samples whose own
    /// normal turns away.
    pub(crate) fn of(
        scene: &ShadingContext<'_>,
        id: TriangleId,
        (barycentric, position): ([f32; 3], [f64; 2]),
        places: &[LitPlace],
    ) -> Option<Self> {
        let shadows = scene.shadows?;
        let sum = places.iter().fold([0.0; 3], |sum: [f32; 3], place| {
            std::array::from_fn(|axis| sum[axis] + place.weight * place.corner.normal[axis])
        });
        let normal = Vec3::new(sum[0], sum[1], sum[2]).normalized_or_zero().lane(0);
        let place = shadows.place(id, barycentric);
        let receiver =
            Receiver { id, barycentric, normal, smooth: normal, position, is_between: true };
        let visible = |(light, placed): (usize, &PlacedLight)| {
            let is_lit = |LitPlace { corner, .. }: &LitPlace| {
                let ([x, y, z], [n_x, n_y, n_z]) = (corner.position, corner.normal);
                Vec3::new(n_x, n_y, n_z).dot(placed.to_light(Vec3::new(x, y, z))) > 0.0
            };
            let place = place.filter(|_| places.iter().any(is_lit))?;
            Some(shadows.visibility(light, &place, &receiver))
        };
        let openness = shadows
            .openness
            .and_then(|rule| place.map(|place| shadows.openness(rule, &place, normal, position)));
        Some(Self {
            normal,
            visibility: scene.lights.iter().enumerate().map(visible).collect(),
            openness: openness.unwrap_or(1.0),
        })
    }

    /// The light between places, each light of them times its V; `None` if all of it arrives.
    ///
    /// I = sum of w k (own + sum of V_i I_i) over the places, where w are the weights, I_i the parts of
    /// the lights, all ambient parts and the environment times the openness, and k what clamping
    /// leaves of a place's light.
    pub(crate) fn light(
        &self,
        scene: &ShadingContext<'_>,
        triangle: &mut LitTriangle,
        places: &[LitPlace],
        texel: [f32; 3],
    ) -> Option<[f32; 3]> {
        let visibility = |light: usize| self.visibility[light].unwrap_or(1.0);
        if self.openness == 1.0 && self.visibility.iter().all(|v| v.unwrap_or(1.0) == 1.0) {
            return None;
        }
        let mut sum = [0.0; 3];
        for (place, terms) in places.iter().zip(triangle.terms(scene, places, texel)) {
            for channel in 0..3 {
                let of_light = |terms: &LightTerms<f32>| {
                    let LightTerms { ambient, diffuse, specular, .. } = terms;
                    self.openness * ambient.lane(0)[channel]
                        + diffuse.lane(0)[channel]
                        + specular.lane(0)[channel]
                };
                let around = terms.scene_ambient[channel] + terms.environment[channel];
                let mut arriving = terms.emission[channel] + self.openness * around;
                for entry in &terms.lights {
                    arriving += visibility(entry.index) * of_light(&entry.terms);
                }
                sum[channel] += place.weight * terms.kept[channel] * arriving;
            }
        }
        Some(sum)
    }
}
