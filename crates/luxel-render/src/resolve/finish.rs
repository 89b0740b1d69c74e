//! Linear pixels into what is kept of them: floats, or encoded bytes.

use luxel_lighting::PictureEncoding;
use luxel_math::{LANES, Simd, f32x16, prelude::*, u32x16};

/// What is kept of pixels: straight colour and alpha, finished.
pub(crate) trait Finish: Sync {
    /// What is kept of one.
    type Pixel: Copy + Default + Send + Sync;

    /// Of one pixel.
    fn pixel(&self, color: [f32; 4]) -> Self::Pixel;

    /// Of a block's pixels.
    fn block<S: Simd>(&self, simd: S, color: [f32x16<S>; 4]) -> [Self::Pixel; LANES];
}

/// Pixels as they are.
pub(crate) struct Linear;

impl Finish for Linear {
    type Pixel = [f32; 4];

    fn pixel(&self, color: [f32; 4]) -> [f32; 4] {
        color
    }

    #[inline(always)]
    fn block<S: Simd>(&self, _: S, color: [f32x16<S>; 4]) -> [[f32; 4]; LANES] {
        let mut channels = [[0.0; LANES]; 4];
        for (stored, lanes) in channels.iter_mut().zip(color) {
            lanes.store_slice(stored);
        }
        let [r, g, b, alpha] = channels;
        let mut pixels = [[0.0; 4]; LANES];
        for lane in 0..LANES {
            pixels[lane] = [r[lane], g[lane], b[lane], alpha[lane]];
        }
        pixels
    }
}

/// Bytes of red, green, blue and alpha. Alpha is never encoded.
pub(crate) struct Bytes(pub(crate) PictureEncoding);

impl Finish for Bytes {
    type Pixel = [u8; 4];

    fn pixel(&self, color: [f32; 4]) -> [u8; 4] {
        bytes_of(color, self.0)
    }

    #[inline(always)]
    fn block<S: Simd>(&self, simd: S, [r, g, b, alpha]: [f32x16<S>; 4]) -> [[u8; 4]; LANES] {
        let opaque = alpha.equal(alpha.one()).all();
        let alpha = if opaque {
            u32x16::splat(simd, 255)
        } else {
            PictureEncoding::None.bytes_of_lanes(alpha)
        };
        let mut stored = [0; LANES];
        self.0.words_of_lanes([r, g, b], alpha).store_slice(&mut stored);
        let mut pixels = [[0; 4]; LANES];
        for (pixel, word) in pixels.iter_mut().zip(stored) {
            *pixel = word.to_le_bytes();
        }
        pixels
    }
}

/// A pixel's bytes. Alpha is never encoded.
pub(crate) fn bytes_of([r, g, b, alpha]: [f32; 4], encoding: PictureEncoding) -> [u8; 4] {
    let byte = |value| encoding.byte(value);
    [byte(r), byte(g), byte(b), PictureEncoding::None.byte(alpha)]
}
