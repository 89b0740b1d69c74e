//! Meshes that several small objects share: joining them, and taking them apart again.
//!
//! A mesh with its node, transforms, trees and clusters takes more than a kilobyte, whatever is in it, and
//! a file of some megabytes may have hundreds of thousands of them. Joined, each takes a [`Section`] of
//! twelve bytes, and all are culled, drawn and measured together.
//!
//! A section is what the object's own mesh would be, with its numbers shifted: positions aren't shared
//! across sections, so that normals, edges and outlines stay those of the object. Objects far from the
//! world's origin are joined where one origin serves all of them as well as each its own.

use crate::{Bounds, Mesh, MeshId, Name, Node, NormalFault, Part, Scene, Section};
use glam::DVec3;
use std::borrow::Cow;
use std::ops::Range;

/// What a section of a mesh has, by number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SectionRange {
    /// Its triangles.
    pub triangles: Range<u32>,
    /// Its positions.
    pub positions: Range<u32>,
    /// Its attribute vertices.
    pub attributes: Range<u32>,
}

/// Objects of more triangles keep a mesh of their own: what a mesh takes is little beside them.
const MOST_TRIANGLES: usize = 128;

/// Joined objects have less of everything, so that 32 bits number it with room to spare.
const MOST_JOINED: usize = 1 << 28;

impl Mesh {
    /// What a section has; everything, for a mesh without sections.
    ///
    /// # Panics
    /// If the mesh has sections, but not this one.
    #[must_use]
    pub fn range_of(&self, section: u32) -> SectionRange {
        let Some(end) = self.sections.get(section as usize) else {
            assert!(self.sections.is_empty(), "the mesh has no section {section}");
            return self.whole();
        };
        let before = match section {
            0 => Section::default(),
            _ => self.sections[section as usize - 1],
        };
        SectionRange {
            triangles: before.triangles..end.triangles,
            positions: before.positions..end.positions,
            attributes: before.attributes..end.attributes,
        }
    }

    fn whole(&self) -> SectionRange {
        SectionRange {
            triangles: 0..self.triangles.len() as u32,
            positions: 0..self.positions.len() as u32,
            attributes: 0..self.attribute_count() as u32,
        }
    }

    /// The section of a triangle, and the triangle's number in it.
    #[must_use]
    #[inline]
    pub fn section_of(&self, triangle: u32) -> (u32, u32) {
        if self.sections.is_empty() {
            return (0, triangle);
        }
        let section = self.sections.partition_point(|section| section.triangles <= triangle);
        let first = section.checked_sub(1).map_or(0, |before| self.sections[before].triangles);
        (section as u32, triangle - first)
    }

    /// A section as a mesh; the mesh itself if it has none.
    ///
    /// # Panics
    /// If the mesh has sections, but not this one.
    #[must_use]
    pub fn section(&self, section: u32) -> Cow<'_, Self> {
        if self.sections.is_empty() {
            return Cow::Borrowed(self);
        }
        Cow::Owned(self.extracted(&self.range_of(section)))
    }

    /// Sections as meshes, in their order.
    pub(crate) fn separated(&self) -> impl Iterator<Item = Self> + '_ {
        (0..self.sections.len() as u32).map(|section| self.extracted(&self.range_of(section)))
    }

    fn extracted(&self, range: &SectionRange) -> Self {
        let SectionRange { triangles, positions, attributes } = range;
        let down = |corners: &[[u32; 3]], by: u32| {
            let corners = &corners[indices(triangles)];
            corners.iter().map(|corners| corners.map(|corner| corner - by)).collect::<Vec<_>>()
        };
        let own_triangles = down(&self.triangles, positions.start);
        let attribute_corners =
            self.attribute_corners.as_ref().map(|corners| down(corners, attributes.start));
        let faults_before =
            |end: u32| self.normal_faults.partition_point(|fault| fault.position < end);
        let faults = faults_before(positions.start)..faults_before(positions.end);
        Self {
            origin: self.origin,
            positions: self.positions[indices(positions)].to_vec(),
            attribute_corners: attribute_corners.filter(|corners| *corners != own_triangles),
            triangles: own_triangles,
            normals: some(&self.normals, attributes),
            normal_faults: self.normal_faults[faults]
                .iter()
                .map(|fault| NormalFault { position: fault.position - positions.start, ..*fault })
                .collect(),
            tangents: some(&self.tangents, attributes),
            uvs: [some(&self.uvs[0], attributes), some(&self.uvs[1], attributes)],
            colors: some(&self.colors, attributes),
            polygons: self.polygons.as_ref().and_then(|polygons| {
                let own = &polygons[indices(triangles)];
                let first = own.first().copied().unwrap_or_default();
                let is_any = own.windows(2).any(|pair| pair[0] == pair[1]);
                is_any.then(|| own.iter().map(|polygon| polygon - first).collect())
            }),
            smoothing_groups: self
                .smoothing_groups
                .as_ref()
                .map(|groups| groups[indices(triangles)].to_vec()),
            parts: self.parts_of(triangles),
            ..Self::default()
        }
    }

    /// The runs of one material in a run of triangles, numbered from its start.
    fn parts_of(&self, triangles: &Range<u32>) -> Vec<Part> {
        let first = self.parts.partition_point(|part| part.first + part.count <= triangles.start);
        let reaching = self.parts[first..].iter().take_while(|part| part.first < triangles.end);
        reaching
            .map(|part| {
                let start = part.first.max(triangles.start);
                let end = (part.first + part.count).min(triangles.end);
                Part { first: start - triangles.start, count: end - start, ..*part }
            })
            .collect()
    }

    /// How many attribute vertices there are.
    fn attribute_count(&self) -> usize {
        let [first, second] = &self.uvs;
        let counts =
            [self.normals.len(), self.tangents.len(), first.len(), second.len(), self.colors.len()];
        let most = counts.into_iter().max().unwrap_or_default();
        if most == 0 && self.attribute_corners.is_none() { self.positions.len() } else { most }
    }

    /// Whether attribute vertices are numbered like the positions, and are as many.
    fn is_numbered_once(&self) -> bool {
        self.attribute_corners.is_none() && self.attribute_count() == self.positions.len()
    }

    /// Whether it is small, and has nothing that sections don't.
    fn is_joinable(&self) -> bool {
        let Self { triangles, parts, polygons, .. } = self;
        let drawn: u32 = parts.iter().map(|part| part.count).sum();
        (1..=MOST_TRIANGLES).contains(&triangles.len())
            && drawn as usize == triangles.len()
            && polygons.as_ref().is_none_or(|polygons| polygons.is_sorted())
            && self.points.is_empty()
            && self.lines.is_empty()
            && self.sections.is_empty()
            && self.has_whole_attributes()
    }

    /// Whether attributes have a value for all attribute vertices, or none at all.
    fn has_whole_attributes(&self) -> bool {
        let count = self.attribute_count();
        let is_whole = |length: usize| length == 0 || length == count;
        let [first, second] = &self.uvs;
        (count > 0 || self.attribute_corners.is_none())
            && is_whole(self.normals.len())
            && is_whole(self.tangents.len())
            && is_whole(first.len())
            && is_whole(second.len())
            && is_whole(self.colors.len())
    }

    /// Whether both have the same attributes.
    fn has_attributes_of(&self, other: &Self) -> bool {
        let has = |mesh: &Self| {
            let [first, second] = &mesh.uvs;
            [
                mesh.normals.is_empty(),
                mesh.tangents.is_empty(),
                first.is_empty(),
                second.is_empty(),
                mesh.colors.is_empty(),
                mesh.smoothing_groups.is_some(),
            ]
        };
        has(self) == has(other)
    }

    /// Whether another small mesh may be a section beside it; if it `moves`, about this one's origin.
    fn takes(&self, other: &Self, moves: bool) -> bool {
        let count = self.positions.len() + self.attribute_count() + self.triangles.len();
        (self.is_joinable() || !self.sections.is_empty())
            && count < MOST_JOINED
            && self.has_attributes_of(other)
            && (self.origin == other.origin || moves && other.is_near(self.origin))
    }

    /// Whether f32 about a place suffices for it, by the rule of [`set_positions`](Self::set_positions).
    fn is_near(&self, origin: DVec3) -> bool {
        let mut bounds = Bounds::EMPTY;
        let positions = 0..self.positions.len() as u32;
        positions.for_each(|index| bounds.include(self.position(index) - origin));
        bounds.is_near_zero()
    }

    /// Puts it about another place.
    fn move_origin(&mut self, origin: DVec3) {
        if self.origin != origin {
            let place = |index: u32| (self.position(index) - origin).as_vec3().to_array();
            self.positions = (0..self.positions.len() as u32).map(place).collect();
            self.origin = origin;
        }
    }

    /// Adds a mesh about the same place, with the same attributes, as the last section.
    pub(crate) fn append(&mut self, other: Self) {
        if self.sections.is_empty() {
            self.sections.push(self.end());
        }
        let end = self.end();
        let up = |corners: &[u32; 3], by: u32| corners.map(|corner| corner + by);
        let own = self.triangles.len();
        if self.attribute_corners.is_none()
            && !(self.is_numbered_once() && other.is_numbered_once())
        {
            self.attribute_corners = Some(self.triangles.clone());
        }
        if let Some(corners) = &mut self.attribute_corners {
            corners.extend(other.attribute_corners().iter().map(|one| up(one, end.attributes)));
        }
        if self.polygons.is_none() && other.polygons.is_some() {
            self.polygons = Some((0..own as u32).collect());
        }
        if let Some(polygons) = &mut self.polygons {
            let next = polygons.last().map_or(0, |last| last + 1);
            match other.polygons {
                Some(others) => {
                    let first = others.first().copied().unwrap_or_default();
                    polygons.extend(others.iter().map(|polygon| polygon - first + next));
                }
                None => polygons.extend(next..next + other.triangles.len() as u32),
            }
        }
        for part in other.parts {
            let first = part.first + end.triangles;
            match self.parts.last_mut() {
                Some(last) if last.material == part.material => last.count += part.count,
                _ => self.parts.push(Part { first, ..part }),
            }
        }
        let faults = other.normal_faults.iter();
        self.normal_faults.extend(
            faults.map(|fault| NormalFault { position: fault.position + end.positions, ..*fault }),
        );
        if let (Some(groups), Some(others)) = (&mut self.smoothing_groups, other.smoothing_groups) {
            groups.extend(others);
        }
        self.triangles.extend(other.triangles.iter().map(|one| up(one, end.positions)));
        self.positions.extend(other.positions);
        self.normals.extend(other.normals);
        self.tangents.extend(other.tangents);
        for (uvs, others) in self.uvs.iter_mut().zip(other.uvs) {
            uvs.extend(others);
        }
        self.colors.extend(other.colors);
        self.sections.push(self.end());
    }

    /// The end of everything.
    fn end(&self) -> Section {
        Section {
            triangles: self.triangles.len() as u32,
            positions: self.positions.len() as u32,
            attributes: self.attribute_count() as u32,
        }
    }

    /// Replaces each section by what `change` makes of it.
    pub(crate) fn change_sections(&mut self, change: &mut dyn FnMut(&mut Self)) {
        let mut sections = self.separated().map(|mut section| {
            change(&mut section);
            section
        });
        let Some(mut all) = sections.next() else { return };
        all.sections.push(all.end());
        // Attributes may become more; all else stays.
        all.sections.reserve_exact(self.sections.len());
        all.positions.reserve_exact(self.positions.len());
        all.triangles.reserve_exact(self.triangles.len());
        if !all.normals.is_empty() {
            all.normals.reserve(self.positions.len());
        }
        sections.for_each(|section| all.append(section));
        *self = all;
    }
}

/// The elements of an array at a range of numbers.
fn indices(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}

/// A part of an attribute, or nothing of one that a mesh lacks.
fn some<T: Clone>(attribute: &[T], range: &Range<u32>) -> Vec<T> {
    attribute.get(indices(range)).map(<[T]>::to_vec).unwrap_or_default()
}

/// The objects of a file without transforms, in their order: joins small ones that follow one another, if
/// there are many.
#[derive(Debug)]
pub struct Joiner {
    nodes: Vec<Node>,
    meshes: Vec<Mesh>,
    joins: bool,
}

/// Files of fewer objects keep a mesh for each: what meshes take is little then.
const LEAST_OBJECTS: usize = 1000;

/// Meshes until which each joined object keeps its origin, and with it every bit of its positions.
const MOST_APART: usize = 10_000;

impl Joiner {
    /// For a file of so many objects.
    #[must_use]
    pub fn new(objects: usize) -> Self {
        Self {
            nodes: Vec::with_capacity(objects),
            meshes: Vec::new(),
            joins: objects >= LEAST_OBJECTS,
        }
    }

    /// Adds an object.
    pub fn push(&mut self, name: impl Into<Name>, mut mesh: Mesh) {
        if self.joins
            && mesh.is_joinable()
            && let moves = self.meshes.len() > MOST_APART
            && let Some(last) = self.meshes.last_mut().filter(|last| last.takes(&mesh, moves))
        {
            mesh.move_origin(last.origin);
            last.append(mesh);
        } else {
            self.meshes.push(mesh);
        }
        let id = MeshId(self.meshes.len() as u32 - 1);
        let sections = self.meshes.last().map_or(0, |last| last.sections.len() as u32);
        let section = sections.saturating_sub(1);
        self.nodes.push(Node { section, ..Node::root(name, Some(id)) });
    }

    /// Makes the objects a scene's.
    pub fn finish(mut self, scene: &mut Scene) {
        self.meshes.shrink_to_fit();
        for mesh in self.meshes.iter_mut().filter(|mesh| !mesh.sections.is_empty()) {
            mesh.positions.shrink_to_fit();
            mesh.triangles.shrink_to_fit();
            mesh.parts.shrink_to_fit();
            mesh.sections.shrink_to_fit();
        }
        (scene.nodes, scene.meshes) = (self.nodes, self.meshes.into());
    }
}

impl Scene {
    /// Whether objects share meshes as [sections](Mesh::sections) of them.
    #[must_use]
    pub fn has_sections(&self) -> bool {
        self.meshes.iter().any(|mesh| !mesh.sections.is_empty())
    }

    /// The scene with a mesh for every object: see [`separate`](Self::separate).
    #[must_use]
    pub fn separated(&self) -> Cow<'_, Self> {
        if !self.has_sections() {
            return Cow::Borrowed(self);
        }
        let mut scene = self.clone();
        scene.separate();
        Cow::Owned(scene)
    }

    /// Gives every object a mesh of its own, which takes more memory, for whoever changes the mesh of one
    /// object alone, or measures meshes as objects. What is drawn and picked stays the same.
    pub fn separate(&mut self) {
        if !self.has_sections() {
            return;
        }
        let mut firsts = Vec::with_capacity(self.meshes.len());
        let mut meshes = Vec::new();
        for mesh in std::mem::take(&mut self.meshes) {
            firsts.push(meshes.len() as u32);
            if mesh.sections.is_empty() {
                meshes.push(mesh);
            } else {
                meshes.extend(mesh.separated());
            }
        }
        self.meshes = meshes.into();
        for node in &mut self.nodes {
            if let Some(mesh) = &mut node.mesh {
                *mesh = MeshId(firsts[mesh.index()] + std::mem::take(&mut node.section));
            }
        }
    }
}

#[cfg(test)]
mod tests;
