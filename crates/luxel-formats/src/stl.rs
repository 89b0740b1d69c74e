//! stub
use crate::{Error, ErrorKind, Limits, Loaded, Place};
pub(crate) fn read(_: &[u8], _: &str, _: &Limits) -> Result<Loaded, Error> {
    let message = "reading stl is not built yet".to_owned();
    Err(Error::at(Place::File, ErrorKind::Unsupported(message)))
}
