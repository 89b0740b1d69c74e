//! Rays through a scene, many at a time.

use crate::arrays::{array, rows};
use crate::errors::argument;
use crate::scene::SharedScene;
use luxel::rays::{WorldHit, WorldRay};
use luxel::render::Renderer;
use luxel::scene::DVec3;
use luxel_parallel::gather;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Rays per task that ask for all hits.
const RUN: usize = 256;

/// What rays hit.
enum Found {
    /// Whether each hits anything.
    Any(Vec<bool>),
    /// The closest hit of each ray.
    Closest(HitArrays),
    /// All hits, nearest first, each with its ray.
    All(Vec<i64>, HitArrays),
}

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
    let found = py.detach(|| {
        let picker = shared.picker()?;
        let rays: Vec<WorldRay> = origins
            .iter()
            .zip(&directions)
            .map(|(origin, way)| WorldRay::new(DVec3::from_array(*origin), DVec3::from_array(*way)))
            .collect();
        Ok::<_, PyErr>(renderer.install(|| match mode {
            "any" => Found::Any(picker.any_of_each(&rays)),
            "closest" => Found::Closest(HitArrays::of(&picker.closest_of_each(&rays))),
            _ => {
                let all = gather(rays.len(), RUN, &|run, all| {
                    for number in run {
                        let hits = picker.all(&rays[number]);
                        all.extend(hits.into_iter().map(|hit| (number as i64, Some(hit))));
                    }
                });
                let (numbers, hits): (_, Vec<_>) = all.into_iter().unzip();
                Found::All(numbers, HitArrays::of(&hits))
            }
        }))
    })?;
    match found {
        Found::Any(any) => {
            let count = any.len();
            array(py, any, &[count])
        }
        Found::Closest(hits) => Ok(hits.into_dict(py)?.into_any()),
        Found::All(numbers, hits) => {
            let count = numbers.len();
            let dict = hits.into_dict(py)?;
            dict.set_item("ray", array(py, numbers, &[count])?)?;
            Ok(dict.into_any())
        }
    }
}

/// Hits by their properties: -1 and not-a-number where nothing is, t infinite.
struct HitArrays {
    t: Vec<f64>,
    object: Vec<i64>,
    triangle: Vec<i64>,
    barycentric: Vec<[f64; 3]>,
    position: Vec<[f64; 3]>,
}

impl HitArrays {
    fn of(hits: &[Option<WorldHit>]) -> Self {
        let count = hits.len();
        let mut arrays = Self {
            t: vec![f64::INFINITY; count],
            object: vec![-1; count],
            triangle: vec![-1; count],
            barycentric: vec![[f64::NAN; 3]; count],
            position: vec![[f64::NAN; 3]; count],
        };
        for (row, hit) in hits.iter().enumerate() {
            if let Some(hit) = hit {
                arrays.t[row] = hit.t;
                arrays.object[row] = hit.object as i64;
                arrays.triangle[row] = i64::from(hit.triangle);
                arrays.barycentric[row] = hit.barycentric;
                arrays.position[row] = hit.position.to_array();
            }
        }
        arrays
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
