//! Light computed elsewhere than at pixels: at corners, at centroids, at the corners of pieces.

use crate::shade::Scene16;
use crate::surface::{self, SurfaceWitness, lit_at_corner};
use crate::triangles::{Attributes, Corner};
use crate::varying::Varying;
use crate::view::Clamp;
use luxel_lighting::{Silent, reflected};
use luxel_math::{Number, Rgb, Vec3};

/// The light that leaves a place, clamped if the view says so.
pub(crate) fn light_at<W: SurfaceWitness<f32>>(
    scene: &Scene16<'_>,
    corner: &Corner,
    has: Attributes,
    material: u32,
    witness: &mut W,
) -> [f32; 3] {
    let place = Varying::at(corner, has);
    clamped(scene, lit_at_corner(scene, &place, material as usize, witness))
}

/// [`light_at`] at a corner of each lane's triangle, of a material without textures. Compiled once a
/// kind of number.
#[inline(never)]
pub(crate) fn plain_light_at<N: Number>(
    scene: &Scene16<'_>,
    position: &Vec3<N>,
    normal: &Vec3<N>,
    material: usize,
) -> Rgb<N> {
    position.x.vectorized(
        #[inline(always)]
        || {
            let point = surface::point(scene, *position, *normal);
            let Some(coefficients) = &scene.uniform[material] else {
                return Rgb::black(position.x);
            };
            let reflection = &scene.scene.materials[material].constants.reflection;
            let surroundings = scene.surroundings(material);
            let light = reflected(&point, coefficients, reflection, &surroundings, &mut Silent);
            match scene.shading.clamp {
                Clamp::Vertex => Rgb::new(
                    light.r.limited(0.0, 1.0),
                    light.g.limited(0.0, 1.0),
                    light.b.limited(0.0, 1.0),
                ),
                Clamp::End => light,
            }
        },
    )
}

/// An intensity as it is interpolated.
pub(crate) fn clamped(scene: &Scene16<'_>, light: [f32; 3]) -> [f32; 3] {
    match scene.shading.clamp {
        Clamp::Vertex => light.map(|channel| channel.clamp(0.0, 1.0)),
        Clamp::End => light,
    }
}
