//! Closest hits beside obvhs, on the same mesh and the same rays, in one run.
//!
//!     cargo run --release -- MESH.bin [THREADS]
//!
//! The mesh: "CHM1", u32 vertices, u32 triangles, f32x3 positions, f32x3 normals, u32x3 indices,
//! little endian, within the unit ball. Rays: those of the 1280x720 pixels of a camera at (0, 0, 3),
//! 45 degrees high, in tiles of 8x8; and as many chords through the ball. Rows are medians of
//! rounds that take turns, so that a busy machine is busy for all; hits are counted, as a check.

use glam::Vec3A;
use luxel_pick::{Bvh, MeshRays, Quality, Ray};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::{Ray as RivalRay, RayHit};
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use std::time::{Duration, Instant};

const ROUNDS: usize = 5;

struct Mesh {
    positions: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
}

fn read(path: &str) -> Result<Mesh, Box<dyn std::error::Error>> {
    let bytes = std::fs::read(path)?;
    if !bytes.starts_with(b"CHM1") {
        return Err("no CHM1 mesh".into());
    }
    let word = |at: usize| {
        bytes.get(at..at + 4).and_then(|word| word.try_into().ok()).map(u32::from_le_bytes)
    };
    let count = |at| word(at).map(|count| count as usize).ok_or("too short");
    let (vertices, triangles) = (count(4)?, count(8)?);
    let triple = |at: usize| Some([word(at)?, word(at + 4)?, word(at + 8)?]);
    let places =
        (0..vertices).map(|at| triple(12 + 12 * at).map(|place| place.map(f32::from_bits)));
    let corners = (0..triangles).map(|at| triple(12 + 24 * vertices + 12 * at));
    let positions = places.collect::<Option<_>>().ok_or("too short")?;
    let triangles = corners.collect::<Option<_>>().ok_or("too short")?;
    Ok(Mesh { positions, triangles })
}

fn camera_rays(width: u32, height: u32) -> Vec<Ray> {
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

fn chords(count: usize) -> Vec<Ray> {
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

/// One row: what is measured, and what a round of it gives to count.
struct Row<'a> {
    name: String,
    count: usize,
    unit: &'a str,
    work: Box<dyn Fn() -> usize + Sync + 'a>,
}

fn row<'a>(
    name: &str,
    count: usize,
    unit: &'a str,
    work: Box<dyn Fn() -> usize + Sync + 'a>,
) -> Row<'a> {
    Row { name: name.to_owned(), count, unit, work }
}

/// Runs all rows in turns.
fn measure(rows: &[Row<'_>]) {
    let mut times = vec![Vec::new(); rows.len()];
    let mut hits = vec![0; rows.len()];
    for round in 0..=ROUNDS {
        for (at, row) in rows.iter().enumerate() {
            let start = Instant::now();
            hits[at] = (row.work)();
            if round > 0 {
                times[at].push(start.elapsed());
            }
        }
    }
    for ((row, mut times), hits) in rows.iter().zip(times).zip(hits) {
        times.sort();
        let (median, least): (Duration, Duration) = (times[ROUNDS / 2], times[0]);
        let rate = |time: Duration| row.count as f64 / time.as_secs_f64() * 1e-6;
        println!(
            "{:36} {:9.2} ms, {:8.2} {} (best {:.2}), {hits} hits",
            row.name,
            median.as_secs_f64() * 1e3,
            rate(median),
            row.unit,
            rate(least)
        );
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let path = arguments.first().ok_or("usage: luxel-rivals MESH.bin [THREADS]")?;
    let threads = arguments.get(1).map_or(Ok(1), |threads| threads.parse())?;
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global()?;
    let mesh = read(path)?;
    let count = mesh.triangles.len();
    let place = |at: u32| Vec3A::from_array(mesh.positions[at as usize]);
    let of = |corners: &[u32; 3]| {
        let [v0, v1, v2] = corners.map(place);
        Triangle { v0, v1, v2 }
    };
    let triangles: Vec<Triangle> = mesh.triangles.iter().map(of).collect();
    let build = |quality| Bvh::build(&mesh.positions, &mesh.triangles, quality);
    let params = BvhBuildParams::medium_build;
    let bvh = build(Quality::Thorough)?;
    println!(
        "{path}: {count} triangles, {threads} threads; luxel {:.1} bytes a triangle",
        bvh.memory() as f64 / count as f64
    );
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let bvh2 = build_bvh2_from_tris(&triangles, params(), &mut Duration::default());
    let cwbvh = build_cwbvh_from_tris(&triangles, params(), &mut Duration::default());
    let sorted = |order: &[u32]| -> Vec<Triangle> {
        order.iter().map(|&at| triangles[at as usize]).collect()
    };
    let (of_bvh2, of_cwbvh) = (sorted(&bvh2.primitive_indices), sorted(&cwbvh.primitive_indices));
    let rival_ray = |ray: &Ray| {
        RivalRay::new_inf(Vec3A::from_array(ray.origin), Vec3A::from_array(ray.direction))
    };
    let camera = camera_rays(1280, 720);
    let random = chords(camera.len());
    let mut rows = vec![
        row(
            "build luxel",
            count,
            "Mtri/s",
            Box::new(|| build(Quality::Thorough).map_or(0, |b| b.triangles())),
        ),
        row(
            "build luxel, fast",
            count,
            "Mtri/s",
            Box::new(|| build(Quality::Fast).map_or(0, |b| b.triangles())),
        ),
        row(
            "build luxel, in order",
            count,
            "Mtri/s",
            Box::new(|| build(Quality::InOrder).map_or(0, |b| b.triangles())),
        ),
        row(
            "build obvhs Bvh2",
            count,
            "Mtri/s",
            Box::new(|| {
                build_bvh2_from_tris(&triangles, params(), &mut Duration::default())
                    .primitive_indices
                    .len()
            }),
        ),
        row(
            "build obvhs CwBvh",
            count,
            "Mtri/s",
            Box::new(|| {
                build_cwbvh_from_tris(&triangles, params(), &mut Duration::default())
                    .primitive_indices
                    .len()
            }),
        ),
    ];
    for (kind, aimed) in [("camera", &camera), ("random", &random)] {
        let each = move |hits: &(dyn Fn(&Ray) -> bool + Sync)| -> usize {
            aimed.par_chunks(16384).map(|run| run.iter().filter(|ray| hits(ray)).count()).sum()
        };
        let (rays, bvh2, cwbvh) = (&rays, &bvh2, &cwbvh);
        let (of_bvh2, of_cwbvh) = (&of_bvh2, &of_cwbvh);
        rows.push(row(
            &format!("{kind} luxel, one at a time"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || each(&|ray| rays.closest(ray).is_some())),
        ));
        rows.push(row(
            &format!("{kind} luxel, batch"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || rays.closest_of_each(aimed).iter().flatten().count()),
        ));
        rows.push(row(
            &format!("{kind} obvhs Bvh2"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || {
                each(&|ray| {
                    let mut hit = RayHit::none();
                    bvh2.ray_traverse(rival_ray(ray), &mut hit, |ray, at| {
                        of_bvh2[at].intersect(ray)
                    })
                })
            }),
        ));
        rows.push(row(
            &format!("{kind} obvhs CwBvh"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || {
                each(&|ray| {
                    let mut hit = RayHit::none();
                    cwbvh.ray_traverse(rival_ray(ray), &mut hit, |ray, at| {
                        of_cwbvh[at].intersect(ray)
                    })
                })
            }),
        ));
    }
    measure(&rows);
    Ok(())
}
