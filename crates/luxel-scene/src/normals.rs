//! Vertex normals: averages of the normals of the faces that meet there.
//!
//! N = normalised sum of w_i N_i over the faces around a vertex, with
//!
//! | [`NormalSource`] | weight w_i |
//! | --- | --- |
//! | `Mean` | 1 (Gouraud 1971) |
//! | `Area` | the face's area |
//! | `Angle` | the face's angle at the vertex (Thürmer and Wüthrich 1998) |
//! | `AreaAngle` | both, multiplied |
//!
//! A *face* is a polygon of the file, however many triangles it became: its normal is Newell's, its
//! angle the sum of its triangles', and it counts once.
//!
//! Which faces count as being around a vertex *together* is decided by smoothing groups where a
//! file has them, by the crease angle where it has none. Vertices where several fans of faces meet
//! are split into as many; positions stay whole. Faces without area have no say.
//!
//! # The default crease angle
//! [`DEFAULT_CREASE_DEGREES`] = 40. Angles between neighbouring faces, counted in steps of 5
//! degrees over the edges of ten models, fall into two heaps with a valley between them:
//!
//! - Parts from CAD programs (three STL files): curved walls are tessellated in steps of less than
//!   15 degrees (two edges of all are between 15 and 45), true edges lie at 85 to 105 and are 29,
//!   32 and 67 % of all, chamfers at 45.
//! - Modelled surfaces that are meant to be smooth: 99.0 % of the Utah teapot's edges and 99.2 % of
//!   a cow's lie below 40; those above are rims and joints.
//! - Scans: 99.5 % of the Stanford bunny's and 99.6 % of the dragon's lie below 40. The rest is
//!   noise, which looks no worse with edges, while a cube from a PLY file looks wrong without; so
//!   formats with shared positions are treated alike.
//!
//! A regular prism of n sides has 360/n degrees at its edges: 45 at the octagon, which is meant to
//! have edges, 36 at the decagon, which usually represents a cylinder. 40 lies between.

mod around;
mod faces;

use crate::{Mesh, Scene, Topology};
use faces::Faces;
use luxel_parallel::fill;
use std::sync::atomic::{AtomicBool, Ordering};

/// How many normals one thread takes at a time.
const RUN: usize = 1 << 12;

/// By default, edges between faces at less than this angle are smooth;
/// the module documentation describes its derivation.
pub const DEFAULT_CREASE_DEGREES: f64 = 40.0;

/// The source of vertex normals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum NormalSource {
    /// The file; missing normals are computed as for `AreaAngle`.
    #[default]
    File,
    /// The plain average of the abutting polygons' normals.
    Mean,
    /// Weighted by the polygons' areas.
    Area,
    /// Weighted by the polygons' angles at the vertex.
    Angle,
    /// Weighted by area times angle.
    AreaAngle,
}

/// How vertex normals are found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalOptions {
    /// Where they come from.
    pub source: NormalSource,
    /// An edge is smooth where the normals of its two faces differ by less than this. From pi on
    /// all faces around a vertex are averaged, even those that share nothing but the vertex.
    /// Meshes with smoothing groups have no need of it.
    pub crease_radians: f64,
}

impl Default for NormalOptions {
    fn default() -> Self {
        Self { source: NormalSource::File, crease_radians: DEFAULT_CREASE_DEGREES.to_radians() }
    }
}

impl Scene {
    /// [`Mesh::compute_normals`] for all meshes.
    pub fn compute_normals(&mut self, options: &NormalOptions) {
        for mesh in &mut self.meshes {
            mesh.compute_normals(options);
        }
    }
}

impl Mesh {
    /// Gives every attribute vertex a unit normal, as the options say.
    ///
    /// With [`NormalSource::File`], normals that are there are kept: brought to unit length, and
    /// replaced by the average of their vertex's faces where they are zero or not finite. Otherwise
    /// attribute vertices are split where faces that don't belong together meet, and their
    /// texture coordinates, colours and tangents are copied. A vertex without any sound face gets
    /// +Z. The result depends on nothing but the mesh and the options.
    pub fn compute_normals(&mut self, options: &NormalOptions) {
        if !self.sections.is_empty() {
            self.change_sections(&mut |section| section.compute_normals(options));
        } else if options.source == NormalSource::File
            && !self.normals.is_empty()
            && self.has_normals_at_all_corners()
        {
            self.mend_normals();
        } else if self.triangles.is_empty() {
            self.normals.clear();
        } else {
            let topology = Topology::of(self);
            let faces = Faces::of(self, options.source);
            let fans = around::gather(self, &topology, &faces, options.crease_radians);
            self.normals.clear();
            self.normals = fans.assign(self, &topology, NO_DIRECTION);
        }
    }

    fn has_normals_at_all_corners(&self) -> bool {
        if self.attribute_corners.is_none() && self.normals.len() >= self.positions.len() {
            // Corners are positions.
            return true;
        }
        let highest = self.attribute_corners().as_flattened().iter().max();
        highest.is_none_or(|&highest| (highest as usize) < self.normals.len())
    }

    /// Brings normals to unit length and replaces those that have no direction.
    fn mend_normals(&mut self) {
        let is_broken = AtomicBool::new(false);
        fill(&mut self.normals, RUN, &|_, run| {
            for normal in run {
                *normal = unit(normal.map(f64::from)).unwrap_or_else(|| {
                    is_broken.store(true, Ordering::Relaxed);
                    [0.0; 3]
                });
            }
        });
        if !is_broken.into_inner() {
            return;
        }
        let faces = Faces::of(self, NormalSource::AreaAngle);
        let mut sums = vec![[0.0; 3]; self.normals.len()];
        for (triangle, corners) in self.attribute_corners().iter().enumerate() {
            let face = faces.at(triangle);
            for (&vertex, weight) in corners.iter().zip(face.weights) {
                face.add_to(&mut sums[vertex as usize], weight);
            }
        }
        for (normal, sum) in self.normals.iter_mut().zip(sums) {
            if *normal == [0.0; 3] {
                *normal = unit(sum).unwrap_or(NO_DIRECTION);
            }
        }
    }
}

/// The normal of a vertex without any sound face.
const NO_DIRECTION: [f32; 3] = [0.0, 0.0, 1.0];

/// The normalized vector; `None` for zero and non-finite ones.
fn unit([x, y, z]: [f64; 3]) -> Option<[f32; 3]> {
    let largest = x.abs().max(y.abs()).max(z.abs());
    // Also false if one is not a number: sums of such are none.
    if !(largest > 0.0 && (x + y + z).is_finite()) {
        return None;
    }
    let [x, y, z] = [x / largest, y / largest, z / largest];
    let length = (x * x + y * y + z * z).sqrt();
    Some([x / length, y / length, z / length].map(|value| value as f32))
}

#[cfg(test)]
mod tests;
