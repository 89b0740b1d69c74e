//! `view` where there is no display, and what it refuses.

use crate::program::{Folder, luxel};

#[test]
fn without_a_display_it_is_said_what_works() {
    // Without a command, it is `view`.
    for line in ["view demo:plane", "demo:plane --size 64x48", ""] {
        luxel(line).failed(1, "`luxel view --terminal` and `luxel render` need no display");
    }
}

#[test]
fn a_model_that_is_not_there_is_told_first() {
    luxel("view nosuch.glb").failed(1, "nosuch.glb");
    luxel("nosuch").failed(1, "nosuch");
    luxel("view demo:plane nosuch.obj").failed(1, "nosuch.obj");
    luxel("view demo:plane /").failed(1, "/: this is a folder");
    luxel("info /").failed(1, "choose a model file in it");
}

#[test]
fn flags_of_the_window_are_checked() {
    luxel("view --mode walking").failed(2, "no mode `walking`");
    luxel("view demo:plane --replay none.log").failed(1, "none.log");
    luxel("view demo:plane --record no/such/folder.log").failed(1, "another place with --record");
    let folder = Folder::new();
    folder
        .run(["view", "demo:plane", "--record", "."])
        .failed(1, "name a file in it with --record");
    // Here, where nothing can be written, whoever tries.
    #[cfg(target_os = "linux")]
    luxel("view demo:plane --record /proc/a.log").failed(1, "another place with --record");
    folder.run(["view", "demo:plane", "--record", "new.log"]).failed(1, "no window");
    assert!(folder.files().is_empty(), "{:?}", folder.files());
    folder.write("a.log", "luxel-navigation 1\njump\n");
    folder.run(["view", "demo:plane", "--replay", "a.log"]).failed(1, "line 2");
}

#[test]
fn without_a_terminal_it_is_said_what_works() {
    luxel("view demo:plane --terminal").failed(1, "this is not a terminal");
    luxel("view demo:plane --graphics sixel").failed(2, "--terminal");
}

#[test]
fn a_wrong_file_of_keys_is_told_with_its_line_before_anything_opens() {
    let folder = Folder::new();
    folder.write("keys.toml", "fit = \"g\"\nquit = \"g\"\n");
    for more in [&[][..], &["--terminal"]] {
        let line = [&["view", "demo:plane", "--keys", "keys.toml"], more].concat();
        folder.run(line).failed(1, "keys.toml:2:8: g is bound to `fit` already");
    }
    folder.run(["view", "demo:plane", "--keys", "none.toml"]).failed(1, "none.toml");
}
