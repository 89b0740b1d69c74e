//! Views: a model seen by a camera, drawn.

use crate::drawer::show_all_but;
use crate::error::exception;
use crate::model::{Environments, Model};
use crate::motion::FIRST_MODE;
use luxel::lighting::{EnvironmentMap, PictureEncoding};
use luxel::navigation::{Log, Settings as Motion, State};
use luxel::pick::Picker;
use luxel::render::{Execution, Renderer, View};
use luxel::scene::{Bounds, Scene};
use luxel::{CameraChoice, Settings};
use std::rc::Rc;
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Bytes that trees for rays may take: a module has at most 4 GB in all.
const MOST_MEMORY: u64 = 1 << 30;

/// A model seen by a camera that settings choose, and pointers and keys move.
#[wasm_bindgen]
pub struct ModelView {
    /// As it was read, without the changes of settings.
    pub(crate) model: Arc<Scene>,
    environments: Environments,
    /// What settings say; none for a view that was packed.
    pub(crate) settings: Settings,
    /// Materials and normals are those of these settings.
    surfaces: Settings,
    pub(crate) renderer: Renderer,
    pub(crate) picker: Option<Picker>,
    /// The objects that are hidden.
    pub(crate) hidden: Vec<u32>,
    pub(crate) bounds: Bounds,
    /// The view that `home` goes back to.
    pub(crate) start: View,
    pub(crate) choice: CameraChoice,
    pub(crate) view: View,
    pub(crate) motion: Motion,
    pub(crate) state: State,
    /// Whether a hand has moved the camera.
    pub(crate) is_moved: bool,
    pub(crate) log: Log,
}

#[wasm_bindgen]
impl ModelView {
    /// The view of a scene, both packed by the same version of luxel.
    ///
    /// # Errors
    /// An exception for other bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(scene: &[u8], view: &[u8]) -> Result<Self, JsError> {
        let scene = Arc::new(luxel::unpack(scene).map_err(exception)?);
        let view = luxel::unpack_view(view).map_err(exception)?;
        let model = (&scene, &Environments::default());
        Self::start_with(model, Arc::clone(&scene), Settings::default(), view)
    }

    /// The view of a model that settings describe: a JSON list of pairs, the name of a flag of `luxel render` and
    /// its text.
    ///
    /// # Errors
    /// An exception for settings that aren't possible.
    pub fn of(model: &Model, settings: &str) -> Result<Self, JsError> {
        let settings = read_settings(settings, model.environments())?;
        let scene = surfaced(model.scene(), &settings)?;
        let view = settings.view(&scene).map_err(exception)?;
        Self::start_with((model.scene(), model.environments()), scene, settings, view)
    }

    /// Replaces all settings. A camera that was moved by hand stays where it is, unless the settings choose
    /// another one than before.
    ///
    /// True if surfaces or the map of the environment are others then, which drawers need anew.
    ///
    /// # Errors
    /// An exception for settings that aren't possible; the view is then as before.
    pub fn set(&mut self, settings: &str) -> Result<bool, JsError> {
        let settings = read_settings(settings, &self.environments)?;
        let changes_surfaces = differ(&settings, &self.surfaces)?;
        let scene = match changes_surfaces {
            true => surfaced(&self.model, &settings)?,
            false => Arc::clone(self.renderer.scene()),
        };
        let view = settings.view(&scene).map_err(exception)?;
        let choice = settings.camera().map_err(exception)?;
        if changes_surfaces {
            self.renderer = Renderer::new(scene, &execution()).map_err(exception)?;
            self.surfaces = settings.clone();
            self.picker = None;
            show_all_but(&mut self.renderer, &self.hidden);
        }
        let changes_map = map_of(&view) != map_of(&self.view);
        let keeps_camera = self.is_moved && choice == self.choice;
        let camera = self.view.camera;
        self.start = view.clone();
        self.settings = settings;
        self.choice = choice;
        self.view = view;
        if keeps_camera {
            self.view.camera = camera;
            self.motion.size = self.view.size;
        } else {
            self.rest();
        }
        Ok(changes_surfaces || changes_map)
    }

    /// Hides objects, by their places in the model's list, and shows all others.
    pub fn hide(&mut self, objects: Vec<u32>) {
        self.hidden = objects;
        show_all_but(&mut self.renderer, &self.hidden);
    }

    /// The picture's width in pixels.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.view.size.width
    }

    /// The picture's height in pixels.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.view.size.height
    }

    /// The picture, four bytes a pixel, rows from the top. `samples` a pixel; 0 for the view's own.
    ///
    /// # Errors
    /// An exception for other numbers of samples than 0, 1, 2, 4, 8 and 16, and for a picture that is too large.
    pub fn draw(&self, samples: u32) -> Result<Vec<u8>, JsError> {
        let picture =
            self.renderer.rgba8(&sampled(self.view.clone(), samples)).map_err(exception)?;
        Ok(picture.pixels.into_flattened())
    }

    /// Whether the picture's bytes are encoded as sRGB; else they are linear.
    #[wasm_bindgen(getter)]
    pub fn is_srgb(&self) -> bool {
        self.view.encoding == PictureEncoding::Srgb
    }

    /// Whether the view casts rays for shadows or occlusion, which takes its time.
    #[wasm_bindgen(getter)]
    pub fn has_rays(&self) -> bool {
        self.view.shadows || self.view.ground || self.view.ambient_occlusion.is_some()
    }

    /// The picture with one sample, without shadows and occlusion: quick, for a moving hand.
    ///
    /// # Errors
    /// An exception for a picture that is too large.
    pub fn draft(&self) -> Result<Vec<u8>, JsError> {
        let picture = self.renderer.rgba8(&draft(self.view.clone())).map_err(exception)?;
        Ok(picture.pixels.into_flattened())
    }
}

impl ModelView {
    /// The view of a scene, whose surfaces have the settings' changes already.
    fn start_with(
        (model, environments): (&Arc<Scene>, &Environments),
        scene: Arc<Scene>,
        settings: Settings,
        view: View,
    ) -> Result<Self, JsError> {
        let renderer = Renderer::new(Arc::clone(&scene), &execution()).map_err(exception)?;
        let choice = settings.camera().map_err(exception)?;
        let bounds = scene.bounds();
        let up = choice.up.unwrap_or(scene.up);
        let motion = Motion::new(bounds, up, view.camera.projection.lens, view.size);
        let state = State::new(FIRST_MODE, &view.camera.view_from_world, choice.pivot(&scene));
        let mut view = Self {
            model: Arc::clone(model),
            environments: Rc::clone(environments),
            surfaces: settings.clone(),
            settings,
            renderer,
            picker: None,
            hidden: Vec::new(),
            bounds,
            start: view.clone(),
            choice,
            view,
            motion,
            state,
            is_moved: false,
            log: Log::default(),
        };
        view.rest();
        Ok(view)
    }
}

/// A view with another number of samples than its own, if that isn't 0.
pub(crate) fn sampled(mut view: View, samples: u32) -> View {
    if samples != 0 {
        view.samples = samples;
    }
    view
}

/// A view with one sample and without rays.
pub(crate) fn draft(mut view: View) -> View {
    view.samples = 1;
    view.shadows = false;
    view.ground = false;
    view.ambient_occlusion = None;
    view
}

/// How pictures are drawn.
pub(crate) fn execution() -> Execution {
    Execution { max_memory: MOST_MEMORY, ..Execution::default() }
}

/// Settings of a JSON list of pairs, with the map that they name.
fn read_settings(text: &str, environments: &Environments) -> Result<Settings, JsError> {
    let pairs: Vec<(String, String)> = serde_json::from_str(text).map_err(exception)?;
    let mut settings = Settings::new(pairs).map_err(exception)?;
    if let Some(file) = settings.environment_file().map_err(exception)? {
        let name = file.to_string_lossy();
        let map = environments.borrow().get(&*name).cloned();
        let add =
            || exception(format!("`environment`: {name} is a file: add it to the scene first"));
        settings.set_environment_map(map.ok_or_else(add)?);
    }
    Ok(settings)
}

/// The map of a view's environment, known by its place in memory.
fn map_of(view: &View) -> Option<*const EnvironmentMap> {
    view.environment.map().map(|map| Arc::as_ptr(map.map()))
}

/// A scene with the settings' materials and normals.
fn surfaced(model: &Arc<Scene>, settings: &Settings) -> Result<Arc<Scene>, JsError> {
    let mut scene = Arc::clone(model);
    settings.apply_to(Arc::make_mut(&mut scene)).map_err(exception)?;
    Ok(scene)
}

/// Whether settings make other surfaces.
fn differ(one: &Settings, other: &Settings) -> Result<bool, JsError> {
    let of = |settings: &Settings| {
        Ok::<_, JsError>((
            settings.restyle().map_err(exception)?,
            settings.normals().map_err(exception)?,
        ))
    };
    Ok(of(one)? != of(other)?)
}
