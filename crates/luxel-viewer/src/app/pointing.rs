//! What the pointer is at, and what it selects.

use super::App;
use crate::marks::Choice;
use crate::probe::Under;
use crate::worker::Purpose;
use luxel::navigation::Event;
use luxel::pick::Region;
use luxel::scene::{DVec2, DVec3, Size};
use std::time::Duration;

/// How long the hand waits to know what it has taken hold of.
const PATIENCE: Duration = Duration::from_millis(80);
/// How long a click waits to know what it has met, where the picture doesn't tell yet.
const LONG_PATIENCE: Duration = Duration::from_millis(500);
/// A button that comes up within so many pixels was a click.
const CLICK: f64 = 4.0;

impl App {
    /// The point of the world under the pointer, if that is known soon enough.
    pub(super) fn point_under(&mut self) -> Option<DVec3> {
        if let Some((at, point)) = self.under
            && at == self.pointer
            && self.asked.is_some_and(|(_, purpose)| purpose == Purpose::Moving)
        {
            return point;
        }
        let point = self.probe(PATIENCE)?.map(|found| found.point);
        self.under = Some((self.pointer, point));
        point
    }

    /// What is under the pointer, if that is known in time.
    fn probe(&self, patience: Duration) -> Option<Option<Under>> {
        let answer = self.worker.probe(self.session.as_ref()?.view(), self.pixel()?);
        answer.recv_timeout(patience).ok()
    }

    /// The pixel under the pointer, if it is in the window.
    pub(super) fn pixel(&self) -> Option<[u32; 2]> {
        let Size { width, height } = self.session.as_ref()?.settings.size;
        let (x, y) = (self.pointer.x, self.pointer.y);
        let is_inside = x >= 0.0 && y >= 0.0 && x < f64::from(width) && y < f64::from(height);
        is_inside.then_some([x as u32, y as u32])
    }

    /// The object that the picture shows under the pointer, or that it shows none; `None`, if it isn't
    /// known yet.
    fn object_shown(&self) -> Option<Option<usize>> {
        let shown = self.shown.as_ref()?;
        let seen = shown.seen.as_ref()?;
        let window = self.session.as_ref()?.settings.size;
        let place = |at: u32, of: u32, source: u32| {
            (u64::from(at) * u64::from(source) / u64::from(of.max(1))) as u32
        };
        let [x, y] = self.pixel()?;
        let x = place(x, window.width, shown.size.width);
        let y = place(y, window.height, shown.size.height);
        Some(seen.at(x, y).map(|(object, _)| object))
    }

    /// Marks the object under the pointer, as long as the hand does nothing else.
    pub(super) fn hover(&mut self) {
        let is_free = self.is_pointer_in && self.holding.is_none() && !self.ui.has_pointer();
        let object = if is_free { self.object_shown().flatten() } else { None };
        if let Some(session) = &mut self.session {
            session.marks.hovered = object.filter(|one| !session.marks.hidden().contains(one));
        }
    }

    /// The pointer has moved with a button down.
    pub(super) fn drag(&mut self) {
        if let Some(from) = self.band {
            self.ui.band = Some([self.in_points(from), self.pointer_in_points()]);
            self.redraw();
            return;
        }
        // A hand that shakes while it clicks turns nothing.
        if self.pressed.is_some_and(|from| from.distance(self.pointer) < CLICK) {
            return;
        }
        self.pressed = None;
        self.happen(Event::Drag { at: self.pointer });
    }

    /// Puts an end of the ruler to the point under the pointer, or puts it away.
    pub(super) fn measure(&mut self) {
        if self.ui.has_pointer() || !self.is_pointer_in {
            return;
        }
        // Not known in time: nothing is changed by it.
        let Some(found) = self.probe(LONG_PATIENCE) else { return };
        let Some(session) = &mut self.session else { return };
        session.ruler = session.ruler.with(found.map(|found| found.point));
        let told = session.ruler.told();
        self.note(told);
    }

    /// Selects what is under the pointer.
    pub(super) fn click(&mut self) {
        let found = self.object_shown().or_else(|| {
            let found = self.probe(LONG_PATIENCE)?;
            Some(found.map(|found| found.object))
        });
        let Some(object) = found else { return };
        let keeps = self.modifiers.shift_key() || self.modifiers.control_key();
        let choice = if keeps { Choice::Toggle } else { Choice::Replace };
        if let Some(session) = &mut self.session {
            session.marks.select(object, choice);
        }
        self.redraw();
    }

    /// Selects what is seen within the rubber band; a band without any extent is a click.
    pub(super) fn select_in_band(&mut self, from: DVec2) {
        self.ui.band = None;
        self.redraw();
        if from.distance(self.pointer) < CLICK {
            self.click();
            return;
        }
        let (Some(shown), Some(session)) = (&self.shown, &mut self.session) else { return };
        let Some(seen) = &shown.seen else { return };
        let window = session.settings.size;
        let scale = DVec2::new(
            f64::from(shown.size.width) / f64::from(window.width),
            f64::from(shown.size.height) / f64::from(window.height),
        );
        let low = from.min(self.pointer) * scale;
        let extent = (from - self.pointer).abs() * scale;
        let Ok(region) = Region::rectangle(low.x, low.y, extent.x, extent.y) else { return };
        let objects = seen.in_region(&region).into_iter().map(|hit| hit.object);
        let choice = if self.modifiers.shift_key() { Choice::Add } else { Choice::Replace };
        session.marks.select(objects, choice);
    }
}
