//! The stream of vertices between `glBegin` and `glEnd`, and on to the next `glBegin` where that goes on with it.

use super::materials::{Materials, Sides};
use super::vertices::Vertices;
use crate::enums as gl;
use crate::limits::WAITING_VERTICES;
use crate::state::current::Current;

/// Where a stream stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Phase {
    /// Nothing is to be drawn.
    #[default]
    Idle,
    /// Between `glBegin` and `glEnd`.
    Open,
    /// After `glEnd`: independent primitives wait for more of their kind, until something else happens.
    Waiting,
}

/// Primitives that are being given vertex by vertex.
#[derive(Clone, Debug)]
pub(crate) struct Stream {
    phase: Phase,
    pub(crate) mode: u32,
    /// Whether it comes from a display list.
    pub(crate) is_listed: bool,
    /// Whether vertices keep more than their positions: hits are found by these alone.
    has_attributes: bool,
    pub(crate) vertices: Vertices,
    pub(crate) materials: Materials,
}

impl Default for Stream {
    fn default() -> Self {
        let materials = Materials::new(Sides::default());
        let (phase, mode, vertices) = (Phase::Idle, gl::POINTS, Vertices::default());
        Self { phase, mode, is_listed: false, has_attributes: true, vertices, materials }
    }
}

/// The vertices of primitives that are complete, of so many; `None` for primitives that share vertices.
#[inline(always)]
fn complete(mode: u32, count: usize) -> Option<usize> {
    // Divisors that the compiler knows.
    Some(match mode {
        gl::POINTS => count,
        gl::LINES => count & !1,
        gl::TRIANGLES => count - count % 3,
        gl::QUADS => count & !3,
        _ => return None,
    })
}

impl Stream {
    /// Begins primitives with what is current, for hits alone or for all that is drawn.
    pub(crate) fn begin(
        &mut self,
        (mode, is_listed, for_hits): (u32, bool, bool),
        current: &Current,
        materials: Sides,
    ) {
        self.phase = Phase::Open;
        (self.mode, self.is_listed, self.has_attributes) = (mode, is_listed, !for_hits);
        self.vertices.restart(current);
        self.materials = Materials::new(materials);
    }

    /// Goes on with primitives that wait, if they are of that mode and come from a list, too, or neither does.
    #[inline]
    pub(crate) fn resume(&mut self, mode: u32, is_listed: bool) -> bool {
        let alike = self.mode == mode && self.is_listed == is_listed;
        let resumes = self.phase == Phase::Waiting && alike;
        if resumes {
            self.phase = Phase::Open;
        }
        resumes
    }

    /// Ends primitives: leaves out what is incomplete, and lets independent ones wait if they are few.
    #[inline]
    pub(crate) fn end(&mut self) {
        self.phase = Phase::Idle;
        let count = self.vertices.len();
        if let Some(complete) = complete(self.mode, count)
            && complete > 0
        {
            if complete < count {
                self.vertices.truncate(complete);
            }
            if self.vertices.len() < WAITING_VERTICES {
                self.phase = Phase::Waiting;
            }
        }
    }

    /// Whether it stands between `glBegin` and `glEnd`.
    #[inline]
    pub(crate) fn is_open(&self) -> bool {
        self.phase == Phase::Open
    }

    /// Whether primitives wait to be drawn.
    #[inline]
    pub(crate) fn is_waiting(&self) -> bool {
        self.phase == Phase::Waiting
    }

    /// Vertices that wait to be drawn.
    pub(crate) fn waiting(&self) -> usize {
        if self.is_waiting() { self.vertices.len() } else { 0 }
    }

    /// Says that what waited has been drawn.
    pub(crate) fn set_drawn(&mut self) {
        self.phase = Phase::Idle;
    }

    /// Whether attributes of now are those of its next vertex.
    #[inline]
    pub(crate) fn takes_attributes(&self) -> bool {
        self.phase != Phase::Idle && self.has_attributes
    }

    /// After all that is complete has been drawn of independent primitives: keeps the rest. False for others, which are
    /// drawn as a whole alone.
    pub(crate) fn drop_complete(&mut self) -> bool {
        let Some(complete) = complete(self.mode, self.vertices.len()) else { return false };
        self.vertices.drop_first(complete);
        self.materials.keep_last();
        true
    }

    /// Whether its primitives can be drawn in part.
    pub(crate) fn is_independent(&self) -> bool {
        complete(self.mode, 0).is_some()
    }

    /// Changes the material for the next vertices.
    pub(crate) fn set_materials(&mut self, sides: Sides) {
        self.materials.set(sides, self.vertices.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn begun(mode: u32) -> Stream {
        let mut stream = Stream::default();
        stream.begin((mode, false, false), &Current::default(), Sides::default());
        stream
    }

    #[test]
    fn section_2_7_each_vertex_keeps_the_values_that_were_current_when_it_came() {
        let mut stream = begun(gl::POINTS);
        let vertices = &mut stream.vertices;
        vertices.set_color([0.5; 4]);
        vertices.push([0.0; 4]);
        vertices.push([1.0; 4]);
        vertices.set_color([0.25; 4]);
        vertices.set_normal([1.0, 0.0, 0.0]);
        vertices.push([2.0; 4]);
        let vertices = vertices.view(&Current::default());
        let colors = [0, 1, 2].map(|vertex| vertices.color.of(vertex)[0]);
        assert_eq!(colors, [0.5, 0.5, 0.25]);
        assert_eq!([vertices.normal.of(0)[2], vertices.normal.of(2)[0]], [1.0, 1.0]);
        assert!(!vertices.edge_flag.varies());
    }

    #[test]
    fn section_5_4_a_run_of_a_list_takes_what_it_has_not_set_from_where_it_is_called() {
        let mut list = Vertices::default();
        list.push([0.0; 4]);
        list.set_color([0.25; 4]);
        list.set_tex_coord(3, [7.0; 4]);
        list.push([1.0; 4]);
        list.push([2.0; 4]);
        list.set_normal([1.0, 0.0, 0.0]);
        let mut stream = begun(gl::POINTS);
        stream.vertices.set_color([0.5; 4]);
        stream.vertices.push([3.0; 4]);
        stream.vertices.append(&list);
        stream.vertices.append(&list);
        let vertices = stream.vertices.view(&Current::default());
        let reds: Vec<f32> = (0..7).map(|vertex| vertices.color.of(vertex)[0]).collect();
        assert_eq!(reds, [0.5, 0.5, 0.25, 0.25, 0.25, 0.25, 0.25]);
        let s: Vec<f32> = (0..7).map(|vertex| vertices.tex_coords[3].of(vertex)[0]).collect();
        assert_eq!(s, [0.0, 0.0, 7.0, 7.0, 7.0, 7.0, 7.0]);
        let x: Vec<f32> = (0..7).map(|vertex| vertices.normal.of(vertex)[0]).collect();
        assert_eq!(x, [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
        let mut current = Current::default();
        list.put_current(&mut current);
        assert_eq!((current.color, current.normal), ([0.25; 4], [1.0, 0.0, 0.0]));
        assert_eq!(current.tex_coords[0], [0.0, 0.0, 0.0, 1.0]);
    }

    #[test]
    fn section_2_6_1_primitives_that_wait_are_complete_and_of_the_mode_that_goes_on() {
        let mut stream = begun(gl::TRIANGLES);
        (0..5).for_each(|_| stream.vertices.push([0.0; 4]));
        stream.vertices.set_color([0.5; 4]);
        stream.end();
        assert_eq!(stream.waiting(), 3);
        assert!(!stream.resume(gl::QUADS, false) && !stream.resume(gl::TRIANGLES, true));
        assert!(stream.resume(gl::TRIANGLES, false));
        stream.vertices.push([1.0; 4]);
        let color = stream.vertices.view(&Current::default()).color;
        assert_eq!([color.of(2)[0], color.of(3)[0]], [1.0, 0.5]);
        let mut strip = begun(gl::TRIANGLE_STRIP);
        (0..5).for_each(|_| strip.vertices.push([0.0; 4]));
        strip.end();
        assert!(!strip.is_waiting() && strip.vertices.len() == 5);
    }
}
