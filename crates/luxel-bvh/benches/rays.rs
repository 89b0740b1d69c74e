//! Times building and rays on a bumpy sphere of 100 000, a million and five million triangles.
//!
//! `cargo bench -p luxel-bvh [-- FILTER]`; a filter is part of a row's name. Prints the median and
//! the least of some rounds (one ray at a time at every SIMD level too), and for rays a checksum of
//! triangles and distances, which only a change of results may change.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel_bvh::{Bvh, MeshRays, Quality, Ray, RayHit};
use luxel_math::SimdLevel;
use luxel_scene::{Camera, DVec3, Lens, Mesh, Projection, Size, primitives};
use luxel_visibility::WindowRays;
use std::time::Instant;

const ROUNDS: usize = 5;
const SIZE: Size = Size { width: 1280, height: 720 };

fn bumpy_sphere(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    mesh
}

fn camera() -> Camera {
    let view_from_world = Camera::look_at(DVec3::new(0.7, 1.1, 2.6), DVec3::ZERO, DVec3::Y);
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    Camera { view_from_world, projection: Projection { lens, near: 0.5, far: 10.0 } }
}

/// Rays through the centres of all pixels, in tiles of 8x8.
fn camera_rays() -> Vec<Ray> {
    let camera = camera();
    let window = WindowRays::new(&camera.projection, SIZE);
    let world_from_view = camera.view_from_world.inverse();
    let mut rays = Vec::new();
    for tile in 0..(SIZE.width / 8) * (SIZE.height / 8) {
        let (left, top) = (tile % (SIZE.width / 8) * 8, tile / (SIZE.width / 8) * 8);
        for pixel in 0..64 {
            let (x, y) = (left + pixel % 8, top + pixel / 8);
            let (x, y) = (f64::from(x) + 0.5, f64::from(y) + 0.5);
            let (origin, direction) = window.ray(x, y);
            let direction = direction / direction.length();
            let origin = world_from_view.transform_point3(origin).as_vec3();
            let direction = world_from_view.transform_vector3(direction).as_vec3();
            rays.push(Ray::new(origin.to_array(), direction.to_array()));
        }
    }
    rays
}

/// Chords between random points on a sphere around the mesh.
fn random_rays(count: usize) -> Vec<Ray> {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut point = || {
        let (z, angle) = (next() * 2.0 - 1.0, next() * std::f64::consts::TAU);
        let (sine, cosine) = libm::sincos(angle);
        DVec3::new(cosine * (1.0 - z * z).sqrt(), sine * (1.0 - z * z).sqrt(), z) * 1.5
    };
    let mut ray = || {
        let (from, to) = (point(), point());
        Ray::new(from.as_vec3().to_array(), (to - from).as_vec3().to_array())
    };
    (0..count).map(|_| ray()).collect()
}

fn checksum(hits: &[Option<RayHit>]) -> (usize, u64) {
    let mut sum = 0_u64;
    for hit in hits.iter().flatten() {
        sum = sum
            .wrapping_mul(31)
            .wrapping_add(u64::from(hit.triangle) << 32 | u64::from(hit.t.to_bits()));
    }
    (hits.iter().flatten().count(), sum)
}

/// Median and least of some rounds, in seconds.
fn time(mut work: impl FnMut()) -> (f64, f64) {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[ROUNDS / 2], times[0])
}

fn main() {
    let filter: Option<String> =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let wanted = |name: &str| filter.as_ref().is_none_or(|filter| name.contains(filter.as_str()));
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for (triangles, frequency) in [("100k", 71), ("1M", 224), ("5M", 500)] {
        // A filter that names another size wants none of this one's rows.
        let names_size = |size: &str| filter.as_ref().is_some_and(|filter| filter.contains(size));
        if ["100k", "1M", "5M"].into_iter().any(names_size) && !names_size(triangles) {
            continue;
        }
        let mesh = bumpy_sphere(frequency);
        for quality in [Quality::Thorough, Quality::Fast, Quality::InOrder] {
            for threads in ["1 thread", "all threads"] {
                let name = format!("{triangles} build {quality:?} {threads}");
                if !wanted(&name) {
                    continue;
                }
                let build = || {
                    std::hint::black_box(Bvh::build(&mesh.positions, &mesh.triangles, quality))
                        .unwrap();
                };
                let (median, least) =
                    time(|| if threads == "1 thread" { one.install(build) } else { build() });
                println!("{name:44} {:9.2} ms (least {:.2})", median * 1e3, least * 1e3);
            }
        }
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
        println!(
            "{triangles} tree: {:.1} bytes a triangle, {} levels",
            bvh.memory() as f64 / mesh.triangles.len() as f64,
            bvh.depth()
        );
        for (kind, aimed) in [("camera", camera_rays()), ("random", random_rays(500_000))] {
            let mut seen = Vec::new();
            for level in SimdLevel::available() {
                let level = level.resolve().unwrap();
                // A name may stand for another level.
                let simd = SimdLevel::name_of(level);
                let name = format!("{triangles} rays {kind} at {simd}");
                if seen.contains(&simd) || !wanted(&name) {
                    continue;
                }
                seen.push(simd);
                let rays = MeshRays::with_level(&bvh, &mesh.positions, level);
                let mut hits = Vec::new();
                let (median, least) =
                    time(|| hits = aimed.iter().map(|ray| rays.closest(ray)).collect());
                report(&name, aimed.len(), median, least, checksum(&hits));
            }
        }
        let rays = MeshRays::new(&bvh, &mesh.positions);
        for (kind, aimed) in [("camera", camera_rays()), ("random", random_rays(500_000))] {
            let name = format!("{triangles} rays {kind} one at a time");
            if wanted(&name) {
                let mut hits = Vec::new();
                let (median, least) =
                    time(|| hits = aimed.iter().map(|ray| rays.closest(ray)).collect());
                report(&name, aimed.len(), median, least, checksum(&hits));
            }
            for threads in ["1 thread", "all threads"] {
                let name = format!("{triangles} rays {kind} batch {threads}");
                if wanted(&name) {
                    let mut hits = Vec::new();
                    let (median, least) = time(|| {
                        hits = if threads == "1 thread" {
                            one.install(|| rays.closest_of_each(&aimed))
                        } else {
                            rays.closest_of_each(&aimed)
                        };
                    });
                    report(&name, aimed.len(), median, least, checksum(&hits));
                }
            }
            let name = format!("{triangles} rays {kind} any, one at a time");
            if wanted(&name) {
                let mut hits = 0;
                let (median, least) =
                    time(|| hits = aimed.iter().filter(|ray| rays.any(ray)).count());
                report(&name, aimed.len(), median, least, (hits, 0));
            }
            let name = format!("{triangles} rays {kind} any, batch 1 thread");
            if wanted(&name) {
                let mut hits = Vec::new();
                let (median, least) =
                    time(|| one.install(|| rays.any_of_each_into(&aimed, &mut hits)));
                let count = hits.iter().filter(|hit| **hit).count();
                report(&name, aimed.len(), median, least, (count, 0));
            }
        }
    }
}

fn report(name: &str, count: usize, median: f64, least: f64, (hits, sum): (usize, u64)) {
    let (each, rate) = (median / count as f64 * 1e9, count as f64 / median * 1e-6);
    let least = least / count as f64 * 1e9;
    println!(
        "{name:44} {each:9.1} ns each (least {least:.1}), {rate:7.2} M/s, {hits} hits {sum:016x}"
    );
}
