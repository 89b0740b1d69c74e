//! Presents frames and guides in the window, and saves them to files.

use super::{App, scale_camera};
use crate::display::Comparison;
use crate::options::{ShownScene, ShownView, ViewerError};
use crate::picture::{
    Depths, Guides, Line, OutlinedIds, PictureDifference, compose, compose_empty, difference_map,
    draw_lines, draw_outlines, join_columns, rgba_of, save_png,
};
use crate::render::{ExplainedPixel, FramePurpose, RenderedFrame};
use crate::selection::Selection;
use crate::session::Session;
use crate::theme::Theme;
use luxel::scene::Size;
use std::time::{Duration, Instant};

/// The guides' lines, with what they depend on.
#[derive(Default)]
pub(super) struct GuideCache {
    key: Option<(Guides, Selection, &'static Theme, usize)>,
    pub(super) lines: Vec<Line>,
}

/// What is drawn over the pictures of a frame.
struct Overlay<'a> {
    theme: &'static Theme,
    comparison: Option<&'a Comparison>,
    lines: &'a [Line],
    pixels_per_point: f32,
}

/// Composes the window's pixels: one picture, two side by side, or their difference, and the guides.
/// Returns the difference's statistics.
fn compose_frame(
    frame: &RenderedFrame,
    overlay: &Overlay<'_>,
    window: Size,
    pixels: &mut Vec<u32>,
) -> Option<PictureDifference> {
    let count = window.width as usize * window.height as usize;
    pixels.resize(count, 0);
    let RenderedFrame { pictures, size, .. } = frame;
    let mut difference = None;
    match (pictures.as_slice(), overlay.comparison) {
        ([one, other], Some(comparison)) if comparison.is_difference => {
            let (colors, statistics) = difference_map(one, other);
            compose((&colors, *size), overlay.theme, window, pixels);
            difference = Some(statistics);
        }
        ([one, other], Some(comparison)) => {
            compose((one, *size), overlay.theme, window, pixels);
            let mut right = vec![0; count];
            compose((other, *size), overlay.theme, window, &mut right);
            let width = window.width as usize;
            let divider = (comparison.divider * width as f32).round().max(0.0) as usize;
            join_columns(pixels, &right, width, divider);
        }
        ([one, ..], _) => compose((one, *size), overlay.theme, window, pixels),
        ([], _) => compose_empty(overlay.theme, window, pixels),
    }
    if let Some(z) = &frame.depths {
        let depths = Depths { z, size: *size };
        let camera = scale_camera(frame.camera, *size, window);
        draw_lines(overlay.lines, &camera, depths, (window, overlay.pixels_per_point), pixels);
    }
    difference
}

/// How long a note is shown.
const NOTE_DURATION: Duration = Duration::from_secs(4);

impl App {
    /// Shows a new frame, or saves a screenshot.
    pub(super) fn frame_rendered(&mut self, mut frame: Box<RenderedFrame>) {
        match frame.purpose {
            FramePurpose::Screenshot => {
                let note = self.save_screenshot(&frame).unwrap_or_else(|what| what);
                self.note(note);
                return;
            }
            FramePurpose::Interactive => {
                if let Some(session) = &self.session {
                    self.scaling.record_frame(frame.size, session.settings.size, frame.seconds);
                    let window = session.settings.size;
                    self.motion.count(f64::from(frame.size.width) / f64::from(window.width));
                }
            }
            FramePurpose::Refining => {}
            FramePurpose::Refined => {
                // The first frame at rest has brought its objects.
                if let Some(first) = self.frame.as_mut().filter(|first| {
                    let is_alike = first.camera == frame.camera && first.size == frame.size;
                    first.purpose == FramePurpose::Refining && is_alike
                }) {
                    frame.visible = frame.visible.take().or_else(|| first.visible.take());
                    frame.selected = frame.selected.take().or_else(|| first.selected.take());
                }
                if let Some(summary) = self.motion.finish() {
                    (self.options.detail)(&summary);
                }
            }
        }
        if let Some(session) = &self.session {
            let scale = f64::from(frame.size.width) / f64::from(session.settings.size.width);
            self.status.frame_time = Some((frame.seconds * 1e3, scale));
        }
        self.frame = Some(frame);
        self.is_base_stale = true;
        self.redraw();
    }

    /// Shows a new explanation of the pixel under the pointer.
    pub(super) fn set_explanation(&mut self, explained: Option<Box<ExplainedPixel>>) {
        self.ui.panels.set_explanation(explained);
        self.redraw();
    }

    /// Saves a frame as a screenshot; returns a notice for the user, or an error.
    pub(super) fn save_screenshot(&self, frame: &RenderedFrame) -> Result<String, String> {
        let size = frame.size;
        let mut pixels = Vec::new();
        let scale = self.surface.as_ref().map_or(1.0, |surface| surface.window.scale_factor());
        let overlay = Overlay {
            theme: self.ui.theme,
            comparison: self.session.as_ref().and_then(Session::comparison),
            lines: &self.guides.lines,
            pixels_per_point: scale as f32,
        };
        compose_frame(frame, &overlay, size, &mut pixels);
        let encoding = self.session.as_ref().map(|session| session.display().view().encoding);
        let encoding = encoding.unwrap_or_default();
        save_png(&self.stem, &rgba_of(&pixels), size, encoding, &self.options.write)
    }

    /// Prints the command line that draws the view, and copies it to the clipboard.
    pub(super) fn copy_command(&mut self) {
        let Some(session) = &self.session else { return };
        let shown = ShownView {
            view: &session.view(),
            lights: session.changed_lights(),
            is_environment_changed: session.is_environment_changed(),
        };
        let command = (self.options.print)(self.files.shown(), &shown);
        let except = match (session.has_surface_changes(), session.display().layer.is_some()) {
            (true, false) => ", without edited materials and hidden objects",
            (false, true) => ", for the picture instead of the layer",
            (true, true) => ", without edited materials, hidden objects and the layer",
            (false, false) => "",
        };
        let note = match self.clipboard.put(&command) {
            Ok(()) => format!("the command is in the clipboard and in the terminal{except}"),
            Err(_) => format!("there is no clipboard: the command is in the terminal{except}"),
        };
        self.note(note);
    }

    /// Saves the scene and the view as a scene file.
    pub(super) fn save_scene(&mut self) {
        let Some(session) = &mut self.session else { return };
        let scene = &session.model.scene;
        let saved = session.material_overrides().surface_changes(scene, &session.objects).and_then(
            |changes| {
                let view = session.view();
                let planes = session.model.planes;
                let shown = ShownScene { scene, view: &view, planes, changes };
                (self.options.save)(self.files.shown(), &shown)
            },
        );
        if saved.is_ok() {
            session.set_saved();
        }
        let is_all = session.selection.hidden().is_empty();
        let note = saved.map(|name| {
            let hidden = if is_all { "" } else { ", hidden objects included" };
            format!("{name} written{hidden}")
        });
        self.note(note.unwrap_or_else(|what| what));
    }

    /// Requests a repaint of the window.
    pub(super) fn redraw(&self) {
        if let Some(surface) = &self.surface {
            surface.window.request_redraw();
        }
    }

    /// Shows a note in the status line, and reports it.
    pub(super) fn note(&mut self, note: String) {
        (self.options.notice)(&note);
        self.status.note = Some(note);
        self.note_until = Some(Instant::now() + NOTE_DURATION);
        self.redraw();
    }

    /// Computes the guides' lines anew if they have changed.
    fn update_guides(&mut self) {
        let Some(session) = &self.session else { return };
        let mut selection = session.selection.clone();
        selection.hovered = None;
        let scene = std::sync::Arc::as_ptr(&session.model.scene) as usize;
        let key = (session.guides, selection, self.ui.theme, scene);
        if self.guides.key.as_ref() != Some(&key) {
            self.guides.lines = session.guides.lines(&session.guide_scene(), self.ui.theme);
            self.guides.key = Some(key);
            self.is_base_stale = true;
        }
    }

    /// Paints the window: the picture and the user interface.
    pub(super) fn paint(&mut self) -> Result<(), ViewerError> {
        self.hover();
        self.update_guides();
        let Some(surface) = &mut self.surface else { return Ok(()) };
        let selection =
            self.session.as_ref().map(|session| session.selection.clone()).unwrap_or_default();
        let (frame, base) = (self.frame.as_deref(), &mut self.base);
        let divider = self.session.as_ref().and_then(|one| Some(one.comparison()?.divider));
        let is_stale = std::mem::take(&mut self.is_base_stale)
            || selection != self.base_selection
            || divider != self.base_divider;
        self.base_divider = divider;
        let comparison = self.session.as_ref().and_then(|session| session.comparison().cloned());
        let lines = &self.guides.lines;
        self.base_selection.clone_from(&selection);
        let (ui, session, status) = (&mut self.ui, self.session.as_mut(), &self.status);
        let theme = ui.theme;
        let pixels_per_point = surface.window.scale_factor() as f32;
        let mut response = (Vec::new(), Duration::MAX);
        let mut difference = ui.difference;
        surface.present(|pixels, window| {
            if is_stale || base.len() != pixels.len() {
                match frame {
                    Some(frame) => {
                        let comparison = comparison.as_ref();
                        let overlay = Overlay { theme, comparison, lines, pixels_per_point };
                        difference = compose_frame(frame, &overlay, window, base);
                        if let Some(visible) = &frame.visible {
                            let alone = frame.selected.as_ref();
                            let alone = alone.and_then(|selected| selected.visible.as_deref());
                            let ids = OutlinedIds { visible, alone, size: frame.size };
                            let style = (theme, pixels_per_point);
                            draw_outlines(&ids, &selection, style, window, base);
                        }
                    }
                    None => {
                        base.resize(pixels.len(), 0);
                        compose_empty(theme, window, base);
                    }
                }
            }
            pixels.copy_from_slice(base);
            ui.difference = difference;
            response = ui.update(session, status, (window, pixels_per_point));
            ui.paint((window, pixels_per_point), pixels);
        })?;
        if let Some(started) = self.started.filter(|_| self.frame.is_some()) {
            self.started = None;
            let milliseconds = started.elapsed().as_millis();
            (self.options.detail)(&format!("the first picture was there after {milliseconds} ms"));
        }
        let (commands, delay) = response;
        self.repaint_at = Instant::now().checked_add(delay);
        if delay.is_zero() {
            self.redraw();
        }
        // The interface may have changed the selection or the divider.
        if self.session.as_ref().is_some_and(|session| {
            session.selection != self.base_selection
                || session.comparison().map(|comparison| comparison.divider) != self.base_divider
        }) {
            self.redraw();
        }
        for command in commands {
            self.execute(command);
        }
        Ok(())
    }
}
