//! What a check asks and answers.

use crate::finding::{Finding, Kind, Place};
use crate::surface::HalfEdge;
use luxel_render::{Execution, View};
use luxel_scene::{DVec3, Mesh, NormalOptions, Object};

/// What the findings hang on, beside the scene.
#[derive(Clone, Debug)]
pub struct Setup {
    /// The picture that is to be drawn: its camera decides on outlines; highlights are asked for
    /// where its shading lights vertices, and drift where it interpolates in the window.
    pub view: View,
    /// Where normals come from.
    pub normals: NormalOptions,
    /// How the pictures are drawn by which severity is measured.
    pub execution: Execution,
}

impl Setup {
    /// Highlights that lose this many steps are told of: a sixteenth of the range.
    pub const LEAST_HIGHLIGHT: f32 = 16.0;
    /// Things that slide this far in the window are told of, in pixels.
    pub const LEAST_DRIFT: f64 = 4.0;
    /// Outlines this far off are told of, in pixels: more than what a regular polygon of 16 sides has
    /// that fills the height of 720 pixels by eight tenths.
    pub const LEAST_OUTLINE: f64 = 6.0;
    /// How many places of a kind are told.
    pub const MOST_PLACES: usize = 16;
}

/// What a finding is at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spot {
    Triangle(u32),
    Edge(HalfEdge),
    /// A place, and a triangle that it is at.
    Vertex(u32, u32),
}

/// All that is found in a scene.
#[derive(Clone, Debug)]
pub struct Report {
    /// One entry for each kind that is found, in the order of [`Kind::ALL`].
    pub findings: Vec<Finding>,
    /// What is to be marked, with its object's number.
    pub(crate) spots: Vec<(Kind, u32, Spot)>,
}

/// Where something is, in the world.
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
    let position: DVec3 = object.world_from_mesh.transform_point3(position);
    Place { object: number, triangle: Some(triangle), position }
}
