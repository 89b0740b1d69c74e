//! The teapot on the coloured ground: the default scene of the viewer.

use super::builder::SceneBuilder;
use super::{plane, teapot};
use crate::{DMat4, DVec3, Scene};

pub(super) fn scene() -> Scene {
    let mut builder = SceneBuilder::default();
    let root = builder.group("welcome", None, DMat4::IDENTITY);
    plane::ground(&mut builder, root);
    let glaze = builder.material("glaze", teapot::glaze());
    let pot = builder.group("teapot", Some(root), plane::standing([-0.2, 0.0, 0.0], -28.0));
    teapot::add(&mut builder, pot, glaze);
    plane::daylight(&mut builder);
    builder.camera(root, DVec3::new(3.4, 4.6, 9.2), DVec3::new(0.0, 1.2, 0.0), 36.0);
    builder.scene
}
