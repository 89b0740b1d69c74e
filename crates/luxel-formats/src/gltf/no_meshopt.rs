//! Replaces `meshopt` in builds without the feature.

use crate::ErrorKind;
use crate::error::missing_feature;
use luxel_gltf::Meshopt;

/// Refuses the buffer view.
pub(crate) fn decompress(_: &Meshopt, _: &[u8]) -> Result<Vec<u8>, ErrorKind> {
    Err(missing_feature("meshopt geometry", "meshopt"))
}
