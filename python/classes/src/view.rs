//! Views: a scene seen by a camera, drawn, picked and explained.

use crate::arrays::rows;
use crate::camera::camera_of;
use crate::errors::{argument, error};
use crate::frame::PyFrame;
use crate::interruptible::{interruptible_each, interruptible_on};
use crate::ledger::PyLedger;
use crate::picks::{PyHit, hits_of};
use crate::scene::SharedScene;
use crate::settings::Settings;
use luxel::pick::{Inclusion, PickView, Picker, Region};
use luxel::render::MAX_SIDE;
use luxel::render::{At, Layer, LayerValues, Picture, RenderError, Renderer, Unseen, View};
use luxel::report::RegionReport;
use luxel::scene::Size;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A picture and its layers.
type Drawn = Result<(Picture<[u8; 4]>, Vec<LayerValues>), RenderError>;

/// A scene seen by a camera, with lights, shading and size.
#[pyclass(name = "View", module = "luxel", frozen)]
pub(crate) struct PyView {
    shared: Arc<SharedScene>,
    renderer: Arc<Renderer>,
    view: Arc<View>,
}

impl PyView {
    /// The view that settings describe.
    ///
    /// # Errors
    /// `ValueError` or `TypeError` for a setting that isn't possible, `luxel.Error` for what the machine can't do.
    pub(crate) fn new(
        py: Python<'_>,
        shared: Arc<SharedScene>,
        size: Size,
        camera: Option<&Bound<'_, PyAny>>,
        settings: &Settings<'_>,
    ) -> PyResult<Self> {
        if [size.width, size.height].iter().any(|side| !(1..=MAX_SIDE).contains(side)) {
            return Err(argument("size", format!("each side has 1 to {MAX_SIDE} pixels")));
        }
        let execution = settings.execution()?;
        let camera = camera_of(camera, &shared.scene, size)?;
        let view = settings.view(&shared.scene, camera, size)?;
        let renderer = py.detach(|| shared.renderer(&execution))?;
        Ok(Self { shared, renderer, view: Arc::new(view) })
    }

    /// The view itself.
    pub(crate) fn view(&self) -> &View {
        &self.view
    }

    /// Draws views of one scene in parallel on the renderer's threads, which suits small pictures. `progress` is called
    /// after each.
    ///
    /// # Errors
    /// What [`PyView::render`] or `progress` raises.
    pub(crate) fn render_each(
        py: Python<'_>,
        views: &[Self],
        layers: Option<Vec<String>>,
        progress: &mut dyn FnMut() -> PyResult<()>,
    ) -> PyResult<Vec<PyFrame>> {
        let layers = layers_of(layers)?;
        let Some(first) = views.first() else { return Ok(Vec::new()) };
        let draw = |number: usize, stop: &AtomicBool| views[number].draw(&layers, stop);
        let drawn = interruptible_each(py, &first.renderer, views.len(), &draw, progress)?;
        drawn.into_iter().map(|drawn| frame(py, &layers, drawn)).collect()
    }

    /// Draws the picture and layers; stops early once `stop` is set.
    fn draw(&self, layers: &[Layer], stop: &AtomicBool) -> Drawn {
        let (mut picture, mut values) = (Picture::default(), Vec::new());
        let Self { renderer, view, .. } = self;
        renderer
            .rgba8_with_layers_until(stop, view, layers, &mut picture, &mut values)
            .map(|()| (picture, values))
    }

    /// Picks in the view.
    fn picking<T: Send>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&PickView<'_>) -> T + Send,
    ) -> PyResult<T> {
        let View { camera, size, cull, .. } = &*self.view;
        py.detach(|| {
            let picker: Arc<Picker> = self.shared.picker()?;
            let view = PickView::new(&picker, *camera, *size, *cull).map_err(error)?;
            Ok(work(&view))
        })
    }
}

/// The layers with these names, without duplicates and `rgba`, which every frame has.
///
/// # Errors
/// `ValueError` for an unknown name.
fn layers_of(names: Option<Vec<String>>) -> PyResult<Vec<Layer>> {
    let mut layers: Vec<Layer> = Vec::new();
    for name in names.iter().flatten().filter(|name| *name != "rgba") {
        let layer = name.parse().map_err(|error| argument("layers", error))?;
        if !layers.contains(&layer) {
            layers.push(layer);
        }
    }
    Ok(layers)
}

/// The frame of a drawing.
///
/// # Errors
/// `luxel.Error` for a drawing that failed.
fn frame(py: Python<'_>, layers: &[Layer], drawn: Drawn) -> PyResult<PyFrame> {
    let (picture, values) = drawn.map_err(error)?;
    PyFrame::new(py, picture, layers.iter().cloned().zip(values))
}

#[pymethods]
impl PyView {
    /// (width, height), in pixels.
    #[getter]
    fn size(&self) -> (u32, u32) {
        (self.view.size.width, self.view.size.height)
    }

    /// Scene and view as bytes, for the widget of `luxel-notebook`.
    fn _packed<'py>(&self, py: Python<'py>) -> (Bound<'py, PyBytes>, Bound<'py, PyBytes>) {
        let [scene, view] =
            py.detach(|| [luxel::pack(&self.shared.scene), luxel::pack_view(&self.view)]);
        (PyBytes::new(py, &scene), PyBytes::new(py, &view))
    }

    /// The view as a widget that turns under the hand and explains its pixels: needs `luxel[notebook]`.
    fn show<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        slf.py().import("luxel._show")?.call_method1("widget", (slf,))
    }

    /// What a notebook displays: the picture.
    fn _repr_png_<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        let png = self.render(py, None)?.png(py)?;
        Ok(PyBytes::new(py, &png))
    }

    /// Draws the view: a frame with `rgba` and the layers of these names.
    #[pyo3(signature = (layers=None))]
    pub(crate) fn render(&self, py: Python<'_>, layers: Option<Vec<String>>) -> PyResult<PyFrame> {
        let layers = layers_of(layers)?;
        let drawn = interruptible_on(py, &self.renderer, |stop| self.draw(&layers, stop))?;
        frame(py, &layers, drawn)
    }

    /// What is visible at a point of the picture, in pixels from its upper left corner; whole numbers
    /// mean the pixel's centre. `None` where nothing is.
    fn pick(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Option<PyHit>> {
        let place = place_of(x, y)?;
        let position = match place {
            At::Pixel([x, y]) => [f64::from(x) + 0.5, f64::from(y) + 0.5],
            At::Point(point) => point,
        };
        let View { size: Size { width, height }, .. } = *self.view;
        let inside = |at: f64, side: u32| (0.0..f64::from(side)).contains(&at);
        if !inside(position[0], width) || !inside(position[1], height) {
            return Err(argument(
                "x, y",
                format!("outside of the picture of {width}x{height} pixels"),
            ));
        }
        let hit = self.picking(py, |view| view.at(position))?;
        Ok(hit.map(|hit| PyHit::new(&self.shared.scene, hit)))
    }

    /// All surfaces at a point of the picture, nearest first.
    fn pick_through(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Vec<PyHit>> {
        let position = match place_of(x, y)? {
            At::Pixel([x, y]) => [f64::from(x) + 0.5, f64::from(y) + 0.5],
            At::Point(point) => point,
        };
        let hits = self.picking(py, |view| view.through(position))?;
        Ok(hits.into_iter().map(|hit| PyHit::new(&self.shared.scene, hit)).collect())
    }

    /// What is visible at many points, shape (n, 2), in pixels from the upper left corner (a pixel's centre is at
    /// .5): a dict of arrays of n rows.
    fn pick_many<'py>(
        &self,
        py: Python<'py>,
        xy: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let points = rows::<2>("xy", xy)?;
        let hits = self.picking(py, |view| view.at_many(&points))?;
        hits_of(py, &hits)
    }

    /// The objects in a rectangle of the picture, by its upper left corner and size in pixels: a list of dicts as
    /// `luxel pick --rect --json` has them. `visible`: only those that are seen there, with `pixels`;
    /// `enclosed`: only those that lie inside entirely.
    #[pyo3(signature = (x, y, w, h, *, visible=false, enclosed=false))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments")]
    fn rect<'py>(
        &self,
        py: Python<'py>,
        x: f64,
        y: f64,
        w: f64,
        h: f64,
        visible: bool,
        enclosed: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let region =
            Region::rectangle(x, y, w, h).map_err(|error| argument("x, y, w, h", error))?;
        let inclusion = if enclosed { Inclusion::Enclosed } else { Inclusion::Touching };
        let report = self.picking(py, |view| {
            let mut hits = view.sliver(&region, inclusion);
            let pixels: Option<BTreeMap<usize, u64>> = visible.then(|| {
                let seen = view.visible_in(&region);
                seen.into_iter().map(|seen| (seen.object, seen.pixels)).collect()
            });
            let report = match &pixels {
                Some(pixels) => {
                    hits.retain(|hit| pixels.contains_key(&hit.object));
                    RegionReport::new(view, &hits).with_pixels(pixels).to_json()
                }
                None => RegionReport::new(view, &hits).to_json(),
            };
            report["hits"].to_string()
        })?;
        crate::ledger::from_json(py, &report)
    }

    /// Why a pixel has its colour: its ledger. Whole numbers mean the pixel with all its samples, decimals one
    /// sample at that point.
    fn explain(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<PyLedger> {
        let place = place_of(x, y)?;
        let explained = interruptible_on(py, &self.renderer, |_| {
            let explanation = self.renderer.explain(&self.view, place)?;
            let unseen = Unseen::new(&self.renderer, &self.view, &explanation)?;
            Ok::<_, RenderError>((explanation, unseen))
        })?;
        let (explanation, unseen) = explained.map_err(|error| argument("x, y", error))?;
        let scene = Arc::clone(self.renderer.scene());
        Ok(PyLedger::new(
            scene,
            Arc::clone(&self.renderer),
            Arc::clone(&self.view),
            explanation,
            unseen,
        ))
    }

    fn __repr__(&self) -> String {
        let Size { width, height } = self.view.size;
        format!("<luxel.View: {width}x{height}, {} samples>", self.view.samples)
    }
}

/// A pixel, if both numbers are whole, else a point.
fn place_of(x: &Bound<'_, PyAny>, y: &Bound<'_, PyAny>) -> PyResult<At> {
    let is_whole = |number: &Bound<'_, PyAny>| number.hasattr("__index__");
    if is_whole(x)? && is_whole(y)? {
        let side = |number: &Bound<'_, PyAny>| {
            let number = number.call_method0("__index__")?;
            number.extract::<u32>().map_err(|_| argument("x, y", "outside of the picture"))
        };
        return Ok(At::Pixel([side(x)?, side(y)?]));
    }
    let place = [x.extract::<f64>()?, y.extract::<f64>()?];
    match place.iter().all(|side| side.is_finite()) {
        true => Ok(At::Point(place)),
        false => Err(argument("x, y", "expected finite numbers")),
    }
}
