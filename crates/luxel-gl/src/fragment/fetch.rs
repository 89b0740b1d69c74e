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
            if lanes == zero.all_lanes() {
                // No search for the next lane: a layer of a bilinear texture takes 0.88x the time.
                for (word, place) in words.iter_mut().zip(places) {
                    *word = u32::from_le_bytes(texels[place as usize]);
                }
            } else {
                zero.visit(
                    lanes,
                    #[inline(always)]
                    |lane| words[lane] = u32::from_le_bytes(texels[places[lane] as usize]),
                );
            }
            let words = u32x16::from_slice(simd, &words);
            return [channel(words, 0), channel(words, 8), channel(words, 16), channel(words, 24)];
        }
        if let (true, Texels::Depth(Some(depths))) = (self.plain, &self.image.texels) {
            let of = |numbers: &[u32; LANES]| u32x16::from_slice(simd, &numbers[..]);
            let kept = depths.values.gathered([of(across), of(up)], lanes);
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
    part_of_255(f32x16::float_from(byte))
}

/// A byte / 255, to the bit, without a division: 1/255 is 257/65536 and a rest. With the first part the product is exact,
/// and the error of the other one is too small to be seen in the sum.
#[inline(always)]
fn part_of_255<N: Lanes>(byte: N) -> N {
    const FIRST: f32 = 257.0 / 65536.0;
    const REST: f32 = (1.0 / 255.0 - 257.0 / 65536.0_f64) as f32;
    byte * byte.constant(FIRST) + byte * byte.constant(REST)
}

/// How many axes of an image have a border: those that are longer than the inner image.
fn bordered_axes(image: &TextureImage) -> usize {
    let last = image.size.iter().rposition(|side| *side > 1);
    last.map_or(1, |last| last + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_are_divided_by_255_to_the_bit() {
        for byte in 0..=255_u8 {
            let byte = f32::from(byte);
            assert_eq!(part_of_255(byte).to_bits(), (byte / 255.0).to_bits());
        }
    }
}
