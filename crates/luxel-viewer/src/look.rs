//! How the scene is looked at, apart from where from: all that the panels set and no object has.

use luxel::lighting::LightKind;
use luxel::render::{Clamp, Edges, Interpolation, Layer, ShadingMode, View};
use luxel::scene::{Camera, SceneLight, Size};

/// A layer's name in the window.
pub(crate) fn layer_name(layer: &Layer) -> String {
    match layer {
        Layer::NDotL => "N.L".to_owned(),
        Layer::Light(name) => format!("only {name}"),
        layer => layer.name(),
    }
}

/// Whether a layer is about light, and not about shape.
pub(crate) fn is_of_light(layer: &Layer) -> bool {
    matches!(
        layer,
        Layer::Ambient
            | Layer::Diffuse
            | Layer::Specular
            | Layer::Emission
            | Layer::Environment
            | Layer::Fog
            | Layer::NDotL
            | Layer::Light(_)
    )
}

/// Light, shading and what is shown of it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Look {
    /// What to draw; camera and size are the window's.
    view: View,
    /// Which lights are off.
    dark: Vec<bool>,
    /// A layer instead of the picture.
    pub(crate) layer: Option<Layer>,
}

impl Look {
    /// With all lights of a view on.
    pub(crate) fn new(view: View) -> Self {
        let dark = vec![false; view.lights.len()];
        Self { view, dark, layer: None }
    }

    /// What is set, to be read and changed; its lights by the functions below.
    pub(crate) fn view(&self) -> &View {
        &self.view
    }

    pub(crate) fn view_mut(&mut self) -> &mut View {
        &mut self.view
    }

    /// A light with whether it is on.
    pub(crate) fn light(&self, at: usize) -> Option<(&SceneLight, bool)> {
        Some((self.view.lights.get(at)?, !*self.dark.get(at)?))
    }

    pub(crate) fn switch(&mut self, at: usize, is_on: bool) {
        if let Some(dark) = self.dark.get_mut(at) {
            *dark = !is_on;
        }
    }

    /// Calls a light by another name, unless that is none or another light's. What shows it alone goes
    /// on doing so.
    pub(crate) fn rename(&mut self, at: usize, name: &str) {
        let is_free = self.view.lights.iter().all(|light| light.name != name);
        let is_name = !name.trim().is_empty() && !name.chars().any(char::is_control);
        let Some(light) = self.view.lights.get_mut(at).filter(|_| is_free && is_name) else {
            return;
        };
        if self.layer == Some(Layer::Light(light.name.clone())) {
            self.layer = Some(Layer::Light(name.to_owned()));
        }
        name.clone_into(&mut light.name);
    }

    /// One more light, on; its place.
    pub(crate) fn add(&mut self, light: SceneLight) -> usize {
        self.view.lights.push(light);
        self.dark.push(false);
        self.dark.len() - 1
    }

    pub(crate) fn remove(&mut self, at: usize) {
        if at < self.dark.len() {
            self.view.lights.remove(at);
            self.dark.remove(at);
        }
    }

    /// Other lights, all on.
    pub(crate) fn relight(&mut self, lights: Vec<SceneLight>, ambient: [f32; 3]) {
        self.dark = vec![false; lights.len()];
        (self.view.lights, self.view.ambient) = (lights, ambient);
    }

    /// In a few words: where light is computed, how it gets between, what is shown of it.
    pub(crate) fn told(&self) -> String {
        let shading = self.view.shading;
        let mut parts = vec![shading.mode.name().to_owned()];
        if shading.interpolation != Interpolation::default() {
            parts.push(shading.interpolation.name().to_owned());
        }
        if shading.clamp == Clamp::End {
            parts.push("clamped at the end".to_owned());
        }
        if let Some(layer) = &self.layer {
            parts.push(layer_name(layer));
        }
        if self.view.edges.is_some_and(|edges| edges.wireframe) {
            parts.push("wireframe".to_owned());
        }
        parts.push(match self.view.samples {
            1 => "1 sample".to_owned(),
            samples => format!("{samples} samples"),
        });
        parts.join(", ")
    }

    /// All that can be shown: the picture, and its layers.
    pub(crate) fn layers(&self) -> Vec<Option<Layer>> {
        let of_all =
            Layer::ALL.into_iter().filter(|layer| *layer != Layer::Fog || self.view.fog.is_some());
        // Light first, then shape.
        let (lit, shape): (Vec<_>, Vec<_>) = of_all.partition(is_of_light);
        let lights = self.view.lights.iter();
        let lights = lights.filter(|light| light.light.kind != LightKind::Ambient);
        let lights = lights.map(|light| Layer::Light(light.name.clone()));
        std::iter::once(None).chain(lit.into_iter().chain(lights).chain(shape).map(Some)).collect()
    }

    /// The next layer, or the one before.
    pub(crate) fn step_layer(&mut self, is_forward: bool) {
        let all = self.layers();
        let at = all.iter().position(|layer| *layer == self.layer).unwrap_or(0);
        let next = (at + if is_forward { 1 } else { all.len() - 1 }) % all.len();
        self.layer = all.into_iter().nth(next).flatten();
    }

    /// The next shading mode.
    pub(crate) fn step_shading(&mut self) {
        let mode = &mut self.view.shading.mode;
        let at = ShadingMode::ALL.iter().position(|one| one.name() == mode.name());
        *mode = ShadingMode::ALL[(at.unwrap_or(0) + 1) % ShadingMode::ALL.len()];
    }

    /// The next way to draw edges.
    pub(crate) fn step_edges(&mut self) {
        self.view.edges = match self.view.edges {
            None => Some(Edges::OVER_FACES),
            Some(edges) if !edges.wireframe => Some(Edges::WIREFRAME),
            Some(_) => None,
        };
    }

    /// What to draw from a camera: without the lights that are off.
    pub(crate) fn drawn(&self, camera: Camera, size: Size) -> View {
        let mut view = View { camera, size, ..self.view.clone() };
        let mut dark = self.dark.iter();
        view.lights.retain(|_| dark.next() != Some(&true));
        view
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::demos;

    fn look() -> Look {
        let scene = demos::demo("plane").unwrap();
        Look::new(luxel::default_view(&scene, Size { width: 64, height: 48 }))
    }

    #[test]
    fn stepping_comes_round_to_the_picture_through_every_layer() {
        let mut look = look();
        let count = look.layers().len();
        let is_local = |light: &&SceneLight| light.light.kind != LightKind::Ambient;
        let lights = look.view().lights.iter().filter(is_local).count();
        // There is no fog.
        assert_eq!(count, 1 + Layer::ALL.len() - 1 + lights);
        let mut seen = Vec::new();
        for _ in 0..count {
            assert!(!seen.contains(&look.layer), "{:?}", look.layer);
            seen.push(look.layer.clone());
            look.step_layer(true);
        }
        assert_eq!(look.layer, None);
        look.step_layer(false);
        assert_eq!(look.layer, seen[count - 1]);
    }

    #[test]
    fn shading_and_edges_come_round() {
        let mut look = look();
        let first = look.clone();
        let mut told = Vec::new();
        for _ in ShadingMode::ALL {
            told.push(look.told());
            look.step_shading();
        }
        assert_eq!(look, first);
        told.dedup();
        assert_eq!(told.len(), ShadingMode::ALL.len());
        for _ in 0..3 {
            look.step_edges();
        }
        assert_eq!(look, first);
    }

    #[test]
    fn a_light_gets_a_name_that_is_free_and_is_shown_alone_as_before() {
        let mut look = look();
        let names = |look: &Look| {
            let names = look.view().lights.iter().map(|light| light.name.clone());
            names.collect::<Vec<_>>()
        };
        let before = names(&look);
        look.layer = Some(Layer::Light(before[0].clone()));
        for taken in [before[1].as_str(), "", "  ", "a\nb"] {
            look.rename(0, taken);
            assert_eq!(names(&look), before, "{taken:?}");
        }
        look.rename(0, "moon");
        assert_eq!((&*names(&look)[0], &names(&look)[1..]), ("moon", &before[1..]));
        assert_eq!(look.layer, Some(Layer::Light("moon".to_owned())));
    }

    #[test]
    fn lights_that_are_off_are_not_drawn_and_come_back() {
        let mut look = look();
        let camera = look.view().camera;
        let size = look.view().size;
        let all = look.drawn(camera, size).lights;
        look.switch(0, false);
        assert_eq!(look.drawn(camera, size).lights, all[1..]);
        let new = SceneLight { name: "new".to_owned(), ..all[0].clone() };
        let at = look.add(new.clone());
        assert_eq!(look.light(at), Some((&new, true)));
        look.remove(0);
        assert_eq!(look.drawn(camera, size).lights, [&all[1..], &[new]].concat());
    }
}
