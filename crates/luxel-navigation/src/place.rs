//! The pose of the camera.

use crate::motion::Rigid;
use luxel_scene::DVec3;

/// A camera pose with its pivot and scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// From world to camera space.
    pub(crate) view: Rigid,
    /// The pivot of rotations, in world space.
    pub(crate) pivot: DVec3,
    /// The factor of the orthographic height.
    pub(crate) scale: f64,
}
