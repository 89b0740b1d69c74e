//! Execution options never change a byte.

use crate::program::Folder;

/// All SIMD levels of the machine.
fn levels() -> Vec<&'static str> {
    luxel::math::SimdLevel::available().into_iter().map(luxel::math::SimdLevel::name).collect()
}

#[track_caller]
fn assert_same_bytes(line: &str) {
    let folder = Folder::new();
    let draw = |flags: &str| {
        folder.run(format!("render {line} -o - {flags}").split_whitespace()).done().stdout
    };
    let first = draw("--threads 1");
    assert!(!first.is_empty());
    for threads in [2, 7] {
        assert!(draw(&format!("--threads {threads}")) == first, "{line}: {threads} threads");
    }
    for level in levels() {
        assert!(draw(&format!("--simd {level}")) == first, "{line}: {level}");
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_a_picture() {
    for name in ["teapot", "spheres", "cornell", "plane"] {
        assert_same_bytes(&format!("demo:{name} --size 203x150"));
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_a_layer() {
    for layer in ["depth", "normal", "triangle", "barycentric"] {
        let flags = format!("--layer {layer} --output-format npy --size 131x97");
        assert_same_bytes(&format!("demo:plane {flags}"));
    }
}

#[test]
fn threads_and_vectors_change_no_byte_of_light_before_it_is_rounded() {
    assert_same_bytes("demo:spheres --output-format npy --size 131x97 --samples 8");
}

/// Runs the program as a user who may have `most` processes; `None` where this test may not.
///
/// The superuser has no such limit, so another user is taken then.
#[cfg(target_os = "linux")]
fn with_processes(folder: &Folder, most: u32, line: &str) -> Option<std::process::Output> {
    let limit = format!("ulimit -u {most}; exec {} {line}", env!("CARGO_BIN_EXE_luxel"));
    let as_user = ["--reuid=65533", "--regid=65533", "--clear-groups"];
    let is_root = std::fs::metadata("/proc/self").ok().is_some_and(|of| {
        use std::os::unix::fs::MetadataExt;
        of.uid() == 0
    });
    let mut command = std::process::Command::new(if is_root { "setpriv" } else { "bash" });
    if is_root {
        command.args(as_user).arg("bash");
    }
    let output = command.arg("-c").arg(&limit).current_dir(folder.path("")).output().ok()?;
    // 126 and 127: that user can't reach the program.
    (!matches!(output.status.code(), Some(126 | 127))).then_some(output)
}

#[cfg(target_os = "linux")]
#[test]
fn without_threads_the_program_works_on_one() {
    let folder = Folder::new();
    let line = "render demo:teapot --size 64x48 -o -";
    let expected = folder.run(line.split_whitespace()).done().stdout;
    for most in [1, 2, 3] {
        for threads in ["", " --threads 4"] {
            let Some(output) = with_processes(&folder, most, &format!("{line}{threads}")) else {
                eprintln!("skipped: no other user can run the program here");
                return;
            };
            let message = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{most} processes{threads}: {message}");
            assert!(output.stdout == expected, "{most} processes{threads}");
        }
    }
}
