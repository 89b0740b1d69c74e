//! Samples of a block become pixels: each distinct triangle of a pixel is lit once, at its covered
//! sample nearest the centre, and weighs its share of the samples.

use crate::corners::Corners;
use crate::shade::{Batch, Scene16, shade};
use luxel_math::{LANES, Simd, f32x16, prelude::*};
use luxel_visibility::{MAX_SAMPLES, Samples, Tile, TriangleId};

/// Colour and alpha of sixteen pixels, linear; colour is straight, not multiplied by alpha.
pub(crate) type BlockPixels = [[f32; LANES]; 4];

/// The distinct triangles of each pixel of a block, in the order of their first samples.
struct Ranks {
    count: usize,
    ids: [[u32; LANES]; MAX_SAMPLES],
    /// Samples that see the triangle.
    shares: [[u8; LANES]; MAX_SAMPLES],
    /// The sample that stands for them.
    sample: [[u8; LANES]; MAX_SAMPLES],
}

impl Ranks {
    fn of(tile: &Tile, block: usize, samples: Samples) -> Self {
        let planes = tile.planes();
        let mut ranks = Self {
            count: 1,
            ids: [[TriangleId::NONE.0; LANES]; MAX_SAMPLES],
            shares: [[0; LANES]; MAX_SAMPLES],
            sample: [[0; LANES]; MAX_SAMPLES],
        };
        let first = &planes[0].ids[block];
        let nearest_first = samples.nearest_first();
        if planes[1..].iter().all(|plane| plane.ids[block] == *first) {
            ranks.ids[0] = *first;
            ranks.shares[0] = [samples.count() as u8; LANES];
            ranks.sample[0] = [nearest_first[0]; LANES];
            return ranks;
        }
        for lane in 0..LANES {
            let mut used = 0;
            for plane in planes {
                let id = plane.ids[block][lane];
                let known = (0..used).find(|&rank| ranks.ids[rank][lane] == id);
                let rank = known.unwrap_or(used);
                if rank == used {
                    ranks.ids[rank][lane] = id;
                    used += 1;
                    let sees = |&&sample: &&u8| planes[usize::from(sample)].ids[block][lane] == id;
                    ranks.sample[rank][lane] =
                        nearest_first.iter().find(sees).copied().unwrap_or(0);
                }
                ranks.shares[rank][lane] += 1;
            }
            ranks.count = ranks.count.max(used);
        }
        ranks
    }

    /// What one rank of a block asks to be lit.
    fn batch(&self, rank: usize, tile: &Tile, block: usize, samples: Samples) -> Batch {
        Batch::new(tile, block, self.ids[rank], &self.sample[rank], samples)
    }
}

/// The pixels of a block without transparent surfaces.
#[inline(always)]
pub(crate) fn resolve_block<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    tile: &Tile,
    block: usize,
    corners: &mut Corners,
) -> BlockPixels {
    let samples = scene.frame.samples();
    let ranks = Ranks::of(tile, block, samples);
    let mut sum = [f32x16::splat(simd, 0.0); 4];
    let share_of_one = 1.0 / samples.count() as f32;
    for rank in 0..ranks.count {
        let batch = ranks.batch(rank, tile, block, samples);
        let [r, g, b, alpha] = shade(simd, scene, &batch, corners);
        let shares = ranks.shares[rank].map(f32::from);
        let weight = f32x16::simd_from(simd, shares) * share_of_one * alpha;
        sum = [sum[0] + r * weight, sum[1] + g * weight, sum[2] + b * weight, sum[3] + weight];
    }
    straight(sum)
}

/// Divides colours by alpha; black where alpha is 0.
#[inline(always)]
fn straight<S: Simd>([r, g, b, alpha]: [f32x16<S>; 4]) -> BlockPixels {
    let seen = alpha.zero().less(alpha);
    let divisor = alpha.select(seen, alpha.one());
    [r / divisor, g / divisor, b / divisor, alpha].map(|lanes| {
        let mut out = [0.0; LANES];
        lanes.store_slice(&mut out);
        out
    })
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
}

/// Where less comes through than this, deeper layers can't be seen in 16 bits a channel.
const OPAQUE_ENOUGH: f32 = 1.0 / (1 << 20) as f32;

impl Layered {
    pub(crate) fn new(samples: usize) -> Self {
        Self { samples, light: Vec::new(), through: Vec::new(), touched: Vec::new() }
    }

    /// Forgets everything.
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
        scene: &Scene16<'_>,
        tile: &Tile,
        opaque: &Tile,
        block: usize,
        corners: &mut Corners,
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
        self.gather(simd, scene, tile, block, corners, &layered)
    }

    /// Adds what is opaque, or the background, behind all layers of a block, and resolves those of
    /// its pixels that have layers.
    #[inline(always)]
    pub(crate) fn finish_block<S: Simd>(
        &mut self,
        simd: S,
        scene: &Scene16<'_>,
        opaque: &Tile,
        block: usize,
        corners: &mut Corners,
        pixels: &mut BlockPixels,
    ) {
        let touched = self.touched[block];
        self.gather(simd, scene, opaque, block, corners, &[touched; MAX_SAMPLES]);
        let mut sum = [f32x16::splat(simd, 0.0); 4];
        let share = 1.0 / self.samples as f32;
        for sample in 0..self.samples {
            let at = block * self.samples + sample;
            for channel in 0..3 {
                let light = f32x16::simd_from(simd, self.light[at * 3 + channel]);
                sum[channel] += light * share;
            }
            let through = f32x16::simd_from(simd, self.through[at]);
            sum[3] += (through.one() - through) * share;
        }
        let resolved = straight(sum);
        for (channel, values) in pixels.iter_mut().enumerate() {
            for (lane, value) in values.iter_mut().enumerate() {
                if touched >> lane & 1 == 1 {
                    *value = resolved[channel][lane];
                }
            }
        }
    }

    /// Lights what the chosen samples of a block see, and puts it behind what they gathered.
    #[inline(always)]
    fn gather<S: Simd>(
        &mut self,
        simd: S,
        scene: &Scene16<'_>,
        tile: &Tile,
        block: usize,
        corners: &mut Corners,
        chosen: &[u16; MAX_SAMPLES],
    ) -> bool {
        let samples = scene.frame.samples();
        let ranks = Ranks::of(tile, block, samples);
        let mut seen_through = false;
        for rank in 0..ranks.count {
            let batch = ranks.batch(rank, tile, block, samples);
            let lit = shade(simd, scene, &batch, corners);
            for (sample, plane) in tile.planes().iter().enumerate() {
                let at = block * self.samples + sample;
                for lane in 0..LANES {
                    let here = chosen[sample] >> lane & 1 == 1
                        && ranks.shares[rank][lane] > 0
                        && plane.ids[block][lane] == ranks.ids[rank][lane];
                    if here {
                        let through = self.through[at][lane];
                        let alpha = lit[3][lane];
                        for channel in 0..3 {
                            self.light[at * 3 + channel][lane] +=
                                through * alpha * lit[channel][lane];
                        }
                        self.through[at][lane] = through * (1.0 - alpha);
                        seen_through |= self.through[at][lane] > OPAQUE_ENOUGH;
                    }
                }
            }
        }
        seen_through
    }
}
