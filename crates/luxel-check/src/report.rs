//! The setup and the report of a check.

use crate::finding::{Finding, Kind, Place};
use crate::surface::HalfEdge;
use luxel_render::{Execution, View};
use luxel_scene::{DVec3, Mesh, NormalOptions, Object};

/// The parameters of a check.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The view: its camera decides on silhouettes; highlights are checked if its shading lights
    /// vertices, drift if it interpolates in screen space.
    pub view: View,
    /// The source of normals.
    pub normals: NormalOptions,
    /// How pictures for severities are rendered.
    pub execution: Execution,
}

impl Setup {
    /// The least loss of a reported highlight, in 8-bit steps: a sixteenth of the range.
    pub const LEAST_HIGHLIGHT: f32 = 16.0;
    /// The least reported drift of attributes, in pixels.
    pub const LEAST_DRIFT: f64 = 4.0;
    /// The least reported deviation of a silhouette from its curve, in pixels: more than that of a regular
    /// polygon of 16 sides over eight tenths of 720 pixels.
    pub const LEAST_OUTLINE: f64 = 6.0;
    /// The most places listed for a kind.
    pub const MOST_PLACES: usize = 16;
}

/// The element of a finding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spot {
    Triangle(u32),
    Edge(HalfEdge),
    /// A position, and a triangle that uses it.
    Vertex(u32, u32),
}

/// The findings of a scene.
#[derive(Clone, Debug)]
pub struct Report {
    /// One entry per kind found, in the order of [`Kind::ALL`].
    pub findings: Vec<Finding>,
    /// The elements to mark, with their objects' indices.
    pub(crate) spots: Vec<(Kind, u32, Spot)>,
}

/// The place of an element in world space.
pub(crate) fn place(number: u32, object: &Object, mesh: &Mesh, spot: Spot) -> Place {
    let corner = |triangle: u32, k: usize| mesh.position(mesh.triangles[triangle as usize][k]);
    let (triangle, position) = match spot {
        Spot::Triangle(triangle) => {
            (triangle, (corner(triangle, 0) + corner(triangle, 1) + corner(triangle, 2)) / 3.0)
        }
        Spot::Edge(half_edge) => {
            let (triangle, k) = (half_edge / 3, (half_edge % 3) as usize);
            (triangle, (corner(triangle, k) + corner(triangle, (k + 1) % 3)) * 0.5)
        }
        Spot::Vertex(position, triangle) => (triangle, mesh.position(position)),
    };
    let position: DVec3 = object.world_from_mesh.matrix().transform_point3(position);
    Place { object: number, triangle: Some(triangle), position }
}
