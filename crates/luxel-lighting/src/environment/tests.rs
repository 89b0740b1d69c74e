use super::*;
use std::f64::consts::PI;
use std::sync::Arc;

const Y_UP: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The direction of the middle of a texel, by the convention of three.js: the picture's middle is +X, and +Z
/// three quarters of the way across.
fn direction_of(column: usize, row: usize, [width, height]: [usize; 2]) -> [f64; 3] {
    let longitude = ((column as f64 + 0.5) / width as f64 - 0.5) * 2.0 * PI;
    let latitude = (0.5 - (row as f64 + 0.5) / height as f64) * PI;
    let ring = libm::cos(latitude);
    [ring * libm::cos(longitude), libm::sin(latitude), ring * libm::sin(longitude)]
}

fn image(width: usize, of: impl Fn([f64; 3]) -> [f64; 3]) -> EquirectangularImage {
    let height = width / 2;
    let texel = |at: usize| {
        of(direction_of(at % width, at / width, [width, height])).map(|channel| channel as f32)
    };
    let light = (0..width * height).map(texel).collect();
    EquirectangularImage { width: width as u32, height: height as u32, light }
}

fn oriented(image: EquirectangularImage, rotation_degrees: f64) -> OrientedMap {
    OrientedMap::new(Arc::new(EnvironmentMap::new("test", image)), Y_UP, rotation_degrees)
}

fn vec3(direction: [f64; 3]) -> Vec3<f32> {
    let [x, y, z] = direction.map(|axis| axis as f32);
    Vec3::new(x, y, z)
}

/// Directions all around, evenly.
fn around(count: usize) -> impl Iterator<Item = [f64; 3]> {
    (0..count).map(move |at| {
        let y = 1.0 - (2 * at + 1) as f64 / count as f64;
        let (sine, cosine) = libm::sincos(at as f64 * PI * (3.0 - 5.0_f64.sqrt()));
        let ring = (1.0 - y * y).sqrt();
        [ring * cosine, y, ring * sine]
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A sky above a meadow, with a sun as bright as two of them together.
fn outdoors(direction: [f64; 3]) -> [f64; 3] {
    let to_sun = [0.48, 0.6, 0.64];
    let sky = [0.3, 0.5, 1.0].map(|blue| blue * (1.2 - direction[1]));
    let meadow = [0.1, 0.15, 0.05];
    let t = (direction[1] * 10.0).clamp(-1.0, 1.0) * 0.5 + 0.5;
    let sun = 5000.0 * libm::exp((dot(direction, to_sun) - 1.0) / 0.0005);
    [0, 1, 2].map(|channel| meadow[channel] * (1.0 - t) + sky[channel] * t + sun)
}

/// The lobe of the prefilter by brute force: the integral of L (N.L) over the directions to which GGX's facets
/// mirror V, N = V = R, by `count` directions chosen by importance.
fn lobe(of: impl Fn([f64; 3]) -> [f64; 3], r: [f64; 3], roughness: f64, count: usize) -> [f64; 3] {
    let alpha = roughness * roughness;
    let aside = if r[1].abs() < 0.9 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let s = cross(aside, r);
    let s = s.map(|axis| axis / dot(s, s).sqrt());
    let t = cross(r, s);
    let (mut sum, mut weights) = ([0.0; 3], 0.0);
    for at in 0..count {
        // Roberts' sequence of two dimensions.
        let (a, b) = (
            (at as f64 * 0.754_877_666_246_692_7).fract(),
            (at as f64 * 0.569_840_290_998_053_3).fract(),
        );
        let cosine2 = (1.0 - a) / (1.0 + (alpha * alpha - 1.0) * a);
        let (sine, cosine) = ((1.0 - cosine2).sqrt(), cosine2.sqrt());
        let (y, x) = libm::sincos(2.0 * PI * b);
        let h = [0, 1, 2].map(|axis| sine * x * s[axis] + sine * y * t[axis] + cosine * r[axis]);
        let l = [0, 1, 2].map(|axis| 2.0 * cosine * h[axis] - r[axis]);
        let n_dot_l = dot(l, r);
        if n_dot_l > 0.0 {
            let light = of(l);
            for channel in 0..3 {
                sum[channel] += light[channel] * n_dot_l;
            }
            weights += n_dot_l;
        }
    }
    sum.map(|channel| channel / weights)
}

#[test]
fn a_picture_of_one_colour_is_that_colour_everywhere() {
    let color = [0.25, 1.0, 3.0];
    for width in [2, 64, 200] {
        let map = oriented(image(width, |_| color), 30.0);
        let near = |found: Rgb<f32>| {
            for (found, expected) in found.lane(0).into_iter().zip(color) {
                assert!(
                    (f64::from(found) / expected - 1.0).abs() < 1e-4,
                    "{width}: {found} {expected}"
                );
            }
        };
        for direction in around(500) {
            near(map.irradiance(vec3(direction)));
            for roughness in [0.0, 0.04, 0.1, 0.35, 0.8, 1.0] {
                near(map.radiance(vec3(direction), roughness));
            }
        }
        near(Rgb::new(map.map().mean()[0], map.map().mean()[1], map.map().mean()[2]));
    }
}

#[test]
fn matt_surfaces_get_the_irradiance_of_closed_forms() {
    // Of light that is a harmonic, the irradiance is that harmonic times pi, 2 pi / 3 and pi / 4.
    let a = [0.48, -0.6, 0.64];
    let light = |d: [f64; 3]| [2.0 + dot(a, d), 1.0 + d[0] * d[1], 2.0 + 3.0 * d[2] * d[2] - 1.0];
    let map = oriented(image(256, light), 0.0);
    // A cosine lobe: (1/4 + cos / 3 + 5 (3 cos^2 - 1) / 64 + ...) / pi; the sum of harmonics leaves out the rest.
    let lobe = oriented(image(256, |d| [dot(a, d).max(0.0); 3]), 0.0);
    for n in around(300) {
        let expected = [
            2.0 + dot(a, n) * 2.0 / 3.0,
            1.0 + n[0] * n[1] / 4.0,
            2.0 + (3.0 * n[2] * n[2] - 1.0) / 4.0,
        ];
        for (found, expected) in map.irradiance(vec3(n)).lane(0).into_iter().zip(expected) {
            assert!((f64::from(found) - expected).abs() < 3e-4, "{n:?}: {found}, {expected}");
        }
        let c = dot(a, n);
        let expected = (0.25 + c / 3.0 + 5.0 / 128.0 * (3.0 * c * c - 1.0)).max(0.0);
        let found = f64::from(lobe.irradiance(vec3(n)).r);
        assert!((found - expected).abs() < 3e-4, "{n:?}: {found}, {expected}");
    }
}

#[test]
fn directions_are_where_three_js_and_blender_have_them() {
    // A picture of four columns: -X to -Z, -Z to +X, +X to +Z, +Z to -X.
    let light = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 1.0, 0.0]];
    let mut rows = Vec::new();
    for row in 0..8 {
        rows.extend(light.map(|color| if row < 4 { color } else { color.map(|c: f32| c * 0.5) }));
    }
    let image = EquirectangularImage { width: 4, height: 8, light: rows };
    let map = oriented(image, 0.0);
    let at = |direction: [f64; 3]| map.radiance(vec3(direction), 0.0).lane(0);
    for (direction, expected) in [
        ([-0.7, 0.14, -0.7], [1.0, 0.0, 0.0]),
        ([0.7, 0.14, -0.7], [0.0, 1.0, 0.0]),
        ([0.7, 0.14, 0.7], [0.0, 0.0, 1.0]),
        ([-0.7, 0.14, 0.7], [1.0, 1.0, 0.0]),
        ([-0.6, -0.5, 0.6], [0.5, 0.5, 0.0]),
    ] {
        let found = at(direction);
        for channel in 0..3 {
            assert!((found[channel] - expected[channel]).abs() < 0.1, "{direction:?}: {found:?}");
        }
    }
}

#[test]
fn a_quarter_turn_is_the_picture_moved_by_a_quarter_of_its_width() {
    let plain = image(128, outdoors);
    let mut moved = plain.clone();
    for (row, light) in moved.light.chunks_exact_mut(128).enumerate() {
        for (column, light) in light.iter_mut().enumerate() {
            *light = plain.light[row * 128 + (column + 32) % 128];
        }
    }
    let turned = oriented(plain, 90.0);
    let moved = oriented(moved, 0.0);
    for direction in around(1000) {
        for roughness in [0.0, 0.3, 1.0] {
            let a = turned.radiance(vec3(direction), roughness).lane(0);
            let b = moved.radiance(vec3(direction), roughness).lane(0);
            for channel in 0..3 {
                let error = (a[channel] - b[channel]).abs() / b[channel].max(0.1);
                assert!(error < 2e-4, "{direction:?} {roughness}: {a:?} {b:?}");
            }
        }
    }
}

#[test]
fn no_light_of_a_small_sun_is_lost() {
    // A single bright texel, wherever it is, adds its light times its solid angle.
    for (column, row) in [(0, 3), (63, 15), (32, 16), (17, 31), (40, 0)] {
        let mut picture = image(64, |_| [0.0; 3]);
        picture.light[row * 64 + column] = [1e6, 1e3, 1.0];
        let map = EnvironmentMap::new("sun", picture);
        // The texel, as linear filtering spreads it over its neighbours.
        let edge = |row: f64| libm::sin(PI * (0.5 - row / 32.0));
        let area = 2.0 * PI / 64.0 * (edge(row as f64) - edge(row as f64 + 1.0));
        let expected = 1e6 * area / (4.0 * PI);
        let found = f64::from(map.mean()[0]);
        assert!((found / expected - 1.0).abs() < 0.35, "{column} {row}: {found} {expected}");
        if (8..24).contains(&row) {
            assert!((found / expected - 1.0).abs() < 0.01, "{column} {row}: {found} {expected}");
        }
    }
}

#[test]
fn blurred_light_is_the_integral_over_the_facets() {
    // So few of the facets mirror a small sun that it takes many of them.
    for (name, bound, facets, of) in [
        (
            "sky",
            0.01,
            20_000,
            (|d| outdoors(d).map(|light| light.min(2.0))) as fn([f64; 3]) -> [f64; 3],
        ),
        ("sun", 0.03, 200_000, outdoors),
    ] {
        let map = oriented(image(512, of), 0.0);
        for step in 1..=10 {
            let roughness = f64::from(step) / 10.0;
            let (mut worst, mut squares, mut count) = (0.0_f64, 0.0, 0);
            for direction in around(50) {
                let expected = lobe(of, direction, roughness, facets);
                let found = map.radiance(vec3(direction), roughness as f32).lane(0);
                for channel in 0..3 {
                    let error = (f64::from(found[channel]) - expected[channel])
                        / expected[channel].max(0.05);
                    worst = worst.max(error.abs());
                    squares += error * error;
                    count += 1;
                }
            }
            let mean = (squares / f64::from(count)).sqrt();
            println!("{name} {roughness}: worst {worst:.4}, mean square {mean:.4}");
            assert!(mean < bound, "{name} {roughness}: {mean}");
        }
    }
}
