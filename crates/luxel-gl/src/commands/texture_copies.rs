//! Images of textures from the framebuffer: `glCopyTexImage`, `glCopyTexSubImage` (OpenGL 1.5, section 3.8.2).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::image_calls::{CopyTexImage, CopyTexSubImage, TexImage};
use crate::objects::list::Command;
use crate::texture::{InternalFormat, TextureImage, locked};

impl Context {
    /// `glCopyTexImage1D`, `2D`: an image from the framebuffer.
    #[expect(clippy::too_many_arguments, reason = "glCopyTexImage2D has more")]
    pub fn copy_tex_image(
        &mut self,
        dimensions: u32,
        target: u32,
        level: i32,
        internal: u32,
        from: [i32; 2],
        size: [i32; 2],
        border: i32,
    ) {
        let dimensions = dimensions as usize;
        let call = CopyTexImage { dimensions, target, level, internal, from, size, border };
        self.copy_image(&call);
    }

    pub(super) fn copy_image(&mut self, call: &CopyTexImage) {
        compile!(self, Command::CopyTexImage(Box::new(*call)));
        outside_begin!(self);
        let [width, height] = call.size;
        // Numbers of components are no formats here.
        let format =
            if (1..=4).contains(&call.internal) { gl::INVALID_ENUM } else { call.internal };
        let Some(internal) = InternalFormat::named(format) else {
            return self.error.set(gl::INVALID_ENUM);
        };
        let image = TexImage {
            dimensions: call.dimensions,
            target: call.target,
            level: call.level,
            internal: call.internal,
            size: [width, height, 1],
            border: call.border,
            format: if internal.is_depth() { gl::DEPTH_COMPONENT } else { gl::RGBA },
            data_type: gl::UNSIGNED_BYTE,
        };
        let (of, level, format, _) = match image.checked() {
            Ok((of, ..)) if of.proxy => return self.error.set(gl::INVALID_ENUM),
            Ok(checked) => checked,
            Err(error) => return self.error.set(error),
        };
        let there = if format.is_depth() { self.reads_depths() } else { self.reads_colors() };
        demand!(self, there, gl::INVALID_OPERATION);
        demand!(self, !self.reads_samples(), gl::INVALID_OPERATION);
        let size = image.size.map(|side| side as u32);
        let budget = self.textures().budget.clone();
        let border = call.border as u32;
        let replaced = self.active_texture_of(of.target);
        self.leave_images(&replaced);
        let Some(mut image) = TextureImage::new(call.internal, format, size, border, &budget)
        else {
            return self.error.set(gl::OUT_OF_MEMORY);
        };
        let texels = self.copied(image.format.is_depth(), call.from, call.size);
        put(&mut image, [0; 3], &texels);
        self.put_image(of, level, image);
    }

    /// `glCopyTexSubImage1D`, `2D`, `3D`: a part of an image from the framebuffer.
    pub fn copy_tex_sub_image(
        &mut self,
        dimensions: u32,
        target: u32,
        level: i32,
        offset: [i32; 3],
        from: [i32; 2],
        size: [i32; 2],
    ) {
        let dimensions = dimensions as usize;
        self.copy_part(&CopyTexSubImage { dimensions, target, level, offset, from, size });
    }

    pub(super) fn copy_part(&mut self, call: &CopyTexSubImage) {
        compile!(self, Command::CopyTexSubImage(Box::new(*call)));
        outside_begin!(self);
        let size = [call.size[0], call.size[1], 1];
        let checked =
            self.checked_part((call.dimensions, call.target), call.level, call.offset, size);
        let (of, level, offset, is_depth) = match checked {
            Ok(checked) => checked,
            Err(error) => return self.error.set(error),
        };
        let there = if is_depth { self.reads_depths() } else { self.reads_colors() };
        demand!(self, there, gl::INVALID_OPERATION);
        demand!(self, !self.reads_samples(), gl::INVALID_OPERATION);
        let texture = self.active_texture_of(of.target);
        // All is read before it is written: the texture itself may be what is read.
        let texels = self.copied(is_depth, call.from, call.size);
        self.leave_images(&texture);
        self.with_texture_at_rest(&texture, |context| {
            if let Some(image) = locked(&texture).image_mut(of.face, level) {
                put(image, offset, &texels);
            }
            context.image_changed(of, level);
        });
    }

    /// Pixels of the framebuffer that is read, by the transfer, each with its place from the first one; those outside of
    /// it are left out.
    fn copied(
        &mut self,
        is_depth: bool,
        [x, y]: [i32; 2],
        [width, height]: [i32; 2],
    ) -> Vec<([u32; 2], [f32; 4])> {
        self.with_read_framebuffer(|context| {
            context.carry_out();
            let [frame_width, frame_height] = context.framebuffer.size().map(i64::from);
            let (transfer, colors) = (context.transfer(), context.frame_colors());
            let (x, y) = (i64::from(x), i64::from(y));
            let rows = (-y).max(0)..i64::from(height).min(frame_height - y);
            let columns = (-x).max(0)..i64::from(width).min(frame_width - x);
            let places = rows.flat_map(|row| columns.clone().map(move |column| [column, row]));
            places
                .map(|[column, row]| {
                    let at = [(x + column) as u32, (y + row) as u32];
                    let color = if is_depth {
                        context.framebuffer.unit_depth_stencil(at)
                    } else {
                        colors.color(at)
                    };
                    ([column as u32, row as u32], transfer.values(color, is_depth))
                })
                .collect()
        })
    }
}

/// Writes texels into an image.
fn put(image: &mut TextureImage, [across, up, deep]: [u32; 3], texels: &[([u32; 2], [f32; 4])]) {
    for ([column, row], color) in texels {
        let index = image.index([across + column, up + row, deep]);
        image.put(index, *color);
    }
}
