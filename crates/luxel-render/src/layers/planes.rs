//! Planes: a layer's values in the picture, and within one tile.

use crate::frame::{Bands, TilePixels, place_in_tile, put_block};
use luxel_math::{LANES, Lanes};
use luxel_scene::Size;
use luxel_view::{Layer, LayerValues};
use luxel_visibility::{BLOCK, TILE};
use std::ops::Range;

/// Pixels of a row of a block.
const SIDE: usize = BLOCK as usize;

/// Three numbers for each pixel of a block, of which a layer shows as many as it has channels.
pub(super) type BlockValues = [[f32; LANES]; 3];

/// What layers of numbers of triangles and objects show where nothing is.
const NO_NUMBER: u32 = u32::MAX;

/// What a layer of numbers shows where nothing is.
pub(super) fn background(layer: &Layer) -> f32 {
    match layer {
        Layer::Depth => 1.0,
        Layer::Z => f32::INFINITY,
        _ => 0.0,
    }
}

/// A layer that is being filled.
pub(super) struct Plane<'p> {
    pub(super) layer: &'p Layer,
    channels: usize,
    values: PlaneValues<'p>,
}

enum PlaneValues<'p> {
    F32(Bands<'p, f32>),
    U32(Bands<'p, u32>),
}

/// A layer's values within one tile.
pub(super) enum TileValues {
    F32(Vec<f32>),
    U32(Vec<u32>),
}

impl<'p> Plane<'p> {
    /// A layer of a picture, in the memory of earlier values.
    pub(super) fn new(layer: &'p Layer, values: &'p mut LayerValues, size: Size) -> Self {
        let channels = layer.channels();
        let values = if layer.is_id() {
            PlaneValues::U32(Bands::new(numbers_u32(values), size, channels))
        } else {
            PlaneValues::F32(Bands::new(numbers_f32(values), size, channels))
        };
        Self { layer, channels, values }
    }

    /// Memory for a tile of the layer.
    pub(super) fn tile(&self) -> TileValues {
        let count = (TILE * TILE) as usize * self.channels;
        match self.values {
            PlaneValues::F32(_) => TileValues::F32(vec![0.0; count]),
            PlaneValues::U32(_) => TileValues::U32(vec![0; count]),
        }
    }

    /// Copies a tile into the picture.
    pub(super) fn put(&self, tile: usize, drawn: &TileValues) {
        match (&self.values, drawn) {
            (PlaneValues::F32(bands), TileValues::F32(drawn)) => bands.put(tile, drawn),
            (PlaneValues::U32(bands), TileValues::U32(drawn)) => bands.put(tile, drawn),
            _ => {}
        }
    }

    /// Fills tiles of the picture in which nothing is seen.
    pub(super) fn fill(&self, band: usize, columns: &[Range<usize>]) {
        match &self.values {
            PlaneValues::F32(bands) => bands.fill(band, columns, background(self.layer)),
            PlaneValues::U32(bands) => bands.fill(band, columns, NO_NUMBER),
        }
    }

    /// Fills a run of a tile's pixels in which nothing is seen.
    pub(super) fn fill_run(&self, tile: &mut TileValues, run: &Range<usize>) {
        let run = run.start * self.channels..run.end * self.channels;
        match tile {
            TileValues::F32(values) => values[run].fill(background(self.layer)),
            TileValues::U32(values) => values[run].fill(NO_NUMBER),
        }
    }

    /// Fills a block in which nothing is seen.
    pub(super) fn fill_block(&self, tile: &mut TileValues, block: usize) {
        match tile {
            TileValues::F32(values) => {
                self.put_values(values, block, &[[background(self.layer); LANES]; 3]);
            }
            TileValues::U32(values) => {
                self.put_values(values, block, &[[NO_NUMBER; LANES]; 3]);
            }
        }
    }

    /// Writes a block's values among the rows of its tile.
    #[inline(always)]
    pub(super) fn put_values<T: Copy>(
        &self,
        tile: &mut [T],
        block: usize,
        values: &[[T; LANES]; 3],
    ) {
        match self.channels {
            1 => {
                if let Ok(tile) = <&mut TilePixels<T>>::try_from(tile) {
                    put_block(tile, block, &values[0]);
                }
            }
            2 => interleave::<T, 2, { 2 * SIDE }>(tile, block, values),
            _ => interleave::<T, 3, { 3 * SIDE }>(tile, block, values),
        }
    }

    /// Adds to a block's values among the rows of its tile.
    pub(super) fn add_values(&self, tile: &mut [f32], block: usize, values: &BlockValues) {
        for lane in 0..LANES {
            let at = place_in_tile(block, lane) * self.channels;
            for (sum, values) in tile[at..at + self.channels].iter_mut().zip(values) {
                *sum += values[lane];
            }
        }
    }
}

/// Writes C channels of a block among the rows of its tile; a row of a block has `ROW` = C * [`SIDE`] values.
#[inline(always)]
fn interleave<T: Copy, const C: usize, const ROW: usize>(
    tile: &mut [T],
    block: usize,
    values: &[[T; LANES]; 3],
) {
    for first in (0..LANES).step_by(SIDE) {
        let at = place_in_tile(block, first) * C;
        // The fixed length removes the bounds checks.
        let Some(row) = tile[at..].first_chunk_mut::<ROW>() else { return };
        for (pixel, into) in row.as_chunks_mut::<C>().0.iter_mut().enumerate() {
            *into = std::array::from_fn(|channel| values[channel][first + pixel]);
        }
    }
}

/// Numbers in memory, with the background where nothing is seen.
#[inline(always)]
pub(super) fn stored<N: Lanes>(numbers: [N; 3], seen: N::Mask, background: f32) -> BlockValues {
    let mut values = [[0.0; LANES]; 3];
    for (values, number) in values.iter_mut().zip(numbers) {
        number.select(seen, number.constant(background)).store(values, 0);
    }
    values
}

/// The list of a layer's numbers, in the memory of these if they are such.
fn numbers_f32(values: &mut LayerValues) -> &mut Vec<f32> {
    if matches!(values, LayerValues::U32(_)) {
        *values = LayerValues::F32(Vec::new());
    }
    match values {
        LayerValues::F32(numbers) => numbers,
        LayerValues::U32(_) => unreachable!("it was replaced"),
    }
}

/// The list of a layer's whole numbers, in the memory of these if they are such.
fn numbers_u32(values: &mut LayerValues) -> &mut Vec<u32> {
    if matches!(values, LayerValues::F32(_)) {
        *values = LayerValues::U32(Vec::new());
    }
    match values {
        LayerValues::U32(numbers) => numbers,
        LayerValues::F32(_) => unreachable!("it was replaced"),
    }
}
