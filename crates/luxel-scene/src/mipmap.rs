//! Mipmap levels: each half as wide and high as the one before, down to one texel.
//!
//! A texel is the mean of the texels that it covers (a box filter). Where a side is odd, 2m + 1
//! texels become m, each of which covers 2 + 1/m of them: three taps, whose weights m - i, m and
//! i + 1 (over 2m + 1) change along the row (Guthe and Heckbert 2005, *Non-Power-of-Two
//! Mipmapping*). Means are of linear light, in whole numbers, so that the order of adding and the
//! number of threads change nothing.

use crate::encoding::{Encoding, WholeNumbers};
use crate::texture::MipLevel;
use rayon::prelude::*;

/// Below so many texels a level isn't worth more than one thread.
const TEXELS_WORTH_THREADS: usize = 1 << 14;

/// All levels below a picture, which comes first.
pub(crate) fn mip_chain(base: MipLevel, encoding: Encoding) -> Vec<MipLevel> {
    let mut levels = vec![base];
    while let Some(next) = levels.last().and_then(|level| half(level, encoding)) {
        levels.push(next);
    }
    levels
}

/// The level below; `None` below a single texel.
fn half(level: &MipLevel, encoding: Encoding) -> Option<MipLevel> {
    if level.width <= 1 && level.height <= 1 {
        return None;
    }
    let (width, height) = ((level.width / 2).max(1), (level.height / 2).max(1));
    let mut texels = vec![[0; 4]; width as usize * height as usize];
    let numbers = WholeNumbers::of(encoding);
    // Colours without opacity are no colours; but data that happens to lie beside a fourth channel
    // isn't weighted by it.
    let by_alpha = encoding == Encoding::Srgb;
    let fill = |(y, row): (usize, &mut [[u8; 4]])| {
        let down = Taps::of(y, level.height);
        if level.width.is_multiple_of(2) && down.is_pair() {
            let stride = level.width as usize;
            let rows = level.texels[2 * y * stride..][..2 * stride].split_at(stride);
            let pairs = rows.0.as_chunks::<2>().0.iter().zip(rows.1.as_chunks::<2>().0);
            for (texel, ([a, b], [c, d])) in row.iter_mut().zip(pairs) {
                // Equal opacities weigh equally.
                let alike = [b, c, d].iter().all(|texel| texel[3] == a[3]);
                *texel = if !by_alpha || alike {
                    mean_of_four([a, b, c, d], numbers)
                } else {
                    weighted_mean([(1, *a), (1, *b), (1, *c), (1, *d)], numbers, by_alpha)
                };
            }
        } else {
            for (x, texel) in row.iter_mut().enumerate() {
                let across = Taps::of(x, level.width);
                let taps = down.iter().flat_map(|(y, down_weight)| {
                    let row = &level.texels[y * level.width as usize..];
                    across.iter().map(move |(x, weight)| (down_weight * weight, row[x]))
                });
                *texel = weighted_mean(taps, numbers, by_alpha);
            }
        }
    };
    if texels.len() < TEXELS_WORTH_THREADS {
        texels.chunks_exact_mut(width as usize).enumerate().for_each(fill);
    } else {
        texels.par_chunks_exact_mut(width as usize).enumerate().for_each(fill);
    }
    Some(MipLevel { width, height, texels })
}

/// The texels of one side that a texel of the level below covers, with their weights.
#[derive(Clone, Copy)]
struct Taps {
    first: usize,
    weights: [u64; 3],
    count: usize,
}

impl Taps {
    /// The taps of the texel at `index` of a level whose parent has `size` texels.
    fn of(index: usize, size: u32) -> Self {
        let half = u64::from(size / 2);
        let first = 2 * index;
        if size <= 1 {
            Self { first: 0, weights: [1, 0, 0], count: 1 }
        } else if size.is_multiple_of(2) {
            Self { first, weights: [1, 1, 0], count: 2 }
        } else {
            let index = index as u64;
            Self { first, weights: [half - index, half, index + 1], count: 3 }
        }
    }

    fn is_pair(&self) -> bool {
        self.count == 2
    }

    fn iter(self) -> impl Iterator<Item = (usize, u64)> {
        (0..self.count).map(move |tap| (self.first + tap, self.weights[tap]))
    }
}

/// The plain mean of four texels.
#[inline]
fn mean_of_four([a, b, c, d]: [&[u8; 4]; 4], numbers: &WholeNumbers) -> [u8; 4] {
    let channel = |channel: usize| {
        let linear = |texel: &[u8; 4]| u32::from(numbers.linear[usize::from(texel[channel])]);
        numbers.byte[((linear(a) + linear(b) + linear(c) + linear(d) + 2) / 4) as usize]
    };
    let alpha = |texel: &[u8; 4]| u32::from(texel[3]);
    let alpha = (alpha(a) + alpha(b) + alpha(c) + alpha(d) + 2) / 4;
    [channel(0), channel(1), channel(2), alpha as u8]
}

/// The mean of weighted texels; `by_alpha` weights colours by their opacity, too, unless all are
/// wholly transparent.
///
/// The weights' sum is at most the number of texels of a level, below 2^38 in any memory of today,
/// so sums stay below 2^62.
fn weighted_mean(
    taps: impl IntoIterator<Item = (u64, [u8; 4])>,
    numbers: &WholeNumbers,
    by_alpha: bool,
) -> [u8; 4] {
    let mut plain = [0_u64; 3];
    let mut opaque = [0_u64; 3];
    let mut weights = 0;
    let mut alphas = 0;
    for (weight, texel) in taps {
        let alpha = weight * u64::from(texel[3]);
        weights += weight;
        alphas += alpha;
        for channel in 0..3 {
            let linear = u64::from(numbers.linear[usize::from(texel[channel])]);
            plain[channel] += weight * linear;
            opaque[channel] += alpha * linear;
        }
    }
    let (sums, divisor) =
        if by_alpha && alphas > 0 { (opaque, alphas) } else { (plain, weights.max(1)) };
    let [r, g, b] = sums.map(|sum| numbers.byte[((sum + divisor / 2) / divisor) as usize]);
    let weights = weights.max(1);
    [r, g, b, ((alphas + weights / 2) / weights) as u8]
}
