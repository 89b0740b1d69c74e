//! Times the lighting equation over sixteen lanes, for each kind of reflection, with one light and
//! with five, at every SIMD level.
//!
//! `cargo bench -p luxel-lighting --bench equation [-- FILTER]`; a filter is part of a row's name.
//! Prints the median and the least of some rounds, in nanoseconds a point, and the sum of all
//! light, which only a change of the equation may change.

#![allow(clippy::unwrap_used, reason = "a benchmark")]

use luxel_lighting::{
    Environment, Light, LightKind, LightingEnvironment, Material, PlacedLight, REFLECTION_MODELS,
    Reflectance, Silent, SurfacePoint, lit,
};
use luxel_math::{LANES, Simd, SimdLevel, Vec3, dispatch_long, f32x16, prelude::*};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 15;
/// Blocks of sixteen points in a round.
const BLOCKS: u32 = 4096;

/// Lights blocks of points on a ball before the eye; the sum of the light.
#[inline(always)]
fn light_blocks<S: Simd>(simd: S, material: &Material, lighting: &LightingEnvironment<'_>) -> f32 {
    let spread = |of: fn(u32) -> f32, block: u32| {
        let lanes: [f32; LANES] =
            std::array::from_fn(|lane| of(block * LANES as u32 + lane as u32));
        f32x16::simd_from(simd, lanes)
    };
    let mut sum = f32x16::splat(simd, 0.0);
    for block in 0..BLOCKS {
        let x = spread(|at| (at % 251) as f32 / 251.0 - 0.5, block);
        let y = spread(|at| (at % 239) as f32 / 239.0 - 0.5, block);
        let normal = Vec3::new(x, y, f32x16::splat(simd, 0.8)).normalized_or_zero();
        let position = normal + Vec3::splat(x, [0.0, 0.0, -3.0]);
        let view = (-position).normalized_or_zero();
        let point = SurfacePoint { position, normal, view, depth: -position.z };
        let reflectance = Reflectance::of(x, material);
        let color = lit(&point, &reflectance, material, lighting, &mut Silent);
        sum = sum + color.r + color.g + color.b;
    }
    (0..LANES).map(|lane| sum[lane]).sum()
}

fn main() {
    let filter: Option<String> =
        std::env::args().skip(1).find(|argument| !argument.starts_with('-'));
    let lights: Vec<_> = (0..5_u8)
        .map(|number| {
            let [x, y] = [f32::from(number % 2), f32::from(number / 2)].map(|way| way * 2.0 - 1.0);
            let kind = if number == 0 { LightKind::Directional } else { LightKind::Point };
            PlacedLight::new(Light::new(kind, [0.4, 0.4, 0.3]), [x, y, -1.0], [-0.4, -0.6, -1.0])
        })
        .collect();
    let mut seen = Vec::new();
    for level in SimdLevel::available() {
        let level = level.resolve().unwrap();
        // A name may stand for another level.
        let told = SimdLevel::name_of(level);
        if seen.contains(&told) {
            continue;
        }
        seen.push(told);
        for model in REFLECTION_MODELS {
            let reflection = model.reflection.clone();
            let material = Material { reflection, ..Material::default() };
            for count in [1, 5] {
                let name = format!("{} x{count} {told}", model.name);
                if filter.as_ref().is_some_and(|filter| !name.contains(filter.as_str())) {
                    continue;
                }
                let lighting =
                    LightingEnvironment::new(&lights[..count], [0.1; 3], &Environment::None, None);
                let mut sum = 0.0;
                let mut times: Vec<f64> = (0..ROUNDS)
                    .map(|_| {
                        let (material, lighting) = black_box((&material, &lighting));
                        let start = Instant::now();
                        sum = dispatch_long!(level, simd => light_blocks(simd, material, lighting));
                        start.elapsed().as_secs_f64() * 1e9 / f64::from(BLOCKS * LANES as u32)
                    })
                    .collect();
                times.sort_by(f64::total_cmp);
                let [median, least] = [times[ROUNDS / 2], times[0]];
                println!("{name:28} {median:8.2} ns a point (least {least:.2})  {sum}");
            }
        }
    }
}
