//! The short way out: a scene becomes a picture.

use crate::default_view;
use luxel_render::{
    Execution, Picture, PictureError, PictureFormat, RenderError, Renderer, write_rgba8,
};
use luxel_scene::{Scene, Size};
use std::io::Write;
use std::sync::Arc;

/// Draws a scene as [`default_view`] sees it: rows of red, green, blue and alpha from the top.
///
/// ```
/// use luxel::scene::{Size, demos};
///
/// let teapot = demos::demo("teapot").unwrap();
/// let picture = luxel::draw(teapot, Size { width: 64, height: 36 })?;
/// assert_eq!(picture.pixels.len(), 64 * 36);
/// assert_eq!(picture.pixels[0], [0; 4], "nothing is in the corner");
/// assert_eq!(picture.pixels[18 * 64 + 32][3], 255, "the teapot is in the middle");
/// # Ok::<(), luxel::render::RenderError>(())
/// ```
///
/// # Errors
/// [`RenderError`] if the size is impossible or the scene too large to be numbered.
pub fn draw(scene: impl Into<Arc<Scene>>, size: Size) -> Result<Picture<[u8; 4]>, RenderError> {
    let scene = scene.into();
    let view = default_view(&scene, size);
    Renderer::new(scene, &Execution::default())?.rgba8(&view)
}

/// Writes a picture of [`draw`] as PNG.
///
/// # Errors
/// [`PictureError`] if writing fails.
pub fn write_png(picture: &Picture<[u8; 4]>, out: &mut dyn Write) -> Result<(), PictureError> {
    write_rgba8(PictureFormat::Png, picture.size, &picture.pixels, picture.encoding, out)
}
