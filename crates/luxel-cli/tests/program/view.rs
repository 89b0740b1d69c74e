//! `luxel view` without a display, and with invalid arguments.

use crate::program::{Folder, luxel};

#[test]
fn without_a_display_the_error_suggests_alternatives() {
    // The default command is `view`.
    for line in ["view demo:plane", "demo:plane --size 64x48", ""] {
        luxel(line).failed(1, "`luxel view --terminal` and `luxel render` need no display");
    }
}

#[test]
fn a_missing_model_is_an_error_before_the_window_opens() {
    luxel("view nosuch.glb").failed(1, "nosuch.glb");
    luxel("nosuch").failed(1, "nosuch");
    luxel("view demo:plane nosuch.obj").failed(1, "nosuch.obj");
    luxel("view demo:plane /").failed(1, "/: this is a folder");
    luxel("info /").failed(1, "choose a model file in it");
}

#[test]
fn flags_of_the_window_are_checked_before_it_opens() {
    luxel("view --mode walking").failed(2, "no mode `walking`");
    luxel("view demo:plane --replay none.log").failed(1, "none.log");
    luxel("view demo:plane --record no/such/folder.log").failed(1, "another file with --record");
    let folder = Folder::new();
    folder
        .run(["view", "demo:plane", "--record", "."])
        .failed(1, "name a file in it with --record");
    // Nobody can write here.
    #[cfg(target_os = "linux")]
    luxel("view demo:plane --record /proc/a.log").failed(1, "another file with --record");
    folder.run(["view", "demo:plane", "--record", "new.log"]).failed(1, "no window");
    assert!(folder.files().is_empty(), "{:?}", folder.files());
    folder.write("a.log", "luxel-navigation 1\njump\n");
    folder.run(["view", "demo:plane", "--replay", "a.log"]).failed(1, "line 2");
}

#[test]
fn without_a_terminal_the_error_suggests_alternatives() {
    luxel("view demo:plane --terminal").failed(1, "this is not a terminal");
    luxel("view demo:plane --graphics sixel").failed(2, "--terminal");
}

#[test]
fn errors_in_a_key_file_have_their_line_before_the_window_opens() {
    let folder = Folder::new();
    folder.write("keys.toml", "fit = \"g\"\nquit = \"g\"\n");
    for more in [&[][..], &["--terminal"]] {
        let line = [&["view", "demo:plane", "--keys", "keys.toml"], more].concat();
        folder.run(line).failed(1, "keys.toml:2:8: g is bound to `fit` already");
    }
    folder.run(["view", "demo:plane", "--keys", "none.toml"]).failed(1, "none.toml");
}
