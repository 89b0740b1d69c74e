//! Matrices and projection (GLU 1.3, chapter 4), by what they do to points.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_glu::{Transform, error_string, has_extension, look_at, perspective, pick_matrix};

fn times(m: &[f64; 16], p: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|row| (0..4).map(|column| m[4 * column + row] * p[column]).sum())
}

fn near(a: &[f64], b: &[f64]) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-9)
}

#[test]
fn a_perspective_maps_its_frustum_to_the_clip_volume() {
    let m = perspective(90.0, 2.0, 1.0, 9.0).unwrap();
    // The corners: tan(45 degrees) is 1.
    for (z, depth) in [(1.0, -1.0), (9.0, 1.0)] {
        let clip = times(&m, [2.0 * z, z, -z, 1.0]);
        assert!(near(&clip, &[z, z, depth * z, z]), "{clip:?}");
    }
    for bad in [
        perspective(0.0, 1.0, 1.0, 2.0),
        perspective(45.0, 0.0, 1.0, 2.0),
        perspective(45.0, 1.0, 2.0, 2.0),
    ] {
        assert_eq!(bad, None);
    }
}

#[test]
fn a_view_looks_along_minus_z_with_up_in_the_half_plane_of_y() {
    let m = look_at([1.0, 2.0, 3.0], [4.0, 6.0, 3.0], [0.0, 0.0, 5.0]);
    assert!(near(&times(&m, [1.0, 2.0, 3.0, 1.0]), &[0.0, 0.0, 0.0, 1.0]));
    assert!(near(&times(&m, [4.0, 6.0, 3.0, 1.0]), &[0.0, 0.0, -5.0, 1.0]));
    assert!(near(&times(&m, [0.0, 0.0, 1.0, 0.0]), &[0.0, 1.0, 0.0, 0.0]));
    // No direction: nothing that is not a number.
    assert!(look_at([1.0; 3], [1.0; 3], [0.0, 1.0, 0.0]).iter().all(|x| x.is_finite()));
}

#[test]
fn objects_come_back_from_the_window() {
    let transform = Transform {
        model: look_at([3.0, 4.0, 5.0], [0.0; 3], [0.0, 1.0, 0.0]),
        projection: perspective(50.0, 1.5, 0.5, 50.0).unwrap(),
        viewport: [10, 20, 300, 200],
    };
    let object = [0.5, -0.25, 0.75];
    let window = transform.project(object).unwrap();
    assert!(near(&transform.unproject(window).unwrap(), &object));
    let clip_w = 1.0 / 7.0;
    let [x, y, z, w] =
        transform.unproject4([window[0], window[1], window[2], clip_w], [0.0, 1.0]).unwrap();
    // With a w of its own the result is scaled, about the eye.
    assert!(w != 0.0 && [x, y, z].iter().all(|x| x.is_finite()));
    assert!(near(&transform.project([0.0; 3]).unwrap()[..2], &[160.0, 120.0]));
    let flat = Transform { projection: [0.0; 16], ..transform };
    assert_eq!((flat.unproject(window), flat.project(object)), (None, None));
}

#[test]
fn a_pick_matrix_spreads_a_rectangle_over_the_window() {
    let m = pick_matrix([60.0, 70.0], [10.0, 20.0], [10, 20, 200, 100]).unwrap();
    // The rectangle's corner (65, 80) of the window is (-0.45, 0.2) of the clip volume.
    assert!(near(&times(&m, [-0.45, 0.2, 0.3, 1.0]), &[1.0, 1.0, 0.3, 1.0]));
    assert_eq!(pick_matrix([60.0, 70.0], [0.0, 20.0], [10, 20, 200, 100]), None);
}

#[test]
fn names_of_extensions_are_whole_words() {
    assert!(has_extension(b"GL_b", b"GL_a GL_b"));
    assert!(!has_extension(b"GL", b"GL_a GL_b") && !has_extension(b"", b"GL_a  GL_b"));
    assert_eq!(error_string(0x0502), Some(c"invalid operation"));
    assert_eq!(error_string(7), None);
}
