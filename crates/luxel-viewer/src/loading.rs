//! How far a model has come on its way from a file to what is drawn: shared by the thread that reads it
//! and the window, which waits.

use luxel::formats::Progress;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// A model on its way. Whoever reads it says how far it has come; whoever waits may stop it.
#[derive(Clone, Debug, Default)]
pub struct Loading {
    /// For the readers of files.
    pub progress: Progress,
    /// By its place in [`STEPS`].
    step: Arc<AtomicU8>,
}

/// What is done with a model, one after the other.
pub(crate) const STEPS: [&str; 5] = [
    "reading the file",
    "making its meshes",
    "making its normals",
    "fitting it into view",
    "making it ready to be drawn",
];

impl Loading {
    /// The file has been read and is understood.
    pub fn is_understood(&self) {
        self.step.store(2, Ordering::Relaxed);
    }

    /// Its surfaces are ready.
    pub fn is_smooth(&self) {
        self.step.store(3, Ordering::Relaxed);
    }

    /// The model is whole.
    pub(crate) fn is_whole(&self) {
        self.step.store(4, Ordering::Relaxed);
    }

    /// Which of the steps it is at.
    pub(crate) fn step(&self) -> usize {
        let step = usize::from(self.step.load(Ordering::Relaxed));
        let (read, all) = self.progress.bytes();
        if step == 0 && all > 0 && read >= all { 1 } else { step.min(STEPS.len() - 1) }
    }

    /// How much of all its steps is done: each counts the same, that of reading by its bytes.
    pub(crate) fn part(&self) -> f32 {
        let (read, all) = self.progress.bytes();
        let step = self.step();
        let of_step = if step == 0 && all > 0 { read as f64 / all as f64 } else { 0.0 };
        ((step as f64 + of_step) / STEPS.len() as f64) as f32
    }

    /// Where it is, in words.
    pub(crate) fn told(&self) -> String {
        let step = self.step();
        let (read, all) = self.progress.bytes();
        if step == 0 && all > 0 {
            format!("{}: {} of {} MB", STEPS[0], read / 1_000_000, all.div_ceil(1_000_000))
        } else {
            STEPS[step].to_owned()
        }
    }

    /// The model is not wanted any more.
    pub(crate) fn stop(&self) {
        self.progress.stop();
    }

    /// Whether the model is not wanted any more: whoever makes it may give up.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.progress.is_stopped()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::formats::{ErrorKind, Limits, open};

    #[test]
    fn reading_advances_to_the_end_of_the_file_and_on() {
        let path = std::env::temp_dir().join(format!("luxel-loading-{}.obj", std::process::id()));
        std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
        let loading = Loading::default();
        assert_eq!((loading.step(), loading.part()), (0, 0.0));
        let limits = Limits { watch: Some(loading.progress.clone()), ..Limits::default() };
        open(&path, &limits).unwrap();
        let length = std::fs::metadata(&path).unwrap().len();
        assert_eq!(loading.progress.bytes(), (length, length));
        let mut parts = vec![0.0, loading.part()];
        loading.is_understood();
        parts.push(loading.part());
        loading.is_smooth();
        parts.push(loading.part());
        loading.is_whole();
        parts.push(loading.part());
        assert!(parts.is_sorted_by(|a, b| a < b) && loading.part() < 1.0, "{parts:?}");
        // Whoever doesn't want it any more gets nothing.
        loading.stop();
        let stopped = open(&path, &limits).unwrap_err();
        assert!(matches!(stopped.kind, ErrorKind::Stopped), "{stopped}");
        std::fs::remove_file(&path).unwrap();
    }
}
