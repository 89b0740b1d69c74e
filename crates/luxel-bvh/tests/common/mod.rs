//! Meshes and rays of the tests, and the test of one triangle in f64.

#![allow(dead_code, reason = "each test file uses some of it")]

use luxel_bvh::Ray;
use luxel_scene::{DVec3, Mesh, primitives};

pub(crate) fn bumpy_sphere(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    mesh
}

/// A small generator (xorshift) for rays.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f32 / (1 << 23) as f32 - 1.0
    }

    pub(crate) fn point(&mut self, size: f32) -> [f32; 3] {
        [self.next() * size, self.next() * size, self.next() * size]
    }
}

pub(crate) fn d(v: [f32; 3]) -> DVec3 {
    DVec3::new(v[0].into(), v[1].into(), v[2].into())
}

/// Moeller and Trumbore in f64: t, and how deep inside the triangle (least barycentric).
pub(crate) fn intersect(ray: &Ray, corners: [[f32; 3]; 3]) -> Option<(f64, f64)> {
    let [a, b, c] = corners.map(d);
    let (direction, ab, ac) = (d(ray.direction), b - a, c - a);
    let p = direction.cross(ac);
    let determinant = ab.dot(p);
    if determinant == 0.0 {
        return None;
    }
    let to_origin = d(ray.origin) - a;
    let v = to_origin.dot(p) / determinant;
    let q = to_origin.cross(ab);
    let w = direction.dot(q) / determinant;
    let t = ac.dot(q) / determinant;
    Some((t, v.min(w).min(1.0 - v - w)))
}

pub(crate) fn corners(mesh: &Mesh, triangle: usize) -> [[f32; 3]; 3] {
    mesh.triangles[triangle].map(|vertex| mesh.positions[vertex as usize])
}

/// Rays in tiles of eight by eight: from one eye or side by side; some through vertices or along axes,
/// some invalid, of another direction or of unusual length.
pub(crate) fn grids(mesh: &Mesh) -> Vec<Ray> {
    let mut random = Random(71);
    let mut rays = Vec::new();
    for round in 0..60 {
        let eye =
            [[0.0, 0.0, 3.0], [1.9, 0.4, -1.2], [-0.1, 2.5, 0.2], [0.01, 0.0, 0.02]][round % 4];
        // From a wide view to almost parallel rays.
        let step = [0.4, 0.05, 0.002, 1e-5][round / 4 % 4];
        let aim = random.point(0.7);
        let mut of_tile = Vec::new();
        for point in 0..64_u8 {
            let (right, up) = (f32::from(point % 8) - 3.5, f32::from(point / 8) - 3.5);
            let mut target = [aim[0] + right * step, aim[1] + up * step, aim[2]];
            if round % 5 == 4 {
                let vertex = (round * 977 + usize::from(point) * 3) % mesh.positions.len();
                target = mesh.positions[vertex];
            }
            let ray = match round % 3 {
                0 => Ray::new(eye, std::array::from_fn(|axis| target[axis] - eye[axis])),
                // Side by side, along an axis.
                1 => Ray::new([target[0], target[1], 4.0], [0.0, -0.0, -1.0]),
                _ => Ray::new([target[0], target[1], 4.0], [0.1, 0.05, -1.0]),
            };
            let range = [[0.0, f32::INFINITY], [0.5, 3.1], [0.0, 3.4]][usize::from(point) % 3];
            of_tile.push(if round % 2 == 0 { ray } else { Ray { range, ..ray } });
        }
        match round % 6 {
            // Invalid rays, and some of another direction or length.
            3 => of_tile[17].direction = [0.0; 3],
            4 => of_tile[40].direction = [0.3, -0.2, 0.9],
            5 => of_tile[9].direction = of_tile[9].direction.map(|x| x * 1e-20),
            _ => {}
        }
        rays.extend(of_tile);
    }
    // The last tile is not full.
    rays.truncate(rays.len() - 27);
    rays
}
