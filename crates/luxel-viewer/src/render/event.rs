//! Requests to the worker's threads, and the events that they send back.

use super::job::RenderJob;
use super::pixel_query::ExplainedPixel;
use crate::model::Model;
use luxel::pick::VisibleIds;
use luxel::render::Prepared;
use luxel::scene::{Camera, SceneMaterial, Size};
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// An event of a worker thread.
pub(crate) struct WorkerMessage {
    /// The model's number, counted by requests.
    pub(crate) model_number: u64,
    pub(crate) event: WorkerEvent,
}

/// What has happened on a worker thread.
pub(crate) enum WorkerEvent {
    /// A model was loaded, or failed to load.
    Loaded(Result<Box<LoadedModel>, String>),
    /// A frame was rendered.
    Rendered(Box<RenderedFrame>),
    /// A frame was interrupted.
    Interrupted,
    /// The objects visible in the last refined frame.
    VisibleObjects(Option<Box<VisibleIds>>),
    /// The selected objects alone, in the last refined frame.
    SelectedObjects(SelectedObjects),
    /// A pixel was explained; `None` if it can't be.
    Explained(Option<Box<ExplainedPixel>>),
    /// The scene or the view can't be rendered.
    Failed(String),
}

/// A model with everything the renderer precomputes for it.
pub(crate) struct LoadedModel {
    pub(crate) model: Model,
    pub(super) prepared: Prepared,
}

/// A rendered frame.
pub(crate) struct RenderedFrame {
    /// One picture, or two to compare.
    pub(crate) pictures: Vec<Vec<[u8; 4]>>,
    pub(crate) camera: Camera,
    pub(crate) size: Size,
    /// Distances along the view, if requested.
    pub(crate) depths: Option<Vec<f32>>,
    pub(crate) purpose: FramePurpose,
    /// The visible objects, if requested or delivered since.
    pub(crate) visible: Option<Box<VisibleIds>>,
    /// The selected ones alone, if requested or delivered since.
    pub(crate) selected: Option<SelectedObjects>,
    /// Render time.
    pub(crate) seconds: f64,
}

/// Selected objects as a view shows them if nothing else is in the scene.
pub(crate) struct SelectedObjects {
    pub(crate) objects: BTreeSet<usize>,
    /// `None` if nothing else is in the scene.
    pub(crate) visible: Option<Box<VisibleIds>>,
}

/// The purpose of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FramePurpose {
    /// A quick frame while the camera moves.
    Interactive,
    /// The first frame at rest, if the full one takes long.
    Refining,
    /// A full frame at rest.
    Refined,
    /// A file.
    Screenshot,
}

/// How the rendered scene differs from the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SceneOverrides {
    /// Hidden objects, by their indices in the scene.
    pub(crate) hidden: BTreeSet<usize>,
    /// All materials, if any differs from the scene's.
    pub(crate) materials: Option<Vec<SceneMaterial>>,
}

/// A request for one frame.
#[derive(Clone, Debug)]
pub(crate) struct RenderRequest {
    /// One picture, or two to compare, of the same camera and size.
    pub(crate) jobs: Vec<RenderJob>,
    pub(crate) purpose: FramePurpose,
    /// The objects that are outlined: with any, the frame comes with its visible objects, and with
    /// these alone.
    pub(crate) selected: BTreeSet<usize>,
    /// Whether the frame must come with depths, because lines are drawn into it.
    pub(crate) needs_depths: bool,
    /// Set when the frame is no longer wanted.
    pub(crate) is_interrupted: Arc<AtomicBool>,
}
