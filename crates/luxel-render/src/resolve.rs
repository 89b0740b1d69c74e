//! Samples of a block become pixels: each distinct triangle of a pixel is lit once, at its covered
//! sample nearest the centre, and weighs its share of the samples.

use crate::plain::shade_plain;
use crate::shade::{Batch, Kept, Scene16, shade};
use luxel_lighting::Silent;
use luxel_math::{LANES, Simd, f32x16, mask32x16, prelude::*, u32x16};
use luxel_visibility::{MAX_SAMPLES, Samples, Tile, TriangleId};

/// The distinct triangles of each pixel of a block, in the order of their first samples: the first
/// ones of all pixels, then the second ones, and so on.
pub(crate) struct Ranks {
    pub(crate) list: Vec<Rank>,
}

/// One triangle of each pixel of a block.
#[derive(Clone, Copy)]
pub(crate) struct Rank {
    pub(crate) ids: [u32; LANES],
    /// Samples that see the triangle; 0 where a pixel has no more triangles.
    pub(crate) shares: [u32; LANES],
    /// The sample that stands for them: the one nearest the pixel's centre.
    pub(crate) sample: [u32; LANES],
}

impl Rank {
    const NOTHING: Self =
        Self { ids: [TriangleId::NONE.0; LANES], shares: [0; LANES], sample: [0; LANES] };
}

impl Ranks {
    /// Of any block.
    #[inline(always)]
    pub(crate) fn of<S: Simd>(simd: S, tile: &Tile, block: usize, samples: Samples) -> Self {
        let planes = tile.planes();
        let ids_of = |sample: usize| u32x16::simd_from(simd, planes[sample].ids[block]);
        let mut list: Vec<Rank> = Vec::with_capacity(planes.len());
        // How many ranks each pixel has so far.
        let mut used = u32x16::splat(simd, 0);
        for sample in 0..planes.len() {
            let id = ids_of(sample);
            let mut open = mask32x16::splat(simd, true);
            for rank in 0..planes.len() {
                if list.len() == rank {
                    list.push(Rank::NOTHING);
                }
                let own = &mut list[rank];
                // The rank that sees the same triangle, or else the next one.
                let ids = u32x16::simd_from(simd, own.ids);
                let is_new = open & used.simd_eq(rank as u32);
                let takes = is_new | open & ids.simd_eq(id);
                takes.select(id, ids).store_slice(&mut own.ids);
                add_one(simd, takes, &mut own.shares);
                used = is_new.select(used + 1, used);
                open &= !takes;
                if !open.any_true() {
                    break;
                }
            }
        }
        for rank in &mut list {
            let ids = u32x16::simd_from(simd, rank.ids);
            let mut nearest = u32x16::splat(simd, 0);
            for &sample in samples.nearest_first().iter().rev() {
                let sees = ids_of(usize::from(sample)).simd_eq(ids);
                nearest = sees.select(u32x16::splat(simd, sample.into()), nearest);
            }
            nearest.store_slice(&mut rank.sample);
        }
        Self { list }
    }
}

/// Adds 1 where the mask is true.
#[inline(always)]
fn add_one<S: Simd>(simd: S, mask: mask32x16<S>, counts: &mut [u32; LANES]) {
    let sum = u32x16::simd_from(simd, *counts);
    mask.select(sum + 1, sum).store_slice(counts);
}

/// Whether all samples of each pixel of a block see the same.
#[inline(always)]
fn is_even(tile: &Tile, block: usize) -> bool {
    let (first, others) = tile.planes().split_first().unzip();
    first.zip(others).is_none_or(|(first, others)| {
        others.iter().all(|plane| plane.ids[block] == first.ids[block])
    })
}

/// Whether nothing is seen in a block.
pub(crate) fn is_empty(tile: &Tile, block: usize) -> bool {
    tile.planes().iter().all(|plane| plane.ids[block] == [TriangleId::NONE.0; LANES])
}

/// [`is_empty`] by lanes.
#[inline(always)]
pub(crate) fn sees_nothing<S: Simd>(simd: S, tile: &Tile, block: usize) -> bool {
    // Nothing is the highest of all ids.
    let mut all = u32x16::splat(simd, TriangleId::NONE.0);
    for plane in tile.planes() {
        all &= u32x16::simd_from(simd, plane.ids[block]);
    }
    all.simd_eq(TriangleId::NONE.0).all_true()
}

/// A pixel of a block where nothing is seen.
pub(crate) fn empty_pixel(scene: &Scene16<'_>) -> [f32; 4] {
    let [.., alpha] = scene.background;
    if alpha > 0.0 { scene.background } else { [0.0; 4] }
}

/// The pixels of a block where nothing is seen.
#[inline(always)]
pub(crate) fn empty_block<S: Simd>(simd: S, scene: &Scene16<'_>) -> [f32x16<S>; 4] {
    let [r, g, b, alpha] = empty_pixel(scene);
    let like = f32x16::splat(simd, r);
    [like, like.constant(g), like.constant(b), like.constant(alpha)]
}

/// The pixels of a block without transparent surfaces: linear colour, straight, and alpha.
#[inline(always)]
pub(crate) fn resolve_block<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    tile: &Tile,
    block: usize,
    kept: &mut Kept,
) -> [f32x16<S>; 4] {
    let samples = scene.frame.samples();
    let mut sum = [f32x16::splat(simd, 0.0); 4];
    if is_even(tile, block) {
        // All samples of each pixel see the same.
        let ids = tile.planes()[0].ids[block];
        let batch = Batch::even(tile, block, ids, samples.nearest_first()[0], samples);
        let lit = lit_batch(simd, scene, &batch, kept);
        let [r, g, b, alpha] = lit;
        if alpha.equal(alpha.one()).all() {
            // All that is left of the sum below: -0 becomes 0.
            return [r + alpha.zero(), g + alpha.zero(), b + alpha.zero(), alpha];
        }
        add_share(&mut sum, lit, f32x16::splat(simd, 1.0));
        return straight(sum);
    }
    let ranks = Ranks::of(simd, tile, block, samples);
    let share_of_one = 1.0 / samples.count() as f32;
    for rank in &ranks.list {
        let batch = Batch::new(tile, block, rank.ids, &rank.sample, samples);
        let lit = lit_batch(simd, scene, &batch, kept);
        let shares = f32x16::float_from(u32x16::simd_from(simd, rank.shares));
        add_share(&mut sum, lit, shares * share_of_one);
    }
    straight(sum)
}

/// Colour (straight) and alpha of sixteen samples.
#[inline(always)]
fn lit_batch<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    batch: &Batch,
    kept: &mut Kept,
) -> [f32x16<S>; 4] {
    let like = f32x16::splat(simd, 0.0);
    if scene.is_plain {
        shade_plain(like, scene, batch, kept)
    } else {
        shade(like, scene, batch, kept, &mut Silent)
    }
}

/// Adds what a part of the samples sees: colour times alpha, and alpha.
#[inline(always)]
pub(crate) fn add_share<N: Number>(sum: &mut [N; 4], [r, g, b, alpha]: [N; 4], share: N) {
    let weight = share * alpha;
    *sum = [sum[0] + r * weight, sum[1] + g * weight, sum[2] + b * weight, sum[3] + weight];
}

/// Divides colours by alpha; black where alpha is 0.
#[inline(always)]
pub(crate) fn straight<N: Number>([r, g, b, alpha]: [N; 4]) -> [N; 4] {
    let seen = alpha.zero().less(alpha);
    let divisor = alpha.select(seen, alpha.one());
    [r / divisor, g / divisor, b / divisor, alpha]
}

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
        kept: &mut Kept,
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
        self.gather(simd, scene, tile, block, kept, &layered)
    }

    /// Adds what is opaque, or the background, behind all layers of a block; `pixels`, but resolved
    /// where they have layers.
    #[inline(always)]
    pub(crate) fn finish_block<S: Simd>(
        &mut self,
        simd: S,
        scene: &Scene16<'_>,
        opaque: &Tile,
        block: usize,
        kept: &mut Kept,
        pixels: [f32x16<S>; 4],
    ) -> [f32x16<S>; 4] {
        let touched = self.touched[block];
        self.gather(simd, scene, opaque, block, kept, &[touched; MAX_SAMPLES]);
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
            *resolved = Number::select(*resolved, mask, unlayered);
        }
        resolved
    }

    /// Adds the light that a sample gathered, and how much it covers.
    #[inline(always)]
    pub(crate) fn add_sample<N: Number>(sum: &mut [N; 4], light: [N; 3], through: N, share: N) {
        for channel in 0..3 {
            sum[channel] = sum[channel] + light[channel] * share;
        }
        sum[3] = sum[3] + (through.one() - through) * share;
    }

    /// Lights what the chosen samples of a block see, and puts it behind what they gathered.
    #[inline(always)]
    fn gather<S: Simd>(
        &mut self,
        simd: S,
        scene: &Scene16<'_>,
        tile: &Tile,
        block: usize,
        kept: &mut Kept,
        chosen: &[u16; MAX_SAMPLES],
    ) -> bool {
        let samples = scene.frame.samples();
        let ranks = Ranks::of(simd, tile, block, samples);
        let mut seen_through = false;
        for rank in &ranks.list {
            let batch = Batch::new(tile, block, rank.ids, &rank.sample, samples);
            let lit = shade(f32x16::splat(simd, 0.0), scene, &batch, kept, &mut Silent);
            for (sample, plane) in tile.planes().iter().enumerate() {
                let at = block * self.samples + sample;
                for lane in 0..LANES {
                    let here = chosen[sample] >> lane & 1 == 1
                        && rank.shares[lane] > 0
                        && plane.ids[block][lane] == rank.ids[lane];
                    if here {
                        let color = [lit[0][lane], lit[1][lane], lit[2][lane]];
                        let mut light = [0, 1, 2].map(|c| self.light[at * 3 + c][lane]);
                        let through = &mut self.through[at][lane];
                        put_behind(&mut light, through, color, lit[3][lane]);
                        seen_through |= *through > OPAQUE_ENOUGH;
                        for (channel, light) in light.into_iter().enumerate() {
                            self.light[at * 3 + channel][lane] = light;
                        }
                    }
                }
            }
        }
        seen_through
    }
}
