//! Where the lighting equation was evaluated, and how light is interpolated from there.

use luxel_lighting::{DiffuseTerms, Material, MirrorTerms, Reflectance};
use luxel_render::{ExplainedLight, ExplainedSurface};

/// A point at which the lighting equation was evaluated: the sample itself, or one of the points
/// between which light is interpolated.
pub(crate) struct ShadingPoint<'a> {
    /// Its weight in the light of the sample, and its light as interpolated; `None` for the sample
    /// itself.
    pub(crate) share: Option<(f32, [f32; 3])>,
    pub(crate) normal: [f32; 3],
    pub(crate) view: [f32; 3],
    pub(crate) constants: &'a Material,
    pub(crate) reflectance: &'a Reflectance<f32>,
    pub(crate) ambient_light: [f32; 3],
    /// The factor of what comes from all around; 1 at points between which light is interpolated.
    pub(crate) openness: f32,
    pub(crate) emission: [f32; 3],
    pub(crate) scene_ambient: [f32; 3],
    pub(crate) lights: &'a [ExplainedLight],
    pub(crate) environment: [f32; 3],
    pub(crate) mirrors: &'a [(usize, MirrorTerms<f32>)],
    pub(crate) environment_diffuse: Option<[f32; 3]>,
    pub(crate) diffused: &'a [(usize, DiffuseTerms<f32>)],
    pub(crate) sum: [f32; 3],
}

/// The points at which the light of a surface was evaluated.
pub(crate) fn shading_points(surface: &ExplainedSurface) -> Vec<ShadingPoint<'_>> {
    let constants = &surface.material.constants;
    let ambient_light = surface.ambient_light;
    if surface.evaluated_at.is_empty() {
        return vec![ShadingPoint {
            share: None,
            normal: surface.normal,
            view: surface.view,
            constants,
            reflectance: &surface.material.reflectance,
            ambient_light,
            openness: surface.openness.unwrap_or(1.0),
            emission: surface.emission,
            scene_ambient: surface.scene_ambient,
            lights: &surface.lights,
            environment: surface.environment,
            mirrors: &surface.mirrors,
            environment_diffuse: surface.environment_diffuse,
            diffused: &surface.diffused,
            sum: surface.sum,
        }];
    }
    let points = surface.evaluated_at.iter().map(|point| ShadingPoint {
        share: Some((point.weight, point.light)),
        normal: point.normal,
        view: point.view,
        constants,
        reflectance: &point.reflectance,
        ambient_light,
        openness: 1.0,
        emission: point.emission,
        scene_ambient: point.scene_ambient,
        lights: &point.lights,
        environment: point.environment,
        mirrors: &point.mirrors,
        environment_diffuse: point.environment_diffuse,
        diffused: &point.diffused,
        sum: point.sum,
    });
    points.collect()
}

/// How interpolated light comes from the points at which it was evaluated.
pub(crate) struct Interpolation {
    /// The addends: weights and light. Empty where light was evaluated at the sample itself.
    pub(crate) parts: Vec<(f32, [f32; 3])>,
    /// The factor of the sum, unless it is 1.
    pub(crate) texture: Option<[f32; 3]>,
}

impl Interpolation {
    pub(crate) fn of(surface: &ExplainedSurface, points: &[ShadingPoint<'_>]) -> Self {
        let texture = surface.texture;
        Self {
            parts: points.iter().filter_map(|point| point.share).collect(),
            texture: (texture != [1.0; 3]).then_some(texture),
        }
    }
}
