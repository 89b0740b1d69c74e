//! Times fits of bumpy balls of 1000, 100 000 and a million triangles on one thread: the first of a
//! scene, which measures its meshes, and the next, from other sides.
//!
//! `cargo bench -p luxel-scene [-- FILTER]`; a filter is part of a row's name. Prints medians and the
//! least, in milliseconds, and a hash of the cameras. Rows called "shuffled" have their positions in
//! random order, "crowd" shows one mesh a thousand times.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel_scene::{
    Camera, DMat4, DVec3, Lens, Mesh, MeshId, Node, Scene, Size, Viewpoint, fit_view, primitives,
};
use std::time::Instant;

const SIZE: Size = Size { width: 1280, height: 720 };
const LENS: Lens = Lens::Perspective { fov_y_radians: 0.8 };
/// How often a scene is fitted for the first time.
const FIRST: usize = 9;
/// From how many sides it is fitted then.
const NEXT: u32 = 72;

fn bumpy_ball(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    mesh.normals = Vec::new();
    mesh
}

/// The same mesh, its positions in random order.
fn shuffled(mut mesh: Mesh) -> Mesh {
    let mut keys: Vec<(u32, u32)> =
        (0..mesh.positions.len() as u32).map(|at| (at.wrapping_mul(2_654_435_769), at)).collect();
    keys.sort_unstable();
    mesh.positions = keys.iter().map(|&(_, old)| mesh.positions[old as usize]).collect();
    let mut new = vec![0; keys.len()];
    for (at, &(_, old)) in keys.iter().enumerate() {
        new[old as usize] = at as u32;
    }
    for corner in mesh.triangles.as_flattened_mut() {
        *corner = new[*corner as usize];
    }
    mesh.attribute_corners = None;
    mesh
}

fn scene(mesh: Mesh, copies: u32) -> Scene {
    let node = |at: u32| {
        let place = DVec3::new(f64::from(at % 40), f64::from(at / 40), f64::from(at * 7 % 11));
        Node {
            parent_from_node: DMat4::from_translation(4.0 * place).into(),
            ..Node::root("ball", Some(MeshId(0)))
        }
    };
    Scene { meshes: vec![mesh].into(), nodes: (0..copies).map(node).collect(), ..Scene::default() }
}

fn fit(scene: &Scene, side: u32) -> Camera {
    let azimuth_radians = f64::from(side) * std::f64::consts::TAU / f64::from(NEXT);
    fit_view(
        scene,
        &Viewpoint { up: DVec3::Y, azimuth_radians, elevation_radians: 0.35 },
        LENS,
        SIZE,
    )
}

/// Median and least, in milliseconds.
fn summary(mut times: Vec<f64>) -> [f64; 2] {
    times.sort_by(f64::total_cmp);
    [times[times.len() / 2], times[0]]
}

fn main() {
    let filter = std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let filter = filter.unwrap_or_default();
    println!("{:<18} {:>22} {:>22}  cameras", "", "first [ms]", "next [ms]");
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for (name, frequency, copies, shuffle) in [
        ("1k", 7, 1, false),
        ("100k", 71, 1, false),
        ("1m", 224, 1, false),
        ("100k shuffled", 71, 1, true),
        ("1m shuffled", 224, 1, true),
        ("1k crowd", 7, 1000, false),
    ] {
        if !name.contains(&filter) {
            continue;
        }
        let mesh = bumpy_ball(frequency);
        let mesh = if shuffle { shuffled(mesh) } else { mesh };
        pool.install(|| {
            let mut hash = 0xcbf2_9ce4_8422_2325_u64;
            let mut timed = |scene: &Scene, side: u32| {
                let start = Instant::now();
                let camera = fit(scene, side);
                let time = start.elapsed().as_secs_f64() * 1e3;
                let numbers = camera.view_from_world.to_cols_array().map(f64::to_bits);
                for bits in numbers.into_iter().chain([camera.projection.near.to_bits()]) {
                    hash = (hash ^ bits).wrapping_mul(0x0100_0000_01b3);
                }
                time
            };
            let scenes: Vec<Scene> = (0..FIRST).map(|_| scene(mesh.clone(), copies)).collect();
            let first = scenes.iter().map(|scene| timed(scene, 0)).collect();
            let next = (1..NEXT).map(|side| timed(&scenes[0], side)).collect();
            let [[first, least], [next, least_of_next]] = [summary(first), summary(next)];
            println!(
                "{name:<18} {first:>10.4} {least:>11.4} {next:>10.4} {least_of_next:>11.4}  {hash:016x}"
            );
        });
    }
}
