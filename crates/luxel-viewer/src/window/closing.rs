//! What Esc closes: the innermost of what is open, and at last the window.

use super::App;
use crate::keys::{Action, Keys};
use crate::session::Session;
use crate::ui::Ui;
use winit::event_loop::ActiveEventLoop;

/// The effect of Esc.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Closed {
    /// Something is closed.
    Part,
    /// Nothing, because edits would be lost; the note names the keys that save or drop them.
    Nothing(String),
    /// The window.
    Window,
}

/// Closes the innermost of what is open in a session. Text fields and the dialog have handled the key
/// before.
fn close_innermost(ui: &mut Ui, session: &mut Session) -> Closed {
    if std::mem::take(&mut ui.shows_help) {
        return Closed::Part;
    }
    let keys = &ui.keys;
    if session.loses_edits_by_closing() {
        return Closed::Nothing(unsaved(keys, Action::Compare, "closes the other look without"));
    }
    if session.close_innermost() || ui.panels.close_innermost() {
        return Closed::Part;
    }
    if session.has_unsaved_edits() {
        return Closed::Nothing(unsaved(keys, Action::Quit, "quits without"));
    }
    Closed::Window
}

/// The note that edits are not saved, with the keys that save or drop them.
fn unsaved(keys: &Keys, drop: Action, effect: &str) -> String {
    let with = |action: Action, effect: &str| {
        let key = keys.first_of(action);
        (!key.is_empty()).then(|| format!("{key} {effect}"))
    };
    let parts = [with(Action::SaveScene, "saves"), with(drop, effect)];
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    format!("edits are not saved: {}", parts.join(", "))
}

impl App {
    /// Handles Esc, where no text field does.
    pub(super) fn close(&mut self, event_loop: &ActiveEventLoop) {
        let has_model = self.session.is_some();
        // Help lies over everything else.
        if !self.ui.shows_help && (self.cancel_gesture() || (has_model && self.cancel_loading())) {
            return;
        }
        let Some(session) = &mut self.session else { return event_loop.exit() };
        match close_innermost(&mut self.ui, session) {
            Closed::Part => self.redraw(),
            Closed::Nothing(note) => self.note(note),
            Closed::Window => event_loop.exit(),
        }
    }

    /// Ends a drag or a rubber band, if there is one.
    fn cancel_gesture(&mut self) -> bool {
        let is_any = self.held_button.is_some();
        if is_any {
            self.release_all();
            self.redraw();
        }
        is_any
    }

    /// Cancels loading, if a model is being loaded.
    fn cancel_loading(&mut self) -> bool {
        let is_any = self.load_reason.is_some();
        if is_any {
            self.stop_loading();
        }
        is_any
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::theme::DARK;
    use luxel::lighting::K_D;
    use luxel::navigation::Mode;
    use luxel::scene::{DVec3, Size, demos};

    const SIZE: Size = Size { width: 640, height: 360 };

    fn start() -> (Ui, Session) {
        let scene = demos::demo("plane").unwrap();
        let view = luxel::default_view(&scene, SIZE);
        let model = Model { pivot: DVec3::ZERO, ..Model::fitted(scene, view) };
        (Ui::new(&DARK, Keys::default()), Session::new(model, SIZE, Mode::Turntable, false))
    }

    #[test]
    fn esc_closes_what_is_open_from_the_inside_before_the_window() {
        let (mut ui, mut session) = start();
        assert_eq!(close_innermost(&mut ui, &mut session), Closed::Window);
        (ui.shows_help, ui.panels.is_shown, ui.panels.is_narrow) = (true, true, true);
        ui.panels.toggle_explanation();
        session.measurement = session.measurement.with_point(Some(DVec3::ONE));
        session.toggle_difference();
        let mut left = Vec::new();
        for _ in 0..5 {
            assert_eq!(close_innermost(&mut ui, &mut session), Closed::Part);
            left.push([
                ui.shows_help,
                session.measurement != crate::session::Measurement::None,
                session.comparison().is_some(),
                ui.panels.shows_explanation(),
                ui.panels.is_shown,
            ]);
        }
        let expected = [0, 1, 2, 3, 4].map(|closed| [0, 1, 2, 3, 4].map(|part| part > closed));
        assert_eq!(left, expected);
        assert_eq!(close_innermost(&mut ui, &mut session), Closed::Window);
    }

    #[test]
    fn esc_never_loses_edits_and_says_which_keys_save_or_drop_them() {
        for edit in [
            |session: &mut Session| session.change_display(|display| display.remove(0)),
            |session: &mut Session| session.change_display(|one| one.set_enabled(0, false)),
            |session: &mut Session| {
                session.edit_materials(|all| all.edit(0).set_parameter(&K_D, 0.5));
            },
        ] {
            let (mut ui, mut session) = start();
            edit(&mut session);
            for _ in 0..3 {
                let Closed::Nothing(note) = close_innermost(&mut ui, &mut session) else {
                    panic!("edits are lost")
                };
                assert_eq!(note, "edits are not saved: Ctrl s saves, q quits without");
            }
            session.set_saved();
            assert_eq!(close_innermost(&mut ui, &mut session), Closed::Window);
            session.change_display(|display| display.view_mut().ambient = [0.5; 3]);
            assert_ne!(close_innermost(&mut ui, &mut session), Closed::Window);
        }
    }

    #[test]
    fn esc_ends_no_comparison_whose_other_side_has_edits_of_its_own() {
        let (mut ui, mut session) = start();
        session.toggle_comparison();
        session.change_display(|display| display.remove(0));
        session.set_active_side(false);
        let Closed::Nothing(note) = close_innermost(&mut ui, &mut session) else {
            panic!("edits are lost")
        };
        assert!(note.contains("v closes the other look without"), "{note}");
        // The original is in the model's file.
        session.set_active_side(true);
        assert_eq!(close_innermost(&mut ui, &mut session), Closed::Part);
        assert_ne!(close_innermost(&mut ui, &mut session), Closed::Window);
    }
}
