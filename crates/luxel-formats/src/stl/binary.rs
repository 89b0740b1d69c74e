//! Binary STL: 80 arbitrary bytes, a count, and 50 bytes per triangle, little-endian.

use super::{Facets, check_count};
use crate::block_reader::BlockReader;
use crate::format::declared_stl_size;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place};

/// A header and the count of triangles.
const PREFACE: usize = 84;

/// A normal, three corners, and two bytes of attributes.
const RECORD: usize = 50;

pub(super) fn read(
    bytes: &[u8],
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Facets, Error> {
    let end = Place::Byte(bytes.len() as u64);
    let Some(size) = declared_stl_size(bytes) else {
        let what = "the 84 bytes that every binary STL begins with (nor is it a text STL, which \
                    begins with `solid` and has facets)";
        return Err(Error::at(end, ErrorKind::Truncated(what.to_owned())));
    };
    let count = (size - PREFACE as u64) / RECORD as u64;
    let records = &bytes[PREFACE..];
    if size > bytes.len() as u64 {
        let whole = records.len() / RECORD;
        let what = format!("triangle {whole}: the file declares {count}");
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
        facets.push(corners(record));
    }
    Ok(facets)
}

/// Triangles of a long file per block.
const TOGETHER: u64 = 1 << 15;

/// Reads a long file without holding it in memory: reads the next block while welding the last.
/// `None` if the file isn't binary, or its size differs from what its count implies.
pub(super) fn stream(file: &BlockReader<'_>, limits: &Limits) -> Result<Option<Facets>, Error> {
    let size = file.with_block(0, PREFACE, declared_stl_size);
    file.check()?;
    if size != Some(file.length()) {
        return Ok(None);
    }
    let count = (file.length() - PREFACE as u64) / RECORD as u64;
    check_count(count, limits, Place::Byte(80))?;
    file.begin();
    let start_of = |triangle: u64| PREFACE as u64 + triangle * RECORD as u64;
    let read = |first: u64| {
        let length = count.saturating_sub(first).min(TOGETHER) as usize * RECORD;
        file.with_block(start_of(first), length, |bytes| {
            bytes.as_chunks().0.iter().map(corners).collect::<Vec<_>>()
        })
    };
    let mut facets = Facets::with_room_for(count as usize);
    let mut next = read(0);
    let mut first = 0;
    while first < count {
        file.check()?;
        file.advance_to(start_of(first));
        first += TOGETHER;
        let last = std::mem::take(&mut next);
        let weld = || facets.push_all(&last);
        (next, ()) = luxel_parallel::join(|| read(first), weld);
    }
    file.advance_to(file.length());
    file.check()?;
    Ok(Some(facets))
}

/// The corners of a triangle.
fn corners(record: &[u8; RECORD]) -> [[f32; 3]; 3] {
    let (corners, _) = record[12..48].as_chunks::<4>();
    let value = |index: usize| f32::from_le_bytes(corners[index]);
    let corner = |index: usize| [value(3 * index), value(3 * index + 1), value(3 * index + 2)];
    [corner(0), corner(1), corner(2)]
}
