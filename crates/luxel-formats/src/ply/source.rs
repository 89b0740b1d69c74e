//! The body: values one after the other, from text or bytes.

use super::header::{Element, Encoding, Kind, Scalar};
use super::vertices::Column;
use crate::block_reader::BlockReader;
use crate::text::{integer, is_blank, line_of, number, shown, single};
use crate::{Error, ErrorKind, Place};
use luxel_parallel::each;

/// The source of the values.
pub(super) struct Source<'a> {
    /// The whole file, or its beginning.
    file: &'a [u8],
    /// The rest of the file, if `file` is only its beginning; then only tables can be read.
    reader: Option<&'a BlockReader<'a>>,
    at: usize,
    encoding: Encoding,
}

/// The fault of a value.
pub(super) enum Fault {
    End,
    NotANumber(String),
}

/// A row: its values by property, and the items of one list.
#[derive(Default)]
pub(super) struct Row {
    /// 0 for lists.
    pub(super) values: Vec<f64>,
    pub(super) items: Vec<f64>,
}

/// Reads an element's rows one by one; collects the items of the property `list` and skips
/// other lists.
pub(super) fn each_row(
    element: &Element,
    source: &mut Source<'_>,
    list: Option<usize>,
    mut visit: impl FnMut(&Source<'_>, &Row) -> Result<(), Error>,
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

fn read_list(
    source: &mut Source<'_>,
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

fn skip_list(source: &mut Source<'_>, count: Scalar, item: Scalar) -> Result<f64, Fault> {
    for _ in 0..list_length(source, count)? {
        source.scalar(item)?;
    }
    Ok(0.0)
}

fn list_length(source: &mut Source<'_>, count: Scalar) -> Result<u64, Fault> {
    let count = source.scalar(count)?;
    // Items take at least a byte each, so a false length runs into the end of the file.
    if count >= 0.0 && count.fract() == 0.0 {
        Ok(count as u64)
    } else {
        Err(Fault::NotANumber(format!("a list can't have {count} items")))
    }
}

#[cold]
fn explain(fault: Fault, element: &Element, row: u64, source: &Source<'_>) -> Error {
    let name = &element.name;
    let kind = match fault {
        Fault::End => ErrorKind::Truncated(format!(
            "row {row} of element `{name}`, which declares {}",
            element.count
        )),
        Fault::NotANumber(message) => {
            ErrorKind::Malformed(format!("row {row} of element `{name}`: {message}"))
        }
    };
    Error::at(source.place(), kind)
}

impl<'a> Source<'a> {
    /// `body` is the byte offset of the values in the file.
    pub(super) const fn new(file: &'a [u8], body: usize, encoding: Encoding) -> Self {
        Self { file, reader: None, at: body, encoding }
    }

    /// Streams a file that isn't in memory: tables only.
    pub(super) const fn streamed(
        reader: &'a BlockReader<'a>,
        body: usize,
        encoding: Encoding,
    ) -> Self {
        Self { file: &[], reader: Some(reader), at: body, encoding }
    }

    pub(super) const fn is_streamed(&self) -> bool {
        self.reader.is_some()
    }

    /// The next value. `f64` represents all types exactly.
    #[inline]
    fn scalar(&mut self, scalar: Scalar) -> Result<f64, Fault> {
        match self.encoding {
            Encoding::Text => self.word(scalar),
            order => {
                let end = self.at + scalar.size();
                let Some(bytes) = self.file.get(self.at..end) else {
                    self.at = self.file.len();
                    return Err(Fault::End);
                };
                self.at = end;
                Ok(decode(bytes, scalar, order))
            }
        }
    }

    /// The next word; any whitespace separates words.
    fn word(&mut self, scalar: Scalar) -> Result<f64, Fault> {
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
        value.ok_or_else(|| Fault::NotANumber(format!("`{}` is not a number", shown(word))))
    }

    /// The number of unread bytes.
    pub(super) fn bytes_left(&self) -> u64 {
        self.length().saturating_sub(self.at as u64)
    }

    /// The size of the whole file in bytes.
    pub(super) fn length(&self) -> u64 {
        self.reader.map_or(self.file.len() as u64, BlockReader::length)
    }

    /// The place of the last value.
    pub(super) fn place(&self) -> Place {
        match self.encoding {
            Encoding::Text => Place::Line(line_of(self.file, self.at.saturating_sub(1))),
            _ => Place::Byte(self.at as u64),
        }
    }

    /// The minimum bytes of a row: in text, a digit per value and a blank between two;
    /// the last blank may be missing.
    pub(super) fn least_bytes(&self, element: &Element) -> u64 {
        let least = |kind: Kind| match kind {
            Kind::Scalar(scalar) | Kind::List { count: scalar, .. } => scalar.size() as u64,
        };
        match self.encoding {
            Encoding::Text => (element.properties.len() as u64 * 2).saturating_sub(1),
            _ => element.properties.iter().map(|property| least(property.kind)).sum(),
        }
    }

    /// The next `count` rows of `stride` bytes each; `None` for text and for a shorter file.
    pub(super) fn table(&self, count: u64, stride: usize) -> Option<Table<'a>> {
        let count = usize::try_from(count).ok()?;
        let size = stride.checked_mul(count)?;
        if self.encoding == Encoding::Text || stride == 0 || size as u64 > self.bytes_left() {
            return None;
        }
        let bytes = match self.reader {
            Some(reader) => Bytes::Stream(reader, self.at as u64),
            None => Bytes::Here(self.file.get(self.at..self.at + size)?),
        };
        Some(Table { bytes, count, stride, order: self.encoding })
    }

    /// Skips a table.
    pub(super) fn skip(&mut self, table: &Table<'_>) {
        self.at += table.count * table.stride;
        if let Some(reader) = self.reader {
            reader.advance_to(self.at as u64);
        }
    }
}

/// Rows per task.
pub(super) const RUN: usize = 1 << 12;

/// Binary rows of a fixed size.
pub(super) struct Table<'a> {
    bytes: Bytes<'a>,
    count: usize,
    stride: usize,
    order: Encoding,
}

/// Bytes in memory, or bytes of a file from an offset.
enum Bytes<'a> {
    Here(&'a [u8]),
    Stream(&'a BlockReader<'a>, u64),
}

impl Table<'_> {
    /// Decodes each row in parallel.
    pub(super) fn read<T: Clone + Send>(
        &self,
        nothing: T,
        of_row: impl Fn(&[u8]) -> T + Sync,
    ) -> Vec<T> {
        self.read_two((nothing, ()), |row| (of_row(row), ())).0
    }

    /// Like [`Table::read`], with two lists at once.
    pub(super) fn read_two<A: Clone + Send, B: Clone + Send>(
        &self,
        (nothing, none): (A, B),
        of_row: impl Fn(&[u8]) -> (A, B) + Sync,
    ) -> (Vec<A>, Vec<B>) {
        let (mut first, mut second) = (vec![nothing; self.count], vec![none; self.count]);
        let runs = first.chunks_mut(RUN).zip(second.chunks_mut(RUN)).enumerate();
        each(runs, &|(run, (first, second))| {
            self.with_rows(run * RUN, first.len(), |rows| {
                let values = first.iter_mut().zip(second);
                for ((first, second), row) in values.zip(rows.chunks_exact(self.stride)) {
                    (*first, *second) = of_row(row);
                }
            });
        });
        (first, second)
    }

    /// Calls a function with the bytes of some rows; with none if they can't be read.
    fn with_rows<R>(&self, start: usize, count: usize, look: impl FnOnce(&[u8]) -> R) -> R {
        let (at, size) = (self.row_at(start), count * self.stride);
        match self.bytes {
            Bytes::Here(bytes) => look(&bytes[at..at + size]),
            Bytes::Stream(reader, first) => reader.with_block(first + at as u64, size, look),
        }
    }

    /// The given columns of each row, in single precision.
    pub(super) fn singles<const N: usize>(&self, columns: [Column; N]) -> Vec<[f32; N]> {
        if self.has_words_of(Scalar::F32, &columns.map(|column| column.scalar)) {
            return self.read([0.0; N], |row| singles_of(row, columns));
        }
        self.read([0.0; N], |row| {
            let value = |column: Column| self.value(row, column.offset, column.scalar);
            columns.map(|column| value(column) as f32)
        })
    }

    /// Two sets of columns, in one pass if both are stored in single precision.
    pub(super) fn singles_of_two(
        &self,
        columns: [[Column; 3]; 2],
    ) -> (Vec<[f32; 3]>, Vec<[f32; 3]>) {
        let [first, second] = columns;
        let scalars = columns.as_flattened().iter().map(|column| column.scalar);
        if self.has_words_of(Scalar::F32, &scalars.collect::<Vec<_>>()) {
            let of_row = |row: &[u8]| (singles_of(row, first), singles_of(row, second));
            return self.read_two(([0.0; 3], [0.0; 3]), of_row);
        }
        (self.singles(first), self.singles(second))
    }

    /// Whether these values can be copied from rows without conversion.
    pub(super) fn has_words_of(&self, scalar: Scalar, scalars: &[Scalar]) -> bool {
        self.order == Encoding::Little && scalars.iter().all(|&other| other == scalar)
    }

    /// Byte offset of a row in the table.
    pub(super) const fn row_at(&self, row: usize) -> usize {
        row * self.stride
    }

    /// Calls a function with the bytes of one row.
    pub(super) fn with_row<R>(&self, row: usize, look: impl FnOnce(&[u8]) -> R) -> R {
        self.with_rows(row, 1, look)
    }

    /// The value at a place in a row.
    pub(super) fn value(&self, row: &[u8], offset: usize, scalar: Scalar) -> f64 {
        decode(row.get(offset..).unwrap_or_default(), scalar, self.order)
    }
}

/// Columns of a row stored in single precision, little-endian.
#[inline]
fn singles_of<const N: usize>(row: &[u8], columns: [Column; N]) -> [f32; N] {
    columns.map(|column| f32::from_le_bytes(word(row, column.offset)))
}

/// Four bytes of a row.
#[inline]
pub(super) fn word(row: &[u8], at: usize) -> [u8; 4] {
    row.get(at..).and_then(<[u8]>::first_chunk).copied().unwrap_or_default()
}

/// The value is 0 if `bytes` is shorter than the scalar.
#[inline]
fn decode(bytes: &[u8], scalar: Scalar, order: Encoding) -> f64 {
    fn first<const N: usize>(bytes: &[u8], order: Encoding) -> [u8; N] {
        let mut value = bytes.first_chunk::<N>().copied().unwrap_or([0; N]);
        if order == Encoding::Big {
            value.reverse();
        }
        value
    }
    match scalar {
        Scalar::I8 => f64::from(i8::from_le_bytes(first(bytes, order))),
        Scalar::U8 => f64::from(u8::from_le_bytes(first(bytes, order))),
        Scalar::I16 => f64::from(i16::from_le_bytes(first(bytes, order))),
        Scalar::U16 => f64::from(u16::from_le_bytes(first(bytes, order))),
        Scalar::I32 => f64::from(i32::from_le_bytes(first(bytes, order))),
        Scalar::U32 => f64::from(u32::from_le_bytes(first(bytes, order))),
        Scalar::F32 => f64::from(f32::from_le_bytes(first(bytes, order))),
        Scalar::F64 => f64::from_le_bytes(first(bytes, order)),
    }
}
