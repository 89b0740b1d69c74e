//! The images of a page: the position of the pixel, and its neighbourhood.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use luxel_lighting::PictureEncoding;
use luxel_render::{PictureError, PictureFormat, RenderError, Renderer, View, write_rgba8};
use luxel_scene::{Lens, Size};

/// Pixels across the neighbourhood, odd, so that the pixel is in the middle.
const AROUND: u32 = 33;
/// Most pixels of the whole picture's longer side.
const WHOLE: u32 = 640;

/// The picture that holds an explained pixel, scaled down to 640 pixels, and the pixel's
/// neighbourhood, 33 pixels across; both as PNG.
#[derive(Clone, Debug)]
pub struct Pictures {
    /// Column and row of the pixel, in a picture of this size.
    pub(crate) pixel: ([u32; 2], Size),
    /// The size of the scaled picture, and its address.
    pub(crate) whole: (Size, String),
    /// The size of the neighbourhood, and its address.
    pub(crate) around: (Size, String),
    /// The neighbourhood's upper left pixel.
    pub(crate) corner: [u32; 2],
}

/// Why there are no pictures.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PicturesError {
    /// The view can't be drawn.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// The picture can't be encoded.
    #[error(transparent)]
    Encode(#[from] PictureError),
}

impl Pictures {
    /// Draws both pictures. `pixel` is column and row of
    /// [`Explanation::pixel`](luxel_render::Explanation::pixel).
    ///
    /// # Errors
    /// [`PicturesError`] if the view can't be drawn.
    pub fn draw(renderer: &Renderer, view: &View, pixel: [u32; 2]) -> Result<Self, PicturesError> {
        let small = smaller(view);
        let whole = renderer.rgba8(&small)?;
        let (corner, around) = renderer.rgba8_around(view, pixel, around_of(view.size))?;
        Ok(Self {
            pixel: (pixel, view.size),
            whole: (small.size, png(small.size, &whole.pixels, view.encoding)?),
            around: (around.size, png(around.size, &around.pixels, view.encoding)?),
            corner,
        })
    }
}

/// A neighbourhood of about the picture's shape, of odd sides.
fn around_of(size: Size) -> Size {
    let height = f64::from(AROUND) * f64::from(size.height) / f64::from(size.width);
    Size { width: AROUND, height: (height.round() as u32).clamp(11, AROUND) | 1 }
}

/// The same view in a small picture.
fn smaller(view: &View) -> View {
    let Size { width, height } = view.size;
    let longer = width.max(height);
    let mut small = view.clone();
    if longer <= WHOLE {
        return small;
    }
    let by = f64::from(WHOLE) / f64::from(longer);
    let scaled = |side: u32| ((f64::from(side) * by).round() as u32).max(1);
    small.size = Size { width: scaled(width), height: scaled(height) };
    if let Lens::Intrinsics { fx, fy, cx, cy } = &mut small.camera.projection.lens {
        for pixels in [fx, fy, cx, cy] {
            *pixels *= by;
        }
    }
    small
}

/// A picture as the address of an image.
fn png(size: Size, pixels: &[[u8; 4]], encoding: PictureEncoding) -> Result<String, PictureError> {
    let mut bytes = Vec::new();
    write_rgba8(PictureFormat::Png, size, pixels, encoding, &mut bytes)?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(&bytes)))
}
