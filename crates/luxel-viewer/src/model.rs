//! What is looked at.

use luxel::render::View;
use luxel::scene::{DVec3, Scene};
use std::sync::Arc;

/// A model, ready to be drawn, with how it is looked at first.
#[derive(Clone)]
pub struct Model {
    /// What there is.
    pub scene: Arc<Scene>,
    /// The first view: camera, light, samples. Its size and background are the window's.
    pub view: View,
    /// What is up, in world space.
    pub up: DVec3,
    /// What the camera turns about, in world space.
    pub pivot: DVec3,
    /// The clipping planes, near and far, that the user has fixed; those that fit otherwise.
    pub planes: [Option<f64>; 2],
}
