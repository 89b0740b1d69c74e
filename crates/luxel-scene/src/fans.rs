//! Fans: sets of corners at one place that share a value, such as a normal.
//!
//! Values are found place by place, on all threads; then attribute vertices are given to fans, as
//! they are where they can be, split where they must.

use crate::{Mesh, Topology};
use luxel_parallel::{each, fill, sort_u128};

/// How many places one thread takes at a time.
const RUN: usize = 1 << 12;

/// No fan has taken an attribute vertex.
const FREE: u32 = u32::MAX;

/// The fans of a mesh.
pub(crate) struct Fans<T> {
    /// The value of each fan; the fans of a place follow one another, in the order of places.
    values: Vec<T>,
    /// The fan of each corner, in the order of the topology's list.
    fan_of_slot: Vec<u32>,
}

impl<T: Copy + Send + Sync> Fans<T> {
    /// Asks for the fans of every place: `find(place, corners, scratch, values, fan_of_corner)`
    /// appends the values of the place's fans and names each corner's, by its number in `values`.
    /// The scratch memory that one thread reuses for all positions.
    pub(crate) fn gather<S: Default>(
        topology: &Topology,
        find: impl Fn(u32, &[u32], &mut S, &mut Vec<T>, &mut [u32]) + Sync,
    ) -> Self {
        let starts = topology.starts();
        let places = starts.len() - 1;
        let mut fan_of_slot = vec![0; starts[places] as usize];
        let mut pieces = Vec::new();
        let mut rest = &mut fan_of_slot[..];
        for first in (0..places).step_by(RUN) {
            let end = places.min(first + RUN);
            let (piece, after) = rest.split_at_mut((starts[end] - starts[first]) as usize);
            pieces.push((first as u32..end as u32, piece));
            rest = after;
        }
        let mut values: Vec<Vec<T>> = Vec::new();
        values.resize_with(pieces.len(), Vec::new);
        each(pieces.into_iter().zip(&mut values), &|((places, mut slots), values)| {
            values.reserve_exact(places.len());
            let mut scratch = S::default();
            for place in places {
                let corners = topology.corners_at(place);
                let (own, after) = slots.split_at_mut(corners.len());
                if !corners.is_empty() {
                    find(place, corners, &mut scratch, values, own);
                }
                slots = after;
            }
        });
        // Fans are numbered within their pieces until all pieces are known.
        let mut base = 0;
        let mut rest = &mut fan_of_slot[..];
        for (piece, first) in values.iter().zip((0..).step_by(RUN)) {
            let end = places.min(first + RUN);
            let (own, after) = rest.split_at_mut((starts[end] - starts[first]) as usize);
            own.iter_mut().for_each(|fan| *fan += base);
            base += piece.len() as u32;
            rest = after;
        }
        Self { values: values.concat(), fan_of_slot }
    }

    /// The value of every attribute vertex, `unused` for those that no corner names. An attribute
    /// vertex goes to the first fan that needs it; each further one gets a copy, appended at the
    /// end with all its other attributes.
    pub(crate) fn assign(&self, mesh: &mut Mesh, topology: &Topology, unused: T) -> Vec<T> {
        let mut fan_of_vertex = vec![FREE; vertex_count(mesh)];
        // Fan, attribute vertex, and corner, 32 bits each, to be sorted.
        let mut clashes: Vec<u128> = Vec::new();
        let starts = topology.starts();
        let vertices = mesh.attribute_corners().as_flattened();
        for place in 0..mesh.positions.len() {
            let slots = starts[place] as usize..starts[place + 1] as usize;
            let corners = topology.corners_at(place as u32);
            for (&corner, &fan) in corners.iter().zip(&self.fan_of_slot[slots]) {
                let vertex = vertices[corner as usize];
                let owner = &mut fan_of_vertex[vertex as usize];
                if *owner == FREE {
                    *owner = fan;
                } else if *owner != fan {
                    let fan_and_vertex = u128::from(fan) << 64 | u128::from(vertex) << 32;
                    clashes.push(fan_and_vertex | u128::from(corner));
                }
            }
        }
        if !clashes.is_empty() {
            let copied = split(mesh, &mut fan_of_vertex, clashes);
            let before = fan_of_vertex.len() - copied.len();
            mesh.uvs.iter_mut().for_each(|uvs| append_copies(uvs, before, &copied));
            append_copies(&mut mesh.normals, before, &copied);
            append_copies(&mut mesh.tangents, before, &copied);
            append_copies(&mut mesh.colors, before, &copied);
        }
        let mut values = vec![unused; fan_of_vertex.len()];
        fill(&mut values, RUN, &|start, run| {
            for (value, &fan) in run.iter_mut().zip(&fan_of_vertex[start..]) {
                if fan != FREE {
                    *value = self.values[fan as usize];
                }
            }
        });
        values
    }
}

/// Gives clashing corners new attribute vertices; returns the original of each copy.
/// The work is bounded by sorting, whatever the file.
fn split(mesh: &mut Mesh, fan_of_vertex: &mut Vec<u32>, mut clashes: Vec<u128>) -> Vec<u32> {
    sort_u128(&mut clashes);
    let corners = mesh.attribute_corners.get_or_insert_with(|| mesh.triangles.clone());
    let corners = corners.as_flattened_mut();
    let mut copied = Vec::new();
    for clash in clashes.chunk_by(|a, b| a >> 32 == b >> 32) {
        for &key in clash {
            corners[key as u32 as usize] = fan_of_vertex.len() as u32;
        }
        fan_of_vertex.push((clash[0] >> 64) as u32);
        copied.push((clash[0] >> 32) as u32);
    }
    copied
}

/// How many attribute vertices a mesh has.
fn vertex_count(mesh: &Mesh) -> usize {
    let Some(corners) = &mesh.attribute_corners else { return mesh.positions.len() };
    let named = corners.as_flattened().iter().max().map_or(0, |&highest| highest as usize + 1);
    let [first, second] = &mesh.uvs;
    [first.len(), second.len(), mesh.colors.len(), mesh.tangents.len(), mesh.normals.len()]
        .into_iter()
        .fold(named, usize::max)
}

/// Appends copies of some of the values of `count` vertices, if there are values at all.
fn append_copies<T: Copy + Default>(values: &mut Vec<T>, count: usize, copied: &[u32]) {
    if !values.is_empty() {
        values.resize(count, T::default());
        let copies: Vec<T> = copied.iter().map(|&vertex| values[vertex as usize]).collect();
        values.extend(copies);
    }
}
