//! A column, for steps of intensity and of slope.

use super::{grid, stage};
use crate::demos::builder::srgb;
use crate::{DVec3, Scene};
use luxel_lighting::{Material, Reflection};
use std::f64::consts::TAU;

/// A round column of `faces` faces without ends, matte, with the normals of the true cylinder.
#[must_use]
pub fn column(name: &str, faces: u32) -> Scene {
    let stone = Material {
        reflection: Reflection::Lambert,
        diffuse: srgb(0xd5_d8dc),
        ..Material::default()
    };
    let mesh = grid(faces, 1, |u, v| {
        // From the back to the right, seen from outside; a half face off, so that a face is in the
        // middle.
        let (sin, cos) = libm::sincos(TAU * (u + 0.5 / f64::from(faces)));
        let outwards = DVec3::new(-sin, 0.0, -cos);
        (outwards + DVec3::Y * (0.9 - 1.8 * v), outwards)
    });
    let (mut builder, root) = stage(name, "column", stone, mesh);
    builder.sun("sun", DVec3::new(0.17, -0.1, -0.98), [0.95; 3]);
    builder.ambient([0.05; 3]);
    builder.camera(root, DVec3::new(0.0, 0.0, 7.0), DVec3::ZERO, 18.0);
    builder.scene
}
