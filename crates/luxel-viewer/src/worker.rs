//! The thread that loads and draws, so that the window answers all the while.

use crate::model::Model;
use crate::probe::point_under;
use luxel::render::{At, Execution, Explanation, Renderer, View};
use luxel::scene::{DVec3, Size};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Instant;

/// What the thread has to say.
pub(crate) enum Answer {
    /// The model is there, or isn't; whoever has tried to load it knows why.
    Loaded(Option<Box<Model>>),
    /// A picture.
    Drawn(Box<Drawn>),
    /// Why a pixel has its colour; nothing, if it can't be told.
    Explained(Option<Box<Explanation>>),
    /// The scene can't be drawn, or a view.
    Failed(String),
}

/// A picture of the scene.
pub(crate) struct Drawn {
    pub(crate) pixels: Vec<[u8; 4]>,
    pub(crate) size: Size,
    pub(crate) purpose: Purpose,
    /// What it took.
    pub(crate) seconds: f64,
}

/// What a picture is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Purpose {
    /// To be seen while the camera moves.
    Moving,
    /// To be seen at rest.
    Sharp,
    /// To be kept as a file.
    File,
}

/// What the thread is asked for.
enum Request {
    Draw(Box<View>, Purpose),
    Explain(Box<View>, [u32; 2]),
    Probe(Box<View>, [u32; 2], Sender<Option<DVec3>>),
}

/// The thread's other end. It ends when this goes away.
pub(crate) struct Worker {
    requests: Sender<Request>,
}

impl Worker {
    /// Loads a model and then draws what it is asked for, one after the other. `answer` wakes the
    /// window; once it says no, the thread ends.
    ///
    /// # Errors
    /// The system's, if it gives no thread.
    pub(crate) fn start(
        load: impl FnOnce() -> Option<Model> + Send + 'static,
        execution: Execution,
        answer: impl Fn(Answer) -> bool + Send + 'static,
    ) -> std::io::Result<Self> {
        let (requests, received) = channel();
        std::thread::Builder::new().name("luxel-draw".to_owned()).spawn(move || {
            let Some(model) = load() else {
                answer(Answer::Loaded(None));
                return;
            };
            let scene = model.scene.clone();
            if !answer(Answer::Loaded(Some(Box::new(model)))) {
                return;
            }
            match Renderer::new(&scene, &execution) {
                Ok(renderer) => work(&renderer, &received, answer),
                Err(error) => {
                    answer(Answer::Failed(error.to_string()));
                }
            }
        })?;
        Ok(Self { requests })
    }

    /// Asks for a picture. One at a time: the window asks for the next when this one has come.
    pub(crate) fn draw(&self, view: View, purpose: Purpose) {
        // A thread that is gone has said why.
        let _ = self.requests.send(Request::Draw(Box::new(view), purpose));
    }

    /// Asks why a pixel has its colour. One at a time, too.
    pub(crate) fn explain(&self, view: View, pixel: [u32; 2]) {
        let _ = self.requests.send(Request::Explain(Box::new(view), pixel));
    }

    /// Asks for the point of the world under a pixel of a view.
    pub(crate) fn probe(&self, view: View, pixel: [u32; 2]) -> Receiver<Option<DVec3>> {
        let (answer, received) = channel();
        let _ = self.requests.send(Request::Probe(Box::new(view), pixel, answer));
        received
    }
}

fn work(renderer: &Renderer<'_>, requests: &Receiver<Request>, answer: impl Fn(Answer) -> bool) {
    while let Ok(request) = requests.recv() {
        let is_heard = match request {
            Request::Draw(view, purpose) => {
                let start = Instant::now();
                answer(match renderer.rgba8(&view) {
                    Ok(picture) => Answer::Drawn(Box::new(Drawn {
                        pixels: picture.pixels,
                        size: picture.size,
                        purpose,
                        seconds: start.elapsed().as_secs_f64(),
                    })),
                    Err(error) => Answer::Failed(error.to_string()),
                })
            }
            Request::Explain(view, pixel) => {
                let explanation = renderer.explain(&view, At::Pixel(pixel)).ok();
                answer(Answer::Explained(explanation.map(Box::new)))
            }
            // Who has asked may not wait any more.
            Request::Probe(view, pixel, to) => {
                let _ = to.send(point_under(renderer, &view, pixel));
                true
            }
        };
        if !is_heard {
            return;
        }
    }
}
