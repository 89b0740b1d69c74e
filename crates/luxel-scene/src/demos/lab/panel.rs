//! A panel with a lamp before it.

use super::{grid, stage};
use crate::demos::builder::srgb;
use crate::{DVec3, Scene};
use luxel_lighting::{Material, Reflection};

/// A glossy panel of `cells` x `cells` polygons, a lamp close before its middle.
#[must_use]
pub fn panel(name: &str, cells: u32) -> Scene {
    let lacquer = Material {
        reflection: Reflection::Phong,
        diffuse: srgb(0x3f_7f8c),
        k_s: 0.7,
        shininess: 40.0,
        ..Material::default()
    };
    let mesh =
        grid(cells, cells, |u, v| (DVec3::new((u - 0.5) * 3.2, (0.5 - v) * 2.4, 0.0), DVec3::Z));
    let (mut builder, root) = stage(name, "panel", lacquer, mesh);
    builder.lamp("lamp", DVec3::new(-0.35, 0.3, 1.1), [0.8; 3], [0.6, 0.0, 0.35]);
    builder.ambient([0.07; 3]);
    builder.camera(root, DVec3::new(1.0, 0.5, 5.6), DVec3::new(0.05, 0.0, 0.0), 30.0);
    builder.scene
}
