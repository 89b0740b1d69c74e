//! A sheet with a seam on which one side has corners that the other may not know.

use super::stage;
use crate::demos::builder::srgb;
use crate::primitives::{MeshBuilder, SurfacePoint};
use crate::{DVec2, DVec3, Mesh, Scene};
use luxel_lighting::{Material, Reflection};

/// The corners of the seam on its left side.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seam {
    /// All of them.
    Shared,
    /// Only the two at its ends: the others are T-junctions.
    Forgotten,
}

/// How high the wave is.
const HEIGHT: f64 = 1.1;

/// A gentle wave, `cells` quadrilaterals up and on either side of a seam; the seam itself is
/// straight, so that nothing gapes.
///
/// z = h x (1 - |x|) (1 - y^2), and z = 0 at x = 0.
#[must_use]
pub fn seam(name: &str, seam: Seam, cells: u32) -> Scene {
    let plaster = Material {
        reflection: Reflection::Lambert,
        diffuse: srgb(0xc9_b899),
        ..Material::default()
    };
    let (mut builder, root) = stage(name, "sheet", plaster, sheet(seam, cells.max(2)));
    builder.sun("sun", DVec3::new(-0.6, -0.3, -0.75), [0.95; 3]);
    builder.ambient([0.06; 3]);
    builder.camera(root, DVec3::new(0.5, 0.35, 5.0), DVec3::ZERO, 28.0);
    builder.scene
}

/// Place and normal at (x, y), both from -1 to 1.
fn point(x: f64, y: f64) -> SurfacePoint {
    let across = x * (1.0 - x.abs());
    let along = 1.0 - y * y;
    let slope = [HEIGHT * (1.0 - 2.0 * x.abs()) * along, HEIGHT * across * -2.0 * y];
    // The sheet is a little wider than high.
    const WIDTH: f64 = 1.3;
    SurfacePoint {
        position: DVec3::new(x * WIDTH, y, HEIGHT * across * along),
        normal: DVec3::new(-slope[0] / WIDTH, -slope[1], 1.0),
        uv: DVec2::new((x + 1.0) * 0.5, (1.0 - y) * 0.5),
    }
}

fn sheet(seam: Seam, cells: u32) -> Mesh {
    let mut builder = MeshBuilder::default();
    let mut polygons = Vec::new();
    let columns = 2 * cells;
    let place = |column: u32, row: u32| {
        let [x, y] = [(column, columns), (row, cells)]
            .map(|(at, of)| f64::from(at) / f64::from(of) * 2.0 - 1.0);
        point(x, -y)
    };
    let vertices: Vec<Vec<u32>> = (0..=cells)
        .map(|row| (0..=columns).map(|column| builder.vertex(place(column, row))).collect())
        .collect();
    let mut polygon = 0;
    for column in 0..columns {
        let beside_seam = column + 1 == cells && seam == Seam::Forgotten;
        for row in 0..cells as usize {
            let at = column as usize;
            let (above, below) = (&vertices[row], &vertices[row + 1]);
            if !beside_seam {
                builder.triangle([above[at], below[at], below[at + 1]]);
                builder.triangle([above[at], below[at + 1], above[at + 1]]);
                polygons.extend([polygon; 2]);
                polygon += 1;
                continue;
            }
            // One polygon along the whole seam: the corners on its left, and the seam's two ends.
            let is_upper = 2 * row < cells as usize;
            let end = if is_upper { &vertices[0] } else { &vertices[cells as usize] };
            if 2 * row == cells as usize || (is_upper && 2 * (row + 1) > cells as usize) {
                // Where the upper end's triangles meet the lower one's.
                let last = &vertices[cells as usize];
                let middle = if is_upper { below } else { above };
                builder.triangle([middle[at], last[at + 1], vertices[0][at + 1]]);
                polygons.push(polygon);
            }
            builder.triangle([above[at], below[at], end[at + 1]]);
            polygons.push(polygon);
        }
        if beside_seam {
            polygon += 1;
        }
    }
    let mut mesh = builder.finish();
    mesh.polygons = Some(polygons);
    mesh
}
