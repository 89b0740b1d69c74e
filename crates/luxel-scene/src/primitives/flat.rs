//! Shapes with flat faces.

use super::FINEST;
use super::builder::{MeshBuilder, SurfacePoint};
use crate::Mesh;
use glam::{DVec2, DVec3};

/// A rectangle in the plane y = 0 that faces up, `size` along x and z, of `columns` x `rows`
/// quadrilaterals (1 to [`FINEST`] each).
///
/// Its texture lies as seen from above with +Z towards the reader.
#[must_use]
pub fn plane(size: DVec2, columns: u32, rows: u32) -> Mesh {
    let mut builder = MeshBuilder::default();
    let face = Face { centre: DVec3::ZERO, right: DVec3::X * size.x, down: DVec3::Z * size.y };
    face.add(&mut builder, columns.clamp(1, FINEST), rows.clamp(1, FINEST));
    builder.finish()
}

/// A box with edges of the lengths `size`, each face a whole texture.
#[must_use]
pub fn cuboid(size: DVec3) -> Mesh {
    let mut builder = MeshBuilder::default();
    // Each face as seen from outside: where it looks, and where its right and downward edges run.
    let faces = [
        [DVec3::Z, DVec3::X, DVec3::NEG_Y],
        [DVec3::X, DVec3::NEG_Z, DVec3::NEG_Y],
        [DVec3::NEG_Z, DVec3::NEG_X, DVec3::NEG_Y],
        [DVec3::NEG_X, DVec3::Z, DVec3::NEG_Y],
        [DVec3::Y, DVec3::X, DVec3::Z],
        [DVec3::NEG_Y, DVec3::X, DVec3::NEG_Z],
    ];
    for [outward, right, down] in faces {
        let face = Face { centre: outward * size * 0.5, right: right * size, down: down * size };
        face.add(&mut builder, 1, 1);
    }
    builder.finish()
}

/// A rectangle given by its middle and its edges, to the right and downwards seen from the front.
struct Face {
    centre: DVec3,
    right: DVec3,
    down: DVec3,
}

impl Face {
    fn add(&self, builder: &mut MeshBuilder, columns: u32, rows: u32) {
        let normal = self.down.cross(self.right);
        builder.grid(columns, rows, |column, row| {
            let uv = DVec2::new(
                f64::from(column) / f64::from(columns),
                f64::from(row) / f64::from(rows),
            );
            let position = self.centre + self.right * (uv.x - 0.5) + self.down * (uv.y - 0.5);
            SurfacePoint { position, normal, uv }
        });
    }
}
