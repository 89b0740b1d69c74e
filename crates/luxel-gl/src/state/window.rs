//! From clip coordinates to the window (OpenGL 1.5, sections 2.10.1 and 2.11; ARB_clip_control).

use super::fragment::PixelBox;

/// The viewport and the range of depths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Viewport {
    pub(crate) area: PixelBox,
    pub(crate) near: f64,
    pub(crate) far: f64,
}

/// `glClipControl`: which coordinates the clip volume has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct ClipControl {
    /// Whether y runs downwards in the window. Faces stay what they are.
    pub(crate) upper_left: bool,
    /// Whether z runs from 0 to w, rather than from -w.
    pub(crate) zero_to_one: bool,
}

/// Viewport and clip control together.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WindowTransform {
    pub(crate) viewport: Viewport,
    pub(crate) clip: ClipControl,
}

impl Default for Viewport {
    fn default() -> Self {
        Self { area: PixelBox::default(), near: 0.0, far: 1.0 }
    }
}

impl ClipControl {
    /// z / w of the near plane; that of the far one is 1.
    pub(crate) fn nearest(self) -> f64 {
        if self.zero_to_one { 0.0 } else { -1.0 }
    }

    /// Up in the clip volume is up in the window times this.
    pub(crate) fn up(self) -> f64 {
        if self.upper_left { -1.0 } else { 1.0 }
    }
}

impl WindowTransform {
    /// Where clip coordinates lie in the window, in pixels, with their depth.
    pub(crate) fn place(&self, [x, y, z, w]: [f64; 4]) -> [f64; 3] {
        let area = self.viewport.area;
        let place = |value: f64, first: i32, length: i32| {
            f64::from(first) + (value / w + 1.0) * 0.5 * f64::from(length)
        };
        let nearest = self.clip.nearest();
        let unit = ((z / w - nearest) / (1.0 - nearest)).clamp(0.0, 1.0);
        let up = y * self.clip.up();
        [place(x, area.x, area.width), place(up, area.y, area.height), self.depth(unit)]
    }

    /// A depth between 0, the near plane, and 1 in the range of `glDepthRange`.
    pub(crate) fn depth(&self, unit: f64) -> f64 {
        self.viewport.near + (self.viewport.far - self.viewport.near) * unit
    }

    /// z of clip coordinates as in a volume that begins at -w.
    pub(crate) fn z_from_minus_w(&self, z: f64, w: f64) -> f64 {
        if self.clip.zero_to_one { 2.0 * z - w } else { z }
    }
}
