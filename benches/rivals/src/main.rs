//! Closest hits beside obvhs, on the same mesh and the same rays, in one run.
//!
//!     cargo run --release -- MESH.bin [THREADS] [FILTER]
//!
//! The mesh: "CHM1", u32 vertices, u32 triangles, f32x3 positions, f32x3 normals, u32x3 indices,
//! little endian, within the unit ball. Rays: those of the 1280x720 pixels of a camera at (0, 0, 3),
//! 45 degrees high, in tiles of 8x8; and as many chords through the ball. Rows are medians of
//! rounds that take turns, so that a busy machine is busy for all; hits are counted, as a check.

use luxel_bvh::{Bvh, MeshRays, Quality, Ray, TooManyForTree};
use luxel_rivals::{Mesh, camera_rays, chords, read, rival_ray, rival_triangles};
use obvhs::BvhBuildParams;
use obvhs::bvh2::builder::build_bvh2_from_tris;
use obvhs::cwbvh::builder::build_cwbvh_from_tris;
use obvhs::ray::RayHit;
use obvhs::triangle::Triangle;
use rayon::prelude::*;
use std::sync::{LazyLock, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Rounds that count, after one that warms up; `RIVALS_ROUNDS` in the environment says another number.
fn rounds() -> usize {
    std::env::var("RIVALS_ROUNDS").ok().and_then(|text| text.parse().ok()).unwrap_or(5).max(1)
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
fn measure(mut rows: Vec<Row<'_>>, filter: &str) {
    rows.retain(|row| row.name.contains(filter));
    let mut times = vec![Vec::new(); rows.len()];
    let mut hits = vec![0; rows.len()];
    let rounds = rounds();
    for round in 0..=rounds {
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
        let (median, least): (Duration, Duration) = (times[rounds / 2], times[0]);
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
    let path = arguments.first().ok_or("usage: luxel-rivals MESH.bin [THREADS] [FILTER]")?;
    let threads = arguments.get(1).map_or(Ok(1), |threads| threads.parse())?;
    let filter = arguments.get(2).map_or("", String::as_str);
    // Threads of a pool: outside of pools, luxel has its own.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let mesh = read(path)?;
    Ok(pool.install(|| compare(path, &mesh, filter))?)
}

/// Measures what `filter` chooses on one mesh, with the threads of the current pool.
fn compare(path: &str, mesh: &Mesh, filter: &str) -> Result<(), TooManyForTree> {
    let threads = rayon::current_num_threads();
    let count = mesh.triangles.len();
    let triangles = rival_triangles(mesh);
    let build = |quality| Bvh::build(&mesh.positions, &mesh.triangles, quality);
    let params = BvhBuildParams::medium_build;
    let bvh = build(Quality::Thorough)?;
    println!(
        "{path}: {count} triangles, {threads} threads; luxel {:.1} bytes a triangle",
        bvh.memory() as f64 / count as f64
    );
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let sorted = |order: &[u32]| -> Vec<Triangle> {
        order.iter().map(|&at| triangles[at as usize]).collect()
    };
    // Only what is asked for is built.
    let bvh2 = LazyLock::new(|| {
        let tree = build_bvh2_from_tris(&triangles, params(), &mut Duration::default());
        let triangles = sorted(&tree.primitive_indices);
        (tree, triangles)
    });
    let cwbvh = LazyLock::new(|| {
        let tree = build_cwbvh_from_tris(&triangles, params(), &mut Duration::default());
        let triangles = sorted(&tree.primitive_indices);
        (tree, triangles)
    });
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
        let hits = Mutex::new(Vec::new());
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
            Box::new(move || {
                // Into memory that is there, as Embree's hits go.
                let mut hits = hits.lock().unwrap_or_else(PoisonError::into_inner);
                rays.closest_of_each_into(aimed, &mut hits);
                hits.iter().flatten().count()
            }),
        ));
        rows.push(row(
            &format!("{kind} obvhs Bvh2"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || {
                let (tree, triangles) = &**bvh2;
                each(&|ray| {
                    let mut hit = RayHit::none();
                    tree.ray_traverse(rival_ray(ray), &mut hit, |ray, at| {
                        triangles[at].intersect(ray)
                    })
                })
            }),
        ));
        rows.push(row(
            &format!("{kind} obvhs CwBvh"),
            aimed.len(),
            "Mrays/s",
            Box::new(move || {
                let (tree, triangles) = &**cwbvh;
                each(&|ray| {
                    let mut hit = RayHit::none();
                    tree.ray_traverse(rival_ray(ray), &mut hit, |ray, at| {
                        triangles[at].intersect(ray)
                    })
                })
            }),
        ));
    }
    measure(rows, filter);
    Ok(())
}
