//! Barycentrics in f32 against f64, over random triangles: tiny, huge, edge-on and far away.

use glam::DVec3;
use luxel_math::SUBPIXELS;
use luxel_scene::{Lens, Projection, Size};
use luxel_visibility::{Forms, WindowRays};

const SIZE: Size = Size { width: 1920, height: 1080 };

/// Numbers from 0 to 1, always the same ones (xorshift; Marsaglia 2003).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let v = DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0;
            if (0.01..1.0).contains(&v.length_squared()) {
                return v.normalize();
            }
        }
    }
}

fn rays(lens: Lens) -> WindowRays {
    WindowRays::new(&Projection { lens, near: 0.1, far: 1e6 }, SIZE)
}

/// A triangle of about `pixels` pixels whose plane has the cosine `tilt` against the ray through
/// `sample`, which lies inside of it: corners, and the exact barycentrics.
fn triangle(
    random: &mut Random,
    rays: &WindowRays,
    [x, y]: [f64; 2],
    pixels: f64,
    tilt: f64,
    distance: f64,
) -> ([DVec3; 3], [f64; 3]) {
    let (origin, ray) = rays.ray(x, y);
    let place = origin + ray * distance;
    let (next_origin, next) = rays.ray(x + 1.0, y);
    let pixel = ((next_origin + next * distance) - place).length();
    let ray = ray.normalize();
    // Two axes of the plane: one across the ray, one leaning along it by the tilt.
    let across = ray.cross(random.direction()).normalize();
    let beside = ray.cross(across);
    let leaning = ray * (1.0 - tilt * tilt).sqrt() + beside * tilt;
    let size = pixel * pixels;
    let weights = {
        let mut w = [0, 1, 2].map(|_| 0.05 + random.next());
        let sum: f64 = w.iter().sum();
        w.iter_mut().for_each(|w| *w /= sum);
        w
    };
    let turn = random.next() * std::f64::consts::TAU;
    let corners = [0.0, 1.0, 2.0].map(|third| {
        let angle = turn + third * std::f64::consts::TAU / 3.0;
        across * (libm::cos(angle) * size) + leaning * (libm::sin(angle) * size)
    });
    let centre = corners[0] * weights[0] + corners[1] * weights[1] + corners[2] * weights[2];
    (corners.map(|corner| place + corner - centre), weights)
}

/// The worst error of f32 barycentrics, and the part of the triangles that f64 has to answer for.
fn worst(lens: Lens, pixels: f64, tilt: f64, distance: f64) -> (f64, f64) {
    let rays = rays(lens);
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let (mut worst, mut exact, mut count) = (0.0_f64, 0.0, 0.0);
    for _ in 0..4000 {
        let pixel = [random.next() * 1920.0, random.next() * 1080.0];
        let steps = pixel.map(|side| (side * f64::from(SUBPIXELS)) as i32);
        let [x, y] = steps.map(|steps| f64::from(steps) / f64::from(SUBPIXELS));
        let (corners, weights) = triangle(&mut random, &rays, [x, y], pixels, tilt, distance);
        let forms = Forms::new(&rays, corners.map(|corner| corner.to_array()));
        let tile = steps.map(|steps| steps / SUBPIXELS / 64 * 64);
        let inside =
            [0, 1].map(|axis| (steps[axis] - tile[axis] * SUBPIXELS) as f32 / SUBPIXELS as f32);
        let found = forms.in_tile(&rays, tile).at(inside[0], inside[1]);
        count += 1.0;
        if found.inexact {
            exact += 1.0;
            continue;
        }
        for (found, weight) in found.weights.into_iter().zip(weights) {
            worst = worst.max((f64::from(found) - weight).abs());
        }
    }
    (worst, exact / count)
}

const PERSPECTIVE: Lens = Lens::Perspective { fov_y_radians: 0.8 };

#[test]
fn f32_barycentrics_stay_within_their_bound_at_every_size_tilt_and_distance() {
    let lenses = [PERSPECTIVE, Lens::Orthographic { height: 3.0 }];
    for lens in lenses {
        for pixels in [0.01, 0.1, 1.0, 10.0, 100.0, 10_000.0] {
            for (tilt, bound) in [(1.0, 2e-6), (0.3, 3e-6), (0.1, 1e-5), (0.05, 1e-5), (0.02, 3e-5)]
            {
                for distance in [0.5, 4.0, 200.0, 1e5] {
                    // Larger triangles would reach behind the eye; parallel rays have no eye.
                    let (error, exact) = worst(lens, pixels, tilt, distance);
                    assert!(error < bound, "{pixels} px, tilt {tilt}, {distance}: {error:e}");
                    let most = if tilt >= 0.05 { 0.01 } else { 0.3 };
                    assert!(exact <= most, "{pixels} px, tilt {tilt}: {exact} by f64");
                }
            }
        }
    }
}

/// Where the ray of a place of the window meets the plane of a triangle, as barycentrics in f64.
fn meeting(rays: &WindowRays, [x, y]: [f64; 2], [a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let (origin, ray) = rays.ray(x, y);
    let normal = (b - a).cross(c - a);
    let place = origin + ray * ((a - origin).dot(normal) / ray.dot(normal));
    let part = |p: DVec3, q: DVec3| (p - place).cross(q - place).dot(normal);
    [part(b, c), part(c, a), part(a, b)].map(|part| part / normal.dot(normal))
}

/// The worst error of f32 steps over a pixel, as a part of the step.
fn worst_step(pixels: f64, tilt: f64) -> f64 {
    let rays = rays(PERSPECTIVE);
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let mut worst = 0.0_f64;
    for _ in 0..4000 {
        let pixel = [random.next() * 1919.0, random.next() * 1079.0];
        let steps = pixel.map(|side| (side * f64::from(SUBPIXELS)) as i32);
        let [x, y] = steps.map(|steps| f64::from(steps) / f64::from(SUBPIXELS));
        let (corners, _) = triangle(&mut random, &rays, [x, y], pixels, tilt, 4.0);
        let forms = Forms::new(&rays, corners.map(|corner| corner.to_array()));
        let here = meeting(&rays, [x, y], corners);
        for (found, to) in forms.steps(&rays, steps).into_iter().zip([[x + 1.0, y], [x, y + 1.0]]) {
            let there = meeting(&rays, to, corners);
            let expected = [there[1] - here[1], there[2] - here[2]];
            let length = expected[0].hypot(expected[1]);
            let off = [0, 1].map(|at| f64::from(found[at]) - expected[at]);
            worst = worst.max(off[0].hypot(off[1]) / length);
        }
    }
    worst
}

#[test]
fn f32_steps_over_a_pixel_keep_their_digits_however_short_they_are() {
    // Across 10 000 pixels a step is 1e-4, of which differences of barycentrics keep three digits.
    for pixels in [1.0, 10.0, 100.0, 1000.0, 10_000.0] {
        for (tilt, bound) in [(1.0, 1e-6), (0.3, 3e-6), (0.1, 1e-5)] {
            let error = worst_step(pixels, tilt);
            assert!(error < bound, "{pixels} px, tilt {tilt}: {error:e}");
        }
    }
}
