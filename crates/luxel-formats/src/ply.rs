//! PLY, the Stanford polygon format: a header that declares elements and their properties, then
//! their values as text or bytes (Turk 1994).
//!
//! Supported: `vertex` with positions, normals, colours and texture coordinates under
//! their usual names; `face` with polygons and colours; `tristrips`; `edge`. Other elements and
//! properties are skipped. If both vertices and faces have colours, the vertices' win, unless
//! they are all the same.

mod build;
mod faces;
mod header;
mod source;
mod vertices;

use crate::block_reader::BlockReader;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Format, Limits, Loaded, Place};
use faces::Faces;
use header::{Element, Encoding, Header};
use source::Source;
use vertices::Vertices;

/// Reads a PLY file as one object called `name`.
pub(crate) fn read(bytes: &[u8], name: &str, limits: &Limits) -> Result<Loaded, Error> {
    let header = Header::read(bytes)?;
    let mut warnings = warnings_of(&header);
    let source = Source::new(bytes, header.body, header.encoding);
    let content = read_body(&header, source, limits)?;
    let scene = build::scene(content, name, &mut warnings)?;
    Ok(Loaded { scene, format: Format::Ply, warnings: warnings.finish() })
}

/// Longest header that [`stream`] reads, in bytes.
const HEAD: usize = 1 << 16;

/// Reads a long binary file of vertices and triangles without holding it in memory.
/// `None` for others.
pub(crate) fn stream(
    file: &BlockReader<'_>,
    name: &str,
    limits: &Limits,
) -> Result<Option<Loaded>, Error> {
    let head = file.with_block(0, HEAD, Header::read);
    file.check()?;
    let Ok(header) = head else { return Ok(None) };
    let is_table = |element: &Element| match element.name.as_str() {
        "edge" | "tristrips" => false,
        "face" => true,
        _ => element.stride().is_some(),
    };
    if header.encoding == Encoding::Text || !header.elements.iter().all(is_table) {
        return Ok(None);
    }
    file.begin();
    let source = Source::streamed(file, header.body, header.encoding);
    let content = read_body(&header, source, limits);
    file.advance_to(file.length());
    file.check()?;
    let content = content?;
    if content.faces.need_whole_file {
        return Ok(None);
    }
    let mut warnings = warnings_of(&header);
    let scene = build::scene(content, name, &mut warnings)?;
    Ok(Some(Loaded { scene, format: Format::Ply, warnings: warnings.finish() }))
}

/// The content of a body.
#[derive(Default)]
struct Content {
    vertices: Vertices,
    faces: Faces,
    edges: Vec<[u32; 2]>,
}

fn read_body(header: &Header, mut source: Source<'_>, limits: &Limits) -> Result<Content, Error> {
    let vertex = header.elements.iter().find(|element| element.name == "vertex");
    // Rows without values take no space in the file, so they don't count.
    let with_values = vertex.filter(|element| !element.properties.is_empty());
    let vertex_count = with_values.map_or(0, |element| element.count);
    if u32::try_from(vertex_count).is_err() {
        let message = format!("{vertex_count} vertices are more than 32 bits can index");
        let line = vertex.map_or(1, |element| element.line);
        return Err(Error::at(Place::Line(line), ErrorKind::Unsupported(message)));
    }
    let mut content = Content { faces: Faces::new(vertex_count, limits), ..Content::default() };
    for element in &header.elements {
        check(element, &source, limits)?;
        match element.name.as_str() {
            "vertex" if vertex.is_some_and(|vertex| std::ptr::eq(vertex, element)) => {
                content.vertices.read(element, &mut source)?;
            }
            "face" => {
                content.faces.read_polygons(element, &mut source)?;
                if content.faces.need_whole_file {
                    break;
                }
            }
            "tristrips" => content.faces.read_strips(element, &mut source)?,
            "edge" => read_edges(element, &mut source, vertex_count, &mut content.edges)?,
            _ => skip(element, &mut source)?,
        }
    }
    Ok(content)
}

/// Warns of lines that PLY doesn't have, and of properties that nothing is made of.
fn warnings_of(header: &Header) -> Warnings {
    let mut warnings = Warnings::default();
    for (line, text) in &header.unknown {
        warnings.push(format!("line {line}: `{text}` is not a header line of PLY and is ignored"));
    }
    let mut unused = Vec::new();
    for element in header.elements.iter().filter(|element| element.count > 0) {
        let used = match element.name.as_str() {
            "vertex" => vertices::used_properties(element),
            "face" | "tristrips" => faces::used_properties(element),
            "edge" => {
                ["vertex1", "vertex2"].into_iter().filter_map(|end| element.scalar(end)).collect()
            }
            _ => Vec::new(),
        };
        unused.extend(element.others(&used).map(|name| format!("{} {name}", element.name)));
    }
    if !unused.is_empty() {
        warnings.push(format!("properties that are not used: {}", unused.join(", ")));
    }
    warnings
}

/// Checks a count against the bytes that follow and the limits, before allocating.
fn check(element: &Element, source: &Source<'_>, limits: &Limits) -> Result<(), Error> {
    let place = || Place::Line(element.line);
    let left = source.bytes_left();
    if element.count.saturating_mul(source.least_bytes(element)) > left {
        let what = format!(
            "element `{}`: the header declares {} rows, but only {left} bytes follow",
            element.name, element.count
        );
        return Err(Error::at(Place::Byte(source.length()), ErrorKind::Truncated(what)));
    }
    let bytes_each = match element.name.as_str() {
        "vertex" => vertices::bytes_each(element),
        "face" => faces::bytes_each(element),
        "edge" => 8,
        _ => 0,
    };
    limits.check(&format!("element `{}`", element.name), element.count, bytes_each, place())
}

fn read_edges(
    element: &Element,
    source: &mut Source<'_>,
    vertex_count: u64,
    edges: &mut Vec<[u32; 2]>,
) -> Result<(), Error> {
    let (Some(first), Some(second)) = (element.scalar("vertex1"), element.scalar("vertex2")) else {
        return skip(element, source);
    };
    edges.reserve_exact(element.count as usize);
    source::each_row(element, source, None, |source, row| {
        let end = |property: usize| {
            faces::vertex_index(row.values[property], vertex_count)
                .map_err(|kind| Error::at(source.place(), kind))
        };
        edges.push([end(first)?, end(second)?]);
        Ok(())
    })
}

fn skip(element: &Element, source: &mut Source<'_>) -> Result<(), Error> {
    // Rows without values take no space, however many there are.
    if element.stride() == Some(0) {
        return Ok(());
    }
    match element.stride().and_then(|stride| source.table(element.count, stride)) {
        Some(table) => {
            source.skip(&table);
            Ok(())
        }
        None => source::each_row(element, source, None, |_, _| Ok(())),
    }
}

#[cfg(test)]
mod tests;
