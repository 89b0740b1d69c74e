//! Pixels of the framebuffer that is read: as colours, and in the formats of a program's memory.

use super::fragments::unit;
use crate::Context;
use crate::pixels::format::{Components, Elements, PixelFormat};
use crate::raster::Framebuffer;
use crate::state::transfer::Transfer;

/// Colours of a framebuffer; alphas that it hasn't are 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct FrameColors<'a> {
    framebuffer: &'a Framebuffer,
    has_alpha: bool,
}

impl Context {
    /// The colours of the framebuffer that is read.
    pub(super) fn frame_colors(&self) -> FrameColors<'_> {
        FrameColors { framebuffer: &self.framebuffer, has_alpha: self.has_alpha() }
    }
}

impl FrameColors<'_> {
    /// A pixel's red, green, blue and alpha.
    pub(super) fn color(&self, at: [u32; 2]) -> [f32; 4] {
        let mut color = self.framebuffer.color(at).map(|byte| f32::from(byte) / 255.0);
        if !self.has_alpha {
            color[3] = 1.0;
        }
        color
    }

    /// A row of pixels from the left on, red lowest.
    fn row(&self, y: u32, words: &mut [u32]) {
        self.framebuffer.color_row(y, 0, words);
        if !self.has_alpha {
            words.iter_mut().for_each(|word| *word |= 0xff << 24);
        }
    }
}

/// Writes pixels as `glReadPixels` does.
#[derive(Clone, Debug)]
pub(super) struct PixelWriter<'a> {
    pub(super) colors: FrameColors<'a>,
    pub(super) transfer: Transfer,
    pub(super) kind: PixelFormat,
    /// Whether the bytes of elements are swapped.
    pub(super) swap: bool,
}

impl PixelWriter<'_> {
    /// Writes the pixels of some columns of a row, as far as there is room. `words` is for a row of colours.
    pub(super) fn write_row(
        &self,
        y: u32,
        columns: std::ops::Range<u32>,
        words: &mut Vec<u32>,
        out: &mut [u8],
    ) {
        let Self { ref colors, ref transfer, kind, swap } = *self;
        if let (Components::Colors(places), Elements::UnsignedByte) =
            (kind.components, kind.elements)
            && transfer.keeps_colors()
        {
            words.resize(columns.end as usize, 0);
            colors.row(y, words);
            write_bytes(&words[columns.start as usize..], places, out);
            return;
        }
        for (x, out) in columns.zip(out.chunks_exact_mut(kind.bytes())) {
            let (values, count) = self.components([x, y]);
            kind.write(&values[..count], swap, out);
        }
    }

    /// A pixel's components in the order of memory, and how many.
    fn components(&self, at: [u32; 2]) -> ([f32; 4], usize) {
        let Self { colors, transfer, kind, .. } = self;
        let framebuffer = colors.framebuffer;
        let color = || transfer.color(colors.color(at)).map(unit);
        let mut values = [0.0; 4];
        match kind.components {
            Components::Colors(places) => {
                let color = color();
                for (value, &place) in values.iter_mut().zip(places) {
                    *value = color[place];
                }
            }
            Components::Luminance { .. } => {
                let [r, g, b, a] = color();
                values = [(r + g + b).min(1.0), a, 0.0, 0.0];
            }
            // Colours have no indices, which are refused before.
            Components::Index => {}
            Components::Depth => values[0] = unit(transfer.depth(framebuffer.unit_depth(at))),
            Components::Stencil => {
                let value = transfer.stencil(i32::from(framebuffer.stencil(at)));
                values[0] = (value & 0xffff) as f32;
            }
            Components::DepthStencil => {
                values = transfer.values(framebuffer.unit_depth_stencil(at), true).map(unit);
            }
        }
        (values, kind.components.count())
    }
}

/// Writes bytes of colours, red lowest, in the order of places.
pub(super) fn write_bytes(words: &[u32], places: &[usize], out: &mut [u8]) {
    /// What `of` makes of each colour.
    #[inline(always)]
    fn put<const N: usize>(words: &[u32], out: &mut [u8], of: impl Fn([u8; 4]) -> [u8; N]) {
        for (word, out) in words.iter().zip(out.as_chunks_mut().0) {
            *out = of(word.to_le_bytes());
        }
    }
    match places {
        [0, 1, 2, 3] => put(words, out, |color| color),
        [2, 1, 0, 3] => put(words, out, |[r, g, b, a]| [b, g, r, a]),
        [0, 1, 2] => put(words, out, |[r, g, b, _]| [r, g, b]),
        _ => {
            for (word, out) in words.iter().zip(out.chunks_exact_mut(places.len())) {
                let color = word.to_le_bytes();
                for (out, &place) in out.iter_mut().zip(places) {
                    *out = color[place];
                }
            }
        }
    }
}
