// Written by ../../generator from gl.xml and commands.toml: change these.

//! The entry points of OpenGL, one file for each subject, and their addresses by name.

#![allow(non_snake_case, reason = "the names are OpenGL's")]
#![allow(clippy::too_many_arguments, reason = "the parameters are OpenGL's")]
#![allow(clippy::semicolon_if_nothing_returned, reason = "expressions stand as in commands.toml")]

mod arrays;
mod colors;
mod evaluators;
mod fragment;
mod framebuffers;
mod lighting;
mod lists;
mod modes;
mod pixels;
mod primitives;
mod queries;
mod raster_positions;
mod state;
pub(crate) mod table;
mod texture_coordinates;
mod texture_images;
mod textures;
mod transform;
mod unsupported;
mod vertex;
