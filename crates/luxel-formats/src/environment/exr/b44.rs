//! B44 and B44A: 4x4 samples of half channels become 14 bytes, or three where all are the same. Other channels
//! are as they are.

use super::Area;
use super::header::Header;
use super::samples::Kind;

const SIDE: usize = 4;
/// From this third byte on, a group's samples are all the same.
const ALL_SAME: u8 = 13 << 2;

/// The samples of a block, `expected` bytes.
pub(super) fn expanded(
    compressed: &[u8],
    expected: usize,
    header: &Header,
    area: Area,
) -> Result<Vec<u8>, String> {
    let cut = "damaged: samples are cut off";
    let Area { width, height, .. } = area;
    let of_line = header.bytes_of_texel() * width;
    let mut samples = vec![0; expected];
    let (mut rest, mut start) = (compressed, 0);
    for &kind in &header.channels {
        let length = width * kind.bytes();
        if kind == Kind::Half {
            for y in (0..height).step_by(SIDE) {
                for x in (0..width).step_by(SIDE) {
                    let (group, after) = group(rest).ok_or(cut)?;
                    rest = after;
                    for (row, line) in (y..height).zip(group.chunks(SIDE)) {
                        for (column, value) in (x..width).zip(line) {
                            let at = row * of_line + start + 2 * column;
                            samples[at..at + 2].copy_from_slice(&value.to_le_bytes());
                        }
                    }
                }
            }
        } else {
            let (plain, after) = rest.split_at_checked(length * height).ok_or(cut)?;
            rest = after;
            for (row, line) in plain.chunks(length).enumerate() {
                let at = row * of_line + start;
                samples[at..at + length].copy_from_slice(line);
            }
        }
        start += length;
    }
    Ok(samples)
}

/// The 4x4 samples at the front, row by row, and what follows them.
fn group(bytes: &[u8]) -> Option<([u16; SIDE * SIDE], &[u8])> {
    let (&[a, b, third], after) = bytes.split_first_chunk()?;
    let first = u16::from_be_bytes([a, b]);
    if third >= ALL_SAME {
        return Some(([plain(first); SIDE * SIDE], after));
    }
    let (group, after) = bytes.split_first_chunk::<14>()?;
    // Fifteen differences of six bits, after 16 bits of the first sample and six of their scale.
    let bits = group.iter().fold(0_u128, |bits, &byte| bits << 8 | u128::from(byte));
    let shift = third >> 2;
    let difference = |number: usize| (bits >> (90 - 6 * number)) as u16 & 0x3f;
    let next = |before: u16, number: usize| {
        before.wrapping_add(difference(number) << shift).wrapping_sub(0x20 << shift)
    };
    // Down the first column, then each column to the right of the one before.
    let mut ordered = [first; SIDE * SIDE];
    for row in 1..SIDE {
        ordered[row * SIDE] = next(ordered[(row - 1) * SIDE], row);
    }
    for column in 1..SIDE {
        for row in 0..SIDE {
            let at = row * SIDE + column;
            ordered[at] = next(ordered[at - 1], column * SIDE + row);
        }
    }
    Some((ordered.map(plain), after))
}

/// The bits of a half, from bits that are ordered as the numbers are.
const fn plain(ordered: u16) -> u16 {
    if ordered & 0x8000 != 0 { ordered & 0x7fff } else { !ordered }
}
