//! Generated texture coordinates (OpenGL 1.5, section 2.10.4).

use crate::enums as gl;

/// How one coordinate is generated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Generator {
    pub(crate) mode: u32,
    pub(crate) object_plane: [f32; 4],
    /// In eye coordinates.
    pub(crate) eye_plane: [f32; 4],
}

/// Of s, t, r and q.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Generation(pub(crate) [Generator; 4]);

impl Default for Generation {
    fn default() -> Self {
        let generator =
            |plane| Generator { mode: gl::EYE_LINEAR, object_plane: plane, eye_plane: plane };
        Self([
            generator([1.0, 0.0, 0.0, 0.0]),
            generator([0.0, 1.0, 0.0, 0.0]),
            generator([0.0; 4]),
            generator([0.0; 4]),
        ])
    }
}
