//! Frames: a picture and its layers as arrays.

use crate::arrays::array;
use crate::errors::error;
use luxel::lighting::PictureEncoding;
use luxel::render::{Layer, LayerValues, Picture};
use luxel::scene::Size;
use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};

/// A drawn view: `rgba` (h, w, 4) uint8, and each layer by its name, as an attribute or in brackets.
#[pyclass(name = "Frame", module = "luxel", frozen)]
pub(crate) struct PyFrame {
    size: Size,
    encoding: PictureEncoding,
    arrays: Py<PyDict>,
}

impl PyFrame {
    /// A picture with its layers, which are handed over without a copy.
    pub(crate) fn new(
        py: Python<'_>,
        picture: Picture<[u8; 4]>,
        layers: impl Iterator<Item = (Layer, LayerValues)>,
    ) -> PyResult<Self> {
        let (size, encoding) = (picture.size, picture.encoding);
        let [height, width] = [size.height as usize, size.width as usize];
        let arrays = PyDict::new(py);
        arrays
            .set_item("rgba", array(py, picture.pixels.into_flattened(), &[height, width, 4])?)?;
        for (layer, values) in layers {
            let channels = layer.channels();
            let shape = [height, width, channels];
            let shape = if channels == 1 { &shape[..2] } else { &shape[..] };
            let values = match values {
                LayerValues::F32(values) => array(py, values, shape)?,
                LayerValues::U32(values) => array(py, values, shape)?,
            };
            arrays.set_item(layer.name(), values)?;
        }
        Ok(Self { size, encoding, arrays: arrays.unbind() })
    }

    /// The bytes of the picture as PNG.
    pub(crate) fn png(&self, py: Python<'_>) -> PyResult<Vec<u8>> {
        let rgba = self.arrays.bind(py).as_any().get_item("rgba")?;
        let bytes: Vec<u8> = rgba.call_method0("tobytes")?.extract()?;
        let (pixels, _) = bytes.as_chunks::<4>();
        let picture = Picture {
            size: self.size,
            pixels: pixels.to_vec(),
            encoding: self.encoding,
            ..Picture::default()
        };
        let mut png = Vec::new();
        py.detach(|| luxel::write_png(&picture, &mut png)).map_err(error)?;
        Ok(png)
    }
}

#[pymethods]
impl PyFrame {
    /// The names of what it holds.
    #[getter]
    fn names(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.arrays.bind(py).keys().extract()
    }

    fn __getattr__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        self.arrays.bind(py).get_item(name)?.ok_or_else(|| {
            let held = self.names(py).unwrap_or_default().join(", ");
            PyAttributeError::new_err(format!("the frame has no layer `{name}`, but {held}"))
        })
    }

    fn __getitem__<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let found = self.arrays.bind(py).get_item(name)?;
        found.ok_or_else(|| PyKeyError::new_err(name.to_owned()))
    }

    /// The picture as the bytes of a PNG file, those of `luxel render`.
    fn to_png<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &self.png(py)?))
    }

    /// What a notebook displays.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        self.to_png(py)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let Size { width, height } = self.size;
        Ok(format!("<luxel.Frame: {width}x{height}, {}>", self.names(py)?.join(", ")))
    }
}
