//! Picking under the pointer: hover, click, rubber band, measurement.

use super::App;
use crate::render::{FramePurpose, PixelHit};
use crate::selection::SelectMode;
use luxel::navigation::Event;
use luxel::pick::Region;
use luxel::scene::{DVec2, DVec3, Size};
use std::sync::atomic::Ordering;
use std::time::Duration;

/// The longest wait for the point that a gesture grabs.
const GRAB_TIMEOUT: Duration = Duration::from_millis(80);
/// The longest wait for the object under a click, before the frame's visible objects are known.
const CLICK_TIMEOUT: Duration = Duration::from_millis(500);
/// The largest movement of a click, in pixels.
const CLICK_DISTANCE: f64 = 4.0;

impl App {
    /// The point in world space under the pointer, if it is known in time.
    pub(super) fn point_under(&mut self) -> Option<DVec3> {
        if let Some((at, point)) = self.pointer_hit
            && at == self.pointer
            && self.last_request.is_some_and(|(_, purpose)| purpose == FramePurpose::Interactive)
        {
            return point;
        }
        let point = self.hit_under_pointer(GRAB_TIMEOUT)?.map(|found| found.point);
        self.pointer_hit = Some((self.pointer, point));
        point
    }

    /// The surface point under the pointer; the outer `None` if it isn't known in time.
    fn hit_under_pointer(&self, timeout: Duration) -> Option<Option<PixelHit>> {
        // A frame at rest can wait, the hand can't.
        self.is_interrupted.store(true, Ordering::Relaxed);
        let reply =
            self.worker.hit_at_pixel(self.session.as_ref()?.view(), self.pixel_under_pointer()?);
        reply.recv_timeout(timeout).ok()
    }

    /// The pixel under the pointer, if it is inside the window.
    pub(super) fn pixel_under_pointer(&self) -> Option<[u32; 2]> {
        let Size { width, height } = self.session.as_ref()?.settings.size;
        let (x, y) = (self.pointer.x, self.pointer.y);
        let is_inside = x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height);
        is_inside.then_some([x as u32, y as u32])
    }

    /// The object that the frame shows under the pointer, or none; the outer `None` if the frame's visible
    /// objects aren't known yet.
    fn object_under_pointer(&self) -> Option<Option<usize>> {
        let frame = self.frame.as_ref()?;
        let visible = frame.visible.as_ref()?;
        let window = self.session.as_ref()?.settings.size;
        let scaled = |at: u32, of: u32, source: u32| {
            (u64::from(at) * u64::from(source) / u64::from(of.max(1))) as u32
        };
        let [x, y] = self.pixel_under_pointer()?;
        let x = scaled(x, window.width, frame.size.width);
        let y = scaled(y, window.height, frame.size.height);
        Some(visible.at(x, y).map(|(object, _)| object))
    }

    /// Marks the object under the pointer as hovered, unless a button is held.
    pub(super) fn hover(&mut self) {
        let is_free = self.is_pointer_in && self.held_button.is_none() && !self.ui.has_pointer();
        let object = if is_free { self.object_under_pointer().flatten() } else { None };
        if let Some(session) = &mut self.session {
            session.selection.hovered =
                object.filter(|one| !session.selection.hidden().contains(one));
        }
    }

    /// Handles pointer movement with a button held.
    pub(super) fn drag(&mut self) {
        if let Some(from) = self.band_start {
            self.ui.band = Some([self.in_points(from), self.pointer_in_points()]);
            self.redraw();
            return;
        }
        // Small movements belong to a click.
        if self.press_position.is_some_and(|from| from.distance(self.pointer) < CLICK_DISTANCE) {
            return;
        }
        self.press_position = None;
        self.navigate(Event::Drag { at: self.pointer });
    }

    /// Adds the point under the pointer to the measurement.
    pub(super) fn measure(&mut self) {
        if self.ui.has_pointer() || !self.is_pointer_in {
            return;
        }
        // A point that isn't known in time changes nothing.
        let Some(found) = self.hit_under_pointer(CLICK_TIMEOUT) else { return };
        let Some(session) = &mut self.session else { return };
        session.measurement = session.measurement.with_point(found.map(|found| found.point));
        let summary = session.measurement.summary();
        self.note(summary);
    }

    /// Selects the object under the pointer.
    pub(super) fn click(&mut self) {
        let found = self.object_under_pointer().or_else(|| {
            let found = self.hit_under_pointer(CLICK_TIMEOUT)?;
            Some(found.map(|found| found.object))
        });
        let Some(object) = found else { return };
        let toggles = self.modifiers.shift_key() || self.modifiers.control_key();
        let mode = if toggles { SelectMode::Toggle } else { SelectMode::Replace };
        if let Some(session) = &mut self.session {
            session.selection.select(object, mode);
        }
        self.redraw();
    }

    /// Selects the objects visible in the rubber band; a band without extent is a click.
    pub(super) fn select_in_band(&mut self, from: DVec2) {
        self.ui.band = None;
        self.redraw();
        if from.distance(self.pointer) < CLICK_DISTANCE {
            self.click();
            return;
        }
        let (Some(frame), Some(session)) = (&self.frame, &mut self.session) else { return };
        let Some(visible) = &frame.visible else { return };
        let window = session.settings.size;
        let scale = DVec2::new(
            f64::from(frame.size.width) / f64::from(window.width),
            f64::from(frame.size.height) / f64::from(window.height),
        );
        let low = from.min(self.pointer) * scale;
        let extent = (from - self.pointer).abs() * scale;
        let Ok(region) = Region::rectangle(low.x, low.y, extent.x, extent.y) else { return };
        let objects = visible.in_region(&region).into_iter().map(|hit| hit.object);
        let mode = if self.modifiers.shift_key() { SelectMode::Add } else { SelectMode::Replace };
        session.selection.select(objects, mode);
    }
}
