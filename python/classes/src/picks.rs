//! The answers of picks.

use crate::arrays::array;
use luxel::pick::{Element, PickHit};
use luxel::scene::Scene;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A surface at a point of the picture.
#[pyclass(name = "Hit", module = "luxel", frozen, get_all)]
pub(crate) struct PyHit {
    /// The object, by its place in `Scene.objects`.
    object: usize,
    /// Its name.
    name: String,
    /// `triangle`, `point` or `line`.
    element: &'static str,
    /// Its number in the object.
    index: u32,
    /// The material's name.
    material: String,
    /// The weights of the triangle's corners.
    barycentric: [f32; 3],
    /// The place in world space.
    position: [f64; 3],
    /// The unit shading normal, on the side of the eye.
    normal: [f32; 3],
    /// The unit normal of the triangle's plane, on the side of the eye.
    geometric_normal: [f32; 3],
    /// Texture coordinates, if there are any.
    uv: Option<[f32; 2]>,
    /// The interpolated linear vertex colour with alpha, if there is any.
    color: Option<[f32; 4]>,
    /// The distance from the eye.
    distance: f64,
    /// The distance along the viewing axis.
    z: f32,
    /// Window depth, 0 near to 1 far.
    depth: f64,
}

impl PyHit {
    pub(crate) fn new(scene: &Scene, hit: PickHit) -> Self {
        let (element, index) = element_of(hit.element);
        let object = &scene.objects()[hit.object];
        Self {
            object: hit.object,
            name: scene.nodes[object.node.index()].name.to_string(),
            element,
            index,
            material: scene.materials[hit.material.index()].name.to_string(),
            barycentric: hit.barycentric,
            position: hit.position.to_array(),
            normal: hit.normal,
            geometric_normal: hit.geometric_normal,
            uv: hit.uv,
            color: hit.color,
            distance: hit.distance,
            z: hit.z,
            depth: hit.depth,
        }
    }
}

#[pymethods]
impl PyHit {
    /// The triangle's number in the object; `None` for points and lines.
    #[getter]
    fn triangle(&self) -> Option<u32> {
        (self.element == "triangle").then_some(self.index)
    }

    fn __repr__(&self) -> String {
        let Self { name, element, index, position, .. } = self;
        format!("<luxel.Hit: {element} {index} of {name:?} at {position:?}>")
    }
}

fn element_of(element: Element) -> (&'static str, u32) {
    match element {
        Element::Triangle(index) => ("triangle", index),
        Element::Point(index) => ("point", index),
        Element::Line(index) => ("line", index),
    }
}

/// Many hits as arrays: -1 and not-a-number where nothing is.
pub(crate) fn hits_of<'py>(
    py: Python<'py>,
    hits: &[Option<PickHit>],
) -> PyResult<Bound<'py, PyAny>> {
    let count = hits.len();
    let whole = |value: &dyn Fn(&PickHit) -> i64| -> Vec<i64> {
        hits.iter().map(|hit| hit.as_ref().map_or(-1, value)).collect()
    };
    let real = |value: &dyn Fn(&PickHit) -> f64| -> Vec<f64> {
        hits.iter().map(|hit| hit.as_ref().map_or(f64::NAN, value)).collect()
    };
    let triangle = |hit: &PickHit| match hit.element {
        Element::Triangle(index) => i64::from(index),
        Element::Point(_) | Element::Line(_) => -1,
    };
    let triples = |value: &dyn Fn(&PickHit) -> [f64; 3]| -> Vec<f64> {
        hits.iter().flat_map(|hit| hit.as_ref().map_or([f64::NAN; 3], value)).collect()
    };
    let arrays = PyDict::new(py);
    arrays.set_item("object", array(py, whole(&|hit| hit.object as i64), &[count])?)?;
    arrays.set_item("triangle", array(py, whole(&triangle), &[count])?)?;
    let weights = triples(&|hit| hit.barycentric.map(f64::from));
    arrays.set_item("barycentric", array(py, weights, &[count, 3])?)?;
    let positions = triples(&|hit| hit.position.to_array());
    arrays.set_item("position", array(py, positions, &[count, 3])?)?;
    let normals = triples(&|hit| hit.normal.map(f64::from));
    arrays.set_item("normal", array(py, normals, &[count, 3])?)?;
    arrays.set_item("distance", array(py, real(&|hit| hit.distance), &[count])?)?;
    arrays.set_item("z", array(py, real(&|hit| f64::from(hit.z)), &[count])?)?;
    arrays.set_item("depth", array(py, real(&|hit| hit.depth), &[count])?)?;
    Ok(arrays.into_any())
}
