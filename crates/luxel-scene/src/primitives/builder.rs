//! Vertices and triangles collected into a mesh, coinciding positions welded.

use crate::{MaterialId, Mesh, Part};
use glam::{DVec2, DVec3};
use std::collections::HashMap;

/// A surface point with its shading attributes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfacePoint {
    pub(crate) position: DVec3,
    /// Of any length but 0.
    pub(crate) normal: DVec3,
    pub(crate) uv: DVec2,
}

/// A mesh being made. Corners are named by attribute vertices; positions with equal bits are one.
#[derive(Debug, Default)]
pub(crate) struct MeshBuilder {
    mesh: Mesh,
    /// The position of each attribute vertex.
    position_of: Vec<u32>,
    attribute_corners: Vec<[u32; 3]>,
    /// Never iterated, so that its order has no effect.
    positions_by_bits: HashMap<[u32; 3], u32>,
}

impl MeshBuilder {
    /// Adds an attribute vertex and gives its number.
    pub(crate) fn vertex(&mut self, point: SurfacePoint) -> u32 {
        // Adding zero makes -0 into 0, which would be another place by its bits.
        let position = point.position.as_vec3().to_array().map(|value| value + 0.0);
        let next = self.mesh.positions.len() as u32;
        let index = *self.positions_by_bits.entry(position.map(f32::to_bits)).or_insert(next);
        if index == next {
            self.mesh.positions.push(position);
        }
        self.position_of.push(index);
        let normal = point.normal.normalize_or(DVec3::Y).as_vec3().to_array();
        self.mesh.normals.push(normal.map(|value| value + 0.0));
        self.mesh.uvs[0].push(point.uv.as_vec2().to_array());
        self.position_of.len() as u32 - 1
    }

    /// Adds a triangle of attribute vertices, counter-clockwise from the front, unless two of its
    /// corners are one place.
    pub(crate) fn triangle(&mut self, corners: [u32; 3]) {
        let [a, b, c] = corners.map(|corner| self.position_of[corner as usize]);
        if a != b && b != c && c != a {
            self.mesh.triangles.push([a, b, c]);
            self.attribute_corners.push(corners);
        }
    }

    /// Adds a grid of `columns` x `rows` quadrilaterals, two triangles each. `point(column, row)`
    /// runs to the right and downwards, seen from the front, ends included.
    pub(crate) fn grid(
        &mut self,
        columns: u32,
        rows: u32,
        mut point: impl FnMut(u32, u32) -> SurfacePoint,
    ) {
        let first = self.position_of.len() as u32;
        for row in 0..=rows {
            for column in 0..=columns {
                self.vertex(point(column, row));
            }
        }
        let stride = columns + 1;
        for row in 0..rows {
            for column in 0..columns {
                let left_above = first + row * stride + column;
                let (right_above, left_below) = (left_above + 1, left_above + stride);
                let right_below = left_below + 1;
                self.triangle([left_above, left_below, right_below]);
                self.triangle([left_above, right_below, right_above]);
            }
        }
    }

    /// Adds a flat quadrilateral: corners counter-clockwise from the front, a whole texture from
    /// the first one (upper left) to the third.
    pub(crate) fn quadrilateral(&mut self, corners: [DVec3; 4]) {
        let [upper_left, lower_left, lower_right, upper_right] = corners;
        let normal = (lower_right - upper_left).cross(upper_right - lower_left);
        self.grid(1, 1, |column, row| {
            let position = match (column, row) {
                (0, 0) => upper_left,
                (0, _) => lower_left,
                (_, 0) => upper_right,
                _ => lower_right,
            };
            SurfacePoint { position, normal, uv: DVec2::new(f64::from(column), f64::from(row)) }
        });
    }

    /// The mesh, of one part with the first material.
    pub(crate) fn finish(self) -> Mesh {
        let mut mesh = self.mesh;
        let count = mesh.triangles.len() as u32;
        mesh.parts = vec![Part { first: 0, count, material: MaterialId(0) }];
        let same = self.position_of.iter().enumerate().all(|(at, &index)| at as u32 == index);
        mesh.attribute_corners = (!same).then_some(self.attribute_corners);
        mesh
    }
}
