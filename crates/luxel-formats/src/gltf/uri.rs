//! URIs of buffers and images: embedded data, or a file within the document's folder
//! (glTF 2.0 specification, section 2.8).

use crate::GivenFiles;
use crate::files::{self, Refusal};
use base64::Engine;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use std::path::{Path, PathBuf};

/// The target of a URI.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// Bytes embedded in the URI.
    Data(Vec<u8>),
    /// A file, relative to the document.
    File {
        /// With `%20` as a space.
        decoded: String,
        /// Verbatim, for exporters that don't percent-encode.
        literal: String,
    },
}

/// Padding and stray bits are tolerated, as browsers do.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &base64::alphabet::STANDARD,
    GeneralPurposeConfig::new()
        .with_decode_padding_mode(DecodePaddingMode::Indifferent)
        .with_decode_allow_trailing_bits(true),
);

/// Decodes a URI.
///
/// # Errors
/// A message about the URI.
pub(crate) fn resolve(uri: &str) -> Result<Target, String> {
    if let Some(data) = strip_prefix_ignoring_case(uri, "data:") {
        let (kind, data) =
            data.split_once(',').ok_or("the data URI has no comma before its data")?;
        let bytes = if kind.to_ascii_lowercase().ends_with(";base64") {
            BASE64.decode(data).map_err(|error| format!("the base64 data is damaged: {error}"))?
        } else {
            percent_decoded(data)
        };
        return Ok(Target::Data(bytes));
    }
    let decoded = String::from_utf8(percent_decoded(uri))
        .map_err(|_| format!("`{}` is not a UTF-8 file name", shortened(uri)))?;
    Ok(Target::File { decoded, literal: uri.to_owned() })
}

/// The file of a relative target: percent-decoded, or verbatim if only that file exists.
///
/// # Errors
/// A message about the name.
pub(crate) fn file_in(
    folder: Option<&Path>,
    decoded: &str,
    literal: &str,
    given: Option<&GivenFiles>,
) -> Result<PathBuf, Refusal> {
    let path = files::within(folder, decoded, given).map_err(shortened_message)?;
    let as_written = files::within(folder, literal, given).map_err(shortened_message)?;
    let is_file = |path| files::is_file(path, given);
    let (path, name) = if !is_file(&path) && is_file(&as_written) {
        (as_written, literal)
    } else {
        (path, decoded)
    };
    files::check_reference(folder, &path, name, given).map_err(shortened_message)?;
    Ok(path)
}

fn shortened_message(refusal: Refusal) -> Refusal {
    Refusal { message: shortened(&refusal.message), ..refusal }
}

/// Shortens very long names for messages.
fn shortened(name: &str) -> String {
    const MOST: usize = 400;
    if name.chars().count() <= MOST {
        return name.to_owned();
    }
    name.chars().take(MOST).chain("...".chars()).collect()
}

fn strip_prefix_ignoring_case<'a>(text: &'a str, prefix: &str) -> Option<&'a str> {
    let head = text.get(..prefix.len())?;
    head.eq_ignore_ascii_case(prefix).then(|| &text[prefix.len()..])
}

/// Percent-decodes (RFC 3986, section 2.1); a `%` without two hexadecimal digits
/// stays as it is.
fn percent_decoded(text: &str) -> Vec<u8> {
    let digit = |byte: u8| char::from(byte).to_digit(16).map(|digit| digit as u8);
    let mut rest = text.as_bytes();
    let mut decoded = Vec::with_capacity(rest.len());
    while let Some((&byte, tail)) = rest.split_first() {
        rest = tail;
        if let (b'%', [high, low, after @ ..]) = (byte, tail)
            && let (Some(high), Some(low)) = (digit(*high), digit(*low))
        {
            decoded.push(high << 4 | low);
            rest = after;
        } else {
            decoded.push(byte);
        }
    }
    decoded
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(uri: &str) -> Result<PathBuf, String> {
        match resolve(uri)? {
            Target::File { decoded, literal } => {
                file_in(Some(Path::new("folder")), &decoded, &literal, None)
                    .map_err(|refusal| refusal.message)
            }
            Target::Data(_) => panic!("{uri} is not a data URI"),
        }
    }

    #[test]
    fn codes_in_file_names_are_decoded() {
        assert_eq!(file("a%20b%C3%A9.png").unwrap(), Path::new("folder/a bé.png"));
        assert_eq!(file("sub/50%.bin").unwrap(), Path::new("folder/sub/50%.bin"));
    }

    #[test]
    fn paths_out_of_the_folder_are_refused() {
        for uri in [
            "../x.bin",
            "a/../../x.bin",
            "%2e%2e/x.bin",
            "..%2Fx.bin",
            "/etc/passwd",
            "%2Fetc/passwd",
            "\\\\host\\x.bin",
            "a\\..\\..\\x",
            "file:///etc/passwd",
            "http://example.org/x.bin",
            "C:/x.bin",
            "",
            "a%00b",
        ] {
            assert!(file(uri).is_err(), "{uri}");
        }
    }

    #[test]
    fn data_are_decoded_with_and_without_padding() {
        for uri in ["data:;base64,AQID/w==", "DATA:application/gltf-buffer;base64,AQID/w"] {
            assert_eq!(resolve(uri).unwrap(), Target::Data(vec![1, 2, 3, 255]));
        }
        assert_eq!(resolve("data:text/plain,a%01").unwrap(), Target::Data(vec![b'a', 1]));
    }

    #[test]
    fn damaged_base64_is_an_error() {
        assert!(resolve("data:;base64,A*ID").is_err());
        assert!(resolve("data:nothing").is_err());
    }
}
