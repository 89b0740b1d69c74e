//! Which faces around a place belong together.

use super::faces::{Face, Faces, same_polygon};
use super::{NO_DIRECTION, unit};
use crate::fans::Fans;
use crate::{Mesh, Topology};

/// At an edge of so many faces all pairs are compared; at more, each with the next in file order,
/// so that a file with all faces on one edge stays fast.
const FACES_COMPARED_IN_PAIRS: usize = 8;

/// Faces within this angle of their mean are averaged without asking how they hang together, which
/// makes no difference to the eye. Half the default crease angle, so that it bounds the angle
/// between any two of them.
const ALIKE_DEGREES: f64 = 20.0;

/// Sums shorter than this, compared with the sum of the lengths, have lost their direction.
const CANCELLED: f64 = 1e-6;

/// How faces are grouped.
enum Rule<'a> {
    /// All of a place.
    All,
    /// Those of one group; group 0 is none.
    Groups(&'a [u32]),
    /// Those joined by edges whose faces' normals have a dot product above `cosine`.
    Crease { cosine: f32, alike_cosine: f64 },
}

/// Finds the fans of all places, with their normals.
pub(super) fn gather(
    mesh: &Mesh,
    topology: &Topology,
    faces: &Faces,
    crease_radians: f64,
) -> Fans<[f32; 3]> {
    let rule = match &mesh.smoothing_groups {
        Some(groups) => Rule::Groups(groups),
        None if crease_radians >= std::f64::consts::PI => Rule::All,
        None => {
            let crease = if crease_radians > 0.0 { crease_radians } else { 0.0 };
            let alike = (crease * 0.5).min(ALIKE_DEGREES.to_radians());
            Rule::Crease { cosine: libm::cos(crease) as f32, alike_cosine: libm::cos(alike) }
        }
    };
    let around = Around { mesh, topology, faces, rule };
    Fans::gather(topology, |place, corners, scratch, normals, fan_of_corner| {
        around.find(place, corners, scratch, normals, fan_of_corner);
    })
}

/// Lists that are used again from place to place.
#[derive(Default)]
struct Scratch {
    /// The far end of each edge at the place, with the number of the corner at the place.
    edges: Vec<(u32, u32)>,
    /// The tree of corners that belong together: each one's parent, itself at the root.
    parents: Vec<u32>,
    /// The normals that faces without area borrow.
    borrowed: Vec<[f32; 3]>,
    /// Smoothing groups with corners.
    groups: Vec<(u64, u32)>,
    /// The fan of each root.
    fans: Vec<u32>,
    sums: Vec<Sum>,
}

/// A normal in the making.
#[derive(Clone, Copy, Default)]
struct Sum {
    vector: [f64; 3],
    weights: f64,
    /// The fallback if all terms cancel.
    some_face: [f32; 3],
}

impl Sum {
    fn add(&mut self, face: &Face, weight: f32) {
        if face.is_sound() {
            if self.some_face == [0.0; 3] {
                self.some_face = face.normal;
            }
            face.add_to(&mut self.vector, weight);
            self.weights += f64::from(weight);
        }
    }

    fn normal(&self) -> [f32; 3] {
        let [x, y, z] = self.vector;
        let length = (x * x + y * y + z * z).sqrt();
        let sum = if length > CANCELLED * self.weights { unit(self.vector) } else { None };
        match sum {
            Some(normal) => normal,
            None if self.some_face != [0.0; 3] => self.some_face,
            None => NO_DIRECTION,
        }
    }
}

struct Around<'a> {
    mesh: &'a Mesh,
    topology: &'a Topology,
    faces: &'a Faces,
    rule: Rule<'a>,
}

impl Around<'_> {
    /// Finds the fans of one place, appends their normals, and names each corner's.
    fn find(
        &self,
        place: u32,
        corners: &[u32],
        scratch: &mut Scratch,
        normals: &mut Vec<[f32; 3]>,
        fan_of_corner: &mut [u32],
    ) {
        let first_fan = normals.len() as u32;
        let mut plain = [0.0; 3];
        let mut sum = Sum::default();
        for (slot, &corner) in corners.iter().enumerate() {
            let face = self.face(corner);
            face.add_to(&mut plain, 1.0);
            sum.add(face, self.weight(face, corners, slot));
        }
        if self.is_one_fan(corners, plain) {
            normals.push(sum.normal());
            fan_of_corner.fill(first_fan);
            return;
        }
        scratch.parents.clear();
        scratch.parents.extend(0..corners.len() as u32);
        match &self.rule {
            // One fan: dealt with above.
            Rule::All => {}
            Rule::Groups(groups) => self.join_groups(groups, corners, scratch),
            Rule::Crease { cosine, .. } => self.join_smooth(*cosine, place, corners, scratch),
        }
        // Roots are the first of their fans, so each is met before the others.
        scratch.fans.clear();
        scratch.sums.clear();
        for (slot, &corner) in corners.iter().enumerate() {
            let root = root(&mut scratch.parents, slot);
            let fan = if root == slot {
                scratch.sums.push(Sum::default());
                scratch.sums.len() as u32 - 1
            } else {
                scratch.fans[root]
            };
            scratch.fans.push(fan);
            let face = self.face(corner);
            scratch.sums[fan as usize].add(face, self.weight(face, corners, slot));
            fan_of_corner[slot] = first_fan + fan;
        }
        normals.extend(scratch.sums.iter().map(Sum::normal));
    }

    #[inline]
    fn face(&self, corner: u32) -> &Face {
        self.faces.at(corner as usize / 3)
    }

    /// The weight of the face of a corner; 0 if its polygon has been counted.
    #[inline]
    fn weight(&self, face: &Face, corners: &[u32], slot: usize) -> f32 {
        let [own, before] = [slot, slot.saturating_sub(1)].map(|slot| corners[slot] as usize / 3);
        if self.faces.once_per_polygon && slot > 0 && same_polygon(self.mesh, before, own) {
            0.0
        } else {
            face.weights[corners[slot] as usize % 3]
        }
    }

    /// Whether it is plain to see that all faces belong together. Normals within half the crease
    /// angle of their mean, whose direction is `[x, y, z]`, are within the whole of each other.
    fn is_one_fan(&self, corners: &[u32], [x, y, z]: [f64; 3]) -> bool {
        match self.rule {
            Rule::All => true,
            Rule::Groups(groups) => {
                let group = |corner: u32| groups[corner as usize / 3];
                group(corners[0]) != 0
                    && corners.iter().all(|&corner| group(corner) == group(corners[0]))
            }
            Rule::Crease { alike_cosine, .. } => {
                let least = alike_cosine * (x * x + y * y + z * z).sqrt();
                corners.iter().all(|&corner| {
                    let face = self.face(corner);
                    let [a, b, c] = face.normal;
                    x * f64::from(a) + y * f64::from(b) + z * f64::from(c) > least
                        || !face.is_sound()
                })
            }
        }
    }

    fn join_groups(&self, groups: &[u32], corners: &[u32], scratch: &mut Scratch) {
        let key = |&corner: &u32| {
            let triangle = corner as usize / 3;
            match (groups[triangle], &self.mesh.polygons) {
                // Faceted: each polygon is a separate group.
                (0, Some(polygons)) => u64::from(polygons[triangle]),
                (0, None) => triangle as u64,
                (group, _) => 1 << 32 | u64::from(group),
            }
        };
        scratch.groups.clear();
        scratch.groups.extend(corners.iter().map(key).zip(0..));
        scratch.groups.sort_unstable();
        for pair in scratch.groups.windows(2) {
            if pair[0].0 == pair[1].0 {
                join(&mut scratch.parents, pair[0].1 as usize, pair[1].1 as usize);
            }
        }
    }

    fn join_smooth(&self, cosine: f32, place: u32, corners: &[u32], scratch: &mut Scratch) {
        let Scratch { edges, parents, borrowed, .. } = scratch;
        edges.clear();
        borrowed.clear();
        for (slot, &corner) in corners.iter().enumerate() {
            let triangle = corner as usize / 3;
            if slot > 0 && same_polygon(self.mesh, corners[slot - 1] as usize / 3, triangle) {
                join(parents, slot - 1, slot);
            }
            for position in self.mesh.triangles[triangle] {
                let end = self.topology.place(position);
                if end != place {
                    edges.push((end, slot as u32));
                }
            }
            borrowed.push(self.face(corner).normal);
        }
        edges.sort_unstable();
        // A face without area takes the normal of one of its neighbours.
        for edge in edges.chunk_by(|a, b| a.0 == b.0) {
            for pair in edge.windows(2) {
                let [a, b] = [pair[0].1 as usize, pair[1].1 as usize];
                if borrowed[a] == [0.0; 3] {
                    borrowed[a] = borrowed[b];
                } else if borrowed[b] == [0.0; 3] {
                    borrowed[b] = borrowed[a];
                }
            }
        }
        for edge in edges.chunk_by(|a, b| a.0 == b.0) {
            let mut join_if_smooth = |a: u32, b: u32| {
                let ([x, y, z], [u, v, w]) = (borrowed[a as usize], borrowed[b as usize]);
                if x * u + y * v + z * w > cosine {
                    join(parents, a as usize, b as usize);
                }
            };
            for (at, &(_, a)) in edge.iter().enumerate() {
                let others = &edge[at + 1..];
                let compared = if edge.len() > FACES_COMPARED_IN_PAIRS { 1 } else { others.len() };
                others.iter().take(compared).for_each(|&(_, b)| join_if_smooth(a, b));
            }
        }
    }
}

/// The first corner of a fan, as far as joined; shortens the way for the next question.
fn root(parents: &mut [u32], mut slot: usize) -> usize {
    while parents[slot] as usize != slot {
        let above = parents[parents[slot] as usize];
        parents[slot] = above;
        slot = above as usize;
    }
    slot
}

/// Joins two fans under the first corner of both.
fn join(parents: &mut [u32], a: usize, b: usize) {
    let (a, b) = (root(parents, a), root(parents, b));
    parents[a.max(b)] = a.min(b) as u32;
}
