//! Lights in their places.

use crate::NodeId;
use glam::DVec3;
use luxel_lighting::Light;

/// The coordinates in which a light is placed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Placement {
    /// World space: the light stays with the scene.
    #[default]
    World,
    /// Camera space: the light moves with the eye.
    Camera,
    /// A node's space: the light moves with the node.
    Node(NodeId),
}

/// A light in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneLight {
    /// Its name.
    pub name: String,
    /// What it is.
    pub light: Light,
    /// The coordinates of `position` and `direction`.
    pub placement: Placement,
    /// Where it stands (point and spot lights).
    pub position: DVec3,
    /// The direction in which its light travels, of any length but 0 (directional and spot lights).
    pub direction: DVec3,
}
