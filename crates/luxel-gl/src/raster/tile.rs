//! One tile's part of the log, in the order of the log.

use super::batch::{Batch, Piece, Prepared, Shape};
use super::blend::{blended, compare, logic};
use super::framebuffer::{LARGEST_DEPTH, TILE_BLOCKS, TilePlanes};
use super::log::{ClearedTo, Item};
use super::pipeline::Pipeline;
use super::shade::{Colors, decode, encode, shade};
use crate::primitive::line::LineWalk;
use luxel_math::{
    LANES, Lanes, SUBPIXELS, Simd, f32x16, i32x16, lanes_of, mask32x16, prelude::*, u32x16,
};
use luxel_visibility::{BLOCK, BLOCKS, DepthPlane, Region, Sink, TILE, Tile, cover};
use std::sync::Arc;

/// A piece of a batch, or a clear.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    pub(super) item: u32,
    pub(super) piece: u32,
}

/// Where samples lie in a pixel: at its centre.
const CENTRE: [i32; 2] = [SUBPIXELS / 2; 2];

/// Columns and rows of a block's lanes.
const LANE_X: [i32; LANES] = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3];
const LANE_Y: [i32; LANES] = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3];

/// What carries out one tile's list.
pub(super) struct TileWorker<'a> {
    planes: &'a mut TilePlanes,
    /// Of each pixel the entry that it sees and that hasn't been lit, from 1 on; 0 for none.
    seen: Box<[[u32; LANES]; TILE_BLOCKS]>,
    lighter: Lighter<'a>,
    /// The tile's first pixel in the window.
    origin: [i32; 2],
    /// Its pixels that the window has.
    region: Region,
}

/// Finds what shades an entry; each is prepared once.
struct Lighter<'a> {
    items: &'a [Item],
    list: &'a [Entry],
    /// Of each entry the place in `prepared`, from 1 on.
    places: Vec<u32>,
    prepared: Vec<Prepared>,
}

impl<'a> Lighter<'a> {
    fn batch(&self, number: u32) -> Option<(&'a Batch, &'a Piece)> {
        let entry = self.list.get((number as usize).wrapping_sub(1))?;
        match &self.items[entry.item as usize] {
            Item::Batch(batch) => Some((batch, &batch.pieces[entry.piece as usize])),
            Item::Clear(_) => None,
        }
    }

    /// Prepares an entry, and returns its place.
    fn prepare(&mut self, number: u32) -> usize {
        let at = number as usize - 1;
        if self.places[at] == 0
            && let Some((batch, piece)) = self.batch(number)
        {
            self.prepared.push(batch.prepare(piece));
            self.places[at] = self.prepared.len() as u32;
        }
        (self.places[at] as usize).saturating_sub(1)
    }
}

impl<'a> TileWorker<'a> {
    pub(super) fn new(
        items: &'a [Item],
        list: &'a [Entry],
        origin: [i32; 2],
        [width, height]: [i32; 2],
        planes: &'a mut TilePlanes,
    ) -> Self {
        let region = Region {
            x: origin[0],
            y: origin[1],
            width: TILE.min(width - origin[0]),
            height: TILE.min(height - origin[1]),
        };
        let places = vec![0; list.len()];
        let lighter = Lighter { items, list, places, prepared: Vec::new() };
        Self { planes, seen: Box::new([[0; LANES]; TILE_BLOCKS]), lighter, origin, region }
    }

    /// Carries the list out; then lights what is seen at last.
    #[inline(always)]
    pub(super) fn carry_out<S: Simd>(&mut self, simd: S) {
        let list = self.lighter.list;
        for (at, entry) in list.iter().enumerate() {
            match &self.lighter.items[entry.item as usize] {
                Item::Clear(clear) => {
                    if clear.color_mask != 0 && clear.color_mask != u32::MAX {
                        self.light(simd);
                    }
                    self.clear(clear);
                }
                Item::Batch(batch) => {
                    let piece = &batch.pieces[entry.piece as usize];
                    self.piece(simd, batch, piece, at as u32 + 1);
                }
            }
        }
        self.light(simd);
    }

    /// Lights what is seen.
    fn light<S: Simd>(&mut self, simd: S) {
        for (block, seen) in self.seen.iter_mut().enumerate() {
            if seen.iter().any(|seen| *seen != 0) {
                light_seen(simd, self.origin, block, seen, &mut self.lighter, self.planes);
            }
        }
    }

    /// A region of the window within the tile: left, bottom, right and top of its own pixels.
    fn within(&self, [left, bottom, right, top]: [i32; 4]) -> [i32; 4] {
        let [x, y] = self.origin;
        [
            (left - x).max(0),
            (bottom - y).max(0),
            (right - x).min(self.region.width),
            (top - y).min(self.region.height),
        ]
    }

    fn clear(&mut self, clear: &ClearedTo) {
        let [left, bottom, right, top] = self.within(clear.region);
        let whole = [left, bottom, right, top] == [0, 0, self.region.width, self.region.height];
        for block in 0..TILE_BLOCKS {
            let first = block_origin(block);
            let inside = |lane: usize| {
                let (x, y) = (first[0] + LANE_X[lane], first[1] + LANE_Y[lane]);
                whole || x >= left && x < right && y >= bottom && y < top
            };
            for lane in 0..LANES {
                if !inside(lane) {
                    continue;
                }
                if clear.color_mask == u32::MAX {
                    self.seen[block][lane] = 0;
                }
                let color = &mut self.planes.color[block][lane];
                *color = *color & !clear.color_mask | clear.color & clear.color_mask;
                if let Some(depth) = clear.depth {
                    self.planes.depth[block][lane] = depth;
                }
                let stencil = &mut self.planes.stencil[block][lane];
                *stencil = *stencil & !clear.stencil_mask | clear.stencil & clear.stencil_mask;
            }
        }
    }

    #[inline(always)]
    fn piece<S: Simd>(&mut self, simd: S, batch: &'a Batch, piece: &Piece, number: u32) {
        let pipeline = &*batch.pipeline;
        let of_polygon = matches!(piece.shape, Shape::Triangle(_));
        let limits = if of_polygon { batch.polygon_region } else { pipeline.region };
        let limits = self.within(limits);
        let plain = pipeline.stencil.is_none()
            && !pipeline.is_mixing()
            && (pipeline.polygon_stipple.is_none() || !of_polygon);
        let (region, origin) = (self.region, self.origin);
        let mut sink = PieceSink {
            simd,
            planes: self.planes,
            seen: &mut self.seen,
            lighter: &mut self.lighter,
            pipeline,
            origin,
            limits,
            is_whole: limits == [0, 0, TILE, TILE],
            plain,
            stipple: pipeline.polygon_stipple.as_ref().filter(|_| of_polygon),
            number,
        };
        match piece.shape {
            Shape::Triangle(ref triangle) => cover(simd, triangle, region, CENTRE, &mut sink),
            Shape::Line { ends, depths, width, counter } => {
                line(&mut sink, ends, depths, width, counter);
            }
            Shape::Point { corner, side, depth } => point(&mut sink, corner, side, depth),
        }
    }
}

/// The first pixel of a block within its tile.
fn block_origin(block: usize) -> [i32; 2] {
    let block = block as i32;
    [block % BLOCKS * BLOCK, block / BLOCKS * BLOCK]
}

/// Takes the samples of one piece.
struct PieceSink<'t, 'a, S> {
    simd: S,
    planes: &'t mut TilePlanes,
    seen: &'t mut [[u32; LANES]; TILE_BLOCKS],
    lighter: &'t mut Lighter<'a>,
    pipeline: &'t Pipeline,
    origin: [i32; 2],
    /// Pixels of the tile that may be drawn to: left, bottom, right, top.
    limits: [i32; 4],
    is_whole: bool,
    /// Whether depth alone decides.
    plain: bool,
    stipple: Option<&'t [u32; 32]>,
    number: u32,
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
        if !self.plain {
            self.by_all_tests(covered.to_bitmask() as u32, &z.into(), block);
            return;
        }
        let mut passing = covered;
        if let Some((func, writes)) = self.pipeline.depth {
            let z = quantized(z);
            let stored = f32x16::from_slice(simd, &self.planes.depth[block]);
            passing = covered & compare(func, z, stored);
            if writes {
                passing.select(z, stored).store_slice(&mut self.planes.depth[block]);
            }
        }
        if self.pipeline.color_bits != 0 {
            let before = u32x16::from_slice(simd, &self.seen[block]);
            let number = u32x16::splat(simd, self.number);
            passing.select(number, before).store_slice(&mut self.seen[block]);
        }
    }

    #[inline(always)]
    fn sample(&mut self, [column, row]: [i32; 2], _: [i32; 2], z: f32) {
        let [left, bottom, right, top] = self.limits;
        if column < left || column >= right || row < bottom || row >= top {
            return;
        }
        let (block, lane) = Tile::place(column, row);
        let (block, lane) = (block & (TILE_BLOCKS - 1), lane & (LANES - 1));
        if !self.plain {
            self.by_all_tests(1 << lane, &[z; LANES], block);
            return;
        }
        if let Some((func, writes)) = self.pipeline.depth {
            let z = quantized(z);
            let stored = &mut self.planes.depth[block][lane];
            if !compare(func, z, *stored) {
                return;
            }
            if writes {
                *stored = z;
            }
        }
        if self.pipeline.color_bits != 0 {
            self.seen[block][lane] = self.number;
        }
    }
}

/// A depth as the buffer has it: one of 2^24 steps.
#[inline(always)]
fn quantized<N: Lanes>(z: N) -> N {
    z.clamped(0.0, LARGEST_DEPTH).round_ties_even()
}

impl<S: Simd> PieceSink<'_, '_, S> {
    /// The lanes of a block that may be drawn to.
    #[inline(always)]
    fn allowed<T: Simd>(&self, simd: T, block: usize) -> mask32x16<T> {
        let [left, bottom, right, top] = self.limits;
        let [x, y] = block_origin(block);
        let lane_x = i32x16::simd_from(simd, LANE_X) + x;
        let lane_y = i32x16::simd_from(simd, LANE_Y) + y;
        lane_x.simd_ge(left) & lane_x.simd_lt(right) & lane_y.simd_ge(bottom) & lane_y.simd_lt(top)
    }

    /// Fragments by stipple, alpha test, stencil and depth, in the order of section 4.1; then colours into the buffer,
    /// or the piece's number where they take no notice of what is there.
    #[inline(never)]
    fn by_all_tests(&mut self, covered: u32, z: &[f32; LANES], block: usize) {
        let simd = self.simd;
        simd.vectorize(
            #[inline(always)]
            || self.tested(simd, covered, z, block),
        );
    }

    #[inline(always)]
    fn tested(&mut self, simd: S, mut lanes: u32, z: &[f32; LANES], block: usize) {
        if let Some(stipple) = self.stipple {
            lanes &= stippled(stipple, self.origin, block);
        }
        let mixing = self.pipeline.is_mixing();
        let mut colors = None;
        if let Some((func, reference)) = self.pipeline.alpha_test {
            let shaded = self.colors(simd, block);
            let reference = f32x16::splat(simd, reference);
            lanes &= compare(func, shaded[3], reference).to_bitmask() as u32;
            colors = Some(shaded);
        }
        if lanes == 0 {
            return;
        }
        let mut passing = lanes;
        let stencil = self.pipeline.stencil.as_ref();
        if let Some(test) = stencil {
            passing = test.passing(lanes, &self.planes.stencil[block]);
        }
        let after_stencil = passing;
        if let Some((func, writes)) = self.pipeline.depth {
            let z = quantized(f32x16::from_slice(simd, z));
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
        if passing == 0 || self.pipeline.color_bits == 0 {
            return;
        }
        if !mixing {
            for lane in lanes_of(passing) {
                self.seen[block][lane] = self.number;
            }
            return;
        }
        let colors = match colors {
            Some(colors) => colors,
            None => self.colors(simd, block),
        };
        if self.seen[block].iter().any(|seen| *seen != 0) {
            light_seen(simd, self.origin, block, &mut self.seen[block], self.lighter, self.planes);
        }
        self.mix(simd, passing, colors, block);
    }

    /// The piece's own colours.
    #[inline(always)]
    fn colors(&mut self, simd: S, block: usize) -> Colors<S> {
        let place = self.lighter.prepare(self.number);
        let prepared = &self.lighter.prepared[place];
        let [x, y] = block_origin(block);
        let origin = [self.origin[0] + x, self.origin[1] + y];
        shade(
            simd,
            origin,
            #[inline(always)]
            |_| prepared,
            true,
            self.pipeline.fog.as_ref(),
        )
    }

    /// Writes colours by blending, logical operation and mask.
    #[inline(always)]
    fn mix(&mut self, simd: S, lanes: u32, colors: Colors<S>, block: usize) {
        let stored = u32x16::from_slice(simd, &self.planes.color[block]);
        let mut words = match &self.pipeline.blend {
            Some(blend) => encode(blended(blend, &colors, &decode(stored))),
            None => encode(colors),
        };
        if let Some(operation) = self.pipeline.logic_op {
            words = logic(operation, words, stored);
        }
        let bits = self.pipeline.color_bits;
        let written = (words & bits) | (stored & !bits);
        let mask = mask32x16::from_bitmask(simd, u64::from(lanes));
        mask.select(written, stored).store_slice(&mut self.planes.color[block]);
    }
}

/// The lanes of a block where a polygon's stipple has a bit.
fn stippled(stipple: &[u32; 32], origin: [i32; 2], block: usize) -> u32 {
    let [x, y] = block_origin(block);
    let (x, y) = (origin[0] + x, origin[1] + y);
    let bit = |lane: usize| {
        let (x, y) = ((x + LANE_X[lane]) as usize % 32, (y + LANE_Y[lane]) as usize % 32);
        stipple[y] >> (31 - x) & 1
    };
    (0..LANES).fold(0, |lanes, lane| lanes | bit(lane) << lane)
}

/// Lights what the pixels of a block see, each lane by its own primitive, and forgets it.
#[inline(never)]
fn light_seen<S: Simd>(
    simd: S,
    origin: [i32; 2],
    block: usize,
    seen: &mut [u32; LANES],
    lighter: &mut Lighter<'_>,
    planes: &mut TilePlanes,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let mut left = 0;
            for lane in 0..LANES {
                left |= u32::from(seen[lane] != 0) << lane;
            }
            let [x, y] = block_origin(block);
            let place = [origin[0] + x, origin[1] + y];
            // Lanes of one pipeline together: nearly always all of them.
            while left != 0 {
                let leader = left.trailing_zeros() as usize & (LANES - 1);
                let Some((first, _)) = lighter.batch(seen[leader]) else { return };
                let mut together = 0;
                let mut alike = true;
                let mut places = [0; LANES];
                places[leader] = lighter.prepare(seen[leader]);
                for lane in lanes_of(left) {
                    let same = seen[lane] == seen[leader];
                    let belongs = same
                        || lighter.batch(seen[lane]).is_some_and(|(batch, _)| {
                            Arc::ptr_eq(&batch.pipeline, &first.pipeline)
                        });
                    if belongs {
                        together |= 1 << lane;
                        alike &= same;
                        places[lane] =
                            if same { places[leader] } else { lighter.prepare(seen[lane]) };
                    }
                }
                for lane in 0..LANES {
                    if together >> lane & 1 == 0 {
                        places[lane] = places[leader];
                    }
                }
                left &= !together;
                let prepared = &lighter.prepared;
                let fog = first.pipeline.fog.as_ref();
                let colors = shade(
                    simd,
                    place,
                    #[inline(always)]
                    |lane| &prepared[places[lane & (LANES - 1)]],
                    alike,
                    fog,
                );
                let stored = u32x16::from_slice(simd, &planes.color[block]);
                let mask = mask32x16::from_bitmask(simd, u64::from(together));
                mask.select(encode(colors), stored).store_slice(&mut planes.color[block]);
            }
            *seen = [0; LANES];
        },
    );
}

/// The fragments of a line in the tile: each stands for a column of `width` pixels across the major axis.
#[inline(always)]
fn line<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    ends: [[i32; 2]; 2],
    depths: [f32; 2],
    width: i32,
    counter: u32,
) {
    let walk = LineWalk::new(ends[0], ends[1]);
    let (major, minor) = (walk.major, 1 - walk.major);
    let length = (ends[1][major] - ends[0][major]) as f32;
    let slope = if length == 0.0 { 0.0 } else { (depths[1] - depths[0]) / length };
    let mut slopes = [0.0; 2];
    slopes[major] = slope;
    let plane = DepthPlane {
        x: ends[0][0],
        y: ends[0][1],
        z: depths[0],
        dz_dx: slopes[0],
        dz_dy: slopes[1],
        low: depths[0].min(depths[1]),
        high: depths[0].max(depths[1]),
    };
    // Fragments within the tile along the major axis.
    let low = sink.origin[major];
    let bounds = if walk.step > 0 {
        [low - walk.first, low + TILE - walk.first]
    } else {
        [walk.first - low - TILE + 1, walk.first - low + 1]
    };
    let stipple = sink.pipeline.line_stipple;
    for index in bounds[0].max(0)..bounds[1].min(walk.count) {
        if let Some((factor, pattern)) = stipple
            && pattern >> (counter.wrapping_add(index as u32) / factor % 16) & 1 == 0
        {
            continue;
        }
        let first = walk.pixel(index);
        let position = first.map(|at| at * SUBPIXELS + SUBPIXELS / 2);
        let z = plane.at(position);
        for across in 0..width {
            let mut pixel = [first[0] - sink.origin[0], first[1] - sink.origin[1]];
            pixel[minor] += across;
            if (0..TILE).contains(&pixel[minor]) {
                sink.sample(pixel, position, z);
            }
        }
    }
}

/// The square of a point, block by block.
#[inline(always)]
fn point<S: Simd>(sink: &mut PieceSink<'_, '_, S>, corner: [i32; 2], side: i32, depth: f32) {
    let [left, bottom] = [corner[0] - sink.origin[0], corner[1] - sink.origin[1]];
    let [low_x, low_y] = [left.max(0), bottom.max(0)];
    let [high_x, high_y] = [(left + side).min(TILE), (bottom + side).min(TILE)];
    for y in low_y..high_y {
        for x in low_x..high_x {
            sink.sample([x, y], [0; 2], depth);
        }
    }
}
