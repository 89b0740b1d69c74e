//! How large pictures may be while the camera moves.

use luxel::scene::Size;
use std::time::Instant;

/// What drawing a frame may take at 30 a second: the last one is brought to the window meanwhile.
const SECONDS_A_FRAME: f64 = 0.030;
/// The smallest part of the window's width that is drawn: less can't be made out.
const LEAST: f64 = 0.3;
/// Parts change in such steps, so that the picture's grain doesn't flicker.
const STEP: f64 = 0.1;

/// What frames have taken so far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    /// The part of the window's width that is drawn while moving.
    part: f64,
}

impl Default for Pace {
    fn default() -> Self {
        Self { part: 1.0 }
    }
}

impl Pace {
    /// A frame while moving has taken some time.
    pub(crate) fn learn(&mut self, size: Size, window: Size, seconds: f64) {
        let pixels = f64::from(size.width) * f64::from(size.height);
        let all = f64::from(window.width) * f64::from(window.height);
        let whole = seconds / pixels.max(1.0) * all;
        let part = (SECONDS_A_FRAME / whole).sqrt();
        let steps = (part.clamp(LEAST, 1.0) / STEP).floor();
        let wanted = (steps * STEP).clamp(LEAST, 1.0);
        // Down at once, up by a step: a frame that was quick by chance changes little.
        self.part = if wanted < self.part { wanted } else { wanted.min(self.part + STEP) };
    }

    /// The size to draw while moving.
    pub(crate) fn moving(&self, window: Size) -> Size {
        let side = |side: u32| ((f64::from(side) * self.part).round() as u32).max(1);
        Size { width: side(window.width), height: side(window.height) }
    }
}

/// Pictures drawn one after the other while something moved, for those who want to know.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Run {
    begun: Option<Instant>,
    ended: Option<Instant>,
    pictures: u32,
    /// Their parts of the window's width, added up.
    parts: f64,
}

impl Run {
    /// One more picture, at a part of the window's width.
    pub(crate) fn count(&mut self, part: f64) {
        let now = Instant::now();
        self.begun.get_or_insert(now);
        self.ended = Some(now);
        self.pictures += 1;
        self.parts += part;
    }

    /// What it came to, if there were enough to tell; the next run begins.
    pub(crate) fn told(&mut self) -> Option<String> {
        let Self { begun, ended, pictures, parts } = std::mem::take(self);
        let seconds = (ended? - begun?).as_secs_f64();
        (pictures > 4 && seconds > 0.0).then(|| {
            format!(
                "{pictures} pictures while moving, {:.1} a second, at {:.0} % of the width",
                f64::from(pictures - 1) / seconds,
                parts / f64::from(pictures) * 100.0
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW: Size = Size { width: 1280, height: 720 };

    #[test]
    fn quick_frames_are_drawn_whole() {
        let mut pace = Pace::default();
        assert_eq!(pace.moving(WINDOW), WINDOW);
        pace.learn(WINDOW, WINDOW, 0.02);
        assert_eq!(pace.moving(WINDOW), WINDOW);
    }

    #[test]
    fn slow_frames_become_small_enough_and_grow_again() {
        let mut pace = Pace::default();
        for (whole, expected_part) in [(0.104, 0.5), (10.0, LEAST), (0.02, 1.0)] {
            for _ in 0..20 {
                let size = pace.moving(WINDOW);
                let part = f64::from(size.width) / f64::from(WINDOW.width);
                pace.learn(size, WINDOW, whole * part * part);
            }
            let part = f64::from(pace.moving(WINDOW).width) / f64::from(WINDOW.width);
            assert!((part - expected_part).abs() < STEP + 1e-9, "{whole}: {part}");
        }
    }
}
