//! Fitting into the part of the window that no panel covers.

use super::Session;
use crate::model::Model;
use crate::projection::WindowPart;
use luxel::navigation::Event;
use luxel::scene::{Bounds, Camera, DMat4, DVec3, Lens, Size, fit_along, fit_box};

/// Fits something into a part of a window, seen in the direction of a view, by a function that fits it
/// into a whole one. Returns the view and the lens of the whole window. Orthographic lenses keep their
/// height; a height of 0 becomes the one that fits.
fn fitted(
    view: &DMat4,
    lens: Lens,
    (part, window): (WindowPart, Size),
    fit: impl Fn([DVec3; 3], Lens, Size) -> Camera,
) -> (DMat4, Lens) {
    let axes = [0, 1, 2].map(|row| view.row(row).truncate());
    let of_part = fit(axes, part.lens(lens, window), part.size);
    let lens = match of_part.projection.lens {
        Lens::Orthographic { height } => {
            let by_part = f64::from(window.height) / f64::from(part.size.height.max(1));
            Lens::Orthographic { height: height * by_part }
        }
        _ => lens,
    };
    let shift = DMat4::from_translation(part.shift(lens, window));
    (shift * of_part.view_from_world, lens)
}

impl Model {
    /// Fits the first view into a part of the window, unless the file or the user has placed its camera.
    pub(crate) fn fit_into(&mut self, part: WindowPart, window: Size) {
        if self.is_fitted {
            let Camera { view_from_world, projection } = self.view.camera;
            let fit = |axes, lens, size| fit_along(&self.scene, axes, lens, size);
            let (view, _) = fitted(&view_from_world, projection.lens, (part, window), fit);
            self.view.camera.view_from_world = view;
        }
    }
}

impl Session {
    /// Fits the whole scene into a part of the window, along the present direction.
    pub(crate) fn fit(&mut self, part: WindowPart, seconds: f64) {
        let (scene, bounds) = (self.model.scene.clone(), self.settings.bounds);
        let pivot = if bounds.is_empty() { self.state.pivot() } else { bounds.centre() };
        self.go_to_fitted(part, pivot, seconds, |axes, lens, size| {
            fit_along(&scene, axes, lens, size)
        });
    }

    /// Fits bounds into a part of the window; empty ones change nothing.
    pub(crate) fn fit_bounds(&mut self, bounds: &Bounds, part: WindowPart, seconds: f64) {
        if !bounds.is_empty() {
            self.go_to_fitted(part, bounds.centre(), seconds, |axes, lens, size| {
                fit_box(bounds, axes, lens, size)
            });
        }
    }

    /// Fits the selected objects into a part of the window; without a selection, all visible ones.
    pub(crate) fn fit_selected(&mut self, part: WindowPart, seconds: f64) {
        let (selected, hidden) = (self.selection.selected(), self.selection.hidden());
        if selected.is_empty() && hidden.is_empty() {
            self.fit(part, seconds);
            return;
        }
        let wanted = (0..self.objects.len()).filter(|object| {
            if selected.is_empty() { !hidden.contains(object) } else { selected.contains(object) }
        });
        let bounds = wanted.fold(Bounds::EMPTY, |all, object| all.union(&self.bounds(object)));
        self.fit_bounds(&bounds, part, seconds);
    }

    fn go_to_fitted(
        &mut self,
        part: WindowPart,
        pivot: DVec3,
        seconds: f64,
        fit: impl Fn([DVec3; 3], Lens, Size) -> Camera,
    ) {
        let window = self.settings.size;
        let lens = match self.settings.lens {
            Lens::Orthographic { .. } => Lens::Orthographic { height: 0.0 },
            lens => lens,
        };
        let view = self.state.view_from_world();
        let (view_from_world, lens) = fitted(&view, lens, (part, window), fit);
        let scale = match (lens, self.settings.lens) {
            (Lens::Orthographic { height: fitted }, Lens::Orthographic { height }) => {
                fitted / height
            }
            _ => 1.0,
        };
        self.navigate(Event::Go { view_from_world, pivot, scale }, seconds);
    }
}
