//! The model on display, its loading, and the list of files.

mod file_list;
mod file_watch;
mod load_progress;

pub(crate) use file_list::{FileList, WELCOME};
pub(crate) use file_watch::FileWatch;
pub use load_progress::LoadProgress;
use luxel::render::View;
use luxel::scene::{DVec3, Scene};
use std::sync::Arc;

/// A loaded model with its initial view.
#[derive(Clone)]
pub struct Model {
    /// The scene.
    pub scene: Arc<Scene>,
    /// The initial view: camera, lights, samples. The window replaces size and background.
    pub view: View,
    /// The up direction in world space.
    pub up: DVec3,
    /// The camera's pivot in world space.
    pub pivot: DVec3,
    /// Whether the camera is fitted to the scene, rather than placed by the file or the user.
    pub is_fitted: bool,
    /// The near and far clipping planes that the user has fixed; the others fit the scene.
    pub planes: [Option<f64>; 2],
    /// Whether the view's exposure comes from the scene's own light.
    pub is_auto_exposed: bool,
    /// What to say of that exposure, if it does something.
    pub exposure_note: Option<String>,
}

impl Model {
    /// A model for tests: a scene fitted into a view.
    #[cfg(test)]
    pub(crate) fn fitted(scene: Scene, view: View) -> Self {
        Self {
            up: scene.up,
            pivot: scene.bounds().centre(),
            scene: Arc::new(scene),
            view,
            is_fitted: true,
            planes: [None; 2],
            is_auto_exposed: true,
            exposure_note: None,
        }
    }

    /// Gives every object a mesh of its own: objects are hidden, measured and coloured one by one.
    pub(crate) fn separate(&mut self) {
        if self.scene.has_sections() {
            Arc::make_mut(&mut self.scene).separate();
        }
    }
}
