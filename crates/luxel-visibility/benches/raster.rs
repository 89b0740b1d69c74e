//! Times the tile stage on one thread, from binned clusters to depth and ids: a bumpy sphere of 980, of
//! 100 000 and of a million triangles, at two sizes of the window, at every SIMD level.
//!
//! `cargo bench -p luxel-visibility --bench raster [-- FILTER]`; a filter is part of a row's name.
//! Prints the median and the least of some frames, in milliseconds, and a hash of the outcome,
//! which only a change of the picture may change.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use glam::DVec3;
use luxel_math::SimdLevel;
use luxel_scene::{Camera, Lens, Mesh, Projection, Size, primitives};
use luxel_visibility::{
    Clusters, CullFaces, Frame, Frames, Instance, PartUse, Samples, Tile, ViewFromLocal,
};
use std::time::Instant;

const FRAMES: usize = 15;

fn bumpy_sphere(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    mesh
}

/// The outcome's hash (FNV-1a over depths and ids).
fn hash(tile: &Tile, mut hash: u64) -> u64 {
    for plane in tile.planes() {
        let depths = plane.depth.iter().flatten().map(|depth| depth.to_bits());
        for word in depths.chain(plane.ids.iter().flatten().copied()) {
            hash = (hash ^ u64::from(word)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    hash
}

fn main() {
    let filter: Option<String> =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let mut levels: Vec<SimdLevel> = Vec::new();
    for level in SimdLevel::available() {
        // What a name stands for may be another level.
        let kernels = |level: SimdLevel| level.resolve().map(SimdLevel::name_of).ok();
        if !levels.iter().any(|one| kernels(*one) == kernels(level)) {
            levels.push(level);
        }
    }
    for (triangles, frequency) in [("1k", 7), ("100k", 71), ("1M", 224)] {
        let mesh = bumpy_sphere(frequency);
        let clusters = Clusters::new(&mesh, Frames::Many);
        for (width, height) in [(640, 480), (1920, 1080)] {
            for (sides, cull) in [("both", CullFaces::None), ("front", CullFaces::Clockwise)] {
                for samples in [1, 4] {
                    for &level in &levels {
                        let simd = SimdLevel::name_of(level.resolve().unwrap());
                        let name = format!("{triangles} {width} {sides} x{samples} {simd}");
                        if filter.as_ref().is_some_and(|filter| !name.contains(filter.as_str())) {
                            continue;
                        }
                        let part = PartUse { cull, ..PartUse::default() };
                        time(&name, &mesh, &clusters, Size { width, height }, samples, part, level);
                    }
                }
            }
        }
    }
}

fn time(
    name: &str,
    mesh: &Mesh,
    clusters: &Clusters,
    size: Size,
    samples: u32,
    part: PartUse,
    level: SimdLevel,
) {
    let level = level.resolve().unwrap();
    let view_from_mesh = Camera::look_at(DVec3::new(0.7, 1.1, 2.6), DVec3::ZERO, DVec3::Y);
    let view_from_local = ViewFromLocal::new(&view_from_mesh, mesh.origin);
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let projection = Projection { lens, near: 0.5, far: 10.0 };
    let samples = Samples::new(samples).unwrap();
    let (mut set_up, mut drawn) = (Vec::new(), Vec::new());
    let mut tile = Tile::new(samples.count());
    let mut outcome = 0;
    for _ in 0..FRAMES {
        let start = Instant::now();
        let instance = Instance {
            mesh,
            clusters,
            view_from_local: &view_from_local,
            parts: [part].into(),
            ranks: &[],
            is_repeated: false,
        };
        let frame = Frame::new(vec![instance], &projection, size, samples, level).unwrap();
        set_up.push(start.elapsed().as_secs_f64() * 1e3);
        let mut raster = 0.0;
        outcome = 0xcbf2_9ce4_8422_2325;
        for number in 0..frame.tiles().iter().product() {
            let start = Instant::now();
            frame.draw_opaque(level, number, &|_, _| false, &mut tile);
            raster += start.elapsed().as_secs_f64() * 1e3;
            outcome = hash(&tile, outcome);
        }
        drawn.push(raster);
    }
    let [set_up, drawn] = [set_up, drawn].map(|mut times| {
        times.sort_by(f64::total_cmp);
        (times[FRAMES / 2], times[0])
    });
    println!(
        "{name:28} tiles {:8.3} (least {:8.3})  set-up {:6.3} (least {:6.3})  {outcome:016x}",
        drawn.0, drawn.1, set_up.0, set_up.1
    );
}
