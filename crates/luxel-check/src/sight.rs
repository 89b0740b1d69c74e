//! The parts of lines and points in space that a view shows.

use luxel_scene::{Camera, DMat4, DVec2, DVec3, Size};

/// How much farther than the surface a mark may lie: it lies on it, but for rounding.
const SLACK: f64 = 1e-3;
/// Pixels between places at which a line is looked at.
const STEP: f64 = 0.5;

/// A view with the distance of what it shows.
pub(crate) struct Sight {
    camera: Camera,
    clip_from_view: DMat4,
    size: Size,
    /// The farthest distance of what each pixel and its neighbours show: a mark at an outline lies
    /// beside the pixels of its surface as often as on them.
    farthest: Vec<f32>,
}

impl Sight {
    /// `distances` are along the viewing axis, infinite where nothing is.
    pub(crate) fn new(camera: Camera, size: Size, distances: &[f32]) -> Self {
        let (width, height) = (size.width as usize, size.height as usize);
        let of_three = |values: &[f32], stride: usize, count: usize, at: usize, place: usize| {
            let before = if place > 0 { values[at - stride] } else { values[at] };
            let after = if place + 1 < count { values[at + stride] } else { values[at] };
            values[at].max(before).max(after)
        };
        let all = 0..width * height;
        let rows: Vec<f32> =
            all.clone().map(|at| of_three(distances, 1, width, at, at % width)).collect();
        let farthest = all.map(|at| of_three(&rows, width, height, at, at / width)).collect();
        Self { camera, clip_from_view: camera.projection.clip_from_view(size), size, farthest }
    }

    /// The parts of a line in world space that are seen, in pixels of the window; a point is a line
    /// whose ends are one.
    pub(crate) fn seen(&self, ends: [DVec3; 2], out: &mut Vec<[[f64; 2]; 2]>) {
        let near = self.camera.projection.near;
        let mut ends = ends.map(|end| self.camera.view_from_world.transform_point3(end));
        if !ends.iter().all(|end| end.is_finite()) || ends.iter().all(|end| -end.z < near) {
            return;
        }
        for (cut, kept) in [(0, 1), (1, 0)] {
            if -ends[cut].z < near {
                let (a, b) = (ends[kept], ends[cut]);
                ends[cut] = a + (b - a) * ((-a.z - near) / (b.z - a.z));
            }
        }
        let [from, to] = ends.map(|end| self.window(end));
        let Some([first, last]) = self.within(from, to) else { return };
        let steps = ((to - from).length() * (last - first) / STEP).ceil().min(1e5);
        let mut run: Option<[[f64; 2]; 2]> = None;
        for step in 0..=steps as u32 {
            let part = if steps > 0.0 { f64::from(step) / steps } else { 0.0 };
            let part = first + (last - first) * part;
            let place = from + (to - from) * part;
            if self.is_seen(place, self.distance(ends, part)) {
                let start = run.map_or(place.to_array(), |[start, _]| start);
                run = Some([start, place.to_array()]);
            } else {
                out.extend(run.take());
            }
        }
        out.extend(run);
    }

    fn window(&self, place: DVec3) -> DVec2 {
        let clip = self.clip_from_view.project_point3(place).truncate();
        (clip * DVec2::new(0.5, -0.5) + 0.5)
            * DVec2::new(f64::from(self.size.width), f64::from(self.size.height))
    }

    /// The part of the way between two places of the window that lies in it.
    fn within(&self, from: DVec2, to: DVec2) -> Option<[f64; 2]> {
        let (mut first, mut last) = (0.0_f64, 1.0_f64);
        let sides = [self.size.width, self.size.height].map(f64::from);
        for (axis, side) in sides.into_iter().enumerate() {
            let (from, way) = (from[axis], to[axis] - from[axis]);
            if way == 0.0 {
                if !(0.0..=side).contains(&from) {
                    return None;
                }
                continue;
            }
            let (a, b) = ((0.0 - from) / way, (side - from) / way);
            first = first.max(a.min(b));
            last = last.min(a.max(b));
        }
        (first <= last).then_some([first, last])
    }

    /// How far away a line is at a part of its way in the window.
    fn distance(&self, [from, to]: [DVec3; 2], part: f64) -> f64 {
        let (from, to) = (-from.z, -to.z);
        if self.camera.projection.is_orthographic() {
            from + (to - from) * part
        } else {
            1.0 / (1.0 / from + (1.0 / to - 1.0 / from) * part)
        }
    }

    fn is_seen(&self, place: DVec2, distance: f64) -> bool {
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let column = (place.x as usize).min(width - 1);
        let row = (place.y as usize).min(height - 1);
        distance <= f64::from(self.farthest[row * width + column]) * (1.0 + SLACK)
    }
}
