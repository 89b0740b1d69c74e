//! Vertex normals against the faces that they stand for.

use crate::surface::{RUN, Surface};
use luxel_parallel::{any, fill, gather, sort_u64, sort_u128};
use luxel_scene::{DVec3, Mesh, NormalFault};

/// A normal is behind its face where the cosine of the angle to the face's is below this: two
/// degrees beyond the plane, more than files round.
const BEHIND: f64 = -0.035;

/// Normals say nothing of a face where their average is turned away from its own by more than this.
const UNREPRESENTATIVE_DEGREES: f64 = 60.0;

/// What is wrong with normals.
#[derive(Default)]
pub(crate) struct Normals {
    /// Attribute vertices whose normal points behind one of their faces, with the face.
    pub(crate) behind: Vec<(u32, u32)>,
    /// Triangles of which their normals know nothing.
    pub(crate) unrepresentative: Vec<u32>,
}

/// The normals at each triangle's corners.
pub(crate) fn of_corners(mesh: &Mesh) -> Vec<[DVec3; 3]> {
    let normal = |corner: u32| {
        let [x, y, z] = mesh.normals.get(corner as usize).copied().unwrap_or_default();
        DVec3::new(f64::from(x), f64::from(y), f64::from(z))
    };
    let corners = mesh.attribute_corners();
    let mut normals = vec![[DVec3::ZERO; 3]; corners.len()];
    fill(&mut normals, RUN, &|start, run| {
        for (normals, corners) in run.iter_mut().zip(&corners[start..]) {
            *normals = corners.map(normal);
        }
    });
    normals
}

/// A face's own normal, on the side that most of its vertices take for the front.
pub(crate) fn facing(surface: &Surface<'_>, normals: &[[DVec3; 3]], triangle: usize) -> DVec3 {
    let face = surface.area_vector(triangle as u32).normalize_or_zero();
    let sum: DVec3 = normals[triangle].iter().sum();
    if face.dot(sum) < 0.0 { -face } else { face }
}

/// Compares the normals of corners, which are those of the mesh as it is drawn, with their faces;
/// those left out, and those that are flipped as a whole, have been told of.
pub(crate) fn examine(
    surface: &Surface<'_>,
    drawn: &Mesh,
    normals: &[[DVec3; 3]],
    is_left_out: &[bool],
) -> Normals {
    let least = libm::cos(UNREPRESENTATIVE_DEGREES.to_radians());
    let face = |triangle: usize| facing(surface, normals, triangle);
    let kept = |triangle: &usize| !is_left_out[*triangle];
    let corners = drawn.attribute_corners();
    // Vertex above, triangle below.
    let mut behind = gather(surface.triangles.len(), RUN, &|run, found| {
        for triangle in run.filter(kept) {
            let face = face(triangle);
            for (vertex, normal) in corners[triangle].into_iter().zip(&normals[triangle]) {
                if normal.dot(face) < BEHIND {
                    found.push(u64::from(vertex) << 32 | triangle as u64);
                }
            }
        }
    });
    sort_u64(&mut behind);
    behind.dedup_by_key(|key| *key >> 32);
    let behind = behind.into_iter().map(|key| ((key >> 32) as u32, key as u32)).collect();
    let unrepresentative = gather(surface.triangles.len(), RUN, &|run, found| {
        for triangle in run.filter(kept) {
            let sum: DVec3 = normals[triangle].iter().sum();
            let has_all = normals[triangle].iter().all(|normal| normal.length_squared() > 0.25);
            if has_all && face(triangle).dot(sum.normalize_or_zero()) < least {
                found.push(triangle as u32);
            }
        }
    });
    Normals { behind, unrepresentative }
}

/// What is wrong with the normals of the file: what its reader has told, and what is still there.
pub(crate) fn faults(mesh: &Mesh) -> Vec<NormalFault> {
    let mut faults = mesh.normal_faults.clone();
    let is_wrong = |vertex: usize| {
        mesh.normals.get(vertex).is_some_and(|normal| NormalFault::of(0, *normal).is_some())
    };
    if any(mesh.normals.len(), RUN, &|mut run| run.any(is_wrong)) {
        for (corners, places) in mesh.attribute_corners().iter().zip(&mesh.triangles) {
            for (&corner, &place) in corners.iter().zip(places) {
                if is_wrong(corner as usize) {
                    faults.extend(NormalFault::of(place, mesh.normals[corner as usize]));
                }
            }
        }
        faults.sort_unstable();
        faults.dedup();
    }
    faults
}

/// Attribute vertices equal to an earlier one in all that the file says of them, on a surface that
/// is smooth there although each of both has faces of its own: whoever averages normals by the
/// vertices' numbers shows a seam.
pub(crate) fn seams(surface: &Surface<'_>, normals: &[[DVec3; 3]]) -> Vec<u32> {
    /// Averages closer together than this show no seam: two degrees.
    const SEAM: f64 = 0.999_39;
    /// Smooth surfaces have one normal on both sides, to this cosine.
    const SMOOTH: f64 = 0.999_9;
    /// With so many earlier vertices each is compared.
    const MOST_COMPARED: usize = 64;
    let mesh = surface.mesh;
    let is_whole = surface.triangles[..] == mesh.triangles[..surface.triangles.len()];
    if is_whole && mesh.attribute_corners.is_none() {
        // No two positions are at one place.
        return Vec::new();
    }
    // For each attribute vertex: its position, the normal that is drawn, the one of its own faces.
    let highest = mesh.attribute_corners().as_flattened().iter().max();
    let count = highest.map_or(0, |&highest| highest as usize + 1);
    let mut position_of = vec![u32::MAX; count];
    let mut drawn = vec![DVec3::ZERO; count];
    let mut own = vec![DVec3::ZERO; count];
    for (triangle, corners) in mesh.attribute_corners().iter().enumerate() {
        let Some(normals) = normals.get(triangle) else { break };
        let area = surface.area_vector(triangle as u32);
        for k in 0..3 {
            let vertex = corners[k] as usize;
            position_of[vertex] = mesh.triangles[triangle][k];
            drawn[vertex] = normals[k];
            own[vertex] += area;
        }
    }
    fill(&mut own, RUN, &|_, run| run.iter_mut().for_each(|sum| *sum = sum.normalize_or_zero()));
    // 0 and -0 are the same.
    let bits = |value: f32| (value + 0.0).to_bits();
    // Vertices by their positions, then by their numbers.
    let mut at_places = gather(count, RUN, &|run, keys| {
        for vertex in run.filter(|&vertex| position_of[vertex] != u32::MAX) {
            let position = mesh.positions[position_of[vertex] as usize];
            let [x, y, z] = position.map(|value| u128::from(bits(value)));
            keys.push(x << 96 | y << 64 | z << 32 | vertex as u128);
        }
    });
    sort_u128(&mut at_places);
    let rest = |vertex: u32| {
        let [first, second] = &mesh.uvs;
        let uv = |uvs: &[[f32; 2]]| uvs.get(vertex as usize).copied().unwrap_or_default();
        let color = mesh.colors.get(vertex as usize).copied().unwrap_or_default();
        let ([s, t], [u, v], [red, green, blue, alpha]) = (uv(first), uv(second), color);
        ([s, t, u, v, red, green, blue, alpha].map(bits), vertex)
    };
    let is_seam = |vertex: u32, earlier: u32| {
        let [vertex, earlier] = [vertex as usize, earlier as usize];
        drawn[vertex].dot(drawn[earlier]) > SMOOTH && own[vertex].dot(own[earlier]) < SEAM
    };
    let mut found = Vec::new();
    let mut here = Vec::new();
    let at_places = at_places.chunk_by(|one, other| one >> 32 == other >> 32);
    for at_place in at_places.filter(|at_place| at_place.len() > 1) {
        here.clear();
        here.extend(at_place.iter().map(|key| rest(*key as u32)));
        here.sort_unstable();
        for same in here.chunk_by(|one, other| one.0 == other.0) {
            for (place, (_, vertex)) in same.iter().enumerate().skip(1) {
                let earlier = &same[..place.min(MOST_COMPARED)];
                if earlier.iter().any(|(_, earlier)| is_seam(*vertex, *earlier)) {
                    found.push(*vertex);
                }
            }
        }
    }
    found.sort_unstable();
    found
}
