//! One sphere for each model of reflection, in rows.

use super::builder::{SceneBuilder, srgb};
use crate::{DMat4, DVec3, EnvironmentChoice, Scene, primitives};
use luxel_lighting::{Environment, Material, Reflection};

/// Along each edge of the icosahedron: the outline has about eighty corners.
const FREQUENCY: u32 = 16;
/// From middle to middle, in radii.
const SPACING: f64 = 2.4;

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let root = builder.group("spheres", None, DMat4::IDENTITY);
    let sphere = primitives::icosphere(1.0, FREQUENCY);
    let rows = [("matte", matte()), ("glossy", glossy()), ("physical", physical())];
    for (row, (name, materials)) in rows.into_iter().enumerate() {
        let y = SPACING * (1.0 - row as f64);
        let group =
            builder.group(name, Some(root), DMat4::from_translation(DVec3::new(0.0, y, 0.0)));
        let middle = (materials.len() - 1) as f64 * 0.5;
        for (column, (name, constants)) in materials.into_iter().enumerate() {
            let material = builder.material(name, constants);
            let mesh = builder.mesh(sphere.clone(), material);
            let x = SPACING * (column as f64 - middle);
            let place = DMat4::from_translation(DVec3::new(x, 0.0, 0.0));
            builder.object(name, group, place, mesh);
        }
    }
    builder.camera(root, DVec3::new(0.0, 0.0, 24.0), DVec3::ZERO, 20.0);
    // Without anything around it a mirror is black.
    let studio = Environment::Studio { up: [0.0, 1.0, 0.0] };
    builder.scene.environment = Some(EnvironmentChoice::Always(studio));
    builder.scene
}

type Named = (&'static str, Material);

/// Without a highlight that depends on a glossy surface.
fn matte() -> Vec<Named> {
    let of = |reflection, k_s, shininess| Material {
        reflection,
        diffuse: srgb(0x5a_a9e6),
        k_s,
        shininess,
        roughness: 0.6,
        ..Material::default()
    };
    vec![
        ("unlit", of(Reflection::Unlit, 0.0, 1.0)),
        ("lambert", of(Reflection::Lambert, 0.0, 1.0)),
        ("oren-nayar", of(Reflection::OrenNayar, 0.0, 1.0)),
        ("retro", of(Reflection::Retro, 0.35, 3.0)),
        ("lambert-and-phong", {
            let models = vec![(Reflection::Lambert, 0.6), (Reflection::Phong, 0.4)];
            of(Reflection::Mixed(models), 0.8, 24.0)
        }),
    ]
}

/// Highlights with growing exponents. About four times Phong's exponent makes Blinn's highlight as
/// wide: N.H turns half as fast as R.V.
fn glossy() -> Vec<Named> {
    let of = |reflection, shininess| Material {
        reflection,
        diffuse: srgb(0xe0_7a3f),
        k_s: 0.55,
        shininess,
        ..Material::default()
    };
    vec![
        ("phong-5", of(Reflection::Phong, 5.0)),
        ("phong-20", of(Reflection::Phong, 20.0)),
        ("phong-100", of(Reflection::Phong, 100.0)),
        ("blinn-phong-80", of(Reflection::BlinnPhong, 80.0)),
        ("blinn-phong-400", of(Reflection::BlinnPhong, 400.0)),
    ]
}

/// Materials with roughness: metals from polished to rough, plastic.
fn physical() -> Vec<Named> {
    // Reflectances at normal incidence under daylight, from the metals' optical constants (Johnson
    // and Christy 1972).
    let [silver, gold, copper] =
        [[0.972, 0.960, 0.915], [1.0, 0.766, 0.336], [0.955, 0.638, 0.538]];
    let of = |diffuse, metallic, roughness| Material {
        reflection: Reflection::Microfacet,
        diffuse,
        k_s: 1.0,
        metallic,
        roughness,
        ..Material::default()
    };
    vec![
        ("silver-polished", of(silver, 1.0, 0.05)),
        ("gold-satin", of(gold, 1.0, 0.25)),
        ("gold-brushed", of(gold, 1.0, 0.45)),
        ("copper-rough", of(copper, 1.0, 0.7)),
        ("plastic", of(srgb(0x2f_8f7a), 0.0, 0.25)),
    ]
}
