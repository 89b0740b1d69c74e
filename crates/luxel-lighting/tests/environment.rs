//! The environment's light against brute force: the split sum, and a furnace.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

use luxel_lighting::{
    Environment, EnvironmentMap, EquirectangularImage, Ledger, LightingEnvironment, Material,
    OrientedMap, Reflectance, Reflection, SurfacePoint, lit,
};
use luxel_math::Vec3;
use std::f64::consts::PI;
use std::sync::Arc;

type Direction = [f64; 3];

fn map(width: usize, light: impl Fn(Direction) -> f64) -> Environment {
    let height = width / 2;
    let texel = |at: usize| {
        let longitude = (((at % width) as f64 + 0.5) / width as f64 - 0.5) * 2.0 * PI;
        let latitude = (0.5 - ((at / width) as f64 + 0.5) / height as f64) * PI;
        let (ring, y) = (libm::cos(latitude), libm::sin(latitude));
        [light([ring * libm::cos(longitude), y, ring * libm::sin(longitude)]) as f32; 3]
    };
    let light = (0..width * height).map(texel).collect();
    let image = EquirectangularImage { width: width as u32, height: height as u32, light };
    let frame = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Environment::Map(OrientedMap::new(Arc::new(EnvironmentMap::new("test", image)), frame, 0.0))
}

/// The normal is +Y, so that the sky is above.
fn seen_at(n_dot_v: f64) -> Direction {
    [(1.0 - n_dot_v * n_dot_v).sqrt(), n_dot_v, 0.0]
}

fn terms(material: &Material, n_dot_v: f64, environment: &Environment) -> Ledger {
    let lighting = LightingEnvironment::new(&[], [0.0; 3], environment, None);
    let [x, y, z] = seen_at(n_dot_v).map(|axis| axis as f32);
    let view = Vec3::new(x, y, z);
    let point =
        SurfacePoint { position: -view, normal: Vec3::new(0.0, 1.0, 0.0), view, depth: 1.0 };
    let mut ledger = Ledger::default();
    let _ = lit(&point, &Reflectance::of(0.0, material), material, &lighting, &mut ledger);
    ledger
}

fn microfacet(roughness: f64, metallic: f32) -> Material {
    Material {
        reflection: Reflection::Microfacet,
        diffuse: [1.0; 3],
        k_s: 1.0,
        k_a: 0.0,
        roughness: roughness as f32,
        metallic,
        ..Material::default()
    }
}

/// The light that GGX facets mirror to the eye, in f64, by importance: facets chosen by D (N.H), each light
/// weighs F G (V.H) / ((N.V) (N.H)), G height-correlated.
fn brute_force(
    (roughness, f0): (f64, f64),
    n_dot_v: f64,
    count: u32,
    light: impl Fn(Direction) -> f64,
) -> f64 {
    let alpha = (roughness * roughness).max(0.002);
    let a2 = alpha * alpha;
    let v = seen_at(n_dot_v);
    let mut sum = 0.0;
    for at in 0..count {
        let a = (f64::from(at) * 0.754_877_666_246_692_7 + 0.5).fract();
        let b = (f64::from(at) * 0.569_840_290_998_053_3 + 0.5).fract();
        let n_dot_h2 = (1.0 - a) / (1.0 + (a2 - 1.0) * a);
        let (n_dot_h, sine) = (n_dot_h2.sqrt(), (1.0 - n_dot_h2).sqrt());
        let (y, x) = libm::sincos(2.0 * PI * b);
        let h = [sine * x, n_dot_h, sine * y];
        let v_dot_h = v[0] * h[0] + v[1] * h[1] + v[2] * h[2];
        let l = [0, 1, 2].map(|axis| 2.0 * v_dot_h * h[axis] - v[axis]);
        let n_dot_l = l[1];
        if n_dot_l <= 0.0 || v_dot_h <= 0.0 {
            continue;
        }
        let masking = n_dot_l * (n_dot_v * n_dot_v * (1.0 - a2) + a2).sqrt();
        let shadowing = n_dot_v * (n_dot_l * n_dot_l * (1.0 - a2) + a2).sqrt();
        let g = 2.0 * n_dot_l * n_dot_v / (masking + shadowing);
        let away = 1.0 - v_dot_h;
        let fresnel = f0 + (1.0 - f0) * away * away * away * away * away;
        sum += light(l) * fresnel * g * v_dot_h / (n_dot_v * n_dot_h);
    }
    sum / f64::from(count)
}

const ROUGHNESSES: [f64; 11] = [0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
const COSINES: [f64; 8] = [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0];

#[test]
fn the_share_of_the_split_sum_is_the_integral_over_the_facets() {
    let white = Environment::Constant([1.0; 3]);
    for (f0, metallic, color) in [(1.0, 1.0, 1.0), (0.5, 1.0, 0.5), (0.04, 0.0, 1.0)] {
        let (mut worst, mut squares) = (0.0_f64, 0.0);
        for roughness in ROUGHNESSES {
            for n_dot_v in COSINES {
                let mut material = microfacet(roughness, metallic);
                material.diffuse = [color; 3];
                let found = f64::from(terms(&material, n_dot_v, &white).environment[0]);
                let expected = brute_force((roughness, f0), n_dot_v, 40_000, |_| 1.0);
                worst = worst.max((found - expected).abs());
                squares += (found - expected) * (found - expected);
            }
        }
        let mean = (squares / (ROUGHNESSES.len() * COSINES.len()) as f64).sqrt();
        println!("F0 {f0}: worst {worst:.4}, mean square {mean:.4}");
        assert!(worst < 0.1 && mean < 0.02, "F0 {f0}: {worst} {mean}");
    }
}

#[test]
fn mirrored_skies_are_near_the_integral_over_the_facets() {
    // From a dark meadow to a bright sky, with a bright cloud.
    let sky = |[x, y, z]: Direction| {
        let t = (y * 3.0).clamp(-1.0, 1.0) * 0.5 + 0.5;
        let to_cloud = 0.48 * z - 0.6 * x + 0.64 * y;
        0.2 + 0.8 * t + 1.5 * libm::exp((to_cloud - 1.0) / 0.1)
    };
    let environment = map(256, sky);
    let mean = f64::from(environment.mean()[0]);
    // Steep views, and grazing ones: there, the round lobe reaches below the surface, where it is dark here.
    for (cosines, bounds) in [
        (&COSINES[4..], [0.01, 0.04, 0.06, 0.08, 0.05]),
        (&COSINES[..4], [0.05, 0.3, 0.55, 0.5, 0.35]),
    ] {
        for (roughness, bound) in [0.1, 0.3, 0.5, 0.7, 1.0].into_iter().zip(bounds) {
            let mut squares = 0.0;
            for &n_dot_v in cosines {
                let material = microfacet(roughness, 1.0);
                let found = f64::from(terms(&material, n_dot_v, &environment).environment[0]);
                let expected = brute_force((roughness, 1.0), n_dot_v, 100_000, sky);
                let error = (found - expected) / mean;
                squares += error * error;
            }
            let square = (squares / cosines.len() as f64).sqrt();
            println!(
                "roughness {roughness}, N.V from {}: {square:.3} of the mean light",
                cosines[0]
            );
            assert!(square < bound, "{roughness}: {square}");
        }
    }
}

#[test]
fn a_furnace_gives_no_energy_and_takes_no_more_than_one_scattering() {
    let environment = map(64, |_| 1.0);
    let (mut most, mut least) = (0.0_f64, 0.0_f64);
    for step in 0..=20 {
        let roughness = f64::from(step) / 20.0;
        for n_dot_v in COSINES {
            let metal =
                f64::from(terms(&microfacet(roughness, 1.0), n_dot_v, &environment).environment[0]);
            let single = brute_force((roughness, 1.0), n_dot_v, 20_000, |_| 1.0);
            most = most.max(metal);
            least = least.min(metal - single);
            // What a dielectric doesn't mirror, a white one reflects to all sides.
            let plastic = terms(&microfacet(roughness, 0.0), n_dot_v, &environment);
            let whole = f64::from(plastic.environment[0]);
            assert!((whole - 1.0).abs() < 2e-4, "plastic {roughness} {n_dot_v}: {whole}");
        }
    }
    println!("a white metal: at most {most:.5}, at least single scattering {least:.4}");
    assert!(most < 1.0 + 3e-3, "{most}");
    assert!(least > -0.07, "{least}");
    let white = Material {
        reflection: Reflection::Lambert,
        diffuse: [1.0; 3],
        k_a: 0.0,
        ..Material::default()
    };
    let whole = terms(&white, 0.5, &environment).environment[0];
    assert!((whole - 1.0).abs() < 1e-4, "{whole}");
}
