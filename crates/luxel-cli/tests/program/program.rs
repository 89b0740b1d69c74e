//! Runs the program in a temporary folder.

use serde_json::Value;
use std::ffi::OsStr;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder that is removed with the test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("luxel-{}-{number}", std::process::id());
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    /// The names of all files, in order.
    pub(crate) fn files(&self) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(&self.0)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    pub(crate) fn run<S: AsRef<OsStr>>(&self, args: impl IntoIterator<Item = S>) -> Run {
        self.run_with_input(args, b"")
    }

    pub(crate) fn run_with_input<S: AsRef<OsStr>>(
        &self,
        args: impl IntoIterator<Item = S>,
        input: &[u8],
    ) -> Run {
        let mut child = Command::new(env!("CARGO_BIN_EXE_luxel"))
            .args(args)
            .current_dir(&self.0)
            // Tests never open a window on the developer's desktop.
            .env_remove("DISPLAY")
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        // The program may close its end early.
        let _ = child.stdin.take().unwrap().write_all(input);
        let output = child.wait_with_output().unwrap();
        Run {
            status: output.status.code(),
            stdout: output.stdout,
            stderr: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// The result of a run.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) status: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
}

impl Run {
    /// Asserts success without messages; returns the output.
    #[track_caller]
    pub(crate) fn done(self) -> Self {
        assert_eq!(self.status, Some(0), "{}", self.stderr);
        assert_eq!(self.stderr, "");
        self
    }

    /// Asserts an exit status, one message that contains `expected`, and nothing
    /// on the standard output.
    #[track_caller]
    pub(crate) fn failed(self, status: i32, expected: &str) -> Self {
        let message = &self.stderr;
        assert_eq!(self.status, Some(status), "{message}");
        assert!(message.starts_with("luxel: error: "), "{message}");
        assert!(message.contains(expected), "`{expected}` is not in: {message}");
        for word in ["panicked", "backtrace", "RUST_BACKTRACE", "bug in luxel"] {
            assert!(!message.contains(word), "{message}");
        }
        assert!(self.stdout.is_empty(), "an error belongs on the standard error");
        self
    }

    #[track_caller]
    pub(crate) fn text(self) -> String {
        String::from_utf8(self.done().stdout).unwrap()
    }

    /// The one JSON document on the standard output.
    #[track_caller]
    pub(crate) fn json(self) -> Value {
        serde_json::from_slice(&self.done().stdout).unwrap()
    }
}

/// Runs the program in a temporary folder, which must stay empty.
#[track_caller]
pub(crate) fn luxel(line: &str) -> Run {
    let folder = Folder::new();
    let run = folder.run(line.split_whitespace());
    assert!(folder.files().is_empty(), "files are left behind: {:?}", folder.files());
    run
}

/// A square of two triangles from (0, 0) to (1, 1), facing +Z.
pub(crate) const SQUARE_PLY: &str = "\
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
";
