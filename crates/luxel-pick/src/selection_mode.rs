//! Selection mode with OpenGL's semantics (version 2.1, section 5.2): primitives that intersect the clip
//! volume are recorded with the current stack of names.

use crate::sliver::depths_in_volume;
use glam::{DMat4, DVec3};
use luxel_scene::Mesh;

/// The capacity of the name stack.
pub const MAX_NAMES: usize = 64;

/// A record of primitives that intersected the clip volume.
#[derive(Clone, Debug, PartialEq)]
pub struct HitRecord {
    /// The names, the lowest first.
    pub names: Vec<u32>,
    /// The least window depth, 0 near to 1 far.
    pub z_min: f64,
    /// The greatest.
    pub z_max: f64,
}

impl HitRecord {
    /// The depths in OpenGL's encoding: times 2^32 - 1, rounded.
    #[must_use]
    pub fn z_bits(&self) -> [u32; 2] {
        [self.z_min, self.z_max].map(|z| (z * f64::from(u32::MAX)).round() as u32)
    }

    /// The record's size in OpenGL's buffer, in words: a count, two depths, the names.
    #[must_use]
    pub fn words(&self) -> usize {
        3 + self.names.len()
    }
}

/// The outcome of a selection.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Selected {
    /// The records, in the order of drawing.
    pub records: Vec<HitRecord>,
    /// Whether the buffer was too small (`glRenderMode` returns -1).
    pub overflowed: bool,
}

/// An invalid operation on names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NameError {
    /// Pushed onto a full stack (`GL_STACK_OVERFLOW`).
    #[error("the name stack is full: it holds {MAX_NAMES}")]
    Overflow,
    /// Popped from an empty stack (`GL_STACK_UNDERFLOW`).
    #[error("the name stack is empty: nothing can be popped")]
    Underflow,
    /// A name loaded onto an empty stack (`GL_INVALID_OPERATION`).
    #[error("the name stack is empty: push a name before loading one")]
    Empty,
}

/// Selection mode: set names, draw, and get records of the primitives in the clip volume.
///
/// ```
/// use luxel_pick::{pick_matrix, Selection, Viewport};
/// use luxel_scene::{DMat4, DVec2, DVec3, Lens, Projection, Size};
///
/// let size = Size { width: 640, height: 480 };
/// let lens = Lens::Perspective { fov_y_radians: 0.8 };
/// let projection = Projection { lens, near: 1.0, far: 10.0 }.clip_from_view(size);
/// // Five pixels around the window's centre, the origin at the lower left.
/// let pick = pick_matrix(DVec2::new(320.0, 240.0), DVec2::splat(5.0), Viewport::of(size)).unwrap();
///
/// let mut selection = Selection::new(pick * projection, 64);
/// selection.push_name(7)?;
/// selection.triangle([[-1.0, -1.0, -5.0], [1.0, -1.0, -5.0], [0.0, 1.0, -5.0]].map(DVec3::from));
/// selection.load_name(8)?;
/// selection.triangle([[2.0, 2.0, -5.0], [3.0, 2.0, -5.0], [2.0, 3.0, -5.0]].map(DVec3::from));
/// let selected = selection.finish();
/// assert_eq!(selected.records.len(), 1);
/// assert_eq!(selected.records[0].names, [7]);
/// # Ok::<(), luxel_pick::NameError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Selection {
    clip_from_object: DMat4,
    names: Vec<u32>,
    /// The depths of hits since the names last changed.
    hit: Option<[f64; 2]>,
    selected: Selected,
    /// Words left in the buffer.
    room: usize,
}

impl Selection {
    /// Starts with an empty stack. `clip_from_object` is the projection, times a
    /// [`pick_matrix`](crate::pick_matrix) from the left, times the view from the right; `words` is
    /// the size of the buffer that OpenGL would write to (`glSelectBuffer`).
    #[must_use]
    pub fn new(clip_from_object: DMat4, words: usize) -> Self {
        let selected = Selected::default();
        Self { clip_from_object, names: Vec::new(), hit: None, selected, room: words }
    }

    /// Sets the transform of subsequent primitives.
    pub fn set_clip_from_object(&mut self, clip_from_object: DMat4) {
        self.clip_from_object = clip_from_object;
    }

    /// Empties the stack (`glInitNames`).
    pub fn init_names(&mut self) {
        self.record();
        self.names.clear();
    }

    /// Replaces the topmost name (`glLoadName`).
    ///
    /// # Errors
    /// [`NameError::Empty`] if there is none.
    pub fn load_name(&mut self, name: u32) -> Result<(), NameError> {
        if self.names.is_empty() {
            return Err(NameError::Empty);
        }
        self.record();
        if let Some(top) = self.names.last_mut() {
            *top = name;
        }
        Ok(())
    }

    /// Pushes a name (`glPushName`).
    ///
    /// # Errors
    /// [`NameError::Overflow`] beyond [`MAX_NAMES`].
    pub fn push_name(&mut self, name: u32) -> Result<(), NameError> {
        if self.names.len() >= MAX_NAMES {
            return Err(NameError::Overflow);
        }
        self.record();
        self.names.push(name);
        Ok(())
    }

    /// Pops the topmost name (`glPopName`).
    ///
    /// # Errors
    /// [`NameError::Underflow`] if there is none.
    pub fn pop_name(&mut self) -> Result<(), NameError> {
        if self.names.is_empty() {
            return Err(NameError::Underflow);
        }
        self.record();
        self.names.pop();
        Ok(())
    }

    /// Draws a point.
    pub fn point(&mut self, place: DVec3) {
        self.draw(&[place]);
    }

    /// Draws a line.
    pub fn line(&mut self, ends: [DVec3; 2]) {
        self.draw(&ends);
    }

    /// Draws a triangle; both sides count.
    pub fn triangle(&mut self, corners: [DVec3; 3]) {
        self.draw(&corners);
    }

    /// Draws a convex polygon.
    pub fn polygon(&mut self, corners: &[DVec3]) {
        let Some((&first, rest)) = corners.split_first() else { return };
        for pair in rest.windows(2) {
            self.triangle([first, pair[0], pair[1]]);
        }
    }

    /// Draws the triangles, points and lines of a mesh.
    pub fn mesh(&mut self, mesh: &Mesh) {
        for triangle in &mesh.triangles {
            self.draw(&triangle.map(|vertex| mesh.position(vertex)));
        }
        for &index in mesh.points.iter().flat_map(|points| &points.indices) {
            self.draw(&[mesh.position(index)]);
        }
        for ends in mesh.lines.iter().flat_map(|lines| &lines.segments) {
            self.draw(&ends.map(|end| mesh.position(end)));
        }
    }

    /// Ends selection mode (`glRenderMode`).
    #[must_use]
    pub fn finish(mut self) -> Selected {
        self.record();
        self.selected
    }

    fn draw(&mut self, corners: &[DVec3]) {
        let mut clip = [glam::DVec4::ZERO; 3];
        for (clip, corner) in clip.iter_mut().zip(corners) {
            *clip = self.clip_from_object * corner.extend(1.0);
        }
        if let Some(depths) = depths_in_volume(&clip[..corners.len()]) {
            self.hit(depths);
        }
    }

    /// Takes a primitive for drawn that the caller has transformed and clipped: its least and greatest window depth
    /// ([`depths_in_volume`](crate::depths_in_volume), by the range of `glDepthRange`).
    pub fn hit(&mut self, [low, high]: [f64; 2]) {
        let [z_min, z_max] = self.hit.unwrap_or([low, high]);
        self.hit = Some([z_min.min(low), z_max.max(high)]);
    }

    /// How many names are on the stack.
    #[must_use]
    pub fn depth(&self) -> usize {
        self.names.len()
    }

    /// Records the hits under the current names.
    fn record(&mut self) {
        let Some([z_min, z_max]) = self.hit.take() else { return };
        let record = HitRecord { names: self.names.clone(), z_min, z_max };
        if self.selected.overflowed || record.words() > self.room {
            self.selected.overflowed = true;
            return;
        }
        self.room -= record.words();
        self.selected.records.push(record);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEAR: [DVec3; 3] =
        [DVec3::new(0.0, 0.0, -0.5), DVec3::new(0.5, 0.0, -0.5), DVec3::new(0.0, 0.5, -0.25)];
    const BESIDE: [DVec3; 3] =
        [DVec3::new(2.0, 0.0, 0.0), DVec3::new(3.0, 0.0, 0.0), DVec3::new(2.0, 1.0, 0.0)];

    #[test]
    fn a_record_is_written_when_names_change_and_only_if_something_was_hit() {
        let mut selection = Selection::new(DMat4::IDENTITY, 100);
        selection.triangle(NEAR);
        selection.push_name(1).unwrap();
        selection.triangle(BESIDE);
        selection.push_name(2).unwrap();
        selection.triangle(NEAR);
        selection.point(DVec3::new(0.0, 0.0, 0.75));
        selection.pop_name().unwrap();
        selection.line([DVec3::new(-9.0, 0.0, 0.0), DVec3::new(9.0, 0.0, 0.0)]);
        selection.init_names();
        let selected = selection.finish();
        let records: Vec<_> = selected
            .records
            .iter()
            .map(|record| (record.names.clone(), record.z_min, record.z_max))
            .collect();
        let expected = [(vec![], 0.25, 0.375), (vec![1, 2], 0.25, 0.875), (vec![1], 0.5, 0.5)];
        assert_eq!(records, expected);
        assert_eq!(selected.records[2].z_bits(), [1 << 31; 2]);
        assert!(!selected.overflowed);
    }

    #[test]
    fn the_stack_refuses_what_opengl_refuses() {
        let mut selection = Selection::new(DMat4::IDENTITY, 100);
        assert_eq!(selection.load_name(1), Err(NameError::Empty));
        assert_eq!(selection.pop_name(), Err(NameError::Underflow));
        for name in 0..MAX_NAMES as u32 {
            selection.push_name(name).unwrap();
        }
        assert_eq!(selection.push_name(1), Err(NameError::Overflow));
    }

    #[test]
    fn overflow_is_reported_and_earlier_records_stay() {
        let mut selection = Selection::new(DMat4::IDENTITY, 9);
        for name in 0..4 {
            selection.init_names();
            selection.push_name(name).unwrap();
            selection.triangle(NEAR);
        }
        let selected = selection.finish();
        assert!(selected.overflowed);
        assert_eq!(selected.records.len(), 2);
    }
}
