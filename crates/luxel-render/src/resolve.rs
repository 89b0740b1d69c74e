//! Samples of a block become pixels: each distinct triangle of a pixel is lit once, at its covered
//! sample nearest the centre, and weighs its share of the samples.

use crate::firsts::Firsts;
use crate::packed::{Lit, Packed};
use crate::plain::shade_plain;
use crate::shade::{Batch, Kept, Scene16, shade};
use crate::varying::lanes_of;
use luxel_lighting::Silent;
use luxel_math::{LANES, Simd, f32x16, mask32x16, prelude::*, u32x16};
use luxel_visibility::{MAX_SAMPLES, Tile, TriangleId};

/// Whether nothing is seen in a block.
pub(crate) fn is_empty(tile: &Tile, block: usize) -> bool {
    tile.planes().iter().all(|plane| plane.ids[block] == [TriangleId::NONE.0; LANES])
}

/// What all samples of a block see, if it is the same.
#[inline(always)]
pub(crate) fn sees_one<S: Simd>(simd: S, tile: &Tile, block: usize) -> Option<u32> {
    let id = tile.planes()[0].ids[block][0];
    let mut same = mask32x16::splat(simd, true);
    for plane in tile.planes() {
        same &= u32x16::simd_from(simd, plane.ids[block]).simd_eq(id);
    }
    same.all_true().then_some(id)
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

/// The pixels of a block all samples of whose pixels see the same.
#[inline(always)]
pub(crate) fn even_block<S: Simd>(
    simd: S,
    scene: &Scene16<'_>,
    tile: &Tile,
    block: usize,
    kept: &mut Kept,
) -> [f32x16<S>; 4] {
    let samples = scene.frame.samples();
    let ids = tile.planes()[0].ids[block];
    let batch = Batch::even(tile, block, ids, samples.nearest_first()[0], samples);
    let lit = lit_batch(simd, scene, &batch, kept);
    let [r, g, b, alpha] = lit;
    let zero = f32x16::splat(simd, 0.0);
    if alpha.equal(alpha.one()).all() {
        // All that is left of the sum below: -0 becomes 0.
        return [r + zero, g + zero, b + zero, alpha];
    }
    let mut sum = [zero; 4];
    add_share(&mut sum, lit, f32x16::splat(simd, 1.0));
    straight(sum)
}

/// The pixels of a block whose samples see several triangles.
#[inline(always)]
pub(crate) fn uneven_block<S: Simd>(simd: S, scene: &Scene16<'_>, lit: &[Lit]) -> [f32x16<S>; 4] {
    let share_of_one = 1.0 / scene.frame.samples().count() as f32;
    let mut sum = [f32x16::splat(simd, 0.0); 4];
    for Lit { shares, color, .. } in lit {
        let shares = f32x16::float_from(u32x16::simd_from(simd, *shares));
        let color = color.map(
            #[inline(always)]
            |channel| f32x16::simd_from(simd, channel),
        );
        add_share(&mut sum, color, shares * share_of_one);
    }
    straight(sum)
}

/// Colour (straight) and alpha of sixteen samples.
#[inline(always)]
pub(crate) fn lit_batch<S: Simd>(
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
    packed: Packed,
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
            packed: Packed::new(),
        }
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
        let firsts = Firsts::of(simd, tile, block);
        let Self { samples, light, through, packed, .. } = self;
        packed.add(simd, scene, tile, block, &firsts, kept);
        let mut seen_through = false;
        let put = |_: usize, lit: &[Lit], _: &mut Kept| {
            for Lit { sample: first, lanes, color, .. } in lit {
                let ids = &tile.planes()[*first].ids[block];
                for (sample, plane) in tile.planes().iter().enumerate() {
                    let at = block * *samples + sample;
                    let alike = |lane: usize| plane.ids[block][lane] == ids[lane];
                    let here = lanes & u32::from(chosen[sample]);
                    for lane in lanes_of(here).filter(|&lane| alike(lane)) {
                        let own = [color[0][lane], color[1][lane], color[2][lane]];
                        let mut sum = [0, 1, 2].map(|channel| light[at * 3 + channel][lane]);
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
        packed.finish(simd, scene, kept, put);
        seen_through
    }
}
