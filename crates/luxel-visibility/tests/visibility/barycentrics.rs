//! Barycentrics against rays in f64, and against themselves sixteen at a time.

use crate::random::cases;
use crate::scene::{Picture, best};
use crate::solid::{View, bumpy, direction};
use glam::{DVec3, DVec4};
use luxel_math::{Level, Simd, SimdLevel, dispatch, f32x16, prelude::*};
use luxel_scene::{Lens, Mesh, Size};
use luxel_visibility::{Forms, Frame, TileForms, TriangleOf, sides};
use proptest::prelude::*;

/// Where a ray meets the plane of a triangle: the barycentrics of Möller and Trumbore (1997).
fn cast(origin: DVec3, direction: DVec3, [a, b, c]: [DVec3; 3]) -> Option<[f64; 3]> {
    let (ab, ac) = (b - a, c - a);
    let normal = direction.cross(ac);
    let scale = ab.dot(normal);
    if scale == 0.0 {
        return None;
    }
    let to_origin = origin - a;
    let v = to_origin.dot(normal) / scale;
    let w = direction.dot(to_origin.cross(ab)) / scale;
    Some([1.0 - v - w, v, w])
}

/// The ray through a window position, from the lens alone.
fn ray(lens: Lens, size: Size, x: f64, y: f64) -> (DVec3, DVec3) {
    let (width, height) = (f64::from(size.width), f64::from(size.height));
    match lens {
        Lens::Perspective { fov_y_radians } => {
            let pixel = 2.0 * libm::tan(fov_y_radians / 2.0) / height;
            let towards = DVec3::new((x - width / 2.0) * pixel, (height / 2.0 - y) * pixel, -1.0);
            (DVec3::ZERO, towards)
        }
        Lens::Intrinsics { fx, fy, cx, cy } => {
            (DVec3::ZERO, DVec3::new((x - cx) / fx, (cy - y) / fy, -1.0))
        }
        Lens::Orthographic { height: extent } => {
            let pixel = extent / height;
            let from = DVec3::new((x - width / 2.0) * pixel, (height / 2.0 - y) * pixel, 0.0);
            (from, DVec3::NEG_Z)
        }
    }
}

/// Where a point in view space falls in the window, in pixels; `None` behind the eye.
fn window(view: &View, point: DVec3) -> Option<[f64; 2]> {
    let clip: DVec4 = view.projection.clip_from_view(view.size) * point.extend(1.0);
    let (width, height) = (f64::from(view.size.width), f64::from(view.size.height));
    (clip.w > 0.0)
        .then(|| [(clip.x / clip.w + 1.0) * 0.5 * width, (1.0 - clip.y / clip.w) * 0.5 * height])
}

/// The smallest of a triangle's heights in the window, in pixels; `None` if it reaches behind the eye.
fn smallest_height(view: &View, corners: [DVec3; 3]) -> Option<f64> {
    let [Some(a), Some(b), Some(c)] = corners.map(|corner| window(view, corner)) else {
        return None;
    };
    let area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
    let length = |p: [f64; 2], q: [f64; 2]| libm::hypot(q[0] - p[0], q[1] - p[1]);
    Some(area / length(a, b).max(length(b, c)).max(length(c, a)))
}

/// How much longer than high a triangle is in the window; `None` if it reaches behind the eye.
fn stretch(view: &View, corners: [DVec3; 3]) -> Option<f64> {
    let height = smallest_height(view, corners)?;
    let [Some(a), Some(b), Some(c)] = corners.map(|corner| window(view, corner)) else {
        return None;
    };
    let length = |p: [f64; 2], q: [f64; 2]| libm::hypot(q[0] - p[0], q[1] - p[1]);
    Some(length(a, b).max(length(b, c)).max(length(c, a)) / height)
}

fn check(view: &View) -> Result<(), TestCaseError> {
    view.with_frame(best(), |frame| {
        let picture = Picture::opaque(frame, best());
        let (mut large, mut small) = (0.0_f64, 0.0_f64);
        for (number, position) in view.sample_positions() {
            let Some((_, (instance, triangle))) = picture.seen[number] else { continue };
            let of = TriangleOf { instance, triangle, part: 0 };
            let forms = frame.forms(of);
            let corners = forms.corners();
            let found = forms.barycentric(frame.rays(), position);
            let sum = found.iter().map(|&value| f64::from(value)).sum::<f64>();
            prop_assert!(found.iter().all(|value| (0.0..=1.0).contains(value)), "{:?}", found);
            prop_assert!((sum - 1.0).abs() <= 2e-7, "{:?} sum to {}", found, sum);

            let [x, y] = position.map(|steps| f64::from(steps) / 256.0);
            let (origin, direction) = ray(view.projection.lens, view.size, x, y);
            let expected = cast(origin, direction, corners);
            let found = found.map(f64::from);
            match expected.filter(|expected| expected.iter().all(|&value| value >= 0.0)) {
                Some(expected) => {
                    let off = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
                    match smallest_height(view, corners) {
                        None => large = large.max(off),
                        Some(height) if height > 8.0 => large = large.max(off),
                        Some(height) if height > 0.5 => small = small.max(off),
                        Some(_) => {}
                    }
                }
                None => {
                    // Just outside: the place lies where the sample is, up to the snap, and in slivers
                    // farther along them: negative weights count as 0.
                    let place =
                        corners[0] * found[0] + corners[1] * found[1] + corners[2] * found[2];
                    let [px, py] = window(view, place).unwrap_or([f64::NAN; 2]);
                    let off = libm::hypot(px - x, py - y);
                    let stretch = stretch(view, corners).unwrap_or(64.0).clamp(1.0, 64.0);
                    let bound = 2.0 / 256.0 * stretch;
                    prop_assert!(off < bound, "{} pixels off at {:?}", off, position);
                }
            }
        }
        prop_assert!(large < 1e-5, "off by {} in large triangles", large);
        prop_assert!(small < 1e-4, "off by {} in small triangles", small);
        Ok(())
    })
}

fn lens() -> impl Strategy<Value = Lens> {
    prop_oneof![
        (0.05..2.8).prop_map(|fov_y_radians| Lens::Perspective { fov_y_radians }),
        (0.1..8.0).prop_map(|height| Lens::Orthographic { height }),
        (20.0..900.0, 0.5..2.0, -50.0..150.0, -50.0..150.0)
            .prop_map(|(f, ratio, cx, cy)| Lens::Intrinsics { fx: f, fy: f * ratio, cx, cy }),
    ]
}

proptest! {
    #![proptest_config(cases(80))]

    #[test]
    fn what_a_sample_is_told_is_what_a_ray_finds(
        (place, towards, reach) in (direction(), direction(), 0.0..6.0),
        lens in lens(),
        frequency in prop::sample::select(vec![1, 2, 5, 12, 30]),
        samples in prop::sample::select(vec![1, 4]),
    ) {
        // From within and from without, towards the middle.
        let eye = place * reach;
        let target = if reach < 1.0 { eye + towards } else { towards * 0.3 };
        let view = View::look(bumpy(frequency), eye, target, lens, [1e-3, 50.0]);
        check(&View { samples, ..view })?;
    }

    #[test]
    fn triangles_seen_nearly_from_the_side_are_told_to_lie_where_they_are_drawn(
        corners in prop::collection::vec((-40.0..40.0, -30.0..30.0, -9.0..-2.0), 2..6),
        lens in prop_oneof![Just(Lens::Orthographic { height: 79.0 }),
            Just(Lens::Intrinsics { fx: 5.0, fy: 5.0, cx: 50.5, cy: 39.5 })],
        slant in prop::sample::select(vec![0.0, 1e-6, 1e-3, 4e-3, -1e-3]),
    ) {
        // All corners in a plane through the eye, or along the rays.
        let mut mesh = Mesh::default();
        for &(x, _, z) in &corners {
            let y = 0.37 * if matches!(lens, Lens::Orthographic { .. }) { x } else { x + 0.01 * z };
            let off = if mesh.positions.len() % 2 == 0 { 0.0 } else { slant };
            mesh.positions.push([x, y + off, z].map(|value| value as f32));
        }
        let count = corners.len() as u32;
        for first in 0..count {
            let triangle = [first, (first + 1) % count, (first + 2) % count];
            mesh.triangles.push(triangle);
        }
        mesh.parts = vec![luxel_scene::Part {
            first: 0, count, material: luxel_scene::MaterialId(0),
        }];
        let view = View::look(mesh, DVec3::ZERO, DVec3::NEG_Z, lens, [0.5, 50.0]);
        check(&View { samples: 16, ..view })?;
    }
}

/// Barycentrics of a block, as drawing computes them.
#[inline(always)]
fn of_block<S: Simd>(
    simd: S,
    forms: &Forms,
    frame: &Frame<'_>,
    [x, y]: [i32; 2],
) -> [[f32; 3]; 16] {
    let tile = [x / 64 * 64, y / 64 * 64];
    let lane = |value: fn(usize) -> usize, first: i32| {
        let lanes = std::array::from_fn(|lane| first as f32 + value(lane) as f32 + 0.5);
        f32x16::simd_from(simd, lanes)
    };
    let (across, down) = (lane(|lane| lane % 4, x - tile[0]), lane(|lane| lane / 4, y - tile[1]));
    let wide = across.to_f64();
    let corners = forms.corners().map(|corner| corner.to_array().map(|side| wide.constant(side)));
    let towards_eye = wide.constant(forms.towards_eye());
    let in_tile = TileForms::new(frame.rays(), &corners, sides(&corners), towards_eye, tile);
    let found = in_tile.at(across, down);
    let ([a, b, c], inexact) = (found.weights, found.inexact.to_bitmask());
    std::array::from_fn(|lane| {
        if inexact >> lane & 1 == 1 {
            let pixel = [x + lane as i32 % 4, y + lane as i32 / 4];
            forms.exact_barycentric(frame.rays(), pixel.map(|pixel| pixel * 256 + 128))
        } else {
            [a[lane], b[lane], c[lane]]
        }
    })
}

#[test]
fn blocks_are_told_the_same_bits_as_single_samples_at_every_level() {
    let lens = Lens::Perspective { fov_y_radians: 0.9 };
    let view = View::look(bumpy(6), DVec3::new(1.0, 2.0, 1.5), DVec3::ZERO, lens, [0.1, 10.0]);
    view.with_frame(best(), |frame| {
        for triangle in 0..view.mesh.triangles.len() as u32 {
            let forms = frame.forms(TriangleOf { instance: 0, triangle, part: 0 });
            let corner = [triangle as i32 % 24 * 4, triangle as i32 / 24 * 4 % 76];
            let alone: [[f32; 3]; 16] = std::array::from_fn(|lane| {
                let pixel = [corner[0] + lane as i32 % 4, corner[1] + lane as i32 / 4];
                forms.barycentric(frame.rays(), pixel.map(|pixel| pixel * 256 + 128))
            });
            for level in SimdLevel::available() {
                let level: Level = level.resolve().unwrap();
                let block = dispatch!(level, simd => of_block(simd, &forms, frame, corner));
                assert_eq!(block.map(|b| b.map(f32::to_bits)), alone.map(|b| b.map(f32::to_bits)));
            }
        }
    });
}
