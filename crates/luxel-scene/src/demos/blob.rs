//! A bumpy ball of a million small triangles, to measure with and to look at fine detail.

use super::builder::{SceneBuilder, srgb};
use crate::{DMat4, DVec3, Scene, primitives};
use luxel_lighting::Material;

/// 20 x 224^2 = 1 003 520 triangles.
const FREQUENCY: u32 = 224;

/// A plane wave over space: direction and frequency, phase, height.
type Wave = ([f64; 3], f64, f64);

/// Coarse bumps with finer ones on them, in directions that have nothing in common.
const WAVES: [Wave; 6] = [
    ([2.3, 1.1, -1.7], 0.4, 0.11),
    ([-1.2, 2.6, 1.9], 1.9, 0.09),
    ([3.1, -2.2, 3.4], 0.7, 0.06),
    ([-5.3, 4.1, 6.2], 2.6, 0.025),
    ([9.7, 8.3, -7.1], 1.2, 0.014),
    ([-17.0, 23.0, 19.0], 0.3, 0.005),
];

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let clay =
        builder.material("clay", Material { diffuse: srgb(0x9f_b7a4), ..Material::default() });
    let mesh = builder.mesh(primitives::geodesic(FREQUENCY, place), clay);
    let root = builder.group("blob", None, DMat4::IDENTITY);
    builder.object("ball", root, DMat4::IDENTITY, mesh);
    builder.scene
}

/// The point r(d) d in direction d, with r(d) = 1 + sum of h sin(k.d + p) over the waves, and its
/// normal r d - (grad r - (grad r . d) d): what is perpendicular to every way over the surface.
fn place(direction: DVec3) -> (DVec3, DVec3) {
    let (mut radius, mut gradient) = (1.0, DVec3::ZERO);
    for (frequency, phase, height) in WAVES {
        let frequency = DVec3::from_array(frequency);
        let (sin, cos) = libm::sincos(frequency.dot(direction) + phase);
        radius += height * sin;
        gradient += frequency * (height * cos);
    }
    let along_surface = gradient - direction * gradient.dot(direction);
    (direction * radius, direction * radius - along_surface)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_are_those_of_the_triangles_in_the_limit() {
        let mesh = primitives::geodesic(160, place);
        for (corners, attributes) in mesh.triangles.iter().zip(mesh.attribute_corners()) {
            let [a, b, c] = corners.map(|index| mesh.position(index));
            let face = (b - a).cross(c - a).normalize();
            for vertex in attributes {
                let normal = DVec3::from_array(mesh.normals[*vertex as usize].map(f64::from));
                assert!(normal.dot(face) > 0.985, "{}", normal.dot(face));
            }
        }
    }
}
