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
use luxel::scene::Size;
use random::Random;
use std::sync::Arc;

/// How many files are read.
const FILES: u64 = 400;

#[test]
fn files_of_odd_numbers_are_refused_or_have_the_same_bytes_however_they_are_run() {
    let mut drawn = 0;
    for number in 1..=FILES {
        let mut random = Random(number.wrapping_mul(0x9e37_79b9_7f4a_7c15));
        let bytes = file::glb(&mut random);
        let Ok(loaded) = read(&bytes, Format::Glb, "odd", None, &Limits::default()) else {
            continue;
        };
        let scene = Arc::new(loaded.scene);
        let settings = [
            ("size", random.one_of(&["33x21", "16x16", "5x3"])),
            ("samples", random.one_of(&["1", "4"])),
            ("shading", random.one_of(&["flat", "gouraud", "phong", "subdivided"])),
        ];
        // What has no extent can't be seen.
        let Ok(view) = Settings::new(settings).unwrap().view(&scene) else { continue };
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
        drawn += 1;
    }
    assert!(drawn > FILES / 2, "{drawn} of {FILES} are drawn");
}
