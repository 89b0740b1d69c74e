//! Mipmap levels made from the base level (OpenGL 1.5, section 3.8.8, "Automatic Mipmap Generation"): each texel is the
//! mean of those that it covers, by the taps of luxel's own mipmaps; colours of sRGB formats are averaged as light.

use super::image::{Texels, TextureImage};
use luxel_lighting::srgb_to_byte;
use luxel_scene::Encoding;
use luxel_scene::texture::Taps;

/// The level below an image; `None` below a single texel, or without memory. Borders are dropped, as there is no rule
/// for them.
pub(super) fn half(image: &TextureImage, dimensions: usize) -> Option<TextureImage> {
    let inner = image.inner_size(dimensions);
    if inner.iter().all(|side| *side <= 1) {
        return None;
    }
    let size = inner.map(|side| (side / 2).max(1));
    let mut level = TextureImage::new(image.name, image.format, size, 0, image.budget())?;
    let cover = Cover::new(image, inner, size, dimensions);
    let places = (0..size[2] as usize).flat_map(|z| {
        (0..size[1] as usize).flat_map(move |y| (0..size[0] as usize).map(move |x| [x, y, z]))
    });
    match (&image.texels, &mut level.texels) {
        (Texels::Bytes(from), Texels::Bytes(to)) if image.format.srgb => {
            for (place, texel) in places.zip(to) {
                let (mut sums, mut weights) = ([0.0_f64; 4], 0.0);
                cover.each(place, |index, weight| {
                    let [r, g, b, a] = from[index];
                    let light = |byte: u8| f64::from(Encoding::Srgb.linear(byte));
                    let values = [light(r), light(g), light(b), f64::from(a)];
                    for (sum, value) in sums.iter_mut().zip(values) {
                        *sum += value * weight as f64;
                    }
                    weights += weight as f64;
                });
                let [r, g, b, a] = sums.map(|sum| sum / weights);
                let byte = |light: f64| srgb_to_byte(light as f32);
                *texel = [byte(r), byte(g), byte(b), (a + 0.5) as u8];
            }
        }
        (Texels::Bytes(from), Texels::Bytes(to)) => {
            for (place, texel) in places.zip(to) {
                *texel = mean(&cover, place, |index| from[index].map(u64::from))
                    .map(|value| value as u8);
            }
        }
        (Texels::Words(from), Texels::Words(to)) => {
            for (place, texel) in places.zip(to) {
                *texel = mean(&cover, place, |index| from[index].map(u64::from))
                    .map(|value| value as u16);
            }
        }
        (Texels::Depth(_), Texels::Depth(_)) => {
            for (number, place) in places.enumerate() {
                let (mut sum, mut weights) = (0.0, 0.0);
                cover.each(place, |index, weight| {
                    sum += f64::from(image.get(index)[0]) * weight as f64;
                    weights += weight as f64;
                });
                level.put(number, [(sum / weights) as f32, 0.0, 0.0, 0.0]);
            }
        }
        _ => return None,
    }
    Some(level)
}

/// The texels of an image that each texel of the level below covers.
struct Cover<'i> {
    image: &'i TextureImage,
    /// Of each axis.
    taps: [Vec<Taps>; 3],
    /// The first texel within the border.
    first: [u32; 3],
}

impl<'i> Cover<'i> {
    fn new(image: &'i TextureImage, inner: [u32; 3], size: [u32; 3], dimensions: usize) -> Self {
        Self {
            image,
            taps: [0, 1, 2].map(|axis: usize| {
                (0..size[axis] as usize).map(|at| Taps::of(at, inner[axis])).collect()
            }),
            first: [0, 1, 2].map(|axis| if axis < dimensions { image.border } else { 0 }),
        }
    }

    /// Shows the texels that one covers, by their indexes, with their weights.
    fn each(&self, [x, y, z]: [usize; 3], mut visit: impl FnMut(usize, u64)) {
        let [across, up, deep] = &self.taps;
        for (c, weight_deep) in deep[z].iter() {
            for (b, weight_up) in up[y].iter() {
                for (a, weight_across) in across[x].iter() {
                    let [i, j, k] = self.first;
                    let at = [a as u32 + i, b as u32 + j, c as u32 + k];
                    visit(self.image.index(at), weight_across * weight_up * weight_deep);
                }
            }
        }
    }
}

/// The weighted mean of whole numbers, rounded to the nearest. Weights sum to less than 2^45 for images of 2^14 texels a
/// side, times 2^16 of a word.
fn mean(cover: &Cover<'_>, place: [usize; 3], texel: impl Fn(usize) -> [u64; 4]) -> [u64; 4] {
    let (mut sums, mut weights) = ([0_u64; 4], 0);
    cover.each(place, |index, weight| {
        for (sum, value) in sums.iter_mut().zip(texel(index)) {
            *sum += value * weight;
        }
        weights += weight;
    });
    sums.map(|sum| (sum + weights / 2) / weights)
}
