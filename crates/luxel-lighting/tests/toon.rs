//! The model `toon`: its tones, their thresholds, and its formula.

mod naive;

use luxel_lighting::*;
use luxel_math::Vec3;
use naive::{V, bidirectional, plus, unit, wide};
use std::collections::BTreeSet;

fn material(steps: f32, k_s: f32) -> Material {
    let reflection = Reflection::Toon { steps };
    Material { reflection, diffuse: [1.0; 3], k_s, shininess: 8.0, ..Material::default() }
}

/// The reflected light of intensity 1 from this direction, at a point that faces the eye.
fn sent(material: &Material, to_light: V) -> [f32; 3] {
    let facing = Vec3::new(0.0, 0.0, 1.0);
    let position = Vec3::new(0.0, 0.0, -5.0);
    let point = SurfacePoint { position, normal: facing, view: facing, depth: 5.0 };
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], to_light.map(|c| -c as f32))];
    let around = LightingEnvironment::new(&lights, [0.0; 3], &Environment::None, None);
    lit(&point, &Reflectance::of(0.0, material), material, &around, &mut Silent).lane(0)
}

/// A direction so many degrees from the normal.
fn aside(degrees: f64) -> V {
    let angle = degrees.to_radians();
    [-libm::sin(angle), 0.0, libm::cos(angle)]
}

#[test]
fn as_many_tones_above_black_as_there_are_steps() {
    for steps in [1.0, 2.0, 3.0, 16.0, 64.0] {
        let lit = (0..=3000).map(|at| sent(&material(steps, 0.0), aside(f64::from(at) * 0.03)));
        let tones: BTreeSet<u32> = lit.map(|[tone, ..]| tone.to_bits()).collect();
        let expected = (0..=steps as u8).map(|tone| (f32::from(tone) / steps).to_bits());
        assert_eq!(tones, expected.collect(), "{steps}");
    }
}

#[test]
fn one_step_is_lit_where_the_light_is_within_60_degrees_of_the_normal() {
    let tones =
        [0.0, 59.9, 60.1, 120.0].map(|degrees| sent(&material(1.0, 0.0), aside(degrees))[0]);
    assert_eq!(tones, [1.0, 1.0, 0.0, 0.0]);
}

#[test]
fn the_formula_holds_away_from_the_thresholds() {
    let facing = [0.0, 0.0, 1.0];
    for steps in [1.0, 3.0, 5.0] {
        let material = material(steps, 0.5);
        let mut compared = 0;
        for at in 0..200 {
            let (x, y) = (f64::from(at % 20) * 0.1 - 1.0, f64::from(at / 20) * 0.2 - 1.0);
            let to_light = unit([x, y, 0.8]);
            let [_, _, n_dot_h] = unit(plus(to_light, facing));
            let is_near = |value: f64| {
                let scaled = value * f64::from(steps) + 0.5;
                (scaled - scaled.round()).abs() < 1e-4
            };
            if is_near(to_light[2]) || is_near(libm::pow(n_dot_h, 8.0)) {
                continue;
            }
            compared += 1;
            let reflectance = Reflectance::of(0.0, &material);
            let (diffuse, specular) = bidirectional(
                &material.reflection,
                &reflectance,
                &material,
                facing,
                facing,
                to_light,
            );
            let errors = wide(sent(&material, to_light)).into_iter().zip(plus(diffuse, specular));
            for (color, exact) in errors {
                assert!((color - exact).abs() < 1e-5, "{steps} {to_light:?}: {color} {exact}");
            }
        }
        assert!(compared > 150, "{compared}");
    }
}

#[test]
fn numbers_of_steps_that_make_no_sense_are_brought_into_their_range() {
    let tones = [f32::NAN, f32::NEG_INFINITY, 0.0, 1e30, 2.4]
        .map(|steps| sent(&material(steps, 0.0), aside(45.0))[0]);
    let expected =
        [3.0, 1.0, 1.0, 64.0, 2.0].map(|steps| sent(&material(steps, 0.0), aside(45.0))[0]);
    assert_eq!(tones, expected);
}
