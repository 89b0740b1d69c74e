//! What is looked at and from where: navigation, and the view to draw. It knows no window.

use crate::compare::Split;
use crate::guides::{Guides, Subject};
use crate::keys::{Action, Shown};
use crate::lamps::{NewLight, Places};
use crate::look::Look;
use crate::marks::Marks;
use crate::model::Model;
use crate::places::{place_of, point_at};
use crate::recorder::Recorder;
use crate::ruler::Ruler;
use crate::sheet::Sheet;
use crate::wardrobe::{Wardrobe, uses_of_materials};
use crate::worker::Changes;
use luxel::navigation::{
    Change, Entry, Event, Mode, Number, Settings, State, advance, parallel_height, with_lens,
};
use luxel::render::View;
use luxel::scene::{
    Bounds, Camera, DMat4, DVec3, Lens, Object, Placement, Projection, SceneLight, Size, fit_along,
    fit_planes,
};

/// How long the way to another view takes, in seconds.
const TRANSITION: f64 = 0.15;

/// A model with its camera.
pub(crate) struct Session {
    pub(crate) model: Model,
    pub(crate) state: State,
    pub(crate) settings: Settings,
    /// The perspective to come back to from parallel rays.
    perspective: Lens,
    recorder: Recorder,
    /// Lights and ambient light as they were read.
    read: (Vec<SceneLight>, [f32; 3]),
    look: Look,
    /// What it is compared with.
    split: Option<Split>,
    /// What is shown beside the model.
    pub(crate) guides: Guides,
    /// What was changed of the materials.
    wardrobe: Wardrobe,
    /// How many surfaces have each material.
    pub(crate) uses: Vec<usize>,
    /// The scene's objects, and from its nodes' coordinates to the world's.
    pub(crate) objects: Vec<Object>,
    world_from_nodes: Vec<DMat4>,
    /// Which of them are selected, and which are hidden.
    pub(crate) marks: Marks,
    /// What is measured.
    pub(crate) ruler: Ruler,
    /// Grows with each change of the view beside the camera.
    revision: u64,
}

impl Session {
    /// The model from its first view.
    pub(crate) fn new(model: Model, size: Size, mode: Mode, records: bool) -> Self {
        let lens = model.view.camera.projection.lens;
        let bounds = model.scene.bounds();
        let settings =
            Settings::new(bounds, model.up, lens, size).with(Number::Transition, TRANSITION);
        let state = State::new(mode, &model.view.camera.view_from_world, model.pivot);
        let recorder =
            if records { Recorder::start(&settings, &state) } else { Recorder::default() };
        let perspective = match lens {
            Lens::Orthographic { .. } => {
                Lens::Perspective { fov_y_radians: luxel::DEFAULT_FOV_DEGREES.to_radians() }
            }
            lens => lens,
        };
        let look = Look::new(model.view.clone());
        let uses = uses_of_materials(&model.scene);
        let world_from_nodes = model.scene.world_from_nodes();
        let (objects, marks) = (model.scene.objects(), Marks::default());
        let ruler = Ruler::default();
        let read = (model.view.lights.clone(), model.view.ambient);
        Self {
            read,
            model,
            state,
            settings,
            perspective,
            recorder,
            look,
            split: None,
            guides: Guides::default(),
            wardrobe: Wardrobe::default(),
            uses,
            world_from_nodes,
            objects,
            marks,
            ruler,
            revision: 0,
        }
    }

    /// Edges and samples are those of another session.
    pub(crate) fn look_like(&mut self, other: &Self) {
        let (view, like) = (self.look.view_mut(), other.look.view());
        (view.edges, view.samples, view.shading) = (like.edges, like.samples, like.shading);
        self.look.layer.clone_from(&other.look.layer);
        self.guides = other.guides;
    }

    /// The model has changed on the way; camera, edges and samples stay. So do lights that were changed
    /// in the window, unless the file has others than before, and marks, if it has the same objects.
    pub(crate) fn reload(&mut self, model: Model) {
        let paths = |one: &Self| (0..one.objects.len()).map(|at| one.path(at)).collect::<Vec<_>>();
        let before = paths(self);
        let surfaces = |one: &Self| {
            let materials = one.model.scene.materials.iter();
            materials.map(|material| material.name.clone()).collect::<Vec<_>>()
        };
        let materials = surfaces(self);
        self.model = model;
        let read = (self.model.view.lights.clone(), self.model.view.ambient);
        if read != self.read {
            let looks = self.split.iter_mut().map(|split| &mut split.other);
            for look in looks.chain([&mut self.look]) {
                look.relight(read.0.clone(), read.1);
            }
            self.read = read;
        }
        if surfaces(self) != materials {
            self.wardrobe = Wardrobe::default();
        }
        self.uses = uses_of_materials(&self.model.scene);
        self.objects = self.model.scene.objects();
        self.world_from_nodes = self.model.scene.world_from_nodes();
        if paths(self) != before {
            self.marks = Marks::default();
        }
        let bounds = self.model.scene.bounds();
        if !bounds.is_empty() {
            self.set(Change::Bounds(bounds));
        }
        self.revision += 1;
    }

    /// The lights that are on, in coordinates of the world or the camera, if they or the scene's ambient
    /// light are not as they were read.
    pub(crate) fn changed_lights(&self) -> Option<Vec<SceneLight>> {
        let view = self.view();
        if (&view.lights, view.ambient) == (&self.read.0, self.read.1) {
            return None;
        }
        let mut lights = view.lights;
        for light in &mut lights {
            if let Placement::Node(_) = light.placement {
                self.places().replace(light, Placement::World);
            }
        }
        Some(lights)
    }

    /// Whether what mirrors and metals see is not as it was read.
    pub(crate) fn is_environment_changed(&self) -> bool {
        self.look.view().environment != self.model.view.environment
    }

    /// Whether surfaces are not as they were read.
    pub(crate) fn is_redressed(&self) -> bool {
        self.wardrobe != Wardrobe::default() || !self.marks.hidden().is_empty()
    }

    /// Some seconds have passed, then something has happened.
    pub(crate) fn happen(&mut self, event: Event, seconds: f64) {
        self.state = advance(&self.state, &self.settings, &event, seconds);
        self.recorder.keep(Entry::Event { seconds, event });
    }

    /// An entry of a log is played.
    pub(crate) fn play(&mut self, entry: &Entry) {
        match entry {
            // The window has its own size, and pictures are drawn for it.
            Entry::Set(change) => self.set(*change),
            Entry::Event { seconds, event } => self.happen(*event, *seconds),
        }
    }

    /// The window has another size. The camera of a model that nobody has moved yet is fitted anew by
    /// whoever asks.
    pub(crate) fn resize(&mut self, size: Size) {
        self.set(Change::Size(size));
    }

    fn set(&mut self, change: Change) {
        self.settings = change.apply(&self.settings);
        self.recorder.keep(Entry::Set(change));
    }

    /// All of the scene comes into view, along the direction of the view.
    pub(crate) fn fit(&mut self, seconds: f64) {
        let view = self.state.view_from_world();
        let axes = [0, 1, 2].map(|row| view.row(row).truncate());
        let lens = match self.settings.lens {
            // A height of 0 is the one that fits.
            Lens::Orthographic { .. } => Lens::Orthographic { height: 0.0 },
            lens => lens,
        };
        let camera = fit_along(&self.model.scene, axes, lens, self.settings.size);
        let scale = match (camera.projection.lens, self.settings.lens) {
            (Lens::Orthographic { height: fitted }, Lens::Orthographic { height }) => {
                fitted / height
            }
            _ => 1.0,
        };
        let bounds = self.settings.bounds;
        let pivot = if bounds.is_empty() { self.state.pivot() } else { bounds.centre() };
        let view_from_world = camera.view_from_world;
        self.happen(Event::Go { view_from_world, pivot, scale }, seconds);
    }

    /// What is selected comes into view; if nothing is, whatever is not hidden.
    pub(crate) fn fit_selected(&mut self, seconds: f64) {
        let (selected, hidden) = (self.marks.selected(), self.marks.hidden());
        if selected.is_empty() && hidden.is_empty() {
            self.fit(seconds);
            return;
        }
        let wanted = (0..self.objects.len()).filter(|object| {
            if selected.is_empty() { !hidden.contains(object) } else { selected.contains(object) }
        });
        let bounds = wanted.fold(Bounds::EMPTY, |all, object| all.union(&self.bounds(object)));
        if !bounds.is_empty() {
            self.happen(Event::Fit(Some(bounds)), seconds);
        }
    }

    /// An object's bounds in world space.
    pub(crate) fn bounds(&self, object: usize) -> Bounds {
        self.objects.get(object).map_or(Bounds::EMPTY, |object| {
            self.model.scene.meshes.bounds_of(object.mesh, &object.world_from_mesh)
        })
    }

    /// The names from the scene's root down to an object.
    pub(crate) fn path(&self, object: usize) -> String {
        let object = self.objects.get(object);
        object.map(|object| self.model.scene.path(object.node).join(" / ")).unwrap_or_default()
    }

    /// Parallel rays instead of a perspective, or the other way, with the picture in place.
    pub(crate) fn switch_lens(&mut self, seconds: f64) {
        // Whatever is under way comes to its end first.
        self.happen(Event::Pivot(self.state.pivot()), seconds);
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
        self.happen(Event::Place(place), 0.0);
    }

    /// The camera as it is now.
    pub(crate) fn camera(&self) -> Camera {
        let view_from_world = self.state.view_from_world();
        let lens = self.state.lens(self.settings.lens);
        let (near, far) = fit_planes(&self.settings.bounds, &view_from_world);
        let [fixed_near, fixed_far] = self.model.planes;
        let (mut near, mut far) = (fixed_near.unwrap_or(near), fixed_far.unwrap_or(far));
        // What the user has fixed may leave nothing of what fits.
        if near >= far && fixed_far.is_none() {
            far = near + near.abs().max(1.0);
        } else if near >= far {
            near = if matches!(lens, Lens::Orthographic { .. }) { far - 1.0 } else { far * 1e-4 };
        }
        Camera { view_from_world, projection: Projection { lens, near, far } }
    }

    /// What to draw now.
    pub(crate) fn view(&self) -> View {
        self.look.drawn(self.camera(), self.settings.size)
    }

    /// What to draw now: one picture, or two to be compared.
    pub(crate) fn sheets(&self) -> Vec<Sheet> {
        let (camera, size) = (self.camera(), self.settings.size);
        let sheet =
            |look: &Look| Sheet { view: look.drawn(camera, size), layer: look.layer.clone() };
        match &self.split {
            None => vec![sheet(&self.look)],
            Some(split) if split.is_right_set => vec![sheet(&split.other), sheet(&self.look)],
            Some(split) => vec![sheet(&self.look), sheet(&split.other)],
        }
    }

    /// The view whose picture is seen at a column of the window.
    pub(crate) fn view_at(&self, x: f64) -> View {
        let look = match &self.split {
            Some(split) if !split.is_difference => {
                let is_right = x >= f64::from(split.at) * f64::from(self.settings.size.width);
                if is_right == split.is_right_set { &self.look } else { &split.other }
            }
            _ => &self.look,
        };
        look.drawn(self.camera(), self.settings.size)
    }

    /// What the look is compared with.
    pub(crate) fn split(&self) -> Option<&Split> {
        self.split.as_ref()
    }

    /// Compares with a look like this one, or no more.
    pub(crate) fn toggle_split(&mut self) {
        self.split = if self.split.is_some() { None } else { Some(Split::new(&self.look)) };
        self.changed();
    }

    /// Shows the difference to what the look is compared with, or both.
    pub(crate) fn toggle_difference(&mut self) {
        if self.split.is_none() {
            self.toggle_split();
        }
        if let Some(split) = &mut self.split {
            split.is_difference = !split.is_difference;
        }
        self.changed();
    }

    /// Sets the look on the right from now on, or the one on the left.
    pub(crate) fn set_side(&mut self, is_right: bool) {
        if let Some(split) = &mut self.split
            && split.is_right_set != is_right
        {
            split.is_right_set = is_right;
            std::mem::swap(&mut split.other, &mut self.look);
        }
    }

    /// The line between two looks, to be moved.
    pub(crate) fn divider(&mut self) -> Option<(&mut Split, &Look)> {
        Some((self.split.as_mut()?, &self.look))
    }

    /// The model, as far as guides are about it.
    pub(crate) fn subject(&self) -> Subject<'_> {
        Subject {
            scene: &self.model.scene,
            objects: &self.objects,
            marks: &self.marks,
            bounds: self.settings.bounds,
            up: self.settings.up,
        }
    }

    /// How the scene is looked at.
    pub(crate) fn look(&self) -> &Look {
        &self.look
    }

    /// Changes how the scene is looked at; whoever changes nothing asks for no picture.
    pub(crate) fn change_look(&mut self, change: impl FnOnce(&mut Look)) {
        let before = self.look.clone();
        change(&mut self.look);
        if self.look != before {
            self.changed();
        }
    }

    /// Changes how the scene is looked at as a key asks; whether it asks for that.
    pub(crate) fn look_otherwise(&mut self, action: Action) -> bool {
        match action {
            Action::Show(shown) => {
                let one = match shown {
                    Shown::Grid => &mut self.guides.grid,
                    Shown::Axes => &mut self.guides.axes,
                    Shown::Boxes => &mut self.guides.boxes,
                    Shown::Normals => &mut self.guides.normals,
                };
                *one = !*one;
                self.changed();
            }
            Action::NextEdges => self.change_look(Look::step_edges),
            Action::NextShading => self.change_look(Look::step_shading),
            Action::StepLayer(is_forward) => self.change_look(|look| look.step_layer(is_forward)),
            Action::Split => self.toggle_split(),
            Action::Difference => self.toggle_difference(),
            _ => return false,
        }
        true
    }

    /// What was changed of the materials.
    pub(crate) fn wardrobe(&self) -> &Wardrobe {
        &self.wardrobe
    }

    /// Changes materials.
    pub(crate) fn change_wardrobe(&mut self, change: impl FnOnce(&mut Wardrobe)) {
        let before = self.wardrobe.clone();
        change(&mut self.wardrobe);
        if self.wardrobe != before {
            self.changed();
        }
    }

    /// What is drawn otherwise than the file has it.
    pub(crate) fn changes(&self) -> Changes {
        let materials = self.wardrobe.all(&self.model.scene);
        Changes { hidden: self.marks.hidden().clone(), materials }
    }

    /// What coordinates of lights are about.
    pub(crate) fn places(&self) -> Places<'_> {
        Places {
            view_from_world: self.state.view_from_world(),
            world_from_nodes: &self.world_from_nodes,
        }
    }

    /// Adds a light that is seen in the upper left of the window and shines at what is looked at; its
    /// place.
    pub(crate) fn add_light(&mut self, kind: NewLight) -> usize {
        let (camera, size, target) = (self.camera(), self.settings.size, self.state.pivot());
        let eye = camera.eye();
        // Between the eye and what is looked at.
        let nearer = target + (eye - target) * 0.35;
        let from = place_of(&camera, size, nearer).and_then(|place| {
            let corner = [0.38 * f64::from(size.width), 0.25 * f64::from(size.height)];
            point_at(&camera, size, DVec3::new(corner[0], corner[1], place.z))
        });
        let ends = [from.unwrap_or(eye), target];
        let light = self.places().new_light(kind, ends, &self.look.view().lights);
        let at = self.look.add(light);
        self.changed();
        at
    }

    /// Puts a light somewhere in the world, its light travelling in a direction.
    pub(crate) fn put_light(&mut self, at: usize, position: DVec3, direction: DVec3) {
        let places = Places {
            view_from_world: self.state.view_from_world(),
            world_from_nodes: &self.world_from_nodes,
        };
        if let Some(light) = self.look.view_mut().lights.get_mut(at) {
            let before = light.clone();
            places.put(light, position, direction);
            if *light != before {
                self.revision += 1;
            }
        }
    }

    /// Light or layers are others now.
    pub(crate) fn changed(&mut self) {
        self.revision += 1;
    }

    /// Tells views apart that have the same camera and size.
    pub(crate) fn revision(&self) -> u64 {
        self.revision
    }

    /// The user likes another number.
    pub(crate) fn set_number(&mut self, number: Number, value: f64) {
        if number.allows(value) {
            self.set(Change::Number(number, value));
        }
    }

    /// The log of what was done, if one is kept.
    pub(crate) fn log(&self) -> Option<String> {
        self.recorder.text()
    }
}

#[cfg(test)]
mod tests;
