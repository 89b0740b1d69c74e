//! Material edits on top of the scene's materials.

use luxel::formats::SurfaceChange;
use luxel::scene::{Object, Restyle, Scene, SceneMaterial};
use std::collections::BTreeMap;

/// Edits of materials, by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct MaterialOverrides {
    changes: BTreeMap<usize, Restyle>,
}

impl MaterialOverrides {
    /// The edit of a material, for further changes.
    pub(crate) fn edit(&mut self, material: usize) -> &mut Restyle {
        self.changes.entry(material).or_default()
    }

    /// Reverts a material.
    pub(crate) fn reset(&mut self, material: usize) {
        self.changes.remove(&material);
    }

    pub(crate) fn is_changed(&self, material: usize) -> bool {
        self.changes.contains_key(&material)
    }

    /// The edits as entries of a scene file, which name materials, or objects and materials where
    /// several materials share a name.
    ///
    /// # Errors
    /// If a name is ambiguous in both ways.
    pub(crate) fn surface_changes(
        &self,
        scene: &Scene,
        objects: &[Object],
    ) -> Result<Vec<SurfaceChange>, String> {
        let mut changes = Vec::new();
        for (&at, restyle) in &self.changes {
            let Some(material) = scene.materials.get(at) else { continue };
            let same = scene.materials.iter().filter(|one| one.name == material.name);
            if same.count() == 1 {
                let surface = Some(material.name.to_string());
                changes.push(SurfaceChange { object: None, surface, restyle: restyle.clone() });
                continue;
            }
            // Several materials share the name: one entry for each object.
            let path = |object: &Object| -> Vec<String> {
                scene.path(object.node).into_iter().map(str::to_owned).collect()
            };
            let has_material = |object: &Object, other: bool| {
                materials_of_mesh(scene, object.mesh.index()).into_iter().any(|index| {
                    (index == at) != other && scene.materials[index].name == material.name
                })
            };
            for object in objects.iter().filter(|object| has_material(object, false)) {
                let own = path(object);
                let others = objects.iter().filter(|one| path(one).starts_with(&own));
                if others.clone().any(|one| has_material(one, true)) {
                    let name = &material.name;
                    return Err(format!(
                        "several surfaces are called `{name}`: a scene file can't tell them apart"
                    ));
                }
                changes.push(SurfaceChange {
                    object: Some(own),
                    surface: Some(material.name.to_string()),
                    restyle: restyle.clone(),
                });
            }
        }
        Ok(changes)
    }

    /// A material with its edits.
    pub(crate) fn material(&self, scene: &Scene, material: usize) -> SceneMaterial {
        let mut edited = scene.materials.get(material).cloned().unwrap_or_default();
        if let Some(change) = self.changes.get(&material) {
            change.apply(&mut edited);
        }
        edited
    }

    /// All materials with their edits; `None` without edits.
    pub(crate) fn all(&self, scene: &Scene) -> Option<Vec<SceneMaterial>> {
        let all = || (0..scene.materials.len()).map(|at| self.material(scene, at)).collect();
        (!self.changes.is_empty()).then(all)
    }
}

/// The number of objects that use each material.
pub(crate) fn material_use_counts(scene: &Scene) -> Vec<usize> {
    let mut uses = vec![0; scene.materials.len()];
    for object in scene.objects() {
        for material in materials_of_mesh(scene, object.mesh.index()) {
            uses[material] += 1;
        }
    }
    uses
}

/// The distinct materials of a mesh, in order.
pub(crate) fn materials_of_mesh(scene: &Scene, mesh: usize) -> Vec<usize> {
    let mesh = &scene.meshes[mesh];
    let parts = mesh.parts.iter().map(|part| part.material);
    let points = mesh.points.iter().map(|points| points.material);
    let lines = mesh.lines.iter().map(|lines| lines.material);
    let mut found = Vec::new();
    for material in parts.chain(points).chain(lines) {
        if !found.contains(&material.index()) {
            found.push(material.index());
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::K_D;
    use luxel::scene::demos;

    #[test]
    fn edits_apply_and_are_reverted() {
        let scene = demos::demo("plane").unwrap();
        let mut overrides = MaterialOverrides::default();
        assert_eq!(overrides.all(&scene), None);
        overrides.edit(0).set_parameter(&K_D, 0.25);
        let edited = overrides.all(&scene).unwrap();
        assert_eq!(edited[0].constants.k_d, 0.25);
        assert_eq!(edited[0].constants.k_s, scene.materials[0].constants.k_s);
        assert_eq!(edited[1..], scene.materials[1..]);
        overrides.reset(0);
        assert_eq!((overrides.all(&scene), overrides.is_changed(0)), (None, false));
    }

    #[test]
    fn edits_are_saved_by_material_or_by_object_or_refused() {
        let mut scene = demos::demo("spheres").unwrap();
        let mut overrides = MaterialOverrides::default();
        overrides.edit(1).set_parameter(&K_D, 0.5);
        let changes = overrides.surface_changes(&scene, &scene.objects()).unwrap();
        assert_eq!(changes.len(), 1);
        assert_eq!(changes[0].surface.as_deref(), Some(scene.materials[1].name.as_str()));
        assert_eq!((&changes[0].object, changes[0].restyle.parameter(&K_D)), (&None, Some(0.5)));
        // Two materials with the same name, on different objects.
        scene.materials[0].name = scene.materials[1].name.clone();
        let changes = overrides.surface_changes(&scene, &scene.objects()).unwrap();
        let objects = scene.objects();
        let has_material = |object: &&Object| materials_of_mesh(&scene, object.mesh.index()) == [1];
        let path = scene.path(objects.iter().find(has_material).unwrap().node).join("/");
        assert_eq!(changes.len(), 1);
        assert_eq!(changes[0].object.as_ref().map(|names| names.join("/")), Some(path));
        // On objects with the same name, too.
        let nodes: Vec<_> = objects.iter().map(|object| object.node).collect();
        for node in nodes {
            scene.nodes[node.index()].name = "ball".into();
        }
        assert!(overrides.surface_changes(&scene, &scene.objects()).is_err());
    }

    #[test]
    fn each_object_counts_once_for_its_material() {
        let scene = demos::demo("spheres").unwrap();
        let uses = material_use_counts(&scene);
        let surfaces = scene.objects().len();
        assert_eq!((uses.len(), uses.iter().sum::<usize>()), (scene.materials.len(), surfaces));
    }
}
