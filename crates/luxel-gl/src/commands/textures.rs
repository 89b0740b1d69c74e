//! Texture objects: names, bindings, priorities (OpenGL 1.5, section 3.8.12), and what a draw samples.

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::fragment::TextureStages;
use crate::objects::framebuffer::Attachment;
use crate::objects::list::Command;
use crate::texture::{Target, TextureHandle, locked};
use std::sync::Arc;

impl Context {
    /// The texture that is bound to a target of a unit.
    pub(crate) fn bound_texture(&self, unit: usize, target: Target) -> TextureHandle {
        match self.state.texture.units[unit].bound(target) {
            Some(texture) => TextureHandle::clone(texture),
            None => self.textures().default_of(target),
        }
    }

    /// The texture that is bound to a target of the active unit.
    pub(crate) fn active_texture_of(&self, target: Target) -> TextureHandle {
        self.bound_texture(self.state.active_texture, target)
    }

    /// What the textures of a draw come to: enabled and complete ones (sections 3.8.10 and 3.8.15).
    pub(super) fn texture_stages(&self) -> Option<TextureStages> {
        let enables = &self.state.enables;
        if enables.textures == [0; crate::limits::TEXTURE_UNITS] {
            return None;
        }
        let sums = enables.has(gl::COLOR_SUM) && !enables.has(gl::LIGHTING);
        let separate = enables.has(gl::LIGHTING)
            && self.state.lights.model.color_control == gl::SEPARATE_SPECULAR_COLOR;
        let texture = |unit: usize| {
            let target = enables.texture_target(unit)?;
            locked(&self.bound_texture(unit, target)).sampled()
        };
        TextureStages::new(&self.state, texture, sums || separate)
    }

    /// `glGenTextures`: so many names that no texture has. `GL_INVALID_VALUE` for a negative count.
    pub fn gen_textures(&mut self, count: i32) -> Vec<u32> {
        outside_begin!(self, Vec::new());
        let Ok(count) = usize::try_from(count) else {
            self.error.set(gl::INVALID_VALUE);
            return Vec::new();
        };
        let names = self.textures().generate(count);
        names.unwrap_or_else(|| {
            self.error.set(gl::OUT_OF_MEMORY);
            Vec::new()
        })
    }

    /// `glDeleteTextures`: a texture that is bound here is replaced by that of name 0; elsewhere it lives on until it is
    /// let go. `count` may be negative: `GL_INVALID_VALUE`.
    pub fn delete_textures(&mut self, count: i32, names: &[u32]) {
        outside_begin!(self);
        demand!(self, count >= 0, gl::INVALID_VALUE);
        for &name in names.iter().filter(|name| **name != 0) {
            let texture = self.textures().get(name);
            if let Some(texture) = texture {
                self.leave_images(&texture);
                self.with_texture_at_rest(&texture, |context| {
                    context.framebuffers.detach(|image| {
                        matches!(image, Attachment::Texture { texture: of, .. }
                            if Arc::ptr_eq(of, &texture))
                    });
                });
            }
            self.textures().delete(name);
            for unit in &mut self.state.texture.units {
                for bound in &mut unit.bound {
                    if bound.as_ref().is_some_and(|texture| locked(texture).name == name) {
                        *bound = None;
                    }
                }
            }
        }
    }

    /// `glBindTexture`: the texture of a name, made on first use. `GL_INVALID_OPERATION` if it has another target.
    pub fn bind_texture(&mut self, target: u32, name: u32) {
        compile!(self, Command::BindTexture(target, name));
        outside_begin!(self);
        let Some(target) = Target::named(target) else {
            self.error.set(gl::INVALID_ENUM);
            return;
        };
        let bound = self.textures().bind(target, name);
        match bound {
            Ok(texture) => {
                let unit = &mut self.state.texture.units[self.state.active_texture];
                unit.bound[target as usize] = (name != 0).then_some(texture);
            }
            Err(error) => self.error.set(error),
        }
    }

    /// `glIsTexture`: whether a name is that of a texture, which it is once it has been bound.
    pub fn is_texture(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.textures().get(name).is_some()
    }

    /// `glAreTexturesResident`: all are. `None` after an error: `GL_INVALID_VALUE` for a negative count or a name that
    /// no texture has.
    pub fn are_textures_resident(&mut self, count: i32, names: &[u32]) -> Option<bool> {
        outside_begin!(self, None);
        let known = count >= 0 && names.iter().all(|name| self.textures().get(*name).is_some());
        if !known {
            self.error.set(gl::INVALID_VALUE);
            return None;
        }
        Some(true)
    }

    /// `glPrioritizeTextures`: kept, without effect. Names without texture are passed over.
    pub fn prioritize_textures(&mut self, count: i32, names: &[u32], priorities: &[f32]) {
        let pairs = names.iter().copied().zip(priorities.iter().copied());
        compile!(self, Command::PrioritizeTextures(count, pairs.clone().collect()));
        outside_begin!(self);
        demand!(self, count >= 0, gl::INVALID_VALUE);
        for (name, priority) in pairs {
            let texture = self.textures().get(name);
            if let Some(texture) = texture {
                locked(&texture).parameters_mut().priority = super::fragments::unit(priority);
            }
        }
    }
}
