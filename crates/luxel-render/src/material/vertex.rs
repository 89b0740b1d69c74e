//! Light computed elsewhere than at pixels: at corners, at centroids, at the corners of pieces.

use super::attributes::{Attributes, Corner};
use super::surface::{SurfaceWitness, reflectance};
use crate::context::{AttributeMask, ShadingContext};
use luxel_lighting::{Coefficients, Occlusion, Silent, reflected};
use luxel_math::{Lanes, Rgb, Vec3};
use luxel_view::Clamp;

/// The light that leaves a place, without the texture of its base colour; clamped if the view says so.
pub(crate) fn light_at<W: SurfaceWitness<f32>>(
    scene: &ShadingContext<'_>,
    corner: &Corner,
    has: AttributeMask,
    material: u32,
    witness: &mut W,
) -> [f32; 3] {
    let light = light_under(scene, corner, has, material, [1.0; 3], witness);
    clamped(scene, Rgb::splat(0.0, light)).lane(0)
}

/// The light that leaves a place under a texel of its base colour; not clamped.
pub(crate) fn light_under<W: SurfaceWitness<f32>>(
    scene: &ShadingContext<'_>,
    corner: &Corner,
    has: AttributeMask,
    material: u32,
    texel: [f32; 3],
    witness: &mut W,
) -> [f32; 3] {
    let place = Attributes::at(corner, has);
    let number = material as usize;
    let point = scene.point_at_vertex(place.position, place.normal);
    let tint = Rgb::splat(0.0, texel);
    let reflectance = reflectance(scene, &place, number, 1, tint);
    witness.surface(&point, &reflectance, 1.0);
    let constants = &scene.scene.materials[number].constants;
    let coefficients = Coefficients::new(&reflectance, constants);
    let lighting = scene.lighting(number);
    let reflection = &constants.reflection;
    reflected(&point, &coefficients, reflection, lighting, Occlusion::NONE, witness).lane(0)
}

/// [`light_at`] at a corner of each lane's triangle, of a material without textures and vertex colours.
/// Outlined: one copy per lane type.
#[inline(never)]
pub(crate) fn lights_at<N: Lanes>(
    scene: &ShadingContext<'_>,
    position: &Vec3<N>,
    normal: &Vec3<N>,
    material: usize,
) -> Rgb<N> {
    position.x.vectorized(
        #[inline(always)]
        || {
            let point = scene.point_at_vertex(*position, *normal);
            let Some(coefficients) = &scene.uniform[material] else {
                return Rgb::black(position.x);
            };
            let reflection = &scene.scene.materials[material].constants.reflection;
            let lighting = scene.lighting(material);
            let light =
                reflected(&point, coefficients, reflection, lighting, Occlusion::NONE, &mut Silent);
            clamped(scene, light)
        },
    )
}

/// An intensity as it is interpolated.
#[inline(always)]
fn clamped<N: Lanes>(scene: &ShadingContext<'_>, light: Rgb<N>) -> Rgb<N> {
    match scene.shading.clamp {
        Clamp::Vertex => Rgb::new(
            light.r.clamped(0.0, scene.white),
            light.g.clamped(0.0, scene.white),
            light.b.clamped(0.0, scene.white),
        ),
        Clamp::End => light,
    }
}
