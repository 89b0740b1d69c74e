//! Bitmaps at the raster position (OpenGL 1.5, section 3.7).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::image_calls::BitmapCall;
use crate::objects::list::Command;
use crate::pixels::store::{bitmap_bytes, read_bitmap};
use crate::raster::Batch;
use crate::vertex::Processed;
use luxel_pick::{Feedback, FeedbackVertex};
use std::sync::Arc;

/// What the transform in `f32` may take from a raster position that lies on a pixel's edge, in pixels: it must not
/// move the bitmap to the pixel before.
const RASTER_ERROR: f32 = 1e-4;

impl Context {
    /// Bytes that `glBitmap` reads.
    #[must_use]
    pub fn bitmap_bytes(&self, width: i32, height: i32) -> usize {
        let sides = [width, height].map(|side| usize::try_from(side).unwrap_or(0));
        bitmap_bytes(&self.client.unpack, sides)
    }

    /// `glBitmap`: a fragment of the raster position's colours for each bit; then the position moves. Without bits it only
    /// moves.
    pub fn bitmap(
        &mut self,
        [width, height]: [i32; 2],
        origin: [f32; 2],
        step: [f32; 2],
        bits: Option<&[u8]>,
    ) {
        let sides = [width, height].map(|side| usize::try_from(side).ok());
        let Some(sides) = sides[0].zip(sides[1]) else {
            self.error.set(gl::INVALID_VALUE);
            return;
        };
        let sides = if bits.is_some() { [sides.0, sides.1] } else { [0; 2] };
        let Some(bitmap) = read_bitmap(bits.unwrap_or(&[]), &self.client.unpack, sides) else {
            self.error.set(gl::OUT_OF_MEMORY);
            return;
        };
        self.draw_bitmap(&Arc::new(BitmapCall { bitmap: Arc::new(bitmap), origin, step }));
    }

    pub(crate) fn draw_bitmap(&mut self, call: &Arc<BitmapCall>) {
        compile!(self, Command::Bitmap(Arc::clone(call)));
        outside_begin!(self);
        if !self.state.current.raster.valid {
            return;
        }
        match self.render_mode {
            gl::RENDER => self.render_bitmap(call),
            gl::FEEDBACK => self.feed_bitmap_back(),
            _ => {}
        }
        let window = &mut self.state.current.raster.window;
        window[0] += call.step[0];
        window[1] += call.step[1];
    }

    fn render_bitmap(&mut self, call: &BitmapCall) {
        let scale = self.window_scale();
        let Some((pipeline, viewport)) = self.begin_draw() else { return };
        let raster = &self.state.current.raster;
        let corner = [0, 1]
            .map(|axis: usize| (raster.window[axis] + RASTER_ERROR - call.origin[axis]).floor());
        demand!(self, corner.iter().all(|at| at.abs() < 1e6), gl::NO_ERROR);
        let depth = scale.kind.kept(raster.window[2].into());
        let vertices = Box::new(Processed::at_raster(raster, self.state.enables.sums_colors()));
        let mut batch = Batch::new(pipeline, viewport, scale, vertices);
        let corner = corner.map(|at| at as i32);
        let piece = batch.put_bitmap(Arc::clone(&call.bitmap), corner, depth);
        self.finish_draw(batch, vec![piece]);
    }

    fn feed_bitmap_back(&mut self) {
        let raster = &self.state.current.raster;
        let [x, y, depth, w] = raster.window.map(f64::from);
        let (color, texture) = (raster.color, raster.tex_coords[0]);
        let vertex = FeedbackVertex { x, y, depth, w, color, texture };
        self.feedback.put(&Feedback::Bitmap(&vertex));
    }
}
