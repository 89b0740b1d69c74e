//! The commands, one file a chapter: argument checks, errors, and what they change.
//!
//! Each begins by compiling itself into the open list, if it is one of those that lists hold; then come errors, in the
//! order of the specification.

mod accumulation;
mod arrays;
mod attachments;
mod attribute_stacks;
mod begin_end;
mod bitmaps;
mod buffer_objects;
mod buffers;
mod draw;
mod draw_pixels;
mod evaluators;
mod fragments;
mod frame_pixels;
mod framebuffer_queries;
mod framebuffers;
mod gets;
mod gets_table;
mod lighting;
mod lists;
mod modes;
mod pixel_transfer;
mod pixels;
mod queries;
mod rasterization;
mod renderbuffers;
mod strings;
mod switches;
mod texture_copies;
mod texture_environment;
mod texture_images;
mod texture_parameters;
mod texture_queries;
mod textures;
mod transforms;

pub use buffer_objects::MappedBuffer;
pub use modes::{RenderModeResult, Words};
pub use pixels::ColorLayout;
