//! Mipmap levels: each half as wide and high as the one before, down to one texel.
//!
//! A texel is the mean of the texels that it covers (a box filter). Where a side is odd, 2m + 1
//! texels become m, each of which covers 2 + 1/m of them: three taps, whose weights m - i, m and
//! i + 1 (over 2m + 1) change along the row (Guthe and Heckbert 2005, *Non-Power-of-Two
//! Mipmapping*). Means are of linear light, in whole numbers, so that the order of adding and the
//! number of threads change nothing.

use crate::encoding::{Encoding, WholeNumbers};
use crate::texture::MipLevel;

/// Texels that one thread takes at a time, or a few more.
const TEXELS_OF_RUN: usize = 1 << 13;

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
    // Colours without opacity don't count; but data that happens to lie beside a fourth channel
    // isn't weighted by it.
    let by_alpha = encoding == Encoding::Srgb;
    let fill = |(y, row): (usize, &mut [[u8; 4]])| {
        let down = Taps::of(y, level.height);
        if level.width.is_multiple_of(2) && down.is_pair() {
            let stride = level.width as usize;
            let rows = level.texels[2 * y * stride..][..2 * stride].split_at(stride);
            let pairs = rows.0.as_chunks::<2>().0.iter().zip(rows.1.as_chunks::<2>().0);
            for (x, (texel, ([a, b], [c, d]))) in row.iter_mut().zip(pairs).enumerate() {
                // Equal opacities weigh equally.
                let alike = [b, c, d].iter().all(|texel| texel[3] == a[3]);
                *texel = if !by_alpha || alike {
                    mean_of_four([a, b, c, d], numbers)
                } else {
                    mean_of_taps(level, Taps::of(x, level.width), down, numbers, by_alpha)
                };
            }
        } else {
            for (x, texel) in row.iter_mut().enumerate() {
                *texel = mean_of_taps(level, Taps::of(x, level.width), down, numbers, by_alpha);
            }
        }
    };
    let width = width as usize;
    // Whole rows.
    let run = TEXELS_OF_RUN.next_multiple_of(width);
    luxel_parallel::fill(&mut texels, run, &|start, rows| {
        (start / width..).zip(rows.chunks_exact_mut(width)).for_each(fill);
    });
    let width = width as u32;
    Some(MipLevel { width, height, texels })
}

/// The texels of one side that a texel of the level below covers, with their weights.
#[derive(Clone, Copy, Debug)]
pub struct Taps {
    first: usize,
    weights: [u64; 3],
    count: usize,
}

impl Taps {
    /// The taps of the texel at `index` of a level whose parent has `size` texels.
    #[must_use]
    pub fn of(index: usize, size: u32) -> Self {
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

    /// Texels with their weights.
    pub fn iter(self) -> impl Iterator<Item = (usize, u64)> {
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

/// The weighted mean of the texels at the crossings of taps; `by_alpha` weights colours by their
/// opacity, too, unless all are wholly transparent.
///
/// The weights' sum is at most the number of texels of a level, below 2^38 in any memory of today,
/// so sums stay below 2^62.
#[inline]
fn mean_of_taps(
    level: &MipLevel,
    across: Taps,
    down: Taps,
    numbers: &WholeNumbers,
    by_alpha: bool,
) -> [u8; 4] {
    let mut plain = [0_u64; 3];
    let mut opaque = [0_u64; 3];
    let mut weights = 0;
    let mut alphas = 0;
    for (y, weight_down) in down.iter() {
        let row = &level.texels[y * level.width as usize..];
        for (x, weight_across) in across.iter() {
            let [r, g, b, a] = row[x].map(usize::from);
            let weight = weight_down * weight_across;
            let alpha = weight * a as u64;
            weights += weight;
            alphas += alpha;
            let linear = [numbers.linear[r], numbers.linear[g], numbers.linear[b]];
            for channel in 0..3 {
                plain[channel] += weight * u64::from(linear[channel]);
                opaque[channel] += alpha * u64::from(linear[channel]);
            }
        }
    }
    let (sums, divisor) = if by_alpha && alphas > 0 { (opaque, alphas) } else { (plain, weights) };
    let [r, g, b] = sums.map(|sum| numbers.byte[((sum + divisor / 2) / divisor) as usize]);
    [r, g, b, ((alphas + weights / 2) / weights) as u8]
}
