//! Between world and window, against the formulas of GLU's manual and against the fill rule's rays.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_pick::{Viewport, flip_y, pick_matrix, project, unproject, unproject4, window_ray};
use luxel_scene::{Camera, DMat4, DVec2, DVec3, DVec4, Lens, Projection, Size};
use proptest::prelude::*;

const SIZE: Size = Size { width: 640, height: 480 };

fn lens() -> impl Strategy<Value = Lens> {
    prop_oneof![
        (0.1..2.5).prop_map(|fov_y_radians| Lens::Perspective { fov_y_radians }),
        (0.1..50.0).prop_map(|height| Lens::Orthographic { height }),
        (100.0..900.0, 100.0..900.0, -100.0..700.0, -50.0..600.0)
            .prop_map(|(fx, fy, cx, cy)| Lens::Intrinsics { fx, fy, cx, cy }),
    ]
}

fn camera() -> impl Strategy<Value = Camera> {
    let place = || prop::array::uniform3(-20.0..20.0).prop_map(DVec3::from_array);
    (place(), place(), lens(), 0.01..2.0, prop::bool::ANY).prop_map(
        |(eye, target, lens, near, endless)| {
            let parallel = matches!(lens, Lens::Orthographic { .. });
            let far = if endless && !parallel { f64::INFINITY } else { near + 80.0 };
            let view_from_world = Camera::look_at(eye, target, DVec3::Y);
            Camera { view_from_world, projection: Projection { lens, near, far } }
        },
    )
}

proptest! {
    #[test]
    fn unprojecting_leads_back_to_where_projecting_came_from(
        camera in camera(), x in 0.0..640.0, y in 0.0..480.0, distance in 0.05..0.95,
    ) {
        let clip_from_view = camera.projection.clip_from_view(SIZE);
        let viewport = Viewport::of(SIZE);
        let line = window_ray(&camera, SIZE, [x, y]);
        let [near, far] = line.range;
        let along = near + (far.min(near + 50.0) - near) * distance;
        let place = line.origin + line.direction * along;
        let window = project(place, &camera.view_from_world, &clip_from_view, viewport).unwrap();
        prop_assert!((window.x - x).abs() < 1e-6 && (flip_y(window.y, 480.0) - y).abs() < 1e-6);
        prop_assert!((0.0..=1.0).contains(&window.z));
        let back = unproject(window, &camera.view_from_world, &clip_from_view, viewport).unwrap();
        prop_assert!(back.distance(place) < 1e-4 * (1.0 + along * along), "{} {}", back, place);
        let w = 2.5;
        let four = unproject4(
            (window * 1.0).extend(1.0), &camera.view_from_world, &clip_from_view, viewport, [0.0, 1.0],
        ).unwrap();
        prop_assert!((four.truncate() / four.w).abs_diff_eq(back, 1e-9 * (1.0 + back.length())));
        // Homogeneous: scaling clip coordinates scales the outcome.
        let inverse = (clip_from_view * camera.view_from_world).inverse();
        let ndc = DVec3::new(window.x / 320.0 - 1.0, window.y / 240.0 - 1.0, window.z * 2.0 - 1.0);
        let by_hand = inverse * ndc.extend(w);
        let told = unproject4(
            DVec4::new(window.x, window.y, window.z, w),
            &camera.view_from_world, &clip_from_view, viewport, [0.0, 1.0],
        ).unwrap();
        prop_assert!(told.abs_diff_eq(by_hand, 1e-9 * (1.0 + by_hand.abs().max_element())));
    }

    #[test]
    fn a_pick_matrix_maps_the_rectangle_onto_the_clip_volume(
        centre in [0.0..640.0, 0.0..480.0], size in [0.5..50.0, 0.5..50.0],
        corner in [-40.0..40.0, -40.0..40.0],
    ) {
        let viewport =
            Viewport { x: corner[0], y: corner[1], width: 640.0, height: 480.0 };
        let (centre, size) = (DVec2::from_array(centre), DVec2::from_array(size));
        let pick = pick_matrix(centre, size, viewport).unwrap();
        for sign in [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0)] {
            let place = centre + size * 0.5 * sign;
            let ndc = DVec2::new(
                (place.x - viewport.x) / 320.0 - 1.0, (place.y - viewport.y) / 240.0 - 1.0,
            );
            let clip = pick * DVec4::new(ndc.x, ndc.y, 0.3, 1.0);
            prop_assert!(clip.truncate().truncate().abs_diff_eq(sign, 1e-9));
            prop_assert_eq!((clip.z, clip.w), (0.3, 1.0));
        }
    }
}

#[test]
fn what_has_no_answer_has_none() {
    let viewport = Viewport::of(SIZE);
    assert_eq!(pick_matrix(DVec2::ZERO, DVec2::new(0.0, 1.0), viewport), None);
    let flat = DMat4::from_scale(DVec3::new(1.0, 0.0, 1.0));
    assert_eq!(unproject(DVec3::ZERO, &flat, &DMat4::IDENTITY, viewport), None);
    let lens = Lens::Perspective { fov_y_radians: 1.0 };
    let clip = Projection { lens, near: 0.1, far: 1.0 }.clip_from_view(SIZE);
    assert_eq!(project(DVec3::X, &DMat4::IDENTITY, &clip, viewport), None);
    let endless = Projection { lens, near: 0.1, far: f64::INFINITY }.clip_from_view(SIZE);
    let at_infinity = DVec4::new(320.0, 240.0, 1.0, 1.0);
    let four = unproject4(at_infinity, &DMat4::IDENTITY, &endless, viewport, [0.0, 1.0]).unwrap();
    assert!(four.w.abs() < 1e-12 && four.z < 0.0, "{four}");
}
