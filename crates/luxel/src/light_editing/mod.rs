//! Lights under a hand: their poses in world space, and handles that move them in a picture. The window and the pages
//! show them each in their own way.

mod handles;
mod spaces;

pub use handles::{DirectionSphere, HandleKind, HandleView, LightHandle, LightPose};
pub use spaces::LightSpaces;
