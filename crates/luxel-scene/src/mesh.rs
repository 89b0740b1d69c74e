//! Meshes: triangles over shared positions, with the attributes that shading interpolates.

use crate::MaterialId;
use glam::{DMat4, DVec3};
use luxel_parallel::{each, map};
use std::sync::atomic::{AtomicBool, Ordering};

/// Triangles in the file's order, with points and lines beside them.
///
/// A corner names two things: a *position* (`triangles`), shared by all faces that meet there, and
/// an *attribute vertex* (`attribute_corners`), which carries normal, texture coordinates and
/// colour and is split where those change. Where no position is split, one index serves both.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Mesh {
    /// The place that positions are relative to, so that f32 suffices far from the world's origin.
    pub origin: DVec3,
    /// Positions about `origin`.
    pub positions: Vec<[f32; 3]>,
    /// The positions of each triangle's corners, counter-clockwise seen from the front.
    pub triangles: Vec<[u32; 3]>,
    /// The attribute vertices of each triangle's corners; `None` if they are numbered like the
    /// positions.
    pub attribute_corners: Option<Vec<[u32; 3]>>,
    /// Unit normals of the attribute vertices; empty if the file has none.
    pub normals: Vec<[f32; 3]>,
    /// The faults of the file's normals before their repair, in order of positions.
    pub normal_faults: Vec<NormalFault>,
    /// Unit tangents, with the bitangent's sign; empty if there are none.
    pub tangents: Vec<[f32; 4]>,
    /// Texture coordinates of up to two sets, (0, 0) at the image's upper left; empty if none.
    pub uvs: [Vec<[f32; 2]>; 2],
    /// Linear colours with alpha; empty if there are none.
    pub colors: Vec<[f32; 4]>,
    /// The file's polygon that each triangle is part of; `None`: each is its own.
    pub polygons: Option<Vec<u32>>,
    /// The smoothing group of each triangle, 0 for faceted; `None`: the crease angle decides.
    pub smoothing_groups: Option<Vec<u32>>,
    /// Runs of triangles that share a material, in order and without gaps.
    pub parts: Vec<Part>,
    /// Points.
    pub points: Vec<Points>,
    /// Line segments.
    pub lines: Vec<Lines>,
    /// Where each of several objects ends that share the mesh; empty if it is one object's.
    ///
    /// Small objects of a file share a mesh, so that each takes no more memory than its triangles: see
    /// [`Joiner`](crate::Joiner). Such a mesh is shown whole, by nodes that follow one another in
    /// one place, one for each section in their order. [`Scene::mesh_of`](crate::Scene::mesh_of) is an
    /// object's own mesh, and [`Scene::separate`](crate::Scene::separate) gives each its own for good.
    pub sections: Vec<Section>,
}

/// Where an object ends in a mesh that several share. It begins where the one before it ends.
///
/// No triangle of it uses positions or attribute vertices of another, and there are neither points nor
/// lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Section {
    /// The end of its triangles.
    pub triangles: u32,
    /// The end of its positions.
    pub positions: u32,
    /// The end of its attribute vertices.
    pub attributes: u32,
}

/// A normal that is none, or not of unit length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct NormalFault {
    /// The index of its position.
    pub position: u32,
    /// Whether it is zero or not finite; else its length isn't 1.
    pub undefined: bool,
}

impl NormalFault {
    /// Tolerance of the length: more than the error of normals in signed bytes.
    const TOLERANCE: f64 = 0.02;

    /// The fault of a normal, if any.
    #[must_use]
    pub fn of(position: u32, normal: [f32; 3]) -> Option<Self> {
        let [x, y, z] = normal.map(f64::from);
        let length = (x * x + y * y + z * z).sqrt();
        let undefined = !(length > 0.0 && length.is_finite());
        let is_sound = !undefined && (length - 1.0).abs() <= Self::TOLERANCE;
        (!is_sound).then_some(Self { position, undefined })
    }
}

/// A run of triangles with one material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Part {
    /// The first triangle.
    pub first: u32,
    /// How many.
    pub count: u32,
    /// The material.
    pub material: MaterialId,
}

/// Positions drawn as points.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Points {
    /// Positions, by number.
    pub indices: Vec<u32>,
    /// The material.
    pub material: MaterialId,
}

/// Position pairs drawn as lines.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Lines {
    /// The two ends of each segment, positions by number.
    pub segments: Vec<[u32; 2]>,
    /// The material.
    pub material: MaterialId,
}

impl Mesh {
    /// The attribute vertices of each triangle's corners.
    #[must_use]
    pub fn attribute_corners(&self) -> &[[u32; 3]] {
        self.attribute_corners.as_deref().unwrap_or(&self.triangles)
    }

    /// The position of a corner, in f64, in the mesh's own space.
    #[must_use]
    #[inline]
    pub fn position(&self, index: u32) -> DVec3 {
        self.place(self.positions[index as usize])
    }

    /// A place about the mesh's origin, as [`Mesh::positions`] has them, in f64, in the mesh's own space.
    #[must_use]
    #[inline]
    pub fn place(&self, [x, y, z]: [f32; 3]) -> DVec3 {
        self.origin + DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    }

    /// Takes f64 positions, choosing the middle of their bounds as the origin if they lie so far
    /// out that f32 about zero would lose more than a millionth of the mesh's extent.
    pub fn set_positions(&mut self, positions: &[[f64; 3]]) {
        let mut bounds = Bounds::EMPTY;
        for &position in positions {
            let position = DVec3::from_array(position);
            if position.is_finite() {
                bounds.include(position);
            }
        }
        self.origin = if !bounds.is_empty() && !bounds.is_near_zero() {
            (bounds.min + bounds.max) * 0.5
        } else {
            DVec3::ZERO
        };
        let origin = self.origin;
        self.positions = positions
            .iter()
            .map(|position| (DVec3::from_array(*position) - origin).as_vec3().to_array())
            .collect();
    }

    /// The bounds of everything drawn: triangles, points and lines; empty if there is nothing.
    ///
    /// All of them are visited. For the meshes of a scene, [`Meshes::bounds_of`] is quicker.
    ///
    /// [`Meshes::bounds_of`]: crate::Meshes::bounds_of
    #[must_use]
    pub fn bounds(&self, world_from_mesh: &DMat4) -> Bounds {
        let drawn = self.drawn_positions();
        let of_runs = map(drawn.len(), POSITIONS, &|run| {
            let mut bounds = Bounds::EMPTY;
            for index in run.filter(|&index| drawn[index]) {
                bounds.include(world_from_mesh.transform_point3(self.position(index as u32)));
            }
            Some(bounds)
        });
        of_runs.iter().flatten().fold(Bounds::EMPTY, |all, bounds| all.union(bounds))
    }

    /// Whether there is nothing to draw.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
            && self.points.iter().all(|points| points.indices.is_empty())
            && self.lines.iter().all(|lines| lines.segments.is_empty())
    }

    /// Whether each position is drawn: as the corner of a triangle, as a point, or as the end of a
    /// line.
    pub(crate) fn drawn_positions(&self) -> Vec<bool> {
        let mut drawn = Vec::new();
        drawn.resize_with(self.positions.len(), || AtomicBool::new(false));
        let draw = |indices: &[u32]| {
            for &index in indices {
                drawn[index as usize].store(true, Ordering::Relaxed);
            }
        };
        let corners = self.triangles.as_flattened();
        each(corners.chunks(CORNERS), &draw);
        self.points.iter().for_each(|points| draw(&points.indices));
        self.lines.iter().for_each(|lines| draw(lines.segments.as_flattened()));
        drawn.into_iter().map(AtomicBool::into_inner).collect()
    }
}

/// How many positions one thread takes at a time.
const POSITIONS: usize = 1 << 12;
/// How many corners.
const CORNERS: usize = 1 << 15;

/// A box along the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The lowest coordinates.
    pub min: DVec3,
    /// The highest coordinates.
    pub max: DVec3,
}

impl Bounds {
    /// The bounds of nothing.
    pub const EMPTY: Self = Self { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// Whether f32 about zero loses no more than a millionth of the extent.
    pub(crate) fn is_near_zero(&self) -> bool {
        let far_out = self.min.abs().max(self.max.abs()).max_element();
        let extent = (self.max - self.min).max_element();
        far_out <= 16.0 * extent
    }

    /// Whether the bounds are empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// Grows to hold a point. A coordinate that is not a number changes nothing.
    pub fn include(&mut self, point: DVec3) {
        *self = self.union(&Self { min: point, max: point });
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(&self, other: &Self) -> Self {
        // glam's `min` and `max` of a number and NaN depend on which of them is the first.
        let (is_lower, is_higher) = (other.min.cmple(self.min), other.max.cmpge(self.max));
        Self {
            min: DVec3::select(is_lower, other.min, self.min),
            max: DVec3::select(is_higher, other.max, self.max),
        }
    }

    /// The middle.
    #[must_use]
    pub fn centre(&self) -> DVec3 {
        (self.min + self.max) * 0.5
    }

    /// Half the diagonal.
    #[must_use]
    pub fn radius(&self) -> f64 {
        (self.max - self.min).length() * 0.5
    }

    /// The eight corners.
    #[must_use]
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|corner| {
            let pick =
                |axis: usize| if corner >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_position_that_is_not_a_number_takes_nothing_out_of_the_bounds() {
        let positions = [[-1.0, 2.0, 3.0], [4.0, 0.0, -2.0], [f32::NAN; 3]];
        for order in [[0, 1, 2], [0, 2, 1], [2, 1, 0]] {
            let mesh = Mesh {
                positions: order.map(|at: usize| positions[at]).to_vec(),
                triangles: vec![[0, 1, 2]],
                ..Mesh::default()
            };
            let expected =
                Bounds { min: DVec3::new(-1.0, 0.0, -2.0), max: DVec3::new(4.0, 2.0, 3.0) };
            assert_eq!(mesh.bounds(&DMat4::IDENTITY), expected, "{order:?}");
        }
    }
}
