//! From JSON text to a checked document: syntax, version, extensions.

use super::container::Container;
use super::extensions;
use crate::memory::Memory;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Place};
use luxel_gltf::{Asset, Document, Fault, ReadError};

/// Upper bounds of the memory that a JSON object and a JSON value take once parsed: more than the
/// size of the largest structure of the schema, divided by the shortest text that makes one.
const BYTES_PER_OBJECT: u64 = 640;
const BYTES_PER_VALUE: u64 = 32;

/// Parses the document and checks its version and required extensions.
pub(crate) fn parse(
    container: &Container<'_>,
    memory: &Memory<'_>,
    warnings: &mut Warnings,
) -> Result<Document, Error> {
    let count = |byte| container.json.iter().filter(|&&other| other == byte).count() as u64;
    memory.take("the JSON document", count(b'{'), BYTES_PER_OBJECT, Place::File)?;
    memory.take("the JSON document", count(b','), BYTES_PER_VALUE, Place::File)?;
    memory.take("the JSON document", container.json.len() as u64, 1, Place::File)?;
    // GLB pads the text with spaces, but some exporters write zeros.
    let end = container.json.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1);
    let json = &container.json[..end];
    let document = match luxel_gltf::read(json) {
        Ok(document) => document,
        Err(error) => {
            // Values of other types may be those of another version.
            if let Some(asset) = luxel_gltf::read_asset(json) {
                check_version(&asset)?;
            }
            return Err(json_error(container, error));
        }
    };
    let Some(asset) = &document.asset else {
        let message = "`asset` with its `version` is missing: this is not a glTF document";
        return Err(Error::at(Place::Pointer(String::new()), ErrorKind::Malformed(message.into())));
    };
    check_version(asset)?;
    extensions::check(&document, warnings)?;
    Ok(document)
}

fn check_version(asset: &Asset) -> Result<(), Error> {
    let unsupported = |pointer: &str, message| {
        Err(Error::at(Place::Pointer(pointer.to_owned()), ErrorKind::Unsupported(message)))
    };
    // Later minor versions stay readable by 2.0 readers unless `minVersion` asks for more.
    if asset.version.split('.').next() != Some("2") {
        let message =
            format!("glTF {} is not supported: export the file as glTF 2.0", asset.version);
        return unsupported("/asset/version", message);
    }
    if let Some(least) = asset.min_version.as_deref().filter(|&least| least != "2.0") {
        let message = format!("the file requires glTF {least}; luxel reads 2.0");
        return unsupported("/asset/minVersion", message);
    }
    Ok(())
}

/// An error at the JSON pointer of a wrong value, or at the line or byte of bad syntax.
fn json_error(container: &Container<'_>, error: ReadError) -> Error {
    let ReadError { fault, message } = error;
    let (line, column, is_end) = match fault {
        Fault::Value { pointer } => {
            return Error::at(Place::Pointer(pointer), ErrorKind::Malformed(message));
        }
        Fault::Syntax { line, column, is_end } => (line, column, is_end),
    };
    let place = if container.is_binary {
        let lines = container.json.split_inclusive(|&byte| byte == b'\n');
        let before: usize = lines.take(line.saturating_sub(1)).map(<[u8]>::len).sum();
        let within = column.saturating_sub(1);
        Place::Byte(container.json_start + (before + within) as u64)
    } else {
        Place::Line(line.max(1) as u64)
    };
    let kind = if is_end {
        ErrorKind::Truncated(format!("the JSON document ({message})"))
    } else {
        ErrorKind::Malformed(format!("this is not a JSON document: {message}"))
    };
    Error::at(place, kind)
}
