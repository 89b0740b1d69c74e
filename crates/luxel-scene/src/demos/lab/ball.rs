//! A glossy ball, for outlines and highlights.

use super::stage;
use crate::demos::builder::srgb;
use crate::{DVec3, Scene, primitives};
use luxel_lighting::{Material, Reflection};

/// A ball of `columns` faces round and half as many from pole to pole, with the normals of the true
/// ball, under one sun; `shininess` is the exponent of its highlight.
#[must_use]
pub fn ball(name: &str, columns: u32, shininess: f32) -> Scene {
    let glaze = Material {
        reflection: Reflection::Phong,
        diffuse: srgb(0x8a_4526),
        k_s: 0.9,
        shininess,
        ..Material::default()
    };
    let mesh = primitives::sphere(1.0, columns, columns / 2);
    let (mut builder, root) = stage(name, "ball", glaze, mesh);
    builder.sun("sun", DVec3::new(0.4, -0.75, -1.0), [0.92; 3]);
    builder.ambient([0.14; 3]);
    builder.camera(root, DVec3::new(1.1, 1.6, 5.2), DVec3::ZERO, 26.0);
    builder.scene
}
