//! Images in the caller's memory, scaled and as mipmaps (GLU 1.3, chapter 3).

mod mipmap;
mod pixels;
mod scale;

pub use mipmap::{Level, mipmap_count, mipmaps, nearest_power};
pub use pixels::{Image, ImageError, Layout, PixelFormat};
