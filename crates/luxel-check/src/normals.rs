//! Vertex normals against the faces that they stand for.

use crate::surface::Surface;
use luxel_scene::{DVec3, Mesh, NormalFault};
use rayon::prelude::*;

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
    mesh.attribute_corners().par_iter().map(|corners| corners.map(normal)).collect()
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
    let behind = |triangle: usize| {
        let face = face(triangle);
        (0..3).filter_map(move |k| {
            let is_behind = normals[triangle][k].dot(face) < BEHIND;
            is_behind.then_some((corners[triangle][k], triangle as u32))
        })
    };
    let triangles = 0..surface.triangles.len();
    let mut found: Vec<(u32, u32)> =
        triangles.clone().into_par_iter().filter(kept).flat_map_iter(behind).collect();
    found.par_sort_unstable();
    found.dedup_by_key(|(vertex, _)| *vertex);
    let is_unrepresentative = |triangle: &usize| {
        let sum: DVec3 = normals[*triangle].iter().sum();
        let has_all = normals[*triangle].iter().all(|normal| normal.length_squared() > 0.25);
        has_all && face(*triangle).dot(sum.normalize_or_zero()) < least
    };
    let unrepresentative = triangles.into_par_iter().filter(kept).filter(is_unrepresentative);
    let unrepresentative = unrepresentative.map(|triangle| triangle as u32).collect();
    Normals { behind: found, unrepresentative }
}

/// What is wrong with the normals of the file: what its reader has told, and what is still there.
pub(crate) fn faults(mesh: &Mesh) -> Vec<NormalFault> {
    let mut faults = mesh.normal_faults.clone();
    let is_wrong: Vec<bool> =
        mesh.normals.par_iter().map(|normal| NormalFault::of(0, *normal).is_some()).collect();
    if is_wrong.contains(&true) {
        for (corners, places) in mesh.attribute_corners().iter().zip(&mesh.triangles) {
            for (&corner, &place) in corners.iter().zip(places) {
                if is_wrong.get(corner as usize) == Some(&true) {
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
    own.par_iter_mut().for_each(|sum| *sum = sum.normalize_or_zero());
    let key = |vertex: usize| {
        let position = mesh.positions[position_of[vertex] as usize];
        let [first, second] = &mesh.uvs;
        let uv = |uvs: &[[f32; 2]]| uvs.get(vertex).copied().unwrap_or_default();
        let color = mesh.colors.get(vertex).copied().unwrap_or_default();
        let values = position.into_iter().chain(uv(first)).chain(uv(second)).chain(color);
        let mut key = [0; 11];
        for (bits, value) in key.iter_mut().zip(values) {
            // 0 and -0 are the same.
            *bits = (value + 0.0).to_bits();
        }
        (key, vertex as u32)
    };
    let used = (0..count).into_par_iter().filter(|&vertex| position_of[vertex] != u32::MAX);
    let mut keys: Vec<([u32; 11], u32)> = used.map(key).collect();
    keys.par_sort_unstable();
    let is_seam = |vertex: u32, earlier: u32| {
        let [vertex, earlier] = [vertex as usize, earlier as usize];
        drawn[vertex].dot(drawn[earlier]) > SMOOTH && own[vertex].dot(own[earlier]) < SEAM
    };
    let mut found = Vec::new();
    for same in keys.chunk_by(|one, other| one.0 == other.0) {
        for (place, (_, vertex)) in same.iter().enumerate().skip(1) {
            let earlier = &same[..place.min(MOST_COMPARED)];
            if earlier.iter().any(|(_, earlier)| is_seam(*vertex, *earlier)) {
                found.push(*vertex);
            }
        }
    }
    found.sort_unstable();
    found
}
