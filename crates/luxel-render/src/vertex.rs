//! Light computed elsewhere than at pixels: at corners, at centroids, at the corners of pieces.

use crate::shade::Scene16;
use crate::surface::{SurfaceWitness, lit_at_corner};
use crate::triangles::{Attributes, Corner};
use crate::varying::Varying;
use crate::view::Clamp;

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

/// An intensity as it is interpolated.
pub(crate) fn clamped(scene: &Scene16<'_>, light: [f32; 3]) -> [f32; 3] {
    match scene.shading.clamp {
        Clamp::Vertex => light.map(|channel| channel.clamp(0.0, 1.0)),
        Clamp::End => light,
    }
}
