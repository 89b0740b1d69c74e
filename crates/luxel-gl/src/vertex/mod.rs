//! Vertices: the stream between `glBegin` and `glEnd`, and what becomes of them.

mod column;
mod columns;
pub(crate) mod evaluator;
mod fetch;
mod light_setup;
mod light_vertices;
mod materials;
mod matrix_rows;
mod process;
mod processed;
mod source;
mod stream;
mod texgen;
mod used;
mod vertices;
mod view;
mod weld;

pub(crate) use fetch::{ArrayDraw, Fetched, Wanted, byte_range, decode, decode_indices};
pub use fetch::{ClientMemory, NoClientMemory};
pub(crate) use materials::Materials;
pub(crate) use process::{Needs, Pass, VertexProcessor};
pub(crate) use processed::{Lists, Processed, WindowScale, codes};
pub(crate) use source::VertexSource;
pub(crate) use stream::Stream;
pub(crate) use used::UsedVertices;
pub(crate) use vertices::Vertices;
pub(crate) use view::VertexView;
pub(crate) use weld::{Welded, welded};
