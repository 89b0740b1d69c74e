//! Output files: names, several inputs, and what is there already.

use crate::program::{Folder, SQUARE_PLY};

fn run(folder: &Folder, line: &str) -> crate::program::Run {
    folder.run(line.split_whitespace())
}

#[test]
fn turns_are_numbered_before_the_extension() {
    let folder = Folder::new();
    run(&folder, "render demo:plane --size 8x6 --turntable 3 -o x.png").done();
    assert_eq!(folder.files(), ["x_0.png", "x_1.png", "x_2.png"]);
}

#[test]
fn several_models_are_rendered_by_one_process_each_as_alone() {
    let folder = Folder::new();
    folder.write("a.ply", SQUARE_PLY);
    folder.write("b.toml", "format = \"luxel-scene\"\nversion = 1\n[[models]]\nsource = \"a.ply\"\n[render]\nsize = \"9x5\"\n");
    run(&folder, "render a.ply b.toml demo:plane --samples 1 -o {stem}.png").done();
    assert_eq!(folder.files(), ["a.ply", "a.png", "b.png", "b.toml", "plane.png"]);
    for (model, file) in [("a.ply", "a.png"), ("b.toml", "b.png"), ("demo:plane", "plane.png")] {
        let alone = run(&folder, &format!("render {model} --samples 1 -o -")).done().stdout;
        assert!(folder.read(file) == alone, "{model}: its own settings count, and no others");
    }
}

#[test]
fn a_model_that_fails_does_not_stop_the_rest() {
    let folder = Folder::new();
    folder.write("bad.obj", "f 1 2 3\n");
    let line = "render nosuch.ply bad.obj demo:plane --size 8x6 -o out_{stem}.ppm";
    let run = run(&folder, line).failed(1, "2 of 3 models failed: nosuch.ply, bad.obj");
    assert!(run.stderr.contains("nosuch.ply: No such file"), "{}", run.stderr);
    assert!(run.stderr.contains("bad.obj:1: vertex 3"), "{}", run.stderr);
    assert_eq!(folder.files(), ["bad.obj", "out_plane.ppm"]);
}

#[test]
fn models_that_would_share_a_file_are_wrong_usage_before_any_work() {
    let folder = Folder::new();
    for (line, expected) in [
        ("demo:plane demo:teapot -o x.png", "would both be written to x.png"),
        ("a/x.stl b/x.ply -o {stem}.png", "a/x.stl and b/x.ply would both be written to x.png"),
        ("demo:plane demo:plane -o {stem}.png", "demo:plane is given twice"),
        ("demo:plane demo:teapot -o -", "would both be written to -"),
    ] {
        run(&folder, &format!("render {line}")).failed(2, expected);
    }
    assert!(folder.files().is_empty());
}

#[cfg(unix)]
#[test]
fn a_replaced_file_keeps_its_permissions_and_its_link() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = Folder::new();
    folder.write("real.png", "");
    std::fs::set_permissions(folder.path("real.png"), PermissionsExt::from_mode(0o640)).unwrap();
    symlink("real.png", folder.path("link.png")).unwrap();
    run(&folder, "render demo:plane --size 8x6 -o link.png").done();
    assert!(folder.path("link.png").is_symlink());
    assert!(folder.read("real.png").starts_with(b"\x89PNG"));
    let mode = std::fs::metadata(folder.path("real.png")).unwrap().permissions().mode();
    assert_eq!(mode & 0o777, 0o640);
}

#[test]
fn what_a_killed_run_left_is_removed_and_what_another_is_writing_is_not() {
    let folder = Folder::new();
    folder.write(".x.png.4194303.part", "half a picture");
    folder.write(".x.png.4194302.part", "half a picture");
    folder.write(".x.png.draft.part", "not of luxel");
    folder.write(".y.png.4194303.part", "for another file");
    let at_work = std::fs::File::open(folder.path(".x.png.4194302.part")).unwrap();
    at_work.lock().unwrap();
    run(&folder, "render demo:plane --size 8x6 -o x.png").done();
    let left = [".x.png.4194302.part", ".x.png.draft.part", ".y.png.4194303.part", "x.png"];
    assert_eq!(folder.files(), left);
}

/// Runs a line of a shell, with luxel as `$0`; its status and standard error.
#[cfg(unix)]
pub(crate) fn shell(folder: &Folder, line: &str) -> (Option<i32>, String) {
    let output = std::process::Command::new("sh")
        .args(["-c", line, env!("CARGO_BIN_EXE_luxel")])
        .current_dir(folder.path("."))
        .output()
        .unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[cfg(target_os = "linux")]
#[test]
fn a_picture_that_no_one_receives_is_a_failure() {
    let folder = Folder::new();
    let (status, message) = shell(&folder, "\"$0\" render demo:plane -o - >&-");
    assert_eq!(status, Some(1), "{message}");
    assert!(message.contains("standard output: it is closed"), "{message}");
    let (status, _) = shell(&folder, "\"$0\" render demo:plane -o - > /dev/null");
    assert_eq!(status, Some(0));
}

#[cfg(unix)]
#[test]
fn a_file_beyond_the_limit_of_the_shell_is_an_error_like_a_full_disk() {
    let folder = Folder::new();
    let line = "ulimit -f 1 && \"$0\" render demo:teapot --size 640x480 -o x.png";
    let (status, message) = shell(&folder, line);
    assert_eq!(status, Some(1), "{message}");
    assert!(message.contains("x.png: can't be written"), "{message}");
    assert!(folder.files().is_empty(), "{:?}", folder.files());
}
