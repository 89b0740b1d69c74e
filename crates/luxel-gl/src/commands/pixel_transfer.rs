//! `glPixelTransfer` and `glPixelMap` (OpenGL 1.5, sections 3.6.3 and 6.1.5).

use super::fragments::unit;
use crate::Context;
use crate::context::{compile, demand, outside_begin};
use crate::convert;
use crate::enums as gl;
use crate::objects::list::Command;
use crate::state::transfer::{PixelMaps, Transfer};
use std::sync::Arc;

impl Context {
    /// What pixels go through at the moment.
    pub(super) fn transfer(&self) -> Transfer {
        Transfer { by: self.state.pixel.transfer, maps: Arc::clone(&self.pixel_maps) }
    }

    /// `glPixelTransfer`; switches come as 0 or another value.
    pub fn pixel_transfer(&mut self, pname: u32, value: f32) {
        compile!(self, Command::PixelTransfer(pname, value));
        outside_begin!(self);
        let transfer = &mut self.state.pixel.transfer;
        match pname {
            gl::MAP_COLOR => transfer.map_color = value != 0.0,
            gl::MAP_STENCIL => transfer.map_stencil = value != 0.0,
            gl::INDEX_SHIFT => transfer.index_shift = value as i32,
            gl::INDEX_OFFSET => transfer.index_offset = value as i32,
            _ => match transfer.factor(pname) {
                Some(factor) => *factor = value,
                None => self.error.set(gl::INVALID_ENUM),
            },
        }
    }

    /// `glPixelMapfv`: `size` values of a table, colours from 0 to 1. `GL_INVALID_VALUE` for a size that is not from 1 to
    /// `GL_MAX_PIXEL_MAP_TABLE`, or no power of two where indices choose.
    pub fn pixel_map(&mut self, map: u32, size: i32, values: &[f32]) {
        compile!(self, Command::PixelMap(map, size, values.into()));
        outside_begin!(self);
        let Some(place) = PixelMaps::place(map) else { return self.error.set(gl::INVALID_ENUM) };
        let fits = PixelMaps::is_size(place, size) && values.len() >= size as usize;
        demand!(self, fits, gl::INVALID_VALUE);
        let of = |value: &f32| if PixelMaps::gives_indices(place) { *value } else { unit(*value) };
        let table = values[..size as usize].iter().map(of).collect();
        Arc::make_mut(&mut self.pixel_maps).0[place] = table;
    }

    /// `glPixelMapuiv`: colours from 0 to 2^32 - 1.
    pub fn pixel_map_uints(&mut self, map: u32, size: i32, values: &[u32]) {
        let is_color = PixelMaps::place(map).is_some_and(|place| !PixelMaps::gives_indices(place));
        let of = |value: &u32| if is_color { convert::uint(*value) } else { *value as f32 };
        self.pixel_map(map, size, &values.iter().map(of).collect::<Vec<_>>());
    }

    /// `glPixelMapusv`: colours from 0 to 65535.
    pub fn pixel_map_ushorts(&mut self, map: u32, size: i32, values: &[u16]) {
        let is_color = PixelMaps::place(map).is_some_and(|place| !PixelMaps::gives_indices(place));
        let of = |value: &u16| if is_color { convert::ushort(*value) } else { f32::from(*value) };
        self.pixel_map(map, size, &values.iter().map(of).collect::<Vec<_>>());
    }

    /// `glGetPixelMapfv`.
    pub fn get_pixel_map(&mut self, map: u32) -> Option<Vec<f32>> {
        outside_begin!(self, None);
        let Some(place) = PixelMaps::place(map) else {
            self.error.set(gl::INVALID_ENUM);
            return None;
        };
        Some(self.pixel_maps.0[place].clone())
    }

    /// `glGetPixelMapuiv` with `most` 2^32 - 1, `glGetPixelMapusv` with 65535: what colours of 1 become.
    pub fn get_pixel_map_integers(&mut self, map: u32, most: u32) -> Option<Vec<u32>> {
        let values = self.get_pixel_map(map)?;
        let scale = match PixelMaps::place(map) {
            Some(place) if !PixelMaps::gives_indices(place) => f64::from(most),
            _ => 1.0,
        };
        let of = |value: f32| ((f64::from(value) * scale + 0.5) as u32).min(most);
        Some(values.into_iter().map(of).collect())
    }
}
