//! Window coordinates: logical and physical units, origins at the upper and lower left.
//!
//! Window systems give the mouse in *logical* points and draw in *physical* pixels; on high-density
//! displays they differ by a scale. They are distinct types here, and queries take
//! [`PhysicalPosition`], so that mixing them up doesn't compile.

use glam::DVec2;
use luxel_scene::Size;

/// A size in logical points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogicalSize {
    /// Width in points.
    pub width: f64,
    /// Height in points.
    pub height: f64,
}

/// A size in physical pixels, the unit of all queries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PhysicalSize {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
}

/// A position in logical points from the window's upper left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogicalPosition {
    /// To the right.
    pub x: f64,
    /// Downwards.
    pub y: f64,
}

/// A position in physical pixels from the window's upper left: pixel n covers `[n, n + 1)`.
///
/// Arrays of numbers are pixels; points must be converted first:
///
/// ```compile_fail
/// # fn hover(view: &luxel_pick::PickView<'_>) {
/// let cursor = luxel_pick::LogicalPosition { x: 320.0, y: 180.0 };
/// view.at(cursor); // Another position on a high-density display.
/// # }
/// ```
/// ```
/// # fn hover(view: &luxel_pick::PickView<'_>, scale_factor: f64) {
/// let cursor = luxel_pick::LogicalPosition { x: 320.0, y: 180.0 };
/// view.at(cursor.to_physical(scale_factor));
/// view.at([640.5, 360.5]);
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PhysicalPosition {
    /// To the right.
    pub x: f64,
    /// Downwards.
    pub y: f64,
}

impl LogicalSize {
    /// Converts to pixels, rounded; `scale` is pixels per point.
    ///
    /// ```
    /// use luxel_pick::{LogicalSize, PhysicalSize};
    /// let window = LogicalSize { width: 640.0, height: 360.0 };
    /// assert_eq!(window.to_physical(1.5), PhysicalSize { width: 960, height: 540 });
    /// ```
    #[must_use]
    pub fn to_physical(self, scale: f64) -> PhysicalSize {
        let pixels = |points: f64| (points * scale).round() as u32;
        PhysicalSize { width: pixels(self.width), height: pixels(self.height) }
    }
}

impl LogicalPosition {
    /// Converts to pixels; `scale` is pixels per point.
    #[must_use]
    pub fn to_physical(self, scale: f64) -> PhysicalPosition {
        PhysicalPosition { x: self.x * scale, y: self.y * scale }
    }
}

impl PhysicalSize {
    /// Converts to points; `scale` is pixels per point.
    #[must_use]
    pub fn to_logical(self, scale: f64) -> LogicalSize {
        LogicalSize { width: f64::from(self.width) / scale, height: f64::from(self.height) / scale }
    }
}

impl PhysicalPosition {
    /// Converts to points; `scale` is pixels per point.
    #[must_use]
    pub fn to_logical(self, scale: f64) -> LogicalPosition {
        LogicalPosition { x: self.x / scale, y: self.y / scale }
    }

    /// The same position from the lower left, as GLU's functions take it, or back.
    #[must_use]
    pub fn flipped(self, size: PhysicalSize) -> DVec2 {
        DVec2::new(self.x, flip_y(self.y, f64::from(size.height)))
    }
}

impl PhysicalPosition {
    /// The centre of a pixel, by its column and row.
    ///
    /// ```
    /// let centre = luxel_pick::PhysicalPosition::centre_of(3, 4);
    /// assert_eq!((centre.x, centre.y), (3.5, 4.5));
    /// ```
    #[must_use]
    pub fn centre_of(column: u32, row: u32) -> Self {
        Self { x: f64::from(column) + 0.5, y: f64::from(row) + 0.5 }
    }

    pub(crate) fn to_array(self) -> [f64; 2] {
        [self.x, self.y]
    }
}

impl From<[f64; 2]> for PhysicalPosition {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<PhysicalSize> for Size {
    fn from(size: PhysicalSize) -> Self {
        Self { width: size.width, height: size.height }
    }
}

impl From<Size> for PhysicalSize {
    fn from(size: Size) -> Self {
        Self { width: size.width, height: size.height }
    }
}

/// Converts y between windows with the origin at the upper left and at the lower left: `height - y`.
///
/// ```
/// assert_eq!(luxel_pick::flip_y(0.5, 480.0), 479.5);
/// ```
#[must_use]
pub fn flip_y(y: f64, height: f64) -> f64 {
    height - y
}
