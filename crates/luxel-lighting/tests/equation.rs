//! The equation against its naive double, with any light, material and place.

mod naive;

use luxel_lighting::*;
use luxel_math::Vec3;
use naive::{models, steady_models, wide};
use proptest::prelude::*;

fn unit_vector() -> impl Strategy<Value = [f32; 3]> {
    (-1.0..1.0_f64, 0.0..std::f64::consts::TAU).prop_map(|(z, phi)| {
        let r = (1.0 - z * z).sqrt();
        [(r * libm::cos(phi)) as f32, (r * libm::sin(phi)) as f32, z as f32]
    })
}

fn vec3([x, y, z]: [f32; 3]) -> Vec3<f32> {
    Vec3::new(x, y, z)
}

fn color() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(0.0..1.5_f32)
}

fn any_light() -> impl Strategy<Value = PlacedLight> {
    let kind = prop_oneof![
        Just(LightKind::Directional),
        Just(LightKind::Point),
        (0.0..0.95_f32, 0.0..20.0_f32)
            .prop_map(|(cos_cutoff, exponent)| Cone::Exponent { cos_cutoff, exponent })
            .prop_map(LightKind::Spot),
        (0.5..0.7_f32, 0.8..0.95_f32)
            .prop_map(|(cos_outer, cos_inner)| Cone::Smooth { cos_inner, cos_outer })
            .prop_map(LightKind::Spot),
    ];
    let limit = prop_oneof![Just(Attenuation::NO_LIMIT), Just(1.0_f32), 0.1..2.0_f32];
    let range = prop::option::of(5.0..50.0_f32);
    let attenuation = (prop::array::uniform3(0.1..1.0_f32), limit, range)
        .prop_map(|(coefficients, limit, range)| Attenuation { coefficients, limit, range });
    (
        kind,
        (color(), color(), color()),
        attenuation,
        prop::array::uniform3(-4.0..4.0_f32),
        unit_vector(),
    )
        .prop_map(|(kind, (ambient, diffuse, specular), attenuation, position, direction)| {
            PlacedLight::new(
                Light {
                    kind,
                    ambient,
                    diffuse,
                    specular,
                    attenuation,
                    ..Light::new(kind, [0.0; 3])
                },
                position,
                direction,
            )
        })
}

fn any_material() -> impl Strategy<Value = Material> {
    (
        prop::sample::select(steady_models()),
        (prop::option::of(color()), color(), color(), color()),
        prop::array::uniform3(0.0..1.0_f32),
        0.0..200.0_f32,
        0.0..1.0_f32,
        0.05..1.0_f32,
    )
        .prop_map(|(reflection, colors, k, shininess, metallic, roughness)| Material {
            reflection,
            ambient: colors.0,
            diffuse: colors.1.map(|c| c / 1.5),
            specular: colors.2,
            emission: colors.3,
            k_a: k[0],
            k_d: k[1],
            k_s: k[2],
            shininess,
            metallic,
            roughness,
        })
}

/// The required accuracy of every term: 2e-4 relative, or 2e-5 absolute.
fn close(value: [f32; 3], exact: naive::V) -> bool {
    close_within(value, exact, [0.0; 3])
}

/// [`close`], or off by no more than `slack`.
fn close_within(value: [f32; 3], exact: naive::V, slack: naive::V) -> bool {
    wide(value).into_iter().zip(exact).zip(slack).all(|((value, exact), slack)| {
        let error = (value - exact).abs();
        error <= 2e-4 * exact.abs() + slack || error <= 2e-5
    })
}

/// What a value changes by where the normal is a rounding step longer along each axis: no f32 knows the cosine of a
/// narrow highlight better.
fn by_rounding(
    point: &SurfacePoint<f32>,
    equation: impl Fn(&SurfacePoint<f32>) -> naive::V,
) -> naive::V {
    let exact = equation(point);
    let mut change = [0.0; 3];
    for axis in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let normal = point.normal + vec3(axis) * f32::EPSILON;
        let moved = equation(&SurfacePoint { normal, ..*point });
        for channel in 0..3 {
            change[channel] += (moved[channel] - exact[channel]).abs();
        }
    }
    change
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_term_agrees_with_the_naive_equation(
        material in any_material(),
        lights in prop::collection::vec(any_light(), 0..4),
        scene_ambient in color(),
        normal in unit_vector(),
        position in prop::array::uniform3(-4.0..4.0_f32),
        density in 0.0..0.5_f32,
        law in 0..3,
    ) {
        let view = (-vec3(position)).normalized_or_zero();
        // The side that is seen.
        let turned = vec3(normal).dot(view) < 0.0;
        let normal = if turned { -vec3(normal) } else { vec3(normal) };
        let point = SurfacePoint { position: vec3(position), normal, view, depth: 4.0 };
        let reflectance = Reflectance::of(0.0, &material);
        let law = match law {
            0 => FogLaw::DepthCue { near: 1.0, far: 9.0, front: 1.0, back: density },
            1 => FogLaw::Exponential { density },
            _ => FogLaw::ExponentialSquared { density },
        };
        let fog = Fog { color: [0.5; 3], law };
        let around = LightingEnvironment::new(&lights, scene_ambient, &Environment::None, Some(&fog));
        let mut ledger = Ledger::default();
        let color = lit(&point, &reflectance, &material, &around, &mut ledger);
        let exact = naive::equation(&point, &reflectance, &material, &around);
        // The edge of a cone is a jump: either side of it may be meant.
        for (light, other) in ledger.lights.iter().zip(&exact.lights) {
            prop_assume!((light.terms.spot == 0.0) == (other.spot == 0.0));
            prop_assume!(other.n_dot_l.abs() > 1e-6);
        }
        prop_assert!(close(ledger.emission, exact.emission));
        prop_assert!(close(ledger.scene_ambient, exact.scene_ambient));
        let equation = |point: &_| naive::equation(point, &reflectance, &material, &around);
        for (number, (light, other)) in ledger.lights.iter().zip(&exact.lights).enumerate() {
            let terms = &light.terms;
            prop_assert!(close([terms.attenuation; 3], [other.attenuation; 3]));
            prop_assert!(close([terms.spot; 3], [other.spot; 3]));
            prop_assert!(close([terms.n_dot_l; 3], [other.n_dot_l; 3]));
            prop_assert!(close(terms.ambient.lane(0), other.ambient));
            prop_assert!(close(terms.diffuse.lane(0), other.diffuse));
            let slack = by_rounding(&point, |point| equation(point).lights[number].specular);
            prop_assert!(
                close_within(terms.specular.lane(0), other.specular, slack),
                "{:?} {:?}", terms, other.specular
            );
        }
        let slack = by_rounding(&point, |point| equation(point).color);
        prop_assert!(close_within(color.lane(0), exact.color, slack));
    }
}

fn extreme() -> impl Strategy<Value = f32> {
    prop_oneof![
        Just(0.0),
        Just(-0.0),
        Just(1.0),
        Just(-1.0),
        Just(f32::MAX),
        Just(f32::MIN),
        Just(f32::MIN_POSITIVE),
        Just(1e-45),
        Just(f32::INFINITY),
        Just(f32::NEG_INFINITY),
        Just(f32::NAN),
        any::<f32>(),
        -2.0..2.0_f32,
    ]
}

fn sound_unit(direction: [f32; 3]) -> Vec3<f32> {
    vec3(direction.map(|c| if c.is_finite() { c } else { 0.0 })).normalized_or_zero()
}

fn extreme3() -> impl Strategy<Value = [f32; 3]> {
    prop::array::uniform3(extreme())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20_000))]

    #[test]
    fn no_input_however_mad_makes_a_nan_or_an_infinity(
        reflection in prop::sample::select(models()),
        colors in prop::array::uniform4(extreme3()),
        numbers in prop::array::uniform6(extreme()),
        light_colors in prop::array::uniform3(extreme3()),
        attenuation in extreme3(),
        range in prop::option::of(extreme()),
        cone in (extreme(), extreme(), any::<bool>()),
        kind in 0..3_usize,
        places in prop::array::uniform5(extreme3()),
        fog in (extreme3(), extreme(), extreme(), extreme(), 0..3),
        around in (extreme3(), 0..3, extreme()),
        occlusion in extreme(),
    ) {
        let material = Material {
            reflection,
            ambient: Some(colors[0]), diffuse: colors[1], specular: colors[2], emission: colors[3],
            k_a: numbers[0], k_d: numbers[1], k_s: numbers[2],
            shininess: numbers[3], metallic: numbers[4], roughness: numbers[5],
        };
        let cone = if cone.2 {
            Cone::Exponent { cos_cutoff: cone.0, exponent: cone.1 }
        } else {
            Cone::Smooth { cos_inner: cone.0, cos_outer: cone.1 }
        };
        let kind = [LightKind::Directional, LightKind::Point, LightKind::Spot(cone)][kind];
        let light = Light {
            kind, ambient: light_colors[0], diffuse: light_colors[1], specular: light_colors[2],
            attenuation: Attenuation { coefficients: attenuation, limit: numbers[5], range },
            ..Light::new(LightKind::Point, [0.0; 3])
        };
        let lights = [PlacedLight::new(light, places[0], places[1])];
        // The contract requires unit vectors; degenerate ones become 0.
        let point = SurfacePoint {
            position: vec3(places[2]),
            normal: sound_unit(places[3]),
            view: sound_unit(places[4]),
            depth: fog.1,
        };
        let law = match fog.4 {
            0 => FogLaw::DepthCue { near: fog.2, far: fog.3, front: 1.0, back: 0.0 },
            1 => FogLaw::Exponential { density: fog.2 },
            _ => FogLaw::ExponentialSquared { density: fog.3 },
        };
        let fog = Fog { color: fog.0, law };
        let environment = match around.1 {
            0 => Environment::None,
            1 => Environment::Constant(around.0),
            _ => Environment::Studio { up: [0.0, 1.0, 0.0] },
        };
        let around = LightingEnvironment::new(&lights, around.0, &environment, Some(&fog));
        let mut reflectance = Reflectance::of(0.0, &material);
        reflectance.occlusion = occlusion;
        let mut ledger = Ledger::default();
        let color = lit(&point, &reflectance, &material, &around, &mut ledger);
        prop_assert!(color.lane(0).iter().all(|c| c.is_finite()), "{color:?}");
        let told = [ledger.emission, ledger.scene_ambient, ledger.environment, ledger.sum];
        prop_assert!(told.iter().flatten().all(|c| c.is_finite()), "{ledger:?}");
        for light in &ledger.lights {
            let terms = &light.terms;
            let told = [terms.ambient.lane(0), terms.diffuse.lane(0), terms.specular.lane(0)];
            prop_assert!(told.iter().flatten().all(|c| c.is_finite()), "{terms:?}");
            let factors = [terms.attenuation, terms.spot, terms.n_dot_l];
            prop_assert!(factors.iter().all(|c| c.is_finite()), "{terms:?}");
        }
    }
}
