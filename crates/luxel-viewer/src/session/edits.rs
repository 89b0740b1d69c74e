//! Edits that a scene file keeps, and whether one has them.

use super::Session;
use super::material_overrides::MaterialOverrides;
use crate::display::DisplaySettings;
use luxel::render::EnvironmentChoice;
use luxel::scene::SceneLight;

/// The lights that are on, with the scene's ambient light, and the environment.
type Lighting = (Vec<SceneLight>, [f32; 3], EnvironmentChoice);

/// Lighting and materials.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Edits {
    lighting: Lighting,
    materials: MaterialOverrides,
}

impl Session {
    /// Notes that a scene file has the present edits.
    pub(crate) fn set_saved(&mut self) {
        let lighting = self.lighting(&self.display);
        self.saved_edits = Some(Edits { lighting, materials: self.material_overrides.clone() });
    }

    /// Whether lights, the environment or materials have edits that no file has.
    pub(crate) fn has_unsaved_edits(&self) -> bool {
        let materials = &self.material_overrides;
        let is_saved = self.saved_edits.as_ref().is_some_and(|saved| saved.materials == *materials);
        let is_unsaved = *materials != MaterialOverrides::default() && !is_saved;
        is_unsaved || self.has_unsaved_lighting(&self.display) || self.loses_edits_by_closing()
    }

    /// Whether the end of the comparison would lose edits: those of the side that the panels don't edit.
    pub(crate) fn loses_edits_by_closing(&self) -> bool {
        let other = self.comparison.as_ref().map(|comparison| &comparison.other);
        other.is_some_and(|other| {
            self.lighting(other) != self.lighting(&self.display) && self.has_unsaved_lighting(other)
        })
    }

    fn has_unsaved_lighting(&self, display: &DisplaySettings) -> bool {
        let lighting = self.lighting(display);
        let (lights, ambient) = self.loaded_lights.clone();
        let is_loaded = lighting == (lights, ambient, self.model.view.environment.clone());
        !is_loaded && self.saved_edits.as_ref().is_none_or(|saved| saved.lighting != lighting)
    }

    fn lighting(&self, display: &DisplaySettings) -> Lighting {
        let view = display.view_from(self.camera(), self.settings.size);
        (view.lights, view.ambient, view.environment)
    }
}
