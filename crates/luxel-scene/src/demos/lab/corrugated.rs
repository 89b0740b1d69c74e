//! A folded sheet; averaged normals hide its folds.

use super::{grid, stage};
use crate::demos::builder::srgb;
use crate::{DVec3, NormalOptions, NormalSource, Scene};
use luxel_lighting::{Material, Reflection};
use std::f64::consts::PI;

/// Slopes of the sheet, up and down by turns.
const SLOPES: u32 = 14;

/// A sheet folded like a bellows, each corner with the average of the normals of the slopes that
/// meet there: all of them, but at the two ends, point straight up.
#[must_use]
pub fn corrugated(name: &str) -> Scene {
    let zinc = Material {
        reflection: Reflection::Lambert,
        diffuse: srgb(0x8f_a9b8),
        ..Material::default()
    };
    let step = 3.4 / f64::from(SLOPES);
    let mut mesh = grid(SLOPES, 1, |u, v| {
        let at = (u * f64::from(SLOPES)).round();
        let height = if at % 2.0 == 0.0 { -0.5 } else { 0.5 } * step * 0.8;
        (DVec3::new((u - 0.5) * 3.4, height, (v - 0.5) * 2.2), DVec3::Y)
    });
    mesh.compute_normals(&NormalOptions { source: NormalSource::Mean, crease_radians: PI });
    let (mut builder, root) = stage(name, "sheet", zinc, mesh);
    builder.sun("sun", DVec3::new(0.75, -0.7, -0.3), [0.9; 3]);
    builder.ambient([0.06; 3]);
    builder.camera(root, DVec3::new(0.9, 3.2, 4.4), DVec3::ZERO, 34.0);
    builder.scene
}
