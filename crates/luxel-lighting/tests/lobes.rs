//! The terms of a model are the products of the factors that it reports.

use luxel_lighting::*;
use luxel_math::Vec3;
use proptest::prelude::*;

fn unit([x, y, z]: [f32; 3]) -> Vec3<f32> {
    Vec3::new(x, y, z).normalized_or_zero()
}

fn close(one: [f32; 3], other: [f32; 3]) -> bool {
    one.iter().zip(other).all(|(one, other)| {
        let size = one.abs().max(other.abs());
        (one - other).abs() <= 2e-6 * size.max(1e-6)
    })
}

/// Directions about the normal, which is +Z: some of them behind it.
fn towards() -> impl Strategy<Value = Vec3<f32>> {
    [-1.0_f32..1.0, -1.0_f32..1.0, -0.2_f32..1.0].prop_map(unit)
}

fn model() -> impl Strategy<Value = Reflection> {
    let mix = vec![
        (Reflection::OrenNayar, 0.25),
        (Reflection::Microfacet, 0.5),
        (Reflection::Phong, 0.125),
        (Reflection::Mirror, 0.125),
    ];
    let models = REFLECTION_MODELS.iter().map(|model| model.reflection.clone());
    prop::sample::select(models.chain([Reflection::mixed(mix)]).collect::<Vec<_>>())
}

proptest! {
    #[test]
    fn the_terms_are_the_products_of_the_reported_factors(
        reflection in model(),
        to_light in towards(),
        view in towards(),
        roughness in 0.05_f32..1.0,
        metallic in 0.0_f32..1.0,
        color in [0.0_f32..1.0, 0.0_f32..1.0, 0.0_f32..1.0],
    ) {
        let material = Material {
            reflection,
            diffuse: color,
            k_d: 0.75,
            k_s: 0.5,
            roughness,
            metallic,
            ..Material::default()
        };
        let light = Light::new(LightKind::Directional, [1.0, 0.5, 0.25]);
        let travels = (-to_light).lane(0);
        let lights = [PlacedLight::new(light.clone(), [0.0; 3], travels)];
        let lighting = LightingEnvironment::new(&lights, [0.1; 3], &Environment::Studio { up: [0.0, 1.0, 0.0] }, None);
        let normal = Vec3::new(0.0, 0.0, 1.0);
        let point = SurfacePoint { position: -view, normal, view, depth: 1.0 };
        let mut ledger = Ledger::default();
        let of = Reflectance::of(0.0_f32, &material);
        let _ = lit(&point, &of, &material, &lighting, &mut ledger);
        let LedgerLight { parts, terms, .. } = &ledger.lights[0];

        // The parts add up to the light's terms.
        let zero = [0.0_f32; 3];
        let plus = |sum: [f32; 3], part: [f32; 3]| [0, 1, 2].map(|c| sum[c] + part[c]);
        let sum = parts.iter().fold([zero; 2], |[diffuse, specular], (_, part)| [
            plus(diffuse, (part.diffuse * part.weight).lane(0)),
            plus(specular, (part.specular * part.weight).lane(0)),
        ]);
        let times = |share: [f32; 3], light: [f32; 3]| [0, 1, 2].map(|c| share[c] * light[c]);
        prop_assert!(close(times(sum[0], light.diffuse), terms.diffuse.lane(0)));
        prop_assert!(close(times(sum[1], light.specular), terms.specular.lane(0)));

        // And each is the product of its own factors.
        let cosine = terms.n_dot_l.max(0.0);
        let k_d_o_d = color.map(|channel| 0.75 * channel);
        for (_, part) in parts {
            match part.lobe {
                Lobe::Rough(factor) => {
                    let product = k_d_o_d.map(|channel| channel * (cosine * factor));
                    prop_assert!(close(product, part.diffuse.lane(0)));
                }
                Lobe::Facets { pi_d, visibility, fresnel } => {
                    let f = fresnel.lane(0);
                    let specular = f.map(|f| 0.5 * f * (pi_d * visibility * cosine));
                    prop_assert!(close(specular, part.specular.lane(0)));
                    let left = (1.0 - metallic) * cosine;
                    let diffuse = [0, 1, 2].map(|c| k_d_o_d[c] * (1.0 - f[c]) * left);
                    prop_assert!(close(diffuse, part.diffuse.lane(0)));
                }
                Lobe::Factors { diffuse, specular } => {
                    let product = k_d_o_d.map(|channel| channel * diffuse);
                    prop_assert!(close(product, part.diffuse.lane(0)));
                    prop_assert!(close([0.5 * specular; 3], part.specular.lane(0)));
                }
                Lobe::Plain => {}
            }
        }

        // So is the reflected environment.
        let mirrored = ledger.mirrors.iter().fold(zero, |sum, (_, mirror)| {
            plus(sum, (mirror.share * mirror.radiance * mirror.weight).lane(0))
        });
        prop_assert!(close(mirrored.map(|channel| 0.5 * channel), ledger.environment));
    }
}
