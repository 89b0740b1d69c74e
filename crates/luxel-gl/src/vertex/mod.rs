//! Vertices: the stream between `glBegin` and `glEnd`, and what becomes of them.

pub(crate) mod evaluator;
mod fetch;
mod light_setup;
mod matrix_rows;
mod process;
mod processed;
mod stream;
mod texgen;

pub(crate) use fetch::{ArrayDraw, Fetched, Vertices, byte_range, decode, decode_indices};
pub use fetch::{ClientMemory, NoClientMemory};
pub(crate) use process::VertexProcessor;
pub(crate) use processed::{Processed, WindowScale, codes};
pub(crate) use stream::Stream;
