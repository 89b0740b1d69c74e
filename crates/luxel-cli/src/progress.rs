//! A progress bar, on terminals and in builds with the feature.

use crate::console::Console;

/// The progress of work in several steps.
pub(crate) struct Progress {
    #[cfg(feature = "progress")]
    bar: indicatif::ProgressBar,
}

#[cfg(feature = "progress")]
impl Progress {
    /// A single step shows no bar.
    pub(crate) fn new(console: Console, steps: usize, unit: &str) -> Self {
        use indicatif::{ProgressBar, ProgressStyle};
        if steps < 2 || !console.shows_progress() {
            return Self { bar: ProgressBar::hidden() };
        }
        let bar = ProgressBar::new(steps as u64);
        let template = format!("{{bar:40}} {{pos}}/{{len}} {unit}, {{eta}} left");
        match ProgressStyle::with_template(&template) {
            Ok(style) => Self { bar: bar.with_style(style) },
            Err(_) => Self { bar },
        }
    }

    /// Advances by one step.
    pub(crate) fn step(&self) {
        self.bar.inc(1);
    }

    /// Runs `action`, which prints, without the bar.
    pub(crate) fn hidden<T>(&self, action: impl FnOnce() -> T) -> T {
        self.bar.suspend(action)
    }

    /// Removes the bar.
    pub(crate) fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(not(feature = "progress"))]
impl Progress {
    pub(crate) fn new(_: Console, _: usize, _: &str) -> Self {
        Self {}
    }

    pub(crate) fn step(&self) {}

    pub(crate) fn hidden<T>(&self, action: impl FnOnce() -> T) -> T {
        action()
    }

    pub(crate) fn finish(&self) {}
}
