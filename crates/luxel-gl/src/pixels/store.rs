//! Where pixels lie in memory (OpenGL 1.5, section 3.6.4): rows with an alignment, skipped rows and pixels.

use crate::raster::Bitmap;
use crate::state::pixel::PixelStore;

/// An image in memory: offsets in bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// The first pixel.
    pub(crate) start: usize,
    /// From one row to the next.
    pub(crate) stride: usize,
    /// From one pixel to the next.
    pub(crate) pixel: usize,
    /// Up to the last pixel's end.
    pub(crate) end: usize,
}

impl Layout {
    /// The layout of `width` x `height` pixels of `pixel` bytes, whose elements have `element` bytes.
    ///
    /// Rows begin at multiples of the alignment, unless elements are as large as that (section 3.6.4, k).
    pub(crate) fn new(
        store: &PixelStore,
        [width, height]: [usize; 2],
        pixel: usize,
        element: usize,
    ) -> Self {
        let row = if store.row_length > 0 { store.row_length } else { width };
        let bytes = row.saturating_mul(pixel);
        let stride = if element >= store.alignment {
            bytes
        } else {
            bytes.div_ceil(store.alignment).saturating_mul(store.alignment)
        };
        let start = store
            .skip_rows
            .saturating_mul(stride)
            .saturating_add(store.skip_pixels.saturating_mul(pixel));
        let end = if width == 0 || height == 0 {
            0
        } else {
            let last_row = (height - 1).saturating_mul(stride);
            start.saturating_add(last_row).saturating_add(width.saturating_mul(pixel))
        };
        Self { start, stride, pixel, end }
    }
}

/// Side of a polygon stipple.
const SIDE: usize = 32;

/// The bytes from one row of bits to the next.
fn bitmap_stride(store: &PixelStore, width: usize) -> usize {
    let row = if store.row_length > 0 { store.row_length } else { width };
    row.div_ceil(8 * store.alignment).saturating_mul(store.alignment)
}

/// Bytes that a bitmap takes.
pub(crate) fn bitmap_bytes(store: &PixelStore, [width, height]: [usize; 2]) -> usize {
    if width == 0 || height == 0 {
        return 0;
    }
    let rows = store.skip_rows.saturating_add(height - 1);
    let rows = rows.saturating_mul(bitmap_stride(store, width));
    rows.saturating_add((store.skip_pixels.saturating_add(width)).div_ceil(8))
}

/// Bytes that a polygon stipple takes.
pub(crate) fn stipple_bytes(store: &PixelStore) -> usize {
    bitmap_bytes(store, [SIDE; 2])
}

/// Byte and bit of a pixel of a bitmap.
fn place(store: &PixelStore, width: usize, row: usize, column: usize) -> (usize, u32) {
    let bit = store.skip_pixels.saturating_add(column);
    let start = store.skip_rows.saturating_add(row).saturating_mul(bitmap_stride(store, width));
    let within = (bit % 8) as u32;
    (start.saturating_add(bit / 8), if store.lsb_first { within } else { 7 - within })
}

/// Reads a bitmap; bits beyond the slice are 0. `None` if there is no memory for it.
pub(crate) fn read_bitmap(
    bytes: &[u8],
    store: &PixelStore,
    [width, height]: [usize; 2],
) -> Option<Bitmap> {
    Bitmap::new(width, height, |column, row| {
        let (byte, bit) = place(store, width, row, column);
        bytes.get(byte).is_some_and(|byte| byte >> bit & 1 == 1)
    })
}

/// Reads 32x32 bits; those beyond the slice are 0.
pub(crate) fn read_stipple(bytes: &[u8], store: &PixelStore) -> [u32; SIDE] {
    std::array::from_fn(|row| {
        (0..SIDE).fold(0, |bits, column| {
            let (byte, bit) = place(store, SIDE, row, column);
            bits << 1 | u32::from(bytes.get(byte).is_some_and(|byte| byte >> bit & 1 == 1))
        })
    })
}

/// Writes 32x32 bits, as far as the slice goes.
pub(crate) fn write_stipple(bits: &[u32; SIDE], store: &PixelStore, bytes: &mut [u8]) {
    for (row, bits) in bits.iter().enumerate() {
        for column in 0..SIDE {
            let (byte, bit) = place(store, SIDE, row, column);
            if let Some(byte) = bytes.get_mut(byte) {
                let on = (bits >> (SIDE - 1 - column) & 1) as u8;
                *byte = *byte & !(1 << bit) | on << bit;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_3_6_4_rows_are_aligned_and_skips_come_first() {
        let store = PixelStore { skip_rows: 1, skip_pixels: 2, ..PixelStore::default() };
        let layout = Layout::new(&store, [3, 2], 3, 1);
        assert_eq!(layout, Layout { start: 12 + 6, stride: 12, pixel: 3, end: 18 + 12 + 9 });
        // Elements of four bytes need no alignment of four, whatever the row's length.
        let floats = Layout::new(&PixelStore::default(), [3, 1], 12, 4);
        assert_eq!((floats.stride, floats.end), (36, 36));
    }

    #[test]
    fn section_3_5_2_a_stipple_comes_back_as_it_was_in_any_storage() {
        let bits: [u32; SIDE] = std::array::from_fn(|row| 0x8000_0001 << (row % 7) ^ row as u32);
        for lsb_first in [false, true] {
            for skip_pixels in [0, 3] {
                let store =
                    PixelStore { lsb_first, skip_pixels, row_length: 40, ..PixelStore::default() };
                let mut bytes = vec![0; stipple_bytes(&store)];
                write_stipple(&bits, &store, &mut bytes);
                assert_eq!(read_stipple(&bytes, &store), bits);
            }
        }
    }
}
