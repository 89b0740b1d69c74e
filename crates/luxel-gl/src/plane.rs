//! Values of pixels in tiles of 64x64 and blocks of 4x4, as they are drawn to. Row 0 is the bottom one.
//!
//! Framebuffers, renderbuffers and images of textures keep their pixels so: what is drawn to is moved between them, not
//! copied.

use luxel_math::{LANES, Level, Simd, dispatch_long, i32x16, lanes_of, prelude::*, u32x16};
use luxel_visibility::{BLOCK, BLOCKS, TILE, Tile};

/// Blocks of a tile.
pub(crate) const TILE_BLOCKS: usize = (BLOCKS * BLOCKS) as usize;
const _: () = assert!(BLOCK * BLOCK == LANES as i32, "a block is one vector");

/// One tile, block by block.
pub(crate) type Blocks<T> = [[T; LANES]; TILE_BLOCKS];

/// Columns and rows of a block's lanes.
pub(crate) const LANE_X: [i32; LANES] = [0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3];
pub(crate) const LANE_Y: [i32; LANES] = [0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3];

/// The first pixel of a block within its tile.
#[inline(always)]
pub(crate) fn block_origin(block: usize) -> [i32; 2] {
    let block = block as i32;
    [block % BLOCKS * BLOCK, block / BLOCKS * BLOCK]
}

/// What planes have values of.
pub(crate) trait PlaneValue: Copy + Default + Send + Sync {
    /// What all values of a tile may follow from.
    type Rule: Copy + std::fmt::Debug + Send;

    /// The value at a column and row of the tile.
    fn by_rule(rule: &Self::Rule, pixel: [i32; 2]) -> Self;

    /// The values at sixteen columns and rows.
    fn by_rule_in_lanes<S: Simd>(rule: &Self::Rule, pixels: [i32x16<S>; 2]) -> [Self; LANES];

    /// Reads the first values of a row.
    fn row_by_rule(rule: &Self::Rule, y: i32, row: &mut [Self]);
}

/// Colours and stencil values: all may be the same.
impl PlaneValue for u32 {
    type Rule = Self;

    #[inline(always)]
    fn by_rule(rule: &Self, _: [i32; 2]) -> Self {
        *rule
    }

    #[inline(always)]
    fn by_rule_in_lanes<S: Simd>(rule: &Self, _: [i32x16<S>; 2]) -> [Self; LANES] {
        [*rule; LANES]
    }

    fn row_by_rule(rule: &Self, _: i32, row: &mut [Self]) {
        row.fill(*rule);
    }
}

/// The values of a tile. Those that follow from a rule aren't written before somebody changes a part of them: most of a
/// shadow map is as far away as it was cleared to be, or lies in one triangle.
#[derive(Clone, Debug)]
pub(crate) struct PlaneTile<T: PlaneValue> {
    /// What all values follow from, in the place of the blocks.
    rule: Option<T::Rule>,
    blocks: Box<Blocks<T>>,
}

impl<T: PlaneValue> PlaneTile<T> {
    /// Lets all values follow from a rule.
    pub(crate) fn follow(&mut self, rule: T::Rule) {
        self.rule = Some(rule);
    }

    /// What all values follow from, if they aren't written.
    #[inline(always)]
    pub(crate) fn rule(&self) -> Option<&T::Rule> {
        self.rule.as_ref()
    }

    /// The blocks, to be changed.
    #[inline(always)]
    pub(crate) fn blocks_mut<S: Simd>(&mut self, simd: S) -> &mut Blocks<T> {
        if let Some(rule) = self.rule.take() {
            self.write(simd, &rule);
        }
        &mut self.blocks
    }

    #[inline(never)]
    fn write<S: Simd>(&mut self, simd: S, rule: &T::Rule) {
        simd.vectorize(
            #[inline(always)]
            || {
                let lane_x = i32x16::simd_from(simd, LANE_X);
                let lane_y = i32x16::simd_from(simd, LANE_Y);
                for (number, block) in self.blocks.iter_mut().enumerate() {
                    let [x, y] = block_origin(number);
                    *block = T::by_rule_in_lanes(rule, [lane_x + x, lane_y + y]);
                }
            },
        );
    }

    /// The value at a place, row by row within a block and block by block.
    #[inline(always)]
    fn at(&self, place: usize) -> T {
        let place = place & (TILE_BLOCKS * LANES - 1);
        match &self.rule {
            None => self.blocks.as_flattened()[place],
            Some(rule) => {
                let [x, y] = block_origin(place / LANES);
                let lane = (place % LANES) as i32;
                T::by_rule(rule, [x + lane % BLOCK, y + lane / BLOCK])
            }
        }
    }
}

impl PlaneTile<u32> {
    /// Changes the values of all pixels.
    pub(crate) fn change(&mut self, change: impl Fn(u32) -> u32) {
        match &mut self.rule {
            Some(value) => *value = change(*value),
            None => {
                self.blocks.as_flattened_mut().iter_mut().for_each(|value| *value = change(*value));
            }
        }
    }
}

/// Values of all pixels, with one sample or several.
#[derive(Clone, Debug)]
pub(crate) struct Plane<T: PlaneValue> {
    size: [u32; 2],
    /// Tiles side by side, and samples of a pixel.
    across: usize,
    samples: usize,
    /// Those of a tile's samples one after the other.
    tiles: Vec<PlaneTile<T>>,
}

impl<T: PlaneValue> Plane<T> {
    /// The same value everywhere; `None` if there is no memory for it.
    pub(crate) fn new(size: [u32; 2], samples: usize, value: T) -> Option<Self> {
        let [across, up] = size.map(|side| side.div_ceil(TILE as u32) as usize);
        let count = (across * up).checked_mul(samples)?;
        let mut tiles = Vec::new();
        tiles.try_reserve_exact(count).ok()?;
        for _ in 0..count {
            let mut blocks = Vec::new();
            blocks.try_reserve_exact(TILE_BLOCKS).ok()?;
            blocks.resize(TILE_BLOCKS, [value; LANES]);
            let blocks = blocks.into_boxed_slice().try_into().ok()?;
            tiles.push(PlaneTile { rule: None, blocks });
        }
        Some(Self { size, across, samples, tiles })
    }

    /// Width and height.
    pub(crate) fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Samples of a pixel.
    pub(crate) fn samples(&self) -> usize {
        self.samples
    }

    /// Tile of a sample of a pixel, and its place there.
    fn place(&self, [x, y]: [u32; 2], sample: usize) -> (usize, usize) {
        let side = TILE as u32;
        let tile = (y / side) as usize * self.across + (x / side) as usize;
        let (block, lane) = Tile::place((x % side) as i32, (y % side) as i32);
        (tile * self.samples + sample, block * LANES + lane)
    }

    /// The value of a sample; `None` outside.
    pub(crate) fn get(&self, at: [u32; 2], sample: usize) -> Option<T> {
        let (tile, place) = self.place(at, sample);
        self.tiles.get(tile).map(|tile| tile.at(place))
    }

    /// The values of the first samples of some lanes' pixels, a bit each; 0 outside. In other lanes they mean nothing.
    #[inline(always)]
    pub(crate) fn gathered<S: Simd>(&self, [x, y]: [u32x16<S>; 2], lanes: u32) -> [T; LANES] {
        const TILE_BITS: u32 = TILE.ilog2();
        const BLOCK_BITS: u32 = BLOCK.ilog2();
        let across = (self.across * self.samples) as u32;
        let tile = (y >> TILE_BITS) * across + (x >> TILE_BITS) * self.samples as u32;
        // Row and column of the block, then of the pixel in it.
        let [block, pixel] = [(TILE / BLOCK - 1) as u32, (BLOCK - 1) as u32];
        let place = ((y >> BLOCK_BITS) & block) << (TILE_BITS + BLOCK_BITS)
            | ((x >> BLOCK_BITS) & block) << (2 * BLOCK_BITS)
            | (y & pixel) << BLOCK_BITS
            | x & pixel;
        let first = lanes_of(lanes).next().unwrap_or(0);
        let (mut tiles, mut places) = ([0; LANES], [0; LANES]);
        tile.store_slice(&mut tiles);
        place.store_slice(&mut places);
        let mut values = [T::default(); LANES];
        let elsewhere = !tile.simd_eq(tiles[first]).to_bitmask() as u32 & lanes;
        if elsewhere == 0
            && let Some(rule) = self.tiles.get(tiles[first] as usize).and_then(PlaneTile::rule)
        {
            let side = (TILE - 1) as u32;
            return T::by_rule_in_lanes(rule, [(x & side).bitcast(), (y & side).bitcast()]);
        }
        for lane in lanes_of(lanes) {
            if let Some(tile) = self.tiles.get(tiles[lane] as usize) {
                values[lane] = tile.at(places[lane] as usize);
            }
        }
        values
    }

    /// Changes the value of a sample; nothing outside.
    pub(crate) fn set(&mut self, at: [u32; 2], sample: usize, value: T) {
        let (tile, place) = self.place(at, sample);
        if let Some(tile) = self.tiles.get_mut(tile) {
            let blocks = dispatch_long!(Level::baseline(), simd => tile.blocks_mut(simd));
            blocks.as_flattened_mut()[place] = value;
        }
    }

    /// Reads a row of one sample of the pixels.
    pub(crate) fn read_row(&self, y: u32, sample: usize, row: &mut [T]) {
        let block_row = (y % TILE as u32 / BLOCK as u32 * BLOCKS as u32) as usize;
        let lane = (y % BLOCK as u32 * BLOCK as u32) as usize;
        let first = (y / TILE as u32) as usize * self.across * self.samples;
        let tiles = self.tiles[first + sample..].iter().step_by(self.samples);
        for (tile, pixels) in tiles.zip(row.chunks_mut(TILE as usize)) {
            if let Some(rule) = tile.rule() {
                T::row_by_rule(rule, (y % TILE as u32) as i32, pixels);
                continue;
            }
            let blocks = &tile.blocks[block_row..block_row + BLOCKS as usize];
            // Rows of whole blocks have a length that the compiler knows.
            let (whole, rest) = pixels.as_chunks_mut::<{ BLOCK as usize }>();
            let count = whole.len();
            for (block, pixels) in blocks.iter().zip(whole) {
                pixels.copy_from_slice(&block[lane..lane + BLOCK as usize]);
            }
            if let Some(block) = blocks.get(count) {
                rest.copy_from_slice(&block[lane..lane + rest.len()]);
            }
        }
    }

    /// Writes a rectangle from its lower left pixel on, on all threads: `fill` gets the number of a row, of a sample, and
    /// the row's pixels.
    pub(crate) fn write_rows(
        &mut self,
        [left, bottom]: [u32; 2],
        [width, height]: [u32; 2],
        fill: &(dyn Fn(u32, usize, &mut [T]) + Sync),
    ) {
        let side = TILE as u32;
        let (samples, right, top) = (self.samples, left + width, bottom + height);
        let rows = self.tiles.chunks_mut((self.across * samples).max(1));
        luxel_parallel::each(rows.enumerate(), &|(number, tiles): (usize, &mut [PlaneTile<T>])| {
            let first = number as u32 * side;
            let rows = bottom.max(first)..top.min(first + side);
            if rows.is_empty() {
                return;
            }
            let mut row = vec![T::default(); width as usize];
            for y in rows {
                for sample in 0..samples {
                    fill(y - bottom, sample, &mut row);
                    let tiles = tiles.iter_mut().skip(sample).step_by(samples);
                    for (tile, first) in tiles.zip((0..).step_by(TILE as usize)) {
                        let columns = left.max(first)..right.min(first + side);
                        if columns.is_empty() {
                            continue;
                        }
                        let blocks =
                            dispatch_long!(Level::baseline(), simd => tile.blocks_mut(simd));
                        let pixels = &row[(columns.start - left) as usize..];
                        for (x, pixel) in columns.zip(pixels) {
                            let (block, lane) = Tile::place((x - first) as i32, (y % side) as i32);
                            blocks[block][lane] = *pixel;
                        }
                    }
                }
            }
        });
    }

    /// The first tiles of the first rows, each with those of all its samples.
    pub(crate) fn tiles_mut(
        &mut self,
        [across, up]: [usize; 2],
    ) -> impl Iterator<Item = &mut [PlaneTile<T>]> {
        let samples = self.samples.max(1);
        let rows = self.tiles.chunks_mut((self.across * samples).max(1)).take(up);
        rows.flat_map(move |row| row.chunks_mut(samples).take(across))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_math::{Level, dispatch};

    #[test]
    fn values_are_found_again_sample_by_sample_and_row_by_row() {
        let mut plane = Plane::new([130, 70], 2, 0).unwrap();
        let value = |x: u32, y: u32, sample: usize| 1 + x + 1000 * y + 1_000_000 * sample as u32;
        let all = || (0..70).flat_map(|y| (0..130).map(move |x| [x, y]));
        for at in all() {
            (0..2).for_each(|sample| plane.set(at, sample, value(at[0], at[1], sample)));
        }
        for at in all() {
            for sample in 0..2 {
                assert_eq!(plane.get(at, sample), Some(value(at[0], at[1], sample)));
            }
        }
        dispatch!(Level::baseline(), simd => {
            for first in 0..8690 {
                // Any pixels, also of one column, and one beyond.
                let at = |lane: u32| [(first + 37 * lane) % 130, (first / 130 + 5 * lane) % 70];
                let column = |axis: usize| {
                    let numbers: [u32; LANES] = std::array::from_fn(|lane| at(lane as u32)[axis]);
                    u32x16::from_slice(simd, &numbers)
                };
                let values = plane.gathered([column(0), column(1)], 0xff0f);
                for lane in 0..LANES {
                    let given = 0xff0f_u32 >> lane & 1 == 1;
                    let [x, y] = at(lane as u32);
                    assert!(!given || values[lane] == value(x, y, 0));
                }
            }
            let beyond = u32x16::splat(simd, 64000);
            assert_eq!(plane.gathered([beyond, beyond], u32::from(u16::MAX)), [0; LANES]);
        });
        let mut row = [0; 130];
        plane.read_row(69, 0, &mut row);
        assert!((0..130).all(|x| row[x as usize] == value(x, 69, 0)));
        assert_eq!(plane.tiles_mut([2, 1]).count(), 2);
        assert!(plane.tiles_mut([3, 2]).all(|tile| tile.len() == 2));
        assert_eq!(plane.get([0, 4000], 0), None);
    }

    #[test]
    fn a_filled_tile_reads_and_changes_like_one_that_is_written() {
        let mut plane = Plane::new([130, 70], 1, 5_u32).unwrap();
        for tile in plane.tiles_mut([3, 2]).flatten() {
            tile.follow(7);
            tile.change(|value| value + 1);
        }
        plane.set([64, 3], 0, 20);
        let mut row = [0; 130];
        plane.read_row(3, 0, &mut row);
        let expected = |x: usize, value: u32| if x == 64 { value } else { 8 };
        assert!((0..130).all(|x| row[x] == expected(x, 20)));
        assert_eq!([plane.get([65, 3], 0), plane.get([129, 69], 0)], [Some(8); 2]);
        for tile in plane.tiles_mut([3, 2]).flatten() {
            tile.change(|value| value / 2);
            dispatch!(Level::baseline(), simd => tile.blocks_mut(simd));
        }
        plane.read_row(3, 0, &mut row);
        assert!((0..130).all(|x| row[x] == expected(x, 20) / 2));
    }

    #[test]
    fn rows_that_are_written_are_read_again_and_leave_what_lies_about_them() {
        let mut plane = Plane::new([130, 140], 2, 7_u32).unwrap();
        for tile in plane.tiles_mut([3, 3]).flatten() {
            tile.follow(5);
        }
        let value = |x: u32, y: u32, sample: usize| 1000 + x + 1000 * y + 1_000_000 * sample as u32;
        let ([left, bottom], [width, height]) = ([61, 3], [68, 130]);
        plane.write_rows([left, bottom], [width, height], &|row, sample, pixels| {
            assert_eq!(pixels.len(), width as usize);
            for (pixel, x) in pixels.iter_mut().zip(left..) {
                *pixel = value(x, bottom + row, sample);
            }
        });
        let mut row = [0; 130];
        for y in 0..140 {
            for sample in 0..2 {
                plane.read_row(y, sample, &mut row);
                for (found, x) in row.into_iter().zip(0..) {
                    let within =
                        (left..left + width).contains(&x) && (bottom..bottom + height).contains(&y);
                    assert_eq!(found, if within { value(x, y, sample) } else { 5 }, "{x}, {y}");
                }
            }
        }
    }
}
