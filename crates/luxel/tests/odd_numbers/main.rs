//! Files of odd numbers: denormal, huge and almost equal ones in every attribute, with every filter, wrap and transform of
//! textures. A file is refused with an error, or drawn with the same bytes however it is run.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod file;
mod random;

use luxel::Settings;
use luxel::formats::{Format, Limits, read};
use luxel::math::SimdLevel;
use luxel::pick::{PhysicalPosition, PickView, Picker};
use luxel::render::{Execution, Renderer};
use luxel::scene::{Scene, Size};
use random::Random;
use std::sync::Arc;

/// How many files are read.
const FILES: u64 = 400;

#[test]
fn files_of_odd_numbers_are_refused_or_have_the_same_bytes_however_they_are_run() {
    let drawn = (1..=FILES).filter(|&number| {
        scene_of(number).is_some_and(|(scene, mut random)| check(number, scene, &mut random))
    });
    let drawn = drawn.count();
    assert!(drawn as u64 > FILES / 2, "{drawn} of {FILES} are drawn");
}

#[test]
fn corners_that_are_not_finite_leave_the_same_bytes_however_they_are_run() {
    let mut drawn = 0;
    for number in 1..=FILES / 4 {
        let Some((mut scene, mut random)) = scene_of(number) else { continue };
        for mesh in 0..scene.meshes.len() {
            let numbers = scene.meshes[mesh].positions.as_flattened_mut();
            for _ in 0..3 {
                let place = random.next() as usize % numbers.len();
                numbers[place] = random.one_of(&[f32::NAN, f32::INFINITY, f32::NEG_INFINITY]);
            }
        }
        drawn += usize::from(check(number, scene, &mut random));
    }
    assert!(drawn as u64 > FILES / 16, "{drawn} of {} are drawn", FILES / 4);
}

/// The scene of a file of odd numbers, and what further choices come from; `None` where it is refused.
fn scene_of(number: u64) -> Option<(Scene, Random)> {
    let mut random = Random(number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let bytes = file::glb(&mut random);
    let loaded = read(&bytes, Format::Glb, "odd", None, &Limits::default()).ok()?;
    Some((loaded.scene, random))
}

/// Draws, explains and picks a scene in all ways that have to agree; whether there was something to see.
fn check(number: u64, scene: Scene, random: &mut Random) -> bool {
    let scene = Arc::new(scene);
    let settings = [
        ("size", random.one_of(&["33x21", "16x16", "5x3"])),
        ("samples", random.one_of(&["1", "4"])),
        ("shading", random.one_of(&["flat", "gouraud", "phong", "subdivided"])),
    ];
    // What has no extent can't be seen.
    let Ok(view) = Settings::new(settings).unwrap().view(&scene) else { return false };
    let view = view.with_shadows(random.is_in_percent(30));
    let Size { width, height } = view.size;
    let mut first = None;
    for (threads, simd) in [1, 3, 2].into_iter().cycle().zip(SimdLevel::available()) {
        let execution = Execution { threads, simd, ..Execution::default() };
        let renderer = Renderer::new(Arc::clone(&scene), &execution).unwrap();
        let picture = renderer.rgba8(&view).unwrap().pixels;
        let places = [[0, 0], [width / 2, height / 2], [width / 3, height - 1]];
        for explained in renderer.explain_pixels(&view, &places).unwrap() {
            let [x, y] = explained.pixel;
            let shown = picture[(y * width + x) as usize];
            assert_eq!(explained.rgba8, shown, "file {number}, {simd}: {x}, {y}");
        }
        let first = first.get_or_insert_with(|| picture.clone());
        assert!(*first == picture, "file {number} differs at {simd}, {threads} threads");
    }
    let picker = Picker::new(Arc::clone(&scene)).unwrap();
    let picks = PickView::new(&picker, view.camera, view.size, view.cull).unwrap();
    let hits = picks.through(PhysicalPosition::centre_of(width / 2, height / 2));
    let distances: Vec<_> = hits.iter().map(|hit| hit.distance).collect();
    // Triangles of 1e-18 units have volumes below what f32 holds.
    let is_measurable = (1e-14..1e14).contains(&scene.bounds().radius());
    // The first is the one that is shown, by depths rounded to f32.
    let in_order = distances.is_sorted_by(|near, far| *near <= far * 1.0001);
    assert!(in_order || !is_measurable, "file {number}: {distances:?}");
    true
}
