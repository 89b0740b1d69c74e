//! Meshes whose places change from picture to picture, for `luxel.pyrender`.

use crate::arrays::array;
use crate::camera::PyCamera;
use crate::errors::{argument, error};
use crate::scene::PyScene;
use crate::settings::{Settings, execution, size_of};
use luxel::render::{Layer, LayerValues, Picture, Renderer};
use luxel::scene::{DMat4, MeshId, NodeId, Object, Scene, Size};
use numpy::PyReadonlyArray3;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The largest side of points, in pixels.
const MOST_POINT_SIZE: f32 = 1e4;

/// The meshes of a scene, some of them in some places.
#[pyclass(name = "Stage", module = "luxel._luxel", frozen)]
pub(crate) struct PyStage {
    scene: Arc<Scene>,
    renderer: Mutex<Renderer>,
}

impl PyStage {
    fn renderer(&self) -> MutexGuard<'_, Renderer> {
        self.renderer.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A picture, if it is asked for, and depths.
type Drawn<'py> = (Option<Bound<'py, PyAny>>, Bound<'py, PyAny>);

#[pymethods]
impl PyStage {
    #[new]
    fn new(py: Python<'_>, scene: &PyScene, threads: usize) -> PyResult<Self> {
        let execution = execution(threads, None)?;
        let scene = Arc::clone(&scene.shared.scene);
        let renderer = py.detach(|| Renderer::new(Arc::clone(&scene), &execution));
        Ok(Self { scene, renderer: Mutex::new(renderer.map_err(error)?) })
    }

    /// Shows meshes, by their places in the scene, at poses (n, 4, 4), and nothing else.
    fn place(
        &self,
        py: Python<'_>,
        meshes: Vec<u32>,
        poses: PyReadonlyArray3<'_, f64>,
    ) -> PyResult<()> {
        let poses = poses.as_array();
        if poses.dim() != (meshes.len(), 4, 4) {
            return Err(argument("poses", format!("expected shape ({}, 4, 4)", meshes.len())));
        }
        let count = self.scene.meshes.len();
        let mut objects = Vec::with_capacity(meshes.len());
        for (row, (&mesh, pose)) in meshes.iter().zip(poses.outer_iter()).enumerate() {
            if mesh as usize >= count {
                return Err(argument("meshes", format!("row {row} names mesh {mesh} of {count}")));
            }
            let pose: [[f64; 4]; 4] =
                std::array::from_fn(|column| std::array::from_fn(|row| pose[[row, column]]));
            let world_from_mesh = DMat4::from_cols_array_2d(&pose);
            if !world_from_mesh.is_finite() {
                return Err(argument(
                    "poses",
                    format!("row {row} has a number that is not finite"),
                ));
            }
            objects.push(Object {
                node: NodeId(0),
                mesh: MeshId(mesh),
                section: 0,
                world_from_mesh: world_from_mesh.into(),
            });
        }
        py.detach(|| self.renderer().show_objects(objects));
        Ok(())
    }

    /// Draws what is shown: a picture (h, w, `channels`), none for 0, and depths (h, w), 0 where nothing is. With a
    /// `palette`, a colour for each place of what is shown, the picture is one of objects, black where nothing is.
    #[pyo3(signature = (size, camera, channels, palette=None, point_size=1.0, **settings))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments")]
    fn draw<'py>(
        &self,
        py: Python<'py>,
        size: &Bound<'py, PyAny>,
        camera: &PyCamera,
        channels: usize,
        palette: Option<Vec<[u8; 3]>>,
        point_size: f32,
        settings: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Drawn<'py>> {
        let size = size_of(size)?;
        let settings = Settings::of(settings)?;
        if !(point_size > 0.0 && point_size <= MOST_POINT_SIZE) {
            return Err(argument("point_size", format!("expected 0 to {MOST_POINT_SIZE} pixels")));
        }
        if !matches!(channels, 0 | 3 | 4) {
            return Err(argument("channels", "use 0, 3 or 4"));
        }
        let view = settings.view(&self.scene, camera.placed(&self.scene, size)?, size)?;
        let (view, palette) = (view.with_point_size(point_size), palette.as_deref());
        let drawn = py.detach(|| {
            let renderer = self.renderer();
            let mut layers = vec![Layer::Z];
            layers.extend(palette.is_some().then_some(Layer::Object));
            let mut picture = Picture::default();
            let mut values = Vec::new();
            if palette.is_some() || channels == 0 {
                values = renderer.layers(&view, &layers)?;
            } else {
                renderer.rgba8_with_layers(&view, &layers, &mut picture, &mut values)?;
            }
            let (mut colors, mut depths) = (Vec::new(), Vec::new());
            for values in values {
                match values {
                    LayerValues::F32(mut values) => {
                        // Nothing is infinitely far away.
                        for z in &mut values {
                            *z = if *z < f32::INFINITY { *z } else { 0.0 };
                        }
                        depths = values;
                    }
                    LayerValues::U32(objects) => {
                        let palette = palette.unwrap_or_default();
                        let color =
                            |&at: &u32| palette.get(at as usize).copied().unwrap_or_default();
                        let opaque = |[r, g, b]: [u8; 3]| [r, g, b, 255];
                        let pixels = objects.iter().map(|at| opaque(color(at)));
                        colors = of_channels(&pixels.collect::<Vec<_>>(), channels);
                    }
                }
            }
            if channels > 0 && palette.is_none() {
                colors = match channels {
                    4 => picture.pixels.into_flattened(),
                    _ => of_channels(&picture.pixels, channels),
                };
            }
            Ok::<_, luxel::render::RenderError>((colors, depths))
        });
        let (colors, depths) = drawn.map_err(error)?;
        let Size { width, height } = size;
        let [height, width] = [height as usize, width as usize];
        let colors = (channels > 0).then(|| array(py, colors, &[height, width, channels]));
        Ok((colors.transpose()?, array(py, depths, &[height, width])?))
    }
}

/// The first channels of pixels.
fn of_channels(pixels: &[[u8; 4]], channels: usize) -> Vec<u8> {
    if channels == 3 {
        let mut colors = vec![0; 3 * pixels.len()];
        for (color, pixel) in colors.as_chunks_mut::<3>().0.iter_mut().zip(pixels) {
            color.copy_from_slice(&pixel[..3]);
        }
        return colors;
    }
    pixels.as_flattened().to_vec()
}
