//! The keyword arguments of views: the flags of the command line, by their names and with their values.

use crate::arrays::numbers;
use crate::errors::{argument, error};
use luxel::formats::{Limits, open_environment, values};
use luxel::math::SimdLevel;
use luxel::render::{Execution, View};
use luxel::scene::{Camera, Scene, Size};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::Arc;

/// The names of all settings.
const NAMES: [&str; 28] = [
    "samples",
    "cull",
    "lights",
    "ambient",
    "light_scale",
    "environment",
    "environment_rotation",
    "environment_background",
    "fog",
    "background",
    "ground",
    "exposure",
    "tone",
    "encoding",
    "shading",
    "tolerance",
    "interpolation",
    "clamp",
    "normal_length",
    "shadows",
    "light_rays",
    "ao",
    "ao_rays",
    "wireframe",
    "edges",
    "threads",
    "simd",
    "max_memory",
];

/// What says how the work is done, not what is seen.
const NOT_OF_VIEWS: [&str; 3] = ["threads", "simd", "max_memory"];

/// Keyword arguments, of which no name is unknown.
#[derive(Default)]
pub(crate) struct Settings<'py>(Option<Bound<'py, PyDict>>);

/// (width, height).
///
/// # Errors
/// `ValueError` or `TypeError` for anything but two whole numbers.
pub(crate) fn size_of(value: &Bound<'_, PyAny>) -> PyResult<Size> {
    let (width, height): (u32, u32) = value
        .extract()
        .map_err(|_| argument("size", "expected (width, height), whole numbers from 1"))?;
    Ok(Size { width, height })
}

/// Threads, 0 for one a core, and an instruction set by name.
///
/// # Errors
/// `ValueError` for an unknown name or too many threads.
pub(crate) fn execution(threads: usize, simd: Option<&str>) -> PyResult<Execution> {
    /// As on the command line: more than any machine has, and few enough not to exhaust one.
    const MOST_THREADS: usize = 1024;
    if threads > MOST_THREADS {
        return Err(argument("threads", format!("at most {MOST_THREADS}, not {threads}")));
    }
    let simd: SimdLevel = match simd {
        Some(name) => name.parse().map_err(|error| argument("simd", error))?,
        None => SimdLevel::Auto,
    };
    Ok(Execution { threads, simd, ..Execution::default() })
}

impl<'py> Settings<'py> {
    /// Keyword arguments.
    ///
    /// # Errors
    /// `TypeError` for an unknown name.
    pub(crate) fn of(settings: Option<&Bound<'py, PyDict>>) -> PyResult<Self> {
        for name in settings.iter().flat_map(|settings| settings.keys()) {
            let name: String = name.extract()?;
            if !NAMES.contains(&name.as_str()) {
                let near = values::nearest(&name, NAMES);
                let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
                let unknown = format!("there is no setting `{name}`{near}");
                return Err(PyTypeError::new_err(unknown));
            }
        }
        Ok(Self(settings.cloned()))
    }

    /// A setting that is given and not `None`.
    fn get(&self, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        debug_assert!(NAMES.contains(&name), "{name}");
        let Some(settings) = &self.0 else { return Ok(None) };
        Ok(settings.get_item(name)?.filter(|value| !value.is_none()))
    }

    fn extract<T>(&self, name: &str, expected: &str) -> PyResult<Option<T>>
    where
        T: for<'a> FromPyObject<'a, 'py>,
    {
        let Some(value) = self.get(name)? else { return Ok(None) };
        value.extract().map(Some).map_err(|_| argument(name, format!("expected {expected}")))
    }

    /// How the work is done.
    ///
    /// # Errors
    /// `ValueError` for a value that isn't possible.
    pub(crate) fn execution(&self) -> PyResult<Execution> {
        let simd: Option<String> = self.extract("simd", "a name")?;
        let threads = self.extract("threads", "a whole number from 0")?.unwrap_or(0);
        execution(threads, simd.as_deref())
    }

    /// The view of a scene from a camera. What is left out is as on the command line.
    ///
    /// # Errors
    /// `ValueError` for a value that isn't possible, with its name.
    pub(crate) fn view(&self, scene: &Scene, camera: Camera, size: Size) -> PyResult<View> {
        let mut settings = luxel::Settings::default();
        for name in NAMES {
            if let Some(value) = self.get(name)?.filter(|_| !NOT_OF_VIEWS.contains(&name)) {
                set(&mut settings, name, &value)?;
            }
        }
        if let Some(path) = settings.environment_file().map_err(setting)? {
            let mut limits = Limits::default();
            if let Some(most) = self.extract("max_memory", "a number of bytes")? {
                limits.max_memory = most;
            }
            let opened = open_environment(&path, &limits).map_err(error)?;
            settings.set_environment_map(Arc::new(opened.map));
        }
        settings.view_from(scene, camera, size).map_err(setting)
    }
}

/// Sets one by the name and the text of its flag.
fn set(settings: &mut luxel::Settings, name: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    if name == "lights" {
        let expected = "expected a list of texts as --light takes: \"directional:dir=-1,-2,-1\"";
        let lights: Vec<String> = value.extract().map_err(|_| argument(name, expected))?;
        settings.replace_lights();
        return lights
            .into_iter()
            .try_for_each(|light| settings.set("light", light))
            .map_err(setting);
    }
    settings.set(&name.replace('_', "-"), text(name, value)?).map_err(setting)
}

/// A value as it stands on the command line: a text as it is, a switch, a number, numbers with commas between.
fn text(name: &str, value: &Bound<'_, PyAny>) -> PyResult<String> {
    if let Ok(text) = value.extract::<String>() {
        return Ok(text);
    }
    if let Ok(is_on) = value.extract::<bool>() {
        return Ok(is_on.to_string());
    }
    if let Ok(number) = value.extract::<f64>() {
        return Ok(number.to_string());
    }
    let numbers = numbers(value).ok_or_else(|| {
        argument(name, "expected a text as the command line takes, a number, True, False or a sequence of numbers")
    })?;
    Ok(numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(","))
}

/// A setting that isn't possible, by its name in Python.
fn setting(error: luxel::SettingError) -> PyErr {
    let name = match error.name.as_str() {
        "light" => "lights".to_owned(),
        name => name.replace('-', "_"),
    };
    argument(&name, error.reason)
}
