//! The body: values one after the other, from text or bytes.

use super::header::{Element, Kind, Scalar};
use crate::text::{integer, is_blank, line_of, number, shown, single};
use crate::{Error, ErrorKind, Place};

/// Where values come from.
pub(super) trait Source {
    /// Whether rows without lists all take the same number of bytes.
    const IS_BINARY: bool;

    /// The next value. All types fit into f64.
    fn scalar(&mut self, scalar: Scalar) -> Result<f64, Fault>;

    /// How many bytes haven't been read.
    fn bytes_left(&self) -> usize;

    /// How many bytes the whole file has.
    fn length(&self) -> u64;

    /// Leaves bytes aside; only in binary bodies does their number mean something.
    fn skip_bytes(&mut self, count: usize);

    /// The next bytes; empty for text.
    fn bytes(&self) -> &[u8];

    /// Where the last value was.
    fn place(&self) -> Place;

    /// The least bytes that a row takes.
    fn least_bytes(element: &Element) -> u64;

    /// A value from the bytes of a row.
    fn decode(bytes: &[u8], scalar: Scalar) -> f64;
}

/// What can be wrong with a value.
pub(super) enum Fault {
    End,
    NotANumber(String),
}

/// A row: its values by property, and the items of one of its lists.
#[derive(Default)]
pub(super) struct Row {
    /// 0 for lists.
    pub(super) values: Vec<f64>,
    pub(super) items: Vec<f64>,
}

/// Reads an element's rows one by one; the items of the property `list` are kept, those of other
/// lists are skipped.
pub(super) fn each_row<S: Source>(
    element: &Element,
    source: &mut S,
    list: Option<usize>,
    mut visit: impl FnMut(&S, &Row) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut row = Row::default();
    if element.properties.is_empty() {
        return Ok(());
    }
    for number in 0..element.count {
        row.values.clear();
        for (index, property) in element.properties.iter().enumerate() {
            let read = match property.kind {
                Kind::Scalar(scalar) => source.scalar(scalar),
                Kind::List { count, item } if Some(index) == list => {
                    read_list(source, count, item, &mut row.items)
                }
                Kind::List { count, item } => skip_list(source, count, item),
            };
            row.values.push(read.map_err(|fault| explain(fault, element, number, source))?);
        }
        visit(source, &row)?;
    }
    Ok(())
}

fn read_list<S: Source>(
    source: &mut S,
    count: Scalar,
    item: Scalar,
    items: &mut Vec<f64>,
) -> Result<f64, Fault> {
    items.clear();
    let count = list_length(source, count)?;
    for _ in 0..count {
        items.push(source.scalar(item)?);
    }
    Ok(0.0)
}

fn skip_list<S: Source>(source: &mut S, count: Scalar, item: Scalar) -> Result<f64, Fault> {
    for _ in 0..list_length(source, count)? {
        source.scalar(item)?;
    }
    Ok(0.0)
}

fn list_length<S: Source>(source: &mut S, count: Scalar) -> Result<u64, Fault> {
    let count = source.scalar(count)?;
    // Items take at least a byte each, so a length that lies runs into the file's end.
    if count >= 0.0 && count.fract() == 0.0 {
        Ok(count as u64)
    } else {
        Err(Fault::NotANumber(format!("a list can't have {count} items")))
    }
}

#[cold]
fn explain<S: Source>(fault: Fault, element: &Element, row: u64, source: &S) -> Error {
    let name = &element.name;
    let kind = match fault {
        Fault::End => ErrorKind::Truncated(format!(
            "row {row} of element `{name}`, which says it has {}",
            element.count
        )),
        Fault::NotANumber(message) => {
            ErrorKind::Malformed(format!("row {row} of element `{name}`: {message}"))
        }
    };
    Error::at(source.place(), kind)
}

/// A text body: words apart by blanks, wherever lines end.
pub(super) struct Text<'a> {
    file: &'a [u8],
    at: usize,
}

impl<'a> Text<'a> {
    pub(super) const fn new(file: &'a [u8], body: usize) -> Self {
        Self { file, at: body }
    }
}

impl Source for Text<'_> {
    const IS_BINARY: bool = false;

    #[inline]
    fn scalar(&mut self, scalar: Scalar) -> Result<f64, Fault> {
        let rest = &self.file[self.at..];
        let start = rest.iter().position(|&byte| !is_blank(byte)).ok_or(Fault::End)?;
        let rest = &rest[start..];
        let end = rest.iter().position(|&byte| is_blank(byte)).unwrap_or(rest.len());
        let word = &rest[..end];
        self.at += start + end;
        let value = match scalar {
            Scalar::F32 => single(word).map(f64::from),
            Scalar::F64 => number(word),
            _ => integer(word).map(|value| value as f64).or_else(|| number(word)),
        };
        value.ok_or_else(|| Fault::NotANumber(format!("`{}` is no number", shown(word))))
    }

    fn bytes_left(&self) -> usize {
        self.file.len() - self.at
    }

    fn length(&self) -> u64 {
        self.file.len() as u64
    }

    fn skip_bytes(&mut self, _: usize) {}

    fn bytes(&self) -> &[u8] {
        &[]
    }

    fn place(&self) -> Place {
        Place::Line(line_of(self.file, self.at.saturating_sub(1)))
    }

    /// A digit for each value, and a blank between two; the last one may be missing.
    fn least_bytes(element: &Element) -> u64 {
        (element.properties.len() as u64 * 2).saturating_sub(1)
    }

    fn decode(_: &[u8], _: Scalar) -> f64 {
        0.0
    }
}

/// A binary body.
pub(super) struct Binary<'a, const BIG_ENDIAN: bool> {
    file: &'a [u8],
    at: usize,
}

impl<'a, const BIG_ENDIAN: bool> Binary<'a, BIG_ENDIAN> {
    pub(super) const fn new(file: &'a [u8], body: usize) -> Self {
        Self { file, at: body }
    }
}

impl<const BIG_ENDIAN: bool> Source for Binary<'_, BIG_ENDIAN> {
    const IS_BINARY: bool = true;

    #[inline]
    fn scalar(&mut self, scalar: Scalar) -> Result<f64, Fault> {
        let end = self.at + scalar.size();
        let Some(bytes) = self.file.get(self.at..end) else {
            self.at = self.file.len();
            return Err(Fault::End);
        };
        self.at = end;
        Ok(Self::decode(bytes, scalar))
    }

    fn bytes_left(&self) -> usize {
        self.file.len() - self.at
    }

    fn length(&self) -> u64 {
        self.file.len() as u64
    }

    fn skip_bytes(&mut self, count: usize) {
        self.at = self.at.saturating_add(count).min(self.file.len());
    }

    fn bytes(&self) -> &[u8] {
        &self.file[self.at..]
    }

    fn place(&self) -> Place {
        Place::Byte(self.at as u64)
    }

    fn least_bytes(element: &Element) -> u64 {
        let least = |kind: Kind| match kind {
            Kind::Scalar(scalar) | Kind::List { count: scalar, .. } => scalar.size() as u64,
        };
        element.properties.iter().map(|property| least(property.kind)).sum()
    }

    /// `bytes` has the scalar's size at least; otherwise the value is 0.
    #[inline]
    fn decode(bytes: &[u8], scalar: Scalar) -> f64 {
        fn first<const N: usize, const BIG_ENDIAN: bool>(bytes: &[u8]) -> [u8; N] {
            let mut value = bytes.first_chunk::<N>().copied().unwrap_or([0; N]);
            if BIG_ENDIAN {
                value.reverse();
            }
            value
        }
        match scalar {
            Scalar::I8 => f64::from(i8::from_le_bytes(first::<1, BIG_ENDIAN>(bytes))),
            Scalar::U8 => f64::from(u8::from_le_bytes(first::<1, BIG_ENDIAN>(bytes))),
            Scalar::I16 => f64::from(i16::from_le_bytes(first::<2, BIG_ENDIAN>(bytes))),
            Scalar::U16 => f64::from(u16::from_le_bytes(first::<2, BIG_ENDIAN>(bytes))),
            Scalar::I32 => f64::from(i32::from_le_bytes(first::<4, BIG_ENDIAN>(bytes))),
            Scalar::U32 => f64::from(u32::from_le_bytes(first::<4, BIG_ENDIAN>(bytes))),
            Scalar::F32 => f64::from(f32::from_le_bytes(first::<4, BIG_ENDIAN>(bytes))),
            Scalar::F64 => f64::from_le_bytes(first::<8, BIG_ENDIAN>(bytes)),
        }
    }
}
