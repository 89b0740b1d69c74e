//! Messages on the standard error, coloured on terminals.

use crate::failure::Failure;
pub(crate) use luxel::report::printable;
use std::io::{IsTerminal, Write};
use std::sync::OnceLock;

/// Which messages appear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Console {
    /// Errors only.
    quiet: bool,
    /// Also the work done, with timings.
    verbose: bool,
}

/// Set when the program starts.
static CURRENT: OnceLock<Console> = OnceLock::new();

/// Bold red, for `error`.
const ERROR: &str = "\x1b[1;31m";
/// Bold yellow, for `warning`.
const WARNING: &str = "\x1b[1;33m";
/// Resets the colour.
const RESET: &str = "\x1b[0m";

impl Console {
    pub(crate) fn new(quiet: bool, verbose: bool) -> Self {
        Self { quiet, verbose }
    }

    /// Makes it the program's console.
    pub(crate) fn into_current(self) -> Self {
        *CURRENT.get_or_init(|| self)
    }

    /// The program's console, for warnings from deep within.
    pub(crate) fn current() -> Self {
        CURRENT.get().copied().unwrap_or(Self { quiet: false, verbose: false })
    }

    /// Prints a warning.
    pub(crate) fn warn(self, message: &str) {
        if !self.quiet {
            print_message("warning", WARNING, &[message]);
        }
    }

    /// Prints a notice of work done.
    pub(crate) fn notice(self, message: &str) {
        if !self.quiet {
            write(&format!("luxel: {}\n", printable(message)));
        }
    }

    /// Prints a message with `--verbose`.
    pub(crate) fn detail(self, message: &str) {
        if self.verbose {
            write(&format!("luxel: {}\n", printable(message)));
        }
    }

    /// Whether a progress bar may appear.
    #[cfg(feature = "progress")]
    pub(crate) fn shows_progress(self) -> bool {
        !self.quiet && std::io::stderr().is_terminal()
    }
}

/// Prints a failure, and returns its status.
pub(crate) fn report(failure: &Failure) -> u8 {
    let lines = failure.lines();
    if !lines.is_empty() {
        error(&lines);
    }
    failure.exit_code()
}

/// Prints an error: the problem and its place on the first line, the remedy below.
pub(crate) fn error(lines: &[&str]) {
    print_message("error", ERROR, lines);
}

fn print_message(kind: &str, color: &str, lines: &[&str]) {
    let (on, off) = if colored() { (color, RESET) } else { ("", "") };
    let mut text = format!("luxel: {on}{kind}:{off} ");
    for (place, line) in lines.iter().enumerate() {
        if place > 0 {
            text.push_str("  ");
        }
        text.push_str(&printable(line));
        text.push('\n');
    }
    write(&text);
}

/// Writes to the standard error; ignores a closed one.
fn write(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Colours need a terminal that supports them and an unset `NO_COLOR`
/// (<https://no-color.org>).
fn colored() -> bool {
    std::io::stderr().is_terminal()
        && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
