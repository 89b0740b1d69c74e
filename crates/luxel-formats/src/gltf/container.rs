//! The two containers of a glTF document: plain JSON, and GLB, a header with chunks
//! (glTF 2.0 specification, section 4.4).

use crate::{Error, ErrorKind, Place};

/// The first four bytes of a GLB.
const MAGIC: &[u8] = b"glTF";
const HEADER_BYTES: usize = 12;
const CHUNK_HEADER_BYTES: usize = 8;
const JSON_CHUNK: &[u8] = b"JSON";
const BINARY_CHUNK: &[u8] = b"BIN\0";

/// A document's JSON text and its optional binary chunk.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Container<'a> {
    /// The text, in UTF-8.
    pub(crate) json: &'a [u8],
    /// Byte offset of the text in the file.
    pub(crate) json_start: u64,
    /// Whether errors give a byte offset (GLB) instead of a line (plain JSON).
    pub(crate) is_binary: bool,
    /// The first binary chunk.
    pub(crate) binary: Option<&'a [u8]>,
}

impl<'a> Container<'a> {
    /// Splits a file into its parts. The first bytes decide the container, not the file name.
    pub(crate) fn open(bytes: &'a [u8]) -> Result<Self, Error> {
        if bytes.starts_with(MAGIC) {
            return Self::open_binary(bytes);
        }
        if bytes.is_empty() {
            let message = "the file is empty: a glTF document begins with `{` or `glTF`";
            return Err(Error::at(Place::File, ErrorKind::Malformed(message.to_owned())));
        }
        let json = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let json_start = (bytes.len() - json.len()) as u64;
        Ok(Self { json, json_start, is_binary: false, binary: None })
    }

    fn open_binary(bytes: &'a [u8]) -> Result<Self, Error> {
        let truncated = |what: &str| {
            Error::at(Place::Byte(bytes.len() as u64), ErrorKind::Truncated(what.to_owned()))
        };
        let malformed = |byte: usize, message| {
            Error::at(Place::Byte(byte as u64), ErrorKind::Malformed(message))
        };
        let version = word(bytes, 4).ok_or_else(|| truncated("the GLB header"))?;
        if version != 2 {
            let message =
                format!("GLB version {version} is not supported: export the file as glTF 2.0");
            return Err(Error::at(Place::Byte(4), ErrorKind::Unsupported(message)));
        }
        let length = word(bytes, 8).ok_or_else(|| truncated("the GLB header"))? as usize;
        if length > bytes.len() {
            return Err(truncated(&format!("the {length} bytes declared in the GLB header")));
        }
        // Bytes after the declared end are padding from storage or transfer.
        let bytes = &bytes[..length];
        let mut json = None;
        let mut binary = None;
        let mut at = HEADER_BYTES;
        while at < bytes.len() {
            let (Some(length), Some(kind)) = (word(bytes, at), bytes.get(at + 4..at + 8)) else {
                return Err(truncated("a chunk's header"));
            };
            let start = at + CHUNK_HEADER_BYTES;
            let rest = bytes.len() - start;
            let length = length as usize;
            if length > rest {
                let message = format!("a chunk declares {length} bytes, but only {rest} are left");
                return Err(malformed(at, message));
            }
            let chunk = &bytes[start..start + length];
            match kind {
                JSON_CHUNK if json.is_none() => json = Some((chunk, start as u64)),
                BINARY_CHUNK if binary.is_none() => binary = Some(chunk),
                _ if json.is_none() => {
                    let message = "the first chunk must be JSON".to_owned();
                    return Err(malformed(at + 4, message));
                }
                // Extensions define other kinds of chunk; readers may skip them.
                _ => {}
            }
            at = start + length;
        }
        let (json, json_start) = json.ok_or_else(|| truncated("the JSON chunk"))?;
        Ok(Self { json, json_start, is_binary: true, binary })
    }
}

/// The little-endian 32-bit word at a byte.
fn word(bytes: &[u8], at: usize) -> Option<u32> {
    let word = bytes.get(at..)?.first_chunk::<4>()?;
    Some(u32::from_le_bytes(*word))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A GLB whose chunks have the length that they declare.
    fn glb(version: u32, chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
        let length = 12 + chunks.iter().map(|(_, data)| 8 + data.len()).sum::<usize>();
        let mut bytes = b"glTF".to_vec();
        bytes.extend(version.to_le_bytes());
        bytes.extend((length as u32).to_le_bytes());
        for (kind, data) in chunks {
            bytes.extend((data.len() as u32).to_le_bytes());
            bytes.extend(*kind);
            bytes.extend(*data);
        }
        bytes
    }

    fn place(bytes: &[u8]) -> Place {
        Container::open(bytes).unwrap_err().place
    }

    #[test]
    fn both_chunks_are_found() {
        let bytes = glb(2, &[(b"JSON", b"{}  "), (b"WHAT", b"skip"), (b"BIN\0", b"1234")]);
        let container = Container::open(&bytes).unwrap();
        assert_eq!(container.json, b"{}  ");
        assert_eq!(container.json_start, 20);
        assert_eq!(container.binary, Some(&b"1234"[..]));
    }

    #[test]
    fn the_binary_chunk_may_be_missing() {
        assert_eq!(Container::open(&glb(2, &[(b"JSON", b"{}")])).unwrap().binary, None);
    }

    #[test]
    fn trailing_bytes_are_ignored() {
        let mut bytes = glb(2, &[(b"JSON", b"{}")]);
        bytes.extend([0; 9]);
        assert!(Container::open(&bytes).is_ok());
    }

    #[test]
    fn every_truncation_is_an_error_with_its_byte() {
        let bytes = glb(2, &[(b"JSON", b"{}  "), (b"BIN\0", b"1234")]);
        for length in 4..bytes.len() {
            assert!(matches!(place(&bytes[..length]), Place::Byte(_)), "{length} bytes");
        }
    }

    #[test]
    fn a_chunk_longer_than_the_file_is_an_error_at_its_header() {
        let mut bytes = glb(2, &[(b"JSON", b"{}  "), (b"BIN\0", b"1234")]);
        bytes[24..28].copy_from_slice(&u32::MAX.to_le_bytes());
        assert_eq!(place(&bytes), Place::Byte(24));
    }

    #[test]
    fn glb_version_1_is_refused() {
        let error = Container::open(&glb(1, &[(b"JSON", b"{}")])).unwrap_err();
        assert!(matches!(error.kind, ErrorKind::Unsupported(_)));
    }

    #[test]
    fn a_byte_order_mark_is_skipped() {
        assert_eq!(Container::open(b"\xEF\xBB\xBF{}").unwrap().json, b"{}");
    }
}
