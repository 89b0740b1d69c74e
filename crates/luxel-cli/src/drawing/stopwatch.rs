//! Times of the stages of work.

use luxel::render::Stages;
use serde_json::{Map, Value, json};
use std::fmt;
use std::time::{Duration, Instant};

/// A stopwatch per stage; repeated stages are summed.
#[derive(Debug)]
pub(crate) struct Stopwatch {
    start: Instant,
    lap: Instant,
    stages: Vec<(&'static str, Duration)>,
}

impl Stopwatch {
    pub(crate) fn start() -> Self {
        let now = Instant::now();
        Self { start: now, lap: now, stages: Vec::new() }
    }

    /// Adds the time since the last lap to a stage.
    pub(crate) fn lap(&mut self, stage: &'static str) {
        let now = Instant::now();
        self.add(stage, now - self.lap);
        self.lap = now;
    }

    /// Adds the stages of a frame, which are part of the lap `frame`.
    pub(crate) fn add_stages(&mut self, stages: &Stages) {
        for ((name, _), duration) in
            STAGES_OF_FRAMES.into_iter().zip([stages.bin, stages.visibility, stages.shade])
        {
            self.add(name, duration);
        }
    }

    fn add(&mut self, stage: &'static str, duration: Duration) {
        match self.stages.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, sum)) => *sum += duration,
            None => self.stages.push((stage, duration)),
        }
    }

    /// Milliseconds of each stage, and `total`.
    pub(crate) fn milliseconds(&self) -> impl Iterator<Item = (String, f64)> {
        let stages = self.stages.iter();
        let stages = stages.map(|(name, duration)| ((*name).to_owned(), milliseconds(*duration)));
        stages.chain([("total".to_owned(), milliseconds(self.start.elapsed()))])
    }

    /// Milliseconds of each stage, and `total`.
    pub(crate) fn to_json(&self) -> Value {
        let mut stages: Map<_, _> = self
            .stages
            .iter()
            .map(|(name, duration)| ((*name).to_owned(), json!(milliseconds(*duration))))
            .collect();
        stages.insert("total".to_owned(), json!(milliseconds(self.start.elapsed())));
        Value::Object(stages)
    }
}

/// Stages of frames, and what they are called below `frame`.
const STAGES_OF_FRAMES: [(&str, &str); 3] = [
    ("frame_bin", "bins"),
    ("frame_visibility", "visibility, summed over threads,"),
    ("frame_shade", "shading, summed over threads,"),
];

/// One stage after the other but for reading, of which its reader reports.
impl fmt::Display for Stopwatch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of_frames = |stage: &str| STAGES_OF_FRAMES.iter().find(|(name, _)| *name == stage);
        for (name, duration) in &self.stages {
            if *name == "read" || of_frames(name).is_some() {
                continue;
            }
            write!(formatter, "{name} {} ms", milliseconds(*duration))?;
            let parts = self.stages.iter().filter(|_| *name == "frame");
            let parts = parts.filter_map(|(part, sum)| Some((of_frames(part)?.1, sum)));
            let parts: Vec<_> =
                parts.map(|(part, sum)| format!("{part} {} ms", milliseconds(*sum))).collect();
            if !parts.is_empty() {
                write!(formatter, " ({})", parts.join("; "))?;
            }
            write!(formatter, ", ")?;
        }
        write!(formatter, "total {} ms", milliseconds(self.start.elapsed()))
    }
}

/// Milliseconds to the microsecond.
fn milliseconds(duration: Duration) -> f64 {
    (duration.as_secs_f64() * 1e6).round() / 1e3
}
