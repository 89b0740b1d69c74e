//! Formats, types and storage of pixels (OpenGL 1.5, 3.6.1 and 3.6.4).

/// A format and a type that go together, as `glDrawPixels` takes them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PixelFormat {
    components: usize,
    kind: Kind,
    /// Indices are numbers; all else is 1 at the largest value of its type.
    is_index: bool,
}

/// How components are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Byte,
    UnsignedByte,
    Short,
    UnsignedShort,
    Int,
    UnsignedInt,
    Float,
    Bitmap,
    /// All components in one unsigned integer of so many bytes: the bits of each, the first one in the highest bits, or
    /// in the lowest if reversed.
    Packed {
        bytes: usize,
        bits: &'static [u32],
        reversed: bool,
    },
}

/// Why pixels can't be read or written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ImageError {
    /// `GLU_INVALID_ENUM`: the format or the type is none.
    Enum,
    /// `GLU_INVALID_VALUE`: a size is none.
    Value,
    /// `GLU_INVALID_OPERATION`: the type isn't one for the format.
    Operation,
    /// `GLU_OUT_OF_MEMORY`: the image is larger than memory.
    Memory,
}

impl PixelFormat {
    /// The format and the type by OpenGL's numbers.
    ///
    /// # Errors
    ///
    /// [`ImageError::Enum`] for numbers that are none, [`ImageError::Operation`] if they don't go together.
    pub fn new(format: u32, kind: u32) -> Result<Self, ImageError> {
        let (components, is_index) = match format {
            0x1900 | 0x1901 => (1, true),           // COLOR_INDEX, STENCIL_INDEX
            0x1902..=0x1906 | 0x1909 => (1, false), // DEPTH_COMPONENT to ALPHA, LUMINANCE
            0x190A => (2, false),                   // LUMINANCE_ALPHA
            0x1907 | 0x80E0 => (3, false),          // RGB, BGR
            0x1908 | 0x80E1 => (4, false),          // RGBA, BGRA
            _ => return Err(ImageError::Enum),
        };
        let packed = |bytes, bits, reversed| Kind::Packed { bytes, bits, reversed };
        let kind = match kind {
            0x1400 => Kind::Byte,
            0x1401 => Kind::UnsignedByte,
            0x1402 => Kind::Short,
            0x1403 => Kind::UnsignedShort,
            0x1404 => Kind::Int,
            0x1405 => Kind::UnsignedInt,
            0x1406 => Kind::Float,
            0x1A00 => Kind::Bitmap,
            0x8032 => packed(1, &[3, 3, 2], false),
            0x8362 => packed(1, &[3, 3, 2], true),
            0x8363 => packed(2, &[5, 6, 5], false),
            0x8364 => packed(2, &[5, 6, 5], true),
            0x8033 => packed(2, &[4, 4, 4, 4], false),
            0x8365 => packed(2, &[4, 4, 4, 4], true),
            0x8034 => packed(2, &[5, 5, 5, 1], false),
            0x8366 => packed(2, &[5, 5, 5, 1], true),
            0x8035 => packed(4, &[8, 8, 8, 8], false),
            0x8367 => packed(4, &[8, 8, 8, 8], true),
            0x8036 => packed(4, &[10, 10, 10, 2], false),
            0x8368 => packed(4, &[10, 10, 10, 2], true),
            _ => return Err(ImageError::Enum),
        };
        let fits = match kind {
            Kind::Bitmap => is_index,
            Kind::Packed { bits, .. } if bits.len() == 3 => format == 0x1907,
            Kind::Packed { bits, .. } => bits.len() == components,
            _ => true,
        };
        if fits { Ok(Self { components, kind, is_index }) } else { Err(ImageError::Operation) }
    }

    /// Bits of a pixel.
    fn bits(self) -> u128 {
        let bytes = match self.kind {
            Kind::Bitmap => return 1,
            Kind::Packed { bytes, .. } => bytes,
            Kind::Byte | Kind::UnsignedByte => self.components,
            Kind::Short | Kind::UnsignedShort => 2 * self.components,
            Kind::Int | Kind::UnsignedInt | Kind::Float => 4 * self.components,
        };
        8 * bytes as u128
    }

    /// Bytes of the numbers that `swap_bytes` turns.
    fn element_bytes(self) -> usize {
        match self.kind {
            Kind::Byte | Kind::UnsignedByte | Kind::Bitmap => 1,
            Kind::Short | Kind::UnsignedShort => 2,
            Kind::Int | Kind::UnsignedInt | Kind::Float => 4,
            Kind::Packed { bytes, .. } => bytes,
        }
    }
}

/// How pixels are stored: the values of `glPixelStore`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Rows begin at multiples of so many bytes: 1, 2, 4 or 8.
    pub alignment: usize,
    /// Pixels from a row to the next; 0 is the width.
    pub row_length: usize,
    /// Rows from an image of a volume to the next; 0 is the height.
    pub image_height: usize,
    /// Pixels, rows and images to skip.
    pub skip: [usize; 3],
    /// Whether the bytes of numbers are turned around.
    pub swap_bytes: bool,
    /// Whether the first pixel of a bitmap is in the lowest bit.
    pub lsb_first: bool,
}

impl Layout {
    /// Rows one after another.
    pub const TIGHT: Self = Self {
        alignment: 1,
        row_length: 0,
        image_height: 0,
        skip: [0; 3],
        swap_bytes: false,
        lsb_first: false,
    };

    /// Bytes from a row to the next.
    fn row_bytes(&self, format: PixelFormat, width: usize) -> u128 {
        let pixels = if self.row_length == 0 { width } else { self.row_length };
        let bytes = (pixels as u128 * format.bits()).div_ceil(8);
        // Elements that are as large as the alignment lie on it anyway.
        bytes.next_multiple_of(self.alignment.max(1) as u128)
    }

    /// The first byte of a row, and how many pixels to skip there.
    fn row_start(
        &self,
        format: PixelFormat,
        [width, height, _]: [usize; 3],
        row: usize,
        image: usize,
    ) -> u128 {
        let rows = if self.image_height == 0 { height } else { self.image_height };
        let rows = (self.skip[2] + image) as u128 * rows as u128 + (self.skip[1] + row) as u128;
        rows * self.row_bytes(format, width)
    }

    /// How many bytes an image of a size spans from the pointer to it on.
    ///
    /// # Errors
    ///
    /// [`ImageError::Memory`] if that is beyond the address space.
    pub fn span(&self, format: PixelFormat, size: [usize; 3]) -> Result<usize, ImageError> {
        let [width, height, depth] = size;
        if width == 0 || height == 0 || depth == 0 {
            return Ok(0);
        }
        let start = self.row_start(format, size, height - 1, depth - 1);
        let end = start + ((self.skip[0] + width) as u128 * format.bits()).div_ceil(8);
        usize::try_from(end)
            .ok()
            .filter(|&end| isize::try_from(end).is_ok())
            .ok_or(ImageError::Memory)
    }
}

/// An image or volume of numbers: colours from 0 to 1, indices as they are.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width, height, depth.
    pub size: [usize; 3],
    /// Numbers of a pixel.
    pub components: usize,
    /// Row by row, image by image.
    pub values: Vec<f32>,
}

impl Image {
    /// An image of zeros.
    ///
    /// # Errors
    ///
    /// [`ImageError::Memory`].
    pub fn zero(size: [usize; 3], components: usize) -> Result<Self, ImageError> {
        let count = size.iter().try_fold(components, |count, &side| count.checked_mul(side));
        let count = count.filter(|&count| count <= 1 << 31).ok_or(ImageError::Memory)?;
        let mut values = Vec::new();
        values.try_reserve_exact(count).map_err(|_| ImageError::Memory)?;
        values.resize(count, 0.0);
        Ok(Self { size, components, values })
    }

    /// Reads an image from memory; bytes beyond the end of `memory` are 0.
    ///
    /// # Errors
    ///
    /// [`ImageError::Memory`].
    pub fn read(
        memory: &[u8],
        layout: &Layout,
        format: PixelFormat,
        size: [usize; 3],
    ) -> Result<Self, ImageError> {
        let mut image = Self::zero(size, format.components)?;
        let mut values = image.values.chunks_exact_mut(format.components);
        for place in 0..size[1] * size[2] {
            let start = layout.row_start(format, size, place % size[1], place / size[1]);
            for (x, pixel) in values.by_ref().take(size[0]).enumerate() {
                format.read_pixel(memory, layout, start, x, pixel);
            }
        }
        Ok(image)
    }

    /// Writes the image to memory; what lies beyond the end of `memory` is left out.
    pub fn write(&self, memory: &mut [u8], layout: &Layout, format: PixelFormat) {
        let mut values = self.values.chunks_exact(self.components);
        for place in 0..self.size[1] * self.size[2] {
            let start =
                layout.row_start(format, self.size, place % self.size[1], place / self.size[1]);
            for (x, pixel) in values.by_ref().take(self.size[0]).enumerate() {
                format.write_pixel(memory, layout, start, x, pixel);
            }
        }
    }
}

impl PixelFormat {
    fn read_pixel(self, memory: &[u8], layout: &Layout, row: u128, x: usize, pixel: &mut [f32]) {
        let place = row * 8 + (layout.skip[0] + x) as u128 * self.bits();
        let byte = usize::try_from(place / 8).unwrap_or(usize::MAX);
        match self.kind {
            Kind::Bitmap => {
                let bit = bit_of(place, layout);
                pixel[0] = f32::from(memory.get(byte).map_or(0, |byte| byte >> bit & 1));
            }
            Kind::Packed { bytes, bits, reversed } => {
                let packed = element(memory, byte, bytes, layout.swap_bytes);
                for (value, (shift, bits)) in pixel.iter_mut().zip(fields(bytes, bits, reversed)) {
                    let most = (1u64 << bits) - 1;
                    *value = ((u64::from(packed) >> shift & most) as f64 / most as f64) as f32;
                }
            }
            _ => {
                let bytes = self.element_bytes();
                for (at, value) in pixel.iter_mut().enumerate() {
                    let raw = element(memory, byte + at * bytes, bytes, layout.swap_bytes);
                    *value = self.decoded(raw);
                }
            }
        }
    }

    fn write_pixel(self, memory: &mut [u8], layout: &Layout, row: u128, x: usize, pixel: &[f32]) {
        let place = row * 8 + (layout.skip[0] + x) as u128 * self.bits();
        let byte = usize::try_from(place / 8).unwrap_or(usize::MAX);
        match self.kind {
            Kind::Bitmap => {
                let bit = bit_of(place, layout);
                if let Some(byte) = memory.get_mut(byte) {
                    *byte = *byte & !(1 << bit) | u8::from(pixel[0] >= 0.5) << bit;
                }
            }
            Kind::Packed { bytes, bits, reversed } => {
                let mut packed = 0;
                for (&value, (shift, bits)) in pixel.iter().zip(fields(bytes, bits, reversed)) {
                    let most = (1u64 << bits) - 1;
                    packed |=
                        ((f64::from(value.clamp(0.0, 1.0)) * most as f64 + 0.5) as u64) << shift;
                }
                store(memory, byte, bytes, packed as u32, layout.swap_bytes);
            }
            _ => {
                let bytes = self.element_bytes();
                for (at, &value) in pixel.iter().enumerate() {
                    let raw = self.encoded(value);
                    store(memory, byte + at * bytes, bytes, raw, layout.swap_bytes);
                }
            }
        }
    }

    /// The largest value, which is 1 of a colour; `None` for floats and indices.
    fn most(self) -> Option<f64> {
        if self.is_index {
            return None;
        }
        Some(match self.kind {
            Kind::Byte => 127.0,
            Kind::UnsignedByte => 255.0,
            Kind::Short => 32767.0,
            Kind::UnsignedShort => 65535.0,
            Kind::Int => 2_147_483_647.0,
            Kind::UnsignedInt => 4_294_967_295.0,
            _ => return None,
        })
    }

    fn decoded(self, raw: u32) -> f32 {
        let number = match self.kind {
            Kind::Byte => f64::from(raw as u8 as i8),
            Kind::Short => f64::from(raw as u16 as i16),
            Kind::Int => f64::from(raw.cast_signed()),
            Kind::Float => return f32::from_bits(raw),
            _ => f64::from(raw),
        };
        (number / self.most().unwrap_or(1.0)) as f32
    }

    fn encoded(self, value: f32) -> u32 {
        // Casts from floats clamp to the type.
        let number = (f64::from(value) * self.most().unwrap_or(1.0) + 0.5).floor();
        match self.kind {
            Kind::Byte => u32::from(number as i8 as u8),
            Kind::UnsignedByte => u32::from(number as u8),
            Kind::Short => u32::from(number as i16 as u16),
            Kind::UnsignedShort => u32::from(number as u16),
            Kind::Int => (number as i32).cast_unsigned(),
            Kind::Float => value.to_bits(),
            _ => number as u32,
        }
    }
}

/// The bit of a bitmap's byte.
fn bit_of(place: u128, layout: &Layout) -> u32 {
    let bit = (place % 8) as u32;
    if layout.lsb_first { bit } else { 7 - bit }
}

/// Shift and width of each component in a packed number.
fn fields(bytes: usize, bits: &'static [u32], reversed: bool) -> impl Iterator<Item = (u32, u32)> {
    let mut used = 0;
    bits.iter().map(move |&width| {
        used += width;
        (if reversed { used - width } else { 8 * bytes as u32 - used }, width)
    })
}

fn element(memory: &[u8], at: usize, bytes: usize, swap: bool) -> u32 {
    let mut raw = [0; 4];
    if let Some(found) = at.checked_add(bytes).and_then(|end| memory.get(at..end)) {
        raw[..bytes].copy_from_slice(found);
    }
    if swap {
        raw[..bytes].reverse();
    }
    match bytes {
        1 => u32::from(raw[0]),
        2 => u32::from(u16::from_ne_bytes([raw[0], raw[1]])),
        _ => u32::from_ne_bytes(raw),
    }
}

fn store(memory: &mut [u8], at: usize, bytes: usize, value: u32, swap: bool) {
    let mut raw = match bytes {
        1 => [value as u8, 0, 0, 0],
        2 => {
            let [a, b] = (value as u16).to_ne_bytes();
            [a, b, 0, 0]
        }
        _ => value.to_ne_bytes(),
    };
    if swap {
        raw[..bytes].reverse();
    }
    if let Some(target) = at.checked_add(bytes).and_then(|end| memory.get_mut(at..end)) {
        target.copy_from_slice(&raw[..bytes]);
    }
}
