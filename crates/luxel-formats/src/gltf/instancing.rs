//! Instances of one mesh: `EXT_mesh_gpu_instancing`.

use super::accessor;
use super::buffers::{Buffers, item, malformed};
use crate::{Error, Place};
use glam::{DMat4, DQuat, DVec3};
use luxel_gltf::Instancing;

/// Memory of one instance as a scene node, with its name.
const BYTES_PER_INSTANCE: u64 = 512;
/// Instances that a file may declare without data: an accessor without a buffer view, all zeros, takes a few
/// bytes whatever its count.
const MOST_DECLARED: u64 = 100_000;

/// From each instance to the node.
pub(crate) fn places(
    buffers: &Buffers<'_>,
    instancing: &Instancing,
    pointer: &str,
) -> Result<Vec<DMat4>, Error> {
    let translations: Option<Vec<[f64; 3]>> =
        attribute(buffers, instancing, pointer, "TRANSLATION")?;
    let rotations: Option<Vec<[f64; 4]>> = attribute(buffers, instancing, pointer, "ROTATION")?;
    let scales: Option<Vec<[f64; 3]>> = attribute(buffers, instancing, pointer, "SCALE")?;
    let counts = [
        translations.as_ref().map(Vec::len),
        rotations.as_ref().map(Vec::len),
        scales.as_ref().map(Vec::len),
    ];
    let count = counts.into_iter().flatten().min().unwrap_or(0);
    Ok((0..count)
        .map(|index| {
            let translation = translations.as_ref().map_or([0.0; 3], |list| list[index]);
            let scale = scales.as_ref().map_or([1.0; 3], |list| list[index]);
            let rotation = rotations.as_ref().map_or([0.0, 0.0, 0.0, 1.0], |list| list[index]);
            let rotation = DQuat::from_array(rotation);
            let length = rotation.length();
            let rotation = if length > 0.0 { rotation / length } else { DQuat::IDENTITY };
            let (scale, translation) = (DVec3::from_array(scale), DVec3::from_array(translation));
            DMat4::from_scale_rotation_translation(scale, rotation, translation)
        })
        .filter(DMat4::is_finite)
        .collect())
}

fn attribute<const N: usize>(
    buffers: &Buffers<'_>,
    instancing: &Instancing,
    pointer: &str,
    name: &str,
) -> Result<Option<Vec<[f64; N]>>, Error> {
    let Some(&index) = instancing.attributes.get(name) else { return Ok(None) };
    let pointer = || format!("{pointer}/attributes/{name}");
    let accessor = item(&buffers.document().accessors, index, "accessor", &pointer)?;
    let count = accessor.count;
    if accessor.buffer_view.is_none() && count > MOST_DECLARED {
        let message = format!(
            "{count} instances without data: an accessor without a buffer view gives at most {MOST_DECLARED}"
        );
        return Err(malformed(pointer(), message));
    }
    let place = Place::Pointer(pointer());
    buffers.memory().take("instances", count, BYTES_PER_INSTANCE, place)?;
    let elements = accessor::elements(buffers, index, &pointer)?;
    elements.vectors().map(Some).map_err(|message| malformed(pointer(), message))
}
