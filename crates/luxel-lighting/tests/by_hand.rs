//! The equation against values worked out by hand.

mod naive;

use luxel_lighting::*;
use luxel_math::{Rgb, Vec3};
use naive::{facing_light, models};

/// A point at the origin that faces the eye and the light.
fn facing_point() -> SurfacePoint<f32> {
    SurfacePoint {
        position: Vec3::new(0.0, 0.0, -5.0),
        normal: Vec3::new(0.0, 0.0, 1.0),
        view: Vec3::new(0.0, 0.0, 1.0),
        depth: 5.0,
    }
}

fn white(reflection: Reflection) -> Material {
    Material { reflection, diffuse: [1.0; 3], k_s: 0.0, roughness: 0.0, ..Material::default() }
}

fn lighting(lights: &[PlacedLight]) -> LightingEnvironment<'_> {
    LightingEnvironment::new(lights, [0.0; 3], &Environment::None, None)
}

fn shade(
    point: &SurfacePoint<f32>,
    material: &Material,
    around: &LightingEnvironment<'_>,
) -> [f32; 3] {
    lit(point, &Reflectance::of(0.0, material), material, around, &mut Silent).lane(0)
}

#[test]
fn a_white_surface_facing_a_unit_light_sends_one() {
    let lights = [facing_light()];
    for reflection in
        [Reflection::Lambert, Reflection::OrenNayar, Reflection::Phong, Reflection::BlinnPhong]
    {
        let color = shade(&facing_point(), &white(reflection.clone()), &lighting(&lights));
        assert_eq!(color, [1.0; 3], "{reflection:?}");
    }
    // Of a dielectric, 4 % are mirrored, not scattered.
    let color = shade(&facing_point(), &white(Reflection::Microfacet), &lighting(&lights));
    assert!((color[0] - 0.96).abs() < 1e-6);
    // Without lights, an unlit surface is as bright.
    assert_eq!(shade(&facing_point(), &white(Reflection::Unlit), &lighting(&[])), [1.0; 3]);
}

#[test]
fn phong_and_blinn_at_sixty_degrees_are_what_the_formulas_give_by_hand() {
    // L is 60 degrees from N = V: N.L = 1/2, R.V = 1/2, N.H = cos 30.
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], [-(0.75_f32.sqrt()), 0.0, -0.5])];
    let material = |reflection| Material {
        reflection,
        diffuse: [0.5; 3],
        k_s: 1.0,
        shininess: 2.0,
        ..Material::default()
    };
    let around = lighting(&lights);
    let [phong, ..] = shade(&facing_point(), &material(Reflection::Phong), &around);
    assert!((phong - (0.25 + 0.25)).abs() < 1e-6, "{phong}");
    let [blinn, ..] = shade(&facing_point(), &material(Reflection::BlinnPhong), &around);
    assert!((blinn - (0.25 + 0.75)).abs() < 1e-6, "{blinn}");
    let [retro, ..] = shade(&facing_point(), &material(Reflection::Retro), &around);
    assert!((retro - (0.25 + 0.25)).abs() < 1e-6, "{retro}");
}

#[test]
fn a_red_light_on_a_green_surface_is_black() {
    let light = Light::new(LightKind::Directional, [1.0, 0.0, 0.0]);
    let lights = [PlacedLight::new(light, [0.0; 3], [0.0, 0.0, -1.0])];
    for reflection in models() {
        if reflection == Reflection::Unlit || reflection == Reflection::Microfacet {
            continue;
        }
        let material = Material {
            reflection,
            diffuse: [0.0, 1.0, 0.0],
            specular: [0.0, 1.0, 0.0],
            ..Material::default()
        };
        assert_eq!(shade(&facing_point(), &material, &lighting(&lights)), [0.0; 3]);
    }
}

#[test]
fn a_model_describes_the_parameters_that_change_its_light_and_no_others() {
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], [0.4, 0.3, -1.0])];
    let environment = Environment::Studio { up: [0.0, 1.0, 0.0] };
    let around = LightingEnvironment::new(&lights, [0.2; 3], &environment, None);
    for reflection in models() {
        let material = Material {
            reflection,
            k_a: 0.5,
            k_d: 0.5,
            k_s: 0.5,
            shininess: 8.0,
            roughness: 0.5,
            metallic: 0.5,
            ..Material::default()
        };
        let before = shade(&facing_point(), &material, &around);
        for parameter in parameters() {
            let mut changed = material.clone();
            let value = parameter.range[0];
            match parameter.name {
                "ka" => changed.k_a = value,
                "kd" => changed.k_d = value,
                "ks" => changed.k_s = value,
                "shininess" => changed.shininess = value,
                "roughness" => changed.roughness = value,
                "metallic" => changed.metallic = value,
                own => changed.reflection.set_own(own, value),
            }
            let is_other = shade(&facing_point(), &changed, &around) != before;
            let heeds = material.reflection.heeds(parameter);
            assert_eq!(is_other, heeds, "{} of {:?}", parameter.name, material.reflection);
        }
    }
}

#[test]
fn a_light_behind_the_surface_adds_no_highlight_and_reports_its_cosine() {
    let light = Light::new(LightKind::Directional, [1.0; 3]);
    let lights = [PlacedLight::new(light, [0.0; 3], [0.1, 0.0, 1.0])];
    for reflection in models() {
        // A shininess of 0 makes every highlight 1 but where the light is behind.
        let material = Material { reflection, k_s: 1.0, shininess: 0.0, ..Material::default() };
        let mut ledger = Ledger::default();
        let _ = lit(
            &facing_point(),
            &Reflectance::of(0.0, &material),
            &material,
            &lighting(&lights),
            &mut ledger,
        );
        let terms = &ledger.lights[0].terms;
        assert_eq!(terms.diffuse.lane(0), [0.0; 3]);
        assert_eq!(terms.specular.lane(0), [0.0; 3]);
        assert!(terms.n_dot_l < -0.9);
    }
}

#[test]
fn a_light_at_the_surface_itself_adds_nothing() {
    for kind in
        [LightKind::Point, LightKind::Spot(Cone::Exponent { cos_cutoff: 0.5, exponent: 3.0 })]
    {
        for attenuation in [Attenuation::NONE, Attenuation::INVERSE_SQUARE] {
            let light = Light { ambient: [1.0; 3], attenuation, ..Light::new(kind, [1.0; 3]) };
            let lights = [PlacedLight::new(light, [0.0, 0.0, -5.0], [0.0, 0.0, -1.0])];
            for reflection in models() {
                let unlit = reflection == Reflection::Unlit;
                let material = Material { reflection, shininess: 0.0, ..Material::default() };
                let color = shade(&facing_point(), &material, &lighting(&lights));
                assert!(unlit || color == [0.0; 3], "{material:?} {color:?}");
            }
        }
    }
}

#[test]
fn the_inside_of_a_cone_is_lit_and_the_outside_is_not() {
    let at = |degrees: f64, cone| {
        let light = Light::new(LightKind::Spot(cone), [1.0; 3]);
        let direction = [libm::sin(degrees.to_radians()) as f32, 0.0, {
            -libm::cos(degrees.to_radians()) as f32
        }];
        let lights = [PlacedLight::new(light, [0.0; 3], direction)];
        shade(&facing_point(), &white(Reflection::Lambert), &lighting(&lights))[0]
    };
    let cosine = |degrees: f64| libm::cos(degrees.to_radians()) as f32;
    let cone = Cone::Exponent { cos_cutoff: cosine(30.0), exponent: 2.0 };
    assert_eq!(at(30.1, cone), 0.0);
    assert!((at(29.9, cone) - cosine(29.9) * cosine(29.9)).abs() < 1e-6);
    let open = Cone::Exponent { cos_cutoff: -1.0, exponent: 0.0 };
    assert_eq!(at(180.0, open), 1.0);
    let smooth = Cone::Smooth { cos_inner: cosine(20.0), cos_outer: cosine(40.0) };
    assert_eq!(at(19.9, smooth), 1.0);
    assert_eq!(at(40.1, smooth), 0.0);
}

#[test]
fn attenuation_follows_its_law_and_is_not_cut_at_one() {
    for (coefficients, expected) in [
        ([1.0, 0.0, 0.0], 1.0),
        ([0.0, 0.0, 1.0], 0.04),
        ([1.0, 2.0, 3.0], 1.0 / 86.0),
        ([0.25, 0.0, 0.0], 4.0),
        ([-1.0, 0.0, 0.0], 0.0),
        ([0.0, 0.0, 0.0], 0.0),
    ] {
        let light = Light {
            attenuation: Attenuation::new(coefficients),
            ..Light::new(LightKind::Point, [1.0; 3])
        };
        let lights = [PlacedLight::new(light, [0.0; 3], [0.0; 3])];
        let [value, ..] = shade(&facing_point(), &white(Reflection::Lambert), &lighting(&lights));
        assert!((value - expected).abs() < 1e-6, "{coefficients:?}: {value}");
    }
}

#[test]
fn attenuation_is_cut_at_its_limit_and_only_there() {
    let at_distance_5 = |coefficients, limit| {
        let light = Light {
            attenuation: Attenuation { limit, ..Attenuation::new(coefficients) },
            ..Light::new(LightKind::Point, [1.0; 3])
        };
        let lights = [PlacedLight::new(light, [0.0; 3], [0.0; 3])];
        shade(&facing_point(), &white(Reflection::Lambert), &lighting(&lights))[0]
    };
    assert_eq!(at_distance_5([0.25, 0.0, 0.0], 1.0), 1.0, "4 cut at 1, as Foley et al. have it");
    assert_eq!(at_distance_5([0.25, 0.0, 0.0], 2.5), 2.5);
    assert_eq!(at_distance_5([0.25, 0.0, 0.0], f32::NAN), 0.0);
    assert!((at_distance_5([0.0, 0.0, 1.0], 1.0) - 0.04).abs() < 1e-7, "below 1 nothing is cut");
}

#[test]
fn fog_meets_its_ends_and_its_laws() {
    let fog = |law| Fog { color: [0.2, 0.4, 0.8], law };
    let cue = fog(FogLaw::DepthCue { near: 2.0, far: 10.0, front: 0.9, back: 0.1 });
    assert_eq!(cue.factor(1.0_f32), 0.9);
    assert_eq!(cue.factor(2.0_f32), 0.9);
    assert_eq!(cue.factor(6.0_f32), 0.5);
    assert_eq!(cue.factor(10.0_f32), 0.1);
    assert_eq!(cue.factor(f32::INFINITY), 0.1);
    let step = fog(FogLaw::DepthCue { near: 2.0, far: 2.0, front: 1.0, back: 0.0 });
    assert_eq!((step.factor(1.9_f32), step.factor(2.0_f32)), (1.0, 0.0));
    let thin = fog(FogLaw::Exponential { density: 0.5 });
    assert!((thin.factor(2.0_f32) - 0.367_879_45).abs() < 1e-6);
    let thick = fog(FogLaw::ExponentialSquared { density: 0.5 });
    assert!((thick.factor(2.0_f32) - 0.367_879_45).abs() < 1e-6);

    let mut ledger = Ledger::default();
    let veiled = cue.veiled(Rgb::new(1.0, 1.0, 1.0), 6.0, &mut ledger);
    assert_eq!(veiled.lane(0), [0.6, 0.7, 0.9]);
    assert_eq!(ledger.fog, Some((0.5, [0.2, 0.4, 0.8])));
}

#[test]
fn the_ledgers_terms_add_up_to_the_colour_bit_by_bit() {
    let fog = Fog {
        color: [0.3, 0.3, 0.4],
        law: FogLaw::DepthCue { near: 1.0, far: 20.0, front: 1.0, back: 0.2 },
    };
    let light = Light { ambient: [0.1, 0.2, 0.3], ..Light::new(LightKind::Point, [0.7; 3]) };
    let lights = [facing_light(), PlacedLight::new(light, [1.0, 2.0, -3.0], [0.0; 3])];
    let around = LightingEnvironment::new(
        &lights,
        [0.05, 0.06, 0.07],
        &Environment::Studio { up: [0.0, 1.0, 0.0] },
        Some(&fog),
    );
    for reflection in models() {
        let material = Material {
            reflection,
            emission: [0.01, 0.02, 0.0],
            metallic: 0.4,
            roughness: 0.5,
            ..Material::default()
        };
        let reflectance = Reflectance::of(0.0, &material);
        let mut ledger = Ledger::default();
        let color = lit(&facing_point(), &reflectance, &material, &around, &mut ledger);
        let silent = lit(&facing_point(), &reflectance, &material, &around, &mut Silent);
        assert_eq!(color, silent);
        assert_eq!(ledger.color, color.lane(0));
        assert_eq!(ledger.lights.len(), 2);
        for c in 0..3 {
            let mut sum = ledger.emission[c] + ledger.scene_ambient[c];
            for light in &ledger.lights {
                let terms = &light.terms;
                for term in [terms.ambient, terms.diffuse, terms.specular] {
                    sum += term.lane(0)[c];
                }
            }
            sum += ledger.environment[c];
            assert_eq!(sum.to_bits(), ledger.sum[c].to_bits());
            let (s, fog_color) = ledger.fog.unwrap();
            assert_eq!(sum * s + fog_color[c] * (1.0 - s), ledger.color[c]);
        }
    }
}
