//! For each mode a log whose result was computed by hand.
//!
//! All begin at (0, 0, 5) looking along -Z, the pivot at the origin, so that view_from_world is the
//! translation by (0, 0, -5). A view's rows are the camera's right, up and back axes in the world;
//! its translation is (-right . eye, -up . eye, -back . eye).

use crate::stage::{LENS, assert_near, before_origin, play, settings};
use glam::{DMat4, DVec3};
use luxel_navigation::Mode;
use std::f64::consts::{PI, SQRT_2};

/// The view of an eye with its axes.
fn view(right: DVec3, up: DVec3, back: DVec3, eye: DVec3) -> DMat4 {
    let rows = DMat4::from_cols(
        right.extend(-right.dot(eye)),
        up.extend(-up.dot(eye)),
        back.extend(-back.dot(eye)),
        glam::DVec4::W,
    );
    rows.transpose()
}

#[track_caller]
fn check(mode: Mode, log: &str, expected: &DMat4) {
    let (state, _) = play(before_origin(mode), settings(LENS), log);
    assert_near(&state.view_from_world(), expected, 1e-14);
}

#[test]
fn absolute() {
    // Two to the right: the eye at (2, 0, 5). A quarter turn about the world's y takes x to -z and z
    // to x: the eye comes to (5, 0, -2), right to -z, back to x. Three along -z: (5, 0, -5).
    check(
        Mode::Absolute,
        "set move-step 1
        set turn-step-radians 1.5707963267948966
        tap x+ 2
        tap turn-y+
        tap z- 3",
        &view(DVec3::NEG_Z, DVec3::Y, DVec3::X, DVec3::new(5.0, 0.0, -5.0)),
    );
}

#[test]
fn look_at() {
    // The eye at (5, 0, 5), the target at (0, 5, 0): back = (1, -1, 1) / sqrt 3,
    // right = y x back = (1, 0, -1) / sqrt 2, up = back x right = (1, 2, 1) / sqrt 6.
    let (two, three, six) = (SQRT_2, f64::sqrt(3.0), f64::sqrt(6.0));
    check(
        Mode::LookAt,
        "set move-step 1
        tap x+ 5
        tap target-y+ 5",
        &view(
            DVec3::new(1.0, 0.0, -1.0) / two,
            DVec3::new(1.0, 2.0, 1.0) / six,
            DVec3::new(1.0, -1.0, 1.0) / three,
            DVec3::new(5.0, 0.0, 5.0),
        ),
    );
}

#[test]
fn rolling_ball() {
    // With a radius of 100 pixels, 50 pi pixels are a quarter turn. To the right: the scene turns
    // about the camera's y, x to -z and z to x. Upwards (y falls in the window): about -x, z to y and
    // y to -z. Together x goes to -y, y to -z, z to x; the origin stays five ahead.
    let columns = DMat4::from_cols(
        DVec3::NEG_Y.extend(0.0),
        DVec3::NEG_Z.extend(0.0),
        DVec3::X.extend(0.0),
        DVec3::new(0.0, 0.0, -5.0).extend(1.0),
    );
    check(
        Mode::RollingBall,
        "set ball-radius 100
        grab turn 200 500
        drag 357.07963267948966 500
        drag 357.07963267948966 342.92036732051034
        release",
        &columns,
    );
}

#[test]
fn flying() {
    // One second ahead at speed 2: to (0, 0, 3). Then a left turn of a quarter in a second, still at
    // speed 2: a quarter circle of radius 2 / (pi / 2) = 4 / pi about (-4 / pi, 0, 3), which ends at
    // (-4 / pi, 0, 3 - 4 / pi) looking along -x: back = x, right = -z.
    let radius = 4.0 / PI;
    check(
        Mode::Flying,
        "set throttle-step 1
        set turn-radians-per-second 1.5707963267948966
        tap faster 2
        +1 wait
        press yaw-left
        +0.25 wait
        +0.75 lift yaw-left",
        &view(DVec3::NEG_Z, DVec3::Y, DVec3::X, DVec3::new(-radius, 0.0, 3.0 - radius)),
    );
}

#[test]
fn mouselook() {
    // 50 pi pixels of 0.01 radians to the right: looking along +x. Two ahead: the eye at (2, 0, 5).
    // Then far upwards, which ends at the limit of 30 degrees: looking along (cos 30, sin 30, 0),
    // right = z, up = (-sin 30, cos 30, 0).
    let (sine, cosine) = (0.5, f64::sqrt(3.0) / 2.0);
    check(
        Mode::Mouselook,
        "set look-radians-per-pixel 0.01
        set pitch-limit-radians 0.5235987755982988
        set move-step 1
        grab turn 640 360
        drag 797.0796326794897 360
        tap forward 2
        drag 797.0796326794897 -10000
        release",
        &view(
            DVec3::Z,
            DVec3::new(-sine, cosine, 0.0),
            DVec3::new(-cosine, -sine, 0.0),
            DVec3::new(2.0, 0.0, 5.0),
        ),
    );
}

#[test]
fn turntable() {
    // A quarter turn of the scene to the right: the camera is at -x. Then far down, to the pole: the
    // camera is straight above, what was ahead, +x, is up in the picture; right is still +z.
    check(
        Mode::Turntable,
        "set ball-radius 100
        grab turn 200 200
        drag 357.07963267948966 200
        drag 357.07963267948966 1200
        release",
        &view(DVec3::Z, DVec3::X, DVec3::Y, DVec3::new(0.0, 5.0, 0.0)),
    );
}
