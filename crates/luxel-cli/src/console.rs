//! What the program says on the standard error, and how it looks on a terminal.

pub(crate) use luxel::report::printable;
use std::io::{IsTerminal, Write};

/// How much is said.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Console {
    /// Errors only.
    quiet: bool,
    /// What is done and how long it takes, too.
    verbose: bool,
}

/// Bold red, for `error`.
const ERROR: &str = "\x1b[1;31m";
/// Bold yellow, for `warning`.
const WARNING: &str = "\x1b[1;33m";
/// Back to normal.
const RESET: &str = "\x1b[0m";

impl Console {
    pub(crate) fn new(quiet: bool, verbose: bool) -> Self {
        Self { quiet, verbose }
    }

    /// Something was left out or replaced.
    pub(crate) fn warn(self, message: &str) {
        if !self.quiet {
            say("warning", WARNING, &[message]);
        }
    }

    /// Something was done that is worth a line.
    #[cfg(feature = "viewer")]
    pub(crate) fn tell(self, message: &str) {
        if !self.quiet {
            write(&format!("luxel: {}\n", printable(message)));
        }
    }

    /// Something for those who asked for it.
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

/// Says why the program ends: what and where on the first line, what to do below it.
pub(crate) fn error(lines: &[&str]) {
    say("error", ERROR, lines);
}

fn say(kind: &str, color: &str, lines: &[&str]) {
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

/// A standard error that is closed is no reason to stop working.
fn write(text: &str) {
    let _ = std::io::stderr().lock().write_all(text.as_bytes());
}

/// Colours appear on a terminal that has them, unless `NO_COLOR` is set to anything
/// (<https://no-color.org>).
fn colored() -> bool {
    std::io::stderr().is_terminal()
        && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
        && std::env::var_os("TERM").is_none_or(|value| value != "dumb")
}
