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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::projection::project_point;
    use luxel::navigation::Mode;
    use luxel::scene::demos;

    const WINDOW: Size = Size { width: 800, height: 600 };
    /// As a panel at the right and the status line leave it.
    const PART: WindowPart =
        WindowPart { left: 40, top: 0, size: Size { width: 430, height: 572 } };

    fn model(lens: Lens) -> Model {
        let scene = demos::demo("teapot").unwrap();
        let mut view = luxel::default_view(&scene, WINDOW);
        view.camera.projection.lens = lens;
        Model { is_auto_exposed: false, ..Model::fitted(scene, view) }
    }

    fn lenses() -> [Lens; 3] {
        [
            Lens::Perspective { fov_y_radians: 0.8 },
            Lens::Intrinsics { fx: 700.0, fy: 690.0, cx: 350.0, cy: 320.0 },
            Lens::Orthographic { height: 3.0 },
        ]
    }

    /// How the model lies in the part: its middle, and how much of it it fills, across and down.
    fn place(session: &Session) -> ([f64; 2], [f64; 2]) {
        let camera = session.camera();
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for object in &session.objects {
            let mesh = &session.model.scene.meshes[object.mesh.index()];
            for position in &mesh.positions {
                let local = mesh.origin + DVec3::from(position.map(f64::from));
                let point = object.world_from_mesh.matrix().transform_point3(local);
                let at = project_point(&camera, WINDOW, point).unwrap();
                (low, high) = (low.min(at), high.max(at));
            }
        }
        let corner = DVec3::new(f64::from(PART.left), f64::from(PART.top), 0.0);
        let size = DVec3::new(f64::from(PART.size.width), f64::from(PART.size.height), 1.0);
        let middle = ((low + high) * 0.5 - corner) / size;
        let extent = (high - low) / size;
        ([middle.x, middle.y], [extent.x, extent.y])
    }

    fn assert_fitted(session: &Session, what: &str) {
        let (middle, extent) = place(session);
        let is_centred = middle.iter().all(|at| (at - 0.5).abs() < 0.02);
        assert!(is_centred, "{what}: the middle is at {middle:?} of the part");
        let filled = extent[0].max(extent[1]);
        assert!((filled - 0.8).abs() < 0.02, "{what}: it fills {extent:?} of the part");
    }

    #[test]
    fn the_model_is_fitted_into_what_the_panels_leave() {
        for lens in lenses() {
            let mut session = Session::new(model(lens), WINDOW, Mode::Turntable, false);
            session.fit(PART, 0.0);
            session.navigate(Event::Wait, 10.0);
            assert_fitted(&session, &format!("{lens:?}"));
            // The box of an object is larger than its silhouette.
            let all = 0..session.objects.len();
            session.selection.select(all, crate::selection::SelectMode::Replace);
            session.fit_selected(PART, 0.0);
            session.navigate(Event::Wait, 10.0);
            let (middle, extent) = place(&session);
            assert!(middle.iter().all(|at| (at - 0.5).abs() < 0.1), "{lens:?}: {middle:?}");
            let filled = extent[0].max(extent[1]);
            assert!((0.4..0.81).contains(&filled), "{lens:?}: {extent:?}");
        }
    }

    #[test]
    fn the_first_view_is_fitted_into_what_the_panels_leave_unless_it_is_placed() {
        for lens in lenses() {
            let mut fitted = model(lens);
            let before = fitted.view.camera;
            fitted.fit_into(PART, WINDOW);
            let session = Session::new(fitted, WINDOW, Mode::Turntable, false);
            match lens {
                // The height is the user's.
                Lens::Orthographic { .. } => {
                    assert!(place(&session).0.iter().all(|at| (at - 0.5).abs() < 0.02));
                }
                _ => assert_fitted(&session, &format!("{lens:?}")),
            }
            let mut placed = Model { is_fitted: false, ..model(lens) };
            placed.fit_into(PART, WINDOW);
            assert_eq!(placed.view.camera, before);
        }
    }
}
