//! Decompression of geometry packed by `EXT_meshopt_compression` (the extension's appendices A and
//! B define the bitstream and the filters).

mod attributes;
mod filters;
mod indices;

use crate::ErrorKind;
use luxel_gltf::Meshopt;

/// Decompresses a buffer view. The caller has checked that `count` elements of `byte_stride` may be
/// allocated.
pub(crate) fn decompress(view: &Meshopt, stream: &[u8]) -> Result<Vec<u8>, ErrorKind> {
    decode(view, stream).map_err(ErrorKind::Malformed)
}

/// Decompresses a buffer view.
///
/// # Errors
/// A message that describes the damage.
fn decode(view: &Meshopt, stream: &[u8]) -> Result<Vec<u8>, String> {
    let count = usize::try_from(view.count).map_err(|_| "the count is too large")?;
    let stride = usize::try_from(view.byte_stride).map_err(|_| "the stride is too large")?;
    let indices_of = |indices: Vec<u32>| {
        let bytes: Vec<u8> = match stride {
            2 => indices.iter().flat_map(|&index| (index as u16).to_le_bytes()).collect(),
            _ => indices.iter().flat_map(|index| index.to_le_bytes()).collect(),
        };
        bytes
    };
    let is_index = |kind: &str| match stride {
        2 | 4 => Ok(()),
        _ => Err(format!("{kind} have a stride of 2 or 4 bytes, not {stride}")),
    };
    let filter = view.filter.as_deref().unwrap_or("NONE");
    match view.mode.as_str() {
        "ATTRIBUTES" => {
            let mut bytes = attributes::decode(stream, count, stride)?;
            filters::apply(filter, &mut bytes, stride)?;
            Ok(bytes)
        }
        "TRIANGLES" => {
            is_index("TRIANGLES")?;
            Ok(indices_of(indices::decode_triangles(stream, count)?))
        }
        "INDICES" => {
            is_index("INDICES")?;
            Ok(indices_of(indices::decode_sequence(stream, count)?))
        }
        mode => Err(format!("`{mode}` is not a mode: use ATTRIBUTES, TRIANGLES or INDICES")),
    }
}

/// Reads a stream from the front, with bounds checks.
struct Cursor<'a> {
    rest: &'a [u8],
}

/// The message for a stream that ends too early.
const ENDS_EARLY: &str = "the compressed stream ends too early";

impl<'a> Cursor<'a> {
    fn byte(&mut self) -> Result<u8, String> {
        let (&byte, rest) = self.rest.split_first().ok_or(ENDS_EARLY)?;
        self.rest = rest;
        Ok(byte)
    }

    fn bytes(&mut self, count: usize) -> Result<&'a [u8], String> {
        let (bytes, rest) = self.rest.split_at_checked(count).ok_or(ENDS_EARLY)?;
        self.rest = rest;
        Ok(bytes)
    }

    /// An integer of up to five groups of seven bits, the lowest first.
    fn variable(&mut self) -> Result<u32, String> {
        let mut value = 0;
        for shift in [0, 7, 14, 21, 28] {
            let byte = self.byte()?;
            value |= u32::from(byte & 127) << shift;
            if byte < 128 {
                break;
            }
        }
        Ok(value)
    }
}

/// Signed differences in unsigned numbers: 0, -1, 1, -2, ...
const fn unzigzag(value: u32) -> u32 {
    (value >> 1) ^ (value & 1).wrapping_neg()
}

#[cfg(test)]
mod tests;
