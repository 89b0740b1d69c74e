//! Builds one mesh per object, with its positions and attributes, from the statements.

use super::document::{Document, Kind, NONE};
use super::materials::Materials;
use crate::Error;
use crate::text::shown;
use crate::warnings::{Warnings, warn_of_faces_left_out};
use crate::weld::Welder;
use luxel_scene::{Joiner, Lines, MaterialId, Mesh, NormalFault, Part, Points, Scene, triangulate};
use std::ops::Range;

/// Groups the elements into objects; drops objects without elements.
pub(super) fn objects(
    document: &Document<'_>,
    stem: &str,
    materials: &mut Materials<'_>,
    scene: &mut Scene,
    warnings: &mut Warnings,
) -> Result<(), Error> {
    let mut builder = Builder {
        document,
        local: vec![NONE; document.positions.len()],
        outline: Vec::new(),
        pieces: Vec::new(),
        left_out: 0,
        too_small: 0,
    };
    let ranges = ranges(document);
    let mut joiner = Joiner::new(ranges.len());
    for (name, elements) in ranges {
        let name = if name.is_empty() { stem.to_owned() } else { shown(name) };
        if let Some(mesh) = builder.mesh(elements, &name, materials, warnings)? {
            joiner.push(name, mesh);
        }
    }
    joiner.finish(scene);
    warn_of_faces_left_out(builder.left_out, warnings);
    if builder.too_small > 0 {
        let count = builder.too_small;
        warnings.push(format!("faces with fewer than three corners were left out: {count}"));
    }
    Ok(())
}

/// The elements of each object, with its name. Objects come from `o`, or from `g` in a file
/// without `o`; a statement that repeats the current name continues the object.
fn ranges<'a>(document: &Document<'a>) -> Vec<(&'a [u8], Range<usize>)> {
    let by_object = document.beginnings.iter().any(|beginning| beginning.is_object);
    let mut ranges: Vec<(&[u8], Range<usize>)> = vec![(b"", 0..0)];
    for beginning in &document.beginnings {
        let at = beginning.element as usize;
        if let Some((name, range)) = ranges.last_mut().filter(|_| beginning.is_object == by_object)
        {
            range.end = at;
            if *name != beginning.name {
                // An object without elements is left out.
                ranges.pop_if(|(_, range)| range.start == range.end);
                ranges.push((beginning.name, at..at));
            }
        }
    }
    if let Some((_, range)) = ranges.last_mut() {
        range.end = document.elements.len();
    }
    ranges.retain(|(_, range)| range.start < range.end);
    ranges
}

struct Builder<'a> {
    document: &'a Document<'a>,
    /// For each position, its number in the object being built, or [`NONE`].
    local: Vec<u32>,
    outline: Vec<[f64; 3]>,
    pieces: Vec<[u32; 3]>,
    left_out: u64,
    too_small: u64,
}

/// The data collected for one object.
#[derive(Default)]
struct Object {
    /// Its positions, as indices of the file.
    used: Vec<u32>,
    triangles: Vec<[u32; 3]>,
    /// The corners of the triangles, positions included, as indices of the file.
    corners: Vec<[[u32; 3]; 3]>,
    polygons: Vec<u32>,
    smoothing: Vec<u32>,
    /// Runs of triangles with one material: its number in the file, and the count.
    runs: Vec<(u32, u32)>,
    segments: Vec<(u32, [u32; 2])>,
    points: Vec<(u32, u32)>,
}

impl Builder<'_> {
    fn mesh(
        &mut self,
        elements: Range<usize>,
        name: &str,
        materials: &mut Materials<'_>,
        warnings: &mut Warnings,
    ) -> Result<Option<Mesh>, Error> {
        let document = self.document;
        let mut object = Object::default();
        let mut has_polygons = false;
        for (polygon, index) in elements.enumerate() {
            let element = document.elements[index];
            let corners = document.corners_of(index);
            if corners.iter().any(|corner| !self.is_placed(corner[0])) {
                self.left_out += 1;
                continue;
            }
            match element.kind {
                Kind::Face if corners.len() < 3 => self.too_small += 1,
                Kind::Face => {
                    has_polygons |= corners.len() > 3;
                    self.cut(corners);
                    for piece in &self.pieces {
                        let corners = piece.map(|corner| corners[corner as usize]);
                        let triangle = corners
                            .map(|corner| number(&mut self.local, &mut object.used, corner[0]));
                        object.triangles.push(triangle);
                        object.corners.push(corners);
                        object.polygons.push(polygon as u32);
                        object.smoothing.push(element.smoothing);
                    }
                    let count = self.pieces.len() as u32;
                    match object.runs.last_mut() {
                        Some((material, length)) if *material == element.material => {
                            *length += count;
                        }
                        _ => object.runs.push((element.material, count)),
                    }
                }
                Kind::Line => {
                    for pair in corners.windows(2) {
                        let ends = [pair[0][0], pair[1][0]]
                            .map(|end| number(&mut self.local, &mut object.used, end));
                        object.segments.push((element.material, ends));
                    }
                }
                Kind::Points => {
                    for corner in corners {
                        let point = number(&mut self.local, &mut object.used, corner[0]);
                        object.points.push((element.material, point));
                    }
                }
            }
        }
        for &position in &object.used {
            self.local[position as usize] = NONE;
        }
        if object.used.is_empty() {
            return Ok(None);
        }
        let mut mesh = Mesh::default();
        let positions: Vec<_> =
            object.used.iter().map(|&index| document.positions[index as usize]).collect();
        mesh.set_positions(&positions);
        mesh.triangles = std::mem::take(&mut object.triangles);
        mesh.triangles.shrink_to_fit();
        mesh.polygons = has_polygons.then(|| std::mem::take(&mut object.polygons));
        mesh.smoothing_groups =
            document.has_smoothing.then(|| std::mem::take(&mut object.smoothing));
        set_attributes(&mut mesh, document, &object, name, warnings);
        // Materials may take as much again.
        object.corners = Vec::new();
        set_materials(&mut mesh, &object, materials, warnings)?;
        Ok(Some(mesh))
    }

    /// Positions beyond single precision count as not finite.
    fn is_placed(&self, position: u32) -> bool {
        let position = self.document.positions[position as usize];
        position.iter().all(|&value| (value as f32).is_finite())
    }

    /// Triangulates a face of three corners or more.
    fn cut(&mut self, corners: &[[u32; 3]]) {
        self.pieces.clear();
        if corners.len() == 3 {
            self.pieces.push([0, 1, 2]);
            return;
        }
        self.outline.clear();
        let place = |corner: &[u32; 3]| self.document.positions[corner[0] as usize];
        self.outline.extend(corners.iter().map(place));
        triangulate(&self.outline, &mut self.pieces);
    }
}

/// The index of a position in its object.
fn number(local: &mut [u32], used: &mut Vec<u32>, position: u32) -> u32 {
    let number = &mut local[position as usize];
    if *number == NONE {
        *number = used.len() as u32;
        used.push(position);
    }
    *number
}

fn set_attributes(
    mesh: &mut Mesh,
    document: &Document<'_>,
    object: &Object,
    name: &str,
    warnings: &mut Warnings,
) {
    let corners = object.corners.as_flattened();
    let has_uvs = corners.iter().any(|corner| corner[1] != NONE);
    let some_normals = corners.iter().any(|corner| corner[2] != NONE);
    let is_direction =
        |index: u32| document.normals.get(index as usize).is_some_and(|&normal| normal != [0.0; 3]);
    let has_normals = some_normals && corners.iter().all(|corner| is_direction(corner[2]));
    if !document.normal_faults.is_empty() {
        mesh.normal_faults = faults_of(mesh, document, corners);
    }
    if some_normals && !has_normals {
        warnings.push(format!(
            "object `{name}`: corners without a normal, so all of its normals are computed instead"
        ));
    }
    let color = |&position: &u32| match document.colors.get(position as usize) {
        Some(&[r, g, b]) if !r.is_nan() => Some([r, g, b, 1.0]),
        _ => None,
    };
    let has_colors = object.used.iter().any(|position| color(position).is_some());
    let colors = || object.used.iter().map(|position| color(position).unwrap_or([1.0; 4]));
    if !has_uvs && !has_normals {
        if has_colors {
            mesh.colors = colors().collect();
        }
        return;
    }
    let unless = |kept: bool, index: u32| if kept { index } else { NONE };
    let key = |(&position, corner): (&u32, &[u32; 3])| {
        [position, unless(has_uvs, corner[1]), unless(has_normals, corner[2])]
    };
    let keys = || mesh.triangles.as_flattened().iter().zip(corners).map(key);
    let (keys, attributes) = match one_for_each_position(keys(), object.used.len()) {
        Some(keys) => (keys, None),
        None => {
            let mut welder = Welder::with_room_for(object.used.len());
            let attributes: Vec<_> = keys().map(|key| welder.insert(key).0).collect();
            (welder.into_keys(), Some(attributes.as_chunks().0.to_vec()))
        }
    };
    if has_uvs {
        let uv = |key: &[u32; 3]| document.uvs.get(key[1] as usize).copied().unwrap_or_default();
        mesh.uvs[0] = keys.iter().map(uv).collect();
    }
    if has_normals {
        let normal = |key: &[u32; 3]| document.normals[key[2] as usize];
        mesh.normals = keys.iter().map(normal).collect();
    }
    if has_colors {
        let of_positions: Vec<_> = colors().collect();
        let color = |key: &[u32; 3]| of_positions[key[0] as usize];
        mesh.colors = keys.iter().map(color).collect();
    }
    mesh.attribute_corners = attributes;
}

/// The keys by position, if each of `count` positions has exactly one and the order of first use is
/// the order of the positions: then one index serves positions and attributes.
fn one_for_each_position(
    keys: impl Iterator<Item = [u32; 3]>,
    count: usize,
) -> Option<Vec<[u32; 3]>> {
    let mut found: Vec<[u32; 3]> = Vec::with_capacity(count);
    for key in keys {
        match found.get(key[0] as usize) {
            Some(known) if *known == key => {}
            None if key[0] as usize == found.len() => found.push(key),
            _ => return None,
        }
    }
    (found.len() == count).then_some(found)
}

fn set_materials(
    mesh: &mut Mesh,
    object: &Object,
    materials: &mut Materials<'_>,
    warnings: &mut Warnings,
) -> Result<(), Error> {
    let is_colored = !mesh.colors.is_empty();
    let mut material = |number: u32| materials.get(number, is_colored, warnings);
    let mut first = 0;
    mesh.parts.reserve_exact(object.runs.len());
    for &(number, count) in &object.runs {
        mesh.parts.push(Part { first, count, material: material(number)? });
        first += count;
    }
    for &(number, ends) in &object.segments {
        let material = material(number)?;
        match mesh.lines.last_mut() {
            Some(lines) if lines.material == material => lines.segments.push(ends),
            _ => mesh.lines.push(Lines { segments: vec![ends], material }),
        }
    }
    for &(number, point) in &object.points {
        let material: MaterialId = material(number)?;
        match mesh.points.last_mut() {
            Some(points) if points.material == material => points.indices.push(point),
            _ => mesh.points.push(Points { indices: vec![point], material }),
        }
    }
    Ok(())
}

/// The fault of the normals that an object uses. The document lists faults in the order of its
/// normals.
fn faults_of(mesh: &Mesh, document: &Document, corners: &[[u32; 3]]) -> Vec<NormalFault> {
    let fault = |(&position, corner): (&u32, &[u32; 3])| {
        let faults = &document.normal_faults;
        let at = faults.binary_search_by_key(&corner[2], |fault| fault.position).ok()?;
        Some(NormalFault { position, ..faults[at] })
    };
    let positions = mesh.triangles.as_flattened().iter();
    let mut faults: Vec<_> = positions.zip(corners).filter_map(fault).collect();
    faults.sort_unstable();
    faults.dedup();
    faults
}
