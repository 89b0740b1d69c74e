//! Rays that lie side by side: they answer as alone, whatever they share.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod common;

use common::{Random, bumpy_sphere, grids};
use luxel_bvh::{Bvh, MeshRays, Quality, Ray, RayColumns};
use luxel_math::SimdLevel;
use luxel_scene::Mesh;

const LANES: usize = 16;

/// Rays in columns of up to sixteen: some full, some with lanes left out.
fn columns(rays: &[Ray], random: &mut Random) -> Vec<RayColumns> {
    let mut rays = rays.iter();
    let mut all = Vec::new();
    while rays.len() > 0 {
        let mut columns = RayColumns::NONE;
        let has_holes = all.len() % 2 == 1;
        for lane in 0..LANES {
            if has_holes && random.next() < 0.0 {
                continue;
            }
            if let Some(ray) = rays.next() {
                columns.put(lane, ray);
            }
        }
        if columns.lanes != 0 {
            all.push(columns);
        }
    }
    all
}

/// Compares rays that are traced together, several columns at a time, with each ray traced alone; returns how
/// many are blocked.
fn compare(mesh: &Mesh, aimed: &[Ray], what: &str) -> usize {
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough).unwrap();
    let mut blocked = 0;
    for level in SimdLevel::available() {
        let rays = MeshRays::with_level(&bvh, &mesh.positions, level.resolve().unwrap());
        let columns = columns(aimed, &mut Random(5));
        for count in [1, 2, 3, 4, 7, 64] {
            for run in columns.chunks(count) {
                let mut hits = vec![u32::MAX; run.len()];
                rays.any_of_columns(run, &mut hits);
                for (of, hits) in run.iter().zip(hits) {
                    for lane in 0..LANES {
                        let ray = of.ray(lane);
                        let expected = of.lanes >> lane & 1 == 1 && rays.any(&ray);
                        let found = hits >> lane & 1 == 1;
                        assert_eq!(found, expected, "{what}, {level}, {count}: {ray:?}");
                        blocked += usize::from(found && count == 1);
                    }
                }
            }
        }
    }
    blocked / SimdLevel::available().len()
}

/// Rays from neighbouring places of a surface, towards one direction or one place: those of sixteen places
/// close together follow each other.
fn towards_lights(mesh: &Mesh, lights: usize) -> Vec<Ray> {
    let mut random = Random(23);
    let mut rays = Vec::new();
    for light in 0..lights {
        let towards = random.point(1.0);
        for triangle in mesh.triangles.iter().step_by(37) {
            let [a, b, c] = triangle.map(|vertex| mesh.positions[vertex as usize]);
            for _ in 0..LANES {
                let (v, w) = (random.next().abs() * 0.5, random.next().abs() * 0.5);
                let place: [f32; 3] = std::array::from_fn(|axis| {
                    (a[axis] + (b[axis] - a[axis]) * v + (c[axis] - a[axis]) * w) * 1.000_01
                });
                let to = std::array::from_fn(|axis| mesh.positions[0][axis] + 5.0 * towards[axis]);
                rays.push(match light % 2 {
                    0 => Ray::new(place, towards),
                    _ => Ray::between(place, to),
                });
            }
        }
    }
    rays
}

#[test]
fn rays_side_by_side_answer_as_alone_from_surfaces_to_lights() {
    let mut mesh = bumpy_sphere(30);
    mesh.triangles.push([0, 900, 2000]);
    let rays = towards_lights(&mesh, 6);
    let blocked = compare(&mesh, &rays, "a ball");
    assert!(blocked * 5 > rays.len() && blocked * 10 < 9 * rays.len(), "{blocked}");
}

#[test]
fn rays_side_by_side_answer_as_alone_through_vertices_and_where_they_are_unusual() {
    let mesh = bumpy_sphere(40);
    let mut rays = grids(&mesh);
    let mut random = Random(11);
    rays.extend((0..2000).map(|_| Ray::new(random.point(1.6), random.point(1.0))));
    rays.push(Ray::new([f32::NAN; 3], [1.0; 3]));
    rays.push(Ray::new([0.0; 3], [1e-20; 3]));
    let blocked = compare(&mesh, &rays, "grids");
    assert!(blocked > 1000, "{blocked}");
}

#[test]
fn rays_side_by_side_answer_as_alone_far_from_the_origin_and_at_any_scale() {
    for (scale, offset) in [(1e-6, 0.0), (1e6, 0.0), (1.0, 1e3), (1.0, 1e6), (1e-3, 1.0)] {
        let mut mesh = bumpy_sphere(8);
        for position in &mut mesh.positions {
            *position = position.map(|side| side * scale + offset);
        }
        let rays: Vec<Ray> = towards_lights(&bumpy_sphere(8), 4)
            .into_iter()
            .map(|ray| {
                let origin = ray.origin.map(|side| side * scale + offset);
                let direction = ray.direction.map(|side| side * scale);
                Ray { origin, direction, range: ray.range }
            })
            .collect();
        let blocked = compare(&mesh, &rays, &format!("scale {scale}, offset {offset}"));
        assert!(blocked > 0);
    }
}
