//! Physical laws and published claims: reciprocity, energy, the fit of the split sum, the studio.

use luxel_lighting::*;
use luxel_math::Vec3;
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

fn material(reflection: Reflection, roughness: f32, metallic: f32, color: f32) -> Material {
    Material {
        reflection,
        diffuse: [color; 3],
        k_s: 1.0,
        roughness,
        metallic,
        ..Material::default()
    }
}

/// A direction at this cosine to the normal, which is +Z.
fn direction(cosine: f64, azimuth: f64) -> [f32; 3] {
    let sine = (1.0 - cosine * cosine).sqrt();
    [(sine * libm::cos(azimuth)) as f32, (sine * libm::sin(azimuth)) as f32, cosine as f32]
}

fn vec3([x, y, z]: [f32; 3]) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

/// Diffuse and specular light of a unit light from `to_light` towards `view`.
fn sent(material: &Material, to_light: [f32; 3], view: [f32; 3]) -> [f64; 2] {
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], to_light.map(|c| -c))];
    let lighting = LightingEnvironment::new(&lights, [0.0; 3], &Environment::None, None);
    let mut ledger = Ledger::default();
    let _ = lit(&point(view), &Reflectance::of(0.0, material), material, &lighting, &mut ledger);
    let terms = &ledger.lights[0].terms;
    [f64::from(terms.diffuse.r), f64::from(terms.specular.r)]
}

fn point(view: [f32; 3]) -> SurfacePoint<f32> {
    SurfacePoint {
        position: -vec3(view),
        normal: Vec3::new(0.0, 0.0, 1.0),
        view: vec3(view),
        depth: 1.0,
    }
}

/// The part of the light from all around that goes to the eye, or, by reciprocity, of a beam that
/// goes anywhere: 1/pi times the integral over the hemisphere, diffuse and specular.
fn albedo(material: &Material, n_dot_v: f64) -> [f64; 2] {
    const RINGS: usize = 400;
    const SPOKES: usize = 256;
    let view = direction(n_dot_v, 0.0);
    let mut sum = [0.0; 2];
    for ring in 0..RINGS {
        // Even steps of the angle, so that the rings are dense where lobes are narrow.
        let theta = (ring as f64 + 0.5) / RINGS as f64 * (PI / 2.0);
        let band = libm::sin(theta) * (PI / 2.0 / RINGS as f64);
        for spoke in 0..SPOKES {
            // Dense opposite the eye, where the mirrored lobe is narrow at grazing angles.
            let t = 2.0 * (spoke as f64 + 0.5) / SPOKES as f64 - 1.0;
            let azimuth = PI + PI * t * t * t;
            let solid = band * 3.0 * PI * t * t * (2.0 / SPOKES as f64);
            let part = sent(material, direction(libm::cos(theta), azimuth), view);
            sum = [sum[0] + part[0] * solid, sum[1] + part[1] * solid];
        }
    }
    sum.map(|whole| whole / PI)
}

proptest! {
    #[test]
    fn light_and_eye_can_change_places(
        a in (0.05..1.0_f64, 0.0..TAU),
        b in (0.05..1.0_f64, 0.0..TAU),
        roughness in 0.2..1.0_f32,
        metallic in 0.0..1.0_f32,
    ) {
        let (to_light, view) = (direction(a.0, a.1), direction(b.0, b.1));
        for reflection in [Reflection::Lambert, Reflection::OrenNayar, Reflection::Microfacet] {
            let material = material(reflection, roughness, metallic, 0.8);
            let forth = sent(&material, to_light, view);
            let back = sent(&material, view, to_light);
            for (forth, back) in forth.into_iter().zip(back) {
                // Without the light's own cosine.
                let (forth, back) = (forth / a.0, back / b.0);
                prop_assert!(
                    (forth - back).abs() <= 2e-4 * forth.max(1.0),
                    "{:?} {forth} {back}", material.reflection
                );
            }
        }
    }
}

#[test]
fn no_surface_sends_more_than_it_gets() {
    for n_dot_v in [0.1, 0.4, 0.7, 1.0] {
        for roughness in [0.2, 0.5, 1.0] {
            let rough = material(Reflection::OrenNayar, roughness, 0.0, 1.0);
            let [diffuse, _] = albedo(&rough, n_dot_v);
            // The qualitative model is a fit, which is a little too bright at grazing angles.
            assert!(diffuse < 1.02 && diffuse > 0.5, "Oren-Nayar {roughness} {n_dot_v}: {diffuse}");
            // A white metal: F = 1. The missing energy would be reflected more than once.
            let metal = material(Reflection::Microfacet, roughness, 1.0, 1.0);
            let [diffuse, specular] = albedo(&metal, n_dot_v);
            assert_eq!(diffuse, 0.0);
            assert!(specular < 1.005, "metal {roughness} {n_dot_v}: {specular}");
            let least = if roughness < 0.3 { 0.92 } else { 0.3 };
            assert!(specular > least, "metal {roughness} {n_dot_v}: {specular}");
            // glTF promises it of specular light alone: at grazing angles its diffuse light,
            // weakened by F at V.H and not at N.V, comes on top.
            let plastic = material(Reflection::Microfacet, roughness, 0.0, 1.0);
            let [diffuse, specular] = albedo(&plastic, n_dot_v);
            assert!(specular < 0.7 && diffuse < 0.97, "plastic {roughness} {n_dot_v}");
            let whole = diffuse + specular;
            assert!(whole > 0.7, "plastic {roughness} {n_dot_v}: {whole}");
            assert!(n_dot_v < 0.6 || whole < 1.02, "plastic {roughness} {n_dot_v}: {whole}");
        }
    }
    let white = material(Reflection::Lambert, 1.0, 0.0, 1.0);
    assert!((albedo(&white, 0.5)[0] - 1.0).abs() < 1e-4);
}

/// The reflection of a white environment.
fn mirrored(material: &Material, n_dot_v: f64) -> f64 {
    let lighting = LightingEnvironment::new(&[], [0.0; 3], &Environment::Constant([1.0; 3]), None);
    let mut ledger = Ledger::default();
    let reflectance = Reflectance::of(0.0, material);
    let view = direction(n_dot_v, 0.0);
    let _ = lit(&point(view), &reflectance, material, &lighting, &mut ledger);
    f64::from(ledger.environment[0])
}

#[test]
fn what_is_mirrored_of_a_white_world_is_what_lights_all_around_would_give() {
    let mut worst = 0.0_f64;
    for n_dot_v in [0.2, 0.5, 0.8, 1.0] {
        for roughness in [0.2, 0.4, 0.7, 1.0] {
            for (metallic, color) in [(0.0, 0.5), (1.0, 0.5), (1.0, 1.0)] {
                let material = material(Reflection::Microfacet, roughness, metallic, color);
                let [_, integral] = albedo(&material, n_dot_v);
                let fit = mirrored(&material, n_dot_v);
                worst = worst.max((fit - integral).abs());
            }
        }
    }
    assert!(worst < 0.06, "{worst}");
}

#[test]
fn an_ideal_mirror_shows_the_environment_in_its_own_colour() {
    let material = Material {
        reflection: Reflection::Mirror,
        specular: [1.0, 0.5, 0.0],
        k_s: 0.8,
        ..Material::default()
    };
    let lighting =
        LightingEnvironment::new(&[], [0.0; 3], &Environment::Constant([0.5, 1.0, 2.0]), None);
    let mut reflectance = Reflectance::of(0.0, &material);
    reflectance.occlusion = 0.5;
    let view = direction(0.6, 0.3);
    let color = lit(&point(view), &reflectance, &material, &lighting, &mut Silent);
    assert_eq!(color.lane(0), [0.2, 0.2, 0.0]);
}

#[test]
fn an_environment_takes_the_place_of_ambient_light_on_metals_alone() {
    let ambient = |environment, metallic| {
        let material = material(Reflection::Microfacet, 0.5, metallic, 0.5);
        let lighting = LightingEnvironment::new(&[], [0.4; 3], environment, None);
        let mut ledger = Ledger::default();
        let reflectance = Reflectance::of(0.0, &material);
        let view = direction(1.0, 0.0);
        let _ = lit(&point(view), &reflectance, &material, &lighting, &mut ledger);
        ledger.scene_ambient[0]
    };
    let studio = Environment::Studio { up: [0.0, 1.0, 0.0] };
    assert_eq!(ambient(&Environment::None, 1.0), 0.2);
    assert_eq!(ambient(&studio, 1.0), 0.0);
    assert_eq!(ambient(&studio, 0.0), 0.2);
}

#[test]
fn the_studio_is_bright_above_dark_below_and_blurred_by_roughness() {
    let studio = Environment::Studio { up: [0.0, 0.0, 1.0] };
    let at =
        |height: f64, roughness: f32| studio.radiance(vec3(direction(height, 0.7)), roughness).g;
    for roughness in [0.0, 0.3, 0.6, 1.0] {
        let mut before = at(-1.0, roughness);
        for step in -999..=1000 {
            let now = at(f64::from(step) / 1000.0, roughness);
            assert!((now - before).abs() < 0.01, "a jump at {step}");
            before = now;
        }
        assert!(at(1.0, roughness) > 1.5 * at(-1.0, roughness));
    }
    let contrast = |roughness| at(1.0, roughness) / at(-1.0, roughness);
    assert!(contrast(0.0) > 20.0);
    assert!(contrast(0.0) > contrast(0.7) && contrast(0.7) > contrast(1.0));
}

#[test]
fn a_mix_of_one_model_is_that_model() {
    for model in REFLECTION_MODELS {
        let reflection = model.reflection.clone();
        assert_eq!(Reflection::mixed(vec![(reflection.clone(), 1.0)]), reflection);
        let inner = Reflection::mixed(vec![(reflection.clone(), 0.5)]);
        assert_eq!(Reflection::mixed(vec![(inner, 2.0)]), reflection, "{}", model.name);
    }
    let half = vec![(Reflection::Unlit, 0.5)];
    assert_eq!(Reflection::mixed(half.clone()), Reflection::Mixed(half));
}

#[test]
fn a_mix_within_a_mix_is_dissolved_with_its_weight() {
    let inner = Reflection::mixed(vec![(Reflection::Phong, 0.5), (Reflection::Retro, 0.25)]);
    let mixed = Reflection::mixed(vec![(inner, 0.5), (Reflection::Mirror, 1.0)]);
    let expected =
        vec![(Reflection::Phong, 0.25), (Reflection::Retro, 0.125), (Reflection::Mirror, 1.0)];
    assert_eq!(mixed, Reflection::Mixed(expected));
}
