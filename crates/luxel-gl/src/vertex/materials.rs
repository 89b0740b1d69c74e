//! The materials of a run of vertices: `glMaterial` may stand between them.

use crate::state::material::SurfaceMaterial;

/// Front and back material.
pub(crate) type Sides = [SurfaceMaterial; 2];

/// Materials in the order in which they were set.
#[derive(Clone, Debug)]
pub(crate) struct Materials {
    first: Sides,
    /// Each with the first vertex that has it.
    later: Vec<(u32, Sides)>,
}

impl Materials {
    /// One material for all vertices.
    pub(crate) fn new(sides: Sides) -> Self {
        Self { first: sides, later: Vec::new() }
    }

    /// Changes the material for the next vertices, of which `count` are already there.
    pub(crate) fn set(&mut self, sides: Sides, count: usize) {
        let count = count as u32;
        // One that no vertex has is replaced.
        self.later.pop_if(|(first, _)| *first == count);
        if count == 0 {
            self.first = sides;
        } else if *self.last() != sides {
            self.later.push((count, sides));
        }
    }

    fn last(&self) -> &Sides {
        self.later.last().map_or(&self.first, |(_, sides)| sides)
    }

    /// Forgets all but the last.
    pub(crate) fn keep_last(&mut self) {
        self.first = *self.last();
        self.later.clear();
    }

    /// Whether vertices have different materials.
    pub(crate) fn vary(&self) -> bool {
        !self.later.is_empty()
    }

    /// The materials of a vertex.
    #[inline]
    pub(crate) fn of(&self, vertex: usize) -> &Sides {
        let number = self.later.partition_point(|(first, _)| *first as usize <= vertex);
        number.checked_sub(1).map_or(&self.first, |number| &self.later[number].1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn section_2_13_materials_belong_to_the_vertices_after_them() {
        let shiny = |shininess: f32| [SurfaceMaterial { shininess, ..Default::default() }; 2];
        let mut materials = Materials::new(shiny(9.0));
        for (shininess, count) in [(1.0, 0), (2.0, 1), (3.0, 1), (3.0, 2), (1.0, 3)] {
            materials.set(shiny(shininess), count);
        }
        let of = |vertex| materials.of(vertex)[0].shininess;
        assert_eq!([0, 1, 2, 3, 4].map(of), [1.0, 3.0, 3.0, 1.0, 1.0]);
        materials.keep_last();
        assert!(!materials.vary() && materials.of(0)[0].shininess == 1.0);
    }
}
