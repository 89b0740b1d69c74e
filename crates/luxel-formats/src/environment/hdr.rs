//! Radiance's RGBE: 8 bits a channel with an exponent for the three, by rows, with or without runs.
//!
//! After *Radiance File Formats* (Ward) and the note of its readers on runs (`color.c`). A mantissa m and an
//! exponent e are m 2^(e - 136), as in three.js and Blender; `EXPOSURE` and `COLORCORR` are ignored, as there.

use super::bytes::Cursor;
use super::{check_size, malformed};
use crate::{Error, ErrorKind, Limits, Place};
use luxel_lighting::EquirectangularImage;

/// The longest line of a header.
const LONGEST_LINE: usize = 4096;
/// Widths that runs by channels may have.
const RUN_WIDTHS: std::ops::Range<usize> = 8..0x8000;

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<EquirectangularImage, Error> {
    let mut cursor = Cursor::new(bytes, 0);
    let size @ [width, height] = header(&mut cursor)?;
    // A row takes a texel or more.
    check_size(size, cursor.at(), (bytes, u64::from(height) * 4), limits)?;
    let columns = width as usize;
    let mut light = Vec::with_capacity(columns * height as usize);
    let mut row = vec![[0; 4]; columns];
    for number in 0..height {
        read_row(&mut cursor, &mut row, &format!("row {number} of {height}"))?;
        light.extend(row.iter().map(|&rgbe| decoded(rgbe)));
    }
    Ok(EquirectangularImage { width, height, light })
}

/// Reads the header; width and height.
fn header(cursor: &mut Cursor<'_>) -> Result<[u32; 2], Error> {
    loop {
        let at = cursor.at();
        let line = cursor.until(b'\n', LONGEST_LINE, "the header")?.trim_ascii();
        if line.is_empty() {
            break;
        }
        if let Some(format) = line.strip_prefix(b"FORMAT=")
            && format.trim_ascii() != b"32-bit_rle_rgbe"
        {
            let format = String::from_utf8_lossy(format);
            let message =
                format!("pictures of the format {format} are not read: use 32-bit_rle_rgbe");
            return Err(Error::at(Place::Byte(at as u64), ErrorKind::Unsupported(message)));
        }
    }
    let at = cursor.at();
    let line = cursor.until(b'\n', LONGEST_LINE, "the line of the picture's size")?;
    let line = String::from_utf8_lossy(line);
    let words: Vec<_> = line.split_ascii_whitespace().collect();
    let side = |text: &str| text.parse::<u32>().ok();
    match words[..] {
        ["-Y", height, "+X", width] => match (side(width), side(height)) {
            (Some(width), Some(height)) => Ok([width, height]),
            _ => Err(malformed(at, format!("`{}` is not the size of a picture", line.trim()))),
        },
        [y, _, x, _] if [y, x].iter().all(|axis| ["-Y", "+Y", "-X", "+X"].contains(axis)) => {
            let message = "rows from top to bottom are read, each from left to right (-Y N +X M)";
            Err(Error::at(Place::Byte(at as u64), ErrorKind::Unsupported(message.to_owned())))
        }
        _ => Err(malformed(at, "the line of the picture's size is missing: -Y HEIGHT +X WIDTH")),
    }
}

/// Reads a row, in one of three ways of writing it.
fn read_row(cursor: &mut Cursor<'_>, row: &mut [[u8; 4]], what: &str) -> Result<(), Error> {
    let at = cursor.at();
    let first: [u8; 4] = cursor.array(what)?;
    let [2, 2, high, low] = first else { return plain_row(cursor, first, row, what) };
    if high >= 128 || !RUN_WIDTHS.contains(&row.len()) {
        return plain_row(cursor, first, row, what);
    }
    let width = usize::from(high) << 8 | usize::from(low);
    if width != row.len() {
        let message = format!("{what} has {width} texels, and the picture {} across", row.len());
        return Err(malformed(at, message));
    }
    for channel in 0..4 {
        let mut column = 0;
        while column < width {
            let at = cursor.at();
            let count = usize::from(cursor.byte(what)?);
            let (count, is_run) = if count > 128 { (count - 128, true) } else { (count, false) };
            let Some(texels) = row.get_mut(column..column + count).filter(|_| count > 0) else {
                return Err(malformed(at, format!("a run of {what} ends beyond the row")));
            };
            if is_run {
                let value = cursor.byte(what)?;
                texels.iter_mut().for_each(|texel| texel[channel] = value);
            } else {
                let values = cursor.take(count, what)?;
                for (texel, value) in texels.iter_mut().zip(values) {
                    texel[channel] = *value;
                }
            }
            column += count;
        }
    }
    Ok(())
}

/// Texels one by one; 1, 1, 1, n repeats the last one n times, and right after another such, 256 n times.
fn plain_row(
    cursor: &mut Cursor<'_>,
    first: [u8; 4],
    row: &mut [[u8; 4]],
    what: &str,
) -> Result<(), Error> {
    let (mut column, mut shift, mut texel) = (0_usize, 0, first);
    loop {
        if let [1, 1, 1, count] = texel {
            let count = usize::from(count) << shift;
            let before = column.checked_sub(1).and_then(|at| row.get(at)).copied();
            let (Some(before), Some(repeated)) = (before, row.get_mut(column..column + count))
            else {
                let message =
                    format!("a run of {what} has no texel before it, or ends beyond the row");
                return Err(malformed(cursor.at() - 4, message));
            };
            repeated.fill(before);
            column += count;
            shift = (shift + 8).min(24);
        } else {
            row[column] = texel;
            column += 1;
            shift = 0;
        }
        if column == row.len() {
            return Ok(());
        }
        texel = cursor.array(what)?;
    }
}

/// Exact: a product of a byte and a power of two.
fn decoded([r, g, b, exponent]: [u8; 4]) -> [f32; 3] {
    if exponent == 0 {
        return [0.0; 3];
    }
    // The exponent of an f64 begins at -1023.
    let scale = f64::from_bits((u64::from(exponent) + 1023 - 136) << 52);
    [r, g, b].map(|mantissa| (f64::from(mantissa) * scale) as f32)
}
