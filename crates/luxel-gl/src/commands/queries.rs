//! Occlusion queries (OpenGL 1.5, sections 4.1.7 and 6.1.12).

use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::enums as gl;
use crate::objects::list::Command;
use crate::values::Values;

/// `GL_QUERY_COUNTER_BITS`
const COUNTER_BITS: i32 = 64;

impl Context {
    /// `glGenQueries`.
    pub fn gen_queries(&mut self, count: i32) -> Vec<u32> {
        outside_begin!(self, Vec::new());
        let Ok(count) = usize::try_from(count) else {
            self.error.set(gl::INVALID_VALUE);
            return Vec::new();
        };
        let names = self.queries.generate(count);
        if names.len() < count {
            self.error.set(gl::OUT_OF_MEMORY);
        }
        names
    }

    /// `glDeleteQueries`; one that counts ends.
    pub fn delete_queries(&mut self, names: &[u32]) {
        outside_begin!(self);
        for &name in names {
            self.queries.delete(name);
        }
    }

    /// `glIsQuery`: whether a query of that name has been begun.
    pub fn is_query(&mut self, name: u32) -> bool {
        outside_begin!(self, false);
        self.queries.has(name)
    }

    /// `glBeginQuery`: counts samples that pass the depth test, from 0. `GL_INVALID_OPERATION` for name 0 and while another
    /// query counts.
    pub fn begin_query(&mut self, target: u32, name: u32) {
        compile!(self, Command::BeginQuery(target, name));
        outside_begin!(self);
        demand!(self, target == gl::SAMPLES_PASSED, gl::INVALID_ENUM);
        let can = name != 0 && self.queries.active.is_none();
        demand!(self, can, gl::INVALID_OPERATION);
        if !self.queries.begin(name) {
            self.error.set(gl::OUT_OF_MEMORY);
        }
    }

    /// `glEndQuery`. `GL_INVALID_OPERATION` if none counts.
    pub fn end_query(&mut self, target: u32) {
        compile!(self, Command::EndQuery(target));
        outside_begin!(self);
        demand!(self, target == gl::SAMPLES_PASSED, gl::INVALID_ENUM);
        demand!(self, self.queries.active.take().is_some(), gl::INVALID_OPERATION);
    }

    /// `glGetQuery`: the name of the query that counts, or the bits of counters.
    pub fn get_query(&mut self, target: u32, pname: u32) -> Option<Values> {
        outside_begin!(self, None);
        match pname {
            _ if target != gl::SAMPLES_PASSED => {}
            gl::CURRENT_QUERY => return Some(Values::name(self.queries.active.unwrap_or(0))),
            gl::QUERY_COUNTER_BITS => return Some(Values::integer(COUNTER_BITS)),
            _ => {}
        }
        self.error.set(gl::INVALID_ENUM);
        None
    }

    /// `glGetQueryObject`: the samples that passed, or whether they can be had at once, which is always so.
    /// `GL_INVALID_OPERATION` for a query that hasn't been begun or that counts.
    pub fn get_query_object(&mut self, name: u32, pname: u32) -> Option<u64> {
        outside_begin!(self, None);
        if !self.queries.has(name) || self.queries.active == Some(name) {
            self.error.set(gl::INVALID_OPERATION);
            return None;
        }
        match pname {
            gl::QUERY_RESULT => {
                self.carry_out();
                self.queries.count(name)
            }
            gl::QUERY_RESULT_AVAILABLE => Some(1),
            _ => {
                self.error.set(gl::INVALID_ENUM);
                None
            }
        }
    }
}
