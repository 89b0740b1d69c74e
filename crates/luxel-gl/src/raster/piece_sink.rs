//! Takes the samples of one piece: tests, and writes (OpenGL 1.5, section 4.1).

use super::blend::{blended, compare, logic};
use super::framebuffer::{SamplePlanes, Uses};
use super::lighter::{Lighter, lanes_with_entry, light_seen};
use super::pending::PendingFragments;
use super::pipeline::Pipeline;
use super::samples::covered_by_alpha;
use super::shade::{Colors, Shading, decode, encode, shade};
use super::shaded::{BlockColors, ShadedBlocks};
use super::tile::{Seen, sees_any};
use crate::plane::{LANE_X, LANE_Y, TILE_BLOCKS, block_origin};
use luxel_math::{LANES, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*, u32x16};
use luxel_visibility::{Sink, Tile};
use std::sync::atomic::{AtomicU64, Ordering};

/// A bit for each lane.
const ALL_LANES: u32 = u16::MAX as u32;

/// Up to so many pixels of a block are deferred where pixels have several samples: pieces that cover more are shaded once for
/// all samples, which deferred ones aren't at edges. All up to 15 made a frame of MuJoCo's car take 1.1x the time.
const DEFERRED_WITH_SAMPLES: u32 = 8;

/// What decides about the samples of one piece.
#[derive(Clone, Copy)]
pub(super) struct Tests<'t> {
    pub(super) pipeline: &'t Pipeline,
    pub(super) uses: Uses,
    /// Pixels of the tile that may be drawn to: left, bottom, right, top.
    pub(super) limits: [i32; 4],
    /// Whether depth alone decides.
    pub(super) plain: bool,
    pub(super) stipple: Option<&'t [u32; 32]>,
    /// The piece's entry, from 1 on.
    pub(super) number: u32,
    /// What depths are moved by.
    pub(super) offset: f32,
    /// Whether fragments in blocks that are covered in part are deferred.
    pub(super) defers: bool,
    /// Counts the samples that pass; the sum doesn't depend on the order of tiles.
    pub(super) samples: Option<&'t AtomicU64>,
}

/// Takes the samples of one piece.
pub(super) struct PieceSink<'t, 'a, S> {
    pub(super) simd: S,
    /// Which sample of the pixels.
    pub(super) sample: usize,
    pub(super) planes: SamplePlanes<'t>,
    pub(super) seen: &'t mut Seen,
    pub(super) lighter: &'t mut Lighter<'a>,
    pub(super) shaded: &'t mut ShadedBlocks,
    /// Of each sample.
    pub(super) pending: &'t mut [PendingFragments],
    pub(super) origin: [i32; 2],
    pub(super) tests: Tests<'t>,
    /// Whether the limits are all pixels of the tile.
    pub(super) is_whole: bool,
    /// Colours of an image in the block that comes.
    pub(super) primary: Option<[[f32; LANES]; 4]>,
    /// The parts of pixels that are covered, by which alphas are multiplied, in the block that comes.
    pub(super) coverage: Option<[f32; LANES]>,
}

impl<S: Simd> Sink for PieceSink<'_, '_, S> {
    #[inline(always)]
    fn few(&mut self, _: [i32; 4]) {}

    #[inline(always)]
    fn blocks<T: Simd>(&mut self, _: T, _: i32, blocks: u32, _: f32x16<T>, _: bool) -> u32 {
        blocks
    }

    #[inline(always)]
    fn block<T: Simd>(&mut self, simd: T, covered: mask32x16<T>, z: f32x16<T>, block: usize) {
        let covered = if self.is_whole { covered } else { covered & self.allowed(simd, block) };
        if !covered.any_true() {
            return;
        }
        if !self.tests.plain {
            self.by_all_tests(covered.to_bitmask() as u32, &z.into(), block);
            return;
        }
        let mut passing = covered;
        if let Some((func, writes)) = self.tests.pipeline.depth {
            let z = self.planes.depth_kind.moved(z, self.tests.offset);
            let stored = f32x16::from_slice(simd, &self.planes.depth[block]);
            passing = covered & compare(func, z, stored);
            if writes {
                passing.select(z, stored).store_slice(&mut self.planes.depth[block]);
            }
        }
        if self.tests.pipeline.color_bits != 0 {
            let before = u32x16::from_slice(simd, &self.seen[block]);
            let number = u32x16::splat(simd, self.tests.number);
            passing.select(number, before).store_slice(&mut self.seen[block]);
        }
    }

    #[inline(always)]
    fn sample(&mut self, [column, row]: [i32; 2], _: [i32; 2], z: f32) {
        let [left, bottom, right, top] = self.tests.limits;
        if column < left || column >= right || row < bottom || row >= top {
            return;
        }
        let (block, lane) = Tile::place(column, row);
        let (block, lane) = (block & (TILE_BLOCKS - 1), lane & (LANES - 1));
        if !self.tests.plain {
            self.by_all_tests(1 << lane, &[z; LANES], block);
            return;
        }
        if let Some((func, writes)) = self.tests.pipeline.depth {
            let z = self.planes.depth_kind.moved(z, self.tests.offset);
            let stored = &mut self.planes.depth[block][lane];
            if !compare(func, z, *stored) {
                return;
            }
            if writes {
                *stored = z;
            }
        }
        if self.tests.pipeline.color_bits != 0 {
            self.seen[block][lane] = self.tests.number;
        }
    }
}

impl<S: Simd> PieceSink<'_, '_, S> {
    /// The lanes of a block that may be drawn to.
    #[inline(always)]
    fn allowed<T: Simd>(&self, simd: T, block: usize) -> mask32x16<T> {
        let [left, bottom, right, top] = self.tests.limits;
        let [x, y] = block_origin(block);
        let lane_x = i32x16::simd_from(simd, LANE_X) + x;
        let lane_y = i32x16::simd_from(simd, LANE_Y) + y;
        lane_x.simd_ge(left) & lane_x.simd_lt(right) & lane_y.simd_ge(bottom) & lane_y.simd_lt(top)
    }

    /// The lanes of a block where a polygon's stipple has a bit; all without one.
    #[inline(always)]
    fn stippled(&self, block: usize) -> u32 {
        let Some(stipple) = self.tests.stipple else { return ALL_LANES };
        let [x, y] = self.first_pixel(block);
        let bit = |lane: usize| {
            let (x, y) = ((x + LANE_X[lane]) as usize % 32, (y + LANE_Y[lane]) as usize % 32);
            stipple[y] >> (31 - x) & 1
        };
        (0..LANES).fold(0, |lanes, lane| lanes | bit(lane) << lane)
    }

    /// Fragments by stipple, alpha test, stencil and depth, in the order of section 4.1; then colours into the buffer,
    /// or the piece's number where they take no notice of what is there.
    #[inline(never)]
    pub(super) fn by_all_tests(&mut self, covered: u32, z: &[f32; LANES], block: usize) {
        if self.tests.defers && self.defers(covered, z, block) {
            return;
        }
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            || self.tested(simd, (covered, z), block, None),
        );
    }

    /// Defers fragments, unless they fill the block, or most of it where there are several samples, or have colours or
    /// coverage of their own: whether it does. Pending ones of the same pixels are carried out first.
    #[inline(never)]
    fn defers(&mut self, covered: u32, z: &[f32; LANES], block: usize) -> bool {
        let most =
            if self.shaded.keeps() { DEFERRED_WITH_SAMPLES } else { ALL_LANES.count_ones() - 1 };
        let is_alone =
            covered.count_ones() > most || self.primary.is_some() || self.coverage.is_some();
        if is_alone {
            if self.pending[self.sample].lanes(self.simd, block) & covered != 0 {
                self.carry_out_block(block);
            }
            return false;
        }
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            || self.defer(simd, covered, z, block),
        );
        true
    }

    #[inline(always)]
    fn defer(&mut self, simd: S, covered: u32, z: &[f32; LANES], block: usize) {
        let mut lanes = covered & self.stippled(block);
        if self.pending[self.sample].lanes(simd, block) & lanes != 0 {
            self.carry_out_block(block);
        }
        let mut z = f32x16::from_slice(simd, z);
        let pipeline = self.tests.pipeline;
        if let Some((func, _)) = pipeline.depth {
            z = self.planes.depth_kind.moved(z, self.tests.offset);
            // The depth that is there stays until they are carried out.
            if pipeline.stencil.is_none() {
                let stored = f32x16::from_slice(simd, &self.planes.depth[block]);
                lanes &= compare(func, z, stored).to_bitmask() as u32;
            }
        }
        if lanes != 0 {
            self.pending[self.sample].put(self.tests.number, lanes, z, block);
        }
    }

    /// Carries out all pending fragments.
    pub(super) fn carry_out_pending(&mut self) {
        while let Some(block) = self.pending[self.sample].any_block() {
            self.carry_out_block(block);
        }
    }

    /// Carries out the pending fragments of a block.
    #[inline(never)]
    fn carry_out_block(&mut self, block: usize) {
        let simd = self.simd;
        let (numbers, depths) = self.pending[self.sample].take(block);
        let colors = self.colors_of_lanes(&numbers, block);
        simd.vectorize(
            #[inline(always)]
            || {
                let lanes = lanes_with_entry(u32x16::from_slice(simd, &numbers));
                self.tested(simd, (lanes, &depths), block, Some(&colors));
            },
        );
    }

    /// Fragments by all tests. Deferred ones come with their colours, and are stippled and moved already.
    #[inline(always)]
    fn tested(
        &mut self,
        simd: S,
        (mut lanes, z): (u32, &[f32; LANES]),
        block: usize,
        deferred: Option<&BlockColors>,
    ) {
        if deferred.is_none() {
            lanes &= self.stippled(block);
        }
        // Colours of an image are known now alone.
        let mixing =
            self.tests.pipeline.is_mixing() || self.primary.is_some() || self.coverage.is_some();
        let mut colors = None;
        if let Some(multisample) =
            self.tests.pipeline.multisample.as_ref().filter(|of| of.needs_colors())
        {
            let mut shaded = self.colors(simd, block, lanes, deferred);
            if multisample.alpha_to_coverage {
                lanes &= covered_by_alpha(shaded[3], self.sample).to_bitmask() as u32;
            }
            if multisample.alpha_to_one {
                shaded[3] = f32x16::splat(simd, 1.0);
            }
            colors = Some(shaded);
        }
        if let Some((func, reference)) = self.tests.pipeline.alpha_test {
            let shaded = match colors {
                Some(shaded) => shaded,
                None => self.colors(simd, block, lanes, deferred),
            };
            let reference = f32x16::splat(simd, reference);
            lanes &= compare(func, shaded[3], reference).to_bitmask() as u32;
            colors = Some(shaded);
        }
        if lanes == 0 {
            return;
        }
        let mut passing = lanes;
        let stencil = self.tests.pipeline.stencil.as_ref();
        if let Some(test) = stencil {
            passing = test.passing(lanes, &self.planes.stencil[block]);
        }
        let after_stencil = passing;
        if let Some((func, writes)) = self.tests.pipeline.depth {
            let mut z = f32x16::from_slice(simd, z);
            if deferred.is_none() {
                z = self.planes.depth_kind.moved(z, self.tests.offset);
            }
            let stored = f32x16::from_slice(simd, &self.planes.depth[block]);
            let passes = compare(func, z, stored).to_bitmask() as u32;
            passing &= passes;
            if writes {
                let mask = mask32x16::from_bitmask(simd, u64::from(passing));
                mask.select(z, stored).store_slice(&mut self.planes.depth[block]);
            }
        }
        if let Some(test) = stencil {
            let outcomes = [lanes & !after_stencil, after_stencil & !passing, passing];
            test.update(outcomes, &mut self.planes.stencil[block]);
        }
        if let Some(samples) = self.tests.samples {
            samples.fetch_add(u64::from(passing.count_ones()), Ordering::Relaxed);
        }
        if passing == 0 || self.tests.pipeline.color_bits == 0 {
            return;
        }
        if !mixing {
            for lane in lanes_of(passing) {
                self.seen[block][lane] = self.tests.number;
            }
            return;
        }
        let colors = match colors {
            Some(colors) => colors,
            None => self.colors(simd, block, passing, deferred),
        };
        if sees_any(&self.seen[block]) {
            let (seen, color) = (&mut self.seen[block], &mut *self.planes.color);
            light_seen(simd, self.origin, block, seen, self.lighter, color);
        }
        self.mix(simd, passing, colors, block);
    }

    /// The piece's own colours, or those of deferred fragments, with coverage in their alphas.
    #[inline(always)]
    fn colors(
        &mut self,
        simd: S,
        block: usize,
        lanes: u32,
        deferred: Option<&BlockColors>,
    ) -> Colors<S> {
        if let Some(colors) = deferred {
            return loaded(simd, colors);
        }
        let mut colors = self.shaded_colors(simd, block, lanes);
        if let Some(coverage) = &self.coverage {
            colors[3] *= f32x16::from_slice(simd, coverage);
        }
        colors
    }

    #[inline(always)]
    fn shaded_colors(&mut self, simd: S, block: usize, mut lanes: u32) -> Colors<S> {
        let numbers = u32x16::splat(simd, self.tests.number);
        if let Some((colors, known)) = self.shaded.get(numbers, block) {
            if lanes & !known == 0 {
                return loaded(simd, colors);
            }
            // Other samples may cover other pixels.
            lanes = ALL_LANES;
        }
        let place = self.lighter.prepare(self.tests.number);
        let prepared = self.lighter.at(place);
        let colors = shade(
            simd,
            self.first_pixel(block),
            #[inline(always)]
            |_| prepared,
            true,
            self.shading(lanes),
        );
        self.shaded.put(numbers, colors, lanes, block);
        colors
    }

    /// Colours of a block, of each lane by its own entry.
    #[inline(never)]
    fn colors_of_lanes(&mut self, numbers: &[u32; LANES], block: usize) -> BlockColors {
        let simd = self.simd;
        let mut stored = [[0.0; LANES]; 4];
        simd.vectorize(
            #[inline(always)]
            || {
                let own = u32x16::from_slice(simd, numbers);
                // With those of other samples at pixels that this one doesn't cover.
                let mut wanted = own;
                if self.shaded.keeps() {
                    for pending in self.pending.iter().filter(|of| of.has(block)) {
                        let others = pending.numbers(simd, block);
                        wanted = wanted.simd_eq(0).select(others, wanted);
                    }
                }
                let known = self.shaded.get(wanted, block).map_or(0, |(_, known)| known);
                let mut colors = [f32x16::splat(simd, 0.0); 4];
                if lanes_with_entry(own) & !known != 0 {
                    let lanes = lanes_with_entry(wanted) & !known;
                    let mut numbers = [0; LANES];
                    wanted.store_slice(&mut numbers);
                    let Some(prepared) = self.lighter.prepare_lanes(simd, &numbers, lanes) else {
                        return;
                    };
                    let of = self.lighter.of_lanes(&prepared);
                    colors = shade(
                        simd,
                        self.first_pixel(block),
                        #[inline(always)]
                        |lane| of[lane & (LANES - 1)],
                        prepared.alike,
                        self.shading(lanes),
                    );
                    self.shaded.put(wanted, colors, lanes, block);
                }
                if let Some((kept, _)) = self.shaded.get(wanted, block) {
                    stored = *kept;
                    return;
                }
                for (stored, color) in stored.iter_mut().zip(colors) {
                    color.store_slice(stored);
                }
            },
        );
        stored
    }

    /// The first pixel of a block in the window.
    #[inline(always)]
    fn first_pixel(&self, block: usize) -> [i32; 2] {
        let [x, y] = block_origin(block);
        [self.origin[0] + x, self.origin[1] + y]
    }

    /// What fragments of the piece go through after interpolation.
    #[inline(always)]
    fn shading(&self, lanes: u32) -> Shading<'_> {
        Shading {
            textures: self.tests.pipeline.textures.as_ref(),
            rows: self.lighter.rows(),
            fog: self.tests.pipeline.fog.as_ref(),
            primary: self.primary.as_ref(),
            lanes,
        }
    }

    /// Writes colours by blending, logical operation and mask.
    #[inline(always)]
    fn mix(&mut self, simd: S, lanes: u32, colors: Colors<S>, block: usize) {
        let stored = u32x16::from_slice(simd, &self.planes.color[block]);
        let mut words = match &self.tests.pipeline.blend {
            Some(blend) => encode(blended(blend, &colors, &decode(stored))),
            None => encode(colors),
        };
        if let Some(operation) = self.tests.pipeline.logic_op {
            words = logic(operation, words, stored);
        }
        let bits = self.tests.pipeline.color_bits;
        let written = (words & bits) | (stored & !bits);
        let mask = mask32x16::from_bitmask(simd, u64::from(lanes));
        mask.select(written, stored).store_slice(&mut self.planes.color[block]);
    }
}

/// Colours that were kept.
#[inline(always)]
fn loaded<S: Simd>(simd: S, kept: &BlockColors) -> Colors<S> {
    let mut colors = [f32x16::splat(simd, 0.0); 4];
    for (color, kept) in colors.iter_mut().zip(kept) {
        *color = f32x16::from_slice(simd, kept);
    }
    colors
}
