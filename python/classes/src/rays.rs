//! Rays through a scene, many at a time.

use crate::arrays::{array, rows};
use crate::errors::argument;
use crate::interruptible::{interruptible_on, interruptible_pieces};
use crate::scene::SharedScene;
use luxel::rays::{WorldHit, WorldRay};
use luxel::render::Renderer;
use luxel_parallel::gather;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::atomic::Ordering;

/// Rays per task for all hits.
const RUN: usize = 256;

/// Rays per task for closest and any hits: the hits stay in cache until they are copied to the arrays.
const PIECE: usize = 1024;

/// Follows rays from origins along directions, both of shape (n, 3).
///
/// # Errors
/// `ValueError` for other shapes, numbers that are not finite, or an unknown mode.
pub(crate) fn rays<'py>(
    py: Python<'py>,
    shared: &SharedScene,
    renderer: &Renderer,
    (origins, directions): (&Bound<'py, PyAny>, &Bound<'py, PyAny>),
    mode: &str,
) -> PyResult<Bound<'py, PyAny>> {
    if !["closest", "any", "all"].contains(&mode) {
        return Err(argument("mode", format!("`{mode}` is none of closest, any, all")));
    }
    let (origins, directions) =
        (rows::<3>("origins", origins)?, rows::<3>("directions", directions)?);
    if origins.len() != directions.len() {
        let found = format!("{} rows for {} origins", directions.len(), origins.len());
        return Err(argument("directions", found));
    }
    if let Some(row) = directions.iter().position(|direction| *direction == [0.0; 3]) {
        return Err(argument("directions", format!("row {row} has no length")));
    }
    let picker = py.detach(|| shared.picker())?;
    let rays = |at: usize, count: usize| -> Vec<WorldRay> {
        let rays = origins[at..at + count].iter().zip(&directions[at..]);
        rays.map(|(&origin, &way)| WorldRay::new(origin.into(), way.into())).collect()
    };
    let count = origins.len();
    match mode {
        "any" => {
            let mut any = vec![false; count];
            let pieces = any.chunks_mut(PIECE).enumerate();
            interruptible_pieces(py, renderer, pieces, &|(piece, any): (usize, &mut [bool])| {
                any.copy_from_slice(&picker.any_of_each(&rays(piece * PIECE, any.len())));
            })?;
            array(py, any, &[count])
        }
        "closest" => {
            let mut arrays = HitArrays::misses(count);
            let pieces = arrays.pieces().enumerate();
            interruptible_pieces(py, renderer, pieces, &|(piece, mut rows): (_, HitRows<'_>)| {
                rows.put(&picker.closest_of_each(&rays(piece * PIECE, rows.t.len())));
            })?;
            Ok(arrays.into_dict(py)?.into_any())
        }
        _ => {
            let (numbers, arrays) = interruptible_on(py, renderer, |stop| {
                let all = gather(count, RUN, &|run, all| {
                    if stop.load(Ordering::Relaxed) {
                        return;
                    }
                    for (number, ray) in run.clone().zip(rays(run.start, run.len())) {
                        let hits = picker.all(&ray);
                        all.extend(hits.into_iter().map(|hit| (number as i64, Some(hit))));
                    }
                });
                let (numbers, hits): (Vec<_>, Vec<_>) = all.into_iter().unzip();
                let mut arrays = HitArrays::misses(hits.len());
                for (mut rows, hits) in arrays.pieces().zip(hits.chunks(PIECE)) {
                    rows.put(hits);
                }
                (numbers, arrays)
            })?;
            let count = numbers.len();
            let dict = arrays.into_dict(py)?;
            dict.set_item("ray", array(py, numbers, &[count])?)?;
            Ok(dict.into_any())
        }
    }
}

/// Hits as one array per property: -1, NaN and an infinite t for a miss.
struct HitArrays {
    t: Vec<f64>,
    object: Vec<i64>,
    triangle: Vec<i64>,
    barycentric: Vec<[f64; 3]>,
    position: Vec<[f64; 3]>,
}

/// Some rows of [`HitArrays`].
struct HitRows<'a> {
    t: &'a mut [f64],
    object: &'a mut [i64],
    triangle: &'a mut [i64],
    barycentric: &'a mut [[f64; 3]],
    position: &'a mut [[f64; 3]],
}

impl HitRows<'_> {
    /// Writes the hits; rows of misses keep their values.
    fn put(&mut self, hits: &[Option<WorldHit>]) {
        for (row, hit) in hits.iter().enumerate() {
            if let Some(hit) = hit {
                self.t[row] = hit.t;
                self.object[row] = hit.object as i64;
                self.triangle[row] = i64::from(hit.triangle);
                self.barycentric[row] = hit.barycentric;
                self.position[row] = hit.position.to_array();
            }
        }
    }
}

impl HitArrays {
    /// Arrays of misses.
    fn misses(count: usize) -> Self {
        Self {
            t: vec![f64::INFINITY; count],
            object: vec![-1; count],
            triangle: vec![-1; count],
            barycentric: vec![[f64::NAN; 3]; count],
            position: vec![[f64::NAN; 3]; count],
        }
    }

    /// Rows of [`PIECE`] rays each.
    fn pieces(&mut self) -> impl ExactSizeIterator<Item = HitRows<'_>> + Send {
        let numbers = self.object.chunks_mut(PIECE).zip(self.triangle.chunks_mut(PIECE));
        let places = self.barycentric.chunks_mut(PIECE).zip(self.position.chunks_mut(PIECE));
        let rows = self.t.chunks_mut(PIECE).zip(numbers.zip(places));
        rows.map(|(t, ((object, triangle), (barycentric, position)))| HitRows {
            t,
            object,
            triangle,
            barycentric,
            position,
        })
    }

    fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let count = self.t.len();
        let dict = PyDict::new(py);
        dict.set_item("t", array(py, self.t, &[count])?)?;
        dict.set_item("object", array(py, self.object, &[count])?)?;
        dict.set_item("triangle", array(py, self.triangle, &[count])?)?;
        dict.set_item("barycentric", array(py, self.barycentric.into_flattened(), &[count, 3])?)?;
        dict.set_item("position", array(py, self.position.into_flattened(), &[count, 3])?)?;
        Ok(dict)
    }
}
