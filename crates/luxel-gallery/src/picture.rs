//! Pictures of the page: opaque, 8 bits, as small a file as they can be.

use crate::GalleryError;
use luxel::scene::Size;
use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder, Filter};
use std::collections::BTreeMap;

/// An opaque picture: rows of red, green and blue from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Picture {
    pub(crate) size: Size,
    pub(crate) pixels: Vec<[u8; 3]>,
}

/// Pixels of a picture for each pixel of the page, along a side: what screens of high density show.
pub(crate) const DENSITY: u32 = 2;

/// Duration of each frame of an animation: 1/16 s.
const PICTURES_A_SECOND: u16 = 16;

impl Picture {
    /// A picture of one colour.
    pub(crate) fn plain(size: Size, color: [u8; 3]) -> Self {
        let count = size.width as usize * size.height as usize;
        Self { size, pixels: vec![color; count] }
    }

    /// The size on the page.
    pub(crate) fn shown(&self) -> Size {
        let Size { width, height } = self.size;
        Size { width: width / DENSITY, height: height / DENSITY }
    }

    /// The pixel in a column and a row.
    pub(crate) fn at(&self, x: u32, y: u32) -> [u8; 3] {
        self.pixels[(y * self.size.width + x) as usize]
    }

    /// Copies a smaller image into this one.
    pub(crate) fn put(&mut self, other: &Self, left: u32, top: u32) {
        for y in 0..other.size.height {
            for x in 0..other.size.width {
                let at = ((top + y) * self.size.width + left + x) as usize;
                self.pixels[at] = other.at(x, y);
            }
        }
    }

    /// The picture as a PNG.
    pub(crate) fn png(&self) -> Result<Vec<u8>, GalleryError> {
        animation(std::slice::from_ref(self))
    }
}

/// Pictures of one size as an animated PNG that goes on for ever; one picture as a still one.
///
/// Of the ways to write the same pixels, the smallest is taken: with a palette where 256 colours
/// suffice, and by the filter that helps most.
pub(crate) fn animation(pictures: &[Picture]) -> Result<Vec<u8>, GalleryError> {
    let palette = palette(pictures);
    let mut smallest: Option<Vec<u8>> = None;
    let filters: &[Filter] = match palette {
        Some(_) => &[Filter::NoFilter],
        None if pictures.len() > 1 => &[Filter::Sub],
        None => &[Filter::Sub, Filter::Up],
    };
    for &filter in filters {
        let bytes = encode(pictures, palette.as_ref(), filter)?;
        if smallest.as_ref().is_none_or(|smallest| bytes.len() < smallest.len()) {
            smallest = Some(bytes);
        }
    }
    Ok(smallest.unwrap_or_default())
}

/// The colours, if a palette can hold them, in order of their values.
fn palette(pictures: &[Picture]) -> Option<BTreeMap<[u8; 3], u8>> {
    let mut colors = BTreeMap::new();
    for color in pictures.iter().flat_map(|picture| &picture.pixels) {
        colors.insert(*color, 0);
        if colors.len() > 256 {
            return None;
        }
    }
    for (place, index) in colors.values_mut().zip(0..=255) {
        *place = index;
    }
    Some(colors)
}

fn encode(
    pictures: &[Picture],
    palette: Option<&BTreeMap<[u8; 3], u8>>,
    filter: Filter,
) -> Result<Vec<u8>, GalleryError> {
    let mut bytes = Vec::new();
    let Some(first) = pictures.first() else { return Ok(bytes) };
    let mut encoder = Encoder::new(&mut bytes, first.size.width, first.size.height);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(filter);
    encoder.set_source_srgb(png::SrgbRenderingIntent::RelativeColorimetric);
    if let Some(palette) = palette {
        encoder.set_color(ColorType::Indexed);
        encoder.set_palette(palette.keys().flatten().copied().collect::<Vec<_>>());
    } else {
        encoder.set_color(ColorType::Rgb);
    }
    if pictures.len() > 1 {
        encoder.set_animated(pictures.len() as u32, 0)?;
        encoder.set_frame_delay(1, PICTURES_A_SECOND)?;
        encoder.set_blend_op(BlendOp::Source)?;
        encoder.set_dispose_op(DisposeOp::None)?;
    }
    let mut writer = encoder.write_header()?;
    for picture in pictures {
        let data: Vec<u8> = match palette {
            Some(palette) => picture.pixels.iter().map(|color| palette[color]).collect(),
            None => picture.pixels.as_flattened().to_vec(),
        };
        writer.write_image_data(&data)?;
    }
    writer.finish()?;
    Ok(bytes)
}
