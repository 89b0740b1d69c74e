//! glTF 2.0 and GLB (Khronos, ISO/IEC 12113:2022).
//!
//! The pipeline: `container` splits the file, `document` parses and checks its JSON, `tree` sorts
//! the nodes, and `scene` builds their content: `mesh` (from `vertices`, `accessor`, `buffers`),
//! `materials`, `textures`, `lights` and `cameras`. Animations are ignored: nodes have the file's
//! transforms, morph targets their default weights, and skins follow their joints.

mod accessor;
mod buffers;
mod cameras;
mod container;
mod document;
#[cfg_attr(not(feature = "draco"), path = "gltf/no_draco.rs")]
mod draco;
mod extensions;
mod instancing;
mod lights;
mod materials;
mod mesh;
#[cfg_attr(not(feature = "meshopt"), path = "gltf/no_meshopt.rs")]
mod meshopt;
mod pose;
mod scene;
mod textures;
mod topology;
mod tree;
mod uri;
mod vertices;

use crate::memory::Memory;
use crate::warnings::Warnings;
use crate::{Error, Format, Limits, Loaded};
use std::path::Path;

/// Reads a document in either container. A node without a name takes that of its mesh, else
/// its number.
pub(crate) fn read(
    bytes: &[u8],
    format: Format,
    _name: &str,
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Loaded, Error> {
    let container = container::Container::open(bytes)?;
    let memory = Memory::new(limits);
    let mut warnings = Warnings::default();
    let document = document::parse(&container, &memory, &mut warnings)?;
    let buffers = buffers::Buffers::new(&document, container.binary, folder, &memory);
    let scene = scene::build(&buffers, &mut warnings)?;
    Ok(Loaded { scene, format, warnings: warnings.finish() })
}
