//! The same picture, drawn in other ways: levels, threads, orders, clusterings.

use crate::random::{cases, scene};
use crate::scene::{Picture, Scene, best, no_holes};
use crate::solid::{View, bumpy, direction};
use glam::{DMat4, DVec3};
use luxel_math::SimdLevel;
use luxel_scene::{Lens, MaterialId, Mesh, Part};
use luxel_visibility::{Coverage, CullFaces, PartUse, Region};
use proptest::prelude::*;

const ALL: &[Coverage] = &[Coverage::Opaque, Coverage::Cutout, Coverage::Blended];

/// Depths by their bits.
fn bits(picture: &Picture) -> Vec<Option<(u32, (usize, u32))>> {
    picture.seen.iter().map(|seen| seen.map(|(depth, of)| (depth.to_bits(), of))).collect()
}

/// Views that need clipping and views that don't, with triangles of all sizes.
fn view() -> impl Strategy<Value = View> {
    let lens = prop_oneof![
        (0.1..2.5).prop_map(|fov_y_radians| Lens::Perspective { fov_y_radians }),
        (1.0..8.0).prop_map(|height| Lens::Orthographic { height }),
        (20.0..200.0, -50.0..150.0).prop_map(|(f, c)| Lens::Intrinsics {
            fx: f,
            fy: 1.3 * f,
            cx: c,
            cy: 40.0
        }),
    ];
    let samples = prop::sample::select(vec![1, 2, 4]);
    (direction(), direction(), 0.0..4.0, lens, samples, 2..9_u32).prop_map(
        |(place, towards, reach, lens, samples, frequency)| {
            let eye = place * reach;
            let mesh = with_walls(bumpy(frequency));
            View { samples, ..View::look(mesh, eye, eye + towards, lens, [1e-3, 50.0]) }
        },
    )
}

/// Large triangles around and across: they reach the near plane and the guard band.
fn with_walls(mut mesh: Mesh) -> Mesh {
    let room = luxel_scene::primitives::cuboid(DVec3::new(9.0, 7.0, 8.0));
    let first = mesh.positions.len() as u32;
    mesh.positions.extend(&room.positions);
    mesh.triangles.extend(room.triangles.iter().map(|t| t.map(|corner| corner + first)));
    let sheet = mesh.positions.len() as u32;
    mesh.positions.extend([[-9.0, 0.3, 4e3], [7.0, 0.1, 4e3], [0.5, -0.2, -4e3]]);
    mesh.triangles.push([sheet, sheet + 1, sheet + 2]);
    let count = mesh.triangles.len() as u32;
    mesh.parts = vec![Part { first: 0, count, ..mesh.parts[0] }];
    mesh.normals.clear();
    mesh.attribute_corners = None;
    mesh
}

/// Solids whose back faces are left out, some flattened to slivers, from near and far.
fn one_sided() -> impl Strategy<Value = View> {
    let flat = prop::sample::select(vec![1.0_f32, 0.01, 1e-4]);
    let cull = prop::sample::select(vec![CullFaces::Clockwise, CullFaces::CounterClockwise]);
    let mirrored = prop::sample::select(vec![1.0, -1.0]);
    let samples = prop::sample::select(vec![1, 4]);
    let lens = prop_oneof![
        (0.3..2.0).prop_map(|fov_y_radians| Lens::Perspective { fov_y_radians }),
        (1.0..8.0).prop_map(|height| Lens::Orthographic { height }),
    ];
    let camera = (direction(), 1.1..6.0, lens, samples);
    (camera, 3..16_u32, flat, cull, mirrored, 0.5..3.0).prop_map(
        |((place, reach, lens, samples), frequency, flat, cull, mirrored, scale)| {
            let mut mesh = bumpy(frequency);
            for [_, y, _] in &mut mesh.positions {
                *y *= flat;
            }
            let eye = place * reach * scale;
            let view = View::look(mesh, eye, DVec3::new(0.1, 0.2, 0.0), lens, [0.05, 50.0]);
            let scale = DVec3::new(scale * mirrored, scale, scale);
            let view_from_mesh = view.view_from_mesh * DMat4::from_scale(scale);
            View { view_from_mesh, samples, part: PartUse { cull, ..view.part }, ..view }
        },
    )
}

/// A sheet of triangles longer than the window and narrower than a step of its grid, seen from behind:
/// snapping turns many of them over.
fn strips() -> impl Strategy<Value = View> {
    let lens = prop_oneof![
        Just(Lens::Perspective { fov_y_radians: 0.9 }),
        Just(Lens::Orthographic { height: 2.0 }),
    ];
    (lens, 0.03..1.0, 0.0..6.3, -4.0..-1.0, prop::sample::select(vec![1, 4])).prop_map(
        |(lens, cosine, roll, narrow, samples)| {
            let mut mesh = Mesh::default();
            for number in 0..100_u32 {
                let (y, height) = (f64::from(number) * 0.01 - 0.5, libm::exp10(narrow));
                for [x, y] in [[-2.0, y], [2.0, y], [0.1, y + height]] {
                    mesh.positions.push([x as f32, y as f32, 0.0]);
                }
                mesh.triangles.push([0, 1, 2].map(|corner| 3 * number + corner));
            }
            mesh.parts = vec![Part { first: 0, count: 100, material: MaterialId(0) }];
            // The front is +Z: turned about the long sides until the back is seen.
            let behind = DMat4::from_rotation_x(std::f64::consts::FRAC_PI_2 + libm::asin(cosine));
            let turned = DMat4::from_rotation_z(roll) * behind;
            let view = View::look(mesh, DVec3::Z * 2.0, DVec3::ZERO, lens, [0.1, 10.0]);
            let part = PartUse { cull: CullFaces::Clockwise, ..view.part };
            View { view_from_mesh: view.view_from_mesh * turned, samples, part, ..view }
        },
    )
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn no_cluster_is_left_out_of_which_snapping_turns_a_face_over(view in strips()) {
        prop_assert_eq!(bits(&view.draw_one_by_one()), bits(&view.draw(best())));
    }

    #[test]
    fn no_cluster_is_left_out_of_which_a_face_would_be_seen(view in one_sided()) {
        prop_assert_eq!(bits(&view.draw_one_by_one()), bits(&view.draw(best())));
    }

    #[test]
    fn every_level_draws_the_same_bits(scene in scene(ALL, 60)) {
        let draw = |level: SimdLevel| {
            let (built, level) = (scene.build(), level.resolve().unwrap());
            let frame = built.frame(level);
            let layers = Picture::layers(&frame, level, &no_holes);
            let opaque = bits(&Picture::opaque(&frame, level));
            (opaque, layers.iter().map(bits).collect::<Vec<_>>())
        };
        let expected = draw(SimdLevel::Scalar);
        for level in SimdLevel::available() {
            prop_assert_eq!(&draw(level), &expected, "{}", level);
        }
    }

    #[test]
    fn every_level_clips_and_culls_to_the_same_bits(view in view()) {
        let draw = |level: SimdLevel| bits(&view.draw(level.resolve().unwrap()));
        let expected = draw(SimdLevel::Scalar);
        for level in SimdLevel::available() {
            prop_assert_eq!(&draw(level), &expected, "{}", level);
        }
    }

    #[test]
    fn a_part_of_the_window_is_drawn_as_in_the_whole(
        view in view(),
        corner in [-9..101_i32, -9..79_i32],
        size in [1..60_i32, 1..60_i32],
    ) {
        let [x, y] = corner.map(|side| side.max(0));
        let part = Region { x, y, width: size[0], height: size[1] };
        let whole = view.draw(best());
        let drawn = view.draw_part(part, best());
        let count = view.samples as usize;
        let width = view.size.width as usize;
        for row in y..(y + part.height).min(79) {
            for column in x..(x + part.width).min(101) {
                let first = (row as usize * width + column as usize) * count;
                let of = |picture: &Picture| Picture { seen: picture.seen[first..first + count].to_vec() };
                prop_assert_eq!(bits(&of(&drawn)), bits(&of(&whole)), "{}, {}", column, row);
            }
        }
    }

    #[test]
    fn every_number_of_threads_draws_the_same_bits(view in view(), scene in scene(ALL, 200)) {
        let draw = || (bits(&view.draw(best())), bits(&scene.build().draw(best())));
        let expected = draw();
        for threads in [1, 2, 7] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            prop_assert_eq!(&pool.install(draw), &expected, "{} threads", threads);
        }
    }

    #[test]
    fn triangles_drawn_one_by_one_make_the_same_picture(view in view()) {
        // Neither what a cluster hides nor its neighbours in it may matter.
        prop_assert_eq!(bits(&view.draw_one_by_one()), bits(&view.draw(best())));
    }

    #[test]
    fn another_order_of_triangles_shows_the_same_ones(view in view(), step in 1..1000_usize) {
        let count = view.mesh.triangles.len();
        // A step that shares no factor with the count visits every triangle.
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by_key(|&number| (number.wrapping_mul(2 * step + 1) % 257, number));
        let mut shuffled = view.clone();
        shuffled.mesh.triangles = order.iter().map(|&number| view.mesh.triangles[number]).collect();
        let (expected, seen) = (view.draw(best()), shuffled.draw(best()));
        for (expected, seen) in expected.seen.iter().zip(&seen.seen) {
            let seen = seen.map(|(depth, (_, number))| (depth, order[number as usize] as u32));
            let expected = expected.map(|(depth, (_, number))| (depth, number));
            // Of equally near ones another may come first now.
            let tie = seen.zip(expected).is_some_and(|(a, b)| a.0.to_bits() == b.0.to_bits());
            prop_assert!(seen == expected || tie, "{:?} instead of {:?}", seen, expected);
        }
    }
}

#[test]
fn a_crowd_of_triangles_one_by_one_shows_the_same_ties() {
    // Equal depths in many instances, of which the first must win whatever is near.
    let mut runner = proptest::test_runner::TestRunner::new(cases(40));
    let sheets = scene(&[Coverage::Opaque], 120);
    runner
        .run(&sheets, |mut scene: Scene| {
            let mut apart = scene.clone();
            apart.instances.clear();
            scene.instances.truncate(1);
            for &triangle in &scene.instances[0].triangles {
                let placed = crate::scene::Placed {
                    triangles: vec![triangle],
                    ..scene.instances[0].clone()
                };
                apart.instances.push(placed);
            }
            let together = scene.build().draw(best());
            let apart = apart.build().draw(best());
            for (together, apart) in together.seen.iter().zip(&apart.seen) {
                let apart = apart.map(|(depth, (instance, _))| (depth, (0, instance as u32)));
                prop_assert_eq!(*together, apart);
            }
            Ok(())
        })
        .unwrap();
}
