//! Bumpy balls of about so many triangles.

use crate::Mesh;
use std::f64::consts::PI;

/// By name: rings and segments; of 1 020, 9 940, 99 904, 1 001 112 and 5 002 284 triangles.
pub const BALLS: [(&str, u32, u32); 5] =
    [("1k", 16, 34), ("10k", 71, 71), ("100k", 224, 224), ("1m", 708, 708), ("5m", 1582, 1582)];

/// A ball of rings and segments within the unit ball.
pub fn ball(rings: u32, segments: u32) -> Mesh {
    let vertex = |ring: u32, segment: u32| {
        let down = PI * f64::from(ring) / f64::from(rings);
        let around = 2.0 * PI * f64::from(segment) / f64::from(segments);
        let [x, y, z] = [down.sin() * around.cos(), down.cos(), down.sin() * around.sin()];
        let bumps = 0.12 * (5.0 * x + 1.0).sin() * (6.0 * y).cos() * (4.0 * z - 2.0).sin()
            + 0.04 * (19.0 * x).sin() * (17.0 * y + 0.5).sin() * (23.0 * z).cos();
        [x, y, z].map(|part| (part * (0.8 + bumps)) as f32)
    };
    // The poles are first and last.
    let mut positions = vec![vertex(0, 0)];
    for ring in 1..rings {
        positions.extend((0..segments).map(|segment| vertex(ring, segment)));
    }
    positions.push(vertex(rings, 0));
    let at = |ring: u32, segment: u32| 1 + (ring - 1) * segments + segment % segments;
    let last = segments * (rings - 1) + 1;
    let mut triangles = Vec::new();
    for segment in 0..segments {
        triangles.push([0, at(1, segment + 1), at(1, segment)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, segment), at(ring, segment + 1)];
            let [c, d] = [at(ring + 1, segment), at(ring + 1, segment + 1)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
        triangles.push([at(rings - 1, segment), at(rings - 1, segment + 1), last]);
    }
    let normals = normals(&positions, &triangles);
    Mesh { positions, normals, triangles }
}

/// Of unit length, the means of the triangles around, by their areas.
fn normals(positions: &[[f32; 3]], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut sums = vec![[0.0_f64; 3]; positions.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|corner| positions[corner as usize].map(f64::from));
        let side = |to: [f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let ([x, y, z], [u, v, w]) = (side(b), side(c));
        for &corner in triangle {
            let [nx, ny, nz] = &mut sums[corner as usize];
            *nx += y * w - z * v;
            *ny += z * u - x * w;
            *nz += x * v - y * u;
        }
    }
    let unit = |sum: [f64; 3]| {
        let length = sum.iter().map(|part| part * part).sum::<f64>().sqrt();
        sum.map(|part| (part / length) as f32)
    };
    sums.into_iter().map(unit).collect()
}
