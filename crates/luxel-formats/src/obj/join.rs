//! Parses a file's blocks on all threads, and joins them in order.

use super::document::{Document, NONE};
use super::lines::Lines;
use super::parse::{Block, Parsed, out_of_range, parse, too_many_corners};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Limits, Place};
use luxel_scene::NormalFault;
use std::collections::HashMap;

/// Minimum bytes of a block: a millisecond of work or more.
const BLOCK: usize = 1 << 19;
/// Blocks parsed before they are joined, and before memory is checked against the limit.
const TOGETHER: usize = 16;

/// Reads a file's statements.
pub(super) fn document<'a>(
    bytes: &'a [u8],
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Document<'a>, Error> {
    read(bytes, BLOCK, limits, warnings)
}

fn read<'a>(
    bytes: &'a [u8],
    block: usize,
    limits: &Limits,
    warnings: &mut Warnings,
) -> Result<Document<'a>, Error> {
    let mut file = Joined::default();
    let mut lines = Lines::new(bytes);
    loop {
        let blocks: Vec<_> = std::iter::from_fn(|| lines.block(block)).take(TOGETHER).collect();
        if blocks.is_empty() {
            return file.finish(limits, warnings);
        }
        for parsed in parse_all(&blocks, file.document.counts(), limits) {
            let mut block = parsed.block.map_err(|error| file.in_file(error))?;
            file.join(&mut block)?;
        }
        limits.check("the model", file.document.bytes(), 1, Place::Line(file.lines))?;
    }
}

/// Parses blocks in parallel; `before` is the state at the start of the first.
fn parse_all<'a>(blocks: &[Lines<'a>], before: [usize; 3], limits: &Limits) -> Vec<Parsed<'a>> {
    let mut parsed: Vec<Option<Parsed<'a>>> = luxel_parallel::map(blocks.len(), 1, &|run| {
        Some(parse(blocks[run.start].clone(), limits, (run.start == 0).then_some(before)))
    });
    // Blocks with relative indices are parsed again once the counts before them are known.
    let mut counts = before;
    let mut starts = Vec::with_capacity(blocks.len());
    for parsed in parsed.iter().flatten() {
        starts.push(counts);
        // The first error ends the file.
        let Ok(block) = &parsed.block else { continue };
        for (count, more) in counts.iter_mut().zip(block.document.counts()) {
            *count += more;
        }
    }
    luxel_parallel::fill(&mut parsed, 1, &|at, parsed| {
        if parsed[0].as_ref().is_some_and(|parsed| parsed.asks_before) {
            parsed[0] = Some(parse(blocks[at].clone(), limits, Some(starts[at])));
        }
    });
    parsed.into_iter().flatten().collect()
}

/// The blocks joined so far.
#[derive(Default)]
struct Joined<'a> {
    document: Document<'a>,
    material_numbers: HashMap<&'a [u8], u32>,
    /// The current material and smoothing group; no material before the first.
    current: Option<[u32; 2]>,
    highest: [(i64, u64); 3],
    understood: u64,
    unknown: Option<(u64, String)>,
    free_form: Option<u64>,
    lines: u64,
}

impl<'a> Joined<'a> {
    /// An error with its line number in the file.
    fn in_file(&self, mut error: Error) -> Error {
        if let Place::Line(line) = &mut error.place {
            *line += self.lines;
        }
        error
    }

    fn join(&mut self, block: &mut Block<'a>) -> Result<(), Error> {
        self.join_elements(block)?;
        let Self { document, lines, .. } = self;
        let more = &mut block.document;
        if !more.colors.is_empty() || !document.colors.is_empty() {
            document.colors.resize(document.positions.len(), [f32::NAN; 3]);
            more.colors.resize(more.positions.len(), [f32::NAN; 3]);
            document.colors.append(&mut more.colors);
        }
        let normals = document.normals.len() as u32;
        let faults = more.normal_faults.iter();
        document.normal_faults.extend(
            faults.map(|fault| NormalFault { position: fault.position + normals, ..*fault }),
        );
        document.positions.append(&mut more.positions);
        document.uvs.append(&mut more.uvs);
        document.normals.append(&mut more.normals);
        document.libraries.append(&mut more.libraries);
        document.has_smoothing |= more.has_smoothing;
        for (highest, (number, line)) in self.highest.iter_mut().zip(block.highest) {
            if number > highest.0 {
                *highest = (number, line + *lines);
            }
        }
        self.understood += block.understood;
        if self.unknown.is_none() {
            self.unknown = block.unknown.take().map(|(line, word)| (line + *lines, word));
        }
        if self.free_form.is_none() {
            self.free_form = block.free_form.map(|line| line + *lines);
        }
        *lines += block.lines;
        Ok(())
    }

    /// Elements with their corners and names.
    fn join_elements(&mut self, block: &mut Block<'a>) -> Result<(), Error> {
        let document = &mut self.document;
        let more = &mut block.document;
        let mut materials = Vec::with_capacity(more.materials.len());
        for &name in &more.materials {
            let next = document.materials.len() as u32;
            let number = *self.material_numbers.entry(name).or_insert(next);
            if number == next {
                document.materials.push(name);
            }
            materials.push(number);
        }
        let [mut material, mut smoothing] = self.current.unwrap_or([NONE, 0]);
        let corners = document.corners.len();
        let (Ok(corners), Ok(_)) =
            (u32::try_from(corners), u32::try_from(corners + more.corners.len()))
        else {
            return Err(too_many_corners(self.lines + block.lines));
        };
        let [named, grouped] = block.inherits.map(|until| until.unwrap_or(usize::MAX));
        for (number, element) in more.elements.iter_mut().enumerate() {
            element.end += corners;
            element.material =
                if number < named { material } else { materials[element.material as usize] };
            if number < grouped {
                element.smoothing = smoothing;
            }
        }
        if block.inherits[0].is_some() {
            material = materials[block.leaves[0] as usize];
        }
        if block.inherits[1].is_some() {
            smoothing = block.leaves[1];
        }
        self.current = Some([material, smoothing]);
        let elements = document.elements.len() as u32;
        for beginning in &mut more.beginnings {
            beginning.element += elements;
        }
        document.beginnings.append(&mut more.beginnings);
        document.corners.append(&mut more.corners);
        document.elements.append(&mut more.elements);
        Ok(())
    }

    fn finish(self, limits: &Limits, warnings: &mut Warnings) -> Result<Document<'a>, Error> {
        let mut document = self.document;
        document.shrink();
        for (kind, (count, (number, line))) in
            document.counts().into_iter().zip(self.highest).enumerate()
        {
            if number > count as i64 {
                return Err(out_of_range(kind, number, count as u64, line));
            }
        }
        if let Some((line, word)) = self.unknown {
            if self.understood == 0 {
                let message = format!(
                    "`{word}` is not an OBJ statement, nor is the first word of any other line"
                );
                return Err(Error::at(Place::Line(line), ErrorKind::Malformed(message)));
            }
            warnings.push(format!(
                "line {line}: `{word}` is not an OBJ statement: such lines are ignored"
            ));
        }
        if let Some(line) = self.free_form {
            let what = "free-form curves and surfaces are left out: convert them to polygons";
            warnings.push(format!("line {line}: {what}"));
        }
        limits.check("the model", document.bytes(), 1, Place::File)?;
        Ok(document)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The parsed document or the error, as text.
    fn describe(text: &[u8], block: usize) -> String {
        let mut warnings = Warnings::default();
        let document = read(text, block, &Limits::default(), &mut warnings);
        format!("{document:?} {:?}", warnings.finish())
    }

    /// Lines that depend on earlier ones, and some invalid ones.
    const LINES: [&str; 24] = [
        "v 0 0 0",
        "v 1 0 0 .1 .2 .3",
        "  v 0 1 0",
        "vt .5",
        "vt 1 0",
        "vn 0 0 1",
        "vn 0 0 3",
        "f 1 2 3",
        "f -1 -2 -3",
        "f 1/1/1 2/1/1 3//1",
        "f -1/-1/-1 -2//-1 -3",
        "l 1 \\",
        "p -1",
        "o a",
        "g b",
        "s 1",
        "s off",
        "usemtl red",
        "usemtl blue",
        "# f 9 9 9 \\",
        "mtllib a.mtl",
        "curv 1",
        "f 7 8 9",
        "what",
    ];

    proptest! {
        #[test]
        fn the_result_does_not_depend_on_the_division_into_blocks(
            lines in prop::collection::vec(0..LINES.len(), 0..60),
            odd in prop::collection::vec((0..60_usize, prop::sample::select(vec!["f 0", "v x", "f -99", "f 1 99"])), 0..2),
            ends in prop::sample::select(vec!["\n", "\r\n", "\r"]),
        ) {
            let mut lines: Vec<&str> = lines.into_iter().map(|line| LINES[line]).collect();
            for (at, line) in odd {
                lines.insert(at.min(lines.len()), line);
            }
            let text = lines.join(ends);
            let whole = describe(text.as_bytes(), usize::MAX);
            for block in [1, 7, 40, 300] {
                prop_assert_eq!(&describe(text.as_bytes(), block), &whole, "blocks of {}", block);
            }
        }
    }

    #[test]
    fn a_file_of_many_batches_of_blocks_is_joined() {
        let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -1 -2 -3\n".repeat(TOGETHER * 3);
        let document =
            read(text.as_bytes(), 8, &Limits::default(), &mut Warnings::default()).unwrap();
        assert_eq!(document.elements.len(), TOGETHER * 3);
        for (number, element) in document.elements.iter().enumerate() {
            let first = 3 * number as u32;
            assert_eq!(element.end, first + 3);
            let corners = document.corners_of(number);
            assert_eq!(
                corners,
                [[first + 2, NONE, NONE], [first + 1, NONE, NONE], [first, NONE, NONE]]
            );
        }
    }
}
