//! The keyword arguments of views: the flags of the command line, by their names and with their values.

use crate::arrays::vector;
use crate::errors::{argument, error};
use luxel::formats::{Limits, open_environment, values};
use luxel::lighting::{Environment, PictureEncoding, Tone};
use luxel::math::SimdLevel;
use luxel::render::{
    Clamp, Cull, Edges, EnvironmentChoice, Execution, Interpolation, NormalLength, Shading,
    ShadingMode, View, auto_exposure,
};
use luxel::scene::{Background, Camera, Scene, SceneLight, Size, Viewpoint};
use luxel::view::{AmbientOcclusion, DEFAULT_LIGHT_RAYS, DEFAULT_SAMPLES};
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

    fn switch(&self, name: &str) -> PyResult<bool> {
        Ok(self.extract(name, "True or False")?.unwrap_or(false))
    }

    /// One of several values by name.
    fn choice<T: Copy>(
        &self,
        name: &str,
        all: &[T],
        name_of: impl Fn(T) -> &'static str,
    ) -> PyResult<Option<T>> {
        let Some(text) = self.extract::<String>(name, "a name")? else { return Ok(None) };
        let found = all.iter().copied().find(|one| name_of(*one) == text);
        found.map(Some).ok_or_else(|| {
            let names: Vec<_> = all.iter().map(|one| name_of(*one)).collect();
            argument(name, format!("`{text}` is none of {}", names.join(", ")))
        })
    }

    /// The text of a value that the command line takes: a string as it is, numbers with commas.
    fn text(&self, name: &str) -> PyResult<Option<String>> {
        let Some(value) = self.get(name)? else { return Ok(None) };
        if let Ok(text) = value.extract::<String>() {
            return Ok(Some(text));
        }
        let numbers = [
            vector::<3>(name, &value).map(|v| v.to_vec()),
            vector::<4>(name, &value).map(|v| v.to_vec()),
        ];
        let Some(numbers) = numbers.into_iter().find_map(Result::ok) else {
            return Err(argument(
                name,
                "expected a text as the command line takes, or 3 or 4 numbers",
            ));
        };
        Ok(Some(numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",")))
    }

    fn parsed<T>(
        &self,
        name: &str,
        parse: impl Fn(&str) -> Result<T, String>,
    ) -> PyResult<Option<T>> {
        let parse = |text: String| parse(&text).map_err(|message| argument(name, message));
        self.text(name)?.map(parse).transpose()
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
        let (mut lights, mut ambient) = self.lights(scene)?;
        if let Some(scale) = self.extract::<f32>("light_scale", "a number from 0")? {
            if !(scale >= 0.0 && scale.is_finite()) {
                return Err(argument("light_scale", "expected a number from 0"));
            }
            lights.iter_mut().for_each(|light| light.light.scale(scale));
            ambient = ambient.map(|channel| channel * scale);
        }
        let fog = self.parsed("fog", values::fog)?;
        let background: Option<Background> = self.parsed("background", values::background)?;
        let encoding = match self.extract::<String>("encoding", "a name")?.as_deref() {
            None | Some("srgb") => PictureEncoding::Srgb,
            Some("none") => PictureEncoding::None,
            Some(other) => {
                return Err(argument("encoding", format!("`{other}` is none of srgb, none")));
            }
        };
        let cull = |cull| match cull {
            Cull::Auto => "auto",
            Cull::None => "none",
            Cull::Back => "back",
        };
        let cull = self.choice("cull", &[Cull::Auto, Cull::None, Cull::Back], cull)?;
        let mut view = View::new(size, camera)
            .with_samples(self.extract("samples", "1, 2, 4, 8 or 16")?.unwrap_or(DEFAULT_SAMPLES))
            .with_cull(cull.unwrap_or_default())
            .with_lights(lights)
            .with_ambient(ambient)
            .with_environment(self.environment(scene)?)
            .with_environment_background(self.switch("environment_background")?)
            .with_fog(fog.or(scene.fog))
            .with_background(background.or(scene.background).unwrap_or_default())
            .with_tone(self.choice("tone", &Tone::ALL, Tone::name)?.unwrap_or_default())
            .with_encoding(encoding)
            .with_shadows(self.switch("shadows")?)
            .with_ground(self.switch("ground")?)
            .with_light_rays(self.rays("light_rays", DEFAULT_LIGHT_RAYS)?)
            .with_ambient_occlusion(self.ambient_occlusion()?)
            .with_edges(self.edges()?)
            .with_shading(self.shading()?);
        self.expose(&mut view, scene)?;
        Ok(view)
    }

    fn edges(&self) -> PyResult<Option<Edges>> {
        match (self.switch("wireframe")?, self.switch("edges")?) {
            (false, false) => Ok(None),
            (true, false) => Ok(Some(Edges::WIREFRAME)),
            (false, true) => Ok(Some(Edges::OVER_FACES)),
            (true, true) => Err(argument("edges", "it excludes `wireframe`")),
        }
    }

    fn rays(&self, name: &str, default: u32) -> PyResult<u32> {
        let rays = self.extract(name, "a whole number")?.unwrap_or(default);
        match (1..=4096).contains(&rays) {
            true => Ok(rays),
            false => Err(argument(name, "expected 1 to 4096")),
        }
    }

    fn expose(&self, view: &mut View, scene: &Scene) -> PyResult<()> {
        let expected = || argument("exposure", "expected stops, or \"auto\"");
        let Some(value) = self.get("exposure")? else { return Ok(()) };
        if let Ok(ev) = value.extract::<f32>() {
            if !ev.is_finite() {
                return Err(expected());
            }
            view.exposure = ev;
        } else if value.extract::<String>().is_ok_and(|text| text == "auto") {
            view.exposure = auto_exposure(scene, view).ev;
        } else {
            return Err(expected());
        }
        Ok(())
    }

    /// `ao=True` or a radius.
    fn ambient_occlusion(&self) -> PyResult<Option<AmbientOcclusion>> {
        let rays = self.rays("ao_rays", AmbientOcclusion::RAYS)?;
        let Some(value) = self.get("ao")? else { return Ok(None) };
        if let Ok(is_on) = value.extract::<bool>() {
            return Ok(is_on.then_some(AmbientOcclusion { radius: None, rays }));
        }
        match value.extract::<f64>() {
            Ok(radius) if radius > 0.0 => Ok(Some(AmbientOcclusion { radius: Some(radius), rays })),
            _ => Err(argument("ao", "expected True, False or a radius above 0, possibly infinite")),
        }
    }

    fn shading(&self) -> PyResult<Shading> {
        let mut mode =
            self.choice("shading", &ShadingMode::ALL, ShadingMode::name)?.unwrap_or_default();
        if let Some(given) = self.extract::<f32>("tolerance", "a number above 0")? {
            let ShadingMode::Subdivided { tolerance } = &mut mode else {
                return Err(argument("tolerance", "it is for shading=\"subdivided\""));
            };
            if !(given > 0.0 && given.is_finite()) {
                return Err(argument("tolerance", "expected a number above 0"));
            }
            *tolerance = given;
        }
        Ok(Shading {
            mode,
            interpolation: self
                .choice("interpolation", &Interpolation::ALL, Interpolation::name)?
                .unwrap_or_default(),
            clamp: self.choice("clamp", &Clamp::ALL, Clamp::name)?.unwrap_or_default(),
            normal_length: self
                .choice("normal_length", &NormalLength::ALL, NormalLength::name)?
                .unwrap_or_default(),
        })
    }

    /// The lights and the scene's ambient light: given ones, else the file's, else the default ones.
    fn lights(&self, scene: &Scene) -> PyResult<(Vec<SceneLight>, [f32; 3])> {
        let ambient = self.parsed("ambient", values::color)?.or(scene.ambient);
        let Some(given) = self.get("lights")? else {
            let (lights, default_ambient) = luxel::lights_of(scene);
            return Ok((lights, ambient.unwrap_or(default_ambient)));
        };
        let expected = "expected a list of texts as --light takes: \"directional:dir=-1,-2,-1\"";
        let given: Vec<String> = given.extract().map_err(|_| argument("lights", expected))?;
        let mut lights: Vec<SceneLight> = Vec::new();
        for (place, text) in given.iter().enumerate() {
            let light = values::light(text)
                .map_err(|message| argument("lights", format!("`{text}`: {message}")))?
                .named(place);
            if lights.iter().any(|other| other.name == light.name) {
                return Err(argument(
                    "lights",
                    format!("two lights have the name `{}`", light.name),
                ));
            }
            lights.push(light);
        }
        Ok((lights, ambient.unwrap_or_default()))
    }

    /// The environment: a given one, else the file's, else the default one.
    fn environment(&self, scene: &Scene) -> PyResult<EnvironmentChoice> {
        let choice = match self.parsed("environment", values::surroundings)? {
            None => luxel::environment_of(scene),
            Some(surroundings) => match surroundings.environment(scene.up) {
                Ok(choice) => choice,
                Err(path) => {
                    let mut limits = Limits::default();
                    if let Some(most) = self.extract("max_memory", "a number of bytes")? {
                        limits.max_memory = most;
                    }
                    let opened = open_environment(path, &limits).map_err(error)?;
                    EnvironmentChoice::of_map(Arc::new(opened.map), Viewpoint::frame(scene.up), 0.0)
                }
            },
        };
        let rotation: Option<f64> = self.extract("environment_rotation", "degrees")?;
        Ok(match (choice.map(), rotation) {
            (Some(map), Some(degrees)) => {
                EnvironmentChoice::Always(Environment::Map(map.turned(degrees)))
            }
            _ => choice,
        })
    }
}
