//! What a lit surface point sends to the eye.
//!
//! The lighting equation stands here once, generic over the number (one pixel, or sixteen) and over
//! a witness that hears every term as it is computed.

#![forbid(unsafe_code)]

mod light;
mod material;

pub use light::{Attenuation, Cone, Light, LightKind};
pub use material::{Material, Reflection};
