//! State of points, lines and polygons (OpenGL 1.5, sections 3.3 to 3.5).

use crate::enums as gl;

/// Points.
#[derive(Clone, Debug)]
pub(crate) struct Points {
    pub(crate) size: f32,
    pub(crate) least: f32,
    pub(crate) largest: f32,
    pub(crate) fade: f32,
    pub(crate) attenuation: [f32; 3],
}

/// Lines.
#[derive(Clone, Debug)]
pub(crate) struct Lines {
    pub(crate) width: f32,
    pub(crate) factor: i32,
    pub(crate) pattern: u16,
}

/// Polygons.
#[derive(Clone, Debug)]
pub(crate) struct Polygons {
    /// How front and back are drawn.
    pub(crate) modes: [u32; 2],
    pub(crate) cull: u32,
    pub(crate) front: u32,
    pub(crate) offset_factor: f32,
    pub(crate) offset_units: f32,
    /// 32 rows of 32 bits, the first pixel's highest.
    pub(crate) stipple: [u32; 32],
}

impl Default for Points {
    fn default() -> Self {
        Self {
            size: 1.0,
            least: 0.0,
            largest: crate::limits::LARGEST_SIZE,
            fade: 1.0,
            attenuation: [1.0, 0.0, 0.0],
        }
    }
}

impl Default for Lines {
    fn default() -> Self {
        Self { width: 1.0, factor: 1, pattern: 0xffff }
    }
}

impl Default for Polygons {
    fn default() -> Self {
        Self {
            modes: [gl::FILL; 2],
            cull: gl::BACK,
            front: gl::CCW,
            offset_factor: 0.0,
            offset_units: 0.0,
            stipple: [u32::MAX; 32],
        }
    }
}
