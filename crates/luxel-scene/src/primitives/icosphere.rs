//! Spheres from the icosahedron: triangles of nearly equal size, no poles.

use super::FINEST;
use super::builder::{MeshBuilder, SurfacePoint};
use crate::Mesh;
use glam::{DVec2, DVec3};
use std::f64::consts::{PI, TAU};

/// The golden ratio.
const PHI: f64 = 1.618_033_988_749_895;

/// Corners of an icosahedron (Coxeter 1973, *Regular Polytopes*, section 3.7).
const CORNERS: [[f64; 3]; 12] = [
    [-1.0, PHI, 0.0],
    [1.0, PHI, 0.0],
    [-1.0, -PHI, 0.0],
    [1.0, -PHI, 0.0],
    [0.0, -1.0, PHI],
    [0.0, 1.0, PHI],
    [0.0, -1.0, -PHI],
    [0.0, 1.0, -PHI],
    [PHI, 0.0, -1.0],
    [PHI, 0.0, 1.0],
    [-PHI, 0.0, -1.0],
    [-PHI, 0.0, 1.0],
];

/// Its faces, counter-clockwise seen from outside.
const FACES: [[usize; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

/// A geodesic sphere: each of the icosahedron's 20 faces cut into `frequency`^2 triangles (1 to
/// 1024) and blown up to the sphere.
///
/// The texture is the map of [`sphere`](super::sphere); triangles across its seam reach beyond 1,
/// where a repeating texture goes on.
#[must_use]
pub fn icosphere(radius: f64, frequency: u32) -> Mesh {
    geodesic(frequency, |direction| (direction * radius, direction))
}

/// A mesh like [`icosphere`], its vertices where `place` puts each unit direction: position and
/// normal.
pub(crate) fn geodesic(frequency: u32, place: impl Fn(DVec3) -> (DVec3, DVec3)) -> Mesh {
    let frequency = frequency.clamp(1, FINEST / 4);
    let mut builder = MeshBuilder::default();
    for face in FACES {
        let [a, b, c] = face.map(|corner| DVec3::from_array(CORNERS[corner]));
        // Rows run from corner a to the edge between b and c. Two faces add the same two terms on
        // their shared edge, and a zero, so its points have the same bits in both.
        let lattice: Vec<Vec<LatticePoint>> = (0..=frequency)
            .map(|row| {
                let along_row = (0..=row).map(|step| {
                    let weights = [frequency - row, row - step, step].map(f64::from);
                    let sum = a * weights[0] + b * weights[1] + c * weights[2];
                    LatticePoint::new(&mut builder, sum.normalize(), &place)
                });
                along_row.collect()
            })
            .collect();
        for row in 0..frequency as usize {
            let (above, below) = (&lattice[row], &lattice[row + 1]);
            for step in 0..=row {
                add(&mut builder, [above[step], below[step], below[step + 1]]);
                if step < row {
                    add(&mut builder, [above[step], below[step + 1], above[step + 1]]);
                }
            }
        }
    }
    builder.finish()
}

/// A vertex of a face, before it is known which side of the texture's seam it is wanted on.
#[derive(Clone, Copy)]
struct LatticePoint {
    vertex: u32,
    point: SurfacePoint,
    at_pole: bool,
}

impl LatticePoint {
    fn new(
        builder: &mut MeshBuilder,
        direction: DVec3,
        place: &impl Fn(DVec3) -> (DVec3, DVec3),
    ) -> Self {
        let (position, normal) = place(direction);
        // The seam is at -Z; u grows to the right seen from outside.
        let u = 0.5 + libm::atan2(direction.x, direction.z) / TAU;
        let v = libm::acos(direction.y.clamp(-1.0, 1.0)) / PI;
        let point = SurfacePoint { position, normal, uv: DVec2::new(u, v) };
        let at_pole = direction.x == 0.0 && direction.z == 0.0;
        Self { vertex: builder.vertex(point), point, at_pole }
    }
}

/// Adds a triangle, with separate vertices where it crosses the seam or touches a pole.
fn add(builder: &mut MeshBuilder, corners: [LatticePoint; 3]) {
    let mut u = corners.map(|corner| corner.point.uv.x);
    let off_pole = || (0..3).filter(|&corner| !corners[corner].at_pole);
    let highest = off_pole().map(|corner| u[corner]).fold(0.0, f64::max);
    for corner in off_pole() {
        if highest - u[corner] > 0.5 {
            u[corner] += 1.0;
        }
    }
    // A pole lies on every meridian: it takes the one between the other two corners.
    if let Some(pole) = (0..3).find(|&corner| corners[corner].at_pole) {
        u[pole] = (u[(pole + 1) % 3] + u[(pole + 2) % 3]) * 0.5;
    }
    let vertices = std::array::from_fn(|corner| {
        let LatticePoint { vertex, mut point, .. } = corners[corner];
        if u[corner] == point.uv.x {
            return vertex;
        }
        point.uv.x = u[corner];
        builder.vertex(point)
    });
    builder.triangle(vertices);
}
