//! OBJ with MTL, Wavefront's text format.
//!
//! Each `o` begins an object; in a file without `o`, each `g` does; a file with neither is one
//! object. Elements before the first statement, and objects without a name, take the file's stem.
//! A repeated name continues its object only while that is the current one; later it begins
//! another object of the same name, as in most readers. Objects without elements are left
//! out; the vertices of a file without any elements are points. Vertex colours are sRGB; an object shares its positions, and split attributes
//! (texture coordinates, normals) don't split them.

mod build;
mod definitions;
mod document;
mod join;
mod lines;
mod materials;
mod mtl;
mod parse;

use crate::warnings::Warnings;
use crate::{Error, Format, Limits, Loaded};
use luxel_scene::{Scene, SceneMaterial};
use materials::Materials;
use std::path::Path;

/// Reads an OBJ file, with libraries and textures from `folder`.
pub(crate) fn read(
    bytes: &[u8],
    name: &str,
    folder: Option<&Path>,
    limits: &Limits,
) -> Result<Loaded, Error> {
    let mut warnings = Warnings::default();
    let mut document = join::document(bytes, limits, &mut warnings)?;
    document.show_bare_vertices();
    let mut materials =
        Materials::read(&document.libraries, &document.materials, folder, limits, &mut warnings)?;
    let mut scene = Scene::default();
    build::objects(&document, name, &mut materials, &mut scene, &mut warnings)?;
    scene.textures = materials.textures;
    scene.materials = materials.list;
    if scene.materials.is_empty() {
        scene.materials.push(SceneMaterial::default());
    }
    Ok(Loaded { scene, format: Format::Obj, warnings: warnings.finish() })
}

#[cfg(test)]
mod tests;
