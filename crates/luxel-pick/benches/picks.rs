//! Times picks, one by one and many at once, and slivers on a bumpy sphere of a thousand, 100 000, a
//! million and five million triangles. `RAYON_NUM_THREADS=1` compares one thread with one.
//!
//! `cargo bench -p luxel-pick [-- FILTER]`; a filter is part of a row's name. Prints the median and the
//! least of some rounds, and the number of hits.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel_pick::{PickView, Picker, Region};
use luxel_scene::{
    Camera, DVec3, Lens, MaterialId, Mesh, MeshId, Node, Part, Projection, Scene, SceneMaterial,
    Size, primitives,
};
use luxel_visibility::Cull;
use std::time::Instant;

const ROUNDS: usize = 15;
const SIZE: Size = Size { width: 1280, height: 720 };

fn bumpy_sphere(frequency: u32) -> Mesh {
    let mut mesh = primitives::icosphere(1.0, frequency);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    mesh.parts =
        vec![Part { first: 0, count: mesh.triangles.len() as u32, material: MaterialId(0) }];
    mesh
}

fn camera() -> Camera {
    let view_from_world = Camera::look_at(DVec3::new(0.7, 1.1, 2.6), DVec3::ZERO, DVec3::Y);
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    Camera { view_from_world, projection: Projection { lens, near: 0.5, far: 10.0 } }
}

/// 10 000 places at random all over the window.
fn scattered() -> Vec<[f64; 2]> {
    let mut state = 12_345_u64;
    let mut random = |side: u32| {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / f64::from(1 << 24) * f64::from(side)
    };
    (0..10_000).map(|_| [random(SIZE.width), random(SIZE.height)]).collect()
}

/// The pixels of a square of 100x100 on the sphere.
fn dense() -> Vec<[f64; 2]> {
    (0..10_000).map(|at| [590.5 + f64::from(at % 100), 310.5 + f64::from(at / 100)]).collect()
}

/// Median and least of some rounds, in seconds.
fn time(mut work: impl FnMut()) -> (f64, f64) {
    let mut times: Vec<f64> = (0..ROUNDS)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    (times[ROUNDS / 2], times[0])
}

fn main() {
    let filter: Option<String> =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let wanted = |name: &str| filter.as_ref().is_none_or(|filter| name.contains(filter.as_str()));
    for (triangles, frequency) in [("1k", 7), ("100k", 71), ("1M", 224), ("5M", 500)] {
        // A filter that names another size wants none of this one's rows.
        let names_size = |size: &str| filter.as_ref().is_some_and(|filter| filter.contains(size));
        if ["1k", "100k", "1M", "5M"].into_iter().any(names_size) && !names_size(triangles) {
            continue;
        }
        let mesh = bumpy_sphere(frequency);
        let scene = Scene {
            meshes: vec![mesh].into(),
            materials: vec![SceneMaterial::default()],
            nodes: vec![Node::root("sphere", Some(MeshId(0)))],
            ..Scene::default()
        };
        let picker = Picker::new(scene).unwrap();
        let view = PickView::new(&picker, camera(), SIZE, Cull::Auto).unwrap();
        let places: Vec<[f64; 2]> = (0..20_000)
            .map(|at| [f64::from(at * 7919 % 1280) + 0.5, f64::from(at * 104_729 % 720) + 0.5])
            .collect();
        let name = format!("{triangles} pick, all told");
        if wanted(&name) {
            let mut hits = 0;
            let (median, least) =
                time(|| hits = places.iter().filter_map(|&place| view.at(place)).count());
            report(&name, places.len(), median, least, hits);
        }
        let name = format!("{triangles} pick, owner only");
        if wanted(&name) {
            let mut hits = 0;
            let (median, least) =
                time(|| hits = places.iter().filter_map(|&place| view.owner_at(place)).count());
            report(&name, places.len(), median, least, hits);
        }
        for (kind, places) in [("scattered", scattered()), ("dense", dense())] {
            let row = |way: &str, pick: &dyn Fn() -> usize| {
                let name = format!("{triangles} 10 000 {kind}, {way}");
                if wanted(&name) {
                    let mut hits = 0;
                    let (median, least) = time(|| hits = pick());
                    report(&name, places.len(), median, least, hits);
                }
            };
            row("one by one", &|| places.iter().filter_map(|&place| view.at(place)).count());
            row("at once", &|| view.at_many(&places).iter().flatten().count());
            row("owners one by one", &|| {
                places.iter().filter_map(|&place| view.owner_at(place)).count()
            });
            row("owners at once", &|| view.owner_at_many(&places).iter().flatten().count());
        }
        let name = format!("{triangles} sliver of 5x5 pixels");
        if wanted(&name) {
            let mut hits = 0;
            let (median, least) = time(|| {
                hits = 0;
                for &[x, y] in &places[..2000] {
                    let region = Region::rectangle(x, y, 5.0, 5.0).unwrap();
                    hits += view.triangles_in(0, &region).len();
                }
            });
            report(&name, 2000, median, least, hits);
        }
    }
}

fn report(name: &str, count: usize, median: f64, least: f64, hits: usize) {
    let (each, rate) = (median / count as f64 * 1e9, count as f64 / median * 1e-6);
    let least = least / count as f64 * 1e9;
    println!("{name:44} {each:9.1} ns each (least {least:.1}), {rate:7.2} M/s, {hits} hits");
}
