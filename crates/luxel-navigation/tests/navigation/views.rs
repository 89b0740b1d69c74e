//! Standard views, fitting, the ways between, and the knobs of the axes.

use crate::stage::{LENS, before_origin, play, seen, settings, somewhere};
use glam::{DMat3, DMat4, DVec2, DVec3};
use luxel_navigation::{Mode, Number, Settings, StandardView, hit, knobs};
use luxel_scene::Lens;

const VIEWS: [(StandardView, &str); 6] = [
    (StandardView::Front, "front"),
    (StandardView::Back, "back"),
    (StandardView::Right, "right"),
    (StandardView::Left, "left"),
    (StandardView::Top, "top"),
    (StandardView::Bottom, "bottom"),
];

#[test]
fn standard_views_look_at_the_pivot_from_their_side_exactly() {
    let sides = [DVec3::Z, DVec3::NEG_Z, DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y];
    for ((_, name), side) in VIEWS.into_iter().zip(sides) {
        let start = somewhere(Mode::Turntable);
        let (end, _) = play(start, settings(LENS), &format!("view {name}"));
        let back = end.view_from_world().row(2).truncate();
        assert_eq!(back, side, "{name}: not exactly along the axis");
        let distance = start.eye().distance(start.pivot());
        assert!(end.eye().abs_diff_eq(start.pivot() + side * distance, 1e-14), "{name}");
    }
    let up = StandardView::Top.axes(DVec3::Z);
    assert_eq!(up.map(DVec3::round), [DVec3::X, DVec3::Y, DVec3::Z]);
}

#[test]
fn a_pivot_behind_the_eye_comes_before_it() {
    let (end, _) = play(before_origin(Mode::Flying), settings(LENS), "pivot 0 0 8\nview front");
    assert!(end.eye().abs_diff_eq(DVec3::new(0.0, 0.0, 11.0), 1e-14), "{}", end.eye());
}

#[test]
fn the_way_to_a_view_ends_there_to_the_bit_and_is_smooth() {
    let slow = settings(LENS).with(Number::Transition, 0.15);
    for (_, name) in VIEWS {
        let start = somewhere(Mode::Turntable);
        let goal = play(start, settings(LENS), &format!("view {name}")).0;
        let mut state = play(start, slow, &format!("view {name}")).0;
        assert_eq!(state.view_from_world(), start.view_from_world(), "it jumps");
        let mut last = state;
        let mut steps = Vec::new();
        for _ in 0..15 {
            assert!(state.is_moving());
            state = play(state, slow, "+0.01 wait").0;
            let turn = DMat3::from_mat4(state.view_from_world())
                * DMat3::from_mat4(last.view_from_world()).transpose();
            steps.push(((turn.x_axis.x + turn.y_axis.y + turn.z_axis.z - 1.0) / 2.0).acos());
            let distance = state.eye().distance(state.pivot());
            assert!((distance - start.eye().distance(start.pivot())).abs() < 1e-12);
            last = state;
        }
        let state = play(state, slow, "+0.01 wait").0;
        assert_eq!(state.view_from_world(), goal.view_from_world());
        assert!(!state.is_moving());
        let most = steps.iter().copied().fold(0.0, f64::max);
        assert!(steps[0] < most / 3.0 && steps[14] < most / 3.0, "not eased: {steps:?}");
    }
}

#[test]
fn what_moves_the_camera_on_its_way_does_so_from_where_it_goes() {
    let slow = settings(LENS).with(Number::Transition, 0.15);
    let lines = "view top\n+0.05 wait\ntap orbit-right\n+1 wait";
    let moved = play(somewhere(Mode::Turntable), slow, lines).0;
    let expected = play(somewhere(Mode::Turntable), settings(LENS), "view top\ntap orbit-right").0;
    assert_eq!(moved.view_from_world(), expected.view_from_world());
}

/// The window that the corners of the bounds fill, in parts of its size.
fn filled(lines: &str, settings: Settings) -> (DVec2, DVec2) {
    let (end, settings) = play(somewhere(Mode::Turntable), settings, lines);
    let size = DVec2::new(1280.0, 720.0);
    let corners = settings.bounds.corners().map(|corner| seen(&end, &settings, corner) / size);
    corners.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), &corner| {
        (low.min(corner), high.max(corner))
    })
}

#[test]
fn fitting_fills_four_fifths_of_the_window_in_the_same_direction() {
    for lens in [LENS, Lens::Orthographic { height: 0.1 }] {
        for before in ["", "wheel -12 100 100\n", "grab pan 0 0\ndrag 5000 100\nrelease\n"] {
            let (low, high) = filled(&format!("{before}fit"), settings(lens));
            let most = (high - low).max_element();
            assert!((most - 0.8).abs() < 1e-6, "{lens:?}: {most}");
            assert!((low + high).abs_diff_eq(DVec2::ONE, 1e-6), "{lens:?}: not in the middle");
        }
    }
    let start = somewhere(Mode::Turntable);
    let end = play(start, settings(LENS), "fit -2 -1 0 2 1 1").0;
    let rotation = |view: DMat4| DMat3::from_mat4(view);
    assert!(rotation(end.view_from_world()).abs_diff_eq(rotation(start.view_from_world()), 1e-15));
    assert_eq!(end.pivot(), DVec3::new(0.0, 0.0, 0.5));
}

#[test]
fn turntable_and_mouselook_begin_upright_where_they_looked() {
    for mode in ["turntable", "mouselook"] {
        let lines = "tap roll-left 7\ntap pitch-up 2";
        let tilted = play(somewhere(Mode::Flying), settings(LENS), lines).0;
        let level = play(tilted, settings(LENS), &format!("mode {mode}")).0;
        assert!(level.view_from_world().row(0).y.abs() < 1e-15);
        assert!(level.view_from_world().row(1).y > 0.0);
        assert!(level.eye().abs_diff_eq(tilted.eye(), 1e-14));
        let direction = |view: DMat4| view.row(2).truncate();
        let [before, after] = [tilted, level].map(|state| direction(state.view_from_world()));
        assert!(before.abs_diff_eq(after, 1e-15));
    }
}

#[test]
fn look_at_begins_by_looking_at_the_target() {
    let start = play(somewhere(Mode::Flying), settings(LENS), "tap yaw-left 9\nmode look-at").0;
    let target = start.view_from_world().transform_point3(start.pivot());
    assert!(target.truncate().length() < 1e-14 && target.z < 0.0, "{target}");
}

#[test]
fn look_at_passes_over_its_target_without_losing_itself() {
    let lines = "set move-step 1\nview top\nmode look-at\npivot 0 0 0\ntap y+ 2\ntap y- 90";
    let end = play(before_origin(Mode::Turntable), settings(LENS), lines).0;
    assert!(end.view_from_world().is_finite());
    // Eye and target at one place would leave no direction: that step is not made.
    let before = before_origin(Mode::LookAt);
    let end = play(before, settings(LENS), "set move-step 1\ntap z- 5").0;
    assert_eq!(before.view_from_world(), end.view_from_world());
}

#[test]
fn knobs_show_where_the_axes_point_and_can_be_hit() {
    let centre = DVec2::new(1200.0, 80.0);
    let found = knobs(&before_origin(Mode::Turntable).view_from_world(), DVec3::Y, centre, 40.0);
    let at = |axis: DVec3| found.iter().find(|knob| knob.axis == axis).unwrap().at;
    assert_eq!(at(DVec3::X), centre + DVec2::new(40.0, 0.0));
    assert_eq!(at(DVec3::Y), centre + DVec2::new(0.0, -40.0), "y is up in the picture");
    assert_eq!(hit(&found, centre + DVec2::new(38.0, 3.0), 9.0).unwrap().view, StandardView::Right);
    assert_eq!(hit(&found, centre, 9.0).unwrap().view, StandardView::Front, "the nearer one");
    assert_eq!(hit(&found, centre + DVec2::new(25.0, 25.0), 9.0), None);
}
