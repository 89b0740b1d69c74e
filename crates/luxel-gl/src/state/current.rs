//! Current values: what the next vertex is made of (OpenGL 1.5, section 2.7, table 6.5).

use crate::limits::TEXTURE_UNITS;

/// Attributes of the next vertex.
#[derive(Clone, Debug)]
pub(crate) struct Current {
    pub(crate) color: [f32; 4],
    pub(crate) secondary: [f32; 3],
    pub(crate) normal: [f32; 3],
    pub(crate) tex_coords: [[f32; 4]; TEXTURE_UNITS],
    pub(crate) fog_coord: f32,
    pub(crate) edge_flag: bool,
    pub(crate) index: f32,
    pub(crate) raster: RasterPosition,
}

/// The current raster position (section 2.12).
#[derive(Clone, Debug)]
pub(crate) struct RasterPosition {
    /// x, y, z in the window, and the fourth clip coordinate.
    pub(crate) window: [f32; 4],
    pub(crate) valid: bool,
    /// The distance from the eye, or the fog coordinate.
    pub(crate) distance: f32,
    pub(crate) color: [f32; 4],
    pub(crate) secondary: [f32; 4],
    pub(crate) tex_coords: [[f32; 4]; TEXTURE_UNITS],
    pub(crate) index: f32,
}

impl Default for Current {
    fn default() -> Self {
        let tex_coords = [[0.0, 0.0, 0.0, 1.0]; TEXTURE_UNITS];
        Self {
            color: [1.0; 4],
            secondary: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
            tex_coords,
            fog_coord: 0.0,
            edge_flag: true,
            index: 1.0,
            raster: RasterPosition {
                window: [0.0, 0.0, 0.0, 1.0],
                valid: true,
                distance: 0.0,
                color: [1.0; 4],
                secondary: [0.0, 0.0, 0.0, 1.0],
                tex_coords,
                index: 1.0,
            },
        }
    }
}
