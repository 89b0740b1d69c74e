//! `navigate`, and `render --path`: logs of events, played without a display.

use crate::program::{Folder, luxel};
use serde_json::Value;

/// A quarter turn to the right with the rolling ball, then two steps without effect.
const LOG: &str = "\
luxel-navigation 1
# 50 pi pixels over a radius of 100 are a quarter turn
set ball-radius 100
pivot 0 0 0
grab turn 100 300
+0.5 drag 257.07963267948963 300
+0.25 release
";

fn folder_with(log: &str) -> Folder {
    let folder = Folder::new();
    folder.write("hand.log", log);
    folder
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[track_caller]
fn assert_near(found: &[f64], expected: [f64; 16]) {
    assert_eq!(found.len(), 16);
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
}

/// The scene's x becomes -z, z becomes x; the origin stays five units in front of the eye.
const QUARTER: [f64; 16] = [0., 0., -1., 0., 0., 1., 0., 0., 1., 0., 0., 0., 0., 0., -5., 1.];

#[test]
fn a_log_prints_a_line_per_event_that_view_matrix_accepts() {
    let folder = folder_with(LOG);
    let line = "navigate demo:plane --mode rolling-ball --replay hand.log \
                --view-matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5,1";
    let text = folder.run(line.split_whitespace()).text();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 4, "{text}");
    assert_eq!(lines[0], "1,0,0,0,0,1,0,0,0,0,1,0,0,0,-5,1");
    let last: Vec<f64> = lines[3].split(',').map(|number| number.parse().unwrap()).collect();
    assert_near(&last, QUARTER);
    let again = format!("info demo:plane --json --view-matrix {}", lines[3]);
    let again = folder.run(again.split(' ')).json();
    let printed = numbers(&again["camera"]["view_from_world"]);
    assert_eq!(printed, last, "the camera is not the same to the bit");
}

#[test]
fn json_has_the_line_of_each_event_and_the_same_projection() {
    let folder = folder_with(LOG);
    let line = "navigate demo:plane --eye 0,0,5 --target 0,0,0 --mode rolling-ball --json \
                --replay hand.log --near 0.5 --far 20";
    let report = folder.run(line.split_whitespace()).json();
    let events = report["events"].as_array().unwrap();
    let lines: Vec<_> = events.iter().map(|event| event["line"].as_u64().unwrap()).collect();
    assert_eq!(lines, [4, 5, 6, 7]);
    assert_eq!(events[2]["event"], "drag 257.07963267948963 300");
    assert_eq!(events[2]["seconds"], 0.5);
    assert_near(&numbers(&events[3]["view_from_world"]), QUARTER);
    assert_eq!(report["camera"]["view_from_world"], events[3]["view_from_world"]);
    assert_eq!(report["camera"]["clip_from_view"], report["start"]["clip_from_view"]);
}

#[test]
fn every_mode_is_accepted() {
    let folder = folder_with("luxel-navigation 1\ngrab turn 9 9\ndrag 50 20\ntap orbit-left\n");
    for mode in ["absolute", "look-at", "rolling-ball", "flying", "mouselook", "turntable"] {
        let line = format!("navigate demo:plane --mode {mode} --replay hand.log");
        let text = folder.run(line.split(' ')).text();
        let mut lines = text.lines();
        assert_ne!(lines.next(), lines.next(), "{mode}: the hand moves nothing");
    }
    folder
        .run("navigate demo:plane --mode walking --replay hand.log".split(' '))
        .failed(2, "no mode `walking`: use absolute");
}

#[test]
fn errors_in_a_log_have_their_line() {
    let folder = folder_with("luxel-navigation 1\n\njump\n");
    folder
        .run(["navigate", "demo:plane", "--replay", "hand.log"])
        .failed(1, "hand.log: line 3: there is no event `jump`");
    folder.run(["navigate", "--replay", "gone.log"]).failed(1, "gone.log");
    folder.write("none.log", "luxel-navigation 1\nplace 1 0 0 0 0 1 0 0 0 0 1 0 0 nan -5 1\n");
    for line in ["navigate demo:plane --replay", "render demo:plane -o {n}.png --path"] {
        let line = line.split(' ').chain(["none.log"]);
        folder.run(line).failed(1, "none.log: line 2: `nan` is not a finite number");
    }
    let program = env!("CARGO_BIN_EXE_luxel");
    folder.run(["navigate", "--replay", program]).failed(1, "UTF-8");
    folder
        .run_with_input(["navigate", "demo:plane", "--replay", "-"], b"luxel-navigation 3\n")
        .failed(1, "the standard input: line 1: version `3`");
    luxel("navigate").failed(2, "--replay");
}

#[test]
fn a_path_renders_an_image_after_each_event() {
    let folder = folder_with(&LOG.replace("pivot 0 0 0", "mode rolling-ball"));
    let line = "render demo:plane --eye 0,0,5 --target 0,0,0 --size 48x27 --path hand.log --json \
                -o frame_{n:4}.png";
    let report = folder.run(line.split_whitespace()).json();
    let names = ["frame_0000.png", "frame_0001.png", "frame_0002.png", "frame_0003.png"];
    assert_eq!(report["files"], Value::from(names.to_vec()));
    // The image is that of the camera that `navigate` prints.
    assert_eq!(folder.read(names[0]), folder.read(names[1]));
    assert_ne!(folder.read(names[1]), folder.read(names[2]));
    let navigated = "navigate demo:plane --eye 0,0,5 --target 0,0,0 --replay hand.log";
    let text = folder.run(navigated.split(' ')).text();
    let view = text.lines().last().unwrap();
    let line = format!("render demo:plane --size 48x27 -o still.png --view-matrix {view}");
    folder.run(line.split(' ')).done();
    assert_eq!(folder.read("still.png"), folder.read(names[3]));
}

#[test]
fn a_path_with_fps_renders_images_by_time() {
    let folder = folder_with(LOG);
    let line = "render demo:plane --size 16x9 --path hand.log --fps 8 -o {n}.ppm";
    folder.run(line.split(' ')).done();
    // From 0 to 0.75 seconds, each eighth.
    let pictures = folder.files().iter().filter(|name| name.ends_with(".ppm")).count();
    assert_eq!(pictures, 7);
    assert_eq!(folder.read("0.ppm"), folder.read("3.ppm"));
    assert_ne!(folder.read("3.ppm"), folder.read("4.ppm"), "at half a second the hand moves");
}

#[test]
fn paths_without_images_are_refused() {
    let folder = folder_with("luxel-navigation 1\n+1e9 wait\n");
    let render = |flags: &str| {
        let line = format!("render demo:plane --size 4x4 {flags}");
        folder.run(line.split_whitespace())
    };
    render("--path hand.log -o a_{m}.png").failed(2, "one place for the number");
    render("--path hand.log -o -").failed(2, "several images need numbered files");
    render("--path hand.log --turntable 3 -o {n}.png").failed(2, "--turntable");
    render("--fps 3 -o {n}.png").failed(2, "--path");
    render("--path hand.log --fps 30 -o {n}.png").failed(1, "more than 1000000 images");
    folder.write("empty.log", "luxel-navigation 1\nset up 0 0 1\n");
    render("--path empty.log -o {n}.png").failed(1, "no events");
}
