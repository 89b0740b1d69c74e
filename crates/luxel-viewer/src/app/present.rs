//! What the window shows, and what of it is kept in files.

use super::{App, ViewerError};
use crate::compose::{compose, empty};
use crate::outline::outline;
use crate::worker::{Drawn, Purpose};
use luxel::render::{PictureFormat, write_rgba8};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How long a note is shown.
const NOTED: Duration = Duration::from_secs(4);

impl App {
    pub(super) fn drawn(&mut self, drawn: Box<Drawn>) {
        self.is_drawing = false;
        match drawn.purpose {
            Purpose::File => {
                let note = self.keep(&drawn).unwrap_or_else(|what| what);
                self.note(note);
                return;
            }
            Purpose::Moving => {
                if let Some(session) = &self.session {
                    self.pace.learn(drawn.size, session.settings.size, drawn.seconds);
                }
            }
            Purpose::Sharp => {}
        }
        if let Some(session) = &self.session {
            let part = f64::from(drawn.size.width) / f64::from(session.settings.size.width);
            self.status.drawn = Some((drawn.seconds * 1e3, part));
        }
        self.shown = Some(drawn);
        self.is_below_stale = true;
        self.redraw();
    }

    /// Writes what is seen into the first file that isn't there yet.
    pub(super) fn keep(&self, drawn: &Drawn) -> Result<String, String> {
        let size = drawn.size;
        let mut pixels = vec![0; size.width as usize * size.height as usize];
        compose(&drawn.pixels, size, size, &mut pixels);
        let rgba: Vec<_> = pixels
            .iter()
            .map(|pixel: &u32| {
                let [_, r, g, b] = pixel.to_be_bytes();
                [r, g, b, 255]
            })
            .collect();
        let encoding = self.session.as_ref().map(|session| session.model.view.encoding);
        let mut bytes = Vec::new();
        write_rgba8(PictureFormat::Png, size, &rgba, encoding.unwrap_or_default(), &mut bytes)
            .map_err(|error| error.to_string())?;
        let name = |number: u32| PathBuf::from(format!("{}-{number}.png", self.stem));
        let free = (1..).map(name).find(|path| !path.exists());
        let path = free.ok_or("no name is free for a picture")?;
        (self.options.write)(&path, &bytes)?;
        Ok(format!("{} written", path.display()))
    }

    /// Prints the line of a terminal that draws what is seen.
    pub(super) fn print_line(&mut self) {
        let Some(session) = &self.session else { return };
        (self.options.print)(self.files.seen(), &session.view());
        let note = if session.is_edited() {
            "its line is in the terminal, but for lights changed here and what is hidden"
        } else {
            "its line is in the terminal"
        };
        self.note(note.to_owned());
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

    /// Paints the window: the picture, and what lies over it.
    pub(super) fn show(&mut self) -> Result<(), ViewerError> {
        self.hover();
        let Some(screen) = &mut self.screen else { return Ok(()) };
        let marks = self.session.as_ref().map(|session| session.marks.clone()).unwrap_or_default();
        let (shown, below) = (self.shown.as_deref(), &mut self.below);
        let is_stale = std::mem::take(&mut self.is_below_stale) || marks != self.marked;
        self.marked.clone_from(&marks);
        let (ui, session, status) = (&mut self.ui, self.session.as_mut(), &self.status);
        let pixels_per_point = screen.window.scale_factor() as f32;
        let mut asked = (Vec::new(), Duration::MAX);
        screen.present(|pixels, window| {
            if is_stale || below.len() != pixels.len() {
                below.resize(pixels.len(), 0);
                match shown {
                    Some(drawn) => {
                        compose(&drawn.pixels, drawn.size, window, below);
                        if let Some(seen) = &drawn.seen {
                            outline((seen, drawn.size), &marks, pixels_per_point, window, below);
                        }
                    }
                    None => empty(window, below),
                }
            }
            pixels.copy_from_slice(below);
            asked = ui.show(session, status, (window, pixels_per_point), pixels);
        })?;
        let (wishes, again) = asked;
        self.repaint = Instant::now().checked_add(again);
        if again.is_zero() {
            self.redraw();
        }
        // A click in the tree.
        if self.session.as_ref().is_some_and(|session| session.marks != self.marked) {
            self.redraw();
        }
        for wish in wishes {
            self.grant(wish);
        }
        Ok(())
    }
}
