//! The threads that render and load models, so that the window stays responsive.

use super::RenderJob;
use super::event::{LoadedModel, RenderRequest, SceneOverrides, WorkerEvent, WorkerMessage};
use super::pixel_query::PixelHit;
use super::render_thread::{Command, CurrentScene, render_scene};
use crate::model::{LoadProgress, Model};
use luxel::render::{Execution, Renderer, View};
use std::collections::BTreeSet;
use std::ffi::{OsStr, OsString};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

/// Starts a thread that loads a file as the model of this number.
type StartLoading = dyn Fn(u64, OsString, LoadProgress) -> std::io::Result<()>;

/// A handle to the threads, which end when it is dropped.
pub(crate) struct Worker {
    commands: Sender<Command>,
    start_loading: Box<StartLoading>,
    /// The number of models requested so far.
    requested: u64,
    /// Progress of the model requested last.
    progress: LoadProgress,
}

impl Worker {
    /// Starts the render thread and loads the first file. `send` delivers events to the window and
    /// returns false once it is gone.
    ///
    /// # Errors
    /// If no thread can be started.
    pub(crate) fn start(
        load: impl Fn(&OsStr, &LoadProgress) -> Result<Model, String> + Send + Sync + 'static,
        first: OsString,
        execution: Execution,
        send: impl Fn(WorkerMessage) -> bool + Clone + Send + 'static,
    ) -> std::io::Result<Self> {
        let (commands, received) = channel();
        let load = Arc::new(load);
        let send_rendered = send.clone();
        std::thread::Builder::new().name("luxel-draw".to_owned()).spawn(move || {
            let mut next = None;
            loop {
                next = match next {
                    None => match received.recv() {
                        Ok(Command::Show(scene)) => Some(*scene),
                        // There is no scene to render yet.
                        Ok(_) => None,
                        Err(_) => return,
                    },
                    Some(scene) => match render_scene(scene, &received, &send_rendered) {
                        None => return,
                        scene => scene,
                    },
                };
            }
        })?;
        let start_loading = move |model_number, file: OsString, progress: LoadProgress| {
            let (load, send) = (Arc::clone(&load), send.clone());
            let thread = std::thread::Builder::new().name("luxel-read".to_owned());
            let spawned = thread.spawn(move || {
                let loaded = load(&file, &progress).and_then(|mut model| {
                    if progress.is_stopped() {
                        return Err("loading was cancelled".to_owned());
                    }
                    progress.model_complete();
                    model.separate();
                    let renderer = Renderer::new(Arc::clone(&model.scene), &execution);
                    let renderer = renderer.map_err(|error| error.to_string())?;
                    if (RenderJob { view: model.view.clone(), layer: None }).traces_rays() {
                        renderer.build_trees().map_err(|error| error.to_string())?;
                    }
                    let prepared = renderer.into_prepared();
                    Ok(Box::new(LoadedModel { model, prepared }))
                });
                if !progress.is_stopped() {
                    send(WorkerMessage { model_number, event: WorkerEvent::Loaded(loaded) });
                }
            });
            spawned.map(|_| ())
        };
        let start_loading = Box::new(start_loading);
        let progress = LoadProgress::default();
        let mut worker = Self { commands, start_loading, requested: 0, progress };
        worker.load(first)?;
        Ok(worker)
    }

    /// Loads another file, and cancels loading the previous one. The scene on display stays until
    /// [`show`](Self::show).
    ///
    /// # Errors
    /// If no thread can be started.
    pub(crate) fn load(&mut self, file: OsString) -> std::io::Result<()> {
        self.cancel_loading();
        self.progress = LoadProgress::default();
        (self.start_loading)(self.requested, file, self.progress.clone())
    }

    /// Cancels loading.
    pub(crate) fn cancel_loading(&mut self) {
        self.progress.stop();
        self.requested += 1;
    }

    /// The number of the model requested last.
    pub(crate) fn requested(&self) -> u64 {
        self.requested
    }

    /// Its progress.
    pub(crate) fn progress(&self) -> &LoadProgress {
        &self.progress
    }

    /// Renders this model from now on.
    pub(crate) fn show(&self, loaded: LoadedModel) -> Model {
        let LoadedModel { model, prepared } = loaded;
        let number = self.requested;
        let scene = CurrentScene { number, scene: Arc::clone(&model.scene), prepared };
        let _ = self.commands.send(Command::Show(Box::new(scene)));
        model
    }

    /// Requests a frame. One at a time: the window requests the next when this one has arrived, or was
    /// interrupted.
    pub(crate) fn render(&self, request: RenderRequest) {
        // A render thread that has ended has reported why.
        let _ = self.commands.send(Command::Render(Box::new(request)));
    }

    /// Renders the scene with these overrides from now on.
    pub(crate) fn set_overrides(&self, overrides: SceneOverrides) {
        let _ = self.commands.send(Command::SetOverrides(Box::new(overrides)));
    }

    /// Requests the explanation of a pixel. One at a time, too.
    pub(crate) fn explain(&self, view: View, pixel: [u32; 2]) {
        let _ = self.commands.send(Command::Explain(Box::new(view), pixel));
    }

    /// Requests the selected objects alone. One at a time, too.
    pub(crate) fn select(&self, view: View, selected: BTreeSet<usize>) {
        let _ = self.commands.send(Command::Select(Box::new(view), selected));
    }

    /// Requests the surface point at a pixel of a view.
    pub(crate) fn hit_at_pixel(&self, view: View, pixel: [u32; 2]) -> Receiver<Option<PixelHit>> {
        let (reply, received) = channel();
        let _ = self.commands.send(Command::HitAtPixel(Box::new(view), pixel, reply));
        received
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.progress.stop();
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FramePurpose, RenderJob};
    use super::*;
    use luxel::scene::{DVec3, Size, demos};

    const SIZE: Size = Size { width: 96, height: 64 };

    fn model(name: &OsStr) -> Result<Model, String> {
        let name = name.to_string_lossy();
        let scene = demos::demo(&name).ok_or_else(|| format!("{name}: no such file"))?;
        let view = luxel::default_view(&scene, SIZE);
        Ok(Model { pivot: DVec3::ZERO, is_auto_exposed: false, ..Model::fitted(scene, view) })
    }

    #[test]
    fn the_last_request_is_loaded_and_cancelled_ones_send_nothing() {
        // A file that loads until it is cancelled.
        let load = |file: &OsStr, progress: &LoadProgress| {
            while file == "endless" && !progress.is_stopped() {
                std::thread::yield_now();
            }
            model(file)
        };
        let (to, messages) = channel();
        let send = move |message| to.send(message).is_ok();
        let execution = Execution::default();
        let mut worker = Worker::start(load, "endless".into(), execution, send).unwrap();
        worker.load("gone".into()).unwrap();
        let message = messages.recv().unwrap();
        let WorkerMessage { model_number, event: WorkerEvent::Loaded(Err(what)) } = message else {
            panic!("another event")
        };
        assert_eq!((model_number, what.as_str()), (worker.requested(), "gone: no such file"));
        worker.load("endless".into()).unwrap();
        worker.cancel_loading();
        worker.load("plane".into()).unwrap();
        let message = messages.recv().unwrap();
        let WorkerMessage { model_number, event: WorkerEvent::Loaded(Ok(loaded)) } = message else {
            panic!("another event")
        };
        assert_eq!(model_number, worker.requested());
        let view = worker.show(*loaded).view;
        let jobs = vec![RenderJob { view, layer: None }];
        let purpose = FramePurpose::Interactive;
        let selected = BTreeSet::new();
        let is_interrupted = Arc::default();
        worker.render(RenderRequest {
            jobs,
            purpose,
            selected,
            needs_depths: false,
            is_interrupted,
        });
        let message = messages.recv().unwrap();
        let WorkerEvent::Rendered(frame) = message.event else { panic!("another event") };
        assert_eq!((message.model_number, frame.size), (model_number, SIZE));
    }
}
