//! Materials, one a side (OpenGL 1.5, section 2.13.2).

use crate::enums as gl;

/// How one side reflects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SurfaceMaterial {
    pub(crate) ambient: [f32; 4],
    pub(crate) diffuse: [f32; 4],
    pub(crate) specular: [f32; 4],
    pub(crate) emission: [f32; 4],
    pub(crate) shininess: f32,
    pub(crate) indexes: [f32; 3],
}

impl Default for SurfaceMaterial {
    fn default() -> Self {
        Self {
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            emission: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            indexes: [0.0, 1.0, 1.0],
        }
    }
}

/// A property that the current colour drives (`glColorMaterial`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ColorMaterial {
    pub(crate) face: u32,
    pub(crate) mode: u32,
}

impl Default for ColorMaterial {
    fn default() -> Self {
        Self { face: gl::FRONT_AND_BACK, mode: gl::AMBIENT_AND_DIFFUSE }
    }
}

impl ColorMaterial {
    /// Whether the colour drives a side: 0 is the front, 1 the back.
    pub(crate) fn drives(self, side: usize) -> bool {
        match self.face {
            gl::FRONT => side == 0,
            gl::BACK => side == 1,
            _ => true,
        }
    }

    /// Puts a colour where it belongs.
    pub(crate) fn apply(self, color: [f32; 4], sides: &mut [SurfaceMaterial; 2]) {
        for side in 0..2 {
            if self.drives(side) {
                sides[side].set(self.mode, &color);
            }
        }
    }
}

impl SurfaceMaterial {
    /// Sets a property of as many values as [`material`](crate::lengths::material) says.
    pub(crate) fn set(&mut self, pname: u32, values: &[f32]) {
        let color = || values.first_chunk().copied().unwrap_or_default();
        match pname {
            gl::AMBIENT => self.ambient = color(),
            gl::DIFFUSE => self.diffuse = color(),
            gl::AMBIENT_AND_DIFFUSE => (self.ambient, self.diffuse) = (color(), color()),
            gl::SPECULAR => self.specular = color(),
            gl::EMISSION => self.emission = color(),
            gl::SHININESS => self.shininess = values.first().copied().unwrap_or_default(),
            gl::COLOR_INDEXES => self.indexes = values.first_chunk().copied().unwrap_or_default(),
            _ => {}
        }
    }
}
