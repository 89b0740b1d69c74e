//! Whether anything is in the way of rays from what a camera sees: the rays that shadows and openness ask
//! for, and how long luxel takes for them; see ../../occlusion.
//!
//!     occlusion write MESH.bin RAYS.bin
//!     occlusion time MESH.bin RAYS.bin THREADS ROUNDS
//!
//! The camera is that of src/lib.rs; blocks of 4x4 pixels follow one another. From what each pixel sees goes
//! a ray to a light far away, where the triangle faces it, and 16 rays about the triangle's normal, more of
//! them near it by the cosine of their angle, as far as a quarter of the radius of the mesh's box. RAYS.bin:
//! u32 rays to the light, u32 rays of openness, then all of them, 8 f32 each: origin, direction, range.
//! A row: what, the least and the median of the rounds in milliseconds, and hits as a check.

use luxel_bvh::{Bvh, MeshRays, Quality, Ray, RayColumns};
use luxel_rivals::{Mesh, read};
use std::error::Error;
use std::f32::consts::TAU;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

const WIDTH: u32 = 1280;
const HEIGHT: u32 = 720;
/// Rays of openness at each pixel.
const RAYS: u32 = 16;
/// What a thread takes at a time; whole batches.
const CHUNK: usize = 4096;
/// Towards the light.
const LIGHT: [f32; 3] = [0.324_442_84, 0.486_664_26, 0.811_107_1];

type Vector = glam::Vec3;

/// A number that looks random, as in `luxel-render/src/shadow/sequence.rs`.
fn mix(number: u32) -> u32 {
    let number = (number ^ number >> 16).wrapping_mul(0x7feb_352d);
    let number = (number ^ number >> 15).wrapping_mul(0x846c_a68b);
    number ^ number >> 16
}

/// The second dimension of Sobol's sequence.
fn sobol(mut number: u32) -> u32 {
    let (mut direction, mut result) = (1_u32 << 31, 0);
    while number != 0 {
        if number & 1 == 1 {
            result ^= direction;
        }
        number >>= 1;
        direction ^= direction >> 1;
    }
    result
}

/// The rays to the light, and those of openness.
fn occlusion_rays(mesh: &Mesh) -> Result<[Vec<Ray>; 2], Box<dyn Error>> {
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough)?;
    let rays = MeshRays::new(&bvh, &mesh.positions);
    let (low, high) = mesh
        .positions
        .iter()
        .fold((Vector::INFINITY, Vector::NEG_INFINITY), |(low, high), &position| {
            (low.min(position.into()), high.max(position.into()))
        });
    let radius = 0.25 * 0.5 * (high - low).length();
    let half = (22.5_f32).to_radians().tan();
    let eye = Vector::new(0.0, 0.0, 3.0);
    let [mut to_light, mut open] = [Vec::new(), Vec::new()];
    for at in 0..WIDTH * HEIGHT {
        let (block, pixel) = (at / 16, at % 16);
        let x = block % (WIDTH / 4) * 4 + pixel % 4;
        let y = block / (WIDTH / 4) * 4 + pixel / 4;
        let across = half * WIDTH as f32 / HEIGHT as f32;
        let along = Vector::new(
            across * (2.0 * (x as f32 + 0.5) / WIDTH as f32 - 1.0),
            half * (1.0 - 2.0 * (y as f32 + 0.5) / HEIGHT as f32),
            -1.0,
        );
        let along = along.normalize();
        let Some(hit) = rays.closest(&Ray::new(eye.into(), along.into())) else { continue };
        let [a, b, c] = mesh.triangles[hit.triangle as usize]
            .map(|vertex| Vector::from(mesh.positions[vertex as usize]));
        let Some(normal) = (b - a).cross(c - a).try_normalize() else { continue };
        let normal = if normal.dot(along) > 0.0 { -normal } else { normal };
        let origin = (eye + along * hit.t + normal * 1e-5).into();
        if normal.dot(LIGHT.into()) > 0.0 {
            to_light.push(Ray::new(origin, LIGHT));
        }
        let (tangent, bitangent) = normal.any_orthonormal_pair();
        let first = mix(mix(x) ^ y);
        for number in 0..RAYS {
            let unit = |bits: u32| (bits >> 8) as f32 / (1 << 24) as f32;
            let (u, v) = (unit(number.reverse_bits() ^ first), unit(sobol(number) ^ mix(first)));
            let (sine, cosine) = (TAU * v).sin_cos();
            let across = u.sqrt();
            let direction = tangent * (across * cosine)
                + bitangent * (across * sine)
                + normal * (1.0 - u).sqrt();
            open.push(Ray { origin, direction: direction.into(), range: [0.0, radius] });
        }
    }
    Ok([to_light, open])
}

fn write(mesh: &Mesh, path: &str) -> Result<(), Box<dyn Error>> {
    let kinds = occlusion_rays(mesh)?;
    let mut bytes = Vec::new();
    bytes.extend(kinds.iter().flat_map(|rays| (rays.len() as u32).to_le_bytes()));
    for Ray { origin, direction, range } in kinds.iter().flatten() {
        let numbers = origin.iter().chain(direction).chain(range);
        bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
    }
    Ok(std::fs::write(path, bytes)?)
}

fn read_rays(path: &str) -> Result<[Vec<Ray>; 2], Box<dyn Error>> {
    let bytes = std::fs::read(path)?;
    let (words, _) = bytes.as_chunks::<4>();
    let [to_light, open, numbers @ ..] = words else { return Err("no rays".into()) };
    let count = |word: &[u8; 4]| u32::from_le_bytes(*word) as usize;
    let (numbers, _) = numbers.as_chunks::<8>();
    let ray = |words: &[[u8; 4]; 8]| {
        let [ox, oy, oz, dx, dy, dz, start, end] = words.map(f32::from_le_bytes);
        Ray { origin: [ox, oy, oz], direction: [dx, dy, dz], range: [start, end] }
    };
    let rays: Vec<Ray> = numbers.iter().map(ray).collect();
    let (first, second) = rays.split_at_checked(count(to_light)).ok_or("too short")?;
    if second.len() != count(open) {
        return Err("too short".into());
    }
    Ok([first.to_vec(), second.to_vec()])
}

/// How many rays are blocked; `work` answers a chunk on one of the threads.
fn each(rays: &[Ray], threads: usize, work: &(dyn Fn(&[Ray]) -> usize + Sync)) -> usize {
    let next = AtomicUsize::new(0);
    let run = || {
        let mut hits = 0;
        while let Some(chunk) = rays.chunks(CHUNK).nth(next.fetch_add(1, Ordering::Relaxed)) {
            hits += work(chunk);
        }
        hits
    };
    std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(run)).collect();
        run() + others.into_iter().map(|thread| thread.join().unwrap_or(0)).sum::<usize>()
    })
}

/// Rays side by side, sixteen to each of the blocks.
fn columns<'b>(rays: &[Ray], blocks: &'b mut [RayColumns]) -> &'b [RayColumns] {
    let count = rays.len().div_ceil(16);
    for (rays, block) in rays.chunks(16).zip(blocks.iter_mut()) {
        block.lanes = (1 << rays.len()) - 1;
        for (lane, Ray { origin, direction, range }) in rays.iter().enumerate() {
            for axis in 0..3 {
                block.origin[axis][lane] = origin[axis];
                block.direction[axis][lane] = direction[axis];
            }
            block.range[0][lane] = range[0];
            block.range[1][lane] = range[1];
        }
    }
    &blocks[..count]
}

fn blocked(hits: &[bool]) -> usize {
    hits.iter().filter(|hit| **hit).count()
}

fn time(
    mesh: &Mesh,
    [to_light, open]: [Vec<Ray>; 2],
    threads: usize,
    rounds: usize,
) -> Result<(), Box<dyn Error>> {
    let bvh = Bvh::build(&mesh.positions, &mesh.triangles, Quality::Thorough)?;
    let traced = MeshRays::new(&bvh, &mesh.positions);
    let singly = |chunk: &[Ray]| chunk.iter().filter(|ray| traced.any(ray)).count();
    // As the renderer makes them: the rays of two blocks to a light, in columns, and 16 rays from each pixel.
    let to_light_of_blocks = |chunk: &[Ray]| {
        let mut hits = [0; 2];
        let of = |rays: &[Ray], hits: &mut [u32]| {
            let mut blocks = [RayColumns::NONE; 2];
            let columns = columns(rays, &mut blocks);
            traced.any_of_columns(columns, &mut hits[..columns.len()]);
            hits[..columns.len()].iter().map(|hits| hits.count_ones() as usize).sum::<usize>()
        };
        chunk.chunks(32).map(|rays| of(rays, &mut hits)).sum()
    };
    let open_of_block = |chunk: &[Ray]| {
        let mut hits = [false; 256];
        let of = |rays: &[Ray], hits: &mut [bool]| {
            traced.any_of_incoherent(rays, hits);
            blocked(hits)
        };
        chunk.chunks(256).map(|rays| of(rays, &mut hits[..rays.len()])).sum()
    };
    type Work<'w> = &'w (dyn Fn(&[Ray]) -> usize + Sync);
    let rows: [(&str, &[Ray], Work<'_>); 4] = [
        ("light luxel, one at a time", &to_light, &singly),
        ("light luxel, by blocks", &to_light, &to_light_of_blocks),
        ("openness luxel, one at a time", &open, &singly),
        ("openness luxel, by blocks", &open, &open_of_block),
    ];
    for (name, rays, work) in rows {
        let (mut times, mut hits) = (Vec::new(), 0);
        for round in 0..=rounds {
            let start = Instant::now();
            hits = each(rays, threads, work);
            if round > 0 {
                times.push(start.elapsed().as_secs_f64() * 1e3);
            }
        }
        times.sort_by(f64::total_cmp);
        println!("{name}\t{:.3}\t{:.3}\t{hits} of {}", times[0], times[rounds / 2], rays.len());
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        ["write", mesh, rays] => write(&read(mesh)?, rays),
        ["time", mesh, rays, threads, rounds] => {
            time(&read(mesh)?, read_rays(rays)?, threads.parse()?, rounds.parse::<usize>()?.max(1))
        }
        _ => {
            Err("usage: occlusion write MESH.bin RAYS.bin | time MESH.bin RAYS.bin THREADS ROUNDS"
                .into())
        }
    }
}
