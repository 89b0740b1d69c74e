//! What the samples of pixels see: each distinct triangle of a pixel counts once, for all of the pixel's
//! samples that see it.

use luxel_math::{LANES, Simd, mask32x16, prelude::*, u32x16};
use luxel_visibility::{MAX_SAMPLES, Samples, Tile};

/// Which samples of a block's pixels are the first of their pixel to see what they see: for each
/// sample the lanes, as bits.
#[derive(Clone, Copy)]
pub(crate) struct DistinctTriangles([u16; MAX_SAMPLES]);

impl DistinctTriangles {
    /// Where there is but one sample, or all see the same.
    pub(crate) const EVEN: Self = {
        let mut lanes = [0; MAX_SAMPLES];
        lanes[0] = u16::MAX;
        Self(lanes)
    };

    /// Those of a block.
    #[inline(always)]
    pub(crate) fn of<S: Simd>(simd: S, tile: &Tile, block: usize) -> Self {
        let planes = tile.planes();
        let mut firsts = Self::EVEN;
        for sample in 1..planes.len() {
            let ids = u32x16::simd_from(simd, planes[sample].ids[block]);
            let mut seen_before = mask32x16::splat(simd, false);
            for before in &planes[..sample] {
                seen_before |= u32x16::simd_from(simd, before.ids[block]).simd_eq(ids);
            }
            firsts.0[sample & (MAX_SAMPLES - 1)] = !seen_before.to_bitmask() as u16;
        }
        firsts
    }

    /// Whether all samples of each pixel see the same.
    #[inline(always)]
    pub(crate) fn are_even(&self) -> bool {
        self.0[1..] == [0; MAX_SAMPLES - 1]
    }

    /// The lanes of one sample, as bits.
    #[inline(always)]
    pub(crate) fn lanes(&self, sample: usize) -> u32 {
        self.0[sample & (MAX_SAMPLES - 1)].into()
    }
}

/// The samples of each pixel that see the same as one of them.
pub(crate) struct SampleGroup<S: Simd> {
    /// How many they are.
    pub(crate) count: u32x16<S>,
    /// The one nearest the pixel's centre, which stands for them.
    pub(crate) nearest: [u32; LANES],
}

impl<S: Simd> SampleGroup<S> {
    /// Those alike `sample`.
    #[inline(always)]
    pub(crate) fn of(simd: S, tile: &Tile, block: usize, sample: usize, samples: Samples) -> Self {
        let planes = tile.planes();
        let ids = u32x16::simd_from(simd, planes[sample].ids[block]);
        let mut count = u32x16::splat(simd, 0);
        let mut nearest = u32x16::splat(simd, 0);
        for &other in samples.nearest_first().iter().rev() {
            let seen = u32x16::simd_from(simd, planes[usize::from(other)].ids[block]);
            let alike = seen.simd_eq(ids);
            count = alike.select(count + 1, count);
            nearest = alike.select(u32x16::splat(simd, other.into()), nearest);
        }
        Self { count, nearest: nearest.into() }
    }
}
