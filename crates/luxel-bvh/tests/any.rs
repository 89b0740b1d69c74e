//! Any-hit queries against brute force in f64, and against the closest hit.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::{Random, bumpy_sphere, corners, grids, intersect};
use luxel_bvh::{Bvh, MeshRays, Quality, Ray};
use luxel_math::SimdLevel;
use luxel_scene::Mesh;
use proptest::prelude::*;

/// Whether a ray hits any triangle, by testing all of them; `None` where rounding decides, at an
/// edge or at an end of the range.
fn brute_force(mesh: &Mesh, ray: &Ray) -> Option<bool> {
    let [nearest, farthest] = ray.range.map(f64::from);
    let mut certain = Some(false);
    for triangle in 0..mesh.triangles.len() {
        let Some((t, inside)) = intersect(ray, corners(mesh, triangle)) else { continue };
        let slack = 1e-4 * (1.0 + t.abs());
        if inside > 1e-4 && t > nearest + slack && t < farthest - slack {
            return Some(true);
        }
        if inside > -1e-3 && t > nearest - slack && t < farthest + slack {
            certain = None;
        }
    }
    certain
}

/// Segments between random points in and around a mesh, and longer rays.
fn segments(count: usize) -> Vec<Ray> {
    let mut random = Random(97);
    let ray = |at: usize| {
        let (from, to) = (random.point(1.6), random.point(1.6));
        match at % 3 {
            0 => Ray::between(from, to),
            1 => Ray { range: [0.2, 0.7], ..Ray::between(from, to) },
            _ => Ray::new(from, to),
        }
    };
    (0..count).map(ray).collect()
}

#[test]
fn occlusion_is_that_of_brute_force() {
    let mesh = bumpy_sphere(10);
    let segments = segments(4000);
    for quality in [Quality::Thorough, Quality::Fast, Quality::InOrder] {
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, quality).unwrap();
        let rays = MeshRays::new(&bvh, &mesh.positions);
        let batch = rays.any_of_each(&segments);
        let mut counts = [0; 2];
        for (ray, hit) in segments.iter().zip(batch) {
            assert_eq!(rays.any(ray), hit, "{ray:?}");
            if let Some(expected) = brute_force(&mesh, ray) {
                assert_eq!(hit, expected, "{ray:?}");
                counts[usize::from(hit)] += 1;
            }
        }
        assert!(counts.iter().all(|count| *count > 1000), "{counts:?}");
    }
}

#[test]
fn batches_answer_as_single_rays_and_as_the_closest_hit_does() {
    let mut mesh = bumpy_sphere(40);
    mesh.triangles.push([0, 900, 2000]);
    let mut aimed = grids(&mesh);
    aimed.extend(segments(3000));
    for quality in [Quality::Thorough, Quality::InOrder] {
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, quality).unwrap();
        for level in SimdLevel::available() {
            let rays = MeshRays::with_level(&bvh, &mesh.positions, level.resolve().unwrap());
            for threads in [1, 3] {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
                // What the list held before is replaced.
                let mut hits = vec![true; 77];
                pool.install(|| rays.any_of_each_into(&aimed, &mut hits));
                assert_eq!(hits.len(), aimed.len());
                assert!(hits.iter().filter(|hit| **hit).count() > 1000);
                for (ray, hit) in aimed.iter().zip(hits) {
                    assert_eq!(hit, rays.any(ray), "{level} {ray:?}");
                    assert_eq!(hit, rays.closest(ray).is_some(), "{level} {ray:?}");
                }
            }
        }
    }
}

#[test]
fn rays_that_are_traced_together_answer_as_alone_however_many_they_are() {
    let mut mesh = bumpy_sphere(40);
    mesh.triangles.push([0, 900, 2000]);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    // From one place all ways, from some places to one light, and rays of any length and range.
    let mut random = Random(7);
    let mut aimed = grids(&mesh);
    let open: Vec<Ray> = (0..600)
        .map(|at| {
            let place = mesh.positions[at / 16].map(|side| 1.01 * side);
            Ray { range: [0.0, 0.5], ..Ray::new(place, random.point(1.0)) }
        })
        .collect();
    aimed.splice(500..500, open);
    aimed.extend(segments(600));
    aimed.push(Ray::new([f32::NAN; 3], [1.0; 3]));
    aimed.push(Ray::new([0.0; 3], [1e-20; 3]));
    for level in SimdLevel::available() {
        let rays = MeshRays::with_level(&bvh, &mesh.positions, level.resolve().unwrap());
        let expected: Vec<bool> = aimed.iter().map(|ray| rays.any(ray)).collect();
        for count in [1, 5, 8, 15, 16, 17, 64, 100, 256, 300, aimed.len()] {
            for (run, expected) in aimed.chunks(count).zip(expected.chunks(count)) {
                let mut hits = vec![true; run.len()];
                rays.any_of_few(run, &mut hits);
                assert_eq!(hits, expected, "{level}, {count} alike");
                hits.fill(true);
                rays.any_of_incoherent(run, &mut hits);
                assert_eq!(hits, expected, "{level}, {count} that go all ways");
            }
        }
    }
}

#[test]
fn rays_along_an_axis_hit_what_lies_immensely_far_away() {
    let mut mesh = bumpy_sphere(10);
    for position in &mut mesh.positions {
        *position = position.map(|side| (side + 2.0) * 1e25);
    }
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let rays: Vec<Ray> = mesh.positions[..64]
        .iter()
        .map(|[x, y, _]| Ray::new([*x, *y, 0.0], [0.0, 0.0, 1.0]))
        .collect();
    for level in SimdLevel::available() {
        let traced = MeshRays::with_level(&bvh, &mesh.positions, level.resolve().unwrap());
        assert!(rays.iter().all(|ray| traced.any(ray)), "{level}");
        for count in [4, 16, 64] {
            for run in rays.chunks(count) {
                let mut hits = vec![false; run.len()];
                traced.any_of_few(run, &mut hits);
                assert!(hits.iter().all(|hit| *hit), "{level}, {count} alike");
                hits.fill(false);
                traced.any_of_incoherent(run, &mut hits);
                assert!(hits.iter().all(|hit| *hit), "{level}, {count} that go all ways");
            }
        }
    }
}

#[test]
fn both_ends_of_the_range_count() {
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let bvh = Bvh::build(&positions, &[[0, 1, 2]], Quality::Thorough).unwrap();
    let rays = MeshRays::new(&bvh, &positions);
    let ray = Ray::new([0.25, 0.25, 2.0], [0.0, 0.0, -1.0]);
    let expected = [
        ([0.0, 2.0], true),
        ([2.0, 5.0], true),
        ([2.0, 2.0], true),
        ([0.0, 2.0_f32.next_down()], false),
        ([2.0_f32.next_up(), f32::INFINITY], false),
    ];
    for (range, expected) in expected {
        let ray = Ray { range, ..ray };
        assert_eq!(rays.any(&ray), expected, "{range:?}");
        assert_eq!(rays.closest(&ray).is_some(), expected, "{range:?}");
        // As many as a packet takes.
        assert_eq!(rays.any_of_each(&[ray; 64]), [expected; 64], "{range:?}");
    }
}

proptest! {
    #[test]
    fn occlusion_of_triangle_soups_agrees_with_brute_force(
        points in prop::collection::vec(prop::array::uniform3(-3.0..3.0_f32), 3..200),
        size in prop::sample::select(vec![0.02_f32, 0.5, 4.0]),
        from in prop::array::uniform3(-5.0..5.0_f32),
        to in prop::array::uniform3(-5.0..5.0_f32),
    ) {
        let mut mesh = Mesh::default();
        for (at, point) in (0..).zip(points.chunks_exact(3)) {
            let [a, b, c] = [point[0], point[1], point[2]];
            let near = |p: [f32; 3]| std::array::from_fn(|axis| a[axis] + p[axis] * size);
            mesh.positions.extend([a, near(b), near(c)]);
            mesh.triangles.push([3 * at, 3 * at + 1, 3 * at + 2]);
        }
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
        let rays = MeshRays::new(&bvh, &mesh.positions);
        let ray = Ray::between(from, to);
        prop_assume!(ray.is_sound());
        let hit = rays.any(&ray);
        prop_assert_eq!(hit, rays.closest(&ray).is_some());
        if let Some(expected) = brute_force(&mesh, &ray) {
            prop_assert_eq!(hit, expected);
        }
    }
}
