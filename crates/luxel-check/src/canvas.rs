//! Lines and rectangles with smooth edges, drawn over a finished picture.

use luxel_scene::Size;

/// A picture that is drawn over.
///
/// Shapes of one colour are collected first, each pixel keeping the most that one of them covers, so
/// that lines that meet don't darken each other's edges.
pub(crate) struct Canvas<'a> {
    size: Size,
    pixels: &'a mut [[u8; 4]],
    coverage: Vec<f32>,
}

impl<'a> Canvas<'a> {
    pub(crate) fn new(size: Size, pixels: &'a mut [[u8; 4]]) -> Self {
        let coverage = vec![0.0; pixels.len()];
        Self { size, pixels, coverage }
    }

    /// Collects a line with round ends; a dot, if its ends are one.
    pub(crate) fn line(&mut self, [[ax, ay], [bx, by]]: [[f64; 2]; 2], width: f64) {
        let radius = width * 0.5;
        let (dx, dy) = (bx - ax, by - ay);
        let squared = dx * dx + dy * dy;
        let distance = |x: f64, y: f64| {
            let along = if squared > 0.0 {
                (((x - ax) * dx + (y - ay) * dy) / squared).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let (x, y) = (x - ax - along * dx, y - ay - along * dy);
            (x * x + y * y).sqrt()
        };
        let bounds = [ax.min(bx), ay.min(by), ax.max(bx), ay.max(by)];
        // A long line crosses a row on a short piece, so that its box is mostly empty.
        let columns = |y: f64| {
            let part = |y: f64| ((y - ay) / dy).clamp(0.0, 1.0);
            let [from, to] = match dy == 0.0 {
                true => [ax, bx],
                false => [y - radius - 1.0, y + radius + 1.0].map(|y| ax + dx * part(y)),
            };
            [from.min(to), from.max(to)]
        };
        self.shape(bounds, radius, columns, distance);
    }

    /// Collects a rectangle, left, top, right, bottom.
    pub(crate) fn rectangle(&mut self, [left, top, right, bottom]: [f64; 4]) {
        let distance = |x: f64, y: f64| (left - x).max(x - right).max(top - y).max(y - bottom);
        self.shape([left, top, right, bottom], 0.0, |_| [left, right], distance);
    }

    /// Collects what is nearer than a radius by some measure of distance: in the row of pixels about y, between
    /// two columns and a radius around them.
    fn shape(
        &mut self,
        [_, top, _, bottom]: [f64; 4],
        radius: f64,
        columns: impl Fn(f64) -> [f64; 2],
        distance: impl Fn(f64, f64) -> f64,
    ) {
        let reach = radius + 1.0;
        let range = |from: f64, to: f64, count: u32| {
            let clamped = |at: f64| at.clamp(0.0, f64::from(count)) as usize;
            clamped((from - reach).floor())..clamped((to + reach).ceil())
        };
        for row in range(top, bottom, self.size.height) {
            let [left, right] = columns(row as f64 + 0.5);
            for column in range(left, right, self.size.width) {
                let away = distance(column as f64 + 0.5, row as f64 + 0.5);
                let covered = (radius + 0.5 - away).clamp(0.0, 1.0) as f32;
                let kept = &mut self.coverage[row * self.size.width as usize + column];
                *kept = kept.max(covered);
            }
        }
    }

    /// Blends what was collected with a colour where `takes` takes the pixel, and forgets it.
    pub(crate) fn ink(&mut self, color: [u8; 3], opacity: f32, takes: impl Fn(usize) -> bool) {
        for (number, (pixel, coverage)) in
            self.pixels.iter_mut().zip(&mut self.coverage).enumerate()
        {
            let covered = std::mem::take(coverage) * opacity;
            if covered <= 0.0 || !takes(number) {
                continue;
            }
            let behind = f32::from(pixel[3]) / 255.0 * (1.0 - covered);
            let alpha = covered + behind;
            for (channel, color) in pixel.iter_mut().zip(color) {
                let mixed = f32::from(color) * covered + f32::from(*channel) * behind;
                *channel = (mixed / alpha).round() as u8;
            }
            pixel[3] = (alpha * 255.0).round() as u8;
        }
    }

    /// How many of the pixels of a rectangle show something.
    pub(crate) fn shown(&self, [left, top, right, bottom]: [f64; 4]) -> usize {
        let width = self.size.width as usize;
        let rows = top.max(0.0) as usize..(bottom.max(0.0) as usize).min(self.size.height as usize);
        let columns = left.max(0.0) as usize..(right.max(0.0) as usize).min(width);
        rows.flat_map(|row| columns.clone().map(move |column| row * width + column))
            .filter(|&pixel| self.pixels[pixel][3] > 0)
            .count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_as_wide_as_it_should_be_on_any_ground() {
        let size = Size { width: 9, height: 9 };
        for ground in [[0; 4], [255; 4], [90, 90, 90, 255]] {
            let mut pixels = vec![ground; 81];
            let mut canvas = Canvas::new(size, &mut pixels);
            // Twice: lines of one colour don't add up.
            canvas.line([[-5.0, 4.25], [15.0, 4.25]], 2.5);
            canvas.line([[-5.0, 4.25], [15.0, 4.25]], 2.5);
            canvas.ink([200, 10, 10], 1.0, |_| true);
            let column: Vec<_> = (0..9).map(|row| pixels[row * 9 + 4]).collect();
            assert_eq!(column[3..5], [[200, 10, 10, 255]; 2]);
            assert_eq!((column[1], column[7]), (ground, ground));
            if ground[3] == 0 {
                let alpha: u32 = column.iter().map(|pixel| u32::from(pixel[3])).sum();
                assert!(alpha.abs_diff(637) <= 2, "{alpha} of 2.5 times 255");
            }
        }
    }
}
