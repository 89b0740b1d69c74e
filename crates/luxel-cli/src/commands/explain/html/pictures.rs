//! The pictures of the page: where the pixel lies, and what is around it.

use super::{Page, escaped};
use crate::commands::explain::Told;
use crate::failure::Failure;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use luxel::lighting::PictureEncoding;
use luxel::render::{PictureFormat, Renderer, View, write_rgba8};
use luxel::scene::{Lens, Size};

/// Pixels across the neighbourhood, odd, so that the pixel is in the middle.
const AROUND: u32 = 33;
/// Most pixels of the whole picture's longer side.
const WHOLE: u32 = 640;

impl Page {
    /// The whole picture, small, and the pixel's neighbourhood, large.
    pub(super) fn pictures(
        &mut self,
        told: &Told<'_>,
        renderer: &Renderer<'_>,
    ) -> Result<(), Failure> {
        let failure = |error: String| Failure::work(error, "");
        let pixel = told.explanation.pixel;
        let size = told.view.size;
        let small = smaller(told.view);
        let whole = renderer.rgba8(&small).map_err(|error| failure(error.to_string()))?;
        let (corner, around) = renderer
            .rgba8_around(told.view, pixel, around_of(size))
            .map_err(|error| failure(error.to_string()))?;
        let encoding = told.view.encoding;
        let [whole, around_png] =
            [(small.size, &whole.pixels), (around.size, &around.pixels)].map(|(size, pixels)| {
                png(size, pixels, encoding).map_err(|error| failure(error.to_string()))
            });
        let [x, y] = pixel;
        let percent = |at: u32, side: u32| (f64::from(at) + 0.5) / f64::from(side) * 100.0;
        let Size { width, height } = small.size;
        self.push(format_args!(
            "<div class=\"pictures\">\n<figure><div class=\"stage\"><img src=\"{}\" width=\"{width}\" \
             height=\"{height}\" alt=\"The picture of {}, with the pixel marked\"><b class=\"mark\" \
             style=\"left:{:.3}%;top:{:.3}%\"></b></div><figcaption>The picture, {} by {} pixels; the \
             ring is the pixel.</figcaption></figure>\n",
            whole?,
            escaped(&told.model),
            percent(x, size.width),
            percent(y, size.height),
            size.width,
            size.height
        ));
        let Size { width, height } = around.size;
        let [left, top] = [x - corner[0], y - corner[1]];
        self.push(format_args!(
            "<figure><div class=\"stage\"><img class=\"pixels\" src=\"{}\" width=\"{width}\" \
             height=\"{height}\" alt=\"The pixels around it\"><b class=\"cell\" \
             style=\"left:{:.4}%;top:{:.4}%;width:{:.4}%;height:{:.4}%\"></b></div><figcaption>Its \
             neighbourhood, {width} by {height} pixels from ({}, {}).</figcaption></figure>\n</div>\n",
            around_png?,
            f64::from(left) / f64::from(width) * 100.0,
            f64::from(top) / f64::from(height) * 100.0,
            100.0 / f64::from(width),
            100.0 / f64::from(height),
            corner[0],
            corner[1]
        ));
        Ok(())
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
fn png(
    size: Size,
    pixels: &[[u8; 4]],
    encoding: PictureEncoding,
) -> Result<String, luxel::render::PictureError> {
    let mut bytes = Vec::new();
    write_rgba8(PictureFormat::Png, size, pixels, encoding, &mut bytes)?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(&bytes)))
}
