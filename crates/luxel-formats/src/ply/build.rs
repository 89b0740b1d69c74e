//! Builds a scene of one object from the file's elements.

use super::Content;
use super::faces::{Faces, Polygons};
use super::source::RUN;
use super::vertices::Vertices;
use crate::direction::unit;
use crate::warnings::{Warnings, warn_of_faces_left_out};
use crate::{Error, ErrorKind, Place};
use luxel_parallel::{any, fill};
use luxel_scene::{
    AlphaMode, Lines, MaterialId, Mesh, MeshId, Node, NormalFault, Part, Points, Scene,
    SceneMaterial, triangulate,
};
use std::sync::{Mutex, PoisonError};

pub(super) fn scene(content: Content, name: &str, warnings: &mut Warnings) -> Result<Scene, Error> {
    let mut scene = Scene::default();
    let mesh = mesh(content, warnings)?;
    let mut material = SceneMaterial::default();
    if !mesh.colors.is_empty() {
        // The vertex colour replaces the material's.
        material.constants.diffuse = [1.0; 3];
        if lets_light_through(&mesh.colors) {
            material.alpha_mode = AlphaMode::Blend;
        }
    }
    scene.materials.push(material);
    if !mesh.positions.is_empty() {
        scene.nodes.push(Node::root(name, Some(MeshId(0))));
        scene.meshes.push(mesh);
    }
    Ok(scene)
}

/// Whether to use alpha: writers that fill it with zeros don't intend an invisible surface.
fn lets_light_through(colors: &[[f32; 4]]) -> bool {
    let has = |is: fn(f32) -> bool| {
        any(colors.len(), RUN, &|run| colors[run].iter().any(|color| is(color[3])))
    };
    has(|alpha| alpha < 1.0) && has(|alpha| alpha > 0.0)
}

fn mesh(content: Content, warnings: &mut Warnings) -> Result<Mesh, Error> {
    let Content { mut vertices, mut faces, edges } = content;
    let mut mesh = Mesh::default();
    if vertices.doubles.is_empty() {
        mesh.positions = std::mem::take(&mut vertices.singles);
    } else {
        mesh.set_positions(&vertices.doubles);
        vertices.doubles = Vec::new();
    }
    if let Some(polygons) = faces.polygons.take() {
        let (triangles, of_polygon) = cut(&polygons, &mesh)?;
        faces.triangles = triangles;
        faces.colors = of_polygon
            .iter()
            .filter_map(|&polygon| faces.colors.get(polygon as usize).copied())
            .collect();
        mesh.polygons = Some(of_polygon);
    }
    leave_out_unplaced(&mut faces, &mut mesh, warnings);
    mesh.triangles = faces.triangles;
    set_attributes(&mut mesh, vertices, faces.colors, warnings);
    let material = MaterialId(0);
    let count = mesh.triangles.len() as u32;
    mesh.parts.push(Part { first: 0, count, material });
    let is_placed = |index: u32| mesh.positions[index as usize].iter().all(|v| v.is_finite());
    let segments: Vec<_> =
        edges.into_iter().filter(|ends| ends.iter().all(|&end| is_placed(end))).collect();
    if !segments.is_empty() {
        mesh.lines.push(Lines { segments, material });
    } else if mesh.triangles.is_empty() {
        let indices: Vec<_> =
            (0..mesh.positions.len() as u32).filter(|&index| is_placed(index)).collect();
        mesh.points.push(Points { indices, material });
    }
    Ok(mesh)
}

/// Triangulates polygons; returns the polygon of each triangle, too.
fn cut(polygons: &Polygons, mesh: &Mesh) -> Result<(Vec<[u32; 3]>, Vec<u32>), Error> {
    let mut triangles = Vec::with_capacity(polygons.corners.len());
    let mut of_polygon = Vec::with_capacity(polygons.corners.len());
    let mut outline = Vec::new();
    let mut pieces = Vec::new();
    let mut start = 0;
    for (polygon, &end) in polygons.ends.iter().enumerate() {
        let corners = &polygons.corners[start..end as usize];
        start = end as usize;
        if let &[a, b, c] = corners {
            triangles.push([a, b, c]);
        } else {
            outline.clear();
            outline.extend(corners.iter().map(|&corner| mesh.position(corner).to_array()));
            pieces.clear();
            triangulate(&outline, &mut pieces);
            triangles
                .extend(pieces.iter().map(|piece| piece.map(|corner| corners[corner as usize])));
        }
        of_polygon.resize(triangles.len(), polygon as u32);
    }
    if u32::try_from(triangles.len()).is_err() {
        let message = format!("{} triangles are more than 32 bits can index", triangles.len());
        return Err(Error::at(Place::File, ErrorKind::Unsupported(message)));
    }
    Ok((triangles, of_polygon))
}

/// Leaves out faces with a corner that isn't finite.
fn leave_out_unplaced(faces: &mut Faces, mesh: &mut Mesh, warnings: &mut Warnings) {
    let is_placed = |position: &[f32; 3]| position.iter().all(|value| value.is_finite());
    if !any(mesh.positions.len(), RUN, &|run| !mesh.positions[run].iter().all(is_placed)) {
        return;
    }
    let polygon_of = |triangle: usize| match &mesh.polygons {
        Some(polygons) => polygons[triangle],
        None => triangle as u32,
    };
    // A polygon is dropped as a whole.
    let mut unplaced = Vec::new();
    for (triangle, corners) in faces.triangles.iter().enumerate() {
        if !corners.iter().all(|&corner| is_placed(&mesh.positions[corner as usize])) {
            unplaced.push(polygon_of(triangle));
        }
    }
    unplaced.dedup();
    let keep: Vec<_> = (0..faces.triangles.len())
        .map(|triangle| unplaced.binary_search(&polygon_of(triangle)).is_err())
        .collect();
    retain(&mut faces.triangles, &keep);
    retain(&mut faces.colors, &keep);
    if let Some(polygons) = &mut mesh.polygons {
        retain(polygons, &keep);
    }
    warn_of_faces_left_out(unplaced.len() as u64, warnings);
}

fn retain<T>(values: &mut Vec<T>, keep: &[bool]) {
    let mut keep = keep.iter();
    values.retain(|_| keep.next().copied().unwrap_or(true));
}

fn set_attributes(
    mesh: &mut Mesh,
    vertices: Vertices,
    face_colors: Vec<[f32; 4]>,
    warnings: &mut Warnings,
) {
    mesh.normals = vertices.normals;
    mesh.normal_faults = bring_to_unit_length(&mut mesh.normals);
    if !mesh.normal_faults.is_empty() {
        let mut is_used = vec![false; mesh.positions.len()];
        mesh.triangles.as_flattened().iter().for_each(|&corner| is_used[corner as usize] = true);
        mesh.normal_faults.retain(|fault| is_used[fault.position as usize]);
    }
    if mesh.normal_faults.iter().any(|fault| fault.undefined) {
        warnings.push(
            "some normals in use have length zero: all normals are computed instead".to_owned(),
        );
        mesh.normals = Vec::new();
    }
    mesh.uvs[0] = vertices.uvs;
    // Images begin at the top, PLY's second coordinate points up.
    fill(&mut mesh.uvs[0], RUN, &|_, run| {
        for uv in run {
            *uv = [uv[0], 1.0 - uv[1]].map(|value| if value.is_finite() { value } else { 0.0 });
        }
    });
    mesh.colors = vertices.colors;
    // Writers with both kinds fill the unused kind with a single colour.
    let first = mesh.colors.first().copied();
    let colors = &mesh.colors;
    let tells_something =
        any(colors.len(), RUN, &|run| colors[run].iter().any(|&color| Some(color) != first));
    if !tells_something && !face_colors.is_empty() {
        color_faces(mesh, &face_colors);
    }
}

/// Normalizes normals, zero where they have no direction; returns their faults in order.
fn bring_to_unit_length(normals: &mut [[f32; 3]]) -> Vec<NormalFault> {
    let faults = Mutex::new(Vec::new());
    fill(normals, RUN, &|start, run| {
        let mut found = Vec::new();
        for (vertex, normal) in (start as u32..).zip(run) {
            found.extend(NormalFault::of(vertex, *normal));
            *normal = unit(*normal);
        }
        if !found.is_empty() {
            faults.lock().unwrap_or_else(PoisonError::into_inner).append(&mut found);
        }
    });
    let mut faults = faults.into_inner().unwrap_or_else(PoisonError::into_inner);
    faults.sort_unstable();
    faults
}

/// Gives every corner a separate attribute vertex with its face's colour.
fn color_faces(mesh: &mut Mesh, face_colors: &[[f32; 4]]) {
    let corners = mesh.triangles.as_flattened();
    let of_corner = |index: &u32| *index as usize;
    if !mesh.normals.is_empty() {
        mesh.normals = corners.iter().map(|index| mesh.normals[of_corner(index)]).collect();
    }
    if !mesh.uvs[0].is_empty() {
        mesh.uvs[0] = corners.iter().map(|index| mesh.uvs[0][of_corner(index)]).collect();
    }
    mesh.colors = face_colors.iter().flat_map(|&color| [color; 3]).collect();
    let count = mesh.triangles.len() as u32;
    let numbered = |triangle: u32| [3 * triangle, 3 * triangle + 1, 3 * triangle + 2];
    mesh.attribute_corners = Some((0..count).map(numbered).collect());
}
