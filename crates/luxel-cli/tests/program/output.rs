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

#[cfg(unix)]
#[test]
fn a_standard_output_beyond_the_limit_of_the_shell_is_an_error_like_a_full_disk() {
    let folder = Folder::new();
    let many = "o x\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".repeat(100);
    folder.write("many.obj", many);
    for line in ["render demo:teapot --size 640x480 -o -", "info many.obj --json"] {
        let (status, message) = shell(&folder, &format!("ulimit -f 1 && \"$0\" {line} > x"));
        assert_eq!(status, Some(1), "{line}: {message}");
        assert!(message.contains("standard output: "), "{line}: {message}");
    }
}

#[cfg(unix)]
#[test]
fn files_beside_the_model_that_are_pipes_are_errors_and_never_block() {
    let folder = Folder::new();
    let made = std::process::Command::new("mkfifo").arg(folder.path("pipe")).status();
    assert!(made.is_ok_and(|status| status.success()), "mkfifo");
    for line in ["navigate --replay pipe", "render --path pipe -o x.png"] {
        folder.run(line.split(' ')).failed(1, "pipe: this is not a regular file");
    }
    #[cfg(feature = "viewer")]
    folder.run(["view", "--keys", "pipe"]).failed(1, "pipe: this is not a regular file");
    folder.write("m.obj", "mtllib pipe\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let run = folder.run(["info", "m.obj"]).failed(1, "library `pipe` is not read");
    assert!(run.stderr.contains("put a regular file"), "{}", run.stderr);
    assert!(!run.stderr.contains("damaged"), "{}", run.stderr);
}

#[test]
fn the_flags_of_several_models_are_checked_before_any_work() {
    let folder = Folder::new();
    let line = "render demo:plane demo:teapot -o out/{stem}";
    folder.run(line.split(' ')).failed(2, "--output needs an extension");
    assert!(folder.files().is_empty(), "{:?}", folder.files());
}

#[test]
fn layers_of_light_that_nothing_keeps_away_are_warned_of() {
    let folder = Folder::new();
    let size = "render demo:plane --size 16x12 -o x.exr";
    let run = |flags: &str| {
        let run = folder.run(format!("{size} {flags}").split(' '));
        assert_eq!(run.status, Some(0), "{}", run.stderr);
        run.stderr
    };
    let light = "--light directional:dir=0,-1,0:name=sun";
    let both = format!("{light} --layer ao --layer shadow:sun");
    let said = run(&both);
    assert!(said.contains("the layer openness is 1 everywhere"), "{said}");
    assert!(said.contains("the layer shadow:sun is 1 everywhere"), "{said}");
    assert_eq!(run(&format!("{both} --ao --shadows")), "");
    let said = run("--layer ao --ground");
    assert!(said.contains("the layer openness is 1 everywhere"), "{said}");
    let line = format!("{size} {light} --layer shadow:nope");
    folder.run(line.split(' ')).failed(1, "light `nope`: use `sun`");
    let line = format!("{size} --layer ao --layer openness");
    folder.run(line.split(' ')).failed(2, "the layer `openness` is given twice");
}

#[test]
fn environments_that_cannot_be_read_have_a_remedy_of_their_own() {
    let folder = Folder::new();
    let line = |file: &str| format!("render --size 8x8 -o x.png --environment {file}");
    let run = folder.run(line("gone.hdr").split(' ')).failed(1, "gone.hdr");
    assert!(run.stderr.contains("check the name of the environment"), "{}", run.stderr);
    // The largest window that a header can declare.
    let attribute = |name: &str, kind: &str, value: &[u8]| {
        let length = (value.len() as u32).to_le_bytes();
        [name.as_bytes(), b"\0", kind.as_bytes(), b"\0", &length, value].concat()
    };
    let channel = |name: &str| {
        [name.as_bytes(), b"\0", &2_u32.to_le_bytes(), &[0; 4], &[1, 0, 0, 0, 1, 0, 0, 0]].concat()
    };
    let channels = [channel("B"), channel("G"), channel("R"), vec![0]].concat();
    let window = [i32::MIN, i32::MIN, i32::MAX, i32::MAX].map(i32::to_le_bytes).concat();
    let header = [
        &[0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0][..],
        &attribute("channels", "chlist", &channels),
        &attribute("compression", "compression", &[0]),
        &attribute("dataWindow", "box2i", &window),
        &[0],
    ];
    folder.write("huge.exr", header.concat());
    let run = folder.run(line("huge.exr").split(' ')).failed(1, "huge.exr");
    assert!(!run.stderr.contains("0x0"), "{}", run.stderr);
}
