//! The input of a report.

use super::hint::Hint;
use super::pictures::Pictures;
use luxel_render::{Explanation, Unseen, View};
use luxel_scene::Scene;

/// The ledger of one pixel, to be written as text, JSON, LaTeX or HTML.
///
/// All formats write the same terms from the same [`Explanation`]; none computes light again.
/// Colours and light are linear red, green, blue; positions and unit vectors are in world space;
/// `z` is the distance along the viewing axis.
#[derive(Clone, Copy, Debug)]
pub struct Report<'a> {
    pub(crate) explanation: &'a Explanation,
    pub(crate) scene: &'a Scene,
    pub(crate) view: &'a View,
    pub(crate) model: &'a str,
    pub(crate) unseen: Option<&'a Unseen>,
    pub(crate) pictures: Option<&'a Pictures>,
    pub(crate) hint_text: fn(Hint) -> &'static str,
}

impl<'a> Report<'a> {
    /// A report on an explanation, with the scene and the view that it explains.
    ///
    /// Objects go by the scene's names. The model is called `the scene` unless
    /// [`with_model`](Self::with_model) names it.
    #[must_use]
    pub fn new(explanation: &'a Explanation, scene: &'a Scene, view: &'a View) -> Self {
        Self {
            explanation,
            scene,
            view,
            model: "the scene",
            unseen: None,
            pictures: None,
            hint_text: Hint::text,
        }
    }

    /// Names the model: its file, say.
    #[must_use]
    pub fn with_model(self, model: &'a str) -> Self {
        Self { model, ..self }
    }

    /// Adds the invisible surfaces at the pixel, and the objects nearest to an empty one.
    #[must_use]
    pub fn with_unseen(self, unseen: &'a Unseen) -> Self {
        Self { unseen: Some(unseen), ..self }
    }

    /// Adds pictures, which HTML shows.
    #[must_use]
    pub fn with_pictures(self, pictures: &'a Pictures) -> Self {
        Self { pictures: Some(pictures), ..self }
    }

    /// Words hints differently: as a program's flags, or in another language. The default is
    /// [`Hint::text`].
    #[must_use]
    pub fn with_hint_text(self, hint_text: fn(Hint) -> &'static str) -> Self {
        Self { hint_text, ..self }
    }

    /// Settings that explain the pixel beside its light, each once.
    #[must_use]
    pub fn hints(&self) -> Vec<Hint> {
        let entries = self.unseen.map_or(&[][..], |unseen| &unseen.entries);
        let culls = entries.iter().any(|entry| !entry.culled.is_empty());
        culls.then(|| Hint::of_culling(self.view.cull)).into_iter().collect()
    }
}
