//! Rays through a scene, many at a time.

use crate::arrays::{array, rows};
use crate::errors::argument;
use crate::scene::SharedScene;
use luxel::rays::{WorldHit, WorldRay};
use luxel::render::Renderer;
use luxel::scene::DVec3;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What rays hit.
enum Found {
    /// The closest hit of each ray.
    Closest(Vec<Option<WorldHit>>),
    /// Whether each hits anything.
    Any(Vec<bool>),
    /// All hits, each with its ray, nearest first.
    All(Vec<(usize, WorldHit)>),
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
            "closest" => Found::Closest(picker.closest_of_each(&rays)),
            "any" => Found::Any(rays.iter().map(|ray| picker.any(ray)).collect()),
            _ => {
                let of = |(number, ray)| picker.all(ray).into_iter().map(move |hit| (number, hit));
                Found::All(rays.iter().enumerate().flat_map(of).collect())
            }
        }))
    })?;
    match found {
        Found::Any(any) => {
            let count = any.len();
            array(py, any, &[count])
        }
        Found::Closest(hits) => arrays(py, &hits, None),
        Found::All(hits) => {
            let numbers = hits.iter().map(|(number, _)| *number as i64).collect();
            let hits: Vec<_> = hits.into_iter().map(|(_, hit)| Some(hit)).collect();
            arrays(py, &hits, Some(numbers))
        }
    }
}

/// Hits as arrays: -1 and not-a-number where nothing is, t infinite.
fn arrays<'py>(
    py: Python<'py>,
    hits: &[Option<WorldHit>],
    rays: Option<Vec<i64>>,
) -> PyResult<Bound<'py, PyAny>> {
    let count = hits.len();
    let whole = |value: &dyn Fn(&WorldHit) -> i64| -> Vec<i64> {
        hits.iter().map(|hit| hit.as_ref().map_or(-1, value)).collect()
    };
    let triples = |value: &dyn Fn(&WorldHit) -> [f64; 3]| -> Vec<f64> {
        hits.iter().flat_map(|hit| hit.as_ref().map_or([f64::NAN; 3], value)).collect()
    };
    let dict = PyDict::new(py);
    if let Some(rays) = rays {
        dict.set_item("ray", array(py, rays, &[count])?)?;
    }
    let t: Vec<f64> =
        hits.iter().map(|hit| hit.as_ref().map_or(f64::INFINITY, |hit| hit.t)).collect();
    dict.set_item("t", array(py, t, &[count])?)?;
    dict.set_item("object", array(py, whole(&|hit| hit.object as i64), &[count])?)?;
    dict.set_item("triangle", array(py, whole(&|hit| i64::from(hit.triangle)), &[count])?)?;
    dict.set_item("barycentric", array(py, triples(&|hit| hit.barycentric), &[count, 3])?)?;
    let positions = triples(&|hit| hit.position.to_array());
    dict.set_item("position", array(py, positions, &[count, 3])?)?;
    Ok(dict.into_any())
}
