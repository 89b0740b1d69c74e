//! Texels of sixteen lanes from an image.

use crate::texture::{SampledTexture, Texels, TextureImage};
use luxel_math::{LANES, Lanes, Simd, f32x16, i32x16, prelude::*, u32x16};
use luxel_scene::Encoding;
use luxel_scene::texture::addressing::Addressing;

/// Reads texels of an image by their numbers, of which the last two of each axis are the border's.
pub(super) struct Fetch<'t> {
    image: &'t TextureImage,
    inner: [u32; 3],
    border: &'t [f32; 4],
    /// Whether every number is that of a texel.
    plain: bool,
}

impl<'t> Fetch<'t> {
    /// Of an image whose size without borders is `inner`.
    #[inline(always)]
    pub(super) fn new(
        texture: &'t SampledTexture,
        image: &'t TextureImage,
        inner: [u32; 3],
    ) -> Self {
        let mut plain = image.border == 0;
        for addressing in texture.addressing {
            plain &= !matches!(addressing, Addressing::Clamp | Addressing::ClampToBorder);
        }
        Self { image, inner, border: &texture.border, plain }
    }

    /// The texels of the lanes whose bit is set: of each axis the first or the second number, as the bits of `corner`
    /// tell.
    #[inline(always)]
    pub(super) fn texels<S: Simd>(
        &self,
        simd: S,
        numbers: &[[[u32; LANES]; 2]; 3],
        corner: usize,
        lanes: u32,
    ) -> [f32x16<S>; 4] {
        let zero = f32x16::splat(simd, 0.0);
        let [across, up, deep] = numbers;
        let (across, up, deep) =
            (&across[corner & 1], &up[corner >> 1 & 1], &deep[corner >> 2 & 1]);
        if let (true, false, Texels::Bytes(texels)) =
            (self.plain, self.image.format.srgb, &self.image.texels)
        {
            let [width, height, _] = self.image.size;
            let of = |numbers: &[u32; LANES]| u32x16::from_slice(simd, &numbers[..]);
            let mut places = [0; LANES];
            ((of(deep) * height + of(up)) * width + of(across)).store_slice(&mut places);
            let mut words = [0; LANES];
            zero.visit(
                lanes,
                #[inline(always)]
                |lane| words[lane] = u32::from_le_bytes(texels[places[lane] as usize]),
            );
            let words = u32x16::from_slice(simd, &words);
            return [channel(words, 0), channel(words, 8), channel(words, 16), channel(words, 24)];
        }
        if let (true, Texels::Depth(Some(depths))) = (self.plain, &self.image.texels) {
            let mut kept = [0.0; LANES];
            zero.visit(
                lanes,
                #[inline(always)]
                |lane| {
                    let value = depths.values.get([across[lane], up[lane]], 0);
                    kept[lane] = value.unwrap_or(0.0);
                },
            );
            return [depths.kind.unit(zero.load(&kept, 0)); 4];
        }
        let mut columns = [[0.0; LANES]; 4];
        zero.visit(
            lanes,
            #[inline(always)]
            |lane| {
                let texel = self.texel([across[lane], up[lane], deep[lane]]);
                for (column, value) in columns.iter_mut().zip(texel) {
                    column[lane] = value;
                }
            },
        );
        let mut texels = [zero; 4];
        for (texel, column) in texels.iter_mut().zip(&columns) {
            *texel = zero.load(column, 0);
        }
        texels
    }

    /// One texel, of any format, or the border's.
    fn texel(&self, mut at: [u32; 3]) -> [f32; 4] {
        let image = self.image;
        if image.border > 0 {
            for (place, size) in at.iter_mut().zip(self.inner).take(bordered_axes(image)) {
                *place = match place.checked_sub(size) {
                    None => *place + 1,
                    Some(0) => 0,
                    Some(_) => size + 1,
                };
            }
        } else if at[0] >= self.inner[0] || at[1] >= self.inner[1] || at[2] >= self.inner[2] {
            return *self.border;
        }
        let index = image.index(at);
        match &image.texels {
            Texels::Bytes(texels) => {
                let encoding = if image.format.srgb { Encoding::Srgb } else { Encoding::Linear };
                let [r, g, b, a] = texels[index];
                let alpha = Encoding::Linear.linear(a);
                [encoding.linear(r), encoding.linear(g), encoding.linear(b), alpha]
            }
            Texels::Words(texels) => texels[index].map(|word| f32::from(word) / 65535.0),
            Texels::Depth(_) => [image.depth([at[0], at[1]]); 4],
        }
    }
}

/// A byte of words, from 0 to 1.
#[inline(always)]
fn channel<S: Simd>(words: u32x16<S>, shift: u32) -> f32x16<S> {
    let byte: i32x16<S> = ((words >> shift) & 0xff).bitcast();
    f32x16::float_from(byte) / 255.0
}

/// How many axes of an image have a border: those that are longer than the inner image.
fn bordered_axes(image: &TextureImage) -> usize {
    let last = image.size.iter().rposition(|side| *side > 1);
    last.map_or(1, |last| last + 1)
}
