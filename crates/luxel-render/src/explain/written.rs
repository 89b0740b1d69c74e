//! A witness that writes down the terms of one sample's light.

use super::ledger::ExplainedLight;
use super::shadow::shadow_of;
use crate::context::{AttributeMask, ShadingContext};
use crate::interpolate::Fragments;
use crate::material::SurfaceWitness;
use crate::shade::BlockWitness;
use crate::shadow::Receiver;
use luxel_lighting::{
    DiffuseTerms, Ledger, LedgerLight, LightTerms, MirrorTerms, PartTerms, Reflectance,
    SurfacePoint, Terms, Witness,
};
use luxel_math::{LANES, Rgb};
use luxel_scene::SceneLight;

/// Writes down what one sample sees and every term of its light.
#[derive(Default)]
pub(super) struct Written {
    pub(super) point: Option<SurfacePoint<f32>>,
    /// N without the normal map.
    pub(super) smooth: [f32; 3],
    pub(super) reflectance: Option<Reflectance<f32>>,
    pub(super) ledger: Ledger,
    /// Where light was computed elsewhere: the texture of the base colour, and their product.
    pub(super) tint: Option<[f32; 3]>,
    pub(super) sum: Option<[f32; 3]>,
    pub(super) barycentric: [f32; 3],
    pub(super) uv: Option<[f32; 2]>,
}

impl Written {
    /// The terms of each light, by its name, with what keeps it away from the triangle that is seen.
    pub(super) fn explained_lights(
        &self,
        scene: &ShadingContext<'_>,
        eye: [f64; 3],
        lights: &[&SceneLight],
        receiver: Option<&Receiver>,
    ) -> Vec<ExplainedLight> {
        let explained = |entry: &LedgerLight| {
            let placed = &scene.lights[entry.index];
            let about_eye = placed.position();
            ExplainedLight {
                name: lights[entry.index].name.clone(),
                light: lights[entry.index].light.clone(),
                position: [0, 1, 2].map(|axis| eye[axis] + f64::from(about_eye[axis])),
                direction: placed.direction(),
                parts: entry.parts.clone(),
                terms: entry.terms,
                shadow: receiver.and_then(|receiver| {
                    shadow_of(scene, receiver, entry.index, entry.terms.n_dot_l > 0.0)
                }),
            }
        };
        self.ledger.lights.iter().map(explained).collect()
    }
}

impl Witness<f32> for Written {
    fn part(&mut self, index: usize, terms: &PartTerms<f32>) {
        self.ledger.part(index, terms);
    }

    fn mirror(&mut self, index: usize, terms: &MirrorTerms<f32>) {
        self.ledger.mirror(index, terms);
    }

    fn diffuse(&mut self, index: usize, terms: &DiffuseTerms<f32>) {
        self.ledger.diffuse(index, terms);
    }

    fn environment_diffuse(&mut self, diffuse: Rgb<f32>) {
        self.ledger.environment_diffuse(diffuse);
    }

    fn light(&mut self, index: usize, terms: &LightTerms<f32>) {
        self.ledger.light(index, terms);
    }

    fn terms(&mut self, terms: &Terms<f32>) {
        self.ledger.terms(terms);
    }

    fn fog(&mut self, factor: f32, color: Rgb<f32>) {
        self.ledger.fog(factor, color);
    }

    fn color(&mut self, color: Rgb<f32>) {
        self.ledger.color(color);
    }
}

impl BlockWitness<f32> for Written {
    fn fragments(
        &mut self,
        _: &ShadingContext<'_>,
        found: &Fragments<f32>,
        _: &[u32; LANES],
        point: &SurfacePoint<f32>,
        _: u32,
    ) {
        self.smooth = point.normal.lane(0);
        self.barycentric = found.weights;
        self.uv =
            found.attributes.has.has(AttributeMask::UVS[0]).then_some(found.attributes.uv[0][0]);
    }
}

impl SurfaceWitness<f32> for Written {
    fn surface(&mut self, point: &SurfacePoint<f32>, reflectance: &Reflectance<f32>, _alpha: f32) {
        self.point = Some(*point);
        self.reflectance = Some(*reflectance);
    }

    fn elsewhere(&mut self, point: &SurfacePoint<f32>, tint: Rgb<f32>, sum: Rgb<f32>) {
        self.point = Some(*point);
        self.tint = Some(tint.lane(0));
        self.sum = Some(sum.lane(0));
    }
}
