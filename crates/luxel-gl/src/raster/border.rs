//! Lines, points, and the borders of polygons to pieces (OpenGL 1.5, sections 2.11, 3.3, 3.4 and 3.5.4).

use super::build::PieceBuilder;
use super::draw_state::whole_size;
use super::pieces::Shade;
use super::placement::{Plane, slope_of};
use super::shape::{LineEnds, Shape};
use crate::enums as gl;
use crate::primitive::{ClipCorner, clip_polygon, clip_segment};
use crate::vertex::codes;
use luxel_math::SUBPIXELS;
use luxel_visibility::{CullFaces, Triangle, WindowVertex};

/// What lines and points of a polygon have in common: the offset of their depths, by factor, units and slope.
type Offset = Option<[f32; 3]>;

/// The largest depth of some places.
fn deepest(places: &[WindowVertex]) -> f32 {
    places.iter().fold(0.0, |most, place| most.max(place.z))
}

impl PieceBuilder<'_> {
    /// A line between two vertices; with `begins` the stipple does.
    pub(super) fn push_line(
        &mut self,
        ends: [u32; 2],
        (flat, side): (Option<u32>, u8),
        begins: bool,
        offset: Offset,
    ) {
        if begins {
            self.counter = 0;
        }
        let [a, b] = ends.map(|end| self.codes(end));
        if a & b & codes::OUTSIDE != 0 || (a | b) & codes::NOT_FINITE != 0 {
            return;
        }
        let mut corners = [self.corner(ends[0], 0), self.corner(ends[1], 1)];
        let any = a | b;
        if any & (codes::OUTSIDE | codes::NOT_HELD) != 0 {
            let planes = self.planes(any, &ends, false);
            let Some(clipped) = clip_segment(corners, &planes, Plane::distance) else { return };
            corners = clipped;
        }
        let shade = Shade { corners: [ends[0], ends[1], ends[1]], flat, side };
        self.push_segment(&corners, shade, offset);
    }

    /// A line between two corners that clipping has left of the vertices of a shade.
    fn push_segment(&mut self, corners: &[ClipCorner; 2], shade: Shade, offset: Offset) {
        let placed = corners.each_ref().map(|corner| self.clipped_window(corner, &shade.corners));
        let [Some(from), Some(to)] = placed else { return };
        let mut line = LineEnds {
            places: [[from.x, from.y], [to.x, to.y]],
            depths: [from.z, to.z],
            weights: corners.map(|corner| corner.weights.map(|weight| weight as f32)),
            w: corners.map(|corner| corner.clip[3]),
        };
        let counter = self.counter;
        let shape = if self.state.smooth[1] || self.has_samples() {
            Shape::Band { line, width: self.state.line_size, counter: Some(counter) }
        } else {
            // A wide line is shifted across by (width - 1) / 2 (section 3.4.2).
            let (width, minor) = (whole_size(self.state.line_size), 1 - line.major());
            for place in &mut line.places {
                place[minor] -= (width - 1) * (SUBPIXELS / 2);
            }
            Shape::Line { line, width, counter }
        };
        self.put(shape, shade, offset, deepest(&[from, to]));
        if self.batch.pipeline.line_stipple.is_some() {
            self.counter = counter.wrapping_add(line.walk().count as u32);
        }
    }

    /// A point at a vertex.
    pub(super) fn push_point(
        &mut self,
        vertex: u32,
        (flat, side): (Option<u32>, u8),
        offset: Offset,
    ) {
        let code = self.codes(vertex);
        if code & (codes::OUTSIDE | codes::NOT_FINITE | codes::NOT_HELD) != 0 {
            return;
        }
        let shade = Shade { corners: [vertex; 3], flat, side };
        self.push_dot(self.window(vertex), [1.0, 0.0, 0.0], shade, offset);
    }

    /// A point somewhere among the vertices of a shade.
    fn push_dot(&mut self, place: WindowVertex, weights: [f32; 3], shade: Shade, offset: Offset) {
        let size = self.point_size(&shade, weights);
        let shape = if self.state.smooth[0] || self.has_samples() {
            self.partial_point(place, size, weights)
        } else {
            whole_point(place, size, weights)
        };
        self.put(shape, shade, offset, place.z);
    }

    /// A point that may end within pixels: a disc, or with several samples the square that it is unless it is smooth.
    fn partial_point(&self, place: WindowVertex, size: f32, weights: [f32; 3]) -> Shape {
        let WindowVertex { x, y, z } = place;
        let size = size.clamp(1.0, crate::limits::LARGEST_SIZE);
        if self.state.smooth[0] {
            return Shape::Disc { centre: [x, y], size, depth: z, weights };
        }
        let half = (size * SUBPIXELS as f32 / 2.0).round_ties_even() as i32;
        let places = [[x - half, y], [x + half, y]];
        let line = LineEnds { places, depths: [z; 2], weights: [weights; 2], w: [1.0; 2] };
        Shape::Band { line, width: size, counter: None }
    }

    /// size / sqrt(a + b d + c d^2), within the limits (section 3.3); d is |z| in eye coordinates, as in Mesa.
    fn point_size(&self, shade: &Shade, weights: [f32; 3]) -> f32 {
        let [a, b, c] = self.state.attenuation;
        let mut size = self.state.point_size;
        if self.state.attenuation != [1.0, 0.0, 0.0] {
            let mut eye = [0.0; 2];
            for (corner, weight) in shade.corners.into_iter().zip(weights) {
                if let Some([_, _, z, w]) = self.batch.vertices.eye.get(corner as usize) {
                    eye = [eye[0] + z * weight, eye[1] + w * weight];
                }
            }
            let [z, w] = eye;
            let distance = z.abs() / if w == 0.0 { 1.0 } else { w.abs() };
            let divisor = a + b * distance + c * distance * distance;
            if divisor > 0.0 {
                size /= divisor.sqrt();
            }
        }
        let [least, largest] = self.state.point_limits;
        if size < least { least } else { size.min(largest) }
    }

    /// The border of a polygon as lines or points, each with the polygon's offset.
    pub(super) fn outline(
        &mut self,
        corners: &[u32],
        (flat, flagged): (Option<u32>, bool),
        provoking: u32,
        side: usize,
    ) {
        let lines = self.state.mode(side) == gl::LINE;
        let offset = self.state.offsets[usize::from(lines)]
            .map(|[factor, units]| [factor, units, self.slope(corners)]);
        let side = self.state.color_side(side) as u8;
        let Some(any) = self.batch.vertices.codes_if_seen(corners) else { return };
        let is_border = |vertex: u32| !flagged || self.batch.vertices.edge_flag(vertex as usize);
        if any & (codes::OUTSIDE | codes::NOT_HELD) == 0 {
            let mut begins = true;
            let border: Vec<bool> = corners.iter().map(|&vertex| is_border(vertex)).collect();
            for (number, &vertex) in corners.iter().enumerate().filter(|(at, _)| border[*at]) {
                if lines {
                    let next = corners[(number + 1) % corners.len()];
                    self.push_line([vertex, next], (flat, side), begins, offset);
                    begins = false;
                } else {
                    self.push_point(vertex, (flat, side), offset);
                }
            }
            return;
        }
        self.counter = 0;
        let count = corners.len();
        for fan in self.state.fans(&self.batch.vertices, corners, provoking) {
            let triangle = fan.map(|at| corners[at]);
            // Edges between the triangles of a polygon are none of its border.
            let border = [0, 1, 2].map(|at: usize| {
                (fan[at] + 1) % count == fan[(at + 1) % 3] && is_border(triangle[at])
            });
            let shade = Shade { corners: triangle, flat, side };
            self.clipped_outline(shade, (border, lines), offset);
        }
    }

    /// The border that clipping leaves of a triangle, with the edges that it makes (section 2.11). Those along the sides of
    /// the window are left out, as by Mesa's drivers: there lines are cut off alone.
    fn clipped_outline(
        &mut self,
        shade: Shade,
        (border, lines): ([bool; 3], bool),
        offset: Offset,
    ) {
        let triangle = shade.corners;
        let any = triangle.iter().fold(0, |any, corner| any | self.codes(*corner));
        let deep = self.planes(any & !codes::SIDES, &triangle, false);
        let sides = self.planes(any & (codes::SIDES | codes::NOT_HELD), &triangle, false);
        let mut polygon: Vec<ClipCorner> =
            [0, 1, 2].map(|at: usize| self.corner(triangle[at], at)).to_vec();
        for (corner, border) in polygon.iter_mut().zip(border) {
            corner.border = border;
        }
        clip_polygon(&mut polygon, &deep, Plane::distance);
        for (number, corner) in polygon.iter().enumerate().filter(|(_, corner)| corner.border) {
            if lines {
                let next = polygon[(number + 1) % polygon.len()];
                if let Some(segment) = clip_segment([*corner, next], &sides, Plane::distance) {
                    self.push_segment(&segment, shade, offset);
                }
            } else if sides.iter().all(|side| side.distance(corner) >= 0.0)
                && let Some(place) = self.clipped_window(corner, &triangle)
            {
                let weights = corner.weights.map(|weight| weight as f32);
                self.push_dot(place, weights, shade, offset);
            }
        }
    }

    /// max(|dz/dx|, |dz/dy|) of a polygon's first corners, a pixel; 0 if they have no place in the window.
    fn slope(&self, corners: &[u32]) -> f32 {
        if corners[..3].iter().any(|&corner| self.codes(corner) & codes::NOT_HELD != 0) {
            return 0.0;
        }
        let [a, b, c] = [0, 1, 2].map(|number| self.window(corners[number]));
        match Triangle::new([a, b, c], CullFaces::None) {
            Some(triangle) => slope_of(&triangle),
            None => 0.0,
        }
    }
}

/// A square of whole pixels.
fn whole_point(place: WindowVertex, size: f32, weights: [f32; 3]) -> Shape {
    let side = whole_size(size);
    // Odd sizes are centred in a pixel, even ones between pixels (section 3.3.1).
    let first = |at: i32| {
        if side % 2 == 1 {
            at.div_euclid(SUBPIXELS) - side / 2
        } else {
            (at + SUBPIXELS / 2).div_euclid(SUBPIXELS) - side / 2
        }
    };
    Shape::Point { corner: [first(place.x), first(place.y)], side, depth: place.z, weights }
}
