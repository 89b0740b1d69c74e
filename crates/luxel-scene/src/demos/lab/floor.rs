//! A textured floor that recedes.

use super::{grid, stage};
use crate::{DVec3, Encoding, Image, Sampler, Scene, Texture, TextureId, TextureUse};
use luxel_lighting::{Material, Reflection};
use std::sync::Arc;

/// Fields of the texture across and along.
const FIELDS: [u32; 2] = [8, 16];
/// Texels of a field's side.
const TEXELS: u32 = 16;

/// A floor of `cells` x `cells` polygons under one chequered texture, seen along its length.
#[must_use]
pub fn floor(name: &str, cells: u32) -> Scene {
    let paint =
        Material { reflection: Reflection::Lambert, diffuse: [1.0; 3], ..Material::default() };
    let mesh = grid(cells, cells, |u, v| {
        (DVec3::new((u - 0.5) * 4.0, 0.0, (v - 0.5) * 8.0 - 1.0), DVec3::Y)
    });
    let (mut builder, root) = stage(name, "floor", paint, mesh);
    let texture = Texture { image: Arc::new(chequers()), sampler: Sampler::trilinear() };
    builder.scene.textures.push(texture);
    builder.scene.materials[0].base_color = Some(TextureUse::new(TextureId(0)).into());
    builder.sun("sun", DVec3::new(0.3, -1.0, -0.2), [0.9; 3]);
    builder.ambient([0.1; 3]);
    builder.camera(root, DVec3::new(0.9, 2.0, 5.2), DVec3::new(0.0, 0.0, -0.6), 38.0);
    builder.scene
}

/// Fields of two cool greys, with a warm path along the middle.
fn chequers() -> Image {
    let [across, along] = FIELDS;
    let (width, height) = (across * TEXELS, along * TEXELS);
    let texel = |x: u32, y: u32| {
        let (column, row) = (x / TEXELS, y / TEXELS);
        let is_path = column + 1 == across / 2 || column == across / 2;
        match (is_path, (column + row) % 2 == 0) {
            (false, false) => [0x4a, 0x60, 0x76, 255],
            (false, true) => [0x9a, 0xae, 0xbb, 255],
            (true, false) => [0xa8, 0x6d, 0x22, 255],
            (true, true) => [0xf2, 0xb8, 0x4b, 255],
        }
    };
    let texels = (0..height).flat_map(|y| (0..width).map(move |x| texel(x, y))).collect();
    Image::new("chequers", Encoding::Srgb, width, height, texels)
}
