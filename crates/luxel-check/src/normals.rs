//! Vertex normals compared with their faces.

use crate::surface::{RUN, Surface};
use luxel_parallel::{any, fill, gather, sort_u64, sort_u128};
use luxel_scene::{DVec3, Mesh, NormalFault};

/// A normal is behind its face if the cosine of the angle between them is below this: two degrees beyond
/// the plane, more than rounding in files.
const BEHIND: f64 = -0.035;

/// The largest angle between a face's normal and the average of its vertex normals.
const UNREPRESENTATIVE_DEGREES: f64 = 60.0;

/// Faults of normals.
#[derive(Default)]
pub(crate) struct Normals {
    /// Attribute vertices whose normal points behind a face, with the face.
    pub(crate) behind: Vec<(u32, u32)>,
    /// Triangles whose vertex normals don't represent them.
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

/// A face's own normal, on the side of most of its vertex normals.
pub(crate) fn facing(surface: &Surface<'_>, normals: &[[DVec3; 3]], triangle: usize) -> DVec3 {
    let face = surface.area_vector(triangle as u32).normalize_or_zero();
    let sum: DVec3 = normals[triangle].iter().sum();
    if face.dot(sum) < 0.0 { -face } else { face }
}

/// Compares the normals of corners, as rendered, with their faces. Excluded faces and entirely flipped ones
/// are reported elsewhere.
pub(crate) fn examine(
    surface: &Surface<'_>,
    drawn: &Mesh,
    normals: &[[DVec3; 3]],
    is_excluded: &[bool],
) -> Normals {
    let least = libm::cos(UNREPRESENTATIVE_DEGREES.to_radians());
    let face = |triangle: usize| facing(surface, normals, triangle);
    let kept = |triangle: &usize| !is_excluded[*triangle];
    let corners = drawn.attribute_corners();
    // The vertex in the upper bits, the triangle in the lower.
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

/// Faults of the file's normals: those that its reader has reported, and remaining ones.
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

/// Attribute vertices with the same attributes as an earlier one, on a smooth surface, though each has faces
/// of its own: programs that average normals by vertex index show a seam.
pub(crate) fn seams(surface: &Surface<'_>, normals: &[[DVec3; 3]]) -> Vec<u32> {
    /// The cosine above which averages show no seam: two degrees.
    const SEAM: f64 = 0.999_39;
    /// The least cosine between the normals on both sides of a smooth surface.
    const SMOOTH: f64 = 0.999_9;
    /// The most earlier vertices compared with each.
    const MOST_COMPARED: usize = 64;
    let mesh = surface.mesh;
    let is_whole = surface.triangles[..] == mesh.triangles[..surface.triangles.len()];
    if is_whole && mesh.attribute_corners.is_none() {
        // All positions are distinct.
        return Vec::new();
    }
    // For each attribute vertex: position, rendered normal, average normal of its own faces.
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
    // 0 and -0 are equal.
    let bits = |value: f32| (value + 0.0).to_bits();
    // Vertices by position, then by index.
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
