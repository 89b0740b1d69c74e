//! `libOSMesa.so.8`: OpenGL 1.5 and OSMesa over `luxel_gl`, as a C library.
//!
//! Nothing here draws: an entry point takes the current context from a thread-local cell, turns pointers into slices
//! whose lengths [`luxel_gl`] has computed, and calls. `generated` has the 1292 `gl*` functions, written by a tool of
//! its own; `osmesa` the 13 of OSMesa.

mod client;
mod current;
mod egl;
mod entry;
mod generated;
mod mapped;
mod memory;
#[allow(non_snake_case, reason = "the names are OSMesa's")]
mod osmesa;
mod parameters;
mod pointer_query;
mod prelude;
mod returned;
mod slot;
mod strings;
mod window;
