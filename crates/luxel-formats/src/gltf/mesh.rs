//! Meshes: the primitives of one glTF mesh, joined in their order.
//!
//! Primitives that name the same accessors share their vertices. Where some primitives have an
//! attribute that others lack, the others get values that change nothing: white, (0, 0), and for
//! normals and tangents zero vectors, which stand for missing ones.

use super::accessor;
use super::buffers::{Buffers, item, malformed};
use super::draco;
use super::pose::{self, Pose};
use super::topology::{self, Mode};
use super::vertices::{Source, Vertices};
use crate::warnings::Warnings;
use crate::{Error, ErrorKind, Place};
use luxel_gltf::{Index, Primitive};
use luxel_scene::{Lines, MaterialId, Mesh, Part, Points};
use std::collections::{BTreeMap, HashMap};

/// Materials for primitives without one; they follow the file's materials.
#[derive(Debug, Default)]
pub(crate) struct DefaultMaterials {
    /// Number of materials in the file.
    pub(crate) in_file: u32,
    /// The default materials in use: without and with vertex colours.
    pub(crate) used: [Option<MaterialId>; 2],
}

impl DefaultMaterials {
    fn get(&mut self, with_colors: bool) -> MaterialId {
        let taken = self.used.iter().flatten().count() as u32;
        let in_file = self.in_file;
        *self.used[usize::from(with_colors)].get_or_insert(MaterialId(in_file + taken))
    }
}

/// Builds mesh `index` in a pose.
pub(crate) fn build(
    buffers: &Buffers<'_>,
    index: Index,
    pose: &Pose,
    materials: &mut DefaultMaterials,
    warnings: &mut Warnings,
) -> Result<Mesh, Error> {
    let mut joined = Joined::default();
    let mesh = &buffers.document().meshes[index as usize];
    for (number, primitive) in mesh.primitives.iter().enumerate() {
        let pointer = format!("/meshes/{index}/primitives/{number}");
        let mode = primitive.mode.unwrap_or(4);
        let Some(mode) = Mode::from_code(mode) else {
            let message = format!("{mode} is not a mode: use 0 to 6");
            return Err(malformed(format!("{pointer}/mode"), message));
        };
        let material = match primitive.material {
            Some(material) => {
                let materials = &buffers.document().materials;
                item(materials, material, "material", &|| format!("{pointer}/material"))?;
                MaterialId(material)
            }
            None => materials.get(primitive.attributes.contains_key("COLOR_0")),
        };
        let draco = match &primitive.extensions.draco {
            Some(draco) if mode.has_triangles() => {
                Some(draco::decode(buffers, draco, &|| pointer.clone())?)
            }
            _ => None,
        };
        let source = Source { buffers, primitive, pointer: &pointer, draco: draco.as_ref() };
        let Some(run) = joined.vertices_of(&source, pose)? else {
            warnings.push(format!("{pointer}: left out: it has no POSITION"));
            continue;
        };
        match draco {
            Some(draco) => {
                // Positions may come from an accessor beside the stream.
                if draco.vertices() > run.count as usize {
                    let (wanted, there) = (draco.vertices(), run.count);
                    let message =
                        format!("the Draco stream has {wanted} vertices, but positions {there}");
                    return Err(malformed(pointer, message));
                }
                joined.add_triangles(draco.into_triangles(), run, material, &pointer, warnings);
            }
            None => {
                let corners = corners(&source, mode, run.count, &pointer, warnings)?;
                joined.add(mode, &corners, run, material, &pointer, warnings);
            }
        }
    }
    Ok(joined.finish())
}

/// The vertex indices of a primitive, in order.
fn corners(
    source: &Source<'_, '_>,
    mode: Mode,
    count: u32,
    pointer: &str,
    warnings: &mut Warnings,
) -> Result<Vec<u32>, Error> {
    // The index, the decoded index, and a copy while the mesh grows.
    const BYTES_PER_CORNER: u64 = 32;
    let memory = source.buffers.memory();
    let corners = match source.primitive.indices {
        None => {
            let place = || Place::Pointer(pointer.to_owned());
            memory.take("vertices without indices", u64::from(count), BYTES_PER_CORNER, place())?;
            (0..count).collect()
        }
        Some(index) => {
            let pointer = || format!("{pointer}/indices");
            let elements = accessor::elements(source.buffers, index, &pointer)?;
            let place = || Place::Pointer(pointer());
            memory.take("indices", elements.count as u64, BYTES_PER_CORNER, place())?;
            let indices = elements.indices().map_err(|message| malformed(pointer(), message))?;
            if let Some(&index) = indices.iter().find(|&&index| index >= count) {
                let kind = ErrorKind::OutOfRange {
                    what: "vertex",
                    index: i64::from(index),
                    count: u64::from(count),
                };
                return Err(Error::at(place(), kind));
            }
            indices
        }
    };
    let left_over = mode.left_over(corners.len());
    if left_over > 0 {
        warnings.push(format!(
            "{pointer}: the last {left_over} corners complete no primitive and are ignored"
        ));
    }
    Ok(corners)
}

/// A primitive's range of vertices in the mesh.
#[derive(Clone, Copy, Debug)]
struct Run {
    first: u32,
    count: u32,
}

/// Identifies the vertices of a primitive: its attributes and morph targets.
type Key<'k> = (&'k BTreeMap<String, Index>, &'k Vec<BTreeMap<String, Index>>);

/// Primitives joined into one mesh.
#[derive(Default)]
struct Joined<'k> {
    mesh: Mesh,
    positions: Vec<[f64; 3]>,
    runs: HashMap<Key<'k>, Run>,
}

impl<'k> Joined<'k> {
    /// Reads a primitive's vertices, or reuses those of an earlier primitive.
    fn vertices_of(&mut self, source: &Source<'_, 'k>, pose: &Pose) -> Result<Option<Run>, Error> {
        let primitive: &'k Primitive = source.primitive;
        let key = (&primitive.attributes, &primitive.targets);
        // Draco streams number their vertices themselves.
        let is_shared = source.draco.is_none();
        if let Some(&run) = self.runs.get(&key).filter(|_| is_shared) {
            return Ok(Some(run));
        }
        let Some(mut vertices) = source.vertices()? else { return Ok(None) };
        pose::morph(&mut vertices, source, pose)?;
        if let Some(joints) = &pose.joints {
            pose::skin(&mut vertices, joints, source)?;
        }
        let first = self.positions.len();
        let count = vertices.positions.len();
        if first + count > u32::MAX as usize {
            let message = "a mesh of more than 4294967295 vertices is too large".to_owned();
            let place = Place::Pointer(source.pointer.to_owned());
            return Err(Error::at(place, ErrorKind::Unsupported(message)));
        }
        let run = Run { first: first as u32, count: count as u32 };
        self.append(vertices);
        if is_shared {
            self.runs.insert(key, run);
        }
        Ok(Some(run))
    }

    fn append(&mut self, vertices: Vertices) {
        /// Makes two lists of values of `before` and `count` vertices into one, with `neutral`
        /// where either has none. Values that aren't finite become neutral too.
        fn join<const N: usize>(
            list: &mut Vec<[f32; N]>,
            mut more: Vec<[f32; N]>,
            [before, count]: [usize; 2],
            neutral: [f32; N],
        ) {
            if list.is_empty() && more.is_empty() {
                return;
            }
            for value in &mut more {
                if !value.iter().all(|component| component.is_finite()) {
                    *value = neutral;
                }
            }
            if list.is_empty() && before == 0 {
                *list = more;
            } else {
                list.resize(before, neutral);
                list.append(&mut more);
            }
            list.resize(before + count, neutral);
        }
        let counts = [self.positions.len(), vertices.positions.len()];
        let mesh = &mut self.mesh;
        join(&mut mesh.normals, vertices.normals, counts, [0.0; 3]);
        join(&mut mesh.tangents, vertices.tangents, counts, [0.0; 4]);
        let [first_uvs, second_uvs] = vertices.uvs;
        join(&mut mesh.uvs[0], first_uvs, counts, [0.0; 2]);
        join(&mut mesh.uvs[1], second_uvs, counts, [0.0; 2]);
        join(&mut mesh.colors, vertices.colors, counts, [1.0; 4]);
        if self.positions.is_empty() {
            self.positions = vertices.positions;
        } else {
            self.positions.extend(vertices.positions);
        }
    }

    fn add(
        &mut self,
        mode: Mode,
        corners: &[u32],
        run: Run,
        material: MaterialId,
        pointer: &str,
        warnings: &mut Warnings,
    ) {
        if mode.has_triangles() {
            let triangles = topology::triangles(mode, corners);
            return self.add_triangles(triangles, run, material, pointer, warnings);
        }
        let whole = |index: &u32| self.is_finite(run.first + index);
        let (left_out, what);
        if mode == Mode::Points {
            let indices: Vec<u32> = corners
                .iter()
                .filter(|index| whole(index))
                .map(|&index| run.first + index)
                .collect();
            (left_out, what) = (corners.len() - indices.len(), "points");
            self.mesh.points.push(Points { indices, material });
        } else {
            let all = topology::segments(mode, corners);
            let count = all.len();
            let kept = all.into_iter().filter(|ends| ends.iter().all(whole));
            let segments: Vec<_> = kept.map(|ends| ends.map(|index| run.first + index)).collect();
            (left_out, what) = (count - segments.len(), "line segments");
            self.mesh.lines.push(Lines { segments, material });
        }
        warn_of_left_out(left_out, what, pointer, warnings);
    }

    fn add_triangles(
        &mut self,
        mut triangles: Vec<[u32; 3]>,
        run: Run,
        material: MaterialId,
        pointer: &str,
        warnings: &mut Warnings,
    ) {
        triangles.iter_mut().flatten().for_each(|corner| *corner += run.first);
        let before = triangles.len();
        triangles.retain(|corners| corners.iter().all(|&corner| self.is_finite(corner)));
        warn_of_left_out(before - triangles.len(), "faces", pointer, warnings);
        if triangles.is_empty() {
            return;
        }
        let first = self.mesh.triangles.len() as u32;
        self.mesh.parts.push(Part { first, count: triangles.len() as u32, material });
        if first == 0 {
            self.mesh.triangles = triangles;
        } else {
            self.mesh.triangles.extend(triangles);
        }
    }

    /// Whether a position is finite in `f32`.
    fn is_finite(&self, vertex: u32) -> bool {
        let most = f64::from(f32::MAX);
        self.positions[vertex as usize].iter().all(|coordinate| coordinate.abs() <= most)
    }

    fn finish(mut self) -> Mesh {
        self.mesh.set_positions(&self.positions);
        // No face uses the positions that aren't finite; zeros spare later stages the check.
        for position in &mut self.mesh.positions {
            if !position.iter().all(|coordinate| coordinate.is_finite()) {
                *position = [0.0; 3];
            }
        }
        self.mesh
    }
}

fn warn_of_left_out(count: usize, what: &str, pointer: &str, warnings: &mut Warnings) {
    if count > 0 {
        warnings.push(format!(
            "{pointer}: {count} {what} with a corner that is not finite are left out"
        ));
    }
}
