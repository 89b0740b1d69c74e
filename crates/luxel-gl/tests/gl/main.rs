//! The specification (OpenGL 1.5), chapter by chapter, through the commands alone.

#![allow(clippy::unwrap_used, reason = "a panic fails the test")]

mod accumulation;
mod any;
mod arrays;
mod attached_images;
mod canvas;
mod clip_control;
mod color_formats;
mod coverage;
mod deferred;
mod depth;
mod display_lists;
mod errors;
mod fragments;
mod framebuffers;
mod images;
mod lighting;
mod mixing;
mod modes;
mod pixel_transfer;
mod queries;
mod samples;
mod smooth;
mod state;
mod textures;
mod unlit;
mod waiting;
