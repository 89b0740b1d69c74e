//! OpenEXR: one part of scan lines with any number of float32 and uint32 channels, compressed by
//! ZIP (*OpenEXR File Layout* and *Technical Introduction*, Academy Software Foundation).
//!
//! Our own, since the libraries for it take longer to build than all other formats together, and
//! one kind of file is all that is written.

use super::{LayerImage, PictureError};
use crate::LayerValues;
use flate2::{Compression, write::ZlibEncoder};
use luxel_scene::Size;
use std::io::Write;

/// The first four bytes.
const MAGIC: u32 = 20_000_630;
/// Version 2, scan lines in one part.
const VERSION: u32 = 2;
/// Flag of the version field: names of up to 255 bytes.
const LONG_NAMES: u32 = 0x400;
/// The longest name without that flag.
const SHORT_NAME: usize = 31;
const LONGEST_NAME: usize = 255;
/// `ZIP_COMPRESSION`
const ZIP: u8 = 3;
/// Scan lines that are compressed together.
const BLOCK_LINES: usize = 16;
/// zlib's level: the fastest that still finds repetitions.
const LEVEL: u32 = 1;

/// A channel: every `stride`-th value from `first`.
struct Channel<'a> {
    name: String,
    values: Samples<'a>,
    first: usize,
    stride: usize,
}

#[derive(Clone, Copy)]
enum Samples<'a> {
    F32(&'a [f32]),
    U32(&'a [u32]),
}

/// Writes linear pixels as R, G, B and A; colours multiplied by alpha, as the format has it.
pub(crate) fn write_rgba(
    size: Size,
    pixels: &[[f32; 4]],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let multiplied: Vec<[f32; 4]> =
        pixels.iter().map(|&[r, g, b, alpha]| [r * alpha, g * alpha, b * alpha, alpha]).collect();
    let values = Samples::F32(multiplied.as_flattened());
    let channel =
        |(first, name): (usize, &str)| Channel { name: name.to_owned(), values, first, stride: 4 };
    write(size, ["R", "G", "B", "A"].into_iter().enumerate().map(channel).collect(), out)
}

/// Writes layers as channels side by side.
pub(crate) fn write_layers(
    size: Size,
    layers: &[LayerImage],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let mut channels = Vec::new();
    for layer in layers {
        let values = match &layer.values {
            LayerValues::F32(values) => Samples::F32(values),
            LayerValues::U32(values) => Samples::U32(values),
        };
        for (first, name) in layer.channel_names().into_iter().enumerate() {
            channels.push(Channel { name, values, first, stride: layer.channels });
        }
    }
    write(size, channels, out)
}

fn write(
    size: Size,
    mut channels: Vec<Channel<'_>>,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    // Readers rely on the order of names.
    channels.sort_by(|a, b| a.name.cmp(&b.name));
    let bad = |name: &str| name.is_empty() || name.len() > LONGEST_NAME || name.contains('\0');
    for (place, channel) in channels.iter().enumerate() {
        let twice = place > 0 && channels[place - 1].name == channel.name;
        if twice || bad(&channel.name) {
            return Err(PictureError::Channel(channel.name.clone()));
        }
    }
    let header = header(size, &channels);
    let lines = size.height as usize;
    let mut blocks = Vec::new();
    for first_line in (0..lines).step_by(BLOCK_LINES) {
        let range = first_line..lines.min(first_line + BLOCK_LINES);
        let raw = raw_block(size, &channels, range);
        let compressed = compress(&raw)?;
        blocks.push(if compressed.len() < raw.len() { compressed } else { raw });
    }

    out.write_all(&header)?;
    let mut offset = (header.len() + 8 * blocks.len()) as u64;
    for block in &blocks {
        out.write_all(&offset.to_le_bytes())?;
        offset += 8 + block.len() as u64;
    }
    for (number, block) in blocks.iter().enumerate() {
        out.write_all(&((number * BLOCK_LINES) as i32).to_le_bytes())?;
        out.write_all(&(block.len() as i32).to_le_bytes())?;
        out.write_all(block)?;
    }
    Ok(())
}

fn header(size: Size, channels: &[Channel<'_>]) -> Vec<u8> {
    let mut header = Vec::new();
    let long_names = channels.iter().any(|channel| channel.name.len() > SHORT_NAME);
    let version = if long_names { VERSION | LONG_NAMES } else { VERSION };
    header.extend(MAGIC.to_le_bytes());
    header.extend(version.to_le_bytes());

    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        for text in [name, kind] {
            header.extend(text.as_bytes());
            header.push(0);
        }
        header.extend((value.len() as i32).to_le_bytes());
        header.extend(value);
    };
    let mut list = Vec::new();
    for channel in channels {
        list.extend(channel.name.as_bytes());
        list.push(0);
        let kind: i32 = match channel.values {
            Samples::U32(_) => 0,
            Samples::F32(_) => 2,
        };
        list.extend(kind.to_le_bytes());
        // Not perceptually linear, reserved; a sample for every pixel across and down.
        list.extend([0; 4]);
        list.extend(1_i32.to_le_bytes());
        list.extend(1_i32.to_le_bytes());
    }
    list.push(0);
    let window: Vec<u8> = [0, 0, size.width as i32 - 1, size.height as i32 - 1]
        .into_iter()
        .flat_map(i32::to_le_bytes)
        .collect();
    attribute("channels", "chlist", &list);
    attribute("compression", "compression", &[ZIP]);
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1.0_f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1.0_f32.to_le_bytes());
    header.push(0);
    header
}

/// Lines one after another, in each the channels in the order of their names.
fn raw_block(size: Size, channels: &[Channel<'_>], lines: std::ops::Range<usize>) -> Vec<u8> {
    let width = size.width as usize;
    let mut raw = Vec::with_capacity(lines.len() * width * channels.len() * 4);
    for line in lines {
        for channel in channels {
            let places = (0..width).map(|x| (line * width + x) * channel.stride + channel.first);
            match channel.values {
                Samples::F32(values) => {
                    raw.extend(places.flat_map(|place| values[place].to_le_bytes()));
                }
                Samples::U32(values) => {
                    raw.extend(places.flat_map(|place| values[place].to_le_bytes()));
                }
            }
        }
    }
    raw
}

/// ZIP as OpenEXR does it: bytes of even places first, then those of odd ones, each as its
/// difference from the one before plus 128, and that through zlib.
fn compress(raw: &[u8]) -> Result<Vec<u8>, PictureError> {
    let mut parted: Vec<u8> = raw.iter().step_by(2).copied().collect();
    parted.extend(raw.iter().skip(1).step_by(2));
    let mut before = 0;
    for (place, byte) in parted.iter_mut().enumerate() {
        let value = *byte;
        if place > 0 {
            *byte = value.wrapping_sub(before).wrapping_add(128);
        }
        before = value;
    }
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
    encoder.write_all(&parted)?;
    Ok(encoder.finish()?)
}
