//! The session: a model with its camera, display settings, edits and selection, without a window.

mod edits;
mod fitting;
mod material_overrides;
mod measurement;
mod recorder;

use crate::display::{Comparison, DisplaySettings};
use crate::keys::{Action, Guide};
use crate::model::Model;
use crate::picture::{GuideScene, Guides};
use crate::projection::project_point;
use crate::render::{RenderJob, SceneOverrides};
use crate::selection::Selection;
use edits::Edits;
use luxel::light_editing::{LightPose, LightSpaces};
use luxel::lighting::LightKindDescription;
use luxel::navigation::{
    Change, Entry, Event, Mode, Number, Settings, State, advance, parallel_height, with_lens,
};
use luxel::pick::point_in_picture;
use luxel::render::{View, auto_exposure};
use luxel::scene::{
    Bounds, Camera, DMat4, DVec3, Lens, Object, Placement, Projection, SceneLight, Size, fit_planes,
};
use material_overrides::material_use_counts;
pub(crate) use material_overrides::{MaterialOverrides, materials_of_mesh};
pub(crate) use measurement::Measurement;
use recorder::Recorder;

/// The duration of transitions between views, in seconds.
const TRANSITION_SECONDS: f64 = 0.15;

/// A model on display.
pub(crate) struct Session {
    pub(crate) model: Model,
    pub(crate) state: State,
    pub(crate) settings: Settings,
    /// The perspective lens to return to from an orthographic one.
    perspective: Lens,
    recorder: Recorder,
    /// Lights and ambient light as loaded.
    loaded_lights: (Vec<SceneLight>, [f32; 3]),
    /// The edits in the scene file that was saved last.
    saved_edits: Option<Edits>,
    display: DisplaySettings,
    /// The comparison with other settings, if any.
    comparison: Option<Comparison>,
    /// The guides shown with the model.
    pub(crate) guides: Guides,
    material_overrides: MaterialOverrides,
    /// The number of objects that use each material.
    pub(crate) material_uses: Vec<usize>,
    /// The scene's objects, and the world transforms of its nodes.
    pub(crate) objects: Vec<Object>,
    world_from_nodes: Vec<DMat4>,
    /// Selected, hidden and hovered objects.
    pub(crate) selection: Selection,
    /// The measured distance.
    pub(crate) measurement: Measurement,
    /// Counts changes of the view other than the camera's.
    revision: u64,
}

impl Session {
    /// Shows a model from its initial view.
    pub(crate) fn new(model: Model, size: Size, mode: Mode, records: bool) -> Self {
        let lens = model.view.camera.projection.lens;
        let bounds = model.scene.bounds();
        let settings = Settings::new(bounds, model.up, lens, size)
            .with(Number::Transition, TRANSITION_SECONDS);
        let state = State::new(mode, &model.view.camera.view_from_world, model.pivot);
        let recorder =
            if records { Recorder::start(&settings, &state) } else { Recorder::default() };
        let perspective = match lens {
            Lens::Orthographic { .. } => {
                Lens::Perspective { fov_y_radians: luxel::DEFAULT_FOV_DEGREES.to_radians() }
            }
            lens => lens,
        };
        let mut display = DisplaySettings::new(model.view.clone());
        display.is_auto_exposed = model.is_auto_exposed;
        let material_uses = material_use_counts(&model.scene);
        let world_from_nodes = model.scene.world_from_nodes();
        let (objects, selection) = (model.scene.objects(), Selection::default());
        let measurement = Measurement::default();
        let loaded_lights = (model.view.lights.clone(), model.view.ambient);
        Self {
            loaded_lights,
            saved_edits: None,
            model,
            state,
            settings,
            perspective,
            recorder,
            display,
            comparison: None,
            guides: Guides::default(),
            material_overrides: MaterialOverrides::default(),
            material_uses,
            world_from_nodes,
            objects,
            selection,
            measurement,
            revision: 0,
        }
    }

    /// Takes edges, samples, shading, tone curve, layer and guides over from another session.
    pub(crate) fn copy_display_from(&mut self, other: &Self) {
        let (view, from) = (self.display.view_mut(), other.display.view());
        (view.edges, view.samples, view.shading) = (from.edges, from.samples, from.shading);
        view.tone = from.tone;
        self.display.layer.clone_from(&other.display.layer);
        self.guides = other.guides;
    }

    /// Replaces the model by a new version of its file. The camera and display settings stay; so do
    /// edited lights unless the file's lights have changed, material edits if the materials have the same
    /// names, and the selection if the objects have the same paths.
    pub(crate) fn reload(&mut self, model: Model) {
        let paths = |one: &Self| (0..one.objects.len()).map(|at| one.path(at)).collect::<Vec<_>>();
        let before = paths(self);
        let material_names = |one: &Self| {
            let materials = one.model.scene.materials.iter();
            materials.map(|material| material.name.clone()).collect::<Vec<_>>()
        };
        let materials = material_names(self);
        self.model = model;
        let loaded_lights = (self.model.view.lights.clone(), self.model.view.ambient);
        if loaded_lights != self.loaded_lights {
            let all = self.comparison.iter_mut().map(|comparison| &mut comparison.other);
            for display in all.chain([&mut self.display]) {
                display.set_lights(loaded_lights.0.clone(), loaded_lights.1);
                if display.is_auto_exposed {
                    display.view_mut().exposure = self.model.view.exposure;
                }
            }
            self.loaded_lights = loaded_lights;
        }
        if material_names(self) != materials {
            self.material_overrides = MaterialOverrides::default();
        }
        self.material_uses = material_use_counts(&self.model.scene);
        self.objects = self.model.scene.objects();
        self.world_from_nodes = self.model.scene.world_from_nodes();
        if paths(self) != before {
            self.selection = Selection::default();
        }
        let bounds = self.model.scene.bounds();
        if !bounds.is_empty() {
            self.set(Change::Bounds(bounds));
        }
        self.revision += 1;
    }

    /// The lights that are on, in world or camera coordinates, if they or the scene's ambient light differ
    /// from the loaded ones.
    pub(crate) fn changed_lights(&self) -> Option<Vec<SceneLight>> {
        let view = self.view();
        if (&view.lights, view.ambient) == (&self.loaded_lights.0, self.loaded_lights.1) {
            return None;
        }
        let mut lights = view.lights;
        for light in &mut lights {
            if let Placement::Node(_) = light.placement {
                self.light_spaces().change_placement(light, Placement::World);
            }
        }
        Some(lights)
    }

    /// Whether the environment differs from the loaded one.
    pub(crate) fn is_environment_changed(&self) -> bool {
        self.display.view().environment != self.model.view.environment
    }

    /// Whether materials are edited or objects hidden.
    pub(crate) fn has_surface_changes(&self) -> bool {
        self.material_overrides != MaterialOverrides::default()
            || !self.selection.hidden().is_empty()
    }

    /// Ends a measurement, else a comparison, if there is one.
    pub(crate) fn close_innermost(&mut self) -> bool {
        if self.measurement != Measurement::None {
            self.measurement = Measurement::None;
        } else if self.comparison.is_some() {
            self.toggle_comparison();
        } else {
            return false;
        }
        true
    }

    /// Advances navigation by a time, then handles an event.
    pub(crate) fn navigate(&mut self, event: Event, seconds: f64) {
        self.state = advance(&self.state, &self.settings, &event, seconds);
        self.recorder.record(Entry::Event { seconds, event });
    }

    /// Replays an entry of a log.
    pub(crate) fn play(&mut self, entry: &Entry) {
        match entry {
            Entry::Set(change) => self.set(*change),
            Entry::Event { seconds, event } => self.navigate(*event, *seconds),
        }
    }

    /// Sets the window's size.
    pub(crate) fn resize(&mut self, size: Size) {
        self.set(Change::Size(size));
    }

    fn set(&mut self, change: Change) {
        self.settings = change.apply(&self.settings);
        self.recorder.record(Entry::Set(change));
    }

    /// An object's bounds in world space.
    pub(crate) fn bounds(&self, object: usize) -> Bounds {
        self.objects.get(object).map_or(Bounds::EMPTY, |object| {
            self.model.scene.meshes.bounds_of(object.mesh, &object.world_from_mesh.matrix())
        })
    }

    /// The names of nodes from the root to an object.
    pub(crate) fn path(&self, object: usize) -> String {
        let object = self.objects.get(object);
        object.map(|object| self.model.scene.path(object.node).join(" / ")).unwrap_or_default()
    }

    /// Toggles between perspective and orthographic lens; the picture stays in place.
    pub(crate) fn toggle_lens(&mut self, seconds: f64) {
        // Ends a transition in progress.
        self.navigate(Event::Pivot(self.state.pivot()), seconds);
        let (view, pivot, size) =
            (self.state.view_from_world(), self.state.pivot(), self.settings.size);
        let before = self.state.lens(self.settings.lens);
        let after = match before {
            Lens::Orthographic { .. } => self.perspective,
            lens => {
                self.perspective = lens;
                Lens::Orthographic { height: parallel_height(&view, pivot, lens, size) }
            }
        };
        let place = with_lens(&view, pivot, before, after, size);
        self.set(Change::Lens(after));
        self.navigate(Event::Place(place), 0.0);
    }

    /// The present camera.
    pub(crate) fn camera(&self) -> Camera {
        let view_from_world = self.state.view_from_world();
        let lens = self.state.lens(self.settings.lens);
        let (near, far) = fit_planes(&self.settings.bounds, &view_from_world);
        let [fixed_near, fixed_far] = self.model.planes;
        let (mut near, mut far) = (fixed_near.unwrap_or(near), fixed_far.unwrap_or(far));
        // A plane that the user has fixed may lie beyond the fitted other one.
        if near >= far && fixed_far.is_none() {
            far = near + near.abs().max(1.0);
        } else if near >= far {
            near = if matches!(lens, Lens::Orthographic { .. }) { far - 1.0 } else { far * 1e-4 };
        }
        Camera { view_from_world, projection: Projection { lens, near, far } }
    }

    /// The present view.
    pub(crate) fn view(&self) -> View {
        self.display.view_from(self.camera(), self.settings.size)
    }

    /// What to render now: one picture, or two to compare.
    pub(crate) fn render_jobs(&self) -> Vec<RenderJob> {
        let (camera, size) = (self.camera(), self.settings.size);
        let job = |display: &DisplaySettings| RenderJob {
            view: display.view_from(camera, size),
            layer: display.layer.clone(),
        };
        match &self.comparison {
            None => vec![job(&self.display)],
            Some(comparison) if comparison.is_right_active => {
                vec![job(&comparison.other), job(&self.display)]
            }
            Some(comparison) => vec![job(&self.display), job(&comparison.other)],
        }
    }

    /// The view shown at a column of the window.
    pub(crate) fn view_at(&self, x: f64) -> View {
        let display = match &self.comparison {
            Some(comparison) if !comparison.is_difference => {
                let is_right =
                    x >= f64::from(comparison.divider) * f64::from(self.settings.size.width);
                if is_right == comparison.is_right_active {
                    &self.display
                } else {
                    &comparison.other
                }
            }
            _ => &self.display,
        };
        display.view_from(self.camera(), self.settings.size)
    }

    /// The comparison, if any.
    pub(crate) fn comparison(&self) -> Option<&Comparison> {
        self.comparison.as_ref()
    }

    /// Starts a comparison with a copy of the display settings, or ends it.
    pub(crate) fn toggle_comparison(&mut self) {
        self.comparison =
            if self.comparison.is_some() { None } else { Some(Comparison::new(&self.display)) };
        self.changed();
    }

    /// Toggles between the difference and both sides of the comparison.
    pub(crate) fn toggle_difference(&mut self) {
        if self.comparison.is_none() {
            self.toggle_comparison();
        }
        if let Some(comparison) = &mut self.comparison {
            comparison.is_difference = !comparison.is_difference;
        }
        self.changed();
    }

    /// Chooses the side that the panels edit.
    pub(crate) fn set_active_side(&mut self, is_right: bool) {
        if let Some(comparison) = &mut self.comparison
            && comparison.is_right_active != is_right
        {
            comparison.is_right_active = is_right;
            std::mem::swap(&mut comparison.other, &mut self.display);
        }
    }

    /// The comparison, to be edited, with the active settings.
    pub(crate) fn comparison_mut(&mut self) -> Option<(&mut Comparison, &DisplaySettings)> {
        Some((self.comparison.as_mut()?, &self.display))
    }

    /// The scene as guides need it.
    pub(crate) fn guide_scene(&self) -> GuideScene<'_> {
        GuideScene {
            scene: &self.model.scene,
            objects: &self.objects,
            selection: &self.selection,
            bounds: self.settings.bounds,
            up: self.settings.up,
        }
    }

    /// The display settings; in a comparison, those of the active side.
    pub(crate) fn display(&self) -> &DisplaySettings {
        &self.display
    }

    /// Edits the display settings; an edit without effect requests no frame.
    pub(crate) fn change_display(&mut self, change: impl FnOnce(&mut DisplaySettings)) {
        let before = self.display.clone();
        change(&mut self.display);
        if self.display != before {
            self.changed();
        }
    }

    /// Exposes the picture for the light that is on now.
    pub(crate) fn expose_automatically(&mut self) {
        let exposed = auto_exposure(&self.model.scene, &self.view());
        self.change_display(|display| {
            display.view_mut().exposure = exposed.ev;
            display.is_auto_exposed = true;
        });
    }

    /// Applies a key's action to the display settings; false for other actions.
    pub(crate) fn apply_display_action(&mut self, action: Action) -> bool {
        match action {
            Action::ToggleGuide(guide) => {
                let one = match guide {
                    Guide::Grid => &mut self.guides.grid,
                    Guide::Axes => &mut self.guides.axes,
                    Guide::Boxes => &mut self.guides.boxes,
                    Guide::Normals => &mut self.guides.normals,
                };
                *one = !*one;
                self.changed();
            }
            Action::NextEdges => self.change_display(DisplaySettings::step_edges),
            Action::NextShading => self.change_display(DisplaySettings::step_shading),
            Action::StepLayer(is_forward) => {
                self.change_display(|display| display.step_layer(is_forward));
            }
            Action::Compare => self.toggle_comparison(),
            Action::Difference => self.toggle_difference(),
            _ => return false,
        }
        true
    }

    /// The edits of materials.
    pub(crate) fn material_overrides(&self) -> &MaterialOverrides {
        &self.material_overrides
    }

    /// Edits materials.
    pub(crate) fn edit_materials(&mut self, change: impl FnOnce(&mut MaterialOverrides)) {
        let before = self.material_overrides.clone();
        change(&mut self.material_overrides);
        if self.material_overrides != before {
            self.changed();
        }
    }

    /// How the rendered scene differs from the file.
    pub(crate) fn scene_overrides(&self) -> SceneOverrides {
        let materials = self.material_overrides.all(&self.model.scene);
        SceneOverrides { hidden: self.selection.hidden().clone(), materials }
    }

    /// The coordinate spaces of lights.
    pub(crate) fn light_spaces(&self) -> LightSpaces<'_> {
        LightSpaces {
            view_from_world: self.state.view_from_world(),
            world_from_nodes: &self.world_from_nodes,
        }
    }

    /// Adds a light that appears in the upper left of the window and shines at the pivot; returns its
    /// index.
    pub(crate) fn add_light(&mut self, kind: &LightKindDescription) -> usize {
        let (camera, size, target) = (self.camera(), self.settings.size, self.state.pivot());
        let eye = camera.eye();
        // Between the eye and the pivot.
        let nearer = target + (eye - target) * 0.35;
        let from = project_point(&camera, size, nearer).and_then(|place| {
            let corner = [0.38 * f64::from(size.width), 0.25 * f64::from(size.height)];
            point_in_picture(&camera, size, DVec3::new(corner[0], corner[1], place.z))
        });
        let ends = [from.unwrap_or(eye), target];
        let light = self.light_spaces().new_light(kind, ends, &self.display.view().lights);
        let at = self.display.add(light);
        self.changed();
        at
    }

    /// Sets a light's pose in world space.
    pub(crate) fn set_light_pose(&mut self, at: usize, pose: LightPose) {
        let spaces = LightSpaces {
            view_from_world: self.state.view_from_world(),
            world_from_nodes: &self.world_from_nodes,
        };
        if let Some(light) = self.display.view_mut().lights.get_mut(at) {
            let before = light.clone();
            spaces.set_world_pose(light, pose);
            if *light != before {
                self.revision += 1;
            }
        }
    }

    /// Marks the view as changed.
    pub(crate) fn changed(&mut self) {
        self.revision += 1;
    }

    /// The revision of everything in the view but camera and size.
    pub(crate) fn revision(&self) -> u64 {
        self.revision
    }

    /// Sets a number of navigation, if it is allowed.
    pub(crate) fn set_number(&mut self, number: Number, value: f64) {
        if number.allows(value) {
            self.set(Change::Number(number, value));
        }
    }

    /// The log's text, if one is recorded.
    pub(crate) fn log(&self) -> Option<String> {
        self.recorder.text()
    }
}

#[cfg(test)]
mod tests;
