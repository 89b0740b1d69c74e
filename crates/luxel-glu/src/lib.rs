//! GLU 1.3 in safe Rust: matrices, projection, quadrics, images and mipmaps, tessellation of polygons.
//!
//! Nothing here calls OpenGL: shapes go to a [`Drawing`], polygons to a [`Listener`], images to memory. `luxel-glu-abi`
//! makes the C library of it.
//!
//! | function of GLU | here |
//! | --- | --- |
//! | `gluPerspective`, `gluLookAt` | [`perspective`], [`look_at`] |
//! | `gluProject`, `gluUnProject`, `gluUnProject4`, `gluPickMatrix` | [`Transform`], [`pick_matrix`] |
//! | `gluSphere`, `gluCylinder`, `gluDisk`, `gluPartialDisk` | [`Quadric`] |
//! | `gluScaleImage`, `gluBuild2DMipmaps` | [`Image`], [`mipmaps`] |
//! | `gluTess...` | [`Tessellator`] |
//! | `gluErrorString`, `gluGetString`, `gluCheckExtension` | [`error_string`], [`VERSION`], [`has_extension`] |

#![forbid(unsafe_code)]
#![deny(missing_docs)]

mod drawing;
mod image;
mod matrices;
mod project;
mod quadric;
mod strings;
mod tessellate;

pub use drawing::Drawing;
pub use image::{
    Image, ImageError, Layout, Level, PixelFormat, mipmap_count, mipmaps, nearest_power,
};
pub use matrices::{look_at, perspective};
pub use project::{Transform, pick_matrix};
pub use quadric::{DrawStyle, InvalidValue, MOST_STEPS, Normals, Orientation, Quadric};
pub use strings::{EXTENSIONS, VERSION, error_string, has_extension};
pub use tessellate::{Listener, Tessellator, WindingRule};
