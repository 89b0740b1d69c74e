//! Copies of rectangles between framebuffers (EXT_framebuffer_blit).

use super::framebuffer::Framebuffer;
use crate::enums as gl;
use crate::plane::{Plane, PlaneValue};

/// A rectangle by two corners: x and y of the first, then of the second.
type Corners = [i32; 4];

/// Pixels of the destination one after the other along an axis, and the places of their centres in the source.
struct Axis {
    first: u32,
    places: Vec<f64>,
}

impl Axis {
    /// Those between two coordinates that both rectangles and the source have.
    fn new(source: [i32; 2], destination: [i32; 2], within: [i32; 2], size: u32) -> Self {
        let [d0, d1] = destination;
        let [s0, s1] = source.map(f64::from);
        let span = f64::from(d1) - f64::from(d0);
        let (first, end) = (d0.min(d1).max(within[0]), d0.max(d1).min(within[1]));
        let place = |at: i32| s0 + (f64::from(at) + 0.5 - f64::from(d0)) * (s1 - s0) / span;
        let has = |at: &i32| (0.0..f64::from(size)).contains(&place(*at));
        let pixels = first..end;
        let first = pixels.clone().find(has).unwrap_or(end);
        let places = (first..end).take_while(has).map(place).collect();
        Self { first: first.max(0) as u32, places }
    }
}

impl Framebuffer {
    /// Copies pixels of another framebuffer into a region of this one: left, bottom, right, top. Between framebuffers of
    /// as many samples each is copied; else the mean of all colours, and the first one's depth and stencil value. Colours
    /// become what `adapt` makes of them. Pixels that the source hasn't are left as they are.
    pub(crate) fn blit(
        &mut self,
        from: &Self,
        (source, destination): (Corners, Corners),
        mask: u32,
        (linear, adapt): (bool, &(dyn Fn([u8; 4]) -> [u8; 4] + Sync)),
        [left, bottom, right, top]: [i32; 4],
    ) {
        let size = from.size();
        let sides = |corners: Corners, axis: usize| [corners[axis], corners[axis + 2]];
        let axis = |axis: usize, within: [i32; 2]| {
            Axis::new(sides(source, axis), sides(destination, axis), within, size[axis])
        };
        let (columns, rows) = (axis(0, [left, right]), axis(1, [bottom, top]));
        let first = [columns.first, rows.first];
        let count = [columns.places.len() as u32, rows.places.len() as u32];
        let alike = self.samples() == from.samples();
        self.changed = true;
        let has = |bit: u32| mask & bit != 0;
        if let Some(plane) = self.color.as_mut().filter(|_| has(gl::COLOR_BUFFER_BIT)) {
            plane.write_rows(first, count, &|row, sample, colors| {
                let v = rows.places[row as usize];
                let mut words = vec![0; size[0] as usize];
                if alike && from.samples() > 1 {
                    from.color_row(v as u32, sample, &mut words);
                } else {
                    from.resolved_row(v as u32, &mut words);
                }
                for (color, &u) in colors.iter_mut().zip(&columns.places) {
                    let of = match linear && from.samples() == 1 {
                        true => from.linear(u, v),
                        false => words[u as usize].to_le_bytes(),
                    };
                    *color = u32::from_le_bytes(adapt(of));
                }
            });
        }
        let own = |sample: usize| if alike { sample } else { 0 };
        if let Some(plane) = self.depth.as_mut().filter(|_| has(gl::DEPTH_BUFFER_BIT)) {
            plane.values.write_rows(first, count, &|row, sample, depths| {
                let values = from.depth.as_ref().map(|plane| &plane.values);
                copy_row(values, (&columns, rows.places[row as usize]), own(sample), depths);
            });
        }
        if let Some(plane) = self.stencil.as_mut().filter(|_| has(gl::STENCIL_BUFFER_BIT)) {
            plane.write_rows(first, count, &|row, sample, values| {
                let from = from.stencil.as_ref();
                copy_row(from, (&columns, rows.places[row as usize]), own(sample), values);
            });
        }
    }

    /// The means of a row's samples, as words.
    fn resolved_row(&self, y: u32, words: &mut [u32]) {
        const BYTES: u32 = 0x00ff_00ff;
        let samples = self.samples();
        self.color_row(y, 0, words);
        if samples == 1 {
            return;
        }
        // Two bytes of a word at a time, each with room for their sum.
        let halves = |word: u32| [word & BYTES, word >> 8 & BYTES];
        let mut sums: Vec<[u32; 2]> = words.iter().map(|word| halves(*word)).collect();
        for sample in 1..samples {
            self.color_row(y, sample, words);
            for (sum, word) in sums.iter_mut().zip(&*words) {
                let [low, high] = halves(*word);
                *sum = [sum[0] + low, sum[1] + high];
            }
        }
        // (2 sum + count) / (2 count), rounded down.
        let count = samples as u32;
        let mean = |sum: u32| (2 * sum + count * 0x0001_0001) >> (count.ilog2() + 1) & BYTES;
        for (word, [low, high]) in words.iter_mut().zip(sums) {
            *word = mean(low) | mean(high) << 8;
        }
    }

    /// The colour between the four centres about a place, those at the border repeated.
    fn linear(&self, u: f64, v: f64) -> [u8; 4] {
        let [width, height] = self.size();
        let around = |at: f64, side: u32| {
            let at = at - 0.5;
            let low = at.floor();
            let index = |at: f64| at.clamp(0.0, f64::from(side - 1)) as u32;
            (index(low), index(low + 1.0), at - low)
        };
        let ((x0, x1, s), (y0, y1, t)) = (around(u, width), around(v, height));
        let color = |x, y| self.color([x, y]).map(f64::from);
        let (a, b, c, d) = (color(x0, y0), color(x1, y0), color(x0, y1), color(x1, y1));
        std::array::from_fn(|channel| {
            let low = a[channel] + (b[channel] - a[channel]) * s;
            let high = c[channel] + (d[channel] - c[channel]) * s;
            (low + (high - low) * t + 0.5) as u8
        })
    }
}

/// Copies the pixels of a row at one sample; zeros without a plane.
fn copy_row<T: PlaneValue>(
    from: Option<&Plane<T>>,
    (columns, v): (&Axis, f64),
    sample: usize,
    out: &mut [T],
) {
    let Some(from) = from else { return out.fill(T::default()) };
    let mut row = vec![T::default(); from.size()[0] as usize];
    from.read_row(v as u32, sample, &mut row);
    for (value, &u) in out.iter_mut().zip(&columns.places) {
        *value = row[u as usize];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const SIZE: [u32; 2] = [70, 67];

    fn framebuffer(samples: usize, colors: &[u32]) -> Framebuffer {
        let mut color = Plane::new(SIZE, samples, 0).unwrap();
        color.write_rows([0, 0], SIZE, &|row, sample, pixels| {
            for (pixel, x) in pixels.iter_mut().zip(0..) {
                *pixel = colors[(x + 71 * row as usize + 17 * sample) % colors.len()];
            }
        });
        Framebuffer { size: SIZE, color: Some(color), ..Framebuffer::default() }
    }

    fn word(of: &Framebuffer, at: [u32; 2], sample: usize) -> u32 {
        of.color.as_ref().unwrap().get(at, sample).unwrap()
    }

    /// What a pixel becomes, pixel by pixel.
    fn expected(from: &Framebuffer, samples: usize, at: [u32; 2], sample: usize) -> u32 {
        let count = from.samples() as u32;
        if samples > 1 && count > 1 {
            return word(from, at, sample);
        }
        let bytes = |sample: usize| word(from, at, sample).to_le_bytes();
        u32::from_le_bytes(std::array::from_fn(|channel| {
            let sum: u32 = (0..from.samples()).map(|of| u32::from(bytes(of)[channel])).sum();
            ((2 * sum + count) / (2 * count)) as u8
        }))
    }

    proptest! {
        #[test]
        fn ext_framebuffer_multisample_pixels_are_copied_or_rounded_means_where_both_have_them(
            colors in prop::collection::vec(any::<u32>(), 1..97),
            from_samples in prop::sample::select(vec![1, 4]), samples in prop::sample::select(vec![1, 4]),
            corner in [-40..90_i32, -40..90_i32], shift in [-50..50_i32, -50..50_i32], side in [0..90_i32, 0..90_i32],
            flips in any::<[bool; 2]>(), region in [0..70_i32, 0..67_i32],
        ) {
            let from = framebuffer(from_samples, &colors);
            let mut to = framebuffer(samples, &[9]);
            let end = [corner[0] + side[0], corner[1] + side[1]];
            let source = [corner[0], corner[1], end[0], end[1]];
            let destination = [corner[0] + shift[0], corner[1] + shift[1], end[0] + shift[0], end[1] + shift[1]];
            let turned = |mut of: [i32; 4]| {
                for axis in (0..2).filter(|axis| flips[*axis]) {
                    of.swap(axis, axis + 2);
                }
                of
            };
            // The source is turned, or both are: the same as neither.
            let both = flips[0] && flips[1];
            let to_destination = if both { turned(destination) } else { destination };
            let within = [region[0], region[1], 70, 67];
            to.blit(&from, (turned(source), to_destination), gl::COLOR_BUFFER_BIT, (false, &|color| color), within);
            for y in 0..67 {
                for x in 0..70 {
                    let at = [x, y];
                    let inside = (0..2).all(|axis: usize| {
                        (destination[axis].max(region[axis])..destination[axis + 2]).contains(&at[axis])
                    });
                    let place = [0, 1].map(|axis: usize| {
                        let straight = at[axis] - shift[axis];
                        let turned = corner[axis] + end[axis] - 1 - straight;
                        if flips[axis] && !both { turned } else { straight }
                    });
                    let there = inside && (0..70).contains(&place[0]) && (0..67).contains(&place[1]);
                    for sample in 0..samples {
                        let found = word(&to, at.map(|of| of as u32), sample);
                        let of = place.map(|of| of as u32);
                        let as_expected = if there { expected(&from, samples, of, sample) } else { 9 };
                        prop_assert_eq!(found, as_expected, "{:?} {}", at, sample);
                    }
                }
            }
        }
    }
}
