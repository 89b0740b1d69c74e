//! What Esc closes inside of panels.

use super::*;

#[test]
fn a_list_that_has_popped_up_is_closed_alone() {
    let mut stage = Stage::new("teapot", (920, 900));
    stage.pass(Vec::new());
    stage.pass(Vec::new());
    assert!(!stage.ui.close_popup());
    // The colour of O_d and the list of reflection models, by the mouse: neither has keyboard focus.
    let is_list = |rect: &Rect| rect.width() > 150.0 && rect.left() > 700.0;
    let is_color = |rect: &Rect| rect.width() < 30.0 && rect.left() > 690.0 && rect.top() > 60.0;
    for is_wanted in [&is_list as &dyn Fn(&Rect) -> bool, &is_color] {
        let controls = stage.controls();
        let mut opened = 0;
        for (_, rect) in controls.iter().filter(|(_, rect)| is_wanted(rect)) {
            stage.click(rect.center());
            stage.pass(Vec::new());
            if stage.ui.close_popup() {
                opened += 1;
                stage.pass(Vec::new());
                assert!(!stage.ui.close_popup(), "it doesn't close");
            }
        }
        assert!(opened > 0, "nothing pops up");
    }
    assert!(stage.ui.panels.is_shown);
}

#[test]
fn esc_closes_the_dialog_alone() {
    let mut stage = Stage::new("teapot", (920, 900));
    stage.ui.shows_help = true;
    stage.ui.dialog = Some(PathCompletion::beside("demo:plane".as_ref()));
    stage.pass(Vec::new());
    stage.press(Key::Escape);
    assert!(stage.ui.dialog.is_none());
    assert!(stage.ui.shows_help && stage.ui.panels.is_shown && !stage.ui.has_keyboard());
}
