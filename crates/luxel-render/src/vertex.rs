//! Light computed elsewhere than at pixels: at corners, at centroids, at the corners of pieces.

use crate::corners::Corners;
use crate::shade::Scene16;
use crate::surface::{SurfaceWitness, lit_at_corner};
use crate::triangles::{Attributes, Corner};
use crate::view::Clamp;

/// Lights single places, and keeps what that needs.
pub(crate) struct VertexLight {
    corners: Corners,
}

impl VertexLight {
    pub(crate) fn new(attributes: Attributes) -> Self {
        Self { corners: Corners::new(attributes, false) }
    }

    /// The light that leaves a place, clamped if the view says so.
    pub(crate) fn at<W: SurfaceWitness<f32>>(
        &mut self,
        scene: &Scene16<'_>,
        corner: &Corner,
        has: Attributes,
        material: u32,
        witness: &mut W,
    ) -> [f32; 3] {
        self.corners.reset(true);
        self.corners.set(&[*corner; 3], has, 1);
        clamped(scene, lit_at_corner(scene, &self.corners, material as usize, witness))
    }
}

/// An intensity as it is interpolated.
pub(crate) fn clamped(scene: &Scene16<'_>, light: [f32; 3]) -> [f32; 3] {
    match scene.shading.clamp {
        Clamp::Vertex => light.map(|channel| channel.clamp(0.0, 1.0)),
        Clamp::End => light,
    }
}
