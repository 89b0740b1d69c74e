//! Two balls over a board, of which one touches it: without shadows nothing tells which.

use super::stage;
use crate::demos::builder::srgb;
use crate::{DMat4, DVec2, DVec3, Scene, primitives};
use luxel_lighting::{Material, Reflection};

/// A matt board, a ball that stands on it to the left, and one that floats to the right, under one sun.
#[must_use]
pub fn contact(name: &str) -> Scene {
    let paint = |color: u32| Material {
        reflection: Reflection::Lambert,
        diffuse: srgb(color),
        ..Material::default()
    };
    let board = primitives::plane(DVec2::new(5.0, 3.4), 1, 1);
    let (mut builder, root) = stage(name, "board", paint(0xd9_d3c6), board);
    let ball = primitives::sphere(0.5, 96, 48);
    // The farther ball is as much higher as keeps both as high in the picture.
    for (object, color, place) in [
        ("standing", 0xe5_533d, DVec3::new(-0.9, 0.5, 0.5)),
        ("floating", 0x4c_82d8, DVec3::new(0.9, 0.86, 0.9)),
    ] {
        let material = builder.material(object, paint(color));
        let mesh = builder.mesh(ball.clone(), material);
        builder.object(object, root, DMat4::from_translation(place), mesh);
    }
    builder.sun("sun", DVec3::new(0.55, -1.0, -0.35), [0.75; 3]);
    builder.ambient([0.3; 3]);
    builder.camera(root, DVec3::new(0.0, 2.6, 6.2), DVec3::new(0.0, 0.3, 0.0), 34.0);
    builder.scene
}
