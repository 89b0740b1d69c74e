//! Blocks of samples, compressed without loss or with little.

use super::header::{Header, unsupported};
use super::samples::Kind;
use super::{Area, Error, b44, piz};
use flate2::read::ZlibDecoder;
use std::borrow::Cow;
use std::io::Read;

/// How blocks are compressed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Compression {
    None,
    Rle,
    /// A line at a time.
    Zips,
    /// Sixteen lines at a time.
    Zip,
    Pxr24,
    Piz,
    /// With or without short groups of equal samples.
    B44,
}

impl Compression {
    pub(super) fn of(number: u8, at: usize) -> Result<Self, Error> {
        let name = match number {
            0 => return Ok(Self::None),
            1 => return Ok(Self::Rle),
            2 => return Ok(Self::Zips),
            3 => return Ok(Self::Zip),
            4 => return Ok(Self::Piz),
            5 => return Ok(Self::Pxr24),
            6 | 7 => return Ok(Self::B44),
            8 => "DWAA",
            9 => "DWAB",
            _ => "unknown",
        };
        let message = format!("the compression {name} is not read: save the picture with ZIP");
        Err(unsupported(at, message))
    }

    /// Lines of a block.
    pub(super) const fn rows(self) -> usize {
        match self {
            Self::None | Self::Rle | Self::Zips => 1,
            Self::Zip | Self::Pxr24 => 16,
            Self::Piz | Self::B44 => 32,
        }
    }

    /// The samples of a block, `expected` bytes.
    pub(super) fn expand<'a>(
        self,
        compressed: &'a [u8],
        expected: usize,
        header: &Header,
        area: Area,
    ) -> Result<Cow<'a, [u8]>, String> {
        // What compression would make longer is stored as it is.
        if self == Self::None || compressed.len() == expected {
            return match compressed.len() == expected {
                true => Ok(Cow::Borrowed(compressed)),
                false => Err(sizes(compressed.len(), expected)),
            };
        }
        match self {
            Self::None => Ok(Cow::Borrowed(compressed)),
            Self::Rle => Ok(Cow::Owned(woven(&unrolled(compressed, expected)?))),
            Self::Zips | Self::Zip => Ok(Cow::Owned(woven(&inflated(compressed, expected)?))),
            Self::Piz => piz::expanded(compressed, expected, header, area).map(Cow::Owned),
            Self::B44 => b44::expanded(compressed, expected, header, area).map(Cow::Owned),
            Self::Pxr24 => of_24_bits(compressed, expected, header, area).map(Cow::Owned),
        }
    }
}

fn sizes(found: usize, expected: usize) -> String {
    format!("{found} bytes, where {expected} are expected")
}

/// Bytes of zlib, exactly so many.
fn inflated(compressed: &[u8], expected: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::with_capacity(expected);
    let limited = ZlibDecoder::new(compressed).take(expected as u64 + 1);
    let mut limited = limited;
    limited.read_to_end(&mut bytes).map_err(|error| format!("damaged: {error}"))?;
    if bytes.len() == expected { Ok(bytes) } else { Err(sizes(bytes.len(), expected)) }
}

/// Runs: n from 0 repeats the next byte n + 1 times, and from -128 to -1 takes the next -n bytes.
fn unrolled(compressed: &[u8], expected: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::with_capacity(expected);
    let mut rest = compressed;
    while let [count, after @ ..] = rest {
        let count = *count as i8;
        let length = usize::from(count.unsigned_abs());
        if count < 0 {
            let (taken, after) =
                after.split_at_checked(length).ok_or("damaged: a run is cut off")?;
            bytes.extend_from_slice(taken);
            rest = after;
        } else {
            let (value, after) = after.split_first().ok_or("damaged: a run is cut off")?;
            bytes.resize(bytes.len() + length + 1, *value);
            rest = after;
        }
        if bytes.len() > expected {
            break;
        }
    }
    if bytes.len() == expected { Ok(bytes) } else { Err(sizes(bytes.len(), expected)) }
}

/// Undoes what makes bytes compressible: differences to the byte before, and even bytes before odd ones.
fn woven(bytes: &[u8]) -> Vec<u8> {
    let (even, odd) = bytes.split_at(bytes.len().div_ceil(2));
    let mut sums = Vec::with_capacity(bytes.len());
    let mut before = 128_u8;
    for byte in even.iter().chain(odd) {
        before = before.wrapping_add(*byte).wrapping_sub(128);
        sums.push(before);
    }
    let (even, odd) = sums.split_at(even.len());
    let mut woven = Vec::with_capacity(bytes.len());
    for (at, byte) in even.iter().enumerate() {
        woven.push(*byte);
        woven.extend(odd.get(at));
    }
    woven
}

/// PXR24: by line and channel, differences in planes of bytes, the highest first; floats have lost their
/// lowest byte.
fn of_24_bits(
    compressed: &[u8],
    expected: usize,
    header: &Header,
    area: Area,
) -> Result<Vec<u8>, String> {
    let planes = |kind: Kind| match kind {
        Kind::Half => 2,
        Kind::Float => 3,
        Kind::Uint => 4,
    };
    let of_texel: usize = header.channels.iter().map(|&kind| planes(kind)).sum();
    let bytes = inflated(compressed, area.width * area.height * of_texel)?;
    let mut samples = Vec::with_capacity(expected);
    let mut rest = &bytes[..];
    for _ in 0..area.height {
        for &kind in &header.channels {
            let count = planes(kind);
            let (taken, after) = rest.split_at(area.width * count);
            rest = after;
            let mut sum = 0_u32;
            for column in 0..area.width {
                let difference = (0..count).fold(0_u32, |value, plane| {
                    value << 8 | u32::from(taken[plane * area.width + column])
                });
                let difference = if kind == Kind::Float { difference << 8 } else { difference };
                sum = sum.wrapping_add(difference);
                samples.extend_from_slice(&sum.to_le_bytes()[..kind.bytes()]);
            }
        }
    }
    Ok(samples)
}
