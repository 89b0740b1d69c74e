//! Materials as they are worn: those of the scene, with what was changed of them in the window.

use luxel::formats::SurfaceChange;
use luxel::scene::{Object, Restyle, Scene, SceneMaterial};
use std::collections::BTreeMap;

/// What was changed of the scene's materials.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Wardrobe {
    changes: BTreeMap<usize, Restyle>,
}

impl Wardrobe {
    /// What was changed of a material, to be changed further.
    pub(crate) fn change(&mut self, material: usize) -> &mut Restyle {
        self.changes.entry(material).or_default()
    }

    /// A material is as it was again.
    pub(crate) fn undo(&mut self, material: usize) {
        self.changes.remove(&material);
    }

    pub(crate) fn is_changed(&self, material: usize) -> bool {
        self.changes.contains_key(&material)
    }

    /// The changes, as scene files say them: by the material's name in the model, or by the objects that
    /// wear it.
    ///
    /// # Errors
    /// The name of a surface that can't be told from others.
    pub(crate) fn said(
        &self,
        scene: &Scene,
        objects: &[Object],
    ) -> Result<Vec<SurfaceChange>, String> {
        let mut said = Vec::new();
        for (&at, restyle) in &self.changes {
            let Some(material) = scene.materials.get(at) else { continue };
            let same = scene.materials.iter().filter(|one| one.name == material.name);
            if same.count() == 1 {
                let surface = Some(material.name.clone());
                said.push(SurfaceChange { object: None, surface, restyle: restyle.clone() });
                continue;
            }
            // Several of one name: each object by itself.
            let path = |object: &Object| -> Vec<String> {
                scene.path(object.node).into_iter().map(str::to_owned).collect()
            };
            let wears = |object: &Object, other: bool| {
                materials_of(scene, object.mesh.index()).into_iter().any(|worn| {
                    (worn == at) != other && scene.materials[worn].name == material.name
                })
            };
            for object in objects.iter().filter(|object| wears(object, false)) {
                let own = path(object);
                let others = objects.iter().filter(|one| path(one).starts_with(&own));
                if others.clone().any(|one| wears(one, true)) {
                    let name = &material.name;
                    return Err(format!(
                        "several surfaces are called `{name}`: a scene file can't tell them apart"
                    ));
                }
                said.push(SurfaceChange {
                    object: Some(own),
                    surface: Some(material.name.clone()),
                    restyle: restyle.clone(),
                });
            }
        }
        Ok(said)
    }

    /// A material as it is worn.
    pub(crate) fn worn(&self, scene: &Scene, material: usize) -> SceneMaterial {
        let mut worn = scene.materials.get(material).cloned().unwrap_or_default();
        if let Some(change) = self.changes.get(&material) {
            change.apply(&mut worn);
        }
        worn
    }

    /// All of them; `None`, if they are the scene's own.
    pub(crate) fn all(&self, scene: &Scene) -> Option<Vec<SceneMaterial>> {
        let all = || (0..scene.materials.len()).map(|at| self.worn(scene, at)).collect();
        (!self.changes.is_empty()).then(all)
    }
}

/// How many of the scene's surfaces have each of its materials.
pub(crate) fn uses_of_materials(scene: &Scene) -> Vec<usize> {
    let mut uses = vec![0; scene.materials.len()];
    for object in scene.objects() {
        for material in materials_of(scene, object.mesh.index()) {
            uses[material] += 1;
        }
    }
    uses
}

/// The materials of a mesh, each once, in order.
pub(crate) fn materials_of(scene: &Scene, mesh: usize) -> Vec<usize> {
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
    use luxel::scene::demos;

    #[test]
    fn what_is_changed_is_worn_and_undone() {
        let scene = demos::demo("plane").unwrap();
        let mut wardrobe = Wardrobe::default();
        assert_eq!(wardrobe.all(&scene), None);
        wardrobe.change(0).k_d = Some(0.25);
        let worn = wardrobe.all(&scene).unwrap();
        assert_eq!(worn[0].constants.k_d, 0.25);
        assert_eq!(worn[0].constants.k_s, scene.materials[0].constants.k_s);
        assert_eq!(worn[1..], scene.materials[1..]);
        wardrobe.undo(0);
        assert_eq!((wardrobe.all(&scene), wardrobe.is_changed(0)), (None, false));
    }

    #[test]
    fn changes_are_said_by_surface_or_by_object_or_not_at_all() {
        let mut scene = demos::demo("spheres").unwrap();
        let mut wardrobe = Wardrobe::default();
        wardrobe.change(1).k_d = Some(0.5);
        let said = wardrobe.said(&scene, &scene.objects()).unwrap();
        assert_eq!(said.len(), 1);
        assert_eq!(said[0].surface.as_ref(), Some(&scene.materials[1].name));
        assert_eq!((&said[0].object, said[0].restyle.k_d), (&None, Some(0.5)));
        // Two materials of one name, on different objects.
        scene.materials[0].name = scene.materials[1].name.clone();
        let said = wardrobe.said(&scene, &scene.objects()).unwrap();
        let objects = scene.objects();
        let wears = |object: &&Object| materials_of(&scene, object.mesh.index()) == [1];
        let path = scene.path(objects.iter().find(wears).unwrap().node).join("/");
        assert_eq!(said.len(), 1);
        assert_eq!(said[0].object.as_ref().map(|names| names.join("/")), Some(path));
        // And on objects of one name.
        let nodes: Vec<_> = objects.iter().map(|object| object.node).collect();
        for node in nodes {
            scene.nodes[node.index()].name = "ball".to_owned();
        }
        assert!(wardrobe.said(&scene, &scene.objects()).is_err());
    }

    #[test]
    fn each_surface_counts_once_for_its_material() {
        let scene = demos::demo("spheres").unwrap();
        let uses = uses_of_materials(&scene);
        let surfaces = scene.objects().len();
        assert_eq!((uses.len(), uses.iter().sum::<usize>()), (scene.materials.len(), surfaces));
    }
}
