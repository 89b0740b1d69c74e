//! Fixed point: window positions in steps of 1/256 pixel ("24.8").
//!
//! A vertex is snapped to this grid once; from then on coverage is exact integer arithmetic, so
//! two triangles that share an edge can neither overlap nor leave a gap. Eight fractional bits are
//! what Direct3D 11 (functional specification, section 3.4.1) asks for at least.

/// Steps of the grid in one pixel.
pub const SUBPIXELS: i32 = 256;

/// A window coordinate in steps of 1/256 pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SubPixel(pub i32);

impl SubPixel {
    /// The grid position nearest to `pixels`, ties to even.
    ///
    /// # Panics
    /// With debug assertions, if the position doesn't fit 24.8 bits: callers clip to the guard
    /// band first.
    #[must_use]
    pub fn round(pixels: f64) -> Self {
        let steps = (pixels * f64::from(SUBPIXELS)).round_ties_even();
        debug_assert!(steps.abs() < 2_147_483_648.0, "{pixels} px lies outside 24.8 bits");
        Self(steps as i32)
    }

    /// The centre of pixel number `pixel`.
    #[must_use]
    pub const fn centre_of(pixel: i32) -> Self {
        Self(pixel * SUBPIXELS + SUBPIXELS / 2)
    }

    /// The pixel that this position lies in: pixel `n` covers `[n, n + 1)`.
    #[must_use]
    pub const fn pixel(self) -> i32 {
        self.0.div_euclid(SUBPIXELS)
    }

    /// The position in pixels, exact.
    #[must_use]
    pub fn pixels(self) -> f64 {
        f64::from(self.0) / f64::from(SUBPIXELS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_to_the_nearest_step_and_ties_to_even() {
        assert_eq!(SubPixel::round(0.5 / 256.0), SubPixel(0));
        assert_eq!(SubPixel::round(1.5 / 256.0), SubPixel(2));
        assert_eq!(SubPixel::round(-1.5 / 256.0), SubPixel(-2));
        assert_eq!(SubPixel::round(3.0), SubPixel(768));
    }

    #[test]
    fn a_position_left_of_the_window_belongs_to_a_negative_pixel() {
        assert_eq!(SubPixel(-1).pixel(), -1);
        assert_eq!(SubPixel(255).pixel(), 0);
        assert_eq!(SubPixel::centre_of(7).pixel(), 7);
    }
}
