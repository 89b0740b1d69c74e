//! A quad with a different colour at each corner.

use super::{grid, stage};
use crate::demos::builder::srgb;
use crate::{DVec3, Scene};
use luxel_lighting::{Material, Reflection};

/// How bright the corners are: upper left, upper right, lower left, lower right.
const CORNERS: [f64; 4] = [1.0, 0.02, 0.05, 0.55];

/// A square of `cells` x `cells` polygons that isn't lit; the brightness at its corners is that of
/// the four corners of the whole, and bilinear between: the scan-line result of an upright quad.
#[must_use]
pub fn quad(name: &str, cells: u32) -> Scene {
    let own =
        Material { reflection: Reflection::Unlit, diffuse: srgb(0xff_d68a), ..Material::default() };
    let mut mesh =
        grid(cells, cells, |u, v| (DVec3::new(u * 2.0 - 1.0, 1.0 - v * 2.0, 0.0), DVec3::Z));
    let brightness = |[u, v]: [f32; 2]| {
        let [u, v] = [u, v].map(f64::from);
        let [a, b, c, d] = CORNERS;
        let value = (a * (1.0 - u) + b * u) * (1.0 - v) + (c * (1.0 - u) + d * u) * v;
        let value = value as f32;
        [value, value, value, 1.0]
    };
    mesh.colors = mesh.uvs[0].iter().map(|&uv| brightness(uv)).collect();
    let (mut builder, root) = stage(name, "quad", own, mesh);
    builder.camera(root, DVec3::new(0.0, 0.0, 7.0), DVec3::ZERO, 25.0);
    builder.scene
}
