//! Times frames on one thread, by stage: a bumpy ball of 100 000 triangles, by the ways to shade,
//! with a texture, and with holes cut by it, with one light and with five, with one sample a pixel
//! and with four, at every SIMD level.
//!
//! `cargo bench -p luxel --bench frames [-- FILTER]`; a filter is part of a row's name. Prints
//! medians of some frames, in milliseconds, and a hash of the pixels, which is the same at all
//! levels.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel::default_view;
use luxel::math::SimdLevel;
use luxel::render::{Execution, Picture, Renderer, ShadingMode, View};
use luxel::scene::{
    AlphaMode, Encoding, Image, MaterialId, MeshId, Node, Part, Sampler, Scene, SceneMaterial,
    Size, Texture, TextureId, TextureUse, primitives,
};
use std::sync::{Arc, LazyLock};
use std::time::{Duration, Instant};

const FRAMES: usize = 15;

static BEGUN: LazyLock<Instant> = LazyLock::new(Instant::now);

fn bumpy_ball() -> Scene {
    let mut mesh = primitives::icosphere(1.0, 71);
    for position in &mut mesh.positions {
        let [x, y, z] = position.map(f64::from);
        let bumps = libm::sin(9.0 * x) * libm::sin(7.0 * y + 1.0) * libm::sin(8.0 * z);
        *position = position.map(|value| value * (1.0 + 0.15 * bumps) as f32);
    }
    let count = mesh.triangles.len() as u32;
    mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![SceneMaterial::default()],
        nodes: vec![Node::root("ball", Some(MeshId(0)))],
        ..Scene::default()
    }
}

/// The same scene, noise spread over its meshes: along the axis that it is spread by, footprints
/// are as long as they get.
fn textured(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    const SIDE: u32 = 512;
    let mut state = 1_u32;
    let texels = (0..SIDE * SIDE).map(|_| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        state.to_be_bytes()
    });
    let image = Image::new("noise", Encoding::Srgb, SIDE, SIDE, texels.collect());
    scene.textures = vec![Texture { image: Arc::new(image), sampler: Sampler::trilinear() }];
    for mesh in &mut scene.meshes {
        let corners = mesh.attribute_corners.as_ref().unwrap_or(&mesh.triangles);
        let used = corners.as_flattened().iter().zip(mesh.triangles.as_flattened());
        let count = corners.as_flattened().iter().max().map_or(0, |last| *last as usize + 1);
        let mut uvs = vec![[0.0; 2]; count];
        for (attribute, position) in used {
            let [x, y, _] = mesh.positions[*position as usize];
            uvs[*attribute as usize] = [2.0 * x, 2.0 * y];
        }
        mesh.uvs[0] = uvs;
    }
    for material in &mut scene.materials {
        material.base_color = Some(TextureUse::new(TextureId(0)).into());
    }
    scene
}

/// The same scene, half of its texels cut away.
fn masked(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for material in &mut scene.materials {
        material.alpha_mode = AlphaMode::Mask { cutoff: 0.5 };
    }
    scene
}

/// Medians of the frame and its stages, and a hash (FNV-1a) of the pixels.
fn time(scene: &Scene, view: &View, simd: SimdLevel) -> ([f64; 4], u64) {
    let execution =
        Execution { threads: 1, simd, clock: || BEGUN.elapsed(), ..Execution::default() };
    let renderer = Renderer::new(scene.clone(), &execution).unwrap();
    let mut picture = Picture::default();
    let mut times = [const { Vec::new() }; 4];
    for _ in 0..FRAMES {
        renderer.rgba8_into(view, &mut picture).unwrap();
        let stages = &picture.stages;
        let all = [stages.frame, stages.bin, stages.visibility, stages.shade];
        for (list, time) in times.iter_mut().zip(all) {
            list.push(time);
        }
    }
    let median = |mut times: Vec<Duration>| {
        times.sort();
        times[FRAMES / 2].as_secs_f64() * 1e3
    };
    let bytes = picture.pixels.iter().flatten();
    let hash = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    (times.map(median), hash)
}

fn main() {
    let filter: Option<String> =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let plain = bumpy_ball();
    let textured = textured(&plain);
    let masked = masked(&textured);
    let mut levels: Vec<SimdLevel> = Vec::new();
    for level in SimdLevel::available() {
        // A name may stand for another level.
        let told = |level: SimdLevel| level.resolve().map(SimdLevel::name_of).ok();
        if !levels.iter().any(|one| told(*one) == told(level)) {
            levels.push(level);
        }
    }
    for (shading, mode, scene) in [
        ("flat", ShadingMode::Flat, &plain),
        ("gouraud", ShadingMode::Gouraud, &plain),
        ("phong", ShadingMode::Phong, &plain),
        ("textured", ShadingMode::Phong, &textured),
        ("masked", ShadingMode::Phong, &masked),
    ] {
        for count in [1, 5] {
            for samples in [1, 4] {
                for &level in &levels {
                    let simd = SimdLevel::name_of(level.resolve().unwrap());
                    let name = format!("{shading} lights {count} x{samples} {simd}");
                    if filter.as_ref().is_some_and(|filter| !name.contains(filter.as_str())) {
                        continue;
                    }
                    let mut view = default_view(scene, Size { width: 1280, height: 720 });
                    view.shading.mode = mode;
                    view.samples = samples;
                    view.lights = view.lights.iter().cycle().take(count).cloned().collect();
                    let ([frame, bin, visibility, shade], hash) = time(scene, &view, level);
                    println!(
                        "{name:32} frame {frame:8.2}  bin {bin:6.2}  visibility {visibility:7.2}  \
                         shade {shade:7.2}  {hash:016x}"
                    );
                }
            }
        }
    }
}
