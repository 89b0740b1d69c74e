//! Transparent layers over one another, nearest first.

use super::distinct_triangles::DistinctTriangles;
use super::lane_compaction::{LaneCompaction, Lit};
use super::pixels::straight;
use crate::context::ShadingContext;
use crate::shade::ThreadCache;
use luxel_math::{LANES, Simd, f32x16, lanes_of, prelude::*};
use luxel_visibility::{MAX_SAMPLES, Tile};

/// Puts a colour behind the light gathered so far, of which `through` comes through.
#[inline(always)]
pub(crate) fn put_behind(light: &mut [f32; 3], through: &mut f32, color: [f32; 3], alpha: f32) {
    for (light, color) in light.iter_mut().zip(color) {
        *light += *through * alpha * color;
    }
    *through *= 1.0 - alpha;
}

/// A tile in which transparent layers lie over one another.
///
/// Layers come nearest first; each sample keeps the light gathered so far and how much of what lies
/// behind still comes through.
pub(crate) struct Layered {
    samples: usize,
    /// Light of each sample, times alpha: block, sample, channel.
    light: Vec<[f32; LANES]>,
    /// What comes through: block, sample.
    through: Vec<[f32; LANES]>,
    /// The pixels of each block that have a layer.
    touched: Vec<u16>,
    compaction: LaneCompaction,
}

/// Where less comes through than this, deeper layers can't be seen in 16 bits a channel.
const OPAQUE_ENOUGH: f32 = 1.0 / (1 << 20) as f32;

impl Layered {
    pub(crate) fn new(samples: usize) -> Self {
        Self {
            samples,
            light: Vec::new(),
            through: Vec::new(),
            touched: Vec::new(),
            compaction: LaneCompaction::new(),
        }
    }

    /// Resets the layer buffers for a new tile.
    pub(crate) fn clear(&mut self) {
        let blocks = (luxel_visibility::BLOCKS * luxel_visibility::BLOCKS) as usize;
        for (list, value, count) in [
            (&mut self.light, 0.0, blocks * self.samples * 3),
            (&mut self.through, 1.0, blocks * self.samples),
        ] {
            list.clear();
            list.resize(count, [value; LANES]);
        }
        self.touched.clear();
        self.touched.resize(blocks, 0);
    }

    /// Whether a pixel of the block has a layer.
    pub(crate) fn is_touched(&self, block: usize) -> bool {
        self.touched[block] != 0
    }

    /// Adds the samples of a block where `tile` sees something else than `opaque`; whether deeper
    /// layers can still be seen through any of them.
    #[inline(always)]
    pub(crate) fn add_layer<S: Simd>(
        &mut self,
        simd: S,
        scene: &ShadingContext<'_>,
        tile: &Tile,
        opaque: &Tile,
        block: usize,
        cache: &mut ThreadCache,
    ) -> bool {
        let mut layered = [0_u16; MAX_SAMPLES];
        let mut any = 0;
        for (sample, (plane, behind)) in tile.planes().iter().zip(opaque.planes()).enumerate() {
            for (lane, (id, other)) in plane.ids[block].iter().zip(&behind.ids[block]).enumerate() {
                layered[sample] |= u16::from(id != other) << lane;
            }
            any |= layered[sample];
        }
        if any == 0 {
            return false;
        }
        self.touched[block] |= any;
        self.gather(simd, scene, tile, block, cache, &layered)
    }

    /// Adds what is opaque, or the background, behind all layers of a block; `pixels`, but resolved
    /// where they have layers.
    #[inline(always)]
    pub(crate) fn finish_block<S: Simd>(
        &mut self,
        simd: S,
        scene: &ShadingContext<'_>,
        opaque: &Tile,
        block: usize,
        cache: &mut ThreadCache,
        pixels: [f32x16<S>; 4],
    ) -> [f32x16<S>; 4] {
        let touched = self.touched[block];
        self.gather(simd, scene, opaque, block, cache, &[touched; MAX_SAMPLES]);
        let mut sum = [f32x16::splat(simd, 0.0); 4];
        let share = 1.0 / self.samples as f32;
        for sample in 0..self.samples {
            let at = block * self.samples + sample;
            let light = [0, 1, 2].map(
                #[inline(always)]
                |channel| f32x16::simd_from(simd, self.light[at * 3 + channel]),
            );
            let through = f32x16::simd_from(simd, self.through[at]);
            Self::add_sample(&mut sum, light, through, f32x16::splat(simd, share));
        }
        let mut resolved = straight(sum);
        let mask = pixels[0].mask_of(touched.into());
        for (resolved, unlayered) in resolved.iter_mut().zip(pixels) {
            *resolved = Lanes::select(*resolved, mask, unlayered);
        }
        resolved
    }

    /// Adds the light that a sample gathered, and how much it covers.
    #[inline(always)]
    pub(crate) fn add_sample<N: Lanes>(sum: &mut [N; 4], light: [N; 3], through: N, share: N) {
        for channel in 0..3 {
            sum[channel] = sum[channel] + light[channel] * share;
        }
        sum[3] = sum[3] + (through.one() - through) * share;
    }

    /// Lights what the chosen samples of a block see, and puts it behind what they gathered. Outlined: one copy
    /// per instruction set.
    #[inline(never)]
    fn gather<S: Simd>(
        &mut self,
        simd: S,
        scene: &ShadingContext<'_>,
        tile: &Tile,
        block: usize,
        cache: &mut ThreadCache,
        chosen: &[u16; MAX_SAMPLES],
    ) -> bool {
        simd.vectorize(
            #[inline(always)]
            || {
                let distinct = DistinctTriangles::of(simd, tile, block);
                let Self { samples, light, through, compaction, .. } = self;
                compaction.add(simd, scene, tile, block, &distinct, cache);
                let mut seen_through = false;
                let put = |_: usize, lit: &[Lit], _: &mut ThreadCache| {
                    for Lit { sample: first, lanes, is_alone, color, .. } in lit {
                        let ids = &tile.planes()[*first].ids[block];
                        for (sample, plane) in tile.planes().iter().enumerate() {
                            if *is_alone && sample != *first {
                                continue;
                            }
                            let at = block * *samples + sample;
                            let alike = |lane: usize| plane.ids[block][lane] == ids[lane];
                            let here = lanes & u32::from(chosen[sample]);
                            for lane in lanes_of(here).filter(|&lane| alike(lane)) {
                                let own = [color[0][lane], color[1][lane], color[2][lane]];
                                let mut sum =
                                    [0, 1, 2].map(|channel| light[at * 3 + channel][lane]);
                                let through = &mut through[at][lane];
                                put_behind(&mut sum, through, own, color[3][lane]);
                                seen_through |= *through > OPAQUE_ENOUGH;
                                for (channel, sum) in sum.into_iter().enumerate() {
                                    light[at * 3 + channel][lane] = sum;
                                }
                            }
                        }
                    }
                };
                compaction.finish(simd, scene, cache, put);
                seen_through
            },
        )
    }
}
