//! Window positions of objects, and back (GLU 1.3, chapters 4.1 and 4.2): by `luxel_pick`, in f64.

use glam::{DMat4, DVec2};
use luxel_pick::Viewport;

/// The two matrices and the viewport of OpenGL, as `glGetDoublev` and `glGetIntegerv` return them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// The modelview matrix, column-major.
    pub model: [f64; 16],
    /// The projection matrix, column-major.
    pub projection: [f64; 16],
    /// The viewport: lower left corner, width, height.
    pub viewport: [i32; 4],
}

impl Transform {
    /// Where an object is in the window, with its depth in 0 to 1 (`gluProject`); `None` in the plane of the eye.
    #[must_use]
    pub fn project(&self, object: [f64; 3]) -> Option<[f64; 3]> {
        let (model, projection) = self.matrices();
        luxel_pick::project(object.into(), &model, &projection, viewport(self.viewport))
            .map(|position| position.to_array())
    }

    /// The object at a position of the window (`gluUnProject`); `None` if the matrices have no inverse.
    #[must_use]
    pub fn unproject(&self, window: [f64; 3]) -> Option<[f64; 3]> {
        let (model, projection) = self.matrices();
        luxel_pick::unproject(window.into(), &model, &projection, viewport(self.viewport))
            .map(|position| position.to_array())
    }

    /// As [`unproject`](Self::unproject), with w and the depth range (`gluUnProject4`).
    #[must_use]
    pub fn unproject4(&self, window: [f64; 4], depth_range: [f64; 2]) -> Option<[f64; 4]> {
        let (model, projection) = self.matrices();
        luxel_pick::unproject4(
            window.into(),
            &model,
            &projection,
            viewport(self.viewport),
            depth_range,
        )
        .map(|position| position.to_array())
    }

    fn matrices(&self) -> (DMat4, DMat4) {
        (DMat4::from_cols_array(&self.model), DMat4::from_cols_array(&self.projection))
    }
}

/// The matrix that makes a rectangle of the window fill the clip volume (`gluPickMatrix`); `None` if a side of the
/// rectangle is not above 0.
#[must_use]
pub fn pick_matrix(center: [f64; 2], size: [f64; 2], window: [i32; 4]) -> Option<[f64; 16]> {
    luxel_pick::pick_matrix(DVec2::from(center), DVec2::from(size), viewport(window))
        .map(|matrix| matrix.to_cols_array())
}

fn viewport([x, y, width, height]: [i32; 4]) -> Viewport {
    Viewport { x: x.into(), y: y.into(), width: width.into(), height: height.into() }
}
