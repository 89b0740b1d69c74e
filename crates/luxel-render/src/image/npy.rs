//! NPY, the array format of NumPy, version 1.0 (NumPy Enhancement Proposal 1).

use super::PictureError;
use crate::LayerValues;
use luxel_scene::Size;
use std::io::Write;

/// The values of an array.
pub(crate) enum Values<'a> {
    U8(&'a [u8]),
    F32(&'a [f32]),
    U32(&'a [u32]),
}

impl<'a> From<&'a LayerValues> for Values<'a> {
    fn from(values: &'a LayerValues) -> Self {
        match values {
            LayerValues::F32(values) => Self::F32(values),
            LayerValues::U32(values) => Self::U32(values),
        }
    }
}

/// Writes an array of the shape (height, width), or (height, width, channels) for several channels.
pub(crate) fn write(
    size: Size,
    channels: usize,
    values: Values<'_>,
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let kind = match values {
        Values::U8(_) => "|u1",
        Values::F32(_) => "<f4",
        Values::U32(_) => "<u4",
    };
    let Size { width, height } = size;
    let shape = match channels {
        1 => format!("({height}, {width})"),
        _ => format!("({height}, {width}, {channels})"),
    };
    let mut header = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    // The data begins at a multiple of 64 bytes; the last byte of the header ends its line.
    const BEFORE_HEADER: usize = 10;
    while !(BEFORE_HEADER + header.len() + 1).is_multiple_of(64) {
        header.push(' ');
    }
    header.push('\n');
    out.write_all(b"\x93NUMPY\x01\x00")?;
    out.write_all(&(header.len() as u16).to_le_bytes())?;
    out.write_all(header.as_bytes())?;
    match values {
        Values::U8(values) => out.write_all(values)?,
        Values::F32(values) => write_words(values, f32::to_le_bytes, out)?,
        Values::U32(values) => write_words(values, u32::to_le_bytes, out)?,
    }
    Ok(())
}

/// Writes numbers of four bytes, a few thousand at a time.
fn write_words<T: Copy>(
    values: &[T],
    bytes: impl Fn(T) -> [u8; 4],
    out: &mut dyn Write,
) -> Result<(), PictureError> {
    let mut buffer = Vec::with_capacity(4 * 4096);
    for run in values.chunks(4096) {
        buffer.clear();
        buffer.extend(run.iter().flat_map(|&value| bytes(value)));
        out.write_all(&buffer)?;
    }
    Ok(())
}
