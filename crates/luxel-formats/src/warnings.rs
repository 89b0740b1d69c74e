//! What was left out or replaced.

/// How many warnings are kept: a file of a million faults needn't tell each.
const MOST: usize = 64;

/// Sentences for whoever opened the file, each with its place.
#[derive(Debug, Default)]
pub(crate) struct Warnings {
    list: Vec<String>,
    dropped: u64,
}

impl Warnings {
    /// Tells something, once.
    pub(crate) fn push(&mut self, warning: String) {
        if self.list.contains(&warning) {
            return;
        }
        if self.list.len() < MOST {
            self.list.push(warning);
        } else {
            self.dropped += 1;
        }
    }

    /// All of them, with the number of those beyond the first few.
    pub(crate) fn finish(mut self) -> Vec<String> {
        if self.dropped > 0 {
            self.list.push(format!("{} more warnings", self.dropped));
        }
        self.list
    }
}

/// One warning for all faces that can't be drawn.
#[cfg(any(feature = "obj", feature = "ply", feature = "stl"))]
pub(crate) fn warn_of_faces_left_out(count: u64, warnings: &mut Warnings) {
    match count {
        0 => {}
        1 => warnings.push("1 face with a corner that is not finite was left out".to_owned()),
        _ => warnings.push(format!("{count} faces with a corner that is not finite were left out")),
    }
}
