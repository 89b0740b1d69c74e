//! A coarse ball lit from the side: where the light ends, its triangles turn away from it before its
//! normals do.

use super::stage;
use crate::demos::builder::srgb;
use crate::{DVec3, Scene, primitives};
use luxel_lighting::{Material, Reflection};

/// A matt ball of `columns` faces round with the normals of the true ball, lit from the left.
#[must_use]
pub fn terminator(name: &str, columns: u32) -> Scene {
    let chalk = Material {
        reflection: Reflection::Lambert,
        diffuse: srgb(0xd9_d3c6),
        ..Material::default()
    };
    let mesh = primitives::sphere(1.0, columns, columns / 2);
    let (mut builder, root) = stage(name, "ball", chalk, mesh);
    builder.sun("sun", DVec3::new(1.0, -0.25, -0.3), [0.9; 3]);
    builder.ambient([0.1; 3]);
    builder.camera(root, DVec3::new(0.6, 0.8, 5.2), DVec3::ZERO, 26.0);
    builder.scene
}
