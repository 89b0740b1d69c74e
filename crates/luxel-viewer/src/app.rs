//! The window: what happens in it, and what it shows.

mod input;
mod opening;
mod options;
mod pointing;
mod present;

use crate::clipboard::Clipboard;
use crate::files::{Files, WELCOME, Watch};
use crate::loading::Loading;
use crate::marks::Marks;
use crate::model::Model;
use crate::pace::{Pace, Run};
use crate::screen::Screen;
use crate::session::Session;
use crate::sheet::Sheet;
use crate::ui::{OnItsWay, Panels, Status, Ui};
use crate::worker::{Answer, Changes, Drawn, Order, Purpose, Said, Worker};
use luxel::navigation::{Command, Entry, Event};
use luxel::render::View;
use luxel::scene::{Camera, DVec2, DVec3, Size};
use opening::Reading;
pub use options::{
    Options, Outcome, Print, Save, Seen, Showing, ViewerError, WhenInterrupted, Write,
};
use present::GuideLines;
use std::ffi::{OsStr, OsString};
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalPosition};
use winit::event::{ElementState, MouseButton, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoop, EventLoopProxy};
use winit::keyboard::{Key, ModifiersState};
use winit::window::{Window, WindowId};

/// Loads models on threads of their own and shows them, until the user closes the window. `load` says
/// how far it has come, and answers with what went wrong, for the user.
///
/// # Errors
/// [`ViewerError`], if there is no display, or the scene can't be drawn.
pub fn run(
    load: impl Fn(&OsStr, &Loading) -> Result<Model, String> + Send + Sync + 'static,
    options: Options,
) -> Result<Outcome, ViewerError> {
    let no_display = |error: winit::error::EventLoopError| {
        let text = error.to_string();
        // The place in the library's source says nothing to users.
        let text = text.split_once(": ").map_or(text.as_str(), |(_, what)| what).to_owned();
        ViewerError::NoDisplay(text)
    };
    let event_loop = EventLoop::<Call>::with_user_event().build().map_err(no_display)?;
    let proxy: EventLoopProxy<Call> = event_loop.create_proxy();
    let interrupt = proxy.clone();
    (options.when_interrupted)(Box::new(move || interrupt.send_event(Call::Leave).is_ok()));
    let say = move |said| proxy.send_event(Call::Said(said)).is_ok();
    let first = options.files.first().cloned().unwrap_or_default();
    let worker = Worker::start(load, first, options.execution, say)?;
    let mut app = App::new(options, worker);
    event_loop.run_app(&mut app).map_err(no_display)?;
    app.finish()
}

/// What wakes the window, beside its own events.
enum Call {
    Said(Said),
    /// A signal asks the program to end.
    Leave,
}

/// How long nothing may change until the picture sharpens.
const REST: Duration = Duration::from_millis(120);

/// Longer than anyone waits for an event of a log.
const LONGEST: Duration = Duration::from_secs(1 << 30);

/// What a picture shows: the camera, the window's size, the view's revision.
type Asked = (Camera, Size, u64);

struct App {
    options: Options,
    worker: Worker,
    files: Files,
    /// The file that is read now, or was last.
    requested: OsString,
    /// Why a file is being read, if one is.
    reading: Option<Reading>,
    /// The number of the model that is drawn.
    number: u64,
    /// The file that is seen, the one that is read, and when to look at the former.
    watched: Watch,
    coming: Watch,
    next_look: Instant,
    /// The beginning of screenshots' names.
    stem: String,
    screen: Option<Screen>,
    session: Option<Session>,
    pace: Pace,
    run: Run,
    /// When all began, until the first picture is there.
    begun: Option<Instant>,
    /// The picture that is shown.
    shown: Option<Box<Drawn>>,
    /// The last picture asked for, and what for.
    asked: Option<(Asked, Purpose)>,
    /// The picture in the window's size, below what the panels paint.
    below: Vec<u32>,
    is_below_stale: bool,
    /// The marks in it, and the line between two looks.
    marked: Marks,
    divided: Option<f32>,
    /// Lines of the world over it, and what they were made of.
    guides: GuideLines,
    /// What the thread that draws has otherwise than the file.
    changes: Changes,
    ui: Ui,
    status: Status,
    /// When the panels want to be painted again.
    repaint: Option<Instant>,
    /// Up to when a note is shown.
    noted: Option<Instant>,
    is_drawing: bool,
    /// What was last asked to be explained, and whether the answer is still to come.
    explained: Option<(Asked, [u32; 2])>,
    is_explaining: bool,
    wants_screenshot: bool,
    clipboard: Clipboard,
    /// When the camera last changed.
    changed: Instant,
    /// Up to when time has passed for navigation.
    now: Instant,
    /// What is left of the log being played: its next entry, and when that was due to begin.
    playing: Option<(usize, Instant)>,
    pointer: DVec2,
    is_pointer_in: bool,
    modifiers: ModifiersState,
    holding: Option<MouseButton>,
    clicked: Option<(Instant, DVec2)>,
    /// Where the left button went down, as long as it may be a click.
    pressed: Option<DVec2>,
    /// Where the rubber band began.
    band: Option<DVec2>,
    /// What lies under the pointer, for the wheel.
    under: Option<(DVec2, Option<DVec3>)>,
    held: Vec<(Key, Command)>,
    /// The key that shows the ledger as long as it is down, since when, and what was shown before.
    peeking: Option<(Key, Instant, Panels)>,
    end: Option<Result<Outcome, ViewerError>>,
}
impl App {
    fn new(options: Options, worker: Worker) -> Self {
        let now = Instant::now();
        let files = Files::new(options.files.clone());
        let requested = files.asked().to_owned();
        let name = Files::title(&requested);
        let ui = Ui::new(options.theme.theme(None), options.keys.clone());
        let reading = OnItsWay::new(name.clone(), worker.loading().clone());
        let is_chosen = requested != WELCOME.0;
        let status = Status { name, reading: Some(reading), is_chosen, ..Status::default() };
        Self {
            options,
            worker,
            coming: Watch::of(&requested),
            stem: Files::stem(&requested),
            files,
            requested,
            reading: Some(Reading::First),
            number: 0,
            watched: Watch::default(),
            next_look: now,
            screen: None,
            session: None,
            pace: Pace::default(),
            run: Run::default(),
            begun: Some(now),
            shown: None,
            asked: None,
            below: Vec::new(),
            is_below_stale: true,
            marked: Marks::default(),
            divided: None,
            guides: GuideLines::default(),
            changes: Changes::default(),
            ui,
            status,
            repaint: None,
            noted: None,
            is_drawing: false,
            explained: None,
            is_explaining: false,
            wants_screenshot: false,
            clipboard: Clipboard::default(),
            changed: now,
            now,
            playing: None,
            pointer: DVec2::ZERO,
            is_pointer_in: false,
            modifiers: ModifiersState::empty(),
            holding: None,
            clicked: None,
            pressed: None,
            band: None,
            under: None,
            held: Vec::new(),
            peeking: None,
            end: None,
        }
    }

    /// What is left to do when the window is gone.
    fn finish(self) -> Result<Outcome, ViewerError> {
        let log = self.session.as_ref().and_then(Session::log);
        if let (Some(path), Some(log)) = (&self.options.record, log) {
            (self.options.write)(path, log.as_bytes()).map_err(ViewerError::Record)?;
        }
        self.end.unwrap_or(Ok(Outcome::Closed))
    }

    fn end(&mut self, event_loop: &ActiveEventLoop, end: Result<Outcome, ViewerError>) {
        self.end = Some(end);
        event_loop.exit();
    }

    /// The seconds since the last event, to the microsecond, as a log has them.
    fn seconds(&mut self) -> f64 {
        let passed = self.now.elapsed();
        let micros = passed.as_micros() as u64;
        self.now += Duration::from_micros(micros);
        micros as f64 * 1e-6
    }

    /// Something has happened to the camera.
    fn happen(&mut self, event: Event) {
        if self.playing.is_some() {
            return;
        }
        let seconds = self.seconds();
        if let Some(session) = &mut self.session {
            session.happen(event, seconds);
        }
    }

    /// Brings time and picture up to date; when to do so again, if nothing else happens.
    fn pump(&mut self) -> Option<Instant> {
        let due = self.play();
        if self.is_drawing || self.screen.is_none() {
            return due;
        }
        if self.playing.is_none() && self.session.as_ref().is_some_and(|one| one.state.is_moving())
        {
            self.happen(Event::Wait);
        }
        let session = self.session.as_mut()?;
        let changes = session.changes();
        if changes != self.changes {
            self.worker.change(changes.clone());
            self.changes = changes;
            session.changed();
        }
        let view = session.view();
        let wanted = (view.camera, view.size, session.revision());
        if self.wants_screenshot {
            self.wants_screenshot = false;
            let sheets = session.sheets();
            self.draw(sheets, Purpose::File);
            return due;
        }
        match self.asked {
            None => {
                self.asked = Some((wanted, Purpose::Sharp));
                let sheets = session.sheets();
                self.draw(sheets, Purpose::Sharp);
            }
            Some((asked, _)) if asked != wanted => {
                self.changed = Instant::now();
                self.asked = Some((wanted, Purpose::Moving));
                let size = self.pace.moving(view.size);
                let camera = shrunk(view.camera, view.size, size);
                let mut sheets = session.sheets();
                for Sheet { view, .. } in &mut sheets {
                    (view.camera, view.size, view.samples) = (camera, size, 1);
                }
                self.draw(sheets, Purpose::Moving);
            }
            Some((_, Purpose::Moving)) => {
                let rests = self.changed + REST;
                if Instant::now() < rests {
                    return Some(due.map_or(rests, |due| due.min(rests)));
                }
                self.asked = Some((wanted, Purpose::Sharp));
                let sheets = session.sheets();
                self.draw(sheets, Purpose::Sharp);
            }
            Some((asked, Purpose::Sharp | Purpose::File)) => {
                let view = session.view_at(self.pointer.x);
                self.explain(view, asked);
            }
        }
        due
    }

    /// Asks why the pixel under the pointer has its colour, where that is to be seen.
    fn explain(&mut self, view: View, asked: Asked) {
        let Some(pixel) = self.pixel().filter(|_| self.ui.explains()) else { return };
        if self.is_explaining || self.ui.has_pointer() || self.explained == Some((asked, pixel)) {
            return;
        }
        self.explained = Some((asked, pixel));
        self.is_explaining = true;
        self.worker.explain(view, pixel);
    }

    fn draw(&mut self, sheets: Vec<Sheet>, purpose: Purpose) {
        self.is_drawing = true;
        let session = self.session.as_ref();
        let is_marked = session.is_some_and(|session| !session.marks.selected().is_empty());
        let has_lines = session.is_some_and(|session| session.guides.is_any());
        self.worker.draw(Order { sheets, purpose, is_marked, has_lines });
    }

    /// Plays what is due of the log; when the next event is.
    fn play(&mut self) -> Option<Instant> {
        let (Some(log), Some(session)) = (&self.options.replay, &mut self.session) else {
            return None;
        };
        let (mut next, mut begun) = self.playing?;
        let now = Instant::now();
        loop {
            let Some(entry) = log.entries.get(next) else {
                self.playing = None;
                self.now = now;
                return None;
            };
            let due = begun + duration_of(entry);
            if due > now {
                self.playing = Some((next, begun));
                return Some(due);
            }
            session.play(entry);
            (next, begun) = (next + 1, due);
        }
    }
}

impl ApplicationHandler<Call> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.screen.is_some() {
            return;
        }
        let Size { width, height } = self.options.size;
        let attributes = Window::default_attributes()
            .with_title(format!("{} - luxel", self.status.name))
            .with_inner_size(LogicalSize::new(width, height));
        match Screen::open(event_loop, attributes) {
            Ok(screen) => {
                if let Some(session) = &mut self.session {
                    session.resize(screen.size());
                }
                let is_light =
                    screen.window.theme().map(|theme| theme == winit::window::Theme::Light);
                self.ui.dress(self.options.theme.theme(is_light));
                self.screen = Some(screen);
            }
            Err(error) => self.end(event_loop, Err(error)),
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, call: Call) {
        let Call::Said(Said { about, answer }) = call else {
            return self.end(event_loop, Ok(Outcome::Interrupted));
        };
        let is_about_shown = about == self.number;
        match answer {
            // Something else is wanted by now, or nothing.
            Answer::Loaded(_) if about != self.worker.asked() || self.reading.is_none() => {}
            Answer::Loaded(Err(what)) => {
                if !self.not_loaded(what) {
                    self.end(event_loop, Ok(Outcome::NotLoaded));
                }
            }
            Answer::Loaded(Ok(ready)) => self.loaded(*ready),
            Answer::Drawn(drawn) => {
                self.is_drawing = false;
                if is_about_shown {
                    self.drawn(drawn);
                }
                // The next picture is drawn while this one is brought to the window.
                self.pump();
            }
            Answer::Seen(seen) if is_about_shown => {
                if let Some(shown) = &mut self.shown {
                    shown.seen = seen;
                }
                self.is_below_stale = true;
                self.redraw();
            }
            Answer::Seen(_) => {}
            Answer::Explained(explained) => {
                self.is_explaining = false;
                if is_about_shown {
                    self.explained_by(explained);
                }
            }
            Answer::Failed(what) => self.end(event_loop, Err(ViewerError::Draw(what))),
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::Resized(_) => {
                if let (Some(screen), Some(session)) = (&self.screen, &mut self.session) {
                    session.resize(screen.size());
                }
                self.redraw();
            }
            WindowEvent::RedrawRequested => {
                if let Err(error) = self.show() {
                    self.end(event_loop, Err(error));
                }
            }
            WindowEvent::ModifiersChanged(modifiers) => {
                self.modifiers = modifiers.state();
                self.ui.modifiers = egui::Modifiers {
                    alt: self.modifiers.alt_key(),
                    ctrl: self.modifiers.control_key(),
                    shift: self.modifiers.shift_key(),
                    mac_cmd: false,
                    command: self.modifiers.control_key(),
                };
            }
            WindowEvent::ThemeChanged(theme) => {
                let is_light = theme == winit::window::Theme::Light;
                self.ui.dress(self.options.theme.theme(Some(is_light)));
                self.is_below_stale = true;
                self.redraw();
            }
            WindowEvent::DroppedFile(path) => self.open(path),
            WindowEvent::Focused(false) => self.lift_all(),
            WindowEvent::KeyboardInput { event, .. } => {
                if event.state == ElementState::Released {
                    self.lift(&event.logical_key);
                }
                let is_typed = self.is_typed(&event);
                if !is_typed && event.state == ElementState::Pressed {
                    if !event.repeat {
                        self.press(event_loop, event.logical_key);
                    } else if self.ui.shows_help {
                        self.is_for_help(&event.logical_key);
                    }
                }
            }
            WindowEvent::CursorMoved { position: PhysicalPosition { x, y }, .. } => {
                self.pointer = DVec2::new(x, y);
                self.is_pointer_in = true;
                if self.holding.is_some() {
                    self.drag();
                } else {
                    let place = self.pointer_in_points();
                    self.ui.events.push(egui::Event::PointerMoved(place));
                    self.redraw();
                }
            }
            WindowEvent::CursorLeft { .. } => {
                self.is_pointer_in = false;
                self.ui.events.push(egui::Event::PointerGone);
                self.redraw();
            }
            WindowEvent::MouseInput { state: ElementState::Pressed, button, .. } => {
                self.press_button(button);
            }
            WindowEvent::MouseInput { state: ElementState::Released, button, .. } => {
                self.release_button(button);
            }
            WindowEvent::MouseWheel { delta, .. } => self.turn_wheel(delta),
            _ => {}
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let now = Instant::now();
        if self.noted.is_some_and(|until| until <= now) {
            self.noted = None;
            self.status.note = None;
            self.redraw();
        }
        if self.repaint.is_some_and(|when| when <= now) {
            self.repaint = None;
            self.redraw();
        }
        let next =
            [self.pump(), self.watch(), self.noted, self.repaint].into_iter().flatten().min();
        event_loop.set_control_flow(next.map_or(ControlFlow::Wait, ControlFlow::WaitUntil));
    }
}

/// How long an entry of a log takes.
fn duration_of(entry: &Entry) -> Duration {
    match entry {
        Entry::Set(_) => Duration::ZERO,
        Entry::Event { seconds, .. } => Duration::try_from_secs_f64(*seconds).unwrap_or(LONGEST),
    }
}

/// The camera for a smaller picture: only lenses in pixels depend on them.
fn shrunk(mut camera: Camera, from: Size, to: Size) -> Camera {
    use luxel::scene::Lens;
    if let Lens::Intrinsics { fx, fy, cx, cy } = &mut camera.projection.lens {
        let across = f64::from(to.width) / f64::from(from.width);
        let down = f64::from(to.height) / f64::from(from.height);
        (*fx, *cx) = (*fx * across, *cx * across);
        (*fy, *cy) = (*fy * down, *cy * down);
    }
    camera
}
