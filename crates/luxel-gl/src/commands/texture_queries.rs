//! Queries of textures, environments and generated coordinates (OpenGL 1.5, sections 6.1.3 and 6.1.4).

use super::texture_environment::{OPERANDS, SOURCES, argument};
use crate::Context;
use crate::context::outside_begin;
use crate::enums as gl;
use crate::pixels::format::{Components, PixelFormat};
use crate::pixels::unpack::ImageLayout;
use crate::texture::object::ImageTarget;
use crate::texture::{Parameters, Target, TextureImage, locked};
use crate::values::Values;
use std::sync::Arc;

/// A parameter's value; `None` for a name that isn't one.
fn parameter(parameters: &Parameters, pname: u32) -> Option<Values> {
    Some(match pname {
        gl::TEXTURE_WRAP_S => Values::name(parameters.wrap[0]),
        gl::TEXTURE_WRAP_T => Values::name(parameters.wrap[1]),
        gl::TEXTURE_WRAP_R => Values::name(parameters.wrap[2]),
        gl::TEXTURE_MIN_FILTER => Values::name(parameters.minify),
        gl::TEXTURE_MAG_FILTER => Values::name(parameters.magnify),
        gl::TEXTURE_BORDER_COLOR => Values::scaled(parameters.border),
        gl::TEXTURE_PRIORITY => Values::scaled([parameters.priority]),
        gl::TEXTURE_RESIDENT => Values::boolean(true),
        gl::TEXTURE_MIN_LOD => Values::real(parameters.least_lod),
        gl::TEXTURE_MAX_LOD => Values::real(parameters.largest_lod),
        gl::TEXTURE_BASE_LEVEL => Values::integer(parameters.base_level),
        gl::TEXTURE_MAX_LEVEL => Values::integer(parameters.max_level),
        gl::TEXTURE_LOD_BIAS => Values::real(parameters.lod_bias),
        gl::DEPTH_TEXTURE_MODE => Values::name(parameters.depth_mode),
        gl::TEXTURE_COMPARE_MODE => Values::name(parameters.compare_mode),
        gl::TEXTURE_COMPARE_FUNC => Values::name(parameters.compare_func),
        gl::GENERATE_MIPMAP => Values::boolean(parameters.generate_mipmap),
        _ => return None,
    })
}

/// A value of an image; of a level that isn't there the default. `None` for a name that isn't one.
fn level_parameter(image: Option<&TextureImage>, pname: u32) -> Option<Values> {
    let size = image.map_or([0; 3], |image| image.size);
    let bits = image.map_or([0; 7], |image| image.format.component_bits());
    Some(match pname {
        gl::TEXTURE_WIDTH => Values::name(size[0]),
        gl::TEXTURE_HEIGHT => Values::name(size[1]),
        gl::TEXTURE_DEPTH => Values::name(size[2]),
        gl::TEXTURE_BORDER => Values::name(image.map_or(0, |image| image.border)),
        // A level that was never specified has format 1.
        gl::TEXTURE_INTERNAL_FORMAT => Values::name(image.map_or(1, |image| image.name)),
        gl::TEXTURE_RED_SIZE => Values::name(bits[0]),
        gl::TEXTURE_GREEN_SIZE => Values::name(bits[1]),
        gl::TEXTURE_BLUE_SIZE => Values::name(bits[2]),
        gl::TEXTURE_ALPHA_SIZE => Values::name(bits[3]),
        gl::TEXTURE_LUMINANCE_SIZE => Values::name(bits[4]),
        gl::TEXTURE_INTENSITY_SIZE => Values::name(bits[5]),
        gl::TEXTURE_DEPTH_SIZE => Values::name(bits[6]),
        gl::TEXTURE_COMPRESSED => Values::boolean(false),
        gl::TEXTURE_STENCIL_SIZE => {
            Values::integer(if image.is_some_and(|image| image.format.stencil) { 8 } else { 0 })
        }
        // Of formats with an exponent for all (EXT_texture_shared_exponent), which none has.
        gl::TEXTURE_SHARED_SIZE => Values::integer(0),
        _ => return None,
    })
}

impl Context {
    /// Values that a query found, or `GL_INVALID_ENUM`.
    fn found(&mut self, values: Option<Values>) -> Option<Values> {
        if values.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        values
    }

    /// `glGetTexParameter`.
    pub fn get_tex_parameter(&mut self, target: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let values = Target::named(target).and_then(|target| {
            let texture = self.active_texture_of(target);
            let texture = locked(&texture);
            parameter(texture.parameters(), pname)
        });
        self.found(values)
    }

    /// The image of a level of the bound texture.
    fn image_of(&mut self, of: ImageTarget, level: usize) -> Option<Arc<TextureImage>> {
        let texture = self.active_texture_of(of.target);
        self.with_texture_at_rest(&texture, |_| {
            locked(&texture).image(of.face, level).map(Arc::clone)
        })
    }

    /// `glGetTexLevelParameter`: also of proxies. `GL_INVALID_VALUE` for a level that can't be.
    pub fn get_tex_level_parameter(
        &mut self,
        target: u32,
        level: i32,
        pname: u32,
    ) -> Option<Values> {
        outside_begin!(self, None);
        let Some(of) = ImageTarget::named(target) else { return self.found(None) };
        if !(0..of.target.levels()).contains(&level) {
            self.error.set(gl::INVALID_VALUE);
            return None;
        }
        let level = level as usize;
        let values = if of.proxy {
            level_parameter(self.proxies.get(&(of.target as usize, level)), pname)
        } else {
            level_parameter(self.image_of(of, level).as_deref(), pname)
        };
        self.found(values)
    }

    /// The image, format and layout of `glGetTexImage`; an error, or `Ok(None)` for a level without image.
    fn gettable(
        &mut self,
        target: u32,
        level: i32,
        format: u32,
        data_type: u32,
    ) -> Result<Option<(Arc<TextureImage>, PixelFormat, ImageLayout)>, u32> {
        let of = ImageTarget::named(target).filter(|of| !of.proxy).ok_or(gl::INVALID_ENUM)?;
        if !(0..of.target.levels()).contains(&level) {
            return Err(gl::INVALID_VALUE);
        }
        let kind = PixelFormat::named(format, data_type)?;
        if kind.components == Components::Stencil {
            return Err(gl::INVALID_ENUM);
        }
        let Some(image) = self.image_of(of, level as usize) else { return Ok(None) };
        let stencil = kind.components == Components::DepthStencil;
        if kind.components.has_depth() != image.format.is_depth()
            || stencil && !image.format.stencil
        {
            return Err(gl::INVALID_OPERATION);
        }
        let size = image.size.map(|side| side as usize);
        let layout = ImageLayout::new(&self.client.pack, size, kind, of.target.dimensions());
        Ok(Some((image, kind, layout)))
    }

    /// Bytes that `glGetTexImage` writes to; 0 after an error, and for a level without image.
    pub fn get_tex_image_bytes(
        &mut self,
        target: u32,
        level: i32,
        format: u32,
        data_type: u32,
    ) -> usize {
        outside_begin!(self, 0);
        match self.gettable(target, level, format, data_type) {
            Ok(image) => image.map_or(0, |(_, _, layout)| layout.end),
            Err(error) => {
                self.error.set(error);
                0
            }
        }
    }

    /// `glGetTexImage`, as far as the slice goes.
    pub fn get_tex_image(
        &mut self,
        target: u32,
        level: i32,
        format: u32,
        data_type: u32,
        destination: &mut [u8],
    ) {
        outside_begin!(self);
        let (image, kind, layout) = match self.gettable(target, level, format, data_type) {
            Ok(Some(gettable)) => gettable,
            Ok(None) => return,
            Err(error) => return self.error.set(error),
        };
        let swap = self.client.pack.swap_bytes;
        let [width, height, depth] = image.size;
        for z in 0..depth {
            for y in 0..height {
                for x in 0..width {
                    let index = image.index([x, y, z]);
                    let texel = image.format.base.returned(image.get(index), 0.0, 1.0);
                    let start = layout.offset([x, y, z].map(|at| at as usize));
                    let end = start.saturating_add(kind.bytes());
                    let Some(out) = destination.get_mut(start..end) else { return };
                    let mut values = [0.0; 4];
                    match kind.components {
                        Components::Colors(places) => {
                            for (value, &place) in values.iter_mut().zip(places) {
                                *value = texel[place];
                            }
                        }
                        Components::Luminance { .. } => {
                            // The first component, not the sum that glReadPixels makes.
                            values = [texel[0], texel[3], 0.0, 0.0];
                        }
                        _ => {
                            values[0] = texel[0];
                            values[1] = image.stencil(index) as f32 / 255.0;
                        }
                    }
                    kind.write(&values[..kind.components.count()], swap, out);
                }
            }
        }
    }

    /// `glGetTexEnv`.
    pub fn get_tex_env(&mut self, target: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let unit = &self.state.texture.units[self.state.active_texture];
        let of = &unit.environment;
        let values = match (target, pname) {
            (gl::TEXTURE_FILTER_CONTROL, gl::TEXTURE_LOD_BIAS) => Some(Values::real(unit.lod_bias)),
            (gl::TEXTURE_ENV, gl::TEXTURE_ENV_MODE) => Some(Values::name(of.mode)),
            (gl::TEXTURE_ENV, gl::TEXTURE_ENV_COLOR) => Some(Values::scaled(of.color)),
            (gl::TEXTURE_ENV, gl::COMBINE_RGB) => Some(Values::name(of.combine[0])),
            (gl::TEXTURE_ENV, gl::COMBINE_ALPHA) => Some(Values::name(of.combine[1])),
            (gl::TEXTURE_ENV, gl::RGB_SCALE) => Some(Values::real(of.scales[0])),
            (gl::TEXTURE_ENV, gl::ALPHA_SCALE) => Some(Values::real(of.scales[1])),
            (gl::TEXTURE_ENV, _) => argument(pname, SOURCES)
                .map(|(of_what, number)| Values::name(of.sources[of_what][number]))
                .or_else(|| {
                    let (of_what, number) = argument(pname, OPERANDS)?;
                    Some(Values::name(of.operands[of_what][number]))
                }),
            _ => None,
        };
        self.found(values)
    }

    /// `glGetTexGen`.
    pub fn get_tex_gen(&mut self, coordinate: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let unit = &self.state.texture.units[self.state.active_texture];
        let generator = unit.generation.0.get(coordinate.wrapping_sub(gl::S) as usize);
        let values = generator.and_then(|generator| match pname {
            gl::TEXTURE_GEN_MODE => Some(Values::name(generator.mode)),
            gl::OBJECT_PLANE => Some(Values::reals(generator.object_plane)),
            gl::EYE_PLANE => Some(Values::reals(generator.eye_plane)),
            _ => None,
        });
        self.found(values)
    }
}
