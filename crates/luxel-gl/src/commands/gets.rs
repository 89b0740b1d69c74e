//! `glGet` (OpenGL 1.5, section 6.1).

use super::gets_table::value_of;
use crate::Context;
use crate::context::outside_begin;
use crate::enums as gl;
use crate::values::Values;

impl Context {
    /// `glGetBooleanv`, `glGetIntegerv`, `glGetFloatv`, `glGetDoublev`: the values, which the caller converts.
    /// `GL_INVALID_ENUM` for a name that isn't one.
    pub fn get(&mut self, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        let found = value_of(self, pname);
        if found.is_none() {
            self.error.set(gl::INVALID_ENUM);
        }
        found
    }
}
