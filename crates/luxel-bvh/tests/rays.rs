//! Rays against brute force: every triangle, in f64.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::{Random, bumpy_sphere, corners, d, grids, intersect};
use luxel_bvh::{Bvh, MeshRays, Quality, Ray, RayHit};
use luxel_math::SimdLevel;
use luxel_scene::Mesh;
use proptest::prelude::*;
use std::ops::ControlFlow;

/// What is wrong with a hit, by testing every triangle; within rounding of an edge both answers are
/// right.
fn check(mesh: &Mesh, ray: &Ray, hit: Option<RayHit>) -> Result<(), String> {
    let mut certain = f64::INFINITY;
    for triangle in 0..mesh.triangles.len() {
        if let Some((t, inside)) = intersect(ray, corners(mesh, triangle))
            && inside > 1e-4
            && t > f64::from(ray.range[0])
            && t < f64::from(ray.range[1])
        {
            certain = certain.min(t);
        }
    }
    match hit {
        None if certain < f64::INFINITY => Err(format!("missed what is at {certain}")),
        None => Ok(()),
        Some(hit) => {
            let t = f64::from(hit.t);
            let tolerance = 1e-4 * (1.0 + t.abs());
            if t > certain + tolerance {
                return Err(format!("{hit:?} lies behind what is at {certain}"));
            }
            let own = intersect(ray, corners(mesh, hit.triangle as usize));
            match own {
                Some((own, inside)) if (own - t).abs() < tolerance && inside > -1e-3 => Ok(()),
                other => Err(format!("{hit:?} isn't there: {other:?}")),
            }
        }
    }
}

#[test]
fn the_nearest_triangle_is_that_of_brute_force() {
    let mesh = bumpy_sphere(12);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let mut random = Random(7);
    let mut hits = 0;
    for _ in 0..3000 {
        let origin = random.point(2.0);
        let ray = Ray::new(origin, random.point(1.0));
        let hit = rays.closest(&ray);
        hits += usize::from(hit.is_some());
        check(&mesh, &ray, hit).unwrap();
        assert_eq!(rays.any(&ray), hit.is_some());
        assert_eq!(rays.all(&ray).first().copied(), hit);
    }
    assert!(hits > 300, "{hits}");
}

#[test]
fn trees_of_every_quality_give_the_same_hits() {
    let mut mesh = bumpy_sphere(14);
    // Neighbours far apart in the list, and one that isn't there.
    let count = mesh.triangles.len();
    mesh.triangles = (0..count).map(|at| mesh.triangles[at * 1009 % count]).collect();
    mesh.positions.push([f32::NAN; 3]);
    mesh.triangles[77][1] = mesh.positions.len() as u32 - 1;
    let trees = [Quality::Thorough, Quality::Fast, Quality::InOrder]
        .map(|quality| Bvh::build(&mesh.positions, &mesh.triangles, quality).unwrap());
    let asked = trees.each_ref().map(|tree| MeshRays::new(tree, &mesh.positions));
    let mut random = Random(41);
    for _ in 0..2000 {
        let ray = Ray::new(random.point(2.0), random.point(1.0));
        let [thorough, fast, in_order] =
            asked.each_ref().map(|rays| (rays.closest(&ray), rays.all(&ray)));
        assert_eq!(thorough, fast);
        assert_eq!(thorough, in_order);
    }
    for tree in &trees {
        assert_eq!(tree.triangles(), count - 1);
        assert!(tree.memory() <= Quality::InOrder.bytes_needed(count));
    }
}

#[test]
fn all_hits_of_a_closed_mesh_are_even_in_number_from_outside_and_sorted() {
    let mesh = bumpy_sphere(20);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Fast).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let mut random = Random(3);
    for _ in 0..5000 {
        let direction = random.point(1.0);
        let ray = Ray::new(direction.map(|x| x * -50.0), random.point(1.0));
        let hits = rays.all(&ray);
        assert!(hits.is_sorted_by(|a, b| a.t <= b.t));
        assert_eq!(hits.len() % 2, 0, "{ray:?} {hits:?}");
    }
}

#[test]
fn visiting_hits_finds_all_and_ends_at_the_one_that_breaks() {
    let mesh = bumpy_sphere(20);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Fast).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let mut random = Random(5);
    let mut several = 0;
    for _ in 0..2000 {
        let (from, through): ([f32; 3], [f32; 3]) = (random.point(3.0), random.point(0.5));
        let direction = [0, 1, 2].map(|axis| through[axis] - from[axis]);
        let ray = Ray::new(from, direction);
        let all = rays.all(&ray);
        let visited = |most: usize| {
            let mut hits = Vec::new();
            rays.each_hit(&ray, &mut |hit| {
                hits.push(hit);
                if hits.len() == most { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            });
            hits
        };
        let mut hits = visited(usize::MAX);
        for most in 1..hits.len() {
            assert_eq!(visited(most), hits[..most], "{ray:?}");
        }
        several += usize::from(hits.len() > 1);
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.triangle.cmp(&b.triangle)));
        assert_eq!(hits, all, "{ray:?}");
    }
    assert!(several > 100, "{several}");
}

/// Rays from outside to points on the closed mesh's edges and vertices must not come out at the
/// back without having gone in: the nearest hit is on the front side, about where they aim.
#[test]
fn a_million_rays_at_shared_edges_and_vertices_of_a_closed_mesh_leak_nowhere() {
    let mesh = bumpy_sphere(24);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let mut random = Random(11);
    let mut aimed = Vec::new();
    for round in 0..1_000_000 {
        let triangle = corners(&mesh, round % mesh.triangles.len());
        let corner = round / mesh.triangles.len() % 3;
        let (a, b) = (triangle[corner], triangle[(corner + 1) % 3]);
        let along = match round % 4 {
            0 => 0.0,
            1 => 0.5,
            _ => random.next() * 0.5 + 0.5,
        };
        let target: [f32; 3] = std::array::from_fn(|axis| a[axis] + (b[axis] - a[axis]) * along);
        // From the centre, from outside, along an axis: the mesh is star-shaped about 0.
        let ray = match round % 3 {
            0 => Ray::new([0.0; 3], target),
            1 => {
                let axis = round / 3 % 3;
                let mut origin = target;
                origin[axis] = if round % 2 == 0 { 5.0 } else { -5.0 };
                let mut direction = [0.0; 3];
                direction[axis] = -origin[axis].signum();
                Ray::new(origin, direction)
            }
            _ => {
                let origin = target.map(|x| x * 3.0);
                Ray::new(origin, target.map(|x| -x))
            }
        };
        aimed.push(ray);
    }
    let hits = rays.closest_of_each(&aimed);
    let mut at_outline = 0;
    for (ray, hit) in aimed.iter().zip(hits) {
        let Some(hit) = hit else {
            // A ray that grazes the outline may pass by.
            let all = (0..mesh.triangles.len()).filter_map(|at| intersect(ray, corners(&mesh, at)));
            let deepest = all.map(|(_, inside)| inside).fold(f64::NEG_INFINITY, f64::max);
            assert!(deepest < 1e-5, "{ray:?} leaks: it passes {deepest} inside");
            at_outline += 1;
            continue;
        };
        // One more way in than out, or as many: never only out.
        let [a, b, c] = corners(&mesh, hit.triangle as usize).map(d);
        let facing = (b - a).cross(c - a).dot(d(ray.direction));
        let outside = ray.origin != [0.0; 3];
        if outside && facing > 1e-9 {
            // At the outline a front and a back face share an edge, and rounding may swap them.
            let close = |other: &&RayHit| (other.t - hit.t).abs() < 1e-4;
            let count = rays.all(ray).iter().filter(close).count();
            assert!(count > 1, "{ray:?} came out without having gone in: {hit:?}");
        }
    }
    assert!(at_outline < 2000, "{at_outline}");
}

#[test]
fn a_ray_through_an_edge_or_corner_takes_the_lowest_triangle() {
    // A fan about a point: the ray through the middle intersect all eight.
    let mut positions = vec![[0.1, 0.2, 0.3]];
    let mut triangles = Vec::new();
    for step in 0..8_u32 {
        let angle = f64::from(step) * std::f64::consts::FRAC_PI_4 + 0.1;
        let (sine, cosine) = libm::sincos(angle);
        positions.push([cosine as f32, sine as f32, 0.3 + 0.05 * (step % 3) as f32]);
        triangles.push([0, 1 + step, 1 + (step + 1) % 8]);
    }
    for rotated in 0..8 {
        triangles.rotate_left(1);
        let bvh = Bvh::build(&positions, &triangles, Quality::Thorough).unwrap();
        let rays = MeshRays::new(&bvh, &positions);
        let ray = Ray::new([0.1, 0.2, 5.0], [0.0, 0.0, -1.0]);
        let all = rays.all(&ray);
        assert_eq!(all.len(), 8, "{rotated}");
        assert!(all.iter().all(|hit| hit.t == all[0].t), "{all:?}");
        assert_eq!(rays.closest(&ray).unwrap().triangle, 0);
    }
}

#[test]
fn rays_of_tiny_and_huge_directions_hit_what_others_hit() {
    let mesh = bumpy_sphere(8);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let mut random = Random(31);
    for _ in 0..200 {
        let usual = Ray::new(random.point(2.0), random.point(1.0));
        let expected = rays.closest(&usual);
        for exponent in [-100, -60, 60, 100] {
            let factor = f32::from_bits(((127 + exponent) as u32) << 23);
            let scaled = Ray::new(usual.origin, usual.direction.map(|x| x * factor));
            let hit = rays.closest(&scaled);
            assert_eq!(hit.map(|hit| hit.triangle), expected.map(|hit| hit.triangle));
            assert_eq!(hit.map(|hit| hit.t * factor), expected.map(|hit| hit.t));
            assert_eq!(rays.any(&scaled), expected.is_some());
        }
    }
}

#[test]
fn every_level_and_thread_count_gives_the_same_bits() {
    let mesh = bumpy_sphere(60);
    let trees: Vec<Bvh> = [1, 2, 3]
        .into_iter()
        .map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap()
            })
        })
        .collect();
    let mut random = Random(5);
    let aimed: Vec<Ray> =
        (0..4000).map(|_| Ray::new(random.point(3.0), random.point(1.0))).collect();
    let expected = MeshRays::new(&trees[0], &mesh.positions).closest_of_each(&aimed);
    assert!(expected.iter().flatten().count() > 100);
    for bvh in &trees {
        assert_eq!(bvh.memory(), trees[0].memory());
        for level in SimdLevel::available() {
            let rays = MeshRays::with_level(bvh, &mesh.positions, level.resolve().unwrap());
            assert_eq!(rays.closest_of_each(&aimed), expected, "{level}");
        }
    }
}

#[test]
fn rays_in_packets_get_the_bits_of_single_rays() {
    let mut mesh = bumpy_sphere(40);
    // Triangles that lie on others, and one from side to side.
    let twice = mesh.triangles[500..700].to_vec();
    mesh.triangles.extend(twice);
    mesh.triangles.push([0, 900, 2000]);
    let aimed = grids(&mesh);
    for quality in [Quality::Thorough, Quality::InOrder] {
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, quality).unwrap();
        for level in SimdLevel::available() {
            let rays = MeshRays::with_level(&bvh, &mesh.positions, level.resolve().unwrap());
            let together = rays.closest_of_each(&aimed);
            // What a list held before is gone.
            let mut again = vec![together.iter().flatten().next().copied(); aimed.len() / 2];
            rays.closest_of_each_into(&aimed, &mut again);
            assert_eq!(again, together, "{level}");
            assert!(together.iter().flatten().count() > 1000);
            for (ray, hit) in aimed.iter().zip(together) {
                assert_eq!(hit, rays.closest(ray), "{level} {ray:?}");
            }
        }
    }
}

#[test]
fn a_tree_takes_about_thirty_bytes_a_triangle() {
    let mesh = bumpy_sphere(100);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let each = bvh.memory() as f64 / mesh.triangles.len() as f64;
    assert!((20.0..=32.0).contains(&each), "{each}");
}

#[test]
fn hostile_meshes_make_no_deep_tree_and_no_panic() {
    // Ever smaller ones towards a point, all the same ones, huge and tiny ones, and not numbers.
    let mut meshes: Vec<Vec<[f32; 3]>> = Vec::new();
    let shrinking = |count: i32| {
        (0..count).flat_map(|step| {
            let x = f32::from_bits(((127 - step / 2) as u32) << 23)
                * if step % 2 == 0 { 1.0 } else { 1.3 };
            [[x, 0.0, 0.0], [x, x, 0.0], [x, 0.0, x]]
        })
    };
    meshes.push(shrinking(250).collect());
    meshes.push([[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [0.0, 1.0, 1.0]].repeat(50_000));
    meshes.push([[1.0, 2.0, 3.0]].repeat(30_000));
    let extreme = [f32::MAX, -f32::MAX, 1e-38, 0.0, f32::NAN, f32::INFINITY, 1.0, 3e38];
    let mut random = Random(17);
    meshes.push(
        (0..9000)
            .map(|_| random.point(4.0).map(|x| extreme[(x.abs() * 2.0) as usize % 8]))
            .collect(),
    );
    for positions in meshes {
        let triangles: Vec<[u32; 3]> =
            (0..positions.len() as u32 / 3).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
        for quality in [Quality::Thorough, Quality::InOrder] {
            let bvh = Bvh::build(&positions, &triangles, quality).unwrap();
            assert!(bvh.depth() <= 67, "{}", bvh.depth());
        }
        let bvh = Bvh::build(&positions, &triangles, Quality::InOrder).unwrap();
        let rays = MeshRays::new(&bvh, &positions);
        assert!(!rays.any(&Ray::new([9e9; 3], [1.0, 0.0, 0.0])));
        let bvh = Bvh::build(&positions, &triangles, Quality::Thorough).unwrap();
        let rays = MeshRays::new(&bvh, &positions);
        let mut random = Random(23);
        for _ in 0..50 {
            let ray = Ray::new(random.point(2.0), random.point(1.0));
            let closest = rays.closest(&ray);
            assert_eq!(closest.is_some(), rays.any(&ray));
        }
    }
}

#[test]
fn a_refitted_tree_answers_for_the_moved_mesh() {
    let mut mesh = bumpy_sphere(16);
    let build = |quality| Bvh::build(&mesh.positions, &mesh.triangles, quality).unwrap();
    let mut trees = [build(Quality::Fast), build(Quality::InOrder)];
    for position in &mut mesh.positions {
        *position = [position[0] * 1.5 + position[1] * 0.3, position[1] - 0.7, position[2] * 0.8];
    }
    for bvh in &mut trees {
        bvh.refit(&mesh.positions, &mesh.triangles);
        let rays = MeshRays::new(bvh, &mesh.positions);
        let mut random = Random(29);
        for _ in 0..500 {
            let ray = Ray::new(random.point(3.0), random.point(1.0));
            check(&mesh, &ray, rays.closest(&ray)).unwrap();
        }
    }
}

#[test]
fn nothing_is_hit_in_an_empty_mesh_or_by_what_is_no_ray() {
    let empty = Bvh::build(&[], &[], Quality::Thorough).unwrap();
    let rays = MeshRays::new(&empty, &[]);
    assert_eq!(rays.closest(&Ray::new([0.0; 3], [1.0, 0.0, 0.0])), None);
    let mesh = bumpy_sphere(4);
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let rays = MeshRays::new(&bvh, &mesh.positions);
    for ray in [
        Ray::new([0.0; 3], [0.0; 3]),
        Ray::new([f32::NAN, 0.0, 0.0], [1.0, 0.0, 0.0]),
        Ray::new([0.0; 3], [f32::INFINITY, 0.0, 0.0]),
        Ray { range: [1.0, 0.0], ..Ray::new([0.0; 3], [1.0, 0.0, 0.0]) },
        Ray { range: [0.0, f32::NAN], ..Ray::new([0.0; 3], [1.0, 0.0, 0.0]) },
    ] {
        assert_eq!(rays.closest(&ray), None);
        assert!(!rays.any(&ray) && rays.all(&ray).is_empty());
    }
}

proptest! {
    #[test]
    fn hits_of_triangle_soups_agree_with_brute_force(
        points in prop::collection::vec(prop::array::uniform3(-3.0..3.0_f32), 3..200),
        size in prop::sample::select(vec![0.02_f32, 0.5, 4.0]),
        scale in prop::sample::select(vec![1.0_f32, 1e-6, 1e6]),
        origin in prop::array::uniform3(-5.0..5.0_f32),
        direction in prop::array::uniform3(-1.0..1.0_f32),
        range in prop::sample::select(vec![[0.0, f32::INFINITY], [0.5, 4.0]]),
    ) {
        let mut mesh = Mesh::default();
        for (at, point) in points.chunks_exact(3).enumerate() {
            let [a, b, c] = [point[0], point[1], point[2]];
            let near = |p: [f32; 3]| std::array::from_fn(|axis| a[axis] + p[axis] * size);
            mesh.positions.extend([a, near(b), near(c)].map(|p: [f32; 3]| p.map(|x| x * scale)));
            let first = 3 * at as u32;
            mesh.triangles.push([first, first + 1, first + 2]);
        }
        let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
        let rays = MeshRays::new(&bvh, &mesh.positions);
        let ray = Ray {
            range,
            ..Ray::new(origin.map(|x| x * scale), direction.map(|x| x * scale))
        };
        prop_assume!(ray.is_sound());
        prop_assert_eq!(check(&mesh, &ray, rays.closest(&ray)), Ok(()));
    }
}
