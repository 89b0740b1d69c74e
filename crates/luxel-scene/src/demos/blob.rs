//! A bumpy ball of a million small triangles, to measure with and to look at fine detail.

use super::builder::{SceneBuilder, srgb};
use crate::{DMat4, DVec3, Scene, primitives};
use luxel_lighting::Material;

/// 20 x 224^2 = 1 003 520 triangles.
const FREQUENCY: u32 = 224;

/// Frequency and height of each layer of bumps, the coarse ones first.
const BUMPS: [[f64; 2]; 3] = [[2.6, 0.085], [6.5, 0.03], [17.0, 0.008]];

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let clay =
        builder.material("clay", Material { diffuse: srgb(0x9f_b7a4), ..Material::default() });
    let mesh = builder.mesh(primitives::geodesic(FREQUENCY, place), clay);
    let root = builder.group("blob", None, DMat4::IDENTITY);
    builder.object("ball", root, DMat4::IDENTITY, mesh);
    builder.scene
}

/// The point r(d) d in direction d, and its normal r d - (grad r - (grad r . d) d): what is
/// perpendicular to every way over the surface.
///
/// r(d) = 1 + sum of h g(f d) over the bumps, with the gyroid's function
/// g(p) = sin x cos y + sin y cos z + sin z cos x (Schoen 1970), whose bumps look alike in every
/// direction.
fn place(direction: DVec3) -> (DVec3, DVec3) {
    let (mut radius, mut gradient) = (1.0, DVec3::ZERO);
    for [frequency, height] in BUMPS {
        // Off the middle, where the function is symmetric.
        let point = direction * frequency + DVec3::new(0.7, 1.9, 3.1);
        let [x, y, z] = point.to_array().map(libm::sincos);
        radius += height * (x.0 * y.1 + y.0 * z.1 + z.0 * x.1);
        let slope = DVec3::new(x.1 * y.1 - z.0 * x.0, y.1 * z.1 - x.0 * y.0, z.1 * x.1 - y.0 * z.0);
        gradient += slope * (height * frequency);
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
