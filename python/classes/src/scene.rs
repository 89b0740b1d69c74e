//! Scenes, with what makes them ready to be drawn and picked.

use crate::arrays::array;
use crate::bare_mesh::{BareMesh, bare_meshes, without_computed_normals};
use crate::errors::{argument, error};
use crate::frame::PyFrame;
use crate::meshes::{Elements, MeshArrays, image_of};
use crate::settings::{Settings, execution, size_of};
use crate::view::PyView;
use luxel::pick::Picker;
use luxel::render::{Execution, Renderer};
use luxel::scene::{
    DVec3, Encoding, MaterialId, MeshId, Node, NormalOptions, Sampler, Scene, SceneMaterial, Size,
    Texture, TextureId, TextureUse,
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
        let arrays = MeshArrays {
            place: "",
            elements: Elements::Triangles,
            vertices,
            faces: Some(faces),
            normals,
            colors,
            face_colors: None,
            uv,
        };
        let mesh = arrays.mesh(MaterialId(0))?;
        let mut material = SceneMaterial::default();
        let mut textures = Vec::new();
        if let Some(texture) = texture {
            if uv.is_none() {
                return Err(argument("texture", "it needs `uv`"));
            }
            let image = image_of("texture", texture, Encoding::Srgb)?;
            textures.push(Texture { image, sampler: Sampler::default() });
            material.constants.diffuse = [1.0; 3];
            material.base_color = Some(Box::new(TextureUse::new(TextureId(0))));
        } else if !mesh.colors.is_empty() {
            material.constants.diffuse = [1.0; 3];
        }
        let mut scene = Scene { materials: vec![material], textures, ..Scene::default() };
        scene.up = up_of(up)?;
        scene.meshes.push(mesh);
        scene.nodes.push(Node::root("mesh", Some(MeshId(0))));
        Ok(py.detach(|| Self::ready(scene, Vec::new())))
    }

    /// A scene of a trimesh.Trimesh, PointCloud or Scene. `smooth`: True takes its vertex normals, False makes
    /// faces flat; None smooths edges up to 40 degrees.
    #[staticmethod]
    #[pyo3(signature = (source, *, smooth=None, up=None))]
    pub(crate) fn from_trimesh<'py>(
        source: &Bound<'py, PyAny>,
        smooth: Option<bool>,
        up: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        source.py().import("luxel._trimesh")?.call_method1("scene", (source, smooth, up))
    }

    /// The names of the objects, by which layers and hits number them.
    #[getter]
    fn objects(&self) -> Vec<String> {
        let scene = &self.shared.scene;
        let objects = scene.objects();
        objects.iter().map(|object| scene.nodes[object.node.index()].name.to_string()).collect()
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
        let view =
            |camera| PyView::new(py, Arc::clone(&self.shared), size, Some(camera), &settings);
        let views: Vec<PyView> = cameras.iter().map(view).collect::<PyResult<_>>()?;
        let mut done = 0;
        let frames = PyView::render_each(py, &views, layers, &mut || {
            done += 1;
            progress.as_ref().map_or(Ok(()), |progress| progress.call1((done,)).map(drop))
        })?;
        PyList::new(py, frames)
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

/// The direction that is up: +Y unless it is given.
///
/// # Errors
/// `ValueError` for one without length.
pub(crate) fn up_of(up: Option<&Bound<'_, PyAny>>) -> PyResult<DVec3> {
    let Some(up) = up else { return Ok(DVec3::Y) };
    let up = DVec3::from_array(crate::arrays::vector("up", up)?);
    up.try_normalize().ok_or_else(|| argument("up", "it has no direction"))
}
