//! Times single and batched rays through scenes of few and of many objects: up to how many objects batches pay.
//!
//! `cargo bench -p luxel-rays`, with `RAYON_NUM_THREADS=1` for one thread. A row is a number of balls side by
//! side, which have 80 000 triangles together, and the rays: a camera's, row by row, or scattered ones. Then the light
//! that comes along a camera's rays, two blocks of 4x4 pixels together as the renderer traces them, through balls that
//! are opaque and through half transparent ones.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel_math::LANES;
use luxel_rays::{RayLanes, SceneRays, Spread, WorldRay};
use luxel_scene::{
    AlphaMode, DMat4, DVec3, MaterialId, MeshId, Node, Part, Scene, SceneMaterial, primitives,
};
use std::time::Instant;

const ROUNDS: usize = 15;
const SIDE: u32 = 256;

/// Balls on a square grid that is two units wide, of one mesh.
fn balls(count: usize, alpha_mode: AlphaMode) -> Scene {
    let across = (1..).find(|side| side * side >= count).unwrap_or(1);
    let radius = 0.9 / across as f64;
    let frequency = (80_000.0 / count as f64 / 20.0).sqrt() as u32;
    let mut mesh = primitives::icosphere(radius, frequency);
    mesh.parts =
        vec![Part { first: 0, count: mesh.triangles.len() as u32, material: MaterialId(0) }];
    let node = |at: usize| {
        let place = |at: usize| (2 * at + 1) as f64 / across as f64 - 1.0;
        let mut node = Node::root("ball", Some(MeshId(0)));
        let at = DVec3::new(place(at % across), place(at / across), 0.0);
        node.parent_from_node = DMat4::from_translation(at).into();
        node
    };
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial { alpha_mode, opacity: 0.5, ..SceneMaterial::default() }],
        nodes: (0..count).map(node).collect(),
        ..Scene::default()
    }
}

fn camera() -> Vec<WorldRay> {
    let at = |at: u32| f64::from(2 * at + 1) / f64::from(SIDE) - 1.0;
    let eye = DVec3::new(0.0, 0.0, 4.0);
    (0..SIDE * SIDE)
        .map(|pixel| WorldRay::new(eye, DVec3::new(at(pixel % SIDE), at(pixel / SIDE), 0.0) - eye))
        .collect()
}

/// Rays of a camera, sixteen neighbours side by side.
fn blocks(rays: &[WorldRay]) -> Vec<RayLanes> {
    let across = SIDE / 4;
    let block = |block: u32| {
        let mut lanes = RayLanes::NONE;
        for lane in 0..LANES as u32 {
            let [x, y] = [block % across * 4 + lane % 4, block / across * 4 + lane / 4];
            lanes.put(lane as usize, &rays[(y * SIDE + x) as usize]);
        }
        lanes
    };
    (0..across * across).map(block).collect()
}

fn scattered() -> Vec<WorldRay> {
    let mut state = 12_345_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 23) - 1.0
    };
    let mut vector = || DVec3::new(random(), random(), random());
    (0..SIDE * SIDE)
        .map(|_| {
            let origin = vector() * 4.0;
            WorldRay::new(origin, vector() * DVec3::new(1.0, 1.0, 0.2) - origin)
        })
        .collect()
}

/// The least of some rounds, in milliseconds, and what the work counts.
fn time(work: impl Fn() -> usize) -> (f64, usize) {
    let mut least = f64::INFINITY;
    let mut count = 0;
    for _ in 0..ROUNDS {
        let start = Instant::now();
        count = work();
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    (least, count)
}

fn main() {
    for count in [1, 2, 4, 6, 8, 12, 16, 32, 100] {
        let scene = SceneRays::new(balls(count, AlphaMode::Opaque)).unwrap();
        for (kind, rays) in [("camera", camera()), ("scattered", scattered())] {
            let (alone, hits) = time(|| rays.iter().filter_map(|ray| scene.closest(ray)).count());
            let (together, _) = time(|| scene.closest_of_each(&rays).iter().flatten().count());
            let ratio = together / alone;
            println!(
                "{count:4} {kind:10} alone {alone:7.2} ms, at once {together:7.2} ms, {ratio:.2}, {hits} hits"
            );
        }
    }
    for (kind, alpha_mode) in [("opaque", AlphaMode::Opaque), ("glass", AlphaMode::Blend)] {
        for count in [1, 4, 16, 100, 1024] {
            let scene = SceneRays::new(balls(count, alpha_mode)).unwrap();
            let rays = camera();
            let blocks = blocks(&rays);
            let is_dark = |through: &&f32| **through < 1.0;
            let (alone, dark) =
                time(|| rays.iter().filter(|ray| scene.transmittance(ray) < 1.0).count());
            let (together, _) = time(|| {
                let mut count = 0;
                for two in blocks.chunks_exact(2) {
                    let mut through = [[0.0; LANES]; 2];
                    scene.transmittance_of_lanes(two, Spread::Narrow, &mut through);
                    count += through.as_flattened().iter().filter(is_dark).count();
                }
                count
            });
            let ratio = together / alone;
            println!(
                "{count:4} {kind:10} alone {alone:7.2} ms, at once {together:7.2} ms, {ratio:.2}, {dark} dark"
            );
        }
    }
}
