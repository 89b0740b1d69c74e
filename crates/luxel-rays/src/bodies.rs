//! The objects of a scene as rays meet them: those that share a mesh as its sections are one body.

use luxel_scene::{AlphaMode, Mesh, Object, Scene, bodies};
use std::ops::Range;
use std::sync::Arc;

/// Objects, and their runs that share a tree.
pub(crate) struct Bodies {
    objects: Arc<Vec<Object>>,
    /// The ends of the runs; none if each object is a body of its own.
    ends: Vec<u32>,
}

impl Bodies {
    pub(crate) fn new(objects: Arc<Vec<Object>>) -> Self {
        let mut ends: Vec<u32> = bodies(&objects).map(|body| body.end as u32).collect();
        if ends.len() == objects.len() {
            ends = Vec::new();
        }
        ends.shrink_to_fit();
        Self { objects, ends }
    }

    /// Whether the objects of a scene can be traced by their bodies: none lacks a section of its mesh, and nothing
    /// shines through a part of it alone, since then rays would have to find all that is opaque, too.
    pub(crate) fn are_traceable(scene: &Scene, objects: &[Object]) -> bool {
        !scene.has_sections()
            || bodies(objects).all(|body| {
                let mesh = &scene.meshes[objects[body.start].mesh.index()];
                let is_whole = body.len() == mesh.sections.len();
                let mut opaque = opaque_parts(scene, mesh);
                let first = opaque.next();
                mesh.sections.is_empty() || is_whole && opaque.all(|is| Some(is) == first)
            })
    }

    pub(crate) fn objects(&self) -> &[Object] {
        &self.objects
    }

    pub(crate) fn len(&self) -> usize {
        if self.ends.is_empty() { self.objects.len() } else { self.ends.len() }
    }

    /// The objects of a body.
    pub(crate) fn objects_of(&self, body: usize) -> Range<usize> {
        if self.ends.is_empty() {
            return body..body + 1;
        }
        let start = body.checked_sub(1).map_or(0, |before| self.ends[before]);
        start as usize..self.ends[body] as usize
    }

    /// The first object of a body, whose mesh and place are those of all.
    pub(crate) fn object(&self, body: usize) -> &Object {
        &self.objects[self.objects_of(body).start]
    }

    pub(crate) fn body_of(&self, object: usize) -> usize {
        if self.ends.is_empty() {
            return object;
        }
        self.ends.partition_point(|end| *end as usize <= object)
    }
}

/// Whether each part of a mesh is opaque.
pub(crate) fn opaque_parts(scene: &Scene, mesh: &Mesh) -> impl Iterator<Item = bool> {
    let mode = |material: usize| scene.materials[material].alpha_mode;
    mesh.parts.iter().map(move |part| mode(part.material.index()) == AlphaMode::Opaque)
}
