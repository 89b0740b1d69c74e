//! Images at the raster position, zoomed (OpenGL 1.5, sections 3.6.4 and 4.3.3).

use super::piece_sink::PieceSink;
use crate::plane::{LANE_X, LANE_Y, TILE_BLOCKS, block_origin};
use luxel_math::{LANES, Simd};
use luxel_visibility::{Sink, TILE, Tile};

/// What the pixels of an image are, row by row from the bottom up.
#[derive(Clone, Debug)]
pub(crate) enum ImagePixels {
    Colors(Vec<[f32; 4]>),
    /// From 0 to 1; the colours are those of the raster position.
    Depths(Vec<f32>),
    /// Values that no test sees, with the bits that are written.
    Stencil(Vec<u8>, u32),
    /// Depths that are written unless masked, and stencil values with the bits that are; no test sees them.
    DepthStencil(Vec<(f32, u8)>, bool, u32),
}

/// An image where it lies in the window.
#[derive(Clone, Debug)]
pub(crate) struct PlacedImage {
    pixels: ImagePixels,
    width: usize,
    /// The first pixel of the window, to the left and at the bottom.
    corner: [i32; 2],
    /// Of each pixel of the window to the right, and upwards, the column or row of the image.
    places: [Vec<u32>; 2],
}

impl PlacedImage {
    /// An image with its first pixel's corner at a place of the window; each pixel of it is a rectangle as large as the
    /// zoom. A pixel of the window takes the one that its centre lies in, left and bottom edges included.
    pub(crate) fn new(
        pixels: ImagePixels,
        size: [usize; 2],
        place: [f32; 2],
        zoom: [f32; 2],
        region: [i32; 4],
    ) -> Self {
        let mut corner = [0; 2];
        let places = [0, 1].map(|axis: usize| {
            let (from, zoom) = (f64::from(place[axis]), f64::from(zoom[axis]));
            let side = size[axis];
            let ends = [from, from + zoom * side as f64];
            let first_centre = |at: f64| (at - 0.5).ceil() as i32;
            let low = first_centre(ends[0].min(ends[1])).max(region[axis]);
            let high = first_centre(ends[0].max(ends[1])).min(region[axis + 2]);
            corner[axis] = low;
            let of = |at: i32| {
                let along = (f64::from(at) + 0.5 - from) / zoom;
                let number = if zoom > 0.0 { along.floor() } else { along.ceil() - 1.0 };
                number.clamp(0.0, side.saturating_sub(1) as f64) as u32
            };
            let is_empty = side == 0 || zoom == 0.0 || !ends[0].is_finite() || !ends[1].is_finite();
            if is_empty { Vec::new() } else { (low..high).map(of).collect() }
        });
        Self { pixels, width: size[0], corner, places }
    }

    /// Left, bottom, right and top in the window.
    pub(crate) fn bounds(&self) -> [i32; 4] {
        let [left, bottom] = self.corner;
        let [across, up] = [&self.places[0], &self.places[1]].map(|of| of.len() as i32);
        [left, bottom, left.saturating_add(across), bottom.saturating_add(up)]
    }

    /// Bytes that it takes, about.
    pub(crate) fn bytes(&self) -> usize {
        let pixels = match &self.pixels {
            ImagePixels::Colors(of) => size_of_val(of.as_slice()),
            ImagePixels::Depths(of) => size_of_val(of.as_slice()),
            ImagePixels::Stencil(of, _) => of.len(),
            ImagePixels::DepthStencil(of, ..) => size_of_val(of.as_slice()),
        };
        pixels + 4 * (self.places[0].len() + self.places[1].len())
    }

    /// The number of the image's pixel at a pixel of the window.
    fn number(&self, at: [i32; 2]) -> Option<usize> {
        let place = |axis: usize| {
            let at = usize::try_from(at[axis] - self.corner[axis]).ok()?;
            self.places[axis].get(at).map(|place| *place as usize)
        };
        Some(place(1)? * self.width + place(0)?)
    }
}

/// The fragments of an image in a tile.
pub(super) fn image<S: Simd>(sink: &mut PieceSink<'_, '_, S>, of: &PlacedImage, depth: f32) {
    let [left, bottom, right, top] = of.bounds();
    let [x, y] = sink.origin;
    match &of.pixels {
        ImagePixels::Colors(colors) => {
            for block in 0..TILE_BLOCKS {
                colors_of_block(sink, of, colors, depth, block);
            }
        }
        pixels => {
            for row in (bottom - y).max(0)..(top - y).min(TILE) {
                for column in (left - x).max(0)..(right - x).min(TILE) {
                    let Some(number) = of.number([x + column, y + row]) else { continue };
                    match pixels {
                        ImagePixels::Colors(_) => {}
                        ImagePixels::Depths(depths) => {
                            let depth = depths.get(number).copied().unwrap_or(0.0);
                            let kept = sink.planes.depth_kind.kept(depth.into());
                            sink.sample([column, row], [0; 2], kept);
                        }
                        ImagePixels::Stencil(values, mask) => {
                            let value = values.get(number).copied().unwrap_or(0);
                            write_stencil(sink, [column, row], value, *mask);
                        }
                        ImagePixels::DepthStencil(values, writes_depth, mask) => {
                            let (depth, value) = values.get(number).copied().unwrap_or_default();
                            write_stencil(sink, [column, row], value, *mask);
                            if *writes_depth {
                                let (block, lane) = Tile::place(column, row);
                                let kept = sink.planes.depth_kind.kept(depth.into());
                                sink.planes.depth[block][lane] = kept;
                            }
                        }
                    }
                }
            }
        }
    }
}

fn write_stencil<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    [column, row]: [i32; 2],
    value: u8,
    mask: u32,
) {
    let (block, lane) = Tile::place(column, row);
    let stored = &mut sink.planes.stencil[block][lane];
    *stored = *stored & !mask | u32::from(value) & mask;
}

/// The fragments of an image of colours in a block.
fn colors_of_block<S: Simd>(
    sink: &mut PieceSink<'_, '_, S>,
    of: &PlacedImage,
    colors: &[[f32; 4]],
    depth: f32,
    block: usize,
) {
    let first = block_origin(block);
    let mut primary = [[0.0; LANES]; 4];
    let mut lanes = 0;
    for lane in 0..LANES {
        let at =
            [sink.origin[0] + first[0] + LANE_X[lane], sink.origin[1] + first[1] + LANE_Y[lane]];
        let Some(color) = of.number(at).and_then(|number| colors.get(number)) else { continue };
        lanes |= 1 << lane;
        for (channel, value) in primary.iter_mut().zip(color) {
            channel[lane] = *value;
        }
    }
    if lanes != 0 {
        sink.primary = Some(primary);
        sink.by_all_tests(lanes, &[depth; LANES], block);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn columns(side: usize, place: f32, zoom: f32) -> (i32, Vec<u32>) {
        let pixels = ImagePixels::Depths(Vec::new());
        let of = PlacedImage::new(pixels, [side, 1], [place, 0.0], [zoom, 1.0], [0, 0, 10, 10]);
        (of.corner[0], of.places[0].clone())
    }

    #[test]
    fn section_3_6_4_a_pixel_takes_the_part_of_the_image_that_its_centre_lies_in() {
        assert_eq!(columns(3, 2.0, 1.0), (2, vec![0, 1, 2]));
        assert_eq!(columns(2, 1.0, 2.0), (1, vec![0, 0, 1, 1]));
        assert_eq!(columns(4, 0.0, 0.5), (0, vec![1, 3]));
        // Left edges are included, whichever way the image runs.
        assert_eq!(columns(2, 2.5, 1.0), (2, vec![0, 1]));
        assert_eq!(columns(2, 4.5, -1.0), (2, vec![1, 0]));
        assert_eq!(columns(3, 5.0, -2.0), (0, vec![2, 1, 1, 0, 0]));
        // The window cuts it, and nothing is left of one without extent or place.
        assert_eq!(columns(20, -3.0, 1.0), (0, (3..13).collect()));
        assert!(columns(3, 2.0, 0.0).1.is_empty() && columns(0, 2.0, 1.0).1.is_empty());
        assert!(columns(3, f32::INFINITY, 1.0).1.is_empty());
        assert!(columns(3, f32::NAN, 1.0).1.is_empty());
    }
}
