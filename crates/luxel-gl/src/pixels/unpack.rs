//! Pixels from the program's memory (OpenGL 1.5, section 3.6.4): images of up to three dimensions.

use super::format::{Components, Elements, PixelFormat};
use super::store::{Layout, bitmap_bytes, read_bitmap};
use crate::convert;
use crate::enums as gl;
use crate::state::pixel::PixelStore;
use std::borrow::Cow;

/// An image of several images in memory: offsets in bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ImageLayout {
    rows: Layout,
    start: usize,
    image_stride: usize,
    size: [usize; 3],
    /// Up to the last pixel's end.
    pub(crate) end: usize,
}

impl ImageLayout {
    /// The layout of an image; skips of more than `dimensions` axes have no effect.
    pub(crate) fn new(
        store: &PixelStore,
        size: [usize; 3],
        kind: PixelFormat,
        dimensions: usize,
    ) -> Self {
        let mut store = *store;
        if dimensions < 2 {
            store.skip_rows = 0;
        }
        let [width, height, depth] = size;
        let rows = Layout::new(&store, [width, height], kind.bytes(), kind.elements.bytes());
        let (mut start, mut image_stride) = (0, 0);
        if dimensions == 3 {
            let rows_of_image = if store.image_height > 0 { store.image_height } else { height };
            image_stride = rows_of_image.saturating_mul(rows.stride);
            start = store.skip_images.saturating_mul(image_stride);
        }
        let end = if depth == 0 || rows.end == 0 {
            0
        } else {
            let last = (depth - 1).saturating_mul(image_stride);
            start.saturating_add(last).saturating_add(rows.end)
        };
        Self { rows, start, image_stride, size, end }
    }

    /// Where a pixel begins, for pixels within the size.
    pub(crate) fn offset(&self, [x, y, z]: [usize; 3]) -> usize {
        self.start
            .saturating_add(z.saturating_mul(self.image_stride))
            .saturating_add(self.rows.start)
            .saturating_add(y.saturating_mul(self.rows.stride))
            .saturating_add(x.saturating_mul(self.rows.pixel))
    }

    /// The pixels in rows without gaps.
    pub(crate) fn tight(&self, bytes: &[u8]) -> Box<[u8]> {
        let mut all = Vec::with_capacity(bytes.len().min(self.end));
        self.each_row(bytes, |_, row| all.extend_from_slice(row));
        all.into()
    }

    /// Shows each row of pixels with its bytes, as far as the slice goes: the row's number in the image, the image's
    /// number.
    pub(crate) fn each_row<'b>(
        &self,
        bytes: &'b [u8],
        mut visit: impl FnMut([usize; 2], &'b [u8]),
    ) {
        let [width, height, depth] = self.size;
        let length = width.saturating_mul(self.rows.pixel);
        for z in 0..depth {
            for y in 0..height {
                let start = self.offset([0, y, z]);
                let Some(row) = bytes.get(start..start.saturating_add(length)) else { return };
                visit([y, z], row);
            }
        }
    }
}

/// Bytes of an image of the program, `kind` and `data_type` its type.
pub(crate) fn image_bytes(
    store: &PixelStore,
    size: [usize; 3],
    (kind, data_type): (PixelFormat, u32),
    dimensions: usize,
) -> usize {
    if data_type != gl::BITMAP {
        return ImageLayout::new(store, size, kind, dimensions).end;
    }
    let last = size[2].saturating_sub(1);
    if size[2] == 0 { 0 } else { bitmap_bytes(&bits_of(store, size, last), [size[0], size[1]]) }
}

/// How the bits of one image of several are stored.
fn bits_of(store: &PixelStore, [_, height, depth]: [usize; 3], image: usize) -> PixelStore {
    let rows = if store.image_height > 0 { store.image_height } else { height };
    let skipped = if depth > 1 { store.skip_images.saturating_add(image) } else { 0 };
    let skip_rows = store.skip_rows.saturating_add(skipped.saturating_mul(rows));
    PixelStore { skip_rows, ..*store }
}

/// An image of the program with its type and storage; bits become bytes of 0 and 1 in tight rows. `None` if there is no
/// memory for those.
pub(crate) fn without_bits<'b>(
    store: &PixelStore,
    size: [usize; 3],
    data_type: u32,
    bytes: &'b [u8],
) -> Option<(PixelStore, u32, Cow<'b, [u8]>)> {
    if data_type != gl::BITMAP {
        return Some((*store, data_type, Cow::Borrowed(bytes)));
    }
    if bytes.is_empty() {
        return Some((*store, gl::UNSIGNED_BYTE, Cow::Borrowed(bytes)));
    }
    let [width, height, depth] = size;
    let mut pixels = Vec::new();
    for image in 0..depth {
        let bits = read_bitmap(bytes, &bits_of(store, size, image), [width, height])?;
        pixels.try_reserve(width.checked_mul(height)?).ok()?;
        for row in 0..height {
            pixels.extend((0..width).map(|column| u8::from(bits.is_set(column, row))));
        }
    }
    Some((PixelStore::tight(false), gl::UNSIGNED_BYTE, Cow::Owned(pixels)))
}

impl PixelFormat {
    /// Whether pixels are bytes of colour, of which [`read_bytes`](Self::read_bytes) makes texels.
    pub(crate) fn is_bytes(self) -> bool {
        self.elements == Elements::UnsignedByte
            && matches!(self.components, Components::Colors(_) | Components::Luminance { .. })
    }

    /// What [`read`](Self::read) makes of a pixel of bytes, in bytes.
    #[inline]
    pub(crate) fn read_bytes(self, pixel: &[u8]) -> [u8; 4] {
        match (self.components, pixel) {
            (Components::Colors(places), _) => {
                let mut color = [0, 0, 0, 255];
                for (value, &place) in pixel.iter().zip(places) {
                    color[place] = *value;
                }
                color
            }
            (_, [l, a, ..]) => [*l, *l, *l, *a],
            (_, [l]) => [*l, *l, *l, 255],
            _ => [0, 0, 0, 255],
        }
    }

    /// A pixel's first element as a whole number, as stencil values are; of reals what lies before the point.
    pub(crate) fn read_index(self, swap: bool, pixel: &[u8]) -> i32 {
        let word = word(pixel, self.elements.bytes(), swap);
        match self.elements {
            Elements::Byte => i32::from(word as u8 as i8),
            Elements::Short => i32::from(word as u16 as i16),
            Elements::Float => f32::from_bits(word) as i32,
            _ => word as i32,
        }
    }

    /// A pixel's red, green, blue and alpha: what the format lacks is 0, alpha 1; depths are red, stencil
    /// values green.
    pub(crate) fn read(self, swap: bool, pixel: &[u8]) -> [f32; 4] {
        let mut values = [0.0; 4];
        if let Elements::Packed { bytes, bits, reversed } = self.elements {
            let word = word(pixel, bytes, swap);
            let total: u32 = bits.iter().sum();
            let mut low = 0;
            for (value, &bits) in values.iter_mut().zip(bits) {
                let shift = if reversed { low } else { total - low - bits };
                let steps = (1_u32 << bits) - 1;
                *value = (f64::from(word >> shift & steps) / f64::from(steps)) as f32;
                low += bits;
            }
        } else if self.elements == Elements::FloatAndByte {
            let mut words = pixel.chunks_exact(4).map(|bytes| word(bytes, 4, swap));
            values[0] = f32::from_bits(words.next().unwrap_or(0));
            values[1] = convert::ubyte(words.next().unwrap_or(0) as u8);
        } else {
            let width = self.elements.bytes();
            for (value, bytes) in values.iter_mut().zip(pixel.chunks_exact(width)) {
                let word = word(bytes, width, swap);
                *value = match self.elements {
                    Elements::Byte => convert::byte(word as u8 as i8),
                    Elements::UnsignedByte => convert::ubyte(word as u8),
                    Elements::Short => convert::short(word as u16 as i16),
                    Elements::UnsignedShort => convert::ushort(word as u16),
                    Elements::Int => convert::int(word as i32),
                    Elements::UnsignedInt => convert::uint(word),
                    _ => f32::from_bits(word),
                };
            }
        }
        match self.components {
            Components::Colors(places) => {
                let mut color = [0.0, 0.0, 0.0, 1.0];
                for (value, &place) in values.iter().zip(places) {
                    color[place] = *value;
                }
                color
            }
            Components::Luminance { alpha } => {
                let [l, a, ..] = values;
                [l, l, l, if alpha { a } else { 1.0 }]
            }
            Components::DepthStencil => [values[0], values[1], 0.0, 1.0],
            _ => [values[0], 0.0, 0.0, 1.0],
        }
    }
}

/// A word of 1, 2 or 4 bytes in the machine's order, or in the other one.
fn word(bytes: &[u8], width: usize, swap: bool) -> u32 {
    let ordered = bytes.iter().take(width).map(|byte| u32::from(*byte));
    let little = cfg!(target_endian = "little") != swap;
    if little {
        ordered.rev().fold(0, |word, byte| word << 8 | byte)
    } else {
        ordered.fold(0, |word, byte| word << 8 | byte)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_3_6_4_every_format_and_type_comes_back_as_it_was_written() {
        let formats = [
            gl::RED,
            gl::GREEN,
            gl::BLUE,
            gl::ALPHA,
            gl::RGB,
            gl::RGBA,
            gl::BGR,
            gl::BGRA,
            gl::LUMINANCE,
            gl::LUMINANCE_ALPHA,
            gl::DEPTH_COMPONENT,
        ];
        let types = [
            gl::BYTE,
            gl::UNSIGNED_BYTE,
            gl::SHORT,
            gl::UNSIGNED_SHORT,
            gl::INT,
            gl::UNSIGNED_INT,
            gl::FLOAT,
            gl::UNSIGNED_BYTE_3_3_2,
            gl::UNSIGNED_BYTE_2_3_3_REV,
            gl::UNSIGNED_SHORT_5_6_5,
            gl::UNSIGNED_SHORT_5_6_5_REV,
            gl::UNSIGNED_SHORT_4_4_4_4,
            gl::UNSIGNED_SHORT_4_4_4_4_REV,
            gl::UNSIGNED_SHORT_5_5_5_1,
            gl::UNSIGNED_SHORT_1_5_5_5_REV,
            gl::UNSIGNED_INT_8_8_8_8,
            gl::UNSIGNED_INT_8_8_8_8_REV,
            gl::UNSIGNED_INT_10_10_10_2,
            gl::UNSIGNED_INT_2_10_10_10_REV,
        ];
        let mut tried = 0;
        for format in formats {
            for data_type in types {
                for swap in [false, true] {
                    let Ok(kind) = PixelFormat::named(format, data_type) else { continue };
                    let values = [1.0, 0.0, 1.0, 0.0];
                    let mut bytes = vec![0; kind.bytes()];
                    kind.write(&values[..kind.components.count()], swap, &mut bytes);
                    let color = kind.read(swap, &bytes);
                    let expected = match kind.components {
                        Components::Colors(places) => {
                            let mut color = [0.0, 0.0, 0.0, 1.0];
                            for (number, &place) in places.iter().enumerate() {
                                color[place] = values[number];
                            }
                            color
                        }
                        Components::Luminance { alpha } => {
                            [1.0, 1.0, 1.0, if alpha { 0.0 } else { 1.0 }]
                        }
                        _ => [1.0, 0.0, 0.0, 1.0],
                    };
                    for (value, expected) in color.iter().zip(expected) {
                        assert!(
                            (value - expected).abs() < 0.01,
                            "{format:#x} {data_type:#x} {color:?}"
                        );
                    }
                    tried += 1;
                }
            }
        }
        assert!(tried > 150, "{tried}");
    }

    #[test]
    fn section_3_6_4_bits_become_bytes_as_their_storage_has_them() {
        let store = PixelStore { alignment: 1, skip_pixels: 3, ..PixelStore::default() };
        let kind = PixelFormat::of_source(gl::COLOR_INDEX, gl::BITMAP).unwrap();
        let size = [6, 2, 1];
        assert_eq!(image_bytes(&store, size, (kind, gl::BITMAP), 2), 3);
        let bytes = [0b0001_0011, 0b1000_0000, 0b0001_1111];
        // Rows of six bits after three skipped ones: with a row's length of six, one byte from row to row.
        let (_, data_type, pixels) = without_bits(&store, size, gl::BITMAP, &bytes).unwrap();
        assert_eq!(data_type, gl::UNSIGNED_BYTE);
        assert_eq!(pixels[..6], [1, 0, 0, 1, 1, 1]);
    }

    #[test]
    fn section_3_6_4_images_of_three_dimensions_skip_images_and_have_a_height() {
        let kind = PixelFormat::named(gl::LUMINANCE, gl::UNSIGNED_BYTE).unwrap();
        let store = PixelStore {
            alignment: 1,
            row_length: 4,
            image_height: 3,
            skip_images: 1,
            skip_rows: 1,
            skip_pixels: 2,
            ..PixelStore::default()
        };
        let layout = ImageLayout::new(&store, [2, 2, 2], kind, 3);
        assert_eq!(layout.offset([0, 0, 0]), 12 + 4 + 2);
        assert_eq!(layout.offset([1, 1, 1]), 12 + 12 + 8 + 3);
        assert_eq!(layout.end, layout.offset([1, 1, 1]) + 1);
        assert_eq!(ImageLayout::new(&store, [2, 0, 2], kind, 3).end, 0);
    }
}
