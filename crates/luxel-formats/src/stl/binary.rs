//! Binary STL: 80 bytes of anything, a count, and 50 bytes for each triangle, all little-endian.

use super::{Facets, check_count};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place};

/// A header and the count of triangles.
const PREFACE: usize = 84;

/// A normal, three corners, and two bytes of attributes.
const RECORD: usize = 50;

/// How long the file should be by the count it holds; `None` if it is too short to hold one.
pub(super) fn size_said(bytes: &[u8]) -> Option<u64> {
    let (_, count) = bytes.get(..PREFACE)?.split_last_chunk::<4>()?;
    Some(PREFACE as u64 + RECORD as u64 * u64::from(u32::from_le_bytes(*count)))
}

pub(super) fn read(
    bytes: &[u8],
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Facets, Error> {
    let end = Place::Byte(bytes.len() as u64);
    let Some(size) = size_said(bytes) else {
        let what = "the 84 bytes that every binary STL begins with (nor is it a text STL, which \
                    begins with `solid` and has facets)";
        return Err(Error::at(end, ErrorKind::Truncated(what.to_owned())));
    };
    let count = (size - PREFACE as u64) / RECORD as u64;
    let records = &bytes[PREFACE..];
    if size > bytes.len() as u64 {
        let whole = records.len() / RECORD;
        let what = format!("triangle {whole}: the file says it has {count}");
        return Err(Error::at(end, ErrorKind::Truncated(what)));
    }
    check_count(count, limits, Place::Byte(80))?;
    let count = count as usize;
    let surplus = bytes.len() as u64 - size;
    if surplus > 0 {
        warnings.push(format!("byte {size}: {surplus} bytes after the last triangle are ignored"));
    }
    let mut facets = Facets::with_room_for(count);
    for record in records.as_chunks::<RECORD>().0.iter().take(count) {
        let (corners, _) = record[12..48].as_chunks::<4>();
        let value = |index: usize| f32::from_le_bytes(corners[index]);
        let corner = |index: usize| [value(3 * index), value(3 * index + 1), value(3 * index + 2)];
        facets.push([corner(0), corner(1), corner(2)]);
    }
    Ok(facets)
}
