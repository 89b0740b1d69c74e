//! Triangles in clip coordinates, rasterized into ids and barycentrics.

use crate::arrays::{array, index_rows, rows};
use crate::errors::{argument, error};
use crate::settings::{execution, size_of};
use luxel::scene::Size;
use luxel_parallel::{install, pool};
use luxel_visibility::rasterize;
use pyo3::prelude::*;

/// The longest side of a window, as on the command line.
const MAX_SIDE: u32 = 16384;

/// What each pixel's centre sees: float32, shape (h, w, 4), of barycentrics u and v, z/w, and the triangle's number plus
/// 1; rows from the bottom.
#[pyfunction]
pub(crate) fn rasterize_clip<'py>(
    py: Python<'py>,
    vertices: &Bound<'py, PyAny>,
    faces: &Bound<'py, PyAny>,
    size: &Bound<'py, PyAny>,
    threads: usize,
) -> PyResult<Bound<'py, PyAny>> {
    let vertices = rows::<4>("vertices_clip", vertices)?;
    let faces = index_rows::<3>("faces", faces, vertices.len())?;
    let size @ Size { width, height } = size_of(size)?;
    if ![width, height].iter().all(|side| (1..=MAX_SIDE).contains(side)) {
        return Err(argument("size", format!("expected sides of 1 to {MAX_SIDE}")));
    }
    let vertices: Vec<[f32; 4]> = vertices.iter().map(|row| row.map(|x| x as f32)).collect();
    if let Some(row) = vertices.iter().position(|row| row.iter().any(|x| !x.is_finite())) {
        let far = format!("row {row} is too far away for 32-bit floats");
        return Err(argument("vertices_clip", far));
    }
    let level = execution(threads, None)?.simd.resolve().map_err(error)?;
    let numbers = py.detach(|| {
        // Without a number, the threads that are there already.
        let pool = (threads > 0).then(|| pool(threads)).flatten();
        let draw = || rasterize(&vertices, &faces, size, level);
        let fragments = install(pool.as_ref(), draw).map_err(error)?;
        let mut numbers: Vec<f32> = Vec::with_capacity(fragments.len() * 4);
        for row in fragments.rchunks(width as usize) {
            for fragment in row {
                numbers.extend(fragment.map_or([0.0; 4], |fragment| {
                    let [u, v, _] = fragment.barycentric;
                    // Exact up to 2^24 triangles, as the format has it.
                    [u, v, fragment.depth, (fragment.triangle + 1) as f32]
                }));
            }
        }
        Ok::<_, PyErr>(numbers)
    })?;
    array(py, numbers, &[height as usize, width as usize, 4])
}
