//! Tangents for normal maps: the directions in which texture coordinates grow.
//!
//! A normal map's red and green are along the tangent T and the bitangent B = w (N x T). The maps
//! are made for one way of finding T at vertices, that of Mikkelsen (2008, *Simulation of Wrinkled
//! Surfaces Revisited*, and the program MikkTSpace), which glTF 2.0 (3.7.2.1) asks for, too:
//!
//! - per triangle the direction of growing u: T = (v_2 e_1 - v_1 e_2) / |..|, with edges e_i from
//!   the first corner and (u_i, v_i) along them, turned round where the picture is mirrored;
//! - per vertex the mean of the triangles that share position, normal and texture coordinates and
//!   are mirrored alike, each made perpendicular to N and weighted by its angle, seen along N.
//!
//! Green points up in the picture and v down, so w is +1 for pictures that are mirrored as seen
//! with v downwards. A vertex where two ways of mirroring meet is split.

use crate::angle::{angle_between, dot};
use crate::fans::Fans;
use crate::{Mesh, Scene, Topology};

impl Scene {
    /// [`Mesh::compute_tangents`] for the meshes that lack tangents and have a material with a
    /// normal map, over the texture coordinates of the first such map.
    pub fn compute_tangents(&mut self) {
        for mesh in &mut self.meshes {
            let map = mesh
                .parts
                .iter()
                .find_map(|part| self.materials.get(part.material.index())?.normal.as_deref());
            if let (true, Some(map)) = (mesh.tangents.is_empty(), map) {
                mesh.compute_tangents(usize::from(map.uv_set));
            }
        }
    }
}

impl Mesh {
    /// Gives every attribute vertex a unit tangent, perpendicular to its normal, with the sign of
    /// its bitangent, from a set of texture coordinates.
    ///
    /// Does nothing without normals or such coordinates. Where a vertex has no triangle whose
    /// texture coordinates have an area, the tangent is some perpendicular.
    pub fn compute_tangents(&mut self, uv_set: usize) {
        if !self.sections.is_empty() {
            return self.change_sections(&mut |section| section.compute_tangents(uv_set));
        }
        let Some(uvs) = self.uvs.get(uv_set) else { return };
        let corners = self.attribute_corners().as_flattened();
        let Some(&highest) = corners.iter().max() else { return };
        if uvs.len().min(self.normals.len()) <= highest as usize {
            return;
        }
        let topology = Topology::of(self);
        let source = Source { mesh: self, uvs };
        let fans = Fans::gather(&topology, |_, corners, scratch, tangents, fan_of_corner| {
            source.find(corners, scratch, tangents, fan_of_corner);
        });
        self.tangents.clear();
        self.tangents = fans.assign(self, &topology, [1.0, 0.0, 0.0, 1.0]);
    }
}

/// The common key of a fan's corners: normal, texture coordinates and mirroring, as bits.
type Key = ([u32; 5], bool);

/// Lists that are used again from place to place.
#[derive(Default)]
struct Scratch {
    keys: Vec<(Key, u32)>,
}

/// How a picture lies on a triangle.
struct Chart {
    /// The direction of growing u, of unit length; `None` without an area of texture coordinates.
    tangent: Option<[f64; 3]>,
    /// Whether u and v turn as the triangle does.
    direct: bool,
}

struct Source<'a> {
    mesh: &'a Mesh,
    uvs: &'a [[f32; 2]],
}

impl Source<'_> {
    /// Finds the fans of one place, appends their tangents, and names each corner's.
    fn find(
        &self,
        corners: &[u32],
        scratch: &mut Scratch,
        tangents: &mut Vec<[f32; 4]>,
        fan_of_corner: &mut [u32],
    ) {
        const NONE: u32 = u32::MAX;
        fan_of_corner.fill(NONE);
        let keys = &mut scratch.keys;
        keys.clear();
        keys.extend(corners.iter().map(|&corner| self.key(corner)).zip(0..));
        keys.sort_unstable();
        // Triangles without a picture join others at the same normal and coordinates.
        for alike in keys.chunk_by(|a, b| a.0.0 == b.0.0) {
            let mut some_fan = None;
            for fan in alike.chunk_by(|a, b| a.0 == b.0) {
                let numbers = || fan.iter().map(|&(_, slot)| corners[slot as usize]);
                let Some(tangent) = self.mean_tangent(numbers(), fan[0].0.1) else { continue };
                let number = tangents.len() as u32;
                some_fan.get_or_insert(number);
                tangents.push(tangent);
                for &(_, slot) in fan {
                    fan_of_corner[slot as usize] = number;
                }
            }
            let fallback = some_fan.unwrap_or_else(|| {
                tangents.push(self.some_tangent(corners[alike[0].1 as usize]));
                tangents.len() as u32 - 1
            });
            for &(_, slot) in alike {
                let fan = &mut fan_of_corner[slot as usize];
                *fan = if *fan == NONE { fallback } else { *fan };
            }
        }
    }

    fn vertex(&self, corner: u32) -> usize {
        self.mesh.attribute_corners().as_flattened()[corner as usize] as usize
    }

    fn uv(&self, corner: u32) -> [f64; 2] {
        // NaN would spread to the neighbours.
        self.uvs[self.vertex(corner)]
            .map(|value| if value.is_finite() { value.into() } else { 0.0 })
    }

    fn normal(&self, corner: u32) -> [f64; 3] {
        self.mesh.normals[self.vertex(corner)].map(f64::from)
    }

    fn position(&self, corner: u32) -> [f64; 3] {
        let position = self.mesh.triangles.as_flattened()[corner as usize];
        self.mesh.positions[position as usize].map(f64::from)
    }

    fn key(&self, corner: u32) -> Key {
        let vertex = self.vertex(corner);
        let [x, y, z] = self.mesh.normals[vertex].map(|value| (value + 0.0).to_bits());
        let [u, v] = self.uvs[vertex].map(|value| (value + 0.0).to_bits());
        ([x, y, z, u, v], self.chart(corner as usize / 3).direct)
    }

    fn chart(&self, triangle: usize) -> Chart {
        let first = triangle as u32 * 3;
        let [a, b, c] = [first, first + 1, first + 2].map(|corner| self.uv(corner));
        let [[u1, v1], [u2, v2]] = [b, c].map(|uv| [uv[0] - a[0], uv[1] - a[1]]);
        let area = u1 * v2 - v1 * u2;
        let [a, b, c] = [first, first + 1, first + 2].map(|corner| self.position(corner));
        let sign = if area > 0.0 { 1.0 } else { -1.0 };
        let along =
            [0, 1, 2].map(|axis| sign * (v2 * (b[axis] - a[axis]) - v1 * (c[axis] - a[axis])));
        let tangent = if area == 0.0 { None } else { unit(along) };
        Chart { direct: area > 0.0 && tangent.is_some(), tangent }
    }

    /// The mean over the corners of a fan; `None` if none of their triangles has a direction.
    fn mean_tangent(&self, corners: impl Iterator<Item = u32>, direct: bool) -> Option<[f32; 4]> {
        let mut sum = [0.0; 3];
        let mut some = None;
        for corner in corners {
            let Some(tangent) = self.chart(corner as usize / 3).tangent else { continue };
            let normal = self.normal(corner);
            let Some(tangent) = unit(flattened(tangent, normal)) else { continue };
            let first = corner / 3 * 3;
            let here = self.position(corner);
            let [next, previous] = [1, 2].map(|step| {
                let there = self.position(first + (corner - first + step) % 3);
                flattened([0, 1, 2].map(|axis| there[axis] - here[axis]), normal)
            });
            let angle = angle_between(next, previous);
            for (sum, value) in sum.iter_mut().zip(tangent) {
                *sum += angle * value;
            }
            some.get_or_insert(tangent);
        }
        let [x, y, z] = unit(sum).or(some)?.map(|value| value as f32);
        Some([x, y, z, if direct { -1.0 } else { 1.0 }])
    }

    /// Some unit vector perpendicular to the normal at a corner.
    fn some_tangent(&self, corner: u32) -> [f32; 4] {
        let normal = self.normal(corner);
        let axis = if normal[0].abs() < 0.75 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let [x, y, z] = unit(flattened(axis, normal)).unwrap_or(axis).map(|value| value as f32);
        [x, y, z, 1.0]
    }
}

/// A vector without its part along a unit normal.
fn flattened(vector: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let along = dot(vector, normal);
    [0, 1, 2].map(|axis| vector[axis] - along * normal[axis])
}

fn unit(vector: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(vector, vector).sqrt();
    (length > 0.0 && length.is_finite()).then(|| vector.map(|value| value / length))
}

#[cfg(test)]
mod tests;
