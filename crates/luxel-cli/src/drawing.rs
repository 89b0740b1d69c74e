//! From a view to the bytes of files: the one path of all commands that write pictures.

pub(crate) mod burnt_out;
mod format;
mod stopwatch;

use crate::failure::Failure;
pub(crate) use format::Format;
use luxel::lighting::{PictureEncoding, Tone};
use luxel::render::{
    Layer, LayerImage, Legend, Picture, PictureError, PictureFormat, Renderer, Subdivision, View,
    write_layers, write_linear, write_rgba8,
};
use luxel::scene::Size;
use luxel::view::LayerValues;
pub(crate) use stopwatch::Stopwatch;

/// The content of a file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Content {
    /// Its layers; none: the picture.
    pub(crate) layers: Vec<Layer>,
    /// Bits per channel of a picture as PNG or PPM.
    pub(crate) bits: u8,
    /// The format.
    pub(crate) format: Format,
}

/// What vectors may take.
#[cfg_attr(not(feature = "vectors"), expect(dead_code, reason = "only vectors read them"))]
#[derive(Clone, Copy, Debug)]
pub(crate) struct VectorOptions {
    /// How far colours may be from those of pixels, in 8-bit steps.
    pub(crate) tolerance: Option<f64>,
    /// Bytes of memory.
    pub(crate) max_memory: u64,
}

/// An encoded image.
#[derive(Default)]
pub(crate) struct Drawn {
    pub(crate) bytes: Vec<u8>,
    /// The meaning of a layer's 16-bit values.
    pub(crate) legend: Option<Legend>,
    /// Statistics of subdivision.
    pub(crate) subdivision: Option<Subdivision>,
    /// Faces, pieces and paths of vector output.
    pub(crate) svg: Option<[usize; 3]>,
    /// What tells whether it is worth a look how much of the model is burnt out.
    shown: Shown,
}

/// What an image shows of light.
#[derive(Default)]
enum Shown {
    /// Light itself, or a layer.
    #[default]
    Unclamped,
    /// Something clamped, of which the pixels aren't at hand.
    Clamped,
    /// This picture.
    Bytes(Picture<[u8; 4]>),
}

impl Drawn {
    /// Whether it is worth a look how much of the model is burnt out.
    pub(crate) fn may_be_burnt_out(&self) -> bool {
        match &self.shown {
            Shown::Unclamped => false,
            Shown::Clamped => true,
            Shown::Bytes(picture) => picture.may_be_burnt_out(),
        }
    }
}

impl Content {
    /// Whether it is the picture in 8-bit pixels.
    fn is_rgba8(&self) -> bool {
        self.layers.is_empty()
            && self.bits == 8
            && matches!(self.format, Format::Pixels(format) if !format.is_linear())
    }

    /// Bytes of the rendered and the encoded values of a pixel.
    fn bytes_a_pixel(&self) -> u64 {
        if !self.layers.is_empty() {
            return self.layers.iter().map(|layer| 12 + 8 * layer.channels() as u64).sum();
        }
        match self.format {
            Format::Pixels(_) if self.is_rgba8() => 8,
            Format::Pixels(_) => 32,
            Format::Svg => 0,
        }
    }
}

/// Fails before allocating beyond the memory limit.
pub(crate) fn check_memory(
    Size { width, height }: Size,
    contents: &[Content],
    limit: u64,
) -> Result<(), Failure> {
    let bytes_each: u64 = contents.iter().map(Content::bytes_a_pixel).sum();
    let needed = (u64::from(width) * u64::from(height)).saturating_mul(bytes_each);
    if needed <= limit {
        return Ok(());
    }
    Err(Failure::work(
        format!("an image of {width}x{height} would take {needed} bytes; the limit is {limit}"),
        "use a smaller --size, or raise the limit with --max-memory",
    ))
}

/// Renders a view and encodes it.
pub(crate) fn draw(
    renderer: &Renderer,
    view: &View,
    content: &Content,
    vectors: &VectorOptions,
    stopwatch: &mut Stopwatch,
) -> Result<Drawn, Failure> {
    if !content.layers.is_empty() {
        let values = renderer.layers(view, &content.layers)?;
        stopwatch.lap("frame");
        let drawn = encode_layers(view.size, content, values);
        stopwatch.lap("encode");
        return drawn;
    }
    let format = match content.format {
        Format::Pixels(format) => format,
        Format::Svg => return draw_vectors(renderer, view, vectors, stopwatch),
    };
    if content.is_rgba8() {
        let picture = renderer.rgba8(view)?;
        stopwatch.lap("frame");
        return encode_rgba8(view, format, picture, stopwatch);
    }
    // Of light itself, a curve for the eye would leave nothing to work with.
    let tone = if format.is_linear() { Tone::None } else { view.tone };
    let mut shown = view.clone().with_tone(tone);
    if format.is_linear() && view.ground {
        // The ground's alpha is for the bytes of sRGB unless the picture has none.
        shown.encoding = PictureEncoding::None;
    }
    let picture = renderer.linear(&shown)?;
    stopwatch.lap("frame");
    stopwatch.add_stages(&picture.stages);
    let mut drawn = Drawn { subdivision: picture.subdivision, ..Drawn::default() };
    if !format.is_linear() {
        drawn.shown = Shown::Clamped;
    }
    write_linear(format, view.size, &picture.pixels, view.encoding, &mut drawn.bytes)
        .map_err(cannot_encode)?;
    stopwatch.lap("encode");
    Ok(drawn)
}

/// Renders a view and encodes it in several ways, none of them vectors. The bytes are those of [`draw`], but
/// what can be is rendered in one pass.
pub(crate) fn draw_all(
    renderer: &Renderer,
    view: &View,
    contents: &[Content],
    stopwatch: &mut Stopwatch,
) -> Result<Vec<Drawn>, Failure> {
    let mut layers: Vec<Layer> = Vec::new();
    for layer in contents.iter().flat_map(|content| &content.layers) {
        if !layers.contains(layer) {
            layers.push(layer.clone());
        }
    }
    let mut picture = None;
    let mut values = Vec::new();
    if !layers.is_empty() {
        if contents.iter().any(Content::is_rgba8) {
            let mut drawn = Picture::default();
            renderer.rgba8_with_layers(view, &layers, &mut drawn, &mut values)?;
            picture = Some(drawn);
        } else {
            values = renderer.layers(view, &layers)?;
        }
        stopwatch.lap("frame");
    }
    let vectors = VectorOptions { tolerance: None, max_memory: 0 };
    let mut values: Vec<Option<LayerValues>> = values.into_iter().map(Some).collect();
    let mut all = Vec::new();
    for (number, content) in contents.iter().enumerate() {
        let later = &contents[number + 1..];
        let value_of = |layer: &Layer| {
            let place = layers.iter().position(|known| known == layer)?;
            match later.iter().any(|content| content.layers.contains(layer)) {
                true => values[place].clone(),
                false => values[place].take(),
            }
        };
        all.push(match (content.format, &picture) {
            _ if !content.layers.is_empty() => {
                let own = content.layers.iter().filter_map(value_of).collect();
                let drawn = encode_layers(view.size, content, own);
                stopwatch.lap("encode");
                drawn
            }
            (Format::Pixels(format), Some(picture)) if content.is_rgba8() => {
                encode_rgba8(view, format, picture.clone(), stopwatch)
            }
            _ => draw(renderer, view, content, &vectors, stopwatch),
        }?);
    }
    Ok(all)
}

fn encode_layers(
    size: Size,
    content: &Content,
    values: Vec<LayerValues>,
) -> Result<Drawn, Failure> {
    let Format::Pixels(format) = content.format else {
        return Err(Failure::Usage("layers need a pixel format".to_owned()));
    };
    let image = |(layer, values): (&Layer, _)| LayerImage {
        name: layer.name(),
        channels: layer.channels(),
        values,
    };
    let images: Vec<_> = content.layers.iter().zip(values).map(image).collect();
    let mut drawn = Drawn::default();
    drawn.legend = write_layers(format, size, &images, &mut drawn.bytes).map_err(cannot_encode)?;
    Ok(drawn)
}

fn encode_rgba8(
    view: &View,
    format: PictureFormat,
    picture: Picture<[u8; 4]>,
    stopwatch: &mut Stopwatch,
) -> Result<Drawn, Failure> {
    stopwatch.add_stages(&picture.stages);
    let mut drawn = Drawn { subdivision: picture.subdivision, ..Drawn::default() };
    write_rgba8(format, view.size, &picture.pixels, view.encoding, &mut drawn.bytes)
        .map_err(cannot_encode)?;
    drawn.shown = Shown::Bytes(picture);
    stopwatch.lap("encode");
    Ok(drawn)
}

#[cfg(not(feature = "vectors"))]
fn draw_vectors(
    _: &Renderer,
    _: &View,
    _: &VectorOptions,
    _: &mut Stopwatch,
) -> Result<Drawn, Failure> {
    let what = "this build of luxel draws no vectors";
    Err(Failure::work(what, "choose another format with -o, or a luxel with the feature `vectors`"))
}

#[cfg(feature = "vectors")]
fn draw_vectors(
    renderer: &Renderer,
    view: &View,
    VectorOptions { tolerance, max_memory }: &VectorOptions,
    stopwatch: &mut Stopwatch,
) -> Result<Drawn, Failure> {
    let defaults = luxel::render::SvgOptions::default();
    // Half of the memory is for pieces, half for the text of their paths.
    let pieces = max_memory / 600;
    let options = luxel::render::SvgOptions {
        tolerance: tolerance.map_or(defaults.tolerance, |t| t as f32),
        max_pieces: defaults.max_pieces.min(usize::try_from(pieces).unwrap_or(usize::MAX)),
    };
    let svg = renderer.svg(view, &options)?;
    stopwatch.lap("frame");
    Ok(Drawn {
        svg: Some([svg.faces, svg.pieces, svg.paths]),
        bytes: svg.text.into_bytes(),
        shown: Shown::Clamped,
        ..Drawn::default()
    })
}

fn cannot_encode(error: PictureError) -> Failure {
    Failure::work(error.to_string(), "choose another format with -o")
}
