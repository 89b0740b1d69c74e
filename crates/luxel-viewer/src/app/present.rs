//! What the window shows, and what of it is kept in files.

use super::{App, Seen, Showing, ViewerError, shrunk};
use crate::compare::{Apart, Split, heat, join};
use crate::compose::{compose, empty};
use crate::guides::Guides;
use crate::lines::{Depths, Line, draw};
use crate::marks::Marks;
use crate::outline::outline;
use crate::probe::Explained;
use crate::session::Session;
use crate::snapshot::{keep, rgba_of};
use crate::theme::Theme;
use crate::worker::{Drawn, Purpose};
use luxel::report::ledger_lines;
use luxel::scene::Size;
use std::time::{Duration, Instant};

/// Lines of the world, with what they were made of.
#[derive(Default)]
pub(super) struct GuideLines {
    made_of: Option<(Guides, Marks, &'static Theme, usize)>,
    pub(super) lines: Vec<Line>,
}

/// What lies over pictures.
struct Over<'a> {
    theme: &'static Theme,
    split: Option<&'a Split>,
    lines: &'a [Line],
    pixels_per_point: f32,
}

/// Makes the window's pixels of what was drawn: one picture, two side by side, or how far they are
/// apart, with lines of the world.
fn picture(drawn: &Drawn, over: &Over<'_>, window: Size, pixels: &mut Vec<u32>) -> Option<Apart> {
    let count = window.width as usize * window.height as usize;
    pixels.resize(count, 0);
    let Drawn { pictures, size, .. } = drawn;
    let mut apart = None;
    match (pictures.as_slice(), over.split) {
        ([one, other], Some(split)) if split.is_difference => {
            let (colors, how_far) = heat(one, other);
            compose((&colors, *size), over.theme, window, pixels);
            apart = Some(how_far);
        }
        ([one, other], Some(split)) => {
            compose((one, *size), over.theme, window, pixels);
            let mut right = vec![0; count];
            compose((other, *size), over.theme, window, &mut right);
            let width = window.width as usize;
            join(pixels, &right, width, (split.at * width as f32).round().max(0.0) as usize);
        }
        ([one, ..], _) => compose((one, *size), over.theme, window, pixels),
        ([], _) => empty(over.theme, window, pixels),
    }
    if let Some(z) = &drawn.depths {
        let depths = Depths { z, size: *size };
        // A camera in pixels is one for the window's, too.
        let camera = shrunk(drawn.camera, *size, window);
        draw(over.lines, &camera, depths, (window, over.pixels_per_point), pixels);
    }
    apart
}

/// How long a note is shown.
const NOTED: Duration = Duration::from_secs(4);

impl App {
    pub(super) fn drawn(&mut self, drawn: Box<Drawn>) {
        match drawn.purpose {
            Purpose::File => {
                let note = self.keep(&drawn).unwrap_or_else(|what| what);
                self.note(note);
                return;
            }
            Purpose::Moving => {
                if let Some(session) = &self.session {
                    self.pace.learn(drawn.size, session.settings.size, drawn.seconds);
                    let window = session.settings.size;
                    self.run.count(f64::from(drawn.size.width) / f64::from(window.width));
                }
            }
            Purpose::Sharp => {
                if let Some(told) = self.run.told() {
                    (self.options.detail)(&told);
                }
            }
        }
        if let Some(session) = &self.session {
            let part = f64::from(drawn.size.width) / f64::from(session.settings.size.width);
            self.status.drawn = Some((drawn.seconds * 1e3, part));
        }
        self.shown = Some(drawn);
        self.is_below_stale = true;
        self.redraw();
    }

    /// Why the pixel under the pointer has its colour is known.
    pub(super) fn explained_by(&mut self, explained: Option<Box<Explained>>) {
        let surface = explained.as_ref().and_then(|one| one.surface());
        self.ui.equation = surface.map(ledger_lines);
        self.ui.explanation = explained;
        self.redraw();
    }

    /// Writes what is seen into the first file that isn't there yet.
    pub(super) fn keep(&self, drawn: &Drawn) -> Result<String, String> {
        let size = drawn.size;
        let mut pixels = Vec::new();
        let scale = self.screen.as_ref().map_or(1.0, |screen| screen.window.scale_factor());
        let over = Over {
            theme: self.ui.theme,
            split: self.session.as_ref().and_then(Session::split),
            lines: &self.guides.lines,
            pixels_per_point: scale as f32,
        };
        picture(drawn, &over, size, &mut pixels);
        let encoding = self.session.as_ref().map(|session| session.look().view().encoding);
        let encoding = encoding.unwrap_or_default();
        keep(&self.stem, &rgba_of(&pixels), size, encoding, &self.options.write)
    }

    /// Prints the line of a terminal that draws what is seen, and puts it into the clipboard.
    pub(super) fn copy_line(&mut self) {
        let Some(session) = &self.session else { return };
        let seen = Seen {
            view: &session.view(),
            lights: session.changed_lights(),
            is_environment_changed: session.is_environment_changed(),
        };
        let line = (self.options.print)(self.files.seen(), &seen);
        let but = match (session.is_redressed(), session.look().layer.is_some()) {
            (true, false) => ", but for materials changed here and what is hidden",
            (false, true) => ", of the picture and not of the layer",
            (true, true) => ", but for materials changed here, what is hidden, and the layer",
            (false, false) => "",
        };
        let note = match self.clipboard.put(&line) {
            Ok(()) => format!("its line is in the clipboard and in the terminal{but}"),
            Err(_) => format!("there is no clipboard: its line is in the terminal{but}"),
        };
        self.note(note);
    }

    /// Saves what is seen as a scene file.
    pub(super) fn save(&mut self) {
        let Some(session) = &self.session else { return };
        let scene = &session.model.scene;
        let saved = session.wardrobe().said(scene, &session.objects).and_then(|changes| {
            let view = session.view();
            let planes = session.model.planes;
            let showing = Showing { scene, view: &view, planes, changes };
            (self.options.save)(self.files.seen(), &showing)
        });
        let is_all = session.marks.hidden().is_empty();
        let note = saved.map(|name| {
            let but = if is_all { "" } else { ", with what is hidden" };
            format!("{name} written{but}")
        });
        self.note(note.unwrap_or_else(|what| what));
    }

    pub(super) fn redraw(&self) {
        if let Some(screen) = &self.screen {
            screen.window.request_redraw();
        }
    }

    pub(super) fn note(&mut self, note: String) {
        (self.options.tell)(&note);
        self.status.note = Some(note);
        self.noted = Some(Instant::now() + NOTED);
        self.redraw();
    }

    /// Makes the lines of the world that are to be seen, if they are others than before.
    fn draw_guides(&mut self) {
        let Some(session) = &self.session else { return };
        let mut marks = session.marks.clone();
        marks.hovered = None;
        let scene = std::sync::Arc::as_ptr(&session.model.scene) as usize;
        let made_of = (session.guides, marks, self.ui.theme, scene);
        if self.guides.made_of.as_ref() != Some(&made_of) {
            self.guides.lines = session.guides.lines(&session.subject(), self.ui.theme);
            self.guides.made_of = Some(made_of);
            self.is_below_stale = true;
        }
    }

    /// Paints the window: the picture, and what lies over it.
    pub(super) fn show(&mut self) -> Result<(), ViewerError> {
        self.hover();
        self.draw_guides();
        let Some(screen) = &mut self.screen else { return Ok(()) };
        let marks = self.session.as_ref().map(|session| session.marks.clone()).unwrap_or_default();
        let (shown, below) = (self.shown.as_deref(), &mut self.below);
        let divided = self.session.as_ref().and_then(|one| Some(one.split()?.at));
        let is_stale = std::mem::take(&mut self.is_below_stale)
            || marks != self.marked
            || divided != self.divided;
        self.divided = divided;
        let split = self.session.as_ref().and_then(|session| session.split().cloned());
        let lines = &self.guides.lines;
        self.marked.clone_from(&marks);
        let (ui, session, status) = (&mut self.ui, self.session.as_mut(), &self.status);
        let theme = ui.theme;
        let pixels_per_point = screen.window.scale_factor() as f32;
        let mut asked = (Vec::new(), Duration::MAX);
        let mut apart = ui.apart;
        screen.present(|pixels, window| {
            if is_stale || below.len() != pixels.len() {
                match shown {
                    Some(drawn) => {
                        let split = split.as_ref();
                        let over = Over { theme, split, lines, pixels_per_point };
                        apart = picture(drawn, &over, window, below);
                        if let Some(seen) = &drawn.seen {
                            let style = (theme, pixels_per_point);
                            outline((seen, drawn.size), &marks, style, window, below);
                        }
                    }
                    None => {
                        below.resize(pixels.len(), 0);
                        empty(theme, window, below);
                    }
                }
            }
            pixels.copy_from_slice(below);
            ui.apart = apart;
            asked = ui.show(session, status, (window, pixels_per_point), pixels);
        })?;
        if let Some(begun) = self.begun.filter(|_| self.shown.is_some()) {
            self.begun = None;
            let milliseconds = begun.elapsed().as_millis();
            (self.options.detail)(&format!("the first picture was there after {milliseconds} ms"));
        }
        let (wishes, again) = asked;
        self.repaint = Instant::now().checked_add(again);
        if again.is_zero() {
            self.redraw();
        }
        // A click in the tree, the line between two looks.
        if self.session.as_ref().is_some_and(|session| {
            session.marks != self.marked || session.split().map(|split| split.at) != self.divided
        }) {
            self.redraw();
        }
        for wish in wishes {
            self.grant(wish);
        }
        Ok(())
    }
}
