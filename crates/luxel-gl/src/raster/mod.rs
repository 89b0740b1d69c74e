//! From primitives to pixels: the log of draws, and the tiles that it is carried out in.
//!
//! 1. `pipeline`: all state of fragments; `batch`: the primitives of one draw.
//! 2. `build`: culls and clips primitives, and sets them up for rasterization, by `draw_state`, to where `placement` has
//!    them in the window.
//! 3. `log`: batches and clears in the order of their calls, sorted into tiles when somebody looks.
//! 4. `tile`: takes one tile's list in order, `piece_sink` the samples of one piece (`strokes`: of lines and points, `image`: of images). Where colours take no notice of what is there, samples are tested at once
//!    and note which primitive they see; those that are seen at last are lit (`lighter`, `shade`). Where they do, blocks are lit
//!    as they come.
//! 5. `stencil`, `blend`: tests of fragments and mixing of colours.

mod batch;
mod bitmap;
mod blend;
mod blit;
mod build;
mod draw_state;
mod framebuffer;
mod image;
mod lighter;
mod log;
mod piece_sink;
mod pipeline;
mod placement;
mod samples;
mod shade;
mod shaded;
mod spare;
mod stencil;
mod strokes;
mod tile;

pub(crate) use batch::{Batch, Piece};
pub(crate) use bitmap::Bitmap;
pub(crate) use build::{PIECES_RUN, PieceBuilder};
pub(crate) use draw_state::DrawState;
pub(crate) use framebuffer::Framebuffer;
pub(crate) use image::{ImagePixels, PlacedImage};
pub(crate) use log::{Clear, Log};
pub(crate) use pipeline::{Buffers, Pipeline};
pub(crate) use placement::polygon_area;
pub(crate) use samples::SAMPLES;
