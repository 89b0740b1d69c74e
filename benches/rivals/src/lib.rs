//! What is compared: meshes and rays, the same for luxel and its rivals.

pub mod ball;
mod mesh;

pub use mesh::{Mesh, read, write_bin, write_ply};

use glam::Vec3A;
use luxel_bvh::Ray;
use obvhs::ray::Ray as RivalRay;
use obvhs::triangle::Triangle;

/// Rays through the pixels of a camera at (0, 0, 3), 45 degrees high, in tiles of 8x8.
pub fn camera_rays(width: u32, height: u32) -> Vec<Ray> {
    let half = (22.5_f32).to_radians().tan();
    let mut rays = Vec::new();
    for tile in 0..width / 8 * (height / 8) {
        let (left, top) = (tile % (width / 8) * 8, tile / (width / 8) * 8);
        for pixel in 0..64 {
            let (x, y) = ((left + pixel % 8) as f32 + 0.5, (top + pixel / 8) as f32 + 0.5);
            let (w, h) = (width as f32, height as f32);
            let (dx, dy) = (half * w / h * (2.0 * x / w - 1.0), half * (1.0 - 2.0 * y / h));
            let scale = 1.0 / (dx * dx + dy * dy + 1.0).sqrt();
            rays.push(Ray::new([0.0, 0.0, 3.0], [dx * scale, dy * scale, -scale]));
        }
    }
    rays
}

/// Rays from a sphere around the unit ball to places in it.
pub fn chords(count: usize) -> Vec<Ray> {
    let mut state = 12345_u64;
    let mut next = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f32 / (1 << 24) as f32
    };
    let mut in_ball = |on_surface: bool| loop {
        let place: [f32; 3] = std::array::from_fn(|_| 2.0 * next() - 1.0);
        let squared: f32 = place.iter().map(|side| side * side).sum();
        if (1e-4..=1.0).contains(&squared) {
            let scale = if on_surface { 1.5 / squared.sqrt() } else { 1.0 };
            return place.map(|side| side * scale);
        }
    };
    let mut ray = || {
        let (from, to) = (in_ball(true), in_ball(false));
        let way: [f32; 3] = std::array::from_fn(|axis| to[axis] - from[axis]);
        let scale = 1.0 / way.iter().map(|side| side * side).sum::<f32>().sqrt();
        Ray::new(from, way.map(|side| side * scale))
    };
    (0..count).map(|_| ray()).collect()
}

/// The same triangles for obvhs.
pub fn rival_triangles(mesh: &Mesh) -> Vec<Triangle> {
    let place = |at: u32| Vec3A::from_array(mesh.positions[at as usize]);
    let of = |corners: &[u32; 3]| {
        let [v0, v1, v2] = corners.map(place);
        Triangle { v0, v1, v2 }
    };
    mesh.triangles.iter().map(of).collect()
}

/// The same ray for obvhs.
pub fn rival_ray(ray: &Ray) -> RivalRay {
    RivalRay::new_inf(Vec3A::from_array(ray.origin), Vec3A::from_array(ray.direction))
}
