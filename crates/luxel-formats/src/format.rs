//! File formats, and a scene that was read from one of them.

use crate::{Error, ErrorKind, Place, UnknownFormat, Warning};
use luxel_scene::Scene;
use std::str::FromStr;

/// A file format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// glTF 2.0 as JSON.
    Gltf,
    /// glTF 2.0 in one binary file.
    Glb,
    /// Wavefront OBJ with MTL.
    Obj,
    /// Stereolithography, binary or ASCII.
    Stl,
    /// Stanford polygons, binary or ASCII.
    Ply,
    /// A luxel scene file: models, materials, lights, cameras.
    Toml,
}

/// A scene, with the warnings of its reader.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// The content of the file.
    pub scene: Scene,
    /// Its format.
    pub format: Format,
    /// The parts left out or replaced.
    pub warnings: Vec<Warning>,
}

impl Format {
    /// The file name extension, which is also the name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Gltf => "gltf",
            Self::Glb => "glb",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Ply => "ply",
            Self::Toml => "toml",
        }
    }

    /// The format that a file's first bytes show; `None` if they show none.
    ///
    /// glTF's magic number or an object of JSON; `ply`; `solid`, or the length of a binary STL; a scene
    /// file by its first table or key; OBJ by its first statement.
    #[must_use]
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        // Comments at the beginning are seldom longer.
        const WITHIN: usize = 1 << 16;
        if bytes.starts_with(b"glTF") {
            return Some(Self::Glb);
        }
        if declared_stl_size(bytes) == Some(bytes.len() as u64) {
            return Some(Self::Stl);
        }
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let head = text[..text.len().min(WITHIN)].split(|&byte| matches!(byte, b'\n' | b'\r'));
        let is_statement = |line: &&[u8]| !line.is_empty() && line[0] != b'#';
        let first = head.map(<[u8]>::trim_ascii).find(is_statement)?;
        let word = first.split(u8::is_ascii_whitespace).next()?;
        if first.starts_with(b"{") {
            return Some(Self::Gltf);
        }
        if first == b"ply" {
            return Some(Self::Ply);
        }
        if word.eq_ignore_ascii_case(b"solid") {
            return Some(Self::Stl);
        }
        if first.starts_with(b"[") || first.contains(&b'=') {
            return Some(Self::Toml);
        }
        OBJ_STATEMENTS.contains(&word).then_some(Self::Obj)
    }

    /// Whether this build reads it, by its cargo features.
    #[must_use]
    pub const fn is_supported(self) -> bool {
        match self {
            Self::Gltf | Self::Glb => cfg!(feature = "gltf"),
            Self::Obj => cfg!(feature = "obj"),
            Self::Stl => cfg!(feature = "stl"),
            Self::Ply => cfg!(feature = "ply"),
            Self::Toml => cfg!(feature = "toml"),
        }
    }

    /// Refuses text in UTF-16, by its byte order mark or the zeros in every other byte: all text formats
    /// are ASCII or UTF-8.
    pub(crate) fn check_not_utf16(self, bytes: &[u8]) -> Result<(), Error> {
        let is_utf16 = match *bytes {
            [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => true,
            [a, 0, b, 0, ..] | [0, a, 0, b, ..] => {
                [a, b].iter().all(|byte| (b'\t'..=b'~').contains(byte))
            }
            _ => false,
        };
        let is_binary_stl = || declared_stl_size(bytes) == Some(bytes.len() as u64);
        if !is_utf16 || self == Self::Stl && is_binary_stl() {
            return Ok(());
        }
        Err(Error::at(Place::File, ErrorKind::Utf16))
    }

    /// The error of a build without its reader.
    pub(crate) fn missing_feature(self) -> ErrorKind {
        let (what, feature) = match self {
            Self::Gltf | Self::Glb => ("glTF", "gltf"),
            Self::Obj => ("OBJ", "obj"),
            Self::Stl => ("STL", "stl"),
            Self::Ply => ("PLY", "ply"),
            Self::Toml => ("a scene file", "toml"),
        };
        crate::error::missing_feature(what, feature)
    }
}

/// The statements with which OBJ files begin.
const OBJ_STATEMENTS: [&[u8]; 12] =
    [b"v", b"vt", b"vn", b"vp", b"f", b"l", b"p", b"o", b"g", b"s", b"mtllib", b"usemtl"];

/// The size that a binary STL declares: 80 bytes of comment, the number of facets in 4, and 50 bytes a
/// facet. `None` for files without that number.
pub(crate) fn declared_stl_size(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..)?.first_chunk()?;
    Some(84 + 50 * u64::from(u32::from_le_bytes(*count)))
}

impl FromStr for Format {
    type Err = UnknownFormat;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        [Self::Gltf, Self::Glb, Self::Obj, Self::Stl, Self::Ply, Self::Toml]
            .into_iter()
            .find(|format| format.name().eq_ignore_ascii_case(name))
            .ok_or_else(|| UnknownFormat { name: name.to_owned() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_bytes_show_the_format() {
        let mut binary_stl = b"solid facets, binary all the same".to_vec();
        binary_stl.resize(84 + 50, 0);
        binary_stl[80] = 1;
        for (bytes, format) in [
            (&b"glTF\x02\0\0\0"[..], Format::Glb),
            (b"\n  {\"asset\": {}}", Format::Gltf),
            (b"ply\r\nformat ascii 1.0", Format::Ply),
            (b"solid part\nfacet normal 0 0 1", Format::Stl),
            (&binary_stl, Format::Stl),
            (b"# made by hand\n\nmtllib a.mtl\n", Format::Obj),
            (b"\xef\xbb\xbfv 1 2 3\n", Format::Obj),
            (b"# a scene\n[[models]]\nsource = \"a.ply\"\n", Format::Toml),
            (b"ambient = [1, 1, 1]\n", Format::Toml),
        ] {
            let text = String::from_utf8_lossy(bytes);
            assert_eq!(Format::of_bytes(bytes), Some(format), "{text}");
        }
        for bytes in [&b""[..], b"#", b"\x89PNG\r\n", b"hello world", b"plyfoo"] {
            assert_eq!(Format::of_bytes(bytes), None, "{bytes:?}");
        }
    }
}
