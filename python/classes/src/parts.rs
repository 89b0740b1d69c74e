//! Scenes of several meshes with materials, textures and instances, for the package's own modules.

use crate::arrays::{matrix, vector};
use crate::errors::argument;
use crate::meshes::{Elements, MeshArrays, image_of};
use crate::scene::{PyScene, up_of};
use luxel::lighting::Reflection;
use luxel::scene::{
    AlphaMode, DMat4, Encoding, Filter, MaterialId, Mesh, MeshId, Node, NodeId, Sampler, Scene,
    SceneMaterial, Sides, Texture, TextureId, TextureUse, Wrap,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Name, parent by its place, pose, mesh by its place.
type NodeFields<'py> = (String, Option<u32>, Option<Bound<'py, PyAny>>, Option<u32>);
/// Bytes, whether they are sRGB, and the sampler: wrapping of u and v, filters of larger and smaller
/// pictures, as glTF numbers them.
type TextureFields<'py> = (Bound<'py, PyAny>, bool, [u32; 4]);

/// A scene of meshes, materials, textures and nodes, which name one another by their places.
///
/// A mesh is a dict of arrays, as `Scene.from_arrays` takes them, with the place of its `material`, its `mode`
/// and the `place` that errors begin with; a material a dict as glTF has it.
#[pyfunction]
#[pyo3(signature = (meshes, materials, textures, nodes, up=None, warnings=Vec::new()))]
pub(crate) fn build_scene<'py>(
    py: Python<'py>,
    meshes: Vec<Bound<'py, PyDict>>,
    materials: Vec<Bound<'py, PyDict>>,
    textures: Vec<TextureFields<'py>>,
    nodes: Vec<NodeFields<'py>>,
    up: Option<&Bound<'py, PyAny>>,
    warnings: Vec<String>,
) -> PyResult<PyScene> {
    let mut scene = Scene { up: up_of(up)?, ..Scene::default() };
    for (number, (bytes, is_srgb, sampler)) in textures.into_iter().enumerate() {
        let encoding = if is_srgb { Encoding::Srgb } else { Encoding::Linear };
        let image = image_of(&format!("textures[{number}]"), &bytes, encoding)?;
        scene.textures.push(Texture { image, sampler: sampler_of(sampler) });
    }
    for (number, fields) in materials.into_iter().enumerate() {
        let fields = Fields { fields, place: format!("materials[{number}].") };
        scene.materials.push(material_of(&fields, scene.textures.len())?);
    }
    for (number, fields) in meshes.into_iter().enumerate() {
        let fields = Fields { fields, place: format!("meshes[{number}].") };
        scene.meshes.push(mesh_of(fields, scene.materials.len())?);
    }
    for (number, (name, parent, pose, mesh)) in nodes.into_iter().enumerate() {
        let wrong = |what: &str| argument(&format!("nodes[{number}]"), what);
        let parent_from_node = match pose {
            Some(pose) => {
                DMat4::from_cols_array_2d(&matrix(&format!("nodes[{number}].pose"), &pose)?)
            }
            None => DMat4::IDENTITY,
        };
        if parent.is_some_and(|parent| parent as usize >= number) {
            return Err(wrong("its parent doesn't come before it"));
        }
        if mesh.is_some_and(|mesh| mesh as usize >= scene.meshes.len()) {
            return Err(wrong("there is no such mesh"));
        }
        let node = Node::root(name, mesh.map(MeshId)).at(parent.map(NodeId), parent_from_node);
        scene.nodes.push(node);
    }
    Ok(py.detach(|| PyScene::ready(scene, warnings)))
}

fn sampler_of([wrap_u, wrap_v, larger, smaller]: [u32; 4]) -> Sampler {
    let wrap = |code| match code {
        33_071 => Wrap::ClampToEdge,
        33_648 => Wrap::MirroredRepeat,
        _ => Wrap::Repeat,
    };
    let nearest = |is_nearest| if is_nearest { Filter::Nearest } else { Filter::Linear };
    Sampler {
        wrap_u: wrap(wrap_u),
        wrap_v: wrap(wrap_v),
        magnify: nearest(larger == 9728),
        minify: nearest(matches!(smaller, 9728 | 9984 | 9986)),
        mipmap: (!matches!(smaller, 9728 | 9729)).then(|| nearest(matches!(smaller, 9984 | 9985))),
    }
}

/// A dict, with what errors put before its keys.
struct Fields<'py> {
    fields: Bound<'py, PyDict>,
    place: String,
}

impl<'py> Fields<'py> {
    fn wrong(&self, name: &str, expected: &str) -> PyErr {
        argument(&format!("{}{name}", self.place), expected)
    }

    /// A value that is given and not `None`.
    fn get(&self, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        Ok(self.fields.get_item(name)?.filter(|value| !value.is_none()))
    }

    fn extract<T: for<'a> FromPyObject<'a, 'py>>(
        &self,
        name: &str,
        expected: &str,
    ) -> PyResult<Option<T>> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        value.extract().map(Some).map_err(|_| self.wrong(name, expected))
    }

    /// A number from 0 to `most`.
    fn number(&self, name: &str, most: f32) -> PyResult<Option<f32>> {
        let number = self.extract::<f32>(name, "expected a number")?;
        match number {
            Some(number) if !(0.0..=most).contains(&number) => {
                Err(self.wrong(name, &format!("expected a number from 0 to {most}")))
            }
            number => Ok(number),
        }
    }

    /// N numbers from 0.
    fn color<const N: usize>(&self, name: &str) -> PyResult<Option<[f32; N]>> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        let color = vector::<N>(&format!("{}{name}", self.place), &value)?;
        let color = color.map(|channel| channel as f32);
        match color.iter().all(|channel| (0.0..f32::INFINITY).contains(channel)) {
            true => Ok(Some(color)),
            false => Err(self.wrong(name, "expected numbers from 0")),
        }
    }

    /// A texture by its place.
    fn texture(&self, name: &str, count: usize) -> PyResult<Option<Box<TextureUse>>> {
        match self.extract::<u32>(name, "expected the place of a texture")? {
            Some(place) if place as usize >= count => {
                Err(self.wrong(name, "there is no such texture"))
            }
            place => Ok(place.map(|place| Box::new(TextureUse::new(TextureId(place))))),
        }
    }
}

fn mesh_of(mut fields: Fields<'_>, materials: usize) -> PyResult<Mesh> {
    if let Some(place) = fields.extract::<String>("place", "expected a text")? {
        fields.place = place;
    }
    let material = fields.extract::<u32>("material", "expected a whole number")?.unwrap_or(0);
    if material as usize >= materials {
        return Err(fields.wrong("material", "there is no such material"));
    }
    let mode = fields.extract::<String>("mode", "expected a name")?;
    let elements = match mode.as_deref() {
        None | Some("triangles") => Elements::Triangles,
        Some("lines") => Elements::Lines,
        Some("points") => Elements::Points,
        Some(_) => return Err(fields.wrong("mode", "use triangles, lines or points")),
    };
    let vertices = fields.get("vertices")?;
    let names = ["faces", "normals", "colors", "face_colors", "uv"];
    let [faces, normals, colors, face_colors, uv] = names.map(|name| fields.get(name));
    MeshArrays {
        place: &fields.place,
        elements,
        vertices: vertices.as_ref().ok_or_else(|| fields.wrong("vertices", "they are missing"))?,
        faces: faces?.as_ref(),
        normals: normals?.as_ref(),
        colors: colors?.as_ref(),
        face_colors: face_colors?.as_ref(),
        uv: uv?.as_ref(),
    }
    .mesh(MaterialId(material))
}

/// Microfacets, if the material is given as metallic, else as it is without a file's.
fn material_of(fields: &Fields<'_>, textures: usize) -> PyResult<SceneMaterial> {
    let texture = |name| fields.texture(name, textures);
    let switch =
        |name| Ok::<_, PyErr>(fields.extract(name, "expected True or False")?.unwrap_or(false));
    let mut material = SceneMaterial {
        name: fields.extract::<String>("name", "expected a text")?.unwrap_or_default().into(),
        base_color: texture("base_color_texture")?,
        metallic_roughness: texture("metallic_roughness_texture")?,
        normal: texture("normal_texture")?,
        occlusion: texture("occlusion_texture")?,
        emission: texture("emissive_texture")?,
        sides: if switch("double_sided")? { Sides::Both } else { Sides::Front },
        ..SceneMaterial::default()
    };
    let constants = &mut material.constants;
    if let Some([red, green, blue, alpha]) = fields.color("base_color")? {
        constants.diffuse = [red, green, blue];
        material.opacity = alpha.min(1.0);
    }
    constants.emission = fields.color("emissive")?.unwrap_or_default();
    if let Some(shininess) = fields.number("shininess", f32::MAX)? {
        constants.shininess = shininess;
    }
    if let Some(metallic) = fields.number("metallic", 1.0)? {
        constants.reflection = Reflection::Microfacet;
        constants.metallic = metallic;
        constants.roughness = fields.number("roughness", 1.0)?.unwrap_or(1.0);
        constants.k_s = 1.0;
    }
    if switch("unlit")? {
        constants.reflection = Reflection::Unlit;
    }
    material.alpha_mode =
        match fields.extract::<String>("alpha_mode", "expected a name")?.as_deref() {
            None | Some("OPAQUE") => AlphaMode::Opaque,
            Some("BLEND") => AlphaMode::Blend,
            Some("MASK") => {
                AlphaMode::Mask { cutoff: fields.number("alpha_cutoff", f32::MAX)?.unwrap_or(0.5) }
            }
            Some(_) => return Err(fields.wrong("alpha_mode", "use OPAQUE, MASK or BLEND")),
        };
    Ok(material)
}
