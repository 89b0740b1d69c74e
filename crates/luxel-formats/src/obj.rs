//! stub
use crate::{Error, ErrorKind, Limits, Loaded, Place};
pub(crate) fn read(
    _: &[u8],
    _: &str,
    _: Option<&std::path::Path>,
    _: &Limits,
) -> Result<Loaded, Error> {
    let message = "reading obj is not built yet".to_owned();
    Err(Error::at(Place::File, ErrorKind::Unsupported(message)))
}
