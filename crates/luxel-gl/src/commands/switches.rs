//! `glEnable`, `glDisable`, hints.

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;
use crate::state::attributes::Hints;

impl Context {
    /// `glEnable`.
    pub fn enable(&mut self, capability: u32) {
        compile!(self, Command::Enable(capability));
        self.switch(capability, true);
    }

    /// `glDisable`.
    pub fn disable(&mut self, capability: u32) {
        compile!(self, Command::Disable(capability));
        self.switch(capability, false);
    }

    fn switch(&mut self, capability: u32, on: bool) {
        outside_begin!(self);
        // EXT_vertex_array had no glEnableClientState.
        if let Some(array) = self.client.arrays.named_mut(capability) {
            array.enabled = on;
            return;
        }
        let unit = self.state.active_texture;
        demand!(self, self.state.enables.set(capability, on, unit), gl::INVALID_ENUM);
        if capability == gl::COLOR_MATERIAL && on {
            self.color_drives_material();
        }
    }

    /// `glIsEnabled`.
    pub fn is_enabled(&mut self, capability: u32) -> bool {
        outside_begin!(self, false);
        let array = self.client.arrays.named(capability);
        let found = self
            .state
            .enables
            .get(capability, self.state.active_texture)
            .or(array.map(|array| array.enabled));
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found.unwrap_or(false)
    }

    /// `glHint`: kept, but without effect, since everything is drawn exactly anyway.
    pub fn hint(&mut self, target: u32, mode: u32) {
        compile!(self, Command::Hint(target, mode));
        outside_begin!(self);
        let place = Hints::TARGETS.iter().position(|known| *known == target);
        let is_mode = matches!(mode, gl::FASTEST | gl::NICEST | gl::DONT_CARE);
        match place.filter(|_| is_mode) {
            Some(place) => self.state.hints.0[place] = mode,
            None => self.error.set(gl::INVALID_ENUM),
        }
    }
}
