//! Replaces `draco` in builds without the feature.

use super::buffers::Buffers;
use crate::error::missing_feature;
use crate::{Error, Place};
use luxel_gltf::{Draco, Primitive};

/// Never constructed.
pub(crate) enum Decoded {}

/// Refuses the primitive.
pub(crate) fn decode(
    _: &Buffers<'_>,
    _: &Draco,
    pointer: &dyn Fn() -> String,
) -> Result<Decoded, Error> {
    let pointer = format!("{}/extensions/KHR_draco_mesh_compression", pointer());
    Err(Error::at(Place::Pointer(pointer), missing_feature("Draco geometry", "draco")))
}

impl Decoded {
    pub(crate) fn into_triangles(self) -> Vec<[u32; 3]> {
        match self {}
    }

    pub(crate) fn vertices(&self) -> usize {
        match *self {}
    }

    pub(crate) fn values(
        &self,
        _: &Buffers<'_>,
        _: &Primitive,
        _: &str,
    ) -> Option<(usize, Vec<f32>)> {
        match *self {}
    }
}
