//! Scenes, with what makes them ready to be drawn and picked.

use crate::arrays::{array, index_rows, rows};
use crate::bare_mesh::{BareMesh, bare_meshes, without_computed_normals};
use crate::errors::{argument, error};
use crate::frame::PyFrame;
use crate::settings::{Settings, execution, size_of};
use crate::view::PyView;
use luxel::pick::Picker;
use luxel::render::{Execution, Renderer};
use luxel::scene::{
    Encoding, Image, MaterialId, Mesh, MeshId, Node, NormalOptions, Part, Sampler, Scene,
    SceneMaterial, Size, Texture, TextureId, TextureUse,
};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyList};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// A scene: meshes, materials, lights and cameras, ready to be drawn. It never changes.
#[pyclass(name = "Scene", module = "luxel", frozen)]
pub(crate) struct PyScene {
    pub(crate) shared: Arc<SharedScene>,
}

/// What all views of a scene share.
pub(crate) struct SharedScene {
    pub(crate) scene: Arc<Scene>,
    warnings: Vec<String>,
    /// One for each number of threads and instruction set that a view has asked for.
    renderers: Mutex<Vec<(Workers, Arc<Renderer>)>>,
    picker: OnceLock<Arc<Picker>>,
    /// The meshes whose normals were computed.
    bare: Vec<BareMesh>,
}

/// What a pickle holds: a function and its arguments.
type Recipe<'py> = (Bound<'py, PyAny>, (Bound<'py, PyBytes>, Vec<String>));

/// Threads, and the name of an instruction set.
type Workers = (usize, String);

impl SharedScene {
    /// The scene as the file had it, for checks.
    pub(crate) fn bare_scene(&self) -> Scene {
        without_computed_normals(&self.scene, &self.bare)
    }

    /// The renderer for a view's execution.
    ///
    /// # Errors
    /// `luxel.Error` if the machine lacks the instruction set.
    pub(crate) fn renderer(&self, execution: &Execution) -> PyResult<Arc<Renderer>> {
        let key = (execution.threads, format!("{:?}", execution.simd));
        let mut known = self.renderers.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, renderer)) = known.iter().find(|(other, _)| *other == key) {
            return Ok(Arc::clone(renderer));
        }
        let renderer = Arc::new(Renderer::new(Arc::clone(&self.scene), execution).map_err(error)?);
        // Each has threads of its own, and what it knows of meshes.
        const MOST: usize = 4;
        if known.len() == MOST {
            known.remove(0);
        }
        known.push((key, Arc::clone(&renderer)));
        Ok(renderer)
    }

    /// The trees for picks and rays.
    ///
    /// # Errors
    /// `luxel.Error` if a mesh has too many triangles.
    pub(crate) fn picker(&self) -> PyResult<Arc<Picker>> {
        if let Some(picker) = self.picker.get() {
            return Ok(Arc::clone(picker));
        }
        let picker = Arc::new(Picker::new(Arc::clone(&self.scene)).map_err(error)?);
        Ok(Arc::clone(self.picker.get_or_init(|| picker)))
    }
}

impl PyScene {
    /// A scene as a reader gives it, with the normals and tangents that it lacks.
    pub(crate) fn ready(mut scene: Scene, warnings: Vec<String>) -> Self {
        let bare = bare_meshes(&scene);
        scene.compute_normals(&NormalOptions::default());
        scene.compute_tangents();
        Self::of_parts(scene, warnings, bare)
    }

    /// A scene with normals and tangents.
    pub(crate) fn whole(scene: Scene, warnings: Vec<String>) -> Self {
        Self::of_parts(scene, warnings, Vec::new())
    }

    fn of_parts(scene: Scene, warnings: Vec<String>, bare: Vec<BareMesh>) -> Self {
        let shared = SharedScene {
            bare,
            scene: Arc::new(scene),
            warnings,
            renderers: Mutex::default(),
            picker: OnceLock::new(),
        };
        Self { shared: Arc::new(shared) }
    }
}

#[pymethods]
impl PyScene {
    /// A scene of one mesh. `vertices` (n, 3), `faces` (m, 3); of the vertices, `normals` (n, 3), `colors` (n, 3) or
    /// (n, 4), sRGB bytes or linear floats, and `uv` (n, 2), (0, 0) at the texture's lower left; `texture` (h, w,
    /// 3) or (h, w, 4), sRGB bytes, rows from the top.
    #[staticmethod]
    #[pyo3(signature = (vertices, faces, *, normals=None, colors=None, uv=None, texture=None, up=None))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments")]
    fn from_arrays(
        py: Python<'_>,
        vertices: &Bound<'_, PyAny>,
        faces: &Bound<'_, PyAny>,
        normals: Option<&Bound<'_, PyAny>>,
        colors: Option<&Bound<'_, PyAny>>,
        uv: Option<&Bound<'_, PyAny>>,
        texture: Option<&Bound<'_, PyAny>>,
        up: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let positions = rows::<3>("vertices", vertices)?;
        let count = positions.len();
        if let Some(row) =
            positions.iter().position(|row| row.iter().any(|&x| !(x as f32).is_finite()))
        {
            return Err(argument(
                "vertices",
                format!("row {row} is too far away for 32-bit floats"),
            ));
        }
        let mut mesh = Mesh { triangles: index_rows("faces", faces, count)?, ..Mesh::default() };
        mesh.set_positions(&positions);
        let as_many = |name: &str, found: usize| match found == count {
            true => Ok(()),
            false => Err(argument(name, format!("{found} rows for {count} vertices"))),
        };
        if let Some(normals) = normals {
            let normals = rows::<3>("normals", normals)?;
            as_many("normals", normals.len())?;
            mesh.normals = normals.iter().map(|normal| unit(*normal)).collect();
        }
        if let Some(colors) = colors {
            mesh.colors = colors_of(colors)?;
            as_many("colors", mesh.colors.len())?;
        }
        if let Some(uv) = uv {
            let uv = rows::<2>("uv", uv)?;
            as_many("uv", uv.len())?;
            mesh.uvs[0] = uv.iter().map(|&[u, v]| [u as f32, 1.0 - v as f32]).collect();
        }
        let part = Part { first: 0, count: mesh.triangles.len() as u32, material: MaterialId(0) };
        mesh.parts = vec![part];
        let mut material = SceneMaterial::default();
        let mut textures = Vec::new();
        if let Some(texture) = texture {
            if uv.is_none() {
                return Err(argument("texture", "it needs `uv`"));
            }
            textures.push(texture_of(texture)?);
            material.constants.diffuse = [1.0; 3];
            material.base_color = Some(Box::new(TextureUse::new(TextureId(0))));
        } else if !mesh.colors.is_empty() {
            material.constants.diffuse = [1.0; 3];
        }
        let mut scene = Scene { materials: vec![material], textures, ..Scene::default() };
        if let Some(up) = up {
            let up = luxel::scene::DVec3::from_array(crate::arrays::vector("up", up)?);
            scene.up = up.try_normalize().ok_or_else(|| argument("up", "it has no direction"))?;
        }
        scene.meshes.push(mesh);
        scene.nodes.push(Node::root("mesh", Some(MeshId(0))));
        Ok(py.detach(|| Self::ready(scene, Vec::new())))
    }

    /// The names of the objects, by which layers and hits number them.
    #[getter]
    fn objects(&self) -> Vec<String> {
        let scene = &self.shared.scene;
        let objects = scene.objects();
        objects.iter().map(|object| scene.nodes[object.node.index()].name.clone()).collect()
    }

    /// The names of the cameras of the file.
    #[getter]
    fn cameras(&self) -> Vec<String> {
        self.shared.scene.cameras.iter().map(|camera| camera.name.clone()).collect()
    }

    /// What the reader left out or replaced.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.shared.warnings.clone()
    }

    /// The world-space box, [[least x, y, z], [greatest x, y, z]]: float64, shape (2, 3).
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let bounds = self.shared.scene.bounds();
        let numbers = [bounds.min.to_array(), bounds.max.to_array()].concat();
        array(py, numbers, &[2, 3])
    }

    /// How many triangles all objects have together.
    #[getter]
    fn triangle_count(&self) -> u64 {
        let scene = &self.shared.scene;
        let count = |object| scene.mesh_of(object).triangles.len() as u64;
        scene.objects().iter().map(count).sum()
    }

    /// A view of the scene, from which it is drawn, picked and explained.
    #[pyo3(signature = (size, camera=None, **settings))]
    fn view(
        &self,
        py: Python<'_>,
        size: &Bound<'_, PyAny>,
        camera: Option<&Bound<'_, PyAny>>,
        settings: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<PyView> {
        let settings = Settings::of(settings)?;
        PyView::new(py, Arc::clone(&self.shared), size_of(size)?, camera, &settings)
    }

    /// Draws the scene: `view(...)` and its `render(layers)` in one call.
    #[pyo3(signature = (size, camera=None, layers=None, **settings))]
    fn render(
        &self,
        py: Python<'_>,
        size: &Bound<'_, PyAny>,
        camera: Option<&Bound<'_, PyAny>>,
        layers: Option<Vec<String>>,
        settings: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<PyFrame> {
        self.view(py, size, camera, settings)?.render(py, layers)
    }

    /// The mesh defects that spoil shading, as `luxel check --json` lists them: winding, gaps, normals and more. The
    /// view decides on silhouettes and highlights.
    #[pyo3(signature = (size=None, camera=None, **settings))]
    fn check<'py>(
        &self,
        py: Python<'py>,
        size: Option<&Bound<'py, PyAny>>,
        camera: Option<&Bound<'py, PyAny>>,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyList>> {
        let settings = Settings::of(settings)?;
        let size = size.map_or(Ok(Size { width: 1280, height: 720 }), size_of)?;
        let view = PyView::new(py, Arc::clone(&self.shared), size, camera, &settings)?;
        crate::check::findings(py, &self.shared, view.view(), &settings)
    }

    /// A view that turns under the hand and explains its pixels, for notebooks: needs `luxel[notebook]`.
    #[pyo3(signature = (size=None, camera=None, **settings))]
    fn show<'py>(
        &self,
        py: Python<'py>,
        size: Option<&Bound<'py, PyAny>>,
        camera: Option<&Bound<'py, PyAny>>,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let settings = Settings::of(settings)?;
        let size = size.map_or(Ok(Size { width: 640, height: 480 }), size_of)?;
        let view = PyView::new(py, Arc::clone(&self.shared), size, camera, &settings)?;
        py.import("luxel._show")?.call_method1("widget", (view,))
    }

    /// Draws the scene from several cameras: a list of frames. `progress`: True shows a bar; a function is
    /// called with the number of frames done.
    #[pyo3(signature = (cameras, size, layers=None, *, progress=None, **settings))]
    fn render_views<'py>(
        &self,
        py: Python<'py>,
        cameras: &Bound<'py, PyAny>,
        size: &Bound<'py, PyAny>,
        layers: Option<Vec<String>>,
        progress: Option<&Bound<'py, PyAny>>,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyList>> {
        let settings = Settings::of(settings)?;
        let size = size_of(size)?;
        let cameras: Vec<Bound<'_, PyAny>> = cameras.try_iter()?.collect::<PyResult<_>>()?;
        let progress = match progress.map(|progress| (progress, progress.extract::<bool>())) {
            None | Some((_, Ok(false))) => None,
            Some((_, Ok(true))) => {
                Some(py.import("luxel._progress")?.call_method1("bar", (cameras.len(),))?)
            }
            Some((function, Err(_))) if function.is_callable() => Some(function.clone()),
            Some(_) => return Err(argument("progress", "expected True, False or a function")),
        };
        let frames = PyList::empty(py);
        for camera in &cameras {
            let shared = Arc::clone(&self.shared);
            let view = PyView::new(py, shared, size, Some(camera), &settings)?;
            frames.append(view.render(py, layers.clone())?)?;
            if let Some(progress) = &progress {
                progress.call1((frames.len(),))?;
            }
        }
        Ok(frames)
    }

    /// Rays through the scene: `mode` is `closest`, `any` or `all`. See the stubs for what each gives.
    #[pyo3(signature = (origins, directions, mode="closest", *, threads=0))]
    fn rays<'py>(
        &self,
        py: Python<'py>,
        origins: &Bound<'py, PyAny>,
        directions: &Bound<'py, PyAny>,
        mode: &str,
        threads: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let renderer = self.shared.renderer(&execution(threads, None)?)?;
        crate::rays::rays(py, &self.shared, &renderer, (origins, directions), mode)
    }

    /// What a notebook displays: the default view as PNG.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyBytes>>> {
        if self.shared.scene.is_empty() {
            return Ok(None);
        }
        let size = Size { width: 640, height: 360 };
        let view = PyView::new(py, Arc::clone(&self.shared), size, None, &Settings::default())?;
        let png = view.render(py, None)?.png(py)?;
        Ok(Some(PyBytes::new(py, &png)))
    }

    /// Pickles: the scene as bytes for the same version of luxel, to the bit.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Recipe<'py>> {
        let bytes = py.detach(|| luxel::pack(&self.shared.scene));
        let unpack = py.import("luxel._luxel")?.getattr("unpack")?;
        Ok((unpack, (PyBytes::new(py, &bytes), self.warnings())))
    }

    fn __repr__(&self) -> String {
        let objects = self.shared.scene.objects().len();
        format!("<luxel.Scene: {objects} objects, {} triangles>", self.triangle_count())
    }
}

/// A normal of unit length; +Z where it has none.
fn unit([x, y, z]: [f64; 3]) -> [f32; 3] {
    let normal = luxel::scene::DVec3::new(x, y, z).normalize_or(luxel::scene::DVec3::Z);
    normal.as_vec3().to_array()
}

/// Colours of vertices: bytes are sRGB, floats linear.
fn colors_of(value: &Bound<'_, PyAny>) -> PyResult<Vec<[f32; 4]>> {
    let value = &value.py().import("numpy")?.call_method1("asarray", (value,))?;
    let kind: String = value.getattr("dtype")?.getattr("kind")?.extract()?;
    let width = value.getattr("shape")?.extract::<Vec<usize>>()?.get(1).copied();
    let rows: Vec<[f64; 4]> = match width {
        Some(4) => rows::<4>("colors", value)?,
        _ => rows::<3>("colors", value)?.iter().map(|&[r, g, b]| [r, g, b, full(&kind)]).collect(),
    };
    let linear = |row: &[f64; 4]| -> PyResult<[f32; 4]> {
        let [r, g, b, alpha] = row.map(|channel| channel / full(&kind));
        let channels = [r, g, b, alpha];
        if channels.iter().any(|channel| !(0.0..=1.0).contains(channel)) {
            return Err(argument("colors", "expected bytes, or floats between 0 and 1"));
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

/// A texture of bytes.
fn texture_of(value: &Bound<'_, PyAny>) -> PyResult<Texture> {
    let expected = || argument("texture", "expected uint8 of shape (h, w, 3) or (h, w, 4)");
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
    let image = Image::new("texture", Encoding::Srgb, width, height, texels);
    Ok(Texture { image: Arc::new(image), sampler: Sampler::default() })
}
