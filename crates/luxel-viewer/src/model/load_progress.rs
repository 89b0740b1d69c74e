//! Progress of loading a model, shared by the loading thread and the window.

use luxel::formats::Progress;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Progress of loading a model. The loading thread advances it; the window reads it, and may cancel.
#[derive(Clone, Debug, Default)]
pub struct LoadProgress {
    /// Progress of the file's reader.
    pub reader: Progress,
    /// An index into [`STEPS`].
    step: Arc<AtomicU8>,
}

/// The steps of loading, in order.
const STEPS: [&str; 5] = [
    "reading the file",
    "building meshes",
    "computing normals",
    "fitting the view",
    "preparing to draw",
];

impl LoadProgress {
    /// Marks the file as read and parsed.
    pub fn file_parsed(&self) {
        self.step.store(2, Ordering::Relaxed);
    }

    /// Marks the normals as computed.
    pub fn normals_computed(&self) {
        self.step.store(3, Ordering::Relaxed);
    }

    /// Marks the model as complete; preparing it for drawing follows.
    pub(crate) fn model_complete(&self) {
        self.step.store(4, Ordering::Relaxed);
    }

    /// The current step.
    pub(crate) fn step(&self) -> usize {
        let step = usize::from(self.step.load(Ordering::Relaxed));
        let (read, all) = self.reader.bytes();
        if step == 0 && all > 0 && read >= all { 1 } else { step.min(STEPS.len() - 1) }
    }

    /// The fraction done: all steps count the same, reading advances by bytes.
    pub(crate) fn fraction(&self) -> f32 {
        let (read, all) = self.reader.bytes();
        let step = self.step();
        let of_step = if step == 0 && all > 0 { read as f64 / all as f64 } else { 0.0 };
        ((step as f64 + of_step) / STEPS.len() as f64) as f32
    }

    /// The current step, in words.
    pub(crate) fn status(&self) -> String {
        let step = self.step();
        let (read, all) = self.reader.bytes();
        if step == 0 && all > 0 {
            format!("{}: {} of {} MB", STEPS[0], read / 1_000_000, all.div_ceil(1_000_000))
        } else {
            STEPS[step].to_owned()
        }
    }

    /// Cancels progress.
    pub(crate) fn stop(&self) {
        self.reader.stop();
    }

    /// Whether loading is cancelled: the loading thread may give up.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        self.reader.is_stopped()
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
        let progress = LoadProgress::default();
        assert_eq!((progress.step(), progress.fraction()), (0, 0.0));
        let limits = Limits { progress: Some(progress.reader.clone()), ..Limits::default() };
        open(&path, &limits).unwrap();
        let length = std::fs::metadata(&path).unwrap().len();
        assert_eq!(progress.reader.bytes(), (length, length));
        let mut parts = vec![0.0, progress.fraction()];
        progress.file_parsed();
        parts.push(progress.fraction());
        progress.normals_computed();
        parts.push(progress.fraction());
        progress.model_complete();
        parts.push(progress.fraction());
        assert!(parts.is_sorted_by(|a, b| a < b) && progress.fraction() < 1.0, "{parts:?}");
        progress.stop();
        let stopped = open(&path, &limits).unwrap_err();
        assert!(matches!(stopped.kind, ErrorKind::Stopped), "{stopped}");
        std::fs::remove_file(&path).unwrap();
    }
}
