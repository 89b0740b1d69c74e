//! glTF 2.0.

use crate::{Error, ErrorKind, Format, Limits, Loaded, Place};
use std::path::Path;

pub(crate) fn read(
    _: &[u8],
    format: Format,
    _: &str,
    _: Option<&Path>,
    _: &Limits,
) -> Result<Loaded, Error> {
    let message = format!("reading {} is not built yet", format.name());
    Err(Error::at(Place::File, ErrorKind::Unsupported(message)))
}
