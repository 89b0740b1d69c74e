//! The window: its state, and the event loop that runs it.

mod clipboard;
mod closing;
mod events;
mod input;
mod opening;
mod pointing;
mod present;
mod schedule;
mod surface;

use crate::model::{FileList, FileWatch, LoadProgress, Model, WELCOME};
use crate::options::{Options, Outcome, ViewerError};
use crate::render::{
    FramePurpose, MotionStats, RenderedFrame, ResolutionScaling, SceneOverrides, Worker,
    WorkerMessage,
};
use crate::selection::Selection;
use crate::session::Session;
use crate::ui::{PanelLayout, PendingModel, Status, Ui};
use clipboard::Clipboard;
use luxel::navigation::{Command, Event};
use luxel::scene::{Camera, DVec2, DVec3, Size};
use opening::LoadReason;
use present::GuideCache;
use std::ffi::{OsStr, OsString};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};
use surface::WindowSurface;
use winit::event::MouseButton;
use winit::event_loop::{ActiveEventLoop, EventLoop, EventLoopProxy};
use winit::keyboard::{Key, ModifiersState};

/// Opens a window, loads models on threads of their own and shows them until the user closes the window.
/// `load` reports its progress and returns errors for the user.
///
/// # Errors
/// [`ViewerError`], if there is no display, or the scene can't be drawn.
pub fn run(
    load: impl Fn(&OsStr, &LoadProgress) -> Result<Model, String> + Send + Sync + 'static,
    options: Options,
) -> Result<Outcome, ViewerError> {
    let no_display = |error: winit::error::EventLoopError| {
        let text = error.to_string();
        // Without the position in the library's source, which means nothing to users.
        let text = text.split_once(": ").map_or(text.as_str(), |(_, what)| what).to_owned();
        ViewerError::NoDisplay(text)
    };
    let event_loop = EventLoop::<UserEvent>::with_user_event().build().map_err(no_display)?;
    let proxy: EventLoopProxy<UserEvent> = event_loop.create_proxy();
    let interrupt = proxy.clone();
    (options.on_interrupt)(Box::new(move || interrupt.send_event(UserEvent::Quit).is_ok()));
    let send = move |message| proxy.send_event(UserEvent::Worker(message)).is_ok();
    let first = options.files.first().cloned().unwrap_or_default();
    let worker = Worker::start(load, first, options.execution, send)?;
    let mut app = App::new(options, worker);
    event_loop.run_app(&mut app).map_err(no_display)?;
    app.finish()
}

/// An event from outside the window system.
enum UserEvent {
    Worker(WorkerMessage),
    /// A signal ends the program.
    Quit,
}

/// What a frame shows: the camera, the window's size, the view's revision.
type FrameKey = (Camera, Size, u64);

/// The window's state.
struct App {
    options: Options,
    worker: Worker,
    surface: Option<WindowSurface>,
    session: Option<Session>,
    ui: Ui,
    status: Status,
    clipboard: Clipboard,

    files: FileList,
    /// The file requested last.
    requested_file: OsString,
    /// Why a file is being loaded, if one is.
    load_reason: Option<LoadReason>,
    /// The number of the model on display.
    model_number: u64,
    /// Watches of the file on display and of the requested one, and the time of the next poll.
    shown_watch: FileWatch,
    requested_watch: FileWatch,
    next_poll: Instant,
    /// The stem of screenshots.
    stem: String,

    scaling: ResolutionScaling,
    motion: MotionStats,
    /// The window's start, until the first frame is presented.
    started: Option<Instant>,
    /// The frame on display.
    frame: Option<Box<RenderedFrame>>,
    /// The frame requested last.
    last_request: Option<(FrameKey, FramePurpose)>,
    is_rendering: bool,
    /// Interrupts the frame at rest that was requested last.
    is_interrupted: Arc<AtomicBool>,
    wants_screenshot: bool,
    /// The overrides that the render thread applies.
    overrides: SceneOverrides,
    /// The explanation requested last, and whether it is pending.
    explain_request: Option<(FrameKey, [u32; 2])>,
    is_explaining: bool,
    /// Whether the selected objects alone are pending.
    is_selecting: bool,
    /// When the camera last moved.
    moved_at: Instant,
    /// The time up to which navigation has advanced.
    navigated_until: Instant,
    /// The next entry of the log being replayed, and the time when it starts.
    replay: Option<(usize, Instant)>,

    /// The picture in the window's size, below the panels.
    base: Vec<u32>,
    is_base_stale: bool,
    /// The selection and the divider in it.
    base_selection: Selection,
    base_divider: Option<f32>,
    /// The guides in it.
    guides: GuideCache,
    /// When the panels are repainted without an event.
    repaint_at: Option<Instant>,
    /// When the present note disappears.
    note_until: Option<Instant>,

    pointer: DVec2,
    is_pointer_in: bool,
    modifiers: ModifiersState,
    held_button: Option<MouseButton>,
    last_click: Option<(Instant, DVec2)>,
    /// Where the left button was pressed, as long as it may be a click.
    press_position: Option<DVec2>,
    /// The first corner of the rubber band.
    band_start: Option<DVec2>,
    /// The point under the pointer, cached for the wheel.
    pointer_hit: Option<(DVec2, Option<DVec3>)>,
    held_keys: Vec<(Key, Command)>,
    /// The key that shows the explanation while held, when it was pressed, and the layout to restore.
    peek: Option<(Key, Instant, PanelLayout)>,

    outcome: Option<Result<Outcome, ViewerError>>,
}

impl App {
    fn new(options: Options, worker: Worker) -> Self {
        let now = Instant::now();
        let files = FileList::new(options.files.clone());
        let requested_file = files.requested().to_owned();
        let name = FileList::title(&requested_file);
        let ui = Ui::new(options.theme.theme(None), options.keys.clone());
        let pending = PendingModel::new(name.clone(), worker.progress().clone());
        let is_chosen = requested_file != WELCOME.0;
        let status = Status { name, loading: Some(pending), is_chosen, ..Status::default() };
        Self {
            options,
            worker,
            surface: None,
            session: None,
            ui,
            status,
            clipboard: Clipboard::default(),
            requested_watch: FileWatch::of(&requested_file),
            stem: FileList::stem(&requested_file),
            files,
            requested_file,
            load_reason: Some(LoadReason::First),
            model_number: 0,
            shown_watch: FileWatch::default(),
            next_poll: now,
            scaling: ResolutionScaling::default(),
            motion: MotionStats::default(),
            started: Some(now),
            frame: None,
            last_request: None,
            is_rendering: false,
            is_interrupted: Arc::default(),
            wants_screenshot: false,
            overrides: SceneOverrides::default(),
            explain_request: None,
            is_explaining: false,
            is_selecting: false,
            moved_at: now,
            navigated_until: now,
            replay: None,
            base: Vec::new(),
            is_base_stale: true,
            base_selection: Selection::default(),
            base_divider: None,
            guides: GuideCache::default(),
            repaint_at: None,
            note_until: None,
            pointer: DVec2::ZERO,
            is_pointer_in: false,
            modifiers: ModifiersState::empty(),
            held_button: None,
            last_click: None,
            press_position: None,
            band_start: None,
            pointer_hit: None,
            held_keys: Vec::new(),
            peek: None,
            outcome: None,
        }
    }

    /// Writes the log after the window has closed.
    fn finish(self) -> Result<Outcome, ViewerError> {
        let log = self.session.as_ref().and_then(Session::log);
        if let (Some(path), Some(log)) = (&self.options.record, log) {
            (self.options.write)(path, log.as_bytes()).map_err(ViewerError::Record)?;
        }
        self.outcome.unwrap_or(Ok(Outcome::Closed))
    }

    fn end(&mut self, event_loop: &ActiveEventLoop, outcome: Result<Outcome, ViewerError>) {
        self.outcome = Some(outcome);
        event_loop.exit();
    }

    /// The seconds since the last event, to the microsecond, the precision of a log.
    fn seconds(&mut self) -> f64 {
        let passed = self.navigated_until.elapsed();
        let micros = passed.as_micros() as u64;
        self.navigated_until += Duration::from_micros(micros);
        micros as f64 * 1e-6
    }

    /// Handles a navigation event; none while a log is replayed.
    fn navigate(&mut self, event: Event) {
        if self.replay.is_some() {
            return;
        }
        let seconds = self.seconds();
        if let Some(session) = &mut self.session {
            session.navigate(event, seconds);
        }
    }
}

/// The camera for a picture of another size: intrinsics are in pixels.
fn scale_camera(mut camera: Camera, from: Size, to: Size) -> Camera {
    use luxel::scene::Lens;
    if let Lens::Intrinsics { fx, fy, cx, cy } = &mut camera.projection.lens {
        let across = f64::from(to.width) / f64::from(from.width);
        let down = f64::from(to.height) / f64::from(from.height);
        (*fx, *cx) = (*fx * across, *cx * across);
        (*fy, *cy) = (*fy * down, *cy * down);
    }
    camera
}
