//! The header: lines of words from `ply` to `end_header`.

use crate::text::{Words, integer, shown};
use crate::{Error, ErrorKind, Place};

/// The encoding of the body's values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Text,
    Little,
    Big,
}

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn from_name(name: &[u8]) -> Option<Self> {
        Some(match name {
            b"char" | b"int8" => Self::I8,
            b"uchar" | b"uint8" => Self::U8,
            b"short" | b"int16" => Self::I16,
            b"ushort" | b"uint16" => Self::U16,
            b"int" | b"int32" => Self::I32,
            b"uint" | b"uint32" => Self::U32,
            b"float" | b"float32" => Self::F32,
            b"double" | b"float64" => Self::F64,
            _ => return None,
        })
    }

    /// Bytes of a value in a binary body.
    pub(super) const fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) const fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }
}

/// One value, or a list: a count and as many values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scalar(Scalar),
    List { count: Scalar, item: Scalar },
}

#[derive(Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) kind: Kind,
}

/// A table of rows with the same properties.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    /// The line of its declaration.
    pub(super) line: u64,
}

impl Element {
    /// The index of the first scalar property with a name.
    pub(super) fn scalar(&self, name: &str) -> Option<usize> {
        self.properties
            .iter()
            .position(|property| property.name == name && matches!(property.kind, Kind::Scalar(_)))
    }

    /// The names of the properties that are not among those of these indices.
    pub(super) fn others(&self, used: &[usize]) -> impl Iterator<Item = &str> {
        let properties = self.properties.iter().enumerate();
        properties.filter(|(index, _)| !used.contains(index)).map(|(_, own)| own.name.as_str())
    }

    /// Bytes of a row in a binary body, if all rows have the same size.
    pub(super) fn stride(&self) -> Option<usize> {
        let size = |property: &Property| match property.kind {
            Kind::Scalar(scalar) => Some(scalar.size()),
            Kind::List { .. } => None,
        };
        self.properties.iter().map(size).sum()
    }
}

#[derive(Debug)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// Byte offset of the body.
    pub(super) body: usize,
    /// Lines that PLY doesn't have, each with its number. Some exporters leave out `comment`.
    pub(super) unknown: Vec<(u64, String)>,
}

/// A header with more unknown lines than these is none.
const MOST_UNKNOWN: usize = 32;

impl Header {
    pub(super) fn read(bytes: &[u8]) -> Result<Self, Error> {
        let mut lines = Lines { bytes, at: 0, number: 0 };
        if lines.next().map(<[u8]>::trim_ascii) != Some(b"ply") {
            let message = "a PLY file begins with the line `ply`".to_owned();
            return Err(Error::at(Place::Line(1), ErrorKind::Malformed(message)));
        }
        let mut encoding = None;
        let mut elements = Vec::new();
        let mut unknown = Vec::new();
        while let Some(line) = lines.next() {
            let number = lines.number;
            let wrong = |message: &str| {
                let message = format!("{message}: `{}`", shown(line.trim_ascii()));
                Error::at(Place::Line(number), ErrorKind::Malformed(message))
            };
            let mut words = Words::new(line);
            match words.next() {
                Some(b"format") => {
                    encoding = Some(match words.next() {
                        Some(b"ascii") => Encoding::Text,
                        Some(b"binary_little_endian") => Encoding::Little,
                        Some(b"binary_big_endian") => Encoding::Big,
                        _ => {
                            return Err(wrong(
                                "unknown format: PLY has ascii, binary_little_endian and binary_big_endian",
                            ));
                        }
                    });
                }
                Some(b"element") => {
                    let (name, count) = (words.next(), words.next().and_then(integer));
                    let count = count.and_then(|count| u64::try_from(count).ok());
                    let (Some(name), Some(count)) = (name, count) else {
                        return Err(wrong("an element needs a name and a count"));
                    };
                    elements.push(Element {
                        name: shown(name),
                        count,
                        properties: Vec::new(),
                        line: number,
                    });
                }
                Some(b"property") => {
                    let property = property(&mut words)
                        .ok_or_else(|| wrong("a property needs a PLY type and a name"))?;
                    let element: &mut Element =
                        elements.last_mut().ok_or_else(|| wrong("a property needs an element"))?;
                    element.properties.push(property);
                }
                Some(b"end_header") => {
                    let encoding = encoding.ok_or_else(|| {
                        wrong("the header needs a line `format` with ascii or a byte order")
                    })?;
                    return Ok(Self { encoding, elements, body: lines.at, unknown });
                }
                None | Some(b"comment" | b"obj_info") => {}
                Some(_) if unknown.len() < MOST_UNKNOWN => {
                    unknown.push((number, shown(line.trim_ascii())));
                }
                Some(_) => return Err(wrong("PLY has no such header line")),
            }
        }
        let place = Place::Line(lines.number);
        Err(Error::at(place, ErrorKind::Truncated("the header: `end_header` is missing".into())))
    }
}

fn property(words: &mut Words<'_>) -> Option<Property> {
    let kind = match words.next()? {
        b"list" => Kind::List {
            count: Scalar::from_name(words.next()?).filter(|count| !count.is_float())?,
            item: Scalar::from_name(words.next()?)?,
        },
        name => Kind::Scalar(Scalar::from_name(name)?),
    };
    Some(Property { name: shown(words.next()?), kind })
}

/// Lines that end in LF, CR LF or, in very old files, CR.
struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: u64,
}

impl<'a> Lines<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        let rest = self.bytes.get(self.at..).filter(|rest| !rest.is_empty())?;
        let end = rest.iter().position(|&byte| byte == b'\n' || byte == b'\r');
        let end = end.unwrap_or(rest.len());
        let ending = match rest[end..] {
            [b'\r', b'\n', ..] => 2,
            [] => 0,
            _ => 1,
        };
        self.at += end + ending;
        self.number += 1;
        Some(&rest[..end])
    }
}
