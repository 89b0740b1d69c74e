//! `view` where there is no display, and what it refuses.

use crate::program::{Folder, luxel};

#[test]
fn without_a_display_it_is_said_what_works() {
    // Without a command, it is `view`.
    for line in ["view demo:plane", "demo:plane --size 64x48", ""] {
        luxel(line).failed(1, "`luxel render` draws without a display");
    }
}

#[test]
fn a_model_that_is_not_there_is_told_first() {
    luxel("view nosuch.glb").failed(1, "nosuch.glb");
    luxel("nosuch").failed(1, "nosuch");
    luxel("view demo:plane nosuch.obj").failed(1, "nosuch.obj");
}

#[test]
fn flags_of_the_window_are_checked() {
    luxel("view --mode walking").failed(2, "no mode `walking`");
    luxel("view demo:plane --replay none.log").failed(1, "none.log");
    luxel("view demo:plane --record no/such/folder.log").failed(1, "no/such");
    let folder = Folder::new();
    folder.write("a.log", "luxel-navigation 1\njump\n");
    folder.run(["view", "demo:plane", "--replay", "a.log"]).failed(1, "line 2");
}
