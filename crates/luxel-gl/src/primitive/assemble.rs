//! Vertices to points, lines and polygons (OpenGL 1.5, section 2.6.1), with the vertex whose colour flat shading takes
//! (table 2.12).

use crate::enums as gl;
use std::ops::Range;

/// What takes primitives, as numbers of vertices.
pub(crate) trait Visitor {
    /// A point.
    fn point(&mut self, vertex: u32);
    /// A line; whether it begins a stipple pattern. Its second end is the provoking one.
    fn line(&mut self, ends: [u32; 2], begins: bool);
    /// A polygon with its provoking vertex; whether its vertices have edge flags.
    fn polygon(&mut self, corners: &[u32], provoking: u32, flagged: bool);
    /// A polygon of three corners.
    #[inline]
    fn triangle(&mut self, corners: [u32; 3], provoking: u32, flagged: bool) {
        self.polygon(&corners, provoking, flagged);
    }
}

/// How many parts the primitives of `count` vertices can be given in: each is a primitive, or all of them where one goes
/// on from another.
pub(super) fn parts(mode: u32, count: usize) -> usize {
    match mode {
        gl::POINTS => count,
        gl::LINES => count / 2,
        gl::TRIANGLES => count / 3,
        gl::QUADS => count / 4,
        gl::TRIANGLE_STRIP | gl::TRIANGLE_FAN => count.saturating_sub(2),
        gl::QUAD_STRIP => count.saturating_sub(2) / 2,
        _ => 1,
    }
}

/// Gives some parts of the primitives of vertices in the order of `elements`, or of `count` vertices one after the
/// other.
pub(super) fn assemble_parts(
    mode: u32,
    count: usize,
    elements: Option<&[u32]>,
    parts: Range<usize>,
    visitor: &mut impl Visitor,
) {
    match elements {
        Some(elements) => {
            let indexed = &mut Indexed { elements, visitor, corners: Vec::new() };
            assemble_in_order(mode, elements.len(), parts, indexed);
        }
        None => assemble_in_order(mode, count, parts, visitor),
    }
}

/// Gives all primitives.
pub(super) fn assemble(
    mode: u32,
    count: usize,
    elements: Option<&[u32]>,
    visitor: &mut impl Visitor,
) {
    let of = elements.map_or(count, <[u32]>::len);
    assemble_parts(mode, count, elements, 0..parts(mode, of), visitor);
}

/// Takes places in a list of elements for vertices.
struct Indexed<'a, V> {
    elements: &'a [u32],
    visitor: &'a mut V,
    corners: Vec<u32>,
}

impl<V: Visitor> Visitor for Indexed<'_, V> {
    fn point(&mut self, vertex: u32) {
        self.visitor.point(self.elements[vertex as usize]);
    }

    fn line(&mut self, ends: [u32; 2], begins: bool) {
        self.visitor.line(ends.map(|end| self.elements[end as usize]), begins);
    }

    fn polygon(&mut self, corners: &[u32], provoking: u32, flagged: bool) {
        self.corners.clear();
        self.corners.extend(corners.iter().map(|&corner| self.elements[corner as usize]));
        self.visitor.polygon(&self.corners, self.elements[provoking as usize], flagged);
    }

    #[inline]
    fn triangle(&mut self, corners: [u32; 3], provoking: u32, flagged: bool) {
        let corners = corners.map(|corner| self.elements[corner as usize]);
        self.visitor.triangle(corners, self.elements[provoking as usize], flagged);
    }
}

/// Gives some parts of the primitives of `count` vertices; those that are incomplete are left out.
fn assemble_in_order(mode: u32, count: usize, parts: Range<usize>, visitor: &mut impl Visitor) {
    let count = count as u32;
    let parts = parts.start as u32..parts.end as u32;
    match mode {
        gl::POINTS => parts.for_each(|vertex| visitor.point(vertex)),
        gl::LINES => {
            for first in parts.map(|part| 2 * part) {
                visitor.line([first, first + 1], true);
            }
        }
        gl::LINE_STRIP | gl::LINE_LOOP => {
            for first in 0..count.saturating_sub(1) {
                visitor.line([first, first + 1], first == 0);
            }
            // A loop of two vertices goes there and back.
            if mode == gl::LINE_LOOP && count >= 2 {
                visitor.line([count - 1, 0], false);
            }
        }
        gl::TRIANGLES => {
            for first in parts.map(|part| 3 * part) {
                visitor.triangle([first, first + 1, first + 2], first + 2, true);
            }
        }
        gl::TRIANGLE_STRIP => {
            for first in parts {
                // Every second one is turned, so that all face the same way.
                let turn = first & 1;
                let corners = [first + turn, first + 1 - turn, first + 2];
                visitor.triangle(corners, first + 2, false);
            }
        }
        gl::TRIANGLE_FAN => {
            for second in parts.map(|part| part + 1) {
                visitor.triangle([0, second, second + 1], second + 1, false);
            }
        }
        gl::QUADS => {
            for first in parts.map(|part| 4 * part) {
                visitor.polygon(&[first, first + 1, first + 2, first + 3], first + 3, true);
            }
        }
        gl::QUAD_STRIP => {
            for first in parts.map(|part| 2 * part) {
                visitor.polygon(&[first, first + 1, first + 3, first + 2], first + 3, false);
            }
        }
        _ if count >= 3 => {
            let corners: Vec<u32> = (0..count).collect();
            visitor.polygon(&corners, 0, true);
        }
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Seen {
        polygons: Vec<(Vec<u32>, u32)>,
        lines: Vec<([u32; 2], bool)>,
        points: u32,
    }

    impl Visitor for Seen {
        fn point(&mut self, _: u32) {
            self.points += 1;
        }
        fn line(&mut self, ends: [u32; 2], begins: bool) {
            self.lines.push((ends, begins));
        }
        fn polygon(&mut self, corners: &[u32], provoking: u32, _: bool) {
            self.polygons.push((corners.to_vec(), provoking));
        }
    }

    fn seen(mode: u32, count: usize) -> Seen {
        let mut seen = Seen::default();
        assemble(mode, count, None, &mut seen);
        seen
    }

    #[test]
    fn section_2_6_1_strips_fans_and_quads_have_these_corners_and_colours() {
        let polygons = |mode, count| seen(mode, count).polygons;
        let strip = [(vec![0, 1, 2], 2), (vec![2, 1, 3], 3), (vec![2, 3, 4], 4)];
        assert_eq!(polygons(gl::TRIANGLE_STRIP, 5), strip);
        assert_eq!(polygons(gl::TRIANGLE_FAN, 4), [(vec![0, 1, 2], 2), (vec![0, 2, 3], 3)]);
        assert_eq!(polygons(gl::TRIANGLES, 5), [(vec![0, 1, 2], 2)]);
        assert_eq!(polygons(gl::QUADS, 7), [(vec![0, 1, 2, 3], 3)]);
        let quads = [(vec![0, 1, 3, 2], 3), (vec![2, 3, 5, 4], 5)];
        assert_eq!(polygons(gl::QUAD_STRIP, 7), quads);
        assert_eq!(polygons(gl::POLYGON, 5), [(vec![0, 1, 2, 3, 4], 0)]);
        assert!(polygons(gl::POLYGON, 2).is_empty());
    }

    #[test]
    fn section_2_6_1_primitives_in_parts_are_those_of_the_whole() {
        for mode in gl::POINTS..=gl::POLYGON {
            for count in 0..12 {
                let whole = seen(mode, count);
                let mut by_parts = Seen::default();
                for part in 0..parts(mode, count) {
                    assemble_parts(mode, count, None, part..part + 1, &mut by_parts);
                }
                assert_eq!(by_parts.points, whole.points);
                assert_eq!(by_parts.lines, whole.lines);
                assert_eq!(by_parts.polygons, whole.polygons);
            }
        }
    }

    #[test]
    fn section_2_6_1_a_stipple_pattern_begins_once_a_strip_and_with_each_separate_line() {
        assert_eq!(seen(gl::LINES, 5).lines, [([0, 1], true), ([2, 3], true)]);
        let of_loop = [([0, 1], true), ([1, 2], false), ([2, 0], false)];
        assert_eq!(seen(gl::LINE_LOOP, 3).lines, of_loop);
        assert_eq!(seen(gl::LINE_STRIP, 3).lines, of_loop[..2]);
        assert!(seen(gl::LINE_LOOP, 1).lines.is_empty());
        assert_eq!(seen(gl::POINTS, 3).points, 3);
        for mode in gl::POINTS..=gl::POLYGON {
            let none = seen(mode, 0);
            assert!(none.points == 0 && none.lines.is_empty() && none.polygons.is_empty());
        }
    }
}
