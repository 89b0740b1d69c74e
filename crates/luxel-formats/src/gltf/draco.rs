//! Geometry packed by `KHR_draco_mesh_compression`, decoded by the `draco-core` crate.

use super::accessor::Component;
use super::buffers::{Buffers, malformed};
use crate::{Error, Place};
use draco_core::{DecodeLimits, DecoderBuffer, Mesh, MeshDecoder};
use luxel_gltf::{Draco, Primitive};

/// A decompressed primitive.
pub(crate) struct Decoded {
    mesh: Mesh,
    triangles: Vec<[u32; 3]>,
}

/// Decompresses the geometry of a primitive.
pub(crate) fn decode(
    buffers: &Buffers<'_>,
    draco: &Draco,
    pointer: &dyn Fn() -> String,
) -> Result<Decoded, Error> {
    let pointer = || format!("{}/extensions/KHR_draco_mesh_compression", pointer());
    let stream = buffers.view(draco.buffer_view, &pointer)?.bytes;
    let memory = buffers.memory();
    // Lower bound of the memory of one decoded face or point.
    const LEAST_BYTES: u64 = 24;
    let most = memory.left().max_memory;
    let limits = DecodeLimits::default()
        .with_max_points(most / LEAST_BYTES)
        .with_max_faces(most / LEAST_BYTES)
        .with_max_decoded_bytes(most / 2);
    let mut mesh = Mesh::new();
    let mut stream = DecoderBuffer::new(stream).with_limits(limits);
    MeshDecoder::new()
        .decode(&mut stream, &mut mesh)
        .map_err(|error| malformed(pointer(), format!("the Draco stream is damaged: {error}")))?;
    let place = || Place::Pointer(pointer());
    memory.take("Draco geometry", mesh.num_faces() as u64, 2 * LEAST_BYTES, place())?;
    memory.take("Draco geometry", mesh.num_points() as u64, 4 * LEAST_BYTES, place())?;
    let triangles: Vec<_> = mesh.faces().iter().map(|face| face.map(|point| point.0)).collect();
    let points = mesh.num_points();
    if triangles.iter().flatten().any(|&corner| corner as usize >= points) {
        return Err(malformed(
            pointer(),
            "the Draco stream refers to points that it doesn't contain",
        ));
    }
    Ok(Decoded { mesh, triangles })
}

impl Decoded {
    /// The corners of the triangles.
    pub(crate) fn into_triangles(self) -> Vec<[u32; 3]> {
        self.triangles
    }

    /// How many vertices there are.
    pub(crate) fn vertices(&self) -> usize {
        self.mesh.num_points()
    }

    /// The values of an attribute, `width` per vertex; `None` if the stream lacks it.
    /// Normalized integers are scaled by the accessor's component type.
    pub(crate) fn values(
        &self,
        buffers: &Buffers<'_>,
        primitive: &Primitive,
        name: &str,
    ) -> Option<(usize, Vec<f32>)> {
        let id = *primitive.extensions.draco.as_ref()?.attributes.get(name)?;
        let attribute = self.mesh.attribute_by_unique_id(id)?;
        let width = usize::from(attribute.num_components());
        let mut values = attribute.read_f32s(self.vertices(), width);
        let accessor = primitive.attributes.get(name);
        let accessor = accessor.and_then(|&at| buffers.document().accessors.get(at as usize));
        if let Some(accessor) = accessor.filter(|accessor| accessor.normalized) {
            let scale = Component::from_code(accessor.component_type)?.full_scale() as f32;
            values.iter_mut().for_each(|value| *value = (*value / scale).max(-1.0));
        }
        Some((width, values))
    }
}
