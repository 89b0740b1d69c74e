//! Repaired copies of a mesh, to measure the severity of its faults.

use crate::gaps::Gaps;
use crate::surface::Surface;
use luxel_scene::{DVec3, Mesh, Part};
use std::collections::BTreeMap;

/// Reverses triangles.
pub(crate) fn reversed(mesh: &Mesh, triangles: &[u32]) -> Mesh {
    let mut cured = mesh.clone();
    for &triangle in triangles {
        cured.triangles[triangle as usize].swap(1, 2);
        if let Some(corners) = &mut cured.attribute_corners {
            corners[triangle as usize].swap(1, 2);
        }
    }
    cured
}

/// Collapses triangles, so that they don't contribute to averages.
pub(crate) fn without(mesh: &Mesh, triangles: &[u32]) -> Mesh {
    let mut cured = mesh.clone();
    if cured.attribute_corners.is_none() {
        cured.attribute_corners = Some(cured.triangles.clone());
    }
    for &triangle in triangles {
        let [first, ..] = cured.triangles[triangle as usize];
        cured.triangles[triangle as usize] = [first; 3];
    }
    cured
}

/// Removes normals of attribute vertices: they become averages of their faces.
pub(crate) fn without_normals(mesh: &Mesh, vertices: impl Iterator<Item = u32>) -> Mesh {
    let mut cured = mesh.clone();
    for vertex in vertices {
        if let Some(normal) = cured.normals.get_mut(vertex as usize) {
            *normal = [0.0; 3];
        }
    }
    cured
}

/// Removes all normals: they are computed from the faces.
pub(crate) fn with_new_normals(mesh: &Mesh) -> Mesh {
    Mesh { normals: Vec::new(), ..mesh.clone() }
}

/// Closes gaps: the corners of the opposite edge move to the first one's.
pub(crate) fn closed(surface: &Surface<'_>, gaps: &Gaps) -> Mesh {
    let mut cured = surface.mesh.clone();
    let mut moved: BTreeMap<u32, u32> = BTreeMap::new();
    for &(half_edge, partner) in &gaps.cracks {
        let [from, to] = surface.ends(half_edge);
        let [other_from, other_to] = surface.ends(partner);
        let near = |one: u32, other: u32| surface.at(one).distance_squared(surface.at(other));
        let across = near(from, other_to) + near(to, other_from);
        let along = near(from, other_from) + near(to, other_to);
        let pairs = if across <= along {
            [(other_to, from), (other_from, to)]
        } else {
            [(other_from, from), (other_to, to)]
        };
        for (place, target) in pairs {
            if place != target {
                moved.entry(place.max(target)).or_insert(place.min(target));
            }
        }
    }
    for (position, triangle) in surface.triangles.iter().enumerate() {
        for (k, place) in triangle.iter().enumerate() {
            if let Some(target) = moved.get(place) {
                let corner = cured.triangles[position][k] as usize;
                cured.positions[corner] = surface.mesh.positions[*target as usize];
            }
        }
    }
    cured
}

/// Splits edges at the corners in their middle: each triangle becomes a fan around the corner opposite
/// its first split edge, in its own part.
pub(crate) fn split(surface: &Surface<'_>, gaps: &Gaps) -> Mesh {
    let mesh = surface.mesh;
    // The corners to insert into each edge, by triangle.
    let mut on_edges: BTreeMap<u32, [Vec<u32>; 3]> = BTreeMap::new();
    for &(place, half_edge) in &gaps.t_junctions {
        on_edges.entry(half_edge / 3).or_default()[(half_edge % 3) as usize].push(place);
    }
    // An inserted corner has the attributes of its own side.
    let mut vertex_at: BTreeMap<u32, u32> = BTreeMap::new();
    let wanted: std::collections::BTreeSet<u32> =
        gaps.t_junctions.iter().map(|(place, _)| *place).collect();
    for (places, corners) in surface.triangles.iter().zip(mesh.attribute_corners()) {
        for (place, corner) in places.iter().zip(corners).filter(|(at, _)| wanted.contains(at)) {
            vertex_at.entry(*place).or_insert(*corner);
        }
    }
    let mut attribute_corners: Vec<[u32; 3]> = Vec::new();
    let mut cured = Mesh {
        origin: mesh.origin,
        positions: mesh.positions.clone(),
        normals: mesh.normals.clone(),
        ..Mesh::default()
    };
    for part in &mesh.parts {
        let first = cured.triangles.len() as u32;
        for triangle in part.first..part.first + part.count {
            let corners = mesh.triangles[triangle as usize];
            match on_edges.get_mut(&triangle) {
                None => {
                    cured.triangles.push(corners);
                    attribute_corners.push(mesh.attribute_corners()[triangle as usize]);
                }
                Some(edges) => {
                    // Positions with their attribute vertices, around the triangle.
                    let mut around: Vec<(u32, u32)> = Vec::new();
                    let mut at: Vec<(DVec3, bool)> = Vec::new();
                    for k in 0..3 {
                        let vertex = mesh.attribute_corners()[triangle as usize][k];
                        around.push((corners[k], vertex));
                        let from = surface.at(surface.triangles[triangle as usize][k]);
                        at.push((from, true));
                        let key = |place: &u32| surface.at(*place).distance_squared(from);
                        edges[k].sort_by(|one, other| key(one).total_cmp(&key(other)));
                        for &place in &edges[k] {
                            around.push((place, vertex_at.get(&place).copied().unwrap_or(vertex)));
                            at.push((surface.at(place), false));
                        }
                    }
                    for piece in fan(&at) {
                        cured.triangles.push(piece.map(|corner| around[corner].0));
                        attribute_corners.push(piece.map(|corner| around[corner].1));
                    }
                }
            }
        }
        let count = cured.triangles.len() as u32 - first;
        cured.parts.push(Part { first, count, material: part.material });
    }
    cured.attribute_corners = Some(attribute_corners);
    cured
}

/// Triangulates a triangle with additional corners on its edges, without degenerate pieces: clips ears at
/// original corners, first where a neighbour lies within an edge. `at` lists the corners in order, and
/// whether they are original.
fn fan(at: &[(DVec3, bool)]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..at.len()).collect();
    let mut is_corner: Vec<bool> = at.iter().map(|(_, is_corner)| *is_corner).collect();
    let mut pieces = Vec::new();
    while left.len() > 3 {
        let count = left.len();
        let ear = |k: usize| [left[(k + count - 1) % count], left[k], left[(k + 1) % count]];
        let fatness = |k: usize| {
            let [a, b, c] = ear(k).map(|corner| at[corner].0);
            let longest = (b - a).length().max((c - b).length()).max((a - c).length());
            (b - a).cross(c - a).length() / (longest * longest).max(f64::MIN_POSITIVE)
        };
        let is_due = |k: &usize| {
            let [before, tip, behind] = ear(*k);
            is_corner[tip] && !(is_corner[before] && is_corner[behind])
        };
        let order = |&one: &usize, &other: &usize| {
            fatness(one).total_cmp(&fatness(other)).then(other.cmp(&one))
        };
        let due = (0..count).filter(is_due).max_by(order);
        let Some(best) = due.or_else(|| (0..count).max_by(order)) else { break };
        let [before, tip, behind] = ear(best);
        pieces.push([before, tip, behind]);
        is_corner[before] = true;
        is_corner[behind] = true;
        left.remove(best);
    }
    if let [a, b, c] = left[..] {
        pieces.push([a, b, c]);
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_of_a_split_triangle_has_an_area() {
        let at = |x: f64, y: f64| DVec3::new(x, y, 0.0);
        for on_edges in [[1, 0, 0], [0, 2, 0], [1, 1, 1], [3, 0, 2], [5, 4, 3]] {
            let corners = [at(0.0, 0.0), at(4.0, 0.0), at(1.0, 3.0)];
            let mut around = Vec::new();
            for (k, count) in on_edges.into_iter().enumerate() {
                around.push((corners[k], true));
                let way = corners[(k + 1) % 3] - corners[k];
                around.extend((1..=count).map(|step| {
                    (corners[k] + way * (f64::from(step) / f64::from(count + 1)), false)
                }));
            }
            let pieces = fan(&around);
            assert_eq!(pieces.len(), around.len() - 2);
            let area = |[a, b, c]: [usize; 3]| {
                let [a, b, c] = [a, b, c].map(|corner| around[corner].0);
                (b - a).cross(c - a).z
            };
            assert!(pieces.iter().all(|&piece| area(piece) > 1e-3), "{on_edges:?}");
            let sum: f64 = pieces.iter().map(|&piece| area(piece)).sum();
            assert!((sum - 12.0).abs() < 1e-9, "{on_edges:?}");
        }
    }
}
