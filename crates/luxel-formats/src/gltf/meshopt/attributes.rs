//! The attribute codec: byte-wise deltas from the previous element, packed in groups of sixteen.

use super::Cursor;

/// Version 0 of the codec, the one that the extension allows.
const HEADER: u8 = 0xa0;
const GROUP: usize = 16;
/// The first element follows the blocks; the tail is padded in front to this length.
const LEAST_TAIL: usize = 32;

/// Decodes `count` elements of `stride` bytes.
pub(super) fn decode(stream: &[u8], count: usize, stride: usize) -> Result<Vec<u8>, String> {
    if stride == 0 || stride > 256 || !stride.is_multiple_of(4) {
        return Err(format!("a stride of {stride} bytes is not a multiple of 4 up to 256"));
    }
    let mut cursor = Cursor { rest: stream };
    match cursor.byte()? {
        HEADER => {}
        other => return Err(format!("the attribute stream begins with {other:#04x}, not 0xa0")),
    }
    let blocks = cursor.rest.len().checked_sub(stride.max(LEAST_TAIL)).ok_or(super::ENDS_EARLY)?;
    let (blocks, tail) = cursor.rest.split_at(blocks);
    let mut previous = tail[tail.len() - stride..].to_vec();
    let most = ((8192 / stride) & !(GROUP - 1)).min(256);
    let mut cursor = Cursor { rest: blocks };
    let mut elements = vec![0; count * stride];
    let mut differences = [0; 256];
    for block in elements.chunks_mut(most * stride) {
        let in_block = block.len() / stride;
        let groups = in_block.div_ceil(GROUP);
        for (place, last) in previous.iter_mut().enumerate() {
            let modes = cursor.bytes(groups.div_ceil(4))?;
            for (group, sixteen) in differences.chunks_exact_mut(GROUP).take(groups).enumerate() {
                let mode = modes[group / 4] >> (group % 4 * 2) & 3;
                decode_group(&mut cursor, mode, sixteen)?;
            }
            for (element, &difference) in block.chunks_exact_mut(stride).zip(&differences) {
                *last = last.wrapping_add(super::unzigzag(u32::from(difference)) as u8);
                element[place] = *last;
            }
        }
    }
    if !cursor.rest.is_empty() {
        return Err(format!("{} bytes follow the last block", cursor.rest.len()));
    }
    Ok(elements)
}

/// Sixteen differences: none, in 2 or 4 bits with the largest value as an escape, or in bytes.
fn decode_group(cursor: &mut Cursor<'_>, mode: u8, sixteen: &mut [u8]) -> Result<(), String> {
    let bits = match mode {
        0 => {
            sixteen.fill(0);
            return Ok(());
        }
        1 => 2,
        2 => 4,
        _ => {
            sixteen.copy_from_slice(cursor.bytes(GROUP)?);
            return Ok(());
        }
    };
    let escape = (1 << bits) - 1;
    let packed = cursor.bytes(GROUP * bits / 8)?;
    let per_byte = 8 / bits;
    for (index, difference) in sixteen.iter_mut().enumerate() {
        // The highest bits hold the first value.
        let shift = 8 - bits * (index % per_byte + 1);
        let value = packed[index / per_byte] >> shift & escape;
        *difference = if value == escape { cursor.byte()? } else { value };
    }
    Ok(())
}
