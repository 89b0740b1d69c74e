//! Display settings: everything the panels set except camera and objects.

use luxel::lighting::{LightKind, Tone};
use luxel::render::{Clamp, Edges, Interpolation, Layer, ShadingMode, View};
use luxel::scene::{Camera, SceneLight, Size};

/// A layer's name in the window.
pub(crate) fn layer_name(layer: &Layer) -> String {
    match layer {
        Layer::NDotL => "N.L".to_owned(),
        Layer::Light(name) => format!("only {name}"),
        Layer::Shadow(name) => format!("shadow of {name}"),
        layer => layer.name(),
    }
}

/// Whether a layer shows light rather than geometry.
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
            | Layer::Openness
            | Layer::Shadow(_)
            | Layer::Light(_)
    )
}

/// Lights, shading and the layer on display.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DisplaySettings {
    /// The view; the window replaces camera and size.
    view: View,
    /// Which lights are switched off.
    disabled: Vec<bool>,
    /// The layer shown instead of the picture.
    pub(crate) layer: Option<Layer>,
    /// Whether the exposure is the one that suits the light as it was loaded, or as it was when that was
    /// asked for: editing lights changes the picture's brightness.
    pub(crate) is_auto_exposed: bool,
}

impl DisplaySettings {
    /// All lights of the view are on.
    pub(crate) fn new(view: View) -> Self {
        let disabled = vec![false; view.lights.len()];
        Self { view, disabled, layer: None, is_auto_exposed: false }
    }

    /// The view's settings. Lights are added and removed by the functions below.
    pub(crate) fn view(&self) -> &View {
        &self.view
    }

    pub(crate) fn view_mut(&mut self) -> &mut View {
        &mut self.view
    }

    /// A light, and whether it is on.
    pub(crate) fn light(&self, at: usize) -> Option<(&SceneLight, bool)> {
        Some((self.view.lights.get(at)?, !*self.disabled.get(at)?))
    }

    pub(crate) fn set_enabled(&mut self, at: usize, is_on: bool) {
        if let Some(disabled) = self.disabled.get_mut(at) {
            *disabled = !is_on;
        }
    }

    /// Renames a light, unless the name is empty or taken. A layer of this light follows.
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

    /// Adds a light, switched on; returns its index.
    pub(crate) fn add(&mut self, light: SceneLight) -> usize {
        self.view.lights.push(light);
        self.disabled.push(false);
        self.disabled.len() - 1
    }

    pub(crate) fn remove(&mut self, at: usize) {
        if at < self.disabled.len() {
            self.view.lights.remove(at);
            self.disabled.remove(at);
        }
    }

    /// Replaces the lights; all are on.
    pub(crate) fn set_lights(&mut self, lights: Vec<SceneLight>, ambient: [f32; 3]) {
        self.disabled = vec![false; lights.len()];
        (self.view.lights, self.view.ambient) = (lights, ambient);
    }

    /// A short description: shading mode, interpolation, layer, exposure, tone curve, samples.
    pub(crate) fn summary(&self) -> String {
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
        if self.view.exposure != 0.0 {
            parts.push(format!("exposure {}", self.view.exposure));
        }
        if self.view.tone != Tone::None {
            parts.push(self.view.tone.name().to_owned());
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

    /// Everything that can be shown: the picture (`None`) and its layers.
    pub(crate) fn layers(&self) -> Vec<Option<Layer>> {
        let has = |layer: &Layer| match layer {
            Layer::Fog => self.view.fog.is_some(),
            Layer::Openness => self.view.ambient_occlusion.is_some(),
            _ => true,
        };
        let of_all = Layer::ALL.into_iter().filter(has);
        // Light first, then geometry.
        let (lit, shape): (Vec<_>, Vec<_>) = of_all.partition(is_of_light);
        let lights = self.view.lights.iter();
        let lights = lights.filter(|light| light.light.kind != LightKind::Ambient);
        let lights = lights.map(|light| Layer::Light(light.name.clone()));
        std::iter::once(None).chain(lit.into_iter().chain(lights).chain(shape).map(Some)).collect()
    }

    /// Steps to the next or previous layer.
    pub(crate) fn step_layer(&mut self, is_forward: bool) {
        let all = self.layers();
        let at = all.iter().position(|layer| *layer == self.layer).unwrap_or(0);
        let next = (at + if is_forward { 1 } else { all.len() - 1 }) % all.len();
        self.layer = all.into_iter().nth(next).flatten();
    }

    /// Steps to the next shading mode.
    pub(crate) fn step_shading(&mut self) {
        let mode = &mut self.view.shading.mode;
        let at = ShadingMode::ALL.iter().position(|one| one.name() == mode.name());
        *mode = ShadingMode::ALL[(at.unwrap_or(0) + 1) % ShadingMode::ALL.len()];
    }

    /// Steps to the next way to draw edges.
    pub(crate) fn step_edges(&mut self) {
        self.view.edges = match self.view.edges {
            None => Some(Edges::OVER_FACES),
            Some(edges) if !edges.wireframe => Some(Edges::WIREFRAME),
            Some(_) => None,
        };
    }

    /// The view from a camera, without the lights that are off.
    pub(crate) fn view_from(&self, camera: Camera, size: Size) -> View {
        let mut view = self.view.clone().with_camera(camera).with_size(size);
        let mut disabled = self.disabled.iter();
        view.lights.retain(|_| disabled.next() != Some(&true));
        view
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::demos;

    fn plane() -> DisplaySettings {
        let scene = demos::demo("plane").unwrap();
        DisplaySettings::new(luxel::default_view(&scene, Size { width: 64, height: 48 }))
    }

    #[test]
    fn stepping_comes_round_to_the_picture_through_every_layer() {
        let mut display = plane();
        let count = display.layers().len();
        let is_local = |light: &&SceneLight| light.light.kind != LightKind::Ambient;
        let lights = display.view().lights.iter().filter(is_local).count();
        // There is neither fog nor ambient occlusion.
        assert_eq!(count, 1 + Layer::ALL.len() - 2 + lights);
        let mut seen = Vec::new();
        for _ in 0..count {
            assert!(!seen.contains(&display.layer), "{:?}", display.layer);
            seen.push(display.layer.clone());
            display.step_layer(true);
        }
        assert_eq!(display.layer, None);
        display.step_layer(false);
        assert_eq!(display.layer, seen[count - 1]);
    }

    #[test]
    fn shading_and_edges_come_round() {
        let mut display = plane();
        let first = display.clone();
        let mut summaries = Vec::new();
        for _ in ShadingMode::ALL {
            summaries.push(display.summary());
            display.step_shading();
        }
        assert_eq!(display, first);
        summaries.dedup();
        assert_eq!(summaries.len(), ShadingMode::ALL.len());
        for _ in 0..3 {
            display.step_edges();
        }
        assert_eq!(display, first);
    }

    #[test]
    fn a_light_gets_a_name_that_is_free_and_is_shown_alone_as_before() {
        let mut display = plane();
        let names = |display: &DisplaySettings| {
            let names = display.view().lights.iter().map(|light| light.name.clone());
            names.collect::<Vec<_>>()
        };
        let before = names(&display);
        display.layer = Some(Layer::Light(before[0].clone()));
        for taken in [before[1].as_str(), "", "  ", "a\nb"] {
            display.rename(0, taken);
            assert_eq!(names(&display), before, "{taken:?}");
        }
        display.rename(0, "moon");
        assert_eq!((&*names(&display)[0], &names(&display)[1..]), ("moon", &before[1..]));
        assert_eq!(display.layer, Some(Layer::Light("moon".to_owned())));
    }

    #[test]
    fn lights_that_are_off_are_not_drawn_and_come_back() {
        let mut display = plane();
        let camera = display.view().camera;
        let size = display.view().size;
        let all = display.view_from(camera, size).lights;
        display.set_enabled(0, false);
        assert_eq!(display.view_from(camera, size).lights, all[1..]);
        let new = SceneLight { name: "new".to_owned(), ..all[0].clone() };
        let at = display.add(new.clone());
        assert_eq!(display.light(at), Some((&new, true)));
        display.remove(0);
        assert_eq!(display.view_from(camera, size).lights, [&all[1..], &[new]].concat());
    }
}
