//! The resolution of frames while the camera moves.

use luxel::scene::Size;
use std::time::Instant;

/// The render time of a frame at 30 a second: the previous one is presented meanwhile.
const SECONDS_A_FRAME: f64 = 0.030;
/// The smallest fraction of the window's width: less shows nothing useful.
const MIN_SCALE: f64 = 0.3;
/// The step between scales, so that the pixel size doesn't flicker.
const STEP: f64 = 0.1;

/// The resolution of interactive frames, from the render times so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ResolutionScaling {
    /// A fraction of the window's width.
    scale: f64,
}

impl Default for ResolutionScaling {
    fn default() -> Self {
        Self { scale: 1.0 }
    }
}

impl ResolutionScaling {
    /// Adapts the scale to the render time of an interactive frame.
    pub(crate) fn record_frame(&mut self, size: Size, window: Size, seconds: f64) {
        let pixels = f64::from(size.width) * f64::from(size.height);
        let all = f64::from(window.width) * f64::from(window.height);
        let whole = seconds / pixels.max(1.0) * all;
        let scale = (SECONDS_A_FRAME / whole).sqrt();
        let steps = (scale.clamp(MIN_SCALE, 1.0) / STEP).floor();
        let wanted = (steps * STEP).clamp(MIN_SCALE, 1.0);
        // Down at once, up by one step: a frame that is quick by chance changes little.
        self.scale = if wanted < self.scale { wanted } else { wanted.min(self.scale + STEP) };
    }

    /// The size of interactive frames.
    pub(crate) fn interactive_size(&self, window: Size) -> Size {
        let side = |side: u32| ((f64::from(side) * self.scale).round() as u32).max(1);
        Size { width: side(window.width), height: side(window.height) }
    }
}

/// Statistics of consecutive interactive frames, for verbose output.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct MotionStats {
    started: Option<Instant>,
    ended: Option<Instant>,
    frames: u32,
    /// The sum of their scales.
    scales: f64,
}

impl MotionStats {
    /// Counts a frame of some scale.
    pub(crate) fn count(&mut self, scale: f64) {
        let now = Instant::now();
        self.started.get_or_insert(now);
        self.ended = Some(now);
        self.frames += 1;
        self.scales += scale;
    }

    /// Resets the statistics; returns a summary if there were enough frames.
    pub(crate) fn finish(&mut self) -> Option<String> {
        let Self { started, ended, frames, scales } = std::mem::take(self);
        let seconds = (ended? - started?).as_secs_f64();
        (frames > 4 && seconds > 0.0).then(|| {
            format!(
                "{frames} frames while moving, {:.1} a second, at {:.0} % of the width",
                f64::from(frames - 1) / seconds,
                scales / f64::from(frames) * 100.0
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Size = Size { width: 1280, height: 720 };

    #[test]
    fn quick_frames_keep_full_resolution() {
        let mut scaling = ResolutionScaling::default();
        assert_eq!(scaling.interactive_size(WINDOW), WINDOW);
        scaling.record_frame(WINDOW, WINDOW, 0.02);
        assert_eq!(scaling.interactive_size(WINDOW), WINDOW);
    }

    #[test]
    fn slow_frames_shrink_enough_and_grow_again() {
        let mut scaling = ResolutionScaling::default();
        for (whole, expected_scale) in [(0.104, 0.5), (10.0, MIN_SCALE), (0.02, 1.0)] {
            for _ in 0..20 {
                let size = scaling.interactive_size(WINDOW);
                let scale = f64::from(size.width) / f64::from(WINDOW.width);
                scaling.record_frame(size, WINDOW, whole * scale * scale);
            }
            let scale = f64::from(scaling.interactive_size(WINDOW).width) / f64::from(WINDOW.width);
            assert!((scale - expected_scale).abs() < STEP + 1e-9, "{whole}: {scale}");
        }
    }
}
