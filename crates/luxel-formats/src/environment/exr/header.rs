//! The header: what is read of it, and what a picture must be.

use super::super::bytes::Cursor;
use super::super::malformed;
use super::Compression;
use super::samples::Kind;
use crate::{Error, ErrorKind, Place};

/// Flags of the version.
const TILED: u32 = 0x200;
const LONG_NAMES: u32 = 0x400;
/// The longest name.
const LONGEST_NAME: usize = 255;
/// More channels than that are taken for damage.
const MOST_CHANNELS: usize = 1024;

/// How a picture is cut into tiles.
#[derive(Clone, Copy)]
pub(super) struct Tiles {
    pub(super) sides: [usize; 2],
}

/// A picture that can be read.
pub(super) struct Header {
    pub(super) size: [u32; 2],
    /// Where in the file the size stands.
    pub(super) size_byte: usize,
    /// The number of the first row.
    pub(super) top: i32,
    /// The types of all channels, in the order of their samples.
    pub(super) channels: Vec<Kind>,
    /// The channels that are red, green and blue.
    pub(super) colors: [usize; 3],
    pub(super) compression: Compression,
    pub(super) tiles: Option<Tiles>,
}

impl Header {
    /// Bytes of the samples of a texel.
    pub(super) fn bytes_of_texel(&self) -> usize {
        self.channels.iter().map(|kind| kind.bytes()).sum()
    }

    /// How many blocks the picture has.
    pub(super) fn chunk_count(&self) -> usize {
        let [width, height] = self.size.map(|side| side as usize);
        match self.tiles {
            None => height.div_ceil(self.compression.rows()),
            Some(Tiles { sides }) => width.div_ceil(sides[0]) * height.div_ceil(sides[1]),
        }
    }

    pub(super) fn read(cursor: &mut Cursor<'_>) -> Result<Self, Error> {
        let what = "the header";
        cursor.take(4, what)?;
        let version = cursor.u32(what)?;
        let is_tiled = version & TILED != 0;
        if version & !(TILED | LONG_NAMES) != 2 {
            let message = "only pictures of one part are read, and no deep ones: save a plain one";
            return Err(unsupported(4, message));
        }
        let mut channels = None;
        let mut compression = None;
        let (mut data, mut display) = (None, None);
        let (mut tiles, mut size_byte) = (None, 0);
        loop {
            let name = cursor.until(0, LONGEST_NAME, what)?;
            if name.is_empty() {
                break;
            }
            let kind = cursor.until(0, LONGEST_NAME, what)?;
            let length = cursor.i32(what)?;
            let at = cursor.at();
            let length = usize::try_from(length)
                .map_err(|_| malformed(at - 4, format!("an attribute has {length} bytes")))?;
            let value = cursor.take(length, what)?;
            let mut value = Cursor::new(value, 0);
            match (name, kind) {
                (b"channels", b"chlist") => channels = Some(read_channels(&mut value, at)?),
                (b"compression", b"compression") => {
                    compression = Some(Compression::of(value.byte(what)?, at)?);
                }
                (b"dataWindow", b"box2i") => {
                    size_byte = at;
                    data = Some(read_box(&mut value)?);
                }
                (b"displayWindow", b"box2i") => display = Some(read_box(&mut value)?),
                (b"tiles", b"tiledesc") => tiles = Some(read_tiles(&mut value, at)?),
                _ => {}
            }
        }
        let missing = |name: &str| malformed(0, format!("the header lacks `{name}`"));
        let (channels, colors, is_bent) = channels.ok_or_else(|| missing("channels"))?;
        let compression = compression.ok_or_else(|| missing("compression"))?;
        let [left, top, right, bottom] = data.ok_or_else(|| missing("dataWindow"))?;
        if display.is_some_and(|display| display != [left, top, right, bottom]) {
            let message = "the picture is a part of its frame (dataWindow is not displayWindow): save it whole";
            return Err(unsupported(size_byte, message));
        }
        let tiles = if is_tiled { Some(tiles.ok_or_else(|| missing("tiles"))?) } else { None };
        if is_bent && compression == Compression::B44 {
            let message =
                "B44 with channels that are perceptually linear is not read: save it with ZIP";
            return Err(unsupported(0, message));
        }
        let side = |from: i32, to: i32| {
            let texels = i64::from(to) - i64::from(from) + 1;
            texels.clamp(0, i64::from(u32::MAX)) as u32
        };
        let size = [side(left, right), side(top, bottom)];
        Ok(Self { size, size_byte, top, channels, colors, compression, tiles })
    }
}

/// The error of a file that is sound, but not read.
pub(super) fn unsupported(byte: usize, message: impl Into<String>) -> Error {
    Error::at(Place::Byte(byte as u64), ErrorKind::Unsupported(message.into()))
}

fn read_box(value: &mut Cursor<'_>) -> Result<[i32; 4], Error> {
    let mut side = || value.i32("a window of the header");
    Ok([side()?, side()?, side()?, side()?])
}

fn read_tiles(value: &mut Cursor<'_>, at: usize) -> Result<Tiles, Error> {
    let mut side = || value.u32("the sides of tiles");
    let sides = [side()?, side()?].map(|side| side as usize);
    if sides.iter().any(|side| !(1..=1 << 16).contains(side)) {
        return Err(malformed(at, format!("tiles have {}x{} texels", sides[0], sides[1])));
    }
    Ok(Tiles { sides })
}

/// The types of the channels, which of them are red, green and blue, and whether one is to be compressed on a curve.
fn read_channels(
    value: &mut Cursor<'_>,
    at: usize,
) -> Result<(Vec<Kind>, [usize; 3], bool), Error> {
    let what = "the list of channels";
    let mut kinds = Vec::new();
    let mut names = Vec::new();
    let mut is_bent = false;
    loop {
        let name = value.until(0, LONGEST_NAME, what)?;
        if name.is_empty() {
            break;
        }
        let kind = value.i32(what)?;
        let kind =
            Kind::of(kind).ok_or_else(|| malformed(at, format!("a channel has type {kind}")))?;
        let [is_linear_to_the_eye, ..] = value.array::<4>(what)?;
        is_bent |= is_linear_to_the_eye != 0;
        if [value.i32(what)?, value.i32(what)?] != [1, 1] {
            let message = "a channel has fewer samples than texels: save it as RGB";
            return Err(unsupported(at, message));
        }
        kinds.push(kind);
        names.push(name);
        if kinds.len() > MOST_CHANNELS {
            return Err(malformed(at, format!("there are more than {MOST_CHANNELS} channels")));
        }
    }
    let place = |name: &[u8]| names.iter().position(|other| *other == name);
    let rgb = |prefix: &[u8]| {
        let of = |color: &[u8]| place(&[prefix, color].concat());
        Some([of(b"R")?, of(b"G")?, of(b"B")?])
    };
    // Layers have names such as `ViewLayer.Combined.R`.
    let layers = names.iter().filter_map(|name| name.strip_suffix(b"R"));
    let colors = rgb(b"").or_else(|| layers.filter(|layer| layer.ends_with(b".")).find_map(rgb));
    let colors = colors.or_else(|| place(b"Y").map(|grey| [grey; 3]));
    let colors = colors.ok_or_else(|| {
        unsupported(at, "there are no channels R, G and B, and no channel Y of grey")
    })?;
    Ok((kinds, colors, is_bent))
}
