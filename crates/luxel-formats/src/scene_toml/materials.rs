//! `[material]`, `[[materials]]`, `[[overrides]]`: the reflection constants of each surface.

use super::document::{Document, Table};
use super::keys::{MATERIAL, MATERIALS, OVERRIDES};
use super::models::Models;
use crate::memory::Memory;
use crate::values::{color, nearest, parameter, reflectance, reflection, unit_interval};
use crate::{Error, ErrorKind, Place};
use luxel_lighting::parameters;
use luxel_scene::{MaterialId, Mesh, MeshId, NodeId, Restyle, Scene, SceneMaterial};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A change with its name.
struct Named {
    name: String,
    /// Starts from the plain material.
    replace: bool,
    restyle: Restyle,
}

/// The surfaces that an override applies to.
struct Rule {
    /// The change, by its index among the named ones.
    change: usize,
    /// The material's name in the model, if restricted to one.
    surface: Option<String>,
}

/// Maximum number of overrides, which bounds the time that a file can take.
const MAX_OVERRIDES: usize = 4096;

/// Applies the materials and changes of the file to all models.
pub(super) fn apply(
    document: &Document<'_>,
    models: &mut Models,
    memory: &Memory<'_>,
) -> Result<(), Error> {
    for table in document.tables(&MATERIAL)? {
        let restyle = restyle(&table)?;
        models.scene.materials.iter_mut().for_each(|material| restyle.apply(material));
    }
    let (names, changes) = named(document)?;
    let rules = rules(document, models, &names)?;
    if rules.iter().all(Vec::is_empty) {
        return Ok(());
    }
    dress(&mut models.scene, &rules, &changes, memory)
}

fn restyle(table: &Table<'_>) -> Result<Restyle, Error> {
    let mut restyle = Restyle {
        color: table.value("color", reflectance)?,
        emission: table.value("emission", reflectance)?,
        reflection: table.value("reflection", reflection)?,
        ambient: table.value("ambient", reflectance)?,
        specular: table.value("specular", color)?,
        opacity: table.value("opacity", unit_interval)?,
        ..Restyle::default()
    };
    for one in parameters() {
        if let Some(value) = table.value(one.name, |text| parameter(one, text))? {
            restyle.set_parameter(one, value);
        }
    }
    Ok(restyle)
}

/// The named changes, and the index of each name.
fn named(document: &Document<'_>) -> Result<(BTreeMap<String, usize>, Vec<Named>), Error> {
    let mut names = BTreeMap::new();
    let mut changes = Vec::new();
    for table in document.tables(&MATERIALS)? {
        let name = table.text("name")?.unwrap_or_default();
        if names.insert(name.to_owned(), changes.len()).is_some() {
            let message = format!("two materials have the name `{name}`: rename one");
            return Err(table.error_at("name", message));
        }
        let replace = table.switch("replace")?.unwrap_or_default();
        changes.push(Named { name: name.to_owned(), replace, restyle: restyle(&table)? });
    }
    Ok((names, changes))
}

/// The index of a change by name.
fn change_of(names: &BTreeMap<String, usize>, name: &str) -> Result<usize, String> {
    names.get(name).copied().ok_or_else(|| match nearest(name, names.keys().map(String::as_str)) {
        Some(meant) => format!("there is no material `{name}`: did you mean `{meant}`?"),
        None => format!("there is no material `{name}`: add it under [[materials]]"),
    })
}

/// The overrides of each node, in order.
fn rules(
    document: &Document<'_>,
    models: &Models,
    names: &BTreeMap<String, usize>,
) -> Result<Vec<Vec<Rule>>, Error> {
    let scene = &models.scene;
    let mut rules: Vec<Vec<Rule>> = Vec::new();
    rules.resize_with(scene.nodes.len(), Vec::new);
    for model in &models.list {
        let Some((name, place)) = &model.material else { continue };
        let at_place = |message| Error::at(place.clone(), ErrorKind::Malformed(message));
        let change = change_of(names, name).map_err(at_place)?;
        for rules in &mut rules[model.nodes.clone()] {
            rules.push(Rule { change, surface: None });
        }
    }
    let children = children(scene);
    let tables = document.tables(&OVERRIDES)?;
    if let Some(table) = tables.get(MAX_OVERRIDES) {
        return Err(table.error(format!("too many overrides: the limit is {MAX_OVERRIDES}")));
    }
    for table in tables {
        let name = table.text("material")?.unwrap_or_default();
        let change =
            change_of(names, name).map_err(|message| table.error_at("material", message))?;
        let nodes = chosen(&table, models, &children)?;
        let surface = table.text("surface")?.map(str::to_owned);
        if let Some(surface) = &surface
            && !scene.materials.iter().any(|material| material.name == *surface)
        {
            let known = scene.materials.iter().map(|material| material.name.as_str());
            return Err(table.unknown_name("surface", "surface", surface, known));
        }
        for node in nodes {
            rules[node].push(Rule { change, surface: surface.clone() });
        }
    }
    Ok(rules)
}

fn children(scene: &Scene) -> Vec<Vec<usize>> {
    let mut children = vec![Vec::new(); scene.nodes.len()];
    for (index, node) in scene.nodes.iter().enumerate() {
        if let Some(parent) = node.parent {
            children[parent.index()].push(index);
        }
    }
    children
}

/// The nodes that an override applies to: in its model, and at or below its object.
fn chosen(
    table: &Table<'_>,
    models: &Models,
    children: &[Vec<usize>],
) -> Result<BTreeSet<usize>, Error> {
    let scene = &models.scene;
    let mut chosen: BTreeSet<usize> = match table.text("model")? {
        Some(name) => {
            let of_name = models.list.iter().filter(|model| model.name == name);
            let nodes: BTreeSet<_> = of_name.flat_map(|model| model.nodes.clone()).collect();
            if nodes.is_empty() {
                let known = models.list.iter().map(|model| model.name.as_str());
                let message = match nearest(name, known) {
                    Some(meant) => format!("there is no model `{name}`: did you mean `{meant}`?"),
                    None => format!("there is no model `{name}`: name it under [[models]]"),
                };
                return Err(table.error_at("model", message));
            }
            nodes
        }
        None => (0..scene.nodes.len()).collect(),
    };
    if let Some(path) = table.path("object")? {
        let found: Vec<NodeId> = models.nodes.all(scene, &path);
        let mut left: Vec<usize> =
            found.iter().map(|node| node.index()).filter(|node| chosen.contains(node)).collect();
        if left.is_empty() {
            return Err(models.nodes.missing(table, "object", &path));
        }
        let mut below = BTreeSet::new();
        while let Some(node) = left.pop() {
            if below.insert(node) {
                left.extend(&children[node]);
            }
        }
        chosen.retain(|node| below.contains(node));
    }
    Ok(chosen)
}

/// Assigns each object its materials. Meshes that objects share in different materials are
/// copied, and so are materials that only some surfaces change.
fn dress(
    scene: &mut Scene,
    rules: &[Vec<Rule>],
    changes: &[Named],
    memory: &Memory<'_>,
) -> Result<(), Error> {
    scene.separate();
    // From a material and its changes, in order, to the resulting material.
    let mut dressed: HashMap<(u32, Vec<usize>), MaterialId> = HashMap::new();
    let originals = scene.materials.clone();
    let mut is_taken = vec![false; originals.len()];
    // From a mesh and its materials to the resulting mesh.
    let mut meshes: HashMap<(MeshId, Vec<MaterialId>), MeshId> = HashMap::new();
    let mut is_first_use = vec![true; scene.meshes.len()];
    for (node, rules) in rules.iter().enumerate() {
        let Some(mesh) = scene.nodes[node].mesh else { continue };
        let mut made = Vec::new();
        for material in materials_of(&scene.meshes[mesh.index()]) {
            let original = &originals[material.index()];
            let fits = |rule: &&Rule| rule.surface.as_ref().is_none_or(|s| *s == original.name);
            let on_top: Vec<usize> = rules.iter().filter(fits).map(|rule| rule.change).collect();
            let key = (material.0, on_top);
            let id = dressed.get(&key).copied().unwrap_or_else(|| {
                let worn = worn(original, &key.1, changes);
                // The first change of a material happens in place.
                let id = if std::mem::replace(&mut is_taken[material.index()], true) {
                    scene.materials.push(worn);
                    MaterialId(scene.materials.len() as u32 - 1)
                } else {
                    scene.materials[material.index()] = worn;
                    material
                };
                dressed.insert(key, id);
                id
            });
            made.push(id);
        }
        let key = (mesh, made);
        let id = match meshes.get(&key) {
            Some(&id) => id,
            None if std::mem::replace(&mut is_first_use[mesh.index()], false) => {
                // Its other uses still need the original materials.
                meshes.insert(key, mesh);
                mesh
            }
            None => {
                let copy = scene.meshes[mesh.index()].clone();
                let bytes = 64 * (copy.triangles.len() + copy.positions.len()) as u64;
                memory.take("meshes in several materials", bytes, 1, Place::File)?;
                scene.meshes.push(copy);
                let id = MeshId(scene.meshes.len() as u32 - 1);
                meshes.insert(key, id);
                id
            }
        };
        scene.nodes[node].mesh = Some(id);
    }
    for ((_, made), mesh) in meshes {
        wear(&mut scene.meshes[mesh.index()], &made);
    }
    Ok(())
}

fn worn(original: &SceneMaterial, on_top: &[usize], changes: &[Named]) -> SceneMaterial {
    let mut material = original.clone();
    for &change in on_top {
        let Named { name, replace, restyle } = &changes[change];
        if *replace {
            material = SceneMaterial { vertex_colors: false, ..SceneMaterial::default() };
        }
        restyle.apply(&mut material);
        material.name = name.into();
    }
    material
}

/// The material of each run of triangles, points and lines.
fn materials_of(mesh: &Mesh) -> Vec<MaterialId> {
    let parts = mesh.parts.iter().map(|part| part.material);
    let points = mesh.points.iter().map(|points| points.material);
    let lines = mesh.lines.iter().map(|lines| lines.material);
    parts.chain(points).chain(lines).collect()
}

/// Replaces the materials, in the same order.
fn wear(mesh: &mut Mesh, made: &[MaterialId]) {
    let parts = mesh.parts.iter_mut().map(|part| &mut part.material);
    let points = mesh.points.iter_mut().map(|points| &mut points.material);
    let lines = mesh.lines.iter_mut().map(|lines| &mut lines.material);
    for (material, &made) in parts.chain(points).chain(lines).zip(made) {
        *material = made;
    }
}
