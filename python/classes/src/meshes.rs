//! Arrays into meshes and textures.

use crate::arrays::{index_rows, rows};
use crate::errors::argument;
use luxel::scene::{DVec3, Encoding, Image, Lines, MaterialId, Mesh, Part, Points};
use pyo3::prelude::*;
use std::sync::Arc;

/// What the rows of indices are.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Elements {
    Triangles,
    Lines,
    /// All vertices; there are no indices.
    Points,
}

/// The arrays of a mesh with one material.
pub(crate) struct MeshArrays<'a, 'py> {
    /// What errors put before the names of arrays.
    pub(crate) place: &'a str,
    pub(crate) elements: Elements,
    /// (n, 3)
    pub(crate) vertices: &'a Bound<'py, PyAny>,
    /// (m, 3) of triangles, (m, 2) of lines.
    pub(crate) faces: Option<&'a Bound<'py, PyAny>>,
    /// (n, 3)
    pub(crate) normals: Option<&'a Bound<'py, PyAny>>,
    /// (n, 3) or (n, 4): sRGB bytes or linear floats.
    pub(crate) colors: Option<&'a Bound<'py, PyAny>>,
    /// (m, 3) or (m, 4), instead of those of vertices.
    pub(crate) face_colors: Option<&'a Bound<'py, PyAny>>,
    /// (n, 2), (0, 0) at the texture's lower left.
    pub(crate) uv: Option<&'a Bound<'py, PyAny>>,
}

impl MeshArrays<'_, '_> {
    /// The mesh.
    ///
    /// # Errors
    /// `ValueError` with the array's name and row: another shape, a number that isn't finite, an index out of
    /// range.
    pub(crate) fn mesh(&self, material: MaterialId) -> PyResult<Mesh> {
        let named = |name: &str| format!("{}{name}", self.place);
        let positions = rows::<3>(&named("vertices"), self.vertices)?;
        let count = positions.len();
        let is_far = |row: &[f64; 3]| row.iter().any(|&x| !(x as f32).is_finite());
        if let Some(row) = positions.iter().position(is_far) {
            let far = format!("row {row} is too far away for 32-bit floats");
            return Err(argument(&named("vertices"), far));
        }
        let mut mesh = Mesh::default();
        let faces = || {
            let missing = || argument(&named("faces"), "they are missing");
            self.faces.ok_or_else(missing)
        };
        match self.elements {
            Elements::Triangles => {
                mesh.triangles = index_rows(&named("faces"), faces()?, count)?;
                mesh.parts = vec![Part { first: 0, count: mesh.triangles.len() as u32, material }];
            }
            Elements::Lines => {
                let segments = index_rows(&named("faces"), faces()?, count)?;
                mesh.lines = vec![Lines { segments, material }];
            }
            Elements::Points => {
                mesh.points = vec![Points { indices: (0..count as u32).collect(), material }];
            }
        }
        mesh.set_positions(&positions);
        let as_many = |name: &str, found: usize| match found == count {
            true => Ok(()),
            false => Err(argument(&named(name), format!("{found} rows for {count} vertices"))),
        };
        if let Some(normals) = self.normals {
            let normals = rows::<3>(&named("normals"), normals)?;
            as_many("normals", normals.len())?;
            mesh.normals = normals.iter().map(|normal| unit(*normal)).collect();
        }
        if let Some(colors) = self.colors {
            mesh.colors = colors_of(&named("colors"), colors)?;
            as_many("colors", mesh.colors.len())?;
        }
        if let Some(uv) = self.uv {
            let uv = rows::<2>(&named("uv"), uv)?;
            as_many("uv", uv.len())?;
            mesh.uvs[0] = uv.iter().map(|&[u, v]| [u as f32, 1.0 - v as f32]).collect();
        }
        if let Some(colors) = self.face_colors {
            let colors = colors_of(&named("face_colors"), colors)?;
            let (found, expected) = (colors.len(), mesh.triangles.len());
            if found != expected {
                let wrong = format!("{found} rows for {expected} faces");
                return Err(argument(&named("face_colors"), wrong));
            }
            split_by_face(&mut mesh, &colors);
        }
        Ok(mesh)
    }
}

/// Gives each corner of a face attributes of its own, with the face's colour.
fn split_by_face(mesh: &mut Mesh, colors: &[[f32; 4]]) {
    let corners: Vec<u32> = mesh.triangles.as_flattened().to_vec();
    if !mesh.normals.is_empty() {
        mesh.normals = corners.iter().map(|&corner| mesh.normals[corner as usize]).collect();
    }
    if !mesh.uvs[0].is_empty() {
        mesh.uvs[0] = corners.iter().map(|&corner| mesh.uvs[0][corner as usize]).collect();
    }
    mesh.colors = colors.iter().flat_map(|&color| [color; 3]).collect();
    let own = |face: u32| [3 * face, 3 * face + 1, 3 * face + 2];
    mesh.attribute_corners = Some((0..mesh.triangles.len() as u32).map(own).collect());
}

/// A normal of unit length; +Z where it has none.
fn unit([x, y, z]: [f64; 3]) -> [f32; 3] {
    let normal = DVec3::new(x, y, z).normalize_or(DVec3::Z);
    normal.as_vec3().to_array()
}

/// Colours of vertices: bytes are sRGB, floats linear.
fn colors_of(name: &str, value: &Bound<'_, PyAny>) -> PyResult<Vec<[f32; 4]>> {
    let value = &value.py().import("numpy")?.call_method1("asarray", (value,))?;
    let kind: String = value.getattr("dtype")?.getattr("kind")?.extract()?;
    let width = value.getattr("shape")?.extract::<Vec<usize>>()?.get(1).copied();
    let rows: Vec<[f64; 4]> = match width {
        Some(4) => rows::<4>(name, value)?,
        _ => rows::<3>(name, value)?.iter().map(|&[r, g, b]| [r, g, b, full(&kind)]).collect(),
    };
    let linear = |row: &[f64; 4]| -> PyResult<[f32; 4]> {
        let [r, g, b, alpha] = row.map(|channel| channel / full(&kind));
        let channels = [r, g, b, alpha];
        if channels.iter().any(|channel| !(0.0..=1.0).contains(channel)) {
            return Err(argument(name, "expected bytes, or floats between 0 and 1"));
        }
        let decode = |channel: f64| match kind.as_str() {
            "u" | "i" => luxel::lighting::decode_srgb(channel) as f32,
            _ => channel as f32,
        };
        Ok([decode(r), decode(g), decode(b), alpha as f32])
    };
    rows.iter().map(linear).collect()
}

/// The number that stands for all of a channel.
fn full(kind: &str) -> f64 {
    if matches!(kind, "u" | "i") { 255.0 } else { 1.0 }
}

/// An image of bytes: (h, w, 3) or (h, w, 4), rows from the top.
///
/// # Errors
/// `ValueError` for another shape or dtype.
pub(crate) fn image_of(
    name: &str,
    value: &Bound<'_, PyAny>,
    encoding: Encoding,
) -> PyResult<Arc<Image>> {
    let expected = || argument(name, "expected uint8 of shape (h, w, 3) or (h, w, 4)");
    let array: numpy::PyReadonlyArray3<'_, u8> = value.extract().map_err(|_| expected())?;
    let array = array.as_array();
    let (height, width, channels) = array.dim();
    if !(3..=4).contains(&channels) || height == 0 || width == 0 {
        return Err(expected());
    }
    let side = |side: usize| u32::try_from(side).map_err(|_| expected());
    let (width, height) = (side(width)?, side(height)?);
    let texel = |row: usize, column: usize| -> [u8; 4] {
        std::array::from_fn(|channel| match channel < channels {
            true => array[[row, column, channel]],
            false => 255,
        })
    };
    let rows = 0..height as usize;
    let texels = rows.flat_map(|row| (0..width as usize).map(move |column| (row, column)));
    let texels = texels.map(|(row, column)| texel(row, column)).collect();
    Ok(Arc::new(Image::new("texture", encoding, width, height, texels)))
}
