//! `libGLU.so.1`: the 59 functions of GLU 1.3 over `luxel_glu`, as a C library.
//!
//! Functions of OpenGL are undefined symbols here: they are those of the library that the process has loaded.

#![allow(non_snake_case, reason = "the names are GLU's")]

mod gl;
mod images;
mod matrices;
mod nurbs;
mod object;
mod quadrics;
mod strings;
mod tess;
