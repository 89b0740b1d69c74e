//! How pixels change on their way: scales, biases, maps (OpenGL 1.5, section 3.6.5; tables 6.22 and 6.23).

use crate::enums as gl;
use crate::limits::PIXEL_MAP;
use std::sync::Arc;

/// `glPixelTransfer`
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PixelTransfer {
    pub(crate) map_color: bool,
    pub(crate) map_stencil: bool,
    pub(crate) index_shift: i32,
    pub(crate) index_offset: i32,
    /// Of red, green, blue, alpha, depth.
    pub(crate) scales: [f32; 5],
    pub(crate) biases: [f32; 5],
}

impl Default for PixelTransfer {
    fn default() -> Self {
        Self {
            map_color: false,
            map_stencil: false,
            index_shift: 0,
            index_offset: 0,
            scales: [1.0; 5],
            biases: [0.0; 5],
        }
    }
}

impl PixelTransfer {
    /// The scale or bias of that name.
    pub(crate) fn factor(&mut self, name: u32) -> Option<&mut f32> {
        Some(match name {
            gl::RED_SCALE => &mut self.scales[0],
            gl::GREEN_SCALE => &mut self.scales[1],
            gl::BLUE_SCALE => &mut self.scales[2],
            gl::ALPHA_SCALE => &mut self.scales[3],
            gl::DEPTH_SCALE => &mut self.scales[4],
            gl::RED_BIAS => &mut self.biases[0],
            gl::GREEN_BIAS => &mut self.biases[1],
            gl::BLUE_BIAS => &mut self.biases[2],
            gl::ALPHA_BIAS => &mut self.biases[3],
            gl::DEPTH_BIAS => &mut self.biases[4],
            _ => return None,
        })
    }
}

/// Ten tables by their names from `GL_PIXEL_MAP_I_TO_I` on.
#[derive(Clone, Debug)]
pub(crate) struct PixelMaps(pub(crate) [Vec<f32>; 10]);

impl Default for PixelMaps {
    fn default() -> Self {
        Self(std::array::from_fn(|_| vec![0.0]))
    }
}

/// The place of the first table that takes colours to colours.
const OF_COLORS: usize = 6;
/// The place of the first table that takes indices to colours.
const OF_INDICES: usize = 2;
/// The place of `GL_PIXEL_MAP_S_TO_S`.
const OF_STENCIL: usize = 1;

impl PixelMaps {
    /// The place of a table by its name.
    pub(crate) fn place(name: u32) -> Option<usize> {
        (gl::PIXEL_MAP_I_TO_I..=gl::PIXEL_MAP_A_TO_A)
            .contains(&name)
            .then(|| (name - gl::PIXEL_MAP_I_TO_I) as usize)
    }

    /// Whether a table's values are indices, not colours.
    pub(crate) fn gives_indices(place: usize) -> bool {
        place <= OF_STENCIL
    }

    /// Whether a table can have so many values: a power of two if indices choose among them.
    pub(crate) fn is_size(place: usize, size: i32) -> bool {
        let within = (1..=PIXEL_MAP).contains(&size);
        within && (place >= OF_COLORS || size.count_ones() == 1)
    }
}

/// What pixels go through.
#[derive(Clone, Debug)]
pub(crate) struct Transfer {
    pub(crate) by: PixelTransfer,
    pub(crate) maps: Arc<PixelMaps>,
}

impl Transfer {
    /// Whether colours stay as they are.
    pub(crate) fn keeps_colors(&self) -> bool {
        let PixelTransfer { map_color, scales, biases, .. } = self.by;
        !map_color && scales[..4] == [1.0; 4] && biases[..4] == [0.0; 4]
    }

    /// Scale, bias, and the maps from 0 to 1.
    pub(crate) fn color(&self, color: [f32; 4]) -> [f32; 4] {
        if self.keeps_colors() {
            return color;
        }
        std::array::from_fn(|at| {
            let value = color[at] * self.by.scales[at] + self.by.biases[at];
            if !self.by.map_color {
                return value;
            }
            let map = &self.maps.0[OF_COLORS + at];
            let last = (map.len() - 1) as f32;
            let place = (value.clamp(0.0, 1.0) * last + 0.5) as usize;
            map.get(place).copied().unwrap_or(0.0)
        })
    }

    /// What a texel is made of: a colour; or a depth, then a stencil value as a part of 255.
    pub(crate) fn values(&self, values: [f32; 4], of_depth: bool) -> [f32; 4] {
        if !of_depth {
            return self.color(values);
        }
        let stencil = self.stencil((values[1] * 255.0).round() as i32) & 255;
        [self.depth(values[0]), stencil as f32 / 255.0, values[2], values[3]]
    }

    /// Scale and bias.
    pub(crate) fn depth(&self, depth: f32) -> f32 {
        let [.., scale] = self.by.scales;
        let [.., bias] = self.by.biases;
        depth * scale + bias
    }

    /// An index of a colour, shifted and with offset, and the colour that the maps have for it.
    pub(crate) fn indexed(&self, index: i32) -> [f32; 4] {
        let index = self.moved(index);
        std::array::from_fn(|at| {
            let map = &self.maps.0[OF_INDICES + at];
            map.get(index as u32 as usize & (map.len() - 1)).copied().unwrap_or(0.0)
        })
    }

    /// A stencil value, shifted and with offset, by its map.
    pub(crate) fn stencil(&self, value: i32) -> i32 {
        let value = self.moved(value);
        if !self.by.map_stencil {
            return value;
        }
        let map = &self.maps.0[OF_STENCIL];
        let place = value as u32 as usize & (map.len() - 1);
        map.get(place).map_or(0, |value| *value as i32)
    }

    /// An index, shifted to the left (to the right if negative), and with offset.
    fn moved(&self, value: i32) -> i32 {
        let shift = self.by.index_shift;
        let by = shift.unsigned_abs();
        let shifted = match shift {
            0.. => value.checked_shl(by).unwrap_or(0),
            _ => value.checked_shr(by).unwrap_or(0),
        };
        shifted.wrapping_add(self.by.index_offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_3_6_5_colours_are_scaled_biased_and_mapped() {
        let mut transfer = Transfer { by: PixelTransfer::default(), maps: Arc::default() };
        let color = [0.25, 0.5, 1.5, 1.0];
        assert_eq!(transfer.color(color), color);
        transfer.by.scales[0] = 2.0;
        transfer.by.biases[1] = -0.25;
        assert_eq!(transfer.color(color), [0.5, 0.25, 1.5, 1.0]);
        let mut maps = PixelMaps::default();
        maps.0[OF_COLORS] = vec![0.0, 0.125, 1.0];
        maps.0[OF_COLORS + 2] = vec![1.0, 0.75];
        transfer.maps = Arc::new(maps);
        transfer.by.map_color = true;
        assert_eq!(transfer.color(color), [0.125, 0.0, 0.75, 0.0]);
    }

    #[test]
    fn section_3_6_5_indices_become_the_colours_of_the_maps() {
        let mut transfer = Transfer { by: PixelTransfer::default(), maps: Arc::default() };
        assert_eq!(transfer.indexed(3), [0.0; 4]);
        let mut maps = PixelMaps::default();
        maps.0[OF_INDICES] = vec![0.0, 0.25, 0.5, 0.75];
        maps.0[OF_INDICES + 3] = vec![1.0, 0.5];
        transfer.maps = Arc::new(maps);
        assert_eq!(transfer.indexed(3), [0.75, 0.0, 0.0, 0.5]);
        transfer.by.index_offset = 2;
        assert_eq!(transfer.indexed(3), [0.25, 0.0, 0.0, 0.5]);
    }

    #[test]
    fn section_3_6_5_stencil_values_are_shifted_offset_and_mapped_within_the_table() {
        let mut transfer = Transfer { by: PixelTransfer::default(), maps: Arc::default() };
        transfer.by.index_offset = -3;
        let shifted = |transfer: &mut Transfer, shift| {
            transfer.by.index_shift = shift;
            transfer.stencil(12)
        };
        assert_eq!([2, -2, 40, -40].map(|by| shifted(&mut transfer, by)), [45, 0, -3, -3]);
        let mut maps = PixelMaps::default();
        maps.0[OF_STENCIL] = vec![7.0, 8.0, 9.0, 10.0];
        transfer.maps = Arc::new(maps);
        transfer.by.map_stencil = true;
        assert_eq!([0, 1, -40].map(|by| shifted(&mut transfer, by)), [8, 8, 8]);
    }
}
