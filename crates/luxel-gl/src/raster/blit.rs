//! Copies of rectangles between framebuffers (EXT_framebuffer_blit).

use super::framebuffer::Framebuffer;
use crate::enums as gl;

/// A rectangle by two corners: x and y of the first, then of the second.
type Corners = [i32; 4];

impl Framebuffer {
    /// Copies pixels of another framebuffer into a region of this one: left, bottom, right, top. Between framebuffers of
    /// as many samples each is copied; else the mean of all colours, and the first one's depth and stencil value. Colours
    /// become what `adapt` makes of them.
    pub(crate) fn blit(
        &mut self,
        from: &Self,
        (source, destination): (Corners, Corners),
        mask: u32,
        (linear, adapt): (bool, &dyn Fn([u8; 4]) -> [u8; 4]),
        [left, bottom, right, top]: [i32; 4],
    ) {
        let side = |axis: usize| {
            let (a, b) = (i64::from(destination[axis]), i64::from(destination[axis + 2]));
            (a.min(b), a.max(b))
        };
        let ((first_x, end_x), (first_y, end_y)) = (side(0), side(1));
        let columns = first_x.max(i64::from(left))..end_x.min(i64::from(right));
        let rows = first_y.max(i64::from(bottom))..end_y.min(i64::from(top));
        let [width, height] = from.size().map(f64::from);
        // The place in the source of the centre of a pixel of the destination.
        let place = |axis: usize, at: i64| {
            let [s0, s1] = [source[axis], source[axis + 2]].map(f64::from);
            let [d0, d1] = [destination[axis], destination[axis + 2]].map(f64::from);
            s0 + (at as f64 + 0.5 - d0) * (s1 - s0) / (d1 - d0)
        };
        for y in rows {
            for x in columns.clone() {
                let [u, v] = [place(0, x), place(1, y)];
                // Pixels that the source hasn't are left as they are.
                if !(u >= 0.0 && v >= 0.0 && u < width && v < height) {
                    continue;
                }
                let (at, nearest) = ([x as u32, y as u32], [u as u32, v as u32]);
                for sample in 0..self.samples() {
                    let alike = self.samples() == from.samples();
                    let own = if alike { sample } else { 0 };
                    if mask & gl::COLOR_BUFFER_BIT != 0 {
                        let color = match alike && from.samples() > 1 {
                            true => from.sample_color(nearest, own),
                            false if linear && from.samples() == 1 => from.linear(u, v),
                            false => from.resolved(nearest),
                        };
                        self.set_color(at, sample, adapt(color));
                    }
                    if mask & gl::DEPTH_BUFFER_BIT != 0 {
                        self.set_depth(at, sample, from.kept_depth(nearest, own));
                    }
                    if mask & gl::STENCIL_BUFFER_BIT != 0 {
                        self.set_stencil(at, sample, from.sample_stencil(nearest, own));
                    }
                }
            }
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
