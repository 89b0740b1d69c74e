//! OpenEXR: one part of scan lines or tiles, of half, float or uint channels (*OpenEXR File Layout*, Academy
//! Software Foundation).

mod b44;
mod compression;
mod header;
mod piz;
mod samples;
mod words;

use super::bytes::Cursor;
use super::{check_size, malformed};
use crate::{Error, Limits, Place};
use compression::Compression;
use header::{Header, Tiles};
use luxel_lighting::EquirectangularImage;

/// Deflate encodes at most 258 bytes in two bits; Huffman's codes of PIZ are runs of at most 255 in a few.
const BYTES_PER_BYTE: u64 = 1032;

/// A rectangle of texels: column, row, width, height.
#[derive(Clone, Copy)]
struct Area {
    column: usize,
    row: usize,
    width: usize,
    height: usize,
}

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<EquirectangularImage, Error> {
    let mut cursor = Cursor::new(bytes, 0);
    let header = Header::read(&mut cursor)?;
    let [width, height] = header.size;
    let texels = u64::from(width) * u64::from(height);
    let raw = texels.saturating_mul(header.bytes_of_texel() as u64);
    check_size(header.size, header.size_byte, (bytes, raw / BYTES_PER_BYTE), limits)?;
    let columns = width as usize;
    let rows = height as usize;
    let mut light = vec![[0.0; 3]; columns * rows];
    let chunks = header.chunk_count();
    let mut taken = 0;
    let mut offsets = Cursor::new(bytes, cursor.at());
    for number in 0..chunks {
        let what = format!("block {number} of {chunks}");
        let at = offsets.at();
        let offset = offsets.u64("the table of blocks")?;
        let offset = usize::try_from(offset).ok().filter(|&offset| offset < bytes.len());
        let offset = offset.ok_or_else(|| {
            malformed(at, format!("{what} begins beyond the end of the file: it may be cut off"))
        })?;
        let mut chunk = Cursor::new(bytes, offset);
        let area = area_of(&header, &mut chunk, &what)?;
        let length = chunk.i32(&what)?;
        let length = usize::try_from(length)
            .map_err(|_| malformed(chunk.at() - 4, format!("{what} has {length} bytes")))?;
        let start = chunk.at();
        let compressed = chunk.take(length, &what)?;
        // Blocks that lie in one place would take more time than their bytes.
        taken += length;
        if taken > bytes.len() {
            return Err(malformed(at, format!("{what} lies where another one does")));
        }
        let expected = area.width * area.height * header.bytes_of_texel();
        // Other channels may be many.
        let place = Place::Byte(start as u64);
        limits.check("a block of the picture", expected as u64, 2, place)?;
        let raw = header.compression.expand(compressed, expected, &header, area);
        let raw = raw.map_err(|message| malformed(start, format!("{what}: {message}")))?;
        put(&header, area, &raw, columns, &mut light);
    }
    Ok(EquirectangularImage { width, height, light })
}

/// The texels of a block, by its own head.
fn area_of(header: &Header, chunk: &mut Cursor<'_>, what: &str) -> Result<Area, Error> {
    let [width, height] = header.size.map(|side| side as usize);
    let at = chunk.at();
    let outside = || malformed(at, format!("{what} lies outside of the picture"));
    let index = |value: i32| usize::try_from(value).ok();
    let (column, row, most) = match header.tiles {
        None => {
            let row = i64::from(chunk.i32(what)?) - i64::from(header.top);
            let row = usize::try_from(row).map_err(|_| outside())?;
            (Some(0), Some(row), [width, header.compression.rows()])
        }
        Some(Tiles { sides }) => {
            let [x, y] = [chunk.i32(what)?, chunk.i32(what)?];
            let levels = [chunk.i32(what)?, chunk.i32(what)?];
            if levels != [0, 0] {
                return Err(malformed(at, format!("{what} is of another level than the picture")));
            }
            let place =
                |tile: i32, side: usize| index(tile).and_then(|tile| tile.checked_mul(side));
            (place(x, sides[0]), place(y, sides[1]), sides)
        }
    };
    let (Some(column), Some(row)) = (column, row) else { return Err(outside()) };
    if column >= width || row >= height {
        return Err(outside());
    }
    let [across, down] = most;
    Ok(Area { column, row, width: across.min(width - column), height: down.min(height - row) })
}

/// Puts a block's samples, line by line and in a line channel by channel, where they belong.
fn put(header: &Header, area: Area, raw: &[u8], columns: usize, light: &mut [[f32; 3]]) {
    let bytes_of_line = area.width * header.bytes_of_texel();
    for (line, bytes) in raw.chunks_exact(bytes_of_line).enumerate() {
        let first = (area.row + line) * columns + area.column;
        let Some(texels) = light.get_mut(first..first + area.width) else { return };
        let mut start = 0;
        for (number, kind) in header.channels.iter().enumerate() {
            let end = start + area.width * kind.bytes();
            let samples = &bytes[start..end];
            for channel in (0..3).filter(|&channel| header.colors[channel] == number) {
                for (texel, sample) in texels.iter_mut().zip(samples.chunks_exact(kind.bytes())) {
                    texel[channel] = kind.value(sample);
                }
            }
            start = end;
        }
    }
}
