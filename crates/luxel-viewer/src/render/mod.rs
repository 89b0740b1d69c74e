//! Rendering off the window's thread: jobs, the worker and its events, queries of single pixels.

mod event;
mod job;
mod pixel_query;
mod render_thread;
mod resolution_scaling;
mod worker;

pub(crate) use event::{
    FramePurpose, LoadedModel, RenderRequest, RenderedFrame, SceneOverrides, WorkerEvent,
    WorkerMessage,
};
pub(crate) use job::RenderJob;
pub(crate) use pixel_query::{ExplainedPixel, PixelHit, hit_at_pixel, render_depths};
pub(crate) use resolution_scaling::{MotionStats, ResolutionScaling};
pub(crate) use worker::Worker;
