//! Guarantees of all modes.

use crate::stage::{
    LENS, MODES, assert_near, before_origin, deviation, play, pulled, settings, somewhere,
};
use glam::{DMat3, DMat4, DVec2, DVec3};
use luxel_navigation::{Event, Gesture, Mode, Number, State, advance};

#[test]
fn a_million_increments_leave_a_rotation() {
    for mode in MODES {
        let settings = settings(LENS);
        let mut state = somewhere(mode);
        let mut at = DVec2::ZERO;
        let grab = Event::Grab { gesture: Gesture::Turn, at, point: None };
        state = advance(&state, &settings, &grab, 0.0);
        for step in 0..1_000_000_u32 {
            // Ways of all directions that never come back to where they were.
            let angle = f64::from(step) * 0.7;
            at += DVec2::new(angle.cos() + 0.1, angle.sin() * 0.8) * 3.0;
            state = advance(&state, &settings, &Event::Drag { at }, 0.0);
        }
        assert!(deviation(&state) < 4e-16 * 4.0, "{mode}: {:e}", deviation(&state));
    }
}

#[test]
fn gestures_undo_exactly() {
    for mode in MODES {
        let settings = settings(LENS);
        let start = somewhere(mode);
        for gesture in [Gesture::Turn, Gesture::Pan, Gesture::Zoom] {
            // Short of the poles, where turning up stops.
            let ways = [DVec2::new(150.0, 0.0), DVec2::new(0.0, 40.0), DVec2::new(-20.0, -10.0)];
            let back: Vec<_> = ways.iter().rev().map(|way| -way).collect();
            let there = pulled(start, &settings, gesture, &ways);
            assert!(!there.view_from_world().abs_diff_eq(start.view_from_world(), 1e-3));
            let again = pulled(start, &settings, gesture, &[&ways[..], &back].concat());
            assert_near(&again.view_from_world(), &start.view_from_world(), 1e-13);
            assert!(again.pivot().abs_diff_eq(start.pivot(), 1e-13), "{mode} {gesture}");
        }
    }
}

#[test]
fn commands_undo_exactly() {
    for (mode, commands) in [
        (Mode::Absolute, &["x+ x-", "y- y+", "z+ z-", "turn-x+ turn-x-", "turn-z- turn-z+"][..]),
        (Mode::LookAt, &["x+ x-", "y- y+", "target-z+ target-z-", "target-x- target-x+"]),
        (Mode::RollingBall, &["orbit-left orbit-right", "orbit-up orbit-down", "left right"]),
        (Mode::Flying, &["pitch-up pitch-down", "roll-left roll-right", "forward back"]),
        (Mode::Mouselook, &["yaw-left yaw-right", "pitch-down pitch-up", "up down"]),
        (Mode::Turntable, &["orbit-left orbit-right", "orbit-up orbit-down", "forward back"]),
    ] {
        for pair in commands {
            let (one, other) = pair.split_once(' ').unwrap();
            let start = somewhere(mode);
            let there = play(start, settings(LENS), &format!("tap {one} 3")).0;
            assert_ne!(there.view_from_world(), start.view_from_world(), "{mode}: {one}");
            let lines = format!("press {one}\n+0.75 lift {one}\npress {other}\n+0.75 lift {other}");
            let held = play(start, settings(LENS), &lines).0;
            assert_near(&held.view_from_world(), &start.view_from_world(), 1e-14);
            let tapped = play(there, settings(LENS), &format!("tap {other} 3")).0;
            assert_near(&tapped.view_from_world(), &start.view_from_world(), 1e-14);
        }
    }
}

#[test]
fn nothing_flips_at_the_poles() {
    // Up and over, in small steps: each picture is next to the one before.
    for mode in [Mode::Turntable, Mode::Mouselook, Mode::RollingBall, Mode::Flying] {
        for down in [1.0, -1.0] {
            let settings = settings(LENS);
            let mut state = somewhere(mode);
            for _ in 0..2000 {
                let way = [DVec2::new(0.01, down)];
                let next = pulled(state, &settings, Gesture::Turn, &way);
                let turn = DMat3::from_mat4(next.view_from_world())
                    * DMat3::from_mat4(state.view_from_world()).transpose();
                let angle = ((turn.x_axis.x + turn.y_axis.y + turn.z_axis.z - 1.0) / 2.0).min(1.0);
                assert!(angle.acos() < 0.005, "{mode}: {angle}");
                state = next;
            }
        }
    }
}

#[test]
fn at_the_pole_of_the_turntable_the_scene_still_turns_and_one_comes_back_level() {
    let settings = settings(LENS).with(Number::BallRadius, 100.0);
    let start = before_origin(Mode::Turntable);
    let above = pulled(start, &settings, Gesture::Turn, &[DVec2::new(0.0, 5000.0)]);
    assert!(above.eye().abs_diff_eq(DVec3::new(0.0, 5.0, 0.0), 1e-14), "{}", above.eye());
    let turned = pulled(above, &settings, Gesture::Turn, &[DVec2::new(80.0, 0.0)]);
    assert!(turned.eye().abs_diff_eq(above.eye(), 1e-14));
    let down = pulled(turned, &settings, Gesture::Turn, &[DVec2::new(0.0, -100.0)]);
    let around = 0.8;
    let expected = DVec3::new(-f64::sin(around), 0.0, f64::cos(around)) * f64::sin(1.0)
        + DVec3::Y * f64::cos(1.0);
    assert!(down.eye().abs_diff_eq(expected * 5.0, 1e-13), "{} {expected}", down.eye());
    assert!(down.view_from_world().row(0).y.abs() < 1e-15, "the horizon is tilted");
}

#[test]
fn the_horizon_stays_level() {
    for mode in [Mode::Turntable, Mode::Mouselook] {
        let ways: Vec<_> =
            (0..500).map(|step| DVec2::from_angle(f64::from(step)) * f64::from(step)).collect();
        let end = pulled(somewhere(mode), &settings(LENS), Gesture::Turn, &ways);
        assert!(end.view_from_world().row(0).y.abs() < 1e-13, "{mode}");
        assert!(end.view_from_world().row(1).y >= 0.0, "{mode}: upside down");
    }
}

#[test]
fn the_same_events_give_the_same_bits() {
    let lines = "+0.01 grab turn 100 200\n+0.016 drag 140 190\n+0.016 drag 170 150\nrelease\n\
                 +0.1 wait\npress forward\npress yaw-left\n+0.3 lift forward\n+0.7 view right\n\
                 +0.05 wheel 2 300 100\n+0.01 fit\n+0.3 wait";
    for mode in MODES {
        let settings = settings(LENS).with(Number::Inertia, 0.3).with(Number::Transition, 0.15);
        let once = play(somewhere(mode), settings, lines).0;
        let again = play(somewhere(mode), settings, lines).0;
        assert_eq!(
            once.view_from_world().to_cols_array().map(f64::to_bits),
            again.view_from_world().to_cols_array().map(f64::to_bits)
        );
    }
}

#[test]
fn a_camera_at_rest_keeps_its_bits() {
    for mode in MODES {
        let start = somewhere(mode);
        let (end, _) = play(
            start,
            settings(LENS),
            "+1 wait\ngrab turn 10 10\ndrag 10 10\nrelease\n+2 wait\nlevel\ndrag 90 90\npivot 1 2 3",
        );
        assert_eq!(start.view_from_world(), end.view_from_world(), "{mode}");
    }
}

#[test]
fn motion_does_not_depend_on_how_time_is_cut() {
    for (mode, held) in [
        (Mode::Flying, "press yaw-left\npress pitch-up\npress roll-right"),
        (Mode::Mouselook, "press forward\npress yaw-right"),
        (Mode::Turntable, "press orbit-left"),
        (Mode::RollingBall, "press orbit-left\npress orbit-up"),
        (Mode::Absolute, "press x+\npress y-"),
    ] {
        let start = play(somewhere(mode), settings(LENS), "tap faster 3").0;
        let once = play(start, settings(LENS), &format!("{held}\n+1 wait")).0;
        let cut = format!("{held}\n{}", "+0.0625 wait\n".repeat(16));
        let often = play(start, settings(LENS), &cut).0;
        assert_near(&often.view_from_world(), &once.view_from_world(), 1e-13);
    }
}

#[test]
fn numbers_that_are_none_have_no_effect() {
    let settings = settings(LENS);
    let start = somewhere(Mode::Turntable);
    let grab = Event::Grab { gesture: Gesture::Turn, at: DVec2::ZERO, point: None };
    let held = advance(&start, &settings, &grab, 0.0);
    for at in [DVec2::NAN, DVec2::INFINITY, DVec2::splat(1e308) * DVec2::new(1.0, -10.0)] {
        let after = advance(&held, &settings, &Event::Drag { at }, 0.0);
        assert_eq!(after.view_from_world(), start.view_from_world());
    }
    for seconds in [f64::NAN, f64::INFINITY, -1.0] {
        let moving = play(start, settings, "press orbit-left").0;
        let after = advance(&moving, &settings, &Event::Wait, seconds);
        assert_eq!(after.view_from_world(), start.view_from_world());
    }
    let wild = Event::Wheel { notches: -1e300, at: DVec2::ZERO, point: None };
    let after = advance(&start, &settings, &wild, 0.0);
    assert!(after.view_from_world().is_finite());
    let far =
        State::new(Mode::Turntable, &DMat4::from_translation(DVec3::splat(1e308)), DVec3::ZERO);
    let after = pulled(far, &settings, Gesture::Turn, &[DVec2::new(100.0, 7.0)]);
    assert!(after.view_from_world().is_finite());
}
