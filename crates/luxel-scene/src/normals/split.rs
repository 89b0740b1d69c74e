//! Attribute vertices for fans: as they are where they can be, split where they must.

use super::NO_DIRECTION;
use super::fans::Fans;
use crate::{Mesh, Topology};
use rayon::prelude::*;

/// No fan has taken the attribute vertex yet.
const FREE: u32 = u32::MAX;

/// Gives each fan's normal to its corners' attribute vertices. An attribute vertex goes to the
/// first fan that needs it; each further one gets a copy, appended at the end.
pub(super) fn assign(mesh: &mut Mesh, topology: &Topology, fans: &Fans) {
    let mut fan_of_vertex = vec![FREE; vertex_count(mesh)];
    // Fan, attribute vertex, and corner, in this order of sorting.
    let mut clashes: Vec<(u32, u32, u32)> = Vec::new();
    let starts = topology.starts();
    let vertices = mesh.attribute_corners().as_flattened();
    for place in 0..mesh.positions.len() {
        let slots = starts[place] as usize..starts[place + 1] as usize;
        let corners = topology.corners_at(place as u32);
        for (&corner, &fan) in corners.iter().zip(&fans.fan_of_slot[slots]) {
            let vertex = vertices[corner as usize];
            let owner = &mut fan_of_vertex[vertex as usize];
            if *owner == FREE {
                *owner = fan;
            } else if *owner != fan {
                clashes.push((fan, vertex, corner));
            }
        }
    }
    if !clashes.is_empty() {
        // The work of looking copies up is bounded by sorting, whatever the file.
        clashes.par_sort_unstable();
        let corners = mesh.attribute_corners.get_or_insert_with(|| mesh.triangles.clone());
        let before = fan_of_vertex.len();
        let mut copied = Vec::new();
        for clash in clashes.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let copy = fan_of_vertex.len() as u32;
            fan_of_vertex.push(clash[0].0);
            copied.push(clash[0].1 as usize);
            for &(_, _, corner) in clash {
                corners[corner as usize / 3][corner as usize % 3] = copy;
            }
        }
        mesh.uvs.iter_mut().for_each(|uvs| append_copies(uvs, before, &copied));
        append_copies(&mut mesh.colors, before, &copied);
        append_copies(&mut mesh.tangents, before, &copied);
    }
    let normal = |&fan: &u32| if fan == FREE { NO_DIRECTION } else { fans.normals[fan as usize] };
    mesh.normals = fan_of_vertex.par_iter().map(normal).collect();
}

/// How many attribute vertices a mesh has.
fn vertex_count(mesh: &Mesh) -> usize {
    let Some(corners) = &mesh.attribute_corners else { return mesh.positions.len() };
    let named = corners.as_flattened().iter().max().map_or(0, |&highest| highest as usize + 1);
    let [first, second] = &mesh.uvs;
    [first.len(), second.len(), mesh.colors.len(), mesh.tangents.len()]
        .into_iter()
        .fold(named, usize::max)
}

/// Appends copies of some of the values of `count` vertices, if there are values at all.
fn append_copies<T: Copy + Default>(values: &mut Vec<T>, count: usize, copied: &[usize]) {
    if !values.is_empty() {
        values.resize(count, T::default());
        let copies: Vec<T> = copied.iter().map(|&vertex| values[vertex]).collect();
        values.extend(copies);
    }
}
