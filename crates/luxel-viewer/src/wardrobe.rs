//! Materials as they are worn: those of the scene, with what was changed of them in the window.

use luxel::scene::{Restyle, Scene, SceneMaterial};
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
    fn each_surface_counts_once_for_its_material() {
        let scene = demos::demo("spheres").unwrap();
        let uses = uses_of_materials(&scene);
        let surfaces = scene.objects().len();
        assert_eq!((uses.len(), uses.iter().sum::<usize>()), (scene.materials.len(), surfaces));
    }
}
