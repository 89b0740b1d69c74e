//! From lines to statements.

use super::document::{Beginning, Document, Element, Kind, NONE};
use crate::direction::unit;
use crate::text::{Words, integer, number, shown, single};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place, color};
use luxel_scene::NormalFault;
use std::borrow::Cow;
use std::collections::HashMap;

/// After how many lines memory is compared with the limit.
const LINES_BETWEEN_CHECKS: u64 = 1 << 14;

/// Statements of free-form curves and surfaces, and of display, which no picture here shows.
const LEFT_OUT: [&[u8]; 17] = [
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim",
    b"hole", b"scrv", b"sp", b"end", b"con", b"call", b"csh",
];

/// Statements that change nothing that is shown.
const SILENT: [&[u8]; 11] = [
    b"mg",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"maplib",
    b"usemap",
];

/// Reads a file's statements.
pub(super) fn parse<'a>(
    bytes: &'a [u8],
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Document<'a>, Error> {
    let mut parser = Parser {
        document: Document::default(),
        material_numbers: HashMap::new(),
        material: NONE,
        smoothing: 0,
        highest: [(0, 0); 3],
        understood: 0,
        unknown: None,
        free_form: None,
        line: 0,
    };
    let mut lines = Lines::new(bytes);
    while let Some(line) = lines.next() {
        parser.line = lines.number;
        match line {
            Cow::Borrowed(line) => parser.statement(line, Some(line))?,
            Cow::Owned(line) => parser.statement(&line, None)?,
        }
        if lines.number.is_multiple_of(LINES_BETWEEN_CHECKS) {
            limits.check("the model", parser.document.bytes(), 1, Place::Line(lines.number))?;
        }
    }
    parser.finish(limits, warnings)
}

struct Parser<'a> {
    document: Document<'a>,
    material_numbers: HashMap<&'a [u8], u32>,
    material: u32,
    smoothing: u32,
    /// The highest index that refers to something further down, for each kind, with its line.
    highest: [(i64, u64); 3],
    understood: u64,
    /// The first statement that isn't known, and the first one that isn't drawn.
    unknown: Option<(u64, String)>,
    free_form: Option<u64>,
    line: u64,
}

const WHATS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

impl<'a> Parser<'a> {
    /// `lasting` is the line if it lies in the file as it is: names are taken from there.
    fn statement(&mut self, line: &[u8], lasting: Option<&'a [u8]>) -> Result<(), Error> {
        let mut words = Words::new(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        let name =
            || lasting.map_or(&[][..], |line| line[line.len() - words.unread()..].trim_ascii());
        match keyword {
            b"v" => self.position(words)?,
            b"vt" => {
                let [u, v] = self.values(&mut words, 1)?;
                self.document.uvs.push([finite(u), 1.0 - finite(v)]);
            }
            b"vn" => {
                let normal = self.values(&mut words, 3)?;
                let number = self.document.normals.len() as u32;
                self.document.normal_faults.extend(NormalFault::of(number, normal));
                self.document.normals.push(unit(normal));
            }
            b"f" | b"fo" => self.element(Kind::Face, words)?,
            b"l" => self.element(Kind::Line, words)?,
            b"p" => self.element(Kind::Points, words)?,
            b"o" | b"g" => {
                let element = self.document.elements.len() as u32;
                let is_object = keyword == b"o";
                let name = name();
                self.document.beginnings.push(Beginning { is_object, name, element });
            }
            b"s" => {
                self.document.has_smoothing = true;
                self.smoothing = match words.next() {
                    Some(b"on") => 1,
                    Some(word) => integer(word).and_then(|n| u32::try_from(n).ok()).unwrap_or(0),
                    None => 0,
                };
            }
            b"usemtl" => {
                let next = self.document.materials.len() as u32;
                let name = name();
                self.material = *self.material_numbers.entry(name).or_insert(next);
                if self.material == next {
                    self.document.materials.push(name);
                }
            }
            b"mtllib" => self.document.libraries.push(name()),
            [b'#', ..] => return Ok(()),
            _ if SILENT.contains(&keyword) => {}
            _ if LEFT_OUT.contains(&keyword) => {
                self.free_form.get_or_insert(self.line);
            }
            _ => {
                self.unknown.get_or_insert_with(|| (self.line, shown(keyword)));
                return Ok(());
            }
        }
        self.understood += 1;
        Ok(())
    }

    /// Up to N numbers, at least so many, the others 0.
    fn values<const N: usize>(
        &self,
        words: &mut Words<'_>,
        at_least: usize,
    ) -> Result<[f32; N], Error> {
        let mut values = [0.0; N];
        for (index, value) in values.iter_mut().enumerate() {
            match words.next() {
                Some(word) => *value = single(word).ok_or_else(|| self.no_number(word))?,
                None if index < at_least => return Err(self.too_few(at_least)),
                None => break,
            }
        }
        Ok(values)
    }

    /// `v x y z`, `v x y z w`, `v x y z r g b` or `v x y z w r g b`; the weight means something
    /// for free-form surfaces only.
    fn position(&mut self, words: Words<'_>) -> Result<(), Error> {
        let mut values = [0.0_f64; 7];
        let mut count = 0;
        for word in words.take(7) {
            values[count] = number(word).ok_or_else(|| self.no_number(word))?;
            count += 1;
        }
        if count < 3 {
            return Err(self.too_few(3));
        }
        let document = &mut self.document;
        if count >= 6 {
            document.colors.resize(document.positions.len(), [f32::NAN; 3]);
            let rgb = [values[count - 3], values[count - 2], values[count - 1]];
            document.colors.push(rgb.map(color::linear));
        } else if !document.colors.is_empty() {
            document.colors.push([f32::NAN; 3]);
        }
        document.positions.push([values[0], values[1], values[2]]);
        Ok(())
    }

    fn element(&mut self, kind: Kind, words: Words<'_>) -> Result<(), Error> {
        for word in words {
            let corner = self.corner(word)?;
            self.document.corners.push(corner);
        }
        let Ok(end) = u32::try_from(self.document.corners.len()) else {
            let message = "more corners than 32 bits can number".to_owned();
            return Err(Error::at(Place::Line(self.line), ErrorKind::Unsupported(message)));
        };
        let element = Element { kind, end, material: self.material, smoothing: self.smoothing };
        self.document.elements.push(element);
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&mut self, word: &[u8]) -> Result<[u32; 3], Error> {
        let counts =
            [self.document.positions.len(), self.document.uvs.len(), self.document.normals.len()];
        let mut corner = [NONE; 3];
        let mut parts = word.split(|&byte| byte == b'/');
        for (kind, index) in corner.iter_mut().enumerate() {
            match parts.next() {
                None => break,
                Some([]) if kind > 0 => {}
                Some(part) => {
                    let number = integer(part).ok_or_else(|| self.no_index(word))?;
                    *index = self.resolve(kind, number, counts[kind])?;
                }
            }
        }
        Ok(corner)
    }

    /// From an index as the file counts, from 1, or from the last one backwards, to one from 0.
    fn resolve(&mut self, kind: usize, number: i64, count: usize) -> Result<u32, Error> {
        let count = count as i64;
        let index = if number < 0 { count + number } else { number - 1 };
        if index < 0 || index >= i64::from(NONE) {
            return Err(out_of_range(kind, number, count as u64, self.line));
        }
        if index >= count && index >= self.highest[kind].0 {
            self.highest[kind] = (index + 1, self.line);
        }
        Ok(index as u32)
    }

    fn finish(self, limits: &Limits, warnings: &mut Warnings) -> Result<Document<'a>, Error> {
        let document = self.document;
        let counts = [document.positions.len(), document.uvs.len(), document.normals.len()];
        for (kind, (&count, (number, line))) in counts.iter().zip(self.highest).enumerate() {
            if number > count as i64 {
                return Err(out_of_range(kind, number, count as u64, line));
            }
        }
        if let Some((line, word)) = self.unknown {
            if self.understood == 0 {
                let message = format!("`{word}` is no statement of OBJ, nor is any other line");
                return Err(Error::at(Place::Line(line), ErrorKind::Malformed(message)));
            }
            warnings
                .push(format!("line {line}: `{word}` is no statement of OBJ: such are ignored"));
        }
        if let Some(line) = self.free_form {
            let what = "free-form curves and surfaces are left out: convert them to polygons";
            warnings.push(format!("line {line}: {what}"));
        }
        limits.check("the model", document.bytes(), 1, Place::File)?;
        Ok(document)
    }

    #[cold]
    fn no_number(&self, word: &[u8]) -> Error {
        self.malformed(format!("`{}` is no number", shown(word)))
    }

    #[cold]
    fn no_index(&self, word: &[u8]) -> Error {
        self.malformed(format!("`{}` is no corner: write v, v/vt, v//vn or v/vt/vn", shown(word)))
    }

    #[cold]
    fn too_few(&self, at_least: usize) -> Error {
        self.malformed(format!("the statement needs at least {at_least} numbers"))
    }

    fn malformed(&self, message: String) -> Error {
        Error::at(Place::Line(self.line), ErrorKind::Malformed(message))
    }
}

fn finite(value: f32) -> f32 {
    if value.is_finite() { value } else { 0.0 }
}

#[cold]
fn out_of_range(kind: usize, index: i64, count: u64, line: u64) -> Error {
    Error::at(Place::Line(line), ErrorKind::OutOfRange { what: WHATS[kind], index, count })
}

/// Lines, those that end in a backslash joined with what follows.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    /// What ends a line: LF, perhaps after CR; in very old files CR alone.
    end: u8,
    /// The number of the last line given, its first if it was joined.
    pub(super) number: u64,
    next_number: u64,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let end = if rest.contains(&b'\n') { b'\n' } else { b'\r' };
        Self { rest, end, number: 0, next_number: 1 }
    }

    pub(super) fn next(&mut self) -> Option<Cow<'a, [u8]>> {
        self.number = self.next_number;
        let line = self.physical()?;
        if line.last() != Some(&b'\\') || line.first() == Some(&b'#') {
            return Some(Cow::Borrowed(line));
        }
        let mut joined = line.to_vec();
        while joined.pop_if(|byte| *byte == b'\\').is_some() {
            joined.push(b' ');
            joined.extend(self.physical().unwrap_or_default());
        }
        Some(Cow::Owned(joined))
    }

    fn physical(&mut self) -> Option<&'a [u8]> {
        if self.rest.is_empty() {
            return None;
        }
        let end = self.rest.iter().position(|&byte| byte == self.end);
        let (line, rest) = self.rest.split_at(end.unwrap_or(self.rest.len()));
        self.rest = rest.get(1..).unwrap_or_default();
        self.next_number += 1;
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }
}
