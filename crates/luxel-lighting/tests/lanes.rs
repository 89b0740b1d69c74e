//! Sixteen lanes give the bits of one value, at every SIMD level.

mod naive;

use luxel_lighting::*;
use luxel_math::prelude::*;
use luxel_math::{LANES, Rgb, SimdLevel, Vec3, dispatch, f32x16, u32x16};
use naive::models;

/// Sixteen different points.
fn points() -> [SurfacePoint<f32>; 16] {
    std::array::from_fn(|lane| {
        let angle = lane as f64 * 0.4;
        let (sin, cos) = (libm::sin(angle) as f32, libm::cos(angle) as f32);
        let position = Vec3::new(sin, cos * 0.5, -4.0 + 0.3 * lane as f32);
        SurfacePoint {
            position,
            normal: Vec3::new(cos, 0.3, sin).normalized_or_zero(),
            view: (-position).normalized_or_zero(),
            depth: -position.z,
        }
    })
}

#[inline(always)]
fn in_lanes<S: Simd>(
    simd: S,
    points: &[SurfacePoint<f32>; 16],
    material: &Material,
    lighting: &LightingEnvironment<'_>,
) -> [[f32; 3]; 16] {
    let simd = f32x16::splat(simd, 0.0);
    let vector = |of: fn(&SurfacePoint<f32>) -> Vec3<f32>| {
        Vec3::new(
            simd.each_lane(|lane| of(&points[lane]).x),
            simd.each_lane(|lane| of(&points[lane]).y),
            simd.each_lane(|lane| of(&points[lane]).z),
        )
    };
    let point = SurfacePoint {
        position: vector(|point| point.position),
        normal: vector(|point| point.normal),
        view: vector(|point| point.view),
        depth: simd.each_lane(|lane| points[lane].depth),
    };
    let reflectance = Reflectance::of(simd, material);
    let color: Rgb<f32x16<S>> = lit(&point, &reflectance, material, lighting, &mut Silent);
    std::array::from_fn(|lane| color.lane(lane))
}

#[test]
fn every_simd_level_gives_the_bits_of_one_value() {
    let fog = Fog { color: [0.4; 3], law: FogLaw::Exponential { density: 0.1 } };
    let spot = LightKind::Spot(Cone::Exponent { cos_cutoff: 0.8, exponent: 3.0 });
    let lights = [
        naive::facing_light(),
        PlacedLight::new(Light::new(LightKind::Point, [0.9, 0.5, 0.2]), [2.0, 1.0, -1.0], [0.0; 3]),
        PlacedLight::new(Light::new(spot, [0.3, 2.0, 0.7]), [0.0, 3.0, 0.0], [0.0, -1.0, -1.0]),
    ];
    let lighting = LightingEnvironment::new(
        &lights,
        [0.1, 0.11, 0.12],
        &Environment::Studio { up: [0.0, 1.0, 0.0] },
        Some(&fog),
    );
    let points = points();
    for reflection in models() {
        let material =
            Material { reflection, metallic: 0.6, roughness: 0.35, ..Material::default() };
        let single = points.map(|point| {
            let reflectance = Reflectance::of(0.0, &material);
            lit(&point, &reflectance, &material, &lighting, &mut Silent).lane(0)
        });
        for level in SimdLevel::available() {
            let level = level.resolve().unwrap();
            let lanes = dispatch!(level, simd => in_lanes(simd, &points, &material, &lighting));
            for lane in 0..16 {
                assert_eq!(
                    lanes[lane].map(f32::to_bits),
                    single[lane].map(f32::to_bits),
                    "{level:?} {:?} lane {lane}",
                    material.reflection
                );
            }
        }
    }
}

#[inline(always)]
fn bytes_in_lanes<S: Simd>(
    simd: S,
    values: &[f32; LANES],
    encoding: PictureEncoding,
) -> [u32; LANES] {
    let mut bytes = [0; LANES];
    encoding.bytes_of_lanes(f32x16::simd_from(simd, *values)).store_slice(&mut bytes);
    bytes
}

#[inline(always)]
fn words_in_lanes<S: Simd>(
    simd: S,
    values: &[f32; LANES],
    encoding: PictureEncoding,
) -> [u32; LANES] {
    let mut words = [0; LANES];
    let lanes = f32x16::simd_from(simd, *values);
    let quarter = lanes * 0.25;
    let alpha = u32x16::splat(simd, 0xAB);
    encoding.words_of_lanes([lanes, quarter, lanes * lanes], alpha).store_slice(&mut words);
    words
}

#[test]
fn sixteen_bytes_at_once_are_those_of_each_value() {
    let odd = [-1.0, -0.0, f32::NAN, -f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 0.5, 1.0];
    let most = 1.2_f32.to_bits();
    // Where a byte begins, and beside it: there roundings meet.
    let ties = (0..255_u32).flat_map(|byte| {
        let tie = ((f64::from(byte) + 0.5) / 255.0) as f32;
        (0..5).map(move |step| f32::from_bits(tie.to_bits() - 2 + step))
    });
    let floats = (0..=most).step_by(9973).map(f32::from_bits).chain(ties).chain(odd);
    let floats: Vec<f32> = floats.collect();
    for level in SimdLevel::available() {
        let level = level.resolve().expect("it is available");
        for sixteen in floats.chunks(LANES) {
            let mut values = [0.25; LANES];
            values[..sixteen.len()].copy_from_slice(sixteen);
            for encoding in [PictureEncoding::Srgb, PictureEncoding::None] {
                let bytes = dispatch!(level, simd => bytes_in_lanes(simd, &values, encoding));
                assert_eq!(
                    bytes,
                    values.map(|value| u32::from(encoding.byte(value))),
                    "{values:?}"
                );
                let words = dispatch!(level, simd => words_in_lanes(simd, &values, encoding));
                let word = |value: f32| {
                    let channels = [value, value * 0.25, value * value];
                    let [r, g, b] = channels.map(|channel| encoding.byte(channel));
                    u32::from_le_bytes([r, g, b, 0xAB])
                };
                assert_eq!(words, values.map(word), "{values:?}");
            }
        }
    }
}
