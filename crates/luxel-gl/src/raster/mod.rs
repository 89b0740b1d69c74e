//! From primitives to pixels: the log of draws, and the tiles that it is carried out in.
//!
//! 1. `pipeline`: all state of fragments; `batch`: what the primitives of one draw have in common; `pieces`: the parts of
//!    these, with their `shape`.
//! 2. `build`: culls and clips primitives, and makes pieces of them (`triangle_group`: of sixteen triangles at a time;
//!    `border`: of lines and points, `smooth_fill`: of smooth polygons), by `draw_state`, where `placement` has them in the
//!    window.
//! 3. `draw`: all state of a draw, with which its pieces are made, at once or later; `log`: pieces, clears and deferred
//!    draws in the order of their calls, sorted into tiles when somebody looks; `spare` keeps their memory.
//! 4. `tile`: takes one tile's list in order, `tile_samples` its pieces, `whole_tile` those that it decides about as a
//!    whole, `piece_sink` the samples of one (`strokes`: of lines and points, `smooth`: of those that end within pixels,
//!    `outline`: of smooth polygons; `image`: of images; `samples`: where these lie). Where colours take no notice of what
//!    is there, samples are tested at once and note which piece they see, where depth alone decides sixteen small triangles
//!    at a time (`small_pieces`); those that are seen at last are lit (`lighter`, `shade`). Where they do, blocks are lit
//!    as they come, once for all samples (`shaded`), those that are covered in part together (`pending`).
//! 5. `stencil`, `blend`: tests of fragments and mixing of colours.
//! 6. `framebuffer`: the planes that are drawn to; `blit`: copies between them.

mod batch;
mod bitmap;
mod blend;
mod blit;
mod border;
mod build;
mod draw;
mod draw_state;
mod framebuffer;
mod image;
mod lighter;
mod log;
mod outline;
mod pending;
mod piece_sink;
mod pieces;
mod pipeline;
mod placement;
mod samples;
mod shade;
mod shaded;
mod shape;
mod small_pieces;
mod smooth;
mod smooth_fill;
mod spare;
mod stencil;
mod strokes;
mod tile;
mod tile_samples;
mod triangle_group;
mod whole_tile;

pub(crate) use batch::Batch;
pub(crate) use bitmap::Bitmap;
pub(crate) use build::PIECES_RUN;
pub(crate) use draw::{DeferredDraw, DrawSetup};
pub(crate) use draw_state::DrawState;
pub(crate) use framebuffer::Framebuffer;
pub(crate) use image::{ImagePixels, PlacedImage};
pub(crate) use log::{Clear, Log};
pub(crate) use pieces::Pieces;
pub(crate) use pipeline::{Buffers, Pipeline};
pub(crate) use placement::polygon_area;
pub(crate) use samples::SAMPLES;
