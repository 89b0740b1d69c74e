//! The rolling ball against known theorems.

use crate::stage::{LENS, assert_near, before_origin, pulled, settings, somewhere};
use glam::{DMat3, DMat4, DVec2, DVec3};
use luxel_navigation::{Gesture, Mode, Number, State};
use std::f64::consts::TAU;

const RADIUS: f64 = 250.0;

/// The hand goes around a circle, in window pixels, against the clock as one sees it.
fn circle(radius: f64, parts: u32) -> Vec<DVec2> {
    let at = |part: u32| {
        let angle = TAU * f64::from(part) / f64::from(parts);
        DVec2::new(angle.cos(), -angle.sin()) * radius
    };
    (0..parts).map(|part| at(part + 1) - at(part)).collect()
}

/// The turn of the scene in camera coordinates that a hand's way has made.
fn turned(ways: &[DVec2]) -> DMat3 {
    let settings = settings(LENS).with(Number::BallRadius, RADIUS);
    let start = somewhere(Mode::RollingBall);
    let end = pulled(start, &settings, Gesture::Turn, ways);
    let rotation = |state: &State| DMat3::from_mat4(state.view_from_world());
    rotation(&end) * rotation(&start).transpose()
}

#[test]
fn a_closed_loop_turns_about_the_view_axis_by_its_area_over_the_squared_radius_the_other_way() {
    for (hand, parts) in [(5.0, 4000), (10.0, 4000), (20.0, 4000)] {
        let turn = turned(&circle(hand, parts));
        // By the right-hand rule about the axis towards the eye, so against the clock.
        let angle = turn.x_axis.y.atan2(turn.x_axis.x);
        let expected = -TAU / 2.0 * hand * hand / (RADIUS * RADIUS);
        // What the next order leaves is (hand / RADIUS)^4.
        assert!((angle - expected).abs() < 3.0 * (hand / RADIUS).powi(4), "{angle} {expected}");
        assert!(angle < 0.0, "it turns with the hand");
    }
}

#[test]
fn a_small_square_turns_as_a_circle_of_its_area_does() {
    let side = 4.0;
    let to = |x: f64, y: f64| DVec2::new(x, y) * side;
    // To the right, up, to the left, down: against the clock.
    let turn = turned(&[to(1.0, 0.0), to(0.0, -1.0), to(-1.0, 0.0), to(0.0, 1.0)]);
    let angle = turn.x_axis.y.atan2(turn.x_axis.x);
    let expected = -(side / RADIUS).powi(2);
    assert!((angle - expected).abs() < (side / RADIUS).powi(3), "{angle} {expected}");
}

#[test]
fn a_circle_of_any_size_turns_as_a_ball_on_a_plane_does() {
    // In axes that go round with the hand, the ball turns steadily: by -(rho / r) about x (the hand
    // is at (rho, 0) and moves along y) and, seen from those axes, by -1 about z. After once around
    // that is the turn by 2 pi sqrt(1 + rho^2 / r^2) about (-rho / r, 0, -1).
    for hand in [30.0, 250.0, 1000.0] {
        let found = turned(&circle(hand, 40_000));
        let axis = DVec3::new(-hand / RADIUS, 0.0, -1.0);
        let expected = DMat3::from_axis_angle(axis.normalize(), TAU * axis.length());
        assert!(found.abs_diff_eq(expected, 1e-6), "{hand}: {found} {expected}");
    }
}

#[test]
fn a_straight_way_turns_the_same_in_however_many_parts() {
    let settings = settings(LENS);
    let start = before_origin(Mode::RollingBall);
    let way = DVec2::new(300.0, -170.0);
    let once = pulled(start, &settings, Gesture::Turn, &[way]);
    let often = pulled(start, &settings, Gesture::Turn, &[way / 64.0; 64]);
    assert_near(&often.view_from_world(), &once.view_from_world(), 1e-13);
}

#[test]
fn the_way_back_along_any_curve_is_the_exact_inverse() {
    let mut ways = circle(180.0, 90);
    ways.extend([DVec2::new(700.0, -20.0), DVec2::new(-33.0, 512.0)]);
    let back: Vec<DVec2> = ways.iter().rev().map(|way| -way).collect();
    ways.extend(back);
    assert!(turned(&ways).abs_diff_eq(DMat3::IDENTITY, 1e-13));
}

#[test]
fn what_is_before_the_eye_moves_with_the_hand() {
    // A point of the ball towards the eye, the hand to the right and upwards.
    let settings = settings(LENS);
    let end = pulled(
        before_origin(Mode::RollingBall),
        &settings,
        Gesture::Turn,
        &[DVec2::new(20.0, 0.0), DVec2::new(0.0, -20.0)],
    );
    let in_view = end.view_from_world().transform_point3(DVec3::Z);
    assert!(in_view.x > 0.0 && in_view.y > 0.0, "{in_view}");
}

#[test]
fn the_pivot_stays_where_it_is_seen() {
    let settings = settings(LENS);
    let start = somewhere(Mode::RollingBall);
    let end = pulled(start, &settings, Gesture::Turn, &circle(300.0, 50));
    let place = |state: &State| state.view_from_world().transform_point3(state.pivot());
    assert!(place(&start).abs_diff_eq(place(&end), 1e-13));
    assert_ne!(start.view_from_world(), DMat4::IDENTITY);
}
