//! Windows: sizes in the two units that systems use, and the two places where their origin lies.
//!
//! Window systems give the mouse in *logical* points and draw in *physical* pixels; on a display of
//! high density they differ by a scale. They are types of their own here, and questions about places
//! take [`PhysicalPosition`], so that mixing them up doesn't compile.

use glam::DVec2;
use luxel_scene::Size;

/// A size in logical points, as a window system may give it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogicalSize {
    /// Points across.
    pub width: f64,
    /// Points down.
    pub height: f64,
}

/// A size in physical pixels: what is drawn into, and what everything here counts in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PhysicalSize {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
}

/// A place in logical points, the origin at the window's upper left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LogicalPosition {
    /// To the right.
    pub x: f64,
    /// Downwards.
    pub y: f64,
}

/// A place in physical pixels, the origin at the window's upper left: pixel n covers `[n, n + 1)`.
///
/// Bare numbers stand for pixels; points have to be turned into pixels first:
///
/// ```compile_fail
/// # fn hover(view: &luxel_pick::PickView<'_>) {
/// let cursor = luxel_pick::LogicalPosition { x: 320.0, y: 180.0 };
/// view.at(cursor); // On a display of high density another place of the window.
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
    /// In pixels, rounded; `scale` is pixels a point.
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
    /// In pixels; `scale` is pixels a point.
    #[must_use]
    pub fn to_physical(self, scale: f64) -> PhysicalPosition {
        PhysicalPosition { x: self.x * scale, y: self.y * scale }
    }
}

impl PhysicalSize {
    /// In points; `scale` is pixels a point.
    #[must_use]
    pub fn to_logical(self, scale: f64) -> LogicalSize {
        LogicalSize { width: f64::from(self.width) / scale, height: f64::from(self.height) / scale }
    }
}

impl PhysicalPosition {
    /// In points; `scale` is pixels a point.
    #[must_use]
    pub fn to_logical(self, scale: f64) -> LogicalPosition {
        LogicalPosition { x: self.x / scale, y: self.y / scale }
    }

    /// The same place with the origin at the lower left, as GLU's functions take it, or back again.
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

/// From a window whose y runs down from the upper left to one whose y runs up from the lower left,
/// or back: `height - y`.
///
/// ```
/// assert_eq!(luxel_pick::flip_y(0.5, 480.0), 479.5);
/// ```
#[must_use]
pub fn flip_y(y: f64, height: f64) -> f64 {
    height - y
}
