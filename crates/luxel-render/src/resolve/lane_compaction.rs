//! Blocks in which samples of a pixel see different triangles: what only some of their pixels see is
//! packed with that of the blocks around, so that sixteen lanes are lit at a time.
//!
//! A sample is lit the same, whatever lies in the other lanes.

use super::distinct_triangles::{DistinctTriangles, SampleGroup};
use crate::backdrop::Backdrop;
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use crate::shade::{ThreadCache, shade};
use luxel_lighting::Silent;
use luxel_math::{LANES, Simd, f32x16, lanes_of, mask32x16, prelude::*, u32x16};
use luxel_visibility::{Tile, TriangleId};

/// Up to so many lanes are packed; with more, they are lit where they are, beside their neighbours.
///
/// With 4, 8, 10, 12, 14 and 16, a frame of CesiumMilkTruck with four samples in 640x480 takes 103.6, 99.5,
/// 99.3, 99.2, 99.2 and 105.2 million instructions (AVX2, one thread, `benches/rivals/instructions`).
const MOST_PACKED: u32 = 12;

/// Blocks that are lit together.
pub(crate) struct LaneCompaction {
    /// Each block's number, and where what it sees ends.
    blocks: Vec<(usize, usize)>,
    lit: Vec<Lit>,
    /// What waits to be lit.
    batch: Batch,
    /// What each lane of the batch is for, and the lane there.
    places: [(usize, usize); LANES],
    count: usize,
}

/// The light of those triangles of a block's pixels that one sample is the first to see.
pub(crate) struct Lit {
    /// That sample.
    pub(crate) sample: usize,
    /// The pixels of which it is the first, as bits.
    pub(crate) lanes: u32,
    /// Whether it is the light of that sample alone, as behind all surfaces, where each sample has its own.
    pub(crate) is_alone: bool,
    /// How many samples see the triangle; 0 where it isn't the first.
    pub(crate) shares: [u32; LANES],
    /// Straight colour and alpha.
    pub(crate) color: [[f32; LANES]; 4],
}

impl Lit {
    /// What lies behind all surfaces at one sample of those pixels whose bit is set.
    #[cold]
    #[inline(never)]
    fn behind<N: Lanes>(
        simd: N,
        backdrop: &Backdrop<'_>,
        (sample, lanes): (usize, u32),
        batch: &Batch,
        cache: &mut ThreadCache,
    ) -> Self {
        let mut color = [[0.0; LANES]; 4];
        let position = |lane| batch.position(lane);
        backdrop.put(simd, lanes, &position, &mut cache.occlusion, &mut color);
        let shares = std::array::from_fn(|lane| lanes >> lane & 1);
        Self { sample, lanes, is_alone: true, shares, color }
    }
}

impl LaneCompaction {
    pub(crate) fn new() -> Self {
        Self {
            blocks: Vec::new(),
            lit: Vec::new(),
            batch: Batch::nothing([0; 2]),
            places: [(0, 0); LANES],
            count: 0,
        }
    }

    /// Takes what a block of a tile sees.
    #[inline(always)]
    pub(crate) fn add<S: Simd>(
        &mut self,
        simd: S,
        scene: &ShadingContext<'_>,
        tile: &Tile,
        block: usize,
        firsts: &DistinctTriangles,
        cache: &mut ThreadCache,
    ) {
        let samples = scene.frame.samples();
        self.batch.tile = tile.origin();
        let background = scene.background.map(|value| [value; LANES]);
        for (sample, plane) in tile.planes().iter().enumerate() {
            let mut lanes = firsts.lanes(sample);
            if let Some(backdrop) = scene.backdrop {
                let vector = f32x16::splat(simd, 0.0);
                let unseen = vector.eq_mask(&plane.ids[block], TriangleId::NONE.0);
                if unseen != 0 {
                    let at = [sample as u32; LANES];
                    let batch = Batch::new(tile, block, plane.ids[block], &at, samples);
                    self.lit.push(Lit::behind(vector, backdrop, (sample, unseen), &batch, cache));
                }
                lanes &= !unseen;
            }
            if lanes == 0 {
                continue;
            }
            let SampleGroup { count, nearest } =
                SampleGroup::of(simd, tile, block, sample, samples);
            let mask = mask32x16::from_bitmask(simd, lanes.into());
            let nothing = u32x16::splat(simd, TriangleId::NONE.0);
            let seen = mask.select(u32x16::simd_from(simd, plane.ids[block]), nothing);
            let ids: [u32; LANES] = seen.into();
            let shares = mask.select(count, u32x16::splat(simd, 0)).into();
            let mut lit = Lit { sample, lanes, is_alone: false, shares, color: background };
            let to_light = lanes & !seen.simd_eq(nothing).to_bitmask() as u32;
            if to_light.count_ones() > MOST_PACKED {
                let batch = Batch::new(tile, block, ids, &nearest, samples);
                store(
                    shade(f32x16::splat(simd, 0.0), scene, &batch, cache, &mut Silent),
                    &mut lit.color,
                );
                self.lit.push(lit);
                continue;
            }
            self.lit.push(lit);
            for lane in lanes_of(to_light) {
                let position = samples.positions()[nearest[lane] as usize];
                self.batch.put_sample(self.count, (block, lane), position, ids[lane]);
                self.places[self.count] = (self.lit.len() - 1, lane);
                self.count += 1;
                if self.count == LANES {
                    self.light(simd, scene, cache);
                }
            }
        }
        self.blocks.push((block, self.lit.len()));
    }

    /// Lights what waits.
    #[inline(always)]
    fn light<S: Simd>(&mut self, simd: S, scene: &ShadingContext<'_>, cache: &mut ThreadCache) {
        let mut colors = [[0.0; LANES]; 4];
        store(shade(f32x16::splat(simd, 0.0), scene, &self.batch, cache, &mut Silent), &mut colors);
        for (lane, &(of, into)) in self.places[..self.count].iter().enumerate() {
            for (channel, colors) in self.lit[of].color.iter_mut().zip(&colors) {
                channel[into] = colors[lane];
            }
        }
        self.batch.ids = [TriangleId::NONE.0; LANES];
        self.count = 0;
    }

    /// Ends with the blocks that were taken: `put` gets the number of each and what it sees, in the
    /// order of samples. The closure is to be marked `#[inline(always)]`.
    #[inline(always)]
    pub(crate) fn finish<S: Simd>(
        &mut self,
        simd: S,
        scene: &ShadingContext<'_>,
        cache: &mut ThreadCache,
        mut put: impl FnMut(usize, &[Lit], &mut ThreadCache),
    ) {
        if self.count > 0 {
            self.light(simd, scene, cache);
        }
        let mut first = 0;
        for &(block, end) in &self.blocks {
            put(block, &self.lit[first..end], cache);
            first = end;
        }
        self.blocks.clear();
        self.lit.clear();
    }
}

#[inline(always)]
fn store<S: Simd>(lanes: [f32x16<S>; 4], stored: &mut [[f32; LANES]; 4]) {
    for (stored, lanes) in stored.iter_mut().zip(lanes) {
        lanes.store_slice(stored);
    }
}
