//! STL: triangles without connections, binary or text.
//!
//! The content distinguishes the two: a file of exactly 84 + 50 n bytes, n being the count after
//! the header, is binary whatever the header contains; otherwise text begins with `solid` and has
//! `facet` or `endsolid` before its first zero byte. Bitwise equal corners (-0 equals 0) are
//! welded, so that surfaces can be shaded smoothly. The file's normals are ignored: they follow
//! from the corners, and are often wrong.

mod ascii;
mod binary;

use crate::block_reader::BlockReader;
use crate::format::declared_stl_size;
use crate::warnings::{Warnings, warn_of_faces_left_out};
use crate::weld::{BYTES_PER_KEY, Welder};
use crate::{Error, ErrorKind, Format, Limits, Loaded, Place};
use luxel_scene::{DVec3, Joiner, MaterialId, Mesh, Part, Scene, SceneMaterial};

/// A triangle's three indices, and up to three new positions with their keys.
const BYTES_PER_TRIANGLE: u64 = 12 + 3 * (12 + BYTES_PER_KEY);

/// Reads an STL file. Each solid is an object; solids without a name are called `name`.
pub(crate) fn read(bytes: &[u8], name: &str, limits: &Limits) -> Result<Loaded, Error> {
    let mut warnings = Warnings::default();
    let solids = if is_text(bytes) {
        ascii::read(bytes, name, limits, &mut warnings)?
    } else {
        Solids::of_one(name, binary::read(bytes, limits, &mut warnings)?)
    };
    Ok(loaded(solids, warnings))
}

/// Reads a long binary file without holding it in memory; `None` for others.
pub(crate) fn stream(
    file: &BlockReader<'_>,
    name: &str,
    limits: &Limits,
) -> Result<Option<Loaded>, Error> {
    let facets = binary::stream(file, limits)?;
    Ok(facets.map(|facets| loaded(Solids::of_one(name, facets), Warnings::default())))
}

fn loaded(solids: Solids, mut warnings: Warnings) -> Loaded {
    warn_of_faces_left_out(solids.left_out, &mut warnings);
    let mut scene = Scene { up: DVec3::Z, ..Scene::default() };
    let mut joiner = Joiner::new(solids.names.len());
    for (name, mesh) in solids.names.into_iter().zip(solids.meshes) {
        joiner.push(name, mesh);
    }
    joiner.finish(&mut scene);
    scene.materials.push(SceneMaterial::default());
    Loaded { scene, format: Format::Stl, warnings: warnings.finish() }
}

fn is_text(bytes: &[u8]) -> bool {
    // Names are seldom longer than this, so a keyword comes before.
    const WITHIN: usize = 4096;
    if declared_stl_size(bytes) == Some(bytes.len() as u64) {
        return false;
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let head = &bytes[..bytes.len().min(WITHIN)];
    let head = head.split(|&byte| byte == 0).next().unwrap_or(head).to_ascii_lowercase();
    let has = |word: &[u8]| head.windows(word.len()).any(|window| window == word);
    head.starts_with(b"solid") && (head.len() == bytes.len() || has(b"facet") || has(b"endsolid"))
}

/// The objects of a file.
#[derive(Default)]
struct Solids {
    names: Vec<String>,
    meshes: Vec<Mesh>,
    /// Facets that have corners which are no places.
    left_out: u64,
}

impl Solids {
    fn of_one(name: &str, facets: Facets) -> Self {
        let mut solids = Self::default();
        solids.push(name.to_owned(), facets);
        solids
    }

    /// Takes an object, unless nothing is left of it.
    fn push(&mut self, name: String, facets: Facets) {
        self.left_out += facets.left_out;
        if !facets.triangles.is_empty() {
            self.names.push(name);
            self.meshes.push(facets.into_mesh());
        }
    }
}

/// Welds the corners of triangles.
struct Facets {
    welder: Welder,
    triangles: Vec<[u32; 3]>,
    left_out: u64,
}

impl Facets {
    /// Closed surfaces have half as many vertices as triangles.
    fn with_room_for(triangles: usize) -> Self {
        Self {
            welder: Welder::with_room_for(triangles / 2 + 2),
            triangles: Vec::with_capacity(triangles),
            left_out: 0,
        }
    }

    #[inline]
    fn push(&mut self, corners: [[f32; 3]; 3]) {
        if is_finite(&corners) {
            self.triangles.push(self.welder.insert_all(corners.map(key)));
        } else {
            self.left_out += 1;
        }
    }

    /// Welds a batch of triangles.
    fn push_all(&mut self, triangles: &[[[f32; 3]; 3]]) {
        let (eights, rest) = triangles.as_chunks::<8>();
        for eight in eights {
            if eight.iter().all(is_finite) {
                let mut keys = [[0; 3]; 24];
                for (key, &corner) in keys.iter_mut().zip(eight.as_flattened()) {
                    *key = self::key(corner);
                }
                let numbers = self.welder.insert_all(keys);
                self.triangles.extend_from_slice(numbers.as_chunks().0);
            } else {
                eight.iter().for_each(|&corners| self.push(corners));
            }
        }
        rest.iter().for_each(|&corners| self.push(corners));
    }

    fn into_mesh(mut self) -> Mesh {
        let count = self.triangles.len() as u32;
        self.triangles.shrink_to_fit();
        Mesh {
            positions: self.welder.keys().iter().map(|key| key.map(f32::from_bits)).collect(),
            triangles: self.triangles,
            parts: vec![Part { first: 0, count, material: MaterialId(0) }],
            ..Mesh::default()
        }
    }
}

fn is_finite(corners: &[[f32; 3]; 3]) -> bool {
    corners.as_flattened().iter().all(|value| value.is_finite())
}

/// The welding key of a corner. Adding 0 turns -0 into 0 and changes nothing else.
fn key(corner: [f32; 3]) -> [u32; 3] {
    corner.map(|value| (value + 0.0).to_bits())
}

/// Checks that indices and memory suffice for so many triangles.
fn check_count(triangles: u64, limits: &Limits, place: Place) -> Result<(), Error> {
    if triangles > u64::from(u32::MAX) / 3 {
        let message = format!("{triangles} triangles are more than 32 bits can index");
        return Err(Error::at(place, ErrorKind::Unsupported(message)));
    }
    limits.check("the triangles", triangles, BYTES_PER_TRIANGLE, place)
}

#[cfg(test)]
mod tests;
