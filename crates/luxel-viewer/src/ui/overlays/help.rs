//! The help: what mouse and keys do.

use crate::keys::{Action, BINDINGS, Binding, Keys, MODES};
use crate::theme;
use crate::ui::focus;
use egui::{Align2, Context, Frame, Margin, Stroke, vec2};
use luxel::navigation::Mode;
use winit::keyboard::NamedKey;

/// What the mouse does in a mode.
fn mouse(mode: Mode) -> Vec<(&'static str, &'static str)> {
    let turn = match mode {
        Mode::Flying => "steer",
        Mode::Mouselook => "look around",
        _ => "turn",
    };
    let mut rows = vec![
        ("click", "select"),
        ("shift + click", "select more, or less"),
        ("ctrl + left drag", "select in a rectangle"),
        ("left drag", turn),
        ("shift + left, middle", "pan"),
        ("right drag", "zoom"),
        ("wheel", "zoom to the pointer"),
    ];
    // The others turn about the eye.
    if !matches!(mode, Mode::Flying | Mode::Mouselook) {
        rows.push(("double click", "turn about that point"));
    }
    rows
}

/// The bindings that act, described: files are stepped through only if there are several.
fn bindings(has_files: bool) -> impl Iterator<Item = &'static Binding> {
    BINDINGS.iter().filter(move |binding| {
        let acts = has_files || !matches!(binding.action(), Action::StepFile(_));
        acts && !binding.about.is_empty()
    })
}

/// The width of three columns, in points, and the room below which there are two, or one.
const WIDE: f32 = 960.0;
const NARROW: f32 = 860.0;
const NARROWEST: f32 = 620.0;

/// The distance that a key scrolls the help, in points.
pub(crate) fn help_scroll_step(key: NamedKey) -> Option<f32> {
    const LINE: f32 = 20.0;
    const PAGE: f32 = 240.0;
    const ALL: f32 = 1e5;
    Some(match key {
        NamedKey::ArrowDown => LINE,
        NamedKey::ArrowUp => -LINE,
        NamedKey::PageDown | NamedKey::Space => PAGE,
        NamedKey::PageUp => -PAGE,
        NamedKey::End => ALL,
        NamedKey::Home => -ALL,
        _ => return None,
    })
}

/// Shows the help of a mode, scrolled on by a distance in points.
pub(crate) fn help(context: &Context, (mode, has_files): (Mode, bool), keys: &Keys, scroll: f32) {
    let theme = theme::of(context);
    let frame = Frame::new().fill(theme.panel).corner_radius(4).inner_margin(Margin::same(20));
    let frame = frame.stroke(Stroke::new(1.0, theme.line));
    let area = egui::Area::new("help".into())
        .sense(egui::Sense::hover())
        .anchor(Align2::CENTER_CENTER, vec2(0.0, -14.0));
    let rows: Vec<_> = bindings(has_files)
        .map(|binding| (keys.of(binding.action()), binding.about.to_owned()))
        .filter(|(keys, _)| !keys.is_empty())
        .collect();
    let mouse = mouse(mode).into_iter().map(|(keys, what)| (keys.to_owned(), what.to_owned()));
    let mouse: Vec<_> = mouse.collect();
    let modes: Vec<_> = MODES.map(|one| (keys.of(Action::Mode(one)), one.to_string())).into();
    let modes_title = format!("Ways to navigate ({}: the next)", keys.of(Action::NextMode));
    let motions = keys.motions(mode);
    let held = |ui: &mut egui::Ui| {
        ui.colored_label(theme.heading, format!("Held, in {mode}"));
        pairs(ui, &motions);
    };
    let hand = |ui: &mut egui::Ui| {
        table(ui, "Mouse", &mouse);
        ui.add_space(12.0);
        table(ui, &modes_title, &modes);
    };
    let room = (context.content_rect().size() - vec2(80.0, 108.0)).max(vec2(160.0, 48.0));
    area.order(egui::Order::Foreground).show(context, |ui| {
        frame.show(ui, |ui| {
            ui.set_width(WIDE.min(room.x));
            ui.set_max_height(room.y);
            let scrolled = focus::scrolled(ui).max_height(room.y);
            scrolled.show(ui, |ui| {
                if scroll != 0.0 {
                    ui.scroll_with_delta(vec2(0.0, -scroll));
                }
                if room.x < NARROWEST {
                    hand(ui);
                    ui.add_space(12.0);
                    table(ui, "Keys", &rows);
                    ui.add_space(12.0);
                    held(ui);
                    return;
                }
                if room.x < NARROW {
                    ui.columns(2, |columns| {
                        let [left, right] = columns else { return };
                        hand(left);
                        left.add_space(12.0);
                        held(left);
                        table(right, "Keys", &rows);
                    });
                    return;
                }
                let (first, second) = rows.split_at(rows.len().div_ceil(2));
                ui.columns(3, |columns| {
                    let [left, middle, right] = columns else { return };
                    hand(left);
                    table(middle, "Keys", first);
                    table(right, " ", second);
                    right.add_space(12.0);
                    held(right);
                });
            });
        });
    });
}

fn table(ui: &mut egui::Ui, title: &str, rows: &[(String, String)]) {
    ui.colored_label(theme::of(ui.ctx()).heading, title);
    // Rows aren't clickable and may be close.
    ui.spacing_mut().interact_size.y = 18.0;
    egui::Grid::new(title).num_columns(2).spacing([16.0, 2.0]).show(ui, |ui| {
        for (keys, what) in rows {
            ui.monospace(keys);
            ui.weak(what);
            ui.end_row();
        }
    });
}

/// Two keys with their motions in each row.
fn pairs(ui: &mut egui::Ui, motions: &[(String, &str)]) {
    ui.spacing_mut().interact_size.y = 18.0;
    egui::Grid::new("held").num_columns(4).spacing([12.0, 2.0]).show(ui, |ui| {
        for pair in motions.chunks(2) {
            for (key, what) in pair {
                ui.monospace(key);
                ui.weak(*what);
            }
            ui.end_row();
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::projection::WindowPart;
    use crate::session::Session;
    use luxel::navigation::{Event, Gesture};
    use luxel::scene::{DMat4, DVec2, DVec3, Size, demos};

    const SIZE: Size = Size { width: 640, height: 360 };

    /// A session with a tilted camera, off the middle.
    fn session(mode: Mode) -> Session {
        let scene = demos::demo("teapot").unwrap();
        let mut view = luxel::default_view(&scene, SIZE);
        let tilt = DMat4::from_rotation_z(0.4) * DMat4::from_translation(DVec3::new(0.3, 0.1, 0.0));
        view.camera.view_from_world = tilt * view.camera.view_from_world;
        let pivot = scene.bounds().centre() + 0.1;
        let model = Model { pivot, ..Model::fitted(scene, view) };
        let mut session = Session::new(model, SIZE, mode, false);
        session.set_number(luxel::navigation::Number::Transition, 0.0);
        session
    }

    /// Whether something changes the camera, or the speed of flying, shortly after.
    fn acts(mode: Mode, act: impl Fn(&mut Session)) -> bool {
        let cameras = [false, true].map(|is_done| {
            let mut session = session(mode);
            if is_done {
                act(&mut session);
            }
            session.navigate(Event::Wait, 0.1);
            session.camera()
        });
        cameras[0] != cameras[1]
    }

    fn drag(session: &mut Session, gesture: Gesture) {
        let at = DVec2::new(300.0, 200.0);
        session.navigate(Event::Grab { gesture, at, point: None }, 0.0);
        session.navigate(Event::Drag { at: at + DVec2::new(30.0, -20.0) }, 0.01);
        session.navigate(Event::Release, 0.01);
    }

    #[test]
    fn every_key_of_the_help_acts_in_its_mode() {
        let keys = Keys::default();
        let whole = WindowPart::whole(SIZE);
        for mode in MODES {
            for (key, motion) in keys.motions(mode) {
                let command = motion.parse().unwrap();
                let tap = |session: &mut Session| {
                    session.navigate(Event::Tap { command, steps: 1.0 }, 0.0);
                };
                assert!(acts(mode, tap), "{key} ({motion}) does nothing in {mode}");
            }
            for binding in bindings(true) {
                let does = |session: &mut Session| match binding.action() {
                    Action::View(view) => session.navigate(Event::View(view), 0.0),
                    Action::Level => session.navigate(Event::Level, 0.0),
                    Action::Fit => session.fit_selected(whole, 0.0),
                    Action::FitAll => session.fit(whole, 0.0),
                    Action::ToggleLens => session.toggle_lens(0.0),
                    _ => {}
                };
                let is_of_camera = matches!(
                    binding.action(),
                    Action::View(_)
                        | Action::Level
                        | Action::Fit
                        | Action::FitAll
                        | Action::ToggleLens
                );
                assert!(!is_of_camera || acts(mode, does), "{} in {mode}", binding.name);
            }
        }
    }

    #[test]
    fn the_help_lists_what_the_mouse_does_in_its_mode_and_nothing_else() {
        for mode in MODES {
            let rows = mouse(mode);
            for gesture in [Gesture::Turn, Gesture::Pan, Gesture::Zoom] {
                assert!(acts(mode, |session| drag(session, gesture)), "{gesture:?} in {mode}");
            }
            // Whether the point of a double click changes how the camera turns.
            let turned = [false, true].map(|is_done| {
                let mut session = session(mode);
                if is_done {
                    session.navigate(Event::Pivot(DVec3::ZERO), 0.0);
                }
                drag(&mut session, Gesture::Turn);
                session.state.view_from_world()
            });
            let is_listed = rows.iter().any(|(keys, _)| *keys == "double click");
            assert_eq!(is_listed, turned[0] != turned[1], "{mode}");
        }
    }

    #[test]
    fn files_are_stepped_through_only_if_there_are_several() {
        let steps = |has_files| {
            let is_step = |one: &&Binding| matches!(one.action(), Action::StepFile(_));
            bindings(has_files).filter(is_step).count()
        };
        assert_eq!((steps(false), steps(true)), (0, 2));
    }
}
