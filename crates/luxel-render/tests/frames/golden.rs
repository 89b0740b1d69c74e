//! Golden pictures: hashes of bytes, which may change only when the pictures are meant to.
//!
//! `LUXEL_BLESS=1` prints the hashes to be put here instead of comparing them.

use luxel_render::{EnvironmentChoice, Renderer};
use luxel_scene::{Size, default_lights, demos};

use crate::scenes::{execution, fitted};
use luxel_math::SimdLevel;

/// The hash of each demo's picture, 320x180 with 4 samples a pixel, from its fitted view.
const GOLDEN: &[(&str, u64)] = &[
    ("teapot", 0x0b7b_9e64_e802_766c),
    ("spheres", 0xaa7b_b90a_24aa_cb3a),
    ("cornell", 0x0ff4_2b6c_56d4_863b),
    ("plane", 0x8334_f777_1f31_8e5e),
    ("welcome", 0xc9ab_aa20_aaad_5444),
    ("blob", 0x1dce_9d97_49e3_639a),
    ("lab-silhouette", 0x04ed_67d0_b577_457d),
    ("lab-silhouette-cured", 0xa5d7_1b2e_e6af_7636),
    ("lab-perspective", 0x6cd4_e8bf_e996_08e4),
    ("lab-rolling", 0x0404_edc0_3fca_c76e),
    ("lab-rolling-cured", 0x23b6_9839_29ef_cc43),
    ("lab-t-junction", 0x794d_a606_d5c5_b964),
    ("lab-t-junction-cured", 0xd328_8694_9164_306b),
    ("lab-corrugated", 0xadc4_581e_d4fe_3ba0),
    ("lab-lamp", 0x0b79_9003_6d37_1655),
    ("lab-highlight", 0x8b89_9e38_53a2_2c75),
    ("lab-mach", 0x1724_4743_400c_1679),
];

/// FNV-1a (Fowler, Noll and Vo 1991), 64 bits.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, &byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

#[test]
fn demos_look_as_they_did() {
    for (name, _) in demos::names() {
        let scene = demos::demo(name).unwrap();
        let size = Size { width: 320, height: 180 };
        let mut lights = scene.lights.clone();
        if lights.is_empty() {
            lights = default_lights();
        }
        let view = fitted(&scene, size)
            .with_samples(4)
            .with_lights(lights)
            .with_ambient([0.1; 3])
            .with_environment(EnvironmentChoice::StudioForMicrofacets);
        let renderer = Renderer::new(scene.clone(), &execution(0, SimdLevel::Auto)).unwrap();
        let found = hash(renderer.rgba8(&view).unwrap().pixels.as_flattened());
        if std::env::var_os("LUXEL_BLESS").is_some() {
            println!("    (\"{name}\", 0x{found:016x}),");
            continue;
        }
        let golden = GOLDEN.iter().find(|(golden, _)| **golden == *name);
        let expected = golden.map(|(_, hash)| *hash);
        assert_eq!(Some(found), expected, "the picture of {name} has changed");
    }
}
