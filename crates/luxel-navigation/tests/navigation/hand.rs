//! Pan, zoom and inertia follow the pointer.

use crate::stage::{LENS, SIZE, assert_near, play, seen, settings, somewhere};
use glam::{DVec2, DVec3};
use luxel_navigation::{Event, Gesture, Mode, Number, State, advance, parallel_height, with_lens};
use luxel_scene::Lens;
use proptest::prelude::*;

const LENSES: [Lens; 3] = [
    LENS,
    Lens::Orthographic { height: 4.0 },
    Lens::Intrinsics { fx: 900.0, fy: 850.0, cx: 600.0, cy: 400.0 },
];

fn points() -> impl Strategy<Value = DVec3> {
    prop::array::uniform3(-1.0..1.0).prop_map(DVec3::from_array)
}

fn ways() -> impl Strategy<Value = Vec<DVec2>> {
    let way = prop::array::uniform2(-200.0..200.0).prop_map(DVec2::from_array);
    prop::collection::vec(way, 1..20)
}

proptest! {
    #[test]
    fn the_grabbed_point_stays_under_the_pointer(point in points(), ways in ways(), lens in 0..3_usize) {
        let settings = settings(LENSES[lens]);
        let mut state = somewhere(Mode::Turntable);
        let mut at = seen(&state, &settings, point);
        let grab = Event::Grab { gesture: Gesture::Pan, at, point: Some(point) };
        state = advance(&state, &settings, &grab, 0.0);
        let pivot = seen(&state, &settings, state.pivot());
        for way in ways {
            at += way;
            state = advance(&state, &settings, &Event::Drag { at }, 0.0);
            prop_assert!(seen(&state, &settings, point).distance(at) < 1e-6);
        }
        prop_assert!(seen(&state, &settings, state.pivot()).distance(pivot) < 1e-6);
    }

    #[test]
    fn the_wheel_brings_nearer_what_is_under_the_pointer(
        point in points(), notches in -20.0..20.0, lens in 0..3_usize,
    ) {
        let settings = settings(LENSES[lens]);
        let start = somewhere(Mode::Turntable);
        let at = seen(&start, &settings, point);
        let wheel = Event::Wheel { notches, at, point: Some(point) };
        let end = advance(&start, &settings, &wheel, 0.0);
        prop_assert!(seen(&end, &settings, point).distance(at) < 1e-6);
        // By the factor of the wheel, and back to where it was.
        let size = |state: &State| {
            let eye = state.eye().distance(point);
            if lens == 1 { state.scale() } else { eye }
        };
        let factor = 1.2_f64.powf(-notches);
        prop_assert!((size(&end) / size(&start) / factor - 1.0).abs() < 1e-9);
        let back = Event::Wheel { notches: -notches, at, point: Some(point) };
        let back = advance(&end, &settings, &back, 0.0);
        prop_assert!(back.view_from_world().abs_diff_eq(start.view_from_world(), 1e-11));
    }

    #[test]
    fn another_lens_keeps_the_picture_of_the_pivot_s_plane(
        point in points(), from in 0..3_usize, to in 0..3_usize,
    ) {
        let before = settings(LENSES[from]);
        let start = somewhere(Mode::Turntable);
        let view = start.view_from_world();
        let height = parallel_height(&view, start.pivot(), before.lens, SIZE);
        let mut lens = LENSES[to];
        if let Lens::Orthographic { .. } = lens {
            lens = Lens::Orthographic { height };
        }
        // Focal lengths that differ stretch the picture, which no camera can make up for.
        let square = |lens| match lens {
            Lens::Intrinsics { fy, cx, cy, .. } => Lens::Intrinsics { fx: fy, fy, cx, cy },
            lens => lens,
        };
        let before = luxel_navigation::Settings { lens: square(before.lens), ..before };
        let lens = square(lens);
        let after = luxel_navigation::Settings { lens, ..before };
        let other = with_lens(&view, start.pivot(), before.lens, lens, SIZE);
        let other = State::new(Mode::Turntable, &other, start.pivot());
        // Brought into the plane through the pivot.
        let in_view = view.transform_point3(point);
        let depth = view.transform_point3(start.pivot()).z;
        let point = view.inverse().transform_point3(in_view.with_z(depth));
        let off = seen(&start, &before, point).distance(seen(&other, &after, point));
        prop_assert!(off < 1e-6, "{}", off);
        prop_assert_eq!(other.view_from_world().row(0).truncate(), view.row(0).truncate());
    }
}

#[test]
fn the_pivot_is_never_passed_by_zooming() {
    let settings = settings(LENS);
    let mut state = somewhere(Mode::Turntable);
    let behind = DVec3::new(-1.0, -1.0, -1.0);
    for _ in 0..100 {
        let at = seen(&state, &settings, behind);
        let wheel = Event::Wheel { notches: 1.0, at, point: Some(behind) };
        state = advance(&state, &settings, &wheel, 0.0);
        assert!(state.view_from_world().transform_point3(state.pivot()).z < 0.0);
    }
    assert!(state.eye().distance(behind) < 1e-5, "zooming ends early");
}

#[test]
fn inertia_covers_the_distance_of_its_formula() {
    let settings = settings(LENS).with(Number::Inertia, 0.5).with(Number::BallRadius, 100.0);
    let mut state = crate::stage::before_origin(Mode::RollingBall);
    let mut at = DVec2::new(100.0, 100.0);
    let grab = Event::Grab { gesture: Gesture::Turn, at, point: None };
    state = advance(&state, &settings, &grab, 0.0);
    // A second at a steady 200 pixels a second.
    for _ in 0..100 {
        at.x += 2.0;
        state = advance(&state, &settings, &Event::Drag { at }, 0.01);
    }
    state = advance(&state, &settings, &Event::Release, 0.0);
    let angle = |state: &State| state.eye().x.atan2(state.eye().z);
    let at_first = angle(&state);
    let mut cut = state;
    for _ in 0..10 {
        cut = advance(&cut, &settings, &Event::Wait, 0.05);
    }
    state = advance(&state, &settings, &Event::Wait, 0.5);
    assert_near(&cut.view_from_world(), &state.view_from_world(), 1e-13);
    // 200 * 0.5 * (1 - 1 / e) pixels over a radius of 100.
    let expected = 1.0 - f64::exp(-1.0);
    assert!((at_first - angle(&state) - expected).abs() < 1e-9, "{}", at_first - angle(&state));
    let end = play(state, settings, "+100 wait").0;
    assert!(!end.is_moving());
}

#[test]
fn without_inertia_nothing_goes_on() {
    let state = play(
        somewhere(Mode::RollingBall),
        settings(LENS),
        "grab turn 0 0\n+0.01 drag 50 0\n+0.01 drag 90 0\nrelease",
    );
    assert!(!state.0.is_moving());
    let later = play(state.0, state.1, "+1 wait").0;
    assert_eq!(state.0.view_from_world(), later.view_from_world());
}

#[test]
fn a_hand_that_rests_before_it_lets_go_throws_nothing() {
    let settings = settings(LENS).with(Number::Inertia, 0.5);
    let lines = "grab turn 0 0\n+0.01 drag 50 0\n+0.01 drag 90 0\n+1 release";
    assert!(!play(somewhere(Mode::RollingBall), settings, lines).0.is_moving());
}
