//! Parses blocks of lines in parallel. A block depends on earlier ones only by the state at its
//! start, mostly the number of vertices, which is added when blocks are [joined](super::join).

use super::document::{Beginning, Document, Element, Kind, NONE};
use super::lines::Lines;
use crate::direction::unit;
use crate::text::{Words, integer, number, shown, single};
use crate::{Error, ErrorKind, Limits, Place, color};
use luxel_scene::NormalFault;
use std::borrow::Cow;
use std::collections::HashMap;

/// Memory is checked against the limit once in so many lines.
const LINES_BETWEEN_CHECKS: u64 = 1 << 14;

/// Statements of free-form curves and surfaces, which luxel doesn't render.
const LEFT_OUT: [&[u8]; 17] = [
    b"vp", b"cstype", b"deg", b"bmat", b"step", b"curv", b"curv2", b"surf", b"parm", b"trim",
    b"hole", b"scrv", b"sp", b"end", b"con", b"call", b"csh",
];

/// Statements without effect on the image.
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

/// The parsed statements of a block.
pub(super) struct Block<'a> {
    /// Indices of corners, materials and elements count from the start of the block; so do lines.
    pub(super) document: Document<'a>,
    /// The number of leading elements that inherit the material, and the smoothing group, of the
    /// previous blocks; all, if the block sets none.
    pub(super) inherits: [Option<usize>; 2],
    /// The material and the smoothing group at the end, if the block sets any.
    pub(super) leaves: [u32; 2],
    /// The highest index of each kind in a corner, counted from 1, with its line.
    pub(super) highest: [(i64, u64); 3],
    pub(super) understood: u64,
    /// The first unknown statement, and the first one that isn't rendered.
    pub(super) unknown: Option<(u64, String)>,
    pub(super) free_form: Option<u64>,
    pub(super) lines: u64,
}

/// The result of parsing a block.
pub(super) struct Parsed<'a> {
    pub(super) block: Result<Block<'a>, Error>,
    /// Whether the result depends on the counts of the blocks before.
    pub(super) asks_before: bool,
}

/// Parses a block's statements. `before` is the number of vertices, texture coordinates and normals
/// before it, if known.
pub(super) fn parse<'a>(
    mut lines: Lines<'a>,
    limits: &Limits,
    before: Option<[usize; 3]>,
) -> Parsed<'a> {
    let mut parser = Parser {
        block: Block {
            document: Document::default(),
            inherits: [None; 2],
            leaves: [NONE, 0],
            highest: [(0, 0); 3],
            understood: 0,
            unknown: None,
            free_form: None,
            lines: 0,
        },
        material_numbers: HashMap::new(),
        before,
        asks_before: false,
        line: 0,
    };
    let done = parser.statements(&mut lines, limits);
    let Parser { mut block, asks_before, .. } = parser;
    block.lines = lines.given();
    Parsed { block: done.map(|()| block), asks_before }
}

struct Parser<'a> {
    block: Block<'a>,
    material_numbers: HashMap<&'a [u8], u32>,
    before: Option<[usize; 3]>,
    asks_before: bool,
    line: u64,
}

const WHATS: [&str; 3] = ["vertex", "texture coordinate", "normal"];

impl<'a> Parser<'a> {
    fn statements(&mut self, lines: &mut Lines<'a>, limits: &Limits) -> Result<(), Error> {
        while let Some(line) = lines.next() {
            self.line = lines.number;
            match line {
                Cow::Borrowed(line) => self.statement(line, Some(line))?,
                Cow::Owned(line) => self.statement(&line, None)?,
            }
            if lines.number.is_multiple_of(LINES_BETWEEN_CHECKS) {
                let bytes = self.block.document.bytes();
                limits.check("the model", bytes, 1, Place::Line(lines.number))?;
            }
        }
        Ok(())
    }

    /// `lasting` is the line if it is contiguous in the file: names borrow from it.
    fn statement(&mut self, line: &[u8], lasting: Option<&'a [u8]>) -> Result<(), Error> {
        let mut words = Words::new(line);
        let Some(keyword) = words.next() else { return Ok(()) };
        let name =
            || lasting.map_or(&[][..], |line| line[line.len() - words.unread()..].trim_ascii());
        let document = &mut self.block.document;
        match keyword {
            b"v" => self.position(words)?,
            b"vt" => {
                let [u, v] = self.values(&mut words, 1)?;
                self.block.document.uvs.push([finite(u), 1.0 - finite(v)]);
            }
            b"vn" => {
                let normal = self.values(&mut words, 3)?;
                let document = &mut self.block.document;
                let number = document.normals.len() as u32;
                document.normal_faults.extend(NormalFault::of(number, normal));
                document.normals.push(unit(normal));
            }
            b"f" | b"fo" => self.element(Kind::Face, words)?,
            b"l" => self.element(Kind::Line, words)?,
            b"p" => self.element(Kind::Points, words)?,
            b"o" | b"g" => {
                let element = document.elements.len() as u32;
                let is_object = keyword == b"o";
                let name = name();
                document.beginnings.push(Beginning { is_object, name, element });
            }
            b"s" => {
                document.has_smoothing = true;
                let elements = document.elements.len();
                let [_, smoothing] = &mut self.block.inherits;
                smoothing.get_or_insert(elements);
                self.block.leaves[1] = match words.next() {
                    Some(b"on") => 1,
                    Some(word) => integer(word).and_then(|n| u32::try_from(n).ok()).unwrap_or(0),
                    None => 0,
                };
            }
            b"usemtl" => {
                let elements = document.elements.len();
                let [material, _] = &mut self.block.inherits;
                material.get_or_insert(elements);
                let next = document.materials.len() as u32;
                let name = name();
                let number = *self.material_numbers.entry(name).or_insert(next);
                self.block.leaves[0] = number;
                if number == next {
                    document.materials.push(name);
                }
            }
            b"mtllib" => document.libraries.push(name()),
            [b'#', ..] => return Ok(()),
            _ if SILENT.contains(&keyword) => {}
            _ if LEFT_OUT.contains(&keyword) => {
                self.block.free_form.get_or_insert(self.line);
            }
            _ => {
                self.block.unknown.get_or_insert_with(|| (self.line, shown(keyword)));
                return Ok(());
            }
        }
        self.block.understood += 1;
        Ok(())
    }

    /// Up to `N` numbers, at least `at_least`, the others 0.
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

    /// `v x y z`, `v x y z w`, `v x y z r g b` or `v x y z w r g b`; the weight matters
    /// to free-form surfaces only.
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
        let document = &mut self.block.document;
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
            self.block.document.corners.push(corner);
        }
        let document = &mut self.block.document;
        let Ok(end) = u32::try_from(document.corners.len()) else {
            return Err(too_many_corners(self.line));
        };
        let [material, smoothing] = self.block.leaves;
        document.elements.push(Element { kind, end, material, smoothing });
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn corner(&mut self, word: &[u8]) -> Result<[u32; 3], Error> {
        let mut corner = [NONE; 3];
        let mut parts = word.split(|&byte| byte == b'/');
        for (kind, index) in corner.iter_mut().enumerate() {
            match parts.next() {
                None => break,
                Some([]) if kind > 0 => {}
                Some(part) => {
                    let number = integer(part).ok_or_else(|| self.no_index(word))?;
                    *index = self.resolve(kind, number)?;
                }
            }
        }
        Ok(corner)
    }

    /// Converts an index of the file, from 1 or, if negative, from the end, to one from 0.
    fn resolve(&mut self, kind: usize, number: i64) -> Result<u32, Error> {
        if number > 0 && number <= i64::from(NONE) {
            if number > self.block.highest[kind].0 {
                self.block.highest[kind] = (number, self.line);
            }
            return Ok((number - 1) as u32);
        }
        let Some(before) = self.before else {
            self.asks_before = true;
            return Ok(NONE);
        };
        let count = (before[kind] + self.block.document.counts()[kind]) as i64;
        match u32::try_from(count + number) {
            Ok(index) if number < 0 && index < NONE => Ok(index),
            _ => Err(out_of_range(kind, number, count as u64, self.line)),
        }
    }

    #[cold]
    fn no_number(&self, word: &[u8]) -> Error {
        self.malformed(format!("`{}` is not a number", shown(word)))
    }

    #[cold]
    fn no_index(&self, word: &[u8]) -> Error {
        self.malformed(format!(
            "`{}` is not a corner: write v, v/vt, v//vn or v/vt/vn",
            shown(word)
        ))
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
pub(super) fn too_many_corners(line: u64) -> Error {
    let message = "more corners than 32 bits can index".to_owned();
    Error::at(Place::Line(line), ErrorKind::Unsupported(message))
}

#[cold]
pub(super) fn out_of_range(kind: usize, index: i64, count: u64, line: u64) -> Error {
    Error::at(Place::Line(line), ErrorKind::OutOfRange { what: WHATS[kind], index, count })
}
