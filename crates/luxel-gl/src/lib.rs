//! OpenGL's fixed functions on the CPU, without unsafe code.
//!
//! A [`Context`] is one GL context; each command without pointers is a method of it, named as the command. Errors are
//! kept in the context as the specification says ([`Context::get_error`]); a command that is in error changes nothing
//! else, and no sequence of commands panics. The C library over it is `luxel-gl-abi`.
//!
//! One folder a stage; each imports only those above it:
//!
//! 1. `enums`, `limits`, `error`, [`convert`], `values`: constants, and the types of state.
//! 2. `plane`, `depth`: pixels in tiles, and how depths are kept; `texture`: images, texture objects; `state`: the groups of state; [`lengths`] of pointer arguments.
//! 3. `vertex`: the stream between `glBegin` and `glEnd`; transform and lighting, sixteen vertices at a time.
//! 4. `primitive`: assembles points, lines and polygons, and clips them.
//! 5. `fragment`: texture units: sampling and environments.
//! 6. `raster`: the log of draws, and the tiles that it is carried out in.
//! 7. `pixels`: formats and storage of pixels in the program's memory.
//! 8. `modes`: selection and feedback. `objects`: display lists.
//! 9. `context`, `commands`: one file a chapter of the specification.
//!
//! Lighting is [`luxel_lighting`]'s equation in eye coordinates; snapping, edge functions, fill rule and depth planes
//! are [`luxel_visibility`]'s; hit records and feedback buffers are [`luxel_pick`]'s. Window y is up, and row 0 of a
//! buffer is the bottom one, so that left and bottom edges belong to a triangle.
//!
//! Limits of this version: images of colour indices are missing; the default framebuffer has one sample a pixel, and
//! framebuffer objects have one colour.

#![forbid(unsafe_code)]

mod commands;
mod context;
pub mod convert;
mod depth;
mod enums;
mod error;
mod fragment;
pub mod lengths;
mod limits;
mod modes;
mod objects;
mod pixels;
mod plane;
mod primitive;
mod raster;
mod state;
mod texture;
mod values;
mod vertex;

pub use commands::{ColorLayout, MappedBuffer, RenderModeResult, Words};
pub use context::{Configuration, Context};
pub use luxel_math::{SimdLevel, UnavailableSimdLevel};
pub use values::Values;
pub use vertex::{ClientMemory, NoClientMemory};

/// The example of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
