//! Which glTF extensions luxel supports.

use crate::error::missing_feature;
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Place};
use luxel_gltf::Document;

/// Extensions that luxel reads and renders.
const SUPPORTED: &[&str] = &[
    "EXT_mesh_gpu_instancing",
    "EXT_meshopt_compression",
    "KHR_draco_mesh_compression",
    "KHR_lights_punctual",
    "KHR_materials_emissive_strength",
    "KHR_materials_pbrSpecularGlossiness",
    "KHR_materials_unlit",
    "KHR_mesh_quantization",
    "KHR_texture_transform",
];

/// Extensions behind a cargo feature: extension, feature, whether this build has it.
const OPTIONAL: &[(&str, &str, bool)] = &[
    ("EXT_meshopt_compression", "meshopt", cfg!(feature = "meshopt")),
    ("KHR_draco_mesh_compression", "draco", cfg!(feature = "draco")),
];

/// Refuses a document that requires an unsupported extension; warns of optional ones.
pub(crate) fn check(document: &Document, warnings: &mut Warnings) -> Result<(), Error> {
    let supported = |name: &String| SUPPORTED.contains(&name.as_str());
    let required = document.extensions_required.iter().enumerate();
    if let Some((index, name)) = required.into_iter().find(|(_, name)| !supported(name)) {
        let message = format!(
            "the file requires the extension {name}, which luxel doesn't support: export it without"
        );
        let place = Place::Pointer(format!("/extensionsRequired/{index}"));
        return Err(Error::at(place, ErrorKind::Unsupported(message)));
    }
    for (index, name) in document.extensions_required.iter().enumerate() {
        let optional = OPTIONAL.iter().find(|(optional, ..)| optional == name);
        if let Some((_, feature, false)) = optional {
            let what = format!("{name}, which the file requires,");
            let place = Place::Pointer(format!("/extensionsRequired/{index}"));
            return Err(Error::at(place, missing_feature(what, feature)));
        }
    }
    for (index, name) in document.extensions_used.iter().enumerate() {
        if !supported(name) {
            warnings.push(format!("/extensionsUsed/{index}: {name} is ignored"));
        }
    }
    Ok(())
}
