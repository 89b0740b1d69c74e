//! World-space lines over the picture, hidden by nearer surfaces.

use crate::projection::project_point;
use ecolor::Color32;
use luxel::scene::{Camera, DVec2, DVec3, Size};

/// A line segment in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    pub(crate) ends: [DVec3; 2],
    pub(crate) color: Color32,
    /// Opacity, 0 to 1.
    pub(crate) opacity: f32,
    /// In points.
    pub(crate) width: f32,
}

/// The depth buffer that hides lines: distances along the view, infinite on the background.
#[derive(Clone, Copy)]
pub(crate) struct Depths<'a> {
    pub(crate) z: &'a [f32],
    pub(crate) size: Size,
}

/// Lines within a surface are drawn: depths may exceed it by this fraction.
const DEPTH_TOLERANCE: f64 = 0.003;

/// Draws lines, as a picture's camera sees them, over the window's pixels, 0RGB.
pub(crate) fn draw_lines(
    lines: &[Line],
    camera: &Camera,
    depths: Depths<'_>,
    (window, pixels_per_point): (Size, f32),
    pixels: &mut [u32],
) {
    if pixels.len() != window.width as usize * window.height as usize {
        return;
    }
    let canvas = &mut Canvas { depths, window, pixels };
    for line in lines {
        let Some(ends) = ends_in_window(camera, window, line.ends) else { continue };
        canvas.draw(ends, line, f64::from(line.width * pixels_per_point));
    }
}

/// A line's end in the window: pixels, and 1 / z, which is linear there; z itself for orthographic
/// cameras.
#[derive(Clone, Copy)]
struct End {
    place: DVec2,
    depth: f64,
}

struct Canvas<'a> {
    depths: Depths<'a>,
    window: Size,
    pixels: &'a mut [u32],
}

/// Both ends, clipped at the near plane; `None` if nothing is left.
fn ends_in_window(camera: &Camera, window: Size, ends: [DVec3; 2]) -> Option<[(End, bool); 2]> {
    let is_parallel = camera.projection.is_orthographic();
    let front = camera.projection.near.max(if is_parallel { f64::NEG_INFINITY } else { 1e-9 });
    let z = ends.map(|end| -camera.view_from_world.transform_point3(end).z);
    if z[0] < front && z[1] < front {
        return None;
    }
    let cut = |at: usize| {
        let (here, there) = (z[at], z[1 - at]);
        if here >= front {
            return ends[at];
        }
        ends[at] + (ends[1 - at] - ends[at]) * ((front - here) / (there - here) * (1.0 + 1e-9))
    };
    let end = |at: usize| {
        let point = cut(at);
        let place = project_point(camera, window, point)?.truncate();
        let z = -camera.view_from_world.transform_point3(point).z;
        Some((End { place, depth: if is_parallel { z } else { 1.0 / z } }, is_parallel))
    };
    Some([end(0)?, end(1)?])
}

impl Canvas<'_> {
    fn draw(&mut self, ends: [(End, bool); 2], line: &Line, width: f64) {
        let [(from, is_parallel), (to, _)] = ends;
        let way = to.place - from.place;
        let is_flat = way.x.abs() >= way.y.abs();
        // Steps by whole pixels along the major axis, with coverage across it.
        let turned = |place: DVec2| if is_flat { place } else { DVec2::new(place.y, place.x) };
        let (a, b) = (turned(from.place), turned(to.place));
        let ((a, b), (near, far)) =
            if a.x <= b.x { ((a, b), (from, to)) } else { ((b, a), (to, from)) };
        let long = b.x - a.x;
        let (across, down) = (i64::from(self.window.width), i64::from(self.window.height));
        let (length, breadth) = if is_flat { (across, down) } else { (down, across) };
        let first = (a.x.floor() as i64).max(0);
        let last = (b.x.floor() as i64).min(length - 1);
        let slope: f64 = if long > 0.0 { (b.y - a.y) / long } else { 0.0 };
        // The extent across the major axis of a slanted line exceeds its width.
        let half = 0.5 * width * (1.0 + slope * slope).sqrt();
        for step in first..=last {
            let (left, right) = (step as f64, step as f64 + 1.0);
            // The ends cover a part of their step.
            let part = (right.min(b.x) - left.max(a.x)).clamp(0.0, 1.0);
            let part = if long < 1.0 { long } else { part };
            if part <= 0.0 {
                continue;
            }
            let along = (0.5 * (left.max(a.x) + right.min(b.x)) - a.x) / long.max(1e-9);
            let middle = a.y + (b.y - a.y) * along;
            let depth = near.depth + (far.depth - near.depth) * along;
            let z = if is_parallel { depth } else { 1.0 / depth };
            let low = ((middle - half).floor() as i64).max(0);
            let high = ((middle + half).floor() as i64).min(breadth - 1);
            for row in low..=high {
                let (top, bottom) = (row as f64, row as f64 + 1.0);
                let covered = (bottom.min(middle + half) - top.max(middle - half)).clamp(0.0, 1.0);
                let (x, y) = if is_flat { (step, row) } else { (row, step) };
                self.mix(x as usize, y as usize, z, line, covered * part);
            }
        }
    }

    fn mix(&mut self, x: usize, y: usize, z: f64, line: &Line, covered: f64) {
        let Size { width, height } = self.depths.size;
        let place = |at: usize, of: u32, source: u32| {
            (at as u64 * u64::from(source) / u64::from(of.max(1))) as usize
        };
        let row = place(y, self.window.height, height);
        let at = row * width as usize + place(x, self.window.width, width);
        let before = self.depths.z.get(at).copied().unwrap_or(f32::INFINITY);
        if z * (1.0 - DEPTH_TOLERANCE) > f64::from(before) {
            return;
        }
        let alpha = (f64::from(line.opacity) * covered * 256.0) as u32;
        let pixel = &mut self.pixels[y * self.window.width as usize + x];
        let [_, below @ ..] = pixel.to_be_bytes();
        let above = [line.color.r(), line.color.g(), line.color.b()];
        let channel = |at: usize| {
            ((u32::from(above[at]) * alpha + u32::from(below[at]) * (256 - alpha)) >> 8) as u8
        };
        *pixel = u32::from_be_bytes([0, channel(0), channel(1), channel(2)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::scene::{DMat4, Lens, Projection};

    const SIZE: Size = Size { width: 40, height: 20 };

    fn camera() -> Camera {
        let lens = Lens::Orthographic { height: 20.0 };
        let projection = Projection { lens, near: 0.0, far: 100.0 };
        Camera { view_from_world: DMat4::IDENTITY, projection }
    }

    fn drawn(ends: [DVec3; 2], z: &[f32], camera: &Camera) -> Vec<u32> {
        let mut pixels = vec![0; 800];
        let line = Line { ends, color: Color32::WHITE, opacity: 1.0, width: 1.0 };
        draw_lines(&[line], camera, Depths { z, size: SIZE }, (SIZE, 1.0), &mut pixels);
        pixels
    }

    fn covered(pixels: &[u32]) -> f64 {
        pixels.iter().map(|pixel| f64::from(pixel & 255) / 255.0).sum()
    }

    #[test]
    fn a_line_covers_its_length_in_every_direction() {
        let nothing = vec![f32::INFINITY; 800];
        for (to, length) in
            [((12.0, 0.0), 12.0), ((0.0, 9.0), 9.0), ((8.0, 6.0), 10.0), ((-6.0, 8.0), 10.0)]
        {
            let ends = [DVec3::new(0.3, -0.4, -5.0), DVec3::new(to.0 + 0.3, to.1 - 0.4, -5.0)];
            for ends in [ends, [ends[1], ends[0]]] {
                let covered = covered(&drawn(ends, &nothing, &camera()));
                assert!((covered - length).abs() < 0.06 * length, "{to:?}: {covered}");
            }
        }
    }

    #[test]
    fn a_line_is_hidden_by_nearer_surfaces() {
        // The left half of the window shows a surface at distance 10.
        let z: Vec<_> =
            (0..800).map(|at| if at % 40 < 20 { 10.0 } else { f32::INFINITY }).collect();
        let ends = |depth: f64| [DVec3::new(-15.0, 0.5, -depth), DVec3::new(15.0, 0.5, -depth)];
        let behind = drawn(ends(20.0), &z, &camera());
        let lit = |pixels: &[u32], x: usize| pixels[9 * 40 + x] > 0;
        assert!(!lit(&behind, 10) && lit(&behind, 30));
        let before = drawn(ends(5.0), &z, &camera());
        assert!(lit(&before, 10) && lit(&before, 30));
        assert!(lit(&drawn(ends(10.0), &z, &camera()), 10), "in the surface");
    }

    #[test]
    fn depth_between_the_ends_is_perspective_correct() {
        let size = Size { width: 400, height: 200 };
        let lens = Lens::Perspective { fov_y_radians: 1.0 };
        let camera = Camera { projection: Projection { lens, near: 0.5, far: 100.0 }, ..camera() };
        // From near to far: most of the line's extent in the window is near the far end.
        let ends = [DVec3::new(-0.5, 0.0, -1.0), DVec3::new(20.0, 0.0, -40.0)];
        let at = project_point(&camera, size, (ends[0] + ends[1]) * 0.5).unwrap();
        let line = Line { ends, color: Color32::WHITE, opacity: 1.0, width: 1.0 };
        // The middle is 20.5 away; interpolated linearly in the window it would be 39.
        for (wall, is_seen) in [(18.0, false), (23.0, true)] {
            let mut pixels = vec![0; 400 * 200];
            let z = vec![wall; pixels.len()];
            draw_lines(&[line], &camera, Depths { z: &z, size }, (size, 1.0), &mut pixels);
            let lit = [99, 100].map(|row| pixels[row * 400 + at.x as usize]);
            assert_eq!(lit != [0; 2], is_seen, "{wall}");
        }
    }

    #[test]
    fn lines_are_clipped_at_the_near_plane_and_invisible_behind_it() {
        let lens = Lens::Perspective { fov_y_radians: 1.0 };
        let camera = Camera { projection: Projection { lens, near: 0.5, far: 100.0 }, ..camera() };
        let nothing = vec![f32::INFINITY; 800];
        let ahead = DVec3::new(0.0, 0.0, -10.0);
        assert!(covered(&drawn([DVec3::new(1.0, 0.0, 3.0), ahead], &nothing, &camera)) > 5.0);
        let behind = [DVec3::new(1.0, 0.0, 3.0), DVec3::new(0.0, 0.0, 9.0)];
        assert_eq!(covered(&drawn(behind, &nothing, &camera)), 0.0);
    }
}
