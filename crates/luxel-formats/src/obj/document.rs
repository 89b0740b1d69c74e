//! The statements of an OBJ file, before they are sorted into objects.

use luxel_scene::NormalFault;

/// "No such index" in a corner.
pub(super) const NONE: u32 = u32::MAX;

/// The statements of a file, in its order.
#[derive(Debug, Default)]
pub(super) struct Document<'a> {
    pub(super) positions: Vec<[f64; 3]>,
    /// Linear colours of the positions, NaN for those without; empty if none has one.
    pub(super) colors: Vec<[f32; 3]>,
    /// The second coordinate points down.
    pub(super) uvs: Vec<[f32; 2]>,
    /// Of unit length, or 0.
    pub(super) normals: Vec<[f32; 3]>,
    /// The faults of the normals, each with its index in `normals`, in order.
    pub(super) normal_faults: Vec<NormalFault>,
    /// Position, texture coordinates and normal of each corner, element by element.
    pub(super) corners: Vec<[u32; 3]>,
    pub(super) elements: Vec<Element>,
    /// Where objects and groups begin.
    pub(super) beginnings: Vec<Beginning<'a>>,
    /// The distinct names after `usemtl`.
    pub(super) materials: Vec<&'a [u8]>,
    /// The arguments of each `mtllib`.
    pub(super) libraries: Vec<&'a [u8]>,
    /// Whether the file has smoothing groups.
    pub(super) has_smoothing: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Face,
    Line,
    Points,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Element {
    pub(super) kind: Kind,
    /// End of its corners; they begin at the end of the previous element's.
    pub(super) end: u32,
    /// Index into the materials, or [`NONE`].
    pub(super) material: u32,
    pub(super) smoothing: u32,
}

/// The beginning of an object or a group.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginning<'a> {
    pub(super) is_object: bool,
    pub(super) name: &'a [u8],
    /// Its first element.
    pub(super) element: u32,
}

impl Document<'_> {
    /// Bytes that a corner takes in the later stages: itself, its share of triangles, and an
    /// attribute vertex.
    const BYTES_PER_CORNER: u64 = 12 + 12 + 8 + crate::weld::BYTES_PER_KEY + 36;

    /// The numbers of vertices, texture coordinates and normals.
    pub(super) const fn counts(&self) -> [usize; 3] {
        [self.positions.len(), self.uvs.len(), self.normals.len()]
    }

    /// An estimate of the memory of the document and its meshes.
    pub(super) fn bytes(&self) -> u64 {
        self.positions.len() as u64 * (24 + 24 + 4)
            + self.colors.len() as u64 * 12
            + self.uvs.len() as u64 * 8
            + self.normals.len() as u64 * 12
            + self.corners.len() as u64 * Self::BYTES_PER_CORNER
            + self.elements.len() as u64 * 16
            + (self.beginnings.len() + self.materials.len() + self.libraries.len()) as u64 * 400
    }

    /// Gives back what joining blocks has reserved, up to half of it: meshes are built beside it.
    pub(super) fn shrink(&mut self) {
        self.positions.shrink_to_fit();
        self.uvs.shrink_to_fit();
        self.normals.shrink_to_fit();
        self.corners.shrink_to_fit();
        self.elements.shrink_to_fit();
        self.beginnings.shrink_to_fit();
        self.materials.shrink_to_fit();
    }

    /// Makes points of all vertices, if there are no elements.
    pub(super) fn show_bare_vertices(&mut self) {
        if !self.elements.is_empty() {
            return;
        }
        let is_placed = |position: &[f64; 3]| position.iter().all(|&v| (v as f32).is_finite());
        let placed = (0..).zip(&self.positions).filter(|(_, position)| is_placed(position));
        self.corners = placed.map(|(index, _)| [index, NONE, NONE]).collect();
        if !self.corners.is_empty() {
            let end = self.corners.len() as u32;
            self.elements.push(Element { kind: Kind::Points, end, material: NONE, smoothing: 0 });
        }
    }

    /// The elements with their corners.
    pub(super) fn corners_of(&self, element: usize) -> &[[u32; 3]] {
        let start = if element == 0 { 0 } else { self.elements[element - 1].end };
        &self.corners[start as usize..self.elements[element].end as usize]
    }
}
