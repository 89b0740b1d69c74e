//! Bitmaps: a bit for each pixel that gets a fragment (OpenGL 1.5, section 3.7).

/// Rows of bits from the bottom up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Bitmap {
    width: usize,
    height: usize,
    /// Eight pixels a byte, the first one's bit lowest; rows begin with a byte of their own.
    bits: Vec<u8>,
}

impl Bitmap {
    /// A bitmap whose bits are `is_set(column, row)`; `None` if there is no memory for it.
    pub(crate) fn new(
        width: usize,
        height: usize,
        is_set: impl Fn(usize, usize) -> bool,
    ) -> Option<Self> {
        let stride = width.div_ceil(8);
        let count = stride.checked_mul(height)?;
        let mut bits = Vec::new();
        bits.try_reserve_exact(count).ok()?;
        bits.resize(count, 0);
        for row in 0..height {
            for column in (0..width).filter(|&column| is_set(column, row)) {
                bits[row * stride + column / 8] |= 1 << (column % 8);
            }
        }
        Some(Self { width, height, bits })
    }

    /// Width and height.
    pub(crate) fn size(&self) -> [i32; 2] {
        [self.width as i32, self.height as i32]
    }

    /// Whether a pixel of it gets a fragment.
    pub(crate) fn is_set(&self, column: usize, row: usize) -> bool {
        let byte = row * self.width.div_ceil(8) + column / 8;
        self.bits.get(byte).is_some_and(|byte| byte >> (column % 8) & 1 == 1)
    }

    /// Bytes that it takes.
    pub(crate) fn bytes(&self) -> usize {
        self.bits.len()
    }
}
