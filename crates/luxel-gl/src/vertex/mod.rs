//! Vertices: the stream between `glBegin` and `glEnd`, and what becomes of them.

pub(crate) mod process;
pub(crate) mod stream;

pub(crate) use stream::Stream;
