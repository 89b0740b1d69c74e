//! EGL 1.5 as a vendor library of libglvnd: displays without a screen, pbuffers, contexts of OpenGL 1.5.
//!
//! libEGL.so.1 loads this library by a JSON file and calls `__egl_Main` (libeglabi.h, version 0.2), which gives it the
//! functions below; programs call libEGL's. A context's default framebuffer is that of the pbuffer that it was made
//! current with; without one it has no pixels, and programs draw to framebuffer objects.
//!
//! A pbuffer's picture belongs to the context that draws it: a second context on the same pbuffer begins with its own.

mod config;
mod context;
mod error;
mod surface;
mod vendor;
