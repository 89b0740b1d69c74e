//! Times a frame in eight sets of tiles beside the frame at once, on one thread: sets of one view that is
//! binned once, and sets of calls that each bin the view, as renderers on several machines do.
//!
//! `cargo bench -p luxel --bench tiles`; prints medians in milliseconds, and each as a share of the
//! frame at once. The three take turns.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel::default_view;
use luxel::render::{Execution, Picture, Renderer};
use luxel::scene::{MaterialId, MeshId, Node, Part, Scene, SceneMaterial, Size, primitives};
use std::time::Instant;

const ROUNDS: usize = 41;
const SETS: usize = 8;

fn ball() -> Scene {
    let mut mesh = primitives::icosphere(1.0, 71);
    let count = mesh.triangles.len() as u32;
    mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        nodes: vec![Node::root("ball", Some(MeshId(0)))],
        ..Scene::default()
    }
}

fn main() {
    let scene = ball();
    for size in [Size { width: 640, height: 480 }, Size { width: 1920, height: 1080 }] {
        let view = default_view(&scene, size).with_samples(1);
        let execution = Execution { threads: 1, ..Execution::default() };
        let renderer = Renderer::new(scene.clone(), &execution).unwrap();
        let mut picture = Picture::default();
        let mut times = [const { Vec::new() }; 3];
        renderer.install(|| {
            for _ in 0..ROUNDS {
                let begin = Instant::now();
                renderer.rgba8_into(&view, &mut picture).unwrap();
                times[0].push(begin.elapsed());
                let begin = Instant::now();
                let in_sets = renderer.with_tiles(&view, |tiles| {
                    for set in 0..SETS {
                        tiles.rgba8_into(|tile| tile % SETS == set, &mut picture);
                    }
                });
                in_sets.unwrap();
                times[1].push(begin.elapsed());
                let begin = Instant::now();
                for set in 0..SETS {
                    let set = |tile| tile % SETS == set;
                    renderer.rgba8_tiles_into(&view, set, &mut picture).unwrap();
                }
                times[2].push(begin.elapsed());
            }
        });
        let medians = times.map(|mut times| {
            times.sort();
            times[ROUNDS / 2].as_secs_f64() * 1e3
        });
        let names = ["at once", "in 8 sets, binned once", "in 8 calls"];
        println!("{}x{}, {} triangles", size.width, size.height, scene.triangle_count());
        for (name, time) in names.iter().zip(medians) {
            println!("  {name:24} {time:8.3} ms  {:5.3}", time / medians[0]);
        }
    }
}
