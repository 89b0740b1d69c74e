//! Trees, rays and slivers beside obvhs, by criterion:
//!
//!     cargo bench
//!
//! The mesh is a bumpy ball of 100,000 triangles, or `RIVALS_FREQUENCY` squared times 20 (224 is a
//! million). Rays are those of the crate's program; a round of rays is 14,400 of them.

use criterion::measurement::WallTime;
use criterion::{
    BatchSize, BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main,
};
use luxel_bvh::{Bvh, MeshRays, Quality, Ray};
use luxel_pick::{PickView, Picker, Region};
use luxel_rivals::{Mesh, camera_rays, chords, rival_ray, rival_triangles};
use luxel_scene::{
    Camera, DVec3, Lens, MaterialId, MeshId, Node, Part, Projection, Scene, SceneMaterial, Size,
    primitives,
};
use luxel_visibility::Cull;
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use obvhs::triangle::Triangle;
use std::time::Duration;

fn ball() -> luxel_scene::Mesh {
    let frequency = std::env::var("RIVALS_FREQUENCY").ok().and_then(|text| text.parse().ok());
    let mut mesh = primitives::icosphere(1.0, frequency.unwrap_or(71));
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (0.87 + 0.13 * bumps) as f32);
    }
    let count = mesh.triangles.len() as u32;
    mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    mesh
}

fn build(criterion: &mut Criterion, mesh: &Mesh, triangles: &[Triangle]) {
    let mut group = criterion.benchmark_group("build");
    group.sample_size(10).throughput(Throughput::Elements(triangles.len() as u64));
    for quality in [Quality::Thorough, Quality::Fast] {
        group.bench_function(format!("luxel {quality:?}"), |bencher| {
            bencher.iter(|| Bvh::build(&mesh.positions, &mesh.triangles, quality).map(|_| ()));
        });
    }
    let params = BvhBuildParams::medium_build;
    group.bench_function("obvhs Bvh2", |bencher| {
        bencher.iter(|| build_bvh2_from_tris(triangles, params(), &mut Duration::default()));
    });
    group.bench_function("obvhs CwBvh", |bencher| {
        bencher.iter(|| build_cwbvh_from_tris(triangles, params(), &mut Duration::default()));
    });
    group.finish();
}

fn one_by_one(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: &str,
    rays: &[Ray],
    hits: impl Fn(&Ray) -> bool,
) {
    group.bench_function(name, |bencher| {
        bencher.iter(|| rays.iter().filter(|ray| hits(ray)).count());
    });
}

fn rays(criterion: &mut Criterion, mesh: &Mesh, triangles: &[Triangle]) {
    let Ok(bvh) = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough) else { return };
    let own = MeshRays::new(&bvh, &mesh.positions);
    let params = BvhBuildParams::medium_build;
    let bvh2 = build_bvh2_from_tris(triangles, params(), &mut Duration::default());
    let cwbvh = build_cwbvh_from_tris(triangles, params(), &mut Duration::default());
    let sorted = |order: &[u32]| -> Vec<Triangle> {
        order.iter().map(|&at| triangles[at as usize]).collect()
    };
    let (of_bvh2, of_cwbvh) = (sorted(&bvh2.primitive_indices), sorted(&cwbvh.primitive_indices));
    for (kind, aimed) in [("coherent", camera_rays(160, 90)), ("incoherent", chords(14_400))] {
        let mut group = criterion.benchmark_group(format!("closest hit, {kind}"));
        group.throughput(Throughput::Elements(aimed.len() as u64));
        one_by_one(&mut group, "luxel", &aimed, |ray| own.closest(ray).is_some());
        group.bench_function("luxel, batch", |bencher| {
            bencher.iter(|| own.closest_of_each(&aimed));
        });
        one_by_one(&mut group, "obvhs Bvh2", &aimed, |ray| {
            let mut hit = RayHit::none();
            bvh2.ray_traverse(rival_ray(ray), &mut hit, |ray, at| of_bvh2[at].intersect(ray))
        });
        one_by_one(&mut group, "obvhs CwBvh", &aimed, |ray| {
            let mut hit = RayHit::none();
            cwbvh.ray_traverse(rival_ray(ray), &mut hit, |ray, at| of_cwbvh[at].intersect(ray))
        });
        group.finish();
    }
}

/// What obvhs has no like of.
fn windows(criterion: &mut Criterion, mesh: luxel_scene::Mesh) {
    let scene = Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        nodes: vec![Node::root("ball", Some(MeshId(0)))],
        ..Scene::default()
    };
    let size = Size { width: 1280, height: 720 };
    let view_from_world = Camera::look_at(DVec3::new(0.0, 0.0, 3.0), DVec3::ZERO, DVec3::Y);
    let lens = Lens::Perspective { fov_y_radians: 45_f64.to_radians() };
    let camera = Camera { view_from_world, projection: Projection { lens, near: 0.5, far: 10.0 } };
    let Ok(picker) = Picker::new(scene.clone()) else { return };
    let Ok(view) = PickView::new(&picker, camera, size, Cull::Auto) else { return };
    let mut group = criterion.benchmark_group("window");
    let mut turn = 0_u32;
    let mut place = move || {
        turn = turn.wrapping_add(1);
        [
            f64::from(turn.wrapping_mul(7919) % 500) + 390.5,
            f64::from(turn.wrapping_mul(104_729) % 500) + 110.5,
        ]
    };
    group.bench_function("pick, all told", |bencher| {
        bencher.iter_batched(&mut place, |place| view.at(place), BatchSize::SmallInput);
    });
    group.bench_function("sliver of 5x5 pixels", |bencher| {
        bencher.iter_batched(
            || {
                let [x, y] = place();
                Region::rectangle(x, y, 5.0, 5.0)
            },
            |region| region.map(|region| view.triangles_in(0, &region)).ok(),
            BatchSize::SmallInput,
        );
    });
    group.finish();
}

fn all(criterion: &mut Criterion) {
    let ball = ball();
    let (positions, triangles) = (ball.positions.clone(), ball.triangles.clone());
    let mesh = Mesh { positions, normals: Vec::new(), triangles };
    let triangles = rival_triangles(&mesh);
    build(criterion, &mesh, &triangles);
    rays(criterion, &mesh, &triangles);
    windows(criterion, ball);
}

criterion_group!(benches, all);
criterion_main!(benches);
