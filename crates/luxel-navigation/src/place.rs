//! The place of the camera.

use crate::motion::Rigid;
use luxel_scene::DVec3;

/// The camera with what belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    /// From world to camera space.
    pub(crate) view: Rigid,
    /// What the camera turns about, in world space.
    pub(crate) pivot: DVec3,
    /// What the height of parallel rays is multiplied by.
    pub(crate) scale: f64,
}
