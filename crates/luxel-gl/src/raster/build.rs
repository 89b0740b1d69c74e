//! Primitives to pieces: faces, culling, clipping, setup (OpenGL 1.5, sections 2.11, 3.3 to 3.5).

use super::batch::Batch;
use super::draw_state::{DrawState, whole_size};
use super::pieces::{Pieces, Shade};
use super::placement::{Plane, area, depth_offset, polygon_area, slope_of, window_of};
use super::shape::{LineEnds, Shape};
use crate::enums as gl;
use crate::primitive::{ClipCorner, Visitor, clip_polygon, clip_segment};
use crate::vertex::codes;
use luxel_math::SUBPIXELS;
use luxel_visibility::{CullFaces, GUARD_BAND, Triangle, WindowVertex};

/// Primitives that one thread makes pieces of at a time.
pub(crate) const PIECES_RUN: usize = 2048;

/// The largest depth of some places.
fn deepest(places: &[WindowVertex]) -> f32 {
    places.iter().fold(0.0, |most, place| most.max(place.z))
}

/// Makes pieces of the primitives of a batch that it is shown.
pub(crate) struct PieceBuilder<'a> {
    state: &'a DrawState,
    batch: &'a Batch,
    pieces: Pieces,
    /// The counter of line stipples (section 3.4.2).
    counter: u32,
    polygon: Vec<ClipCorner>,
}

impl<'a> PieceBuilder<'a> {
    /// Appends to `pieces`.
    pub(crate) fn new(state: &'a DrawState, batch: &'a Batch, pieces: Pieces) -> Self {
        Self { state, batch, pieces, counter: 0, polygon: Vec::new() }
    }

    pub(crate) fn finish(self) -> Pieces {
        self.pieces
    }

    fn codes(&self, vertex: u32) -> u16 {
        self.batch.vertices.codes[vertex as usize]
    }

    fn window(&self, vertex: u32) -> WindowVertex {
        self.batch.vertices.window[vertex as usize]
    }

    fn corner(&self, vertex: u32, number: usize) -> ClipCorner {
        let held = self.codes(vertex) & codes::NOT_HELD == 0;
        ClipCorner::new(self.batch.vertices.clip[vertex as usize], number, held)
    }

    /// The planes that some vertices lie beyond. Sides of the clip volume are left to the pixels of the viewport
    /// where `guarded`, as far as the guard band reaches.
    fn planes(&self, any: u16, vertices: &[u32], guarded: bool) -> Vec<Plane> {
        let mut planes = Vec::new();
        if any & codes::NEAR != 0 {
            planes.push(Plane::Volume(self.state.scale.near_plane()));
        }
        if any & codes::FAR != 0 {
            planes.push(Plane::Volume([0.0, 0.0, -1.0, 1.0]));
        }
        for &(number, plane) in &self.state.planes {
            if any >> (codes::FIRST_PLANE + number) & 1 == 1 {
                let mut distances = [0.0; 3];
                for (distance, &vertex) in distances.iter_mut().zip(vertices) {
                    let eye = self.batch.vertices.eye[vertex as usize];
                    *distance = plane.iter().zip(eye).map(|(p, e)| p * f64::from(e)).sum();
                }
                planes.push(Plane::User(distances));
            }
        }
        if any & codes::SIDES != 0 && (!guarded || any & codes::NOT_HELD != 0) {
            for axis in 0..2 {
                // One pixel of the band stays for rounding.
                let half = f64::from(self.state.scale.half[axis]).abs().max(1.0);
                let reach = if guarded { f64::from(GUARD_BAND - SUBPIXELS) / half } else { 1.0 };
                for sign in [1.0, -1.0] {
                    let mut plane = [0.0, 0.0, 0.0, reach];
                    plane[axis] = sign;
                    planes.push(if guarded { Plane::Guard(plane) } else { Plane::Volume(plane) });
                }
            }
        }
        planes
    }

    /// Where a corner that clipping has left lies in the window.
    fn clipped_window(&self, corner: &ClipCorner, vertices: &[u32]) -> Option<WindowVertex> {
        if corner.own && corner.held {
            let number = corner.weights.iter().position(|weight| *weight == 1.0)?;
            return Some(self.window(vertices[number]));
        }
        window_of(&self.state.scale, corner.clip)
    }

    fn triangle(&mut self, corners: [u32; 3], flat: Option<u32>, facing: Option<usize>) {
        let [a, b, c] = corners.map(|corner| self.codes(corner));
        let any = a | b | c;
        if a & b & c & codes::OUTSIDE != 0 || any & codes::NOT_FINITE != 0 {
            return;
        }
        let outside = any & codes::OUTSIDE & !codes::SIDES != 0;
        if !outside && any & codes::NOT_HELD == 0 {
            self.whole(corners, flat, facing);
            return;
        }
        let planes = self.planes(any, &corners, true);
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend([0, 1, 2].map(|number| self.corner(corners[number], number)));
        clip_polygon(&mut polygon, &planes, Plane::distance);
        let mut placed = polygon.iter().filter_map(|corner| self.clipped_window(corner, &corners));
        if let (Some(first), Some(mut last)) = (placed.next(), placed.next()) {
            let rest: Vec<WindowVertex> = placed.collect();
            for next in rest {
                self.piece([first, last, next], corners, flat, facing);
                last = next;
            }
        }
        self.polygon = polygon;
    }

    /// A filled triangle as its corners lie in the window.
    #[inline(always)]
    fn whole(&mut self, corners: [u32; 3], flat: Option<u32>, facing: Option<usize>) {
        let window = corners.map(|corner| self.window(corner));
        let area = area(window);
        let side = facing.unwrap_or_else(|| self.state.side(area));
        if area == 0.0 || self.state.is_culled(side) {
            return;
        }
        let shade = Shade::Triangle { corners, flat, side: self.state.color_side(side) as u8 };
        let offset = self.state.offsets[2].map_or(0.0, |[factor, units]| {
            let triangle = Triangle::new(window, CullFaces::None);
            triangle.map_or(0.0, |of| {
                let by = Some([factor, units, slope_of(&of)]);
                depth_offset(by, self.state.scale.kind, of.depth.high)
            })
        });
        let bounds = self.pixels_of(window);
        self.pieces.push_triangle(bounds, shade, offset);
    }

    /// The pixels in a triangle's box: left, bottom, right, top, the last two beyond. With one sample those whose centres
    /// lie in it.
    #[inline(always)]
    fn pixels_of(&self, [a, b, c]: [WindowVertex; 3]) -> [i32; 4] {
        let region = self.batch.polygon_region;
        let centre = SUBPIXELS / 2;
        let (low, high) = if self.has_samples() { (0, 0) } else { (centre - 1, -centre) };
        let range = |axis: usize, [p, q, r]: [i32; 3]| {
            let first = (p.min(q).min(r) + low).div_euclid(SUBPIXELS);
            let last = (p.max(q).max(r) + high).div_euclid(SUBPIXELS);
            [first.max(region[axis]), (last + 1).min(region[axis + 2])]
        };
        let [left, right] = range(0, [a.x, b.x, c.x]);
        let [bottom, top] = range(1, [a.y, b.y, c.y]);
        [left, bottom, right, top]
    }

    /// A part of a filled triangle in the window.
    fn piece(
        &mut self,
        window: [WindowVertex; 3],
        corners: [u32; 3],
        flat: Option<u32>,
        facing: Option<usize>,
    ) {
        let side = facing.unwrap_or_else(|| self.state.side(area(window)));
        if self.state.is_culled(side) {
            return;
        }
        let Some(triangle) = Triangle::new(window, CullFaces::None) else { return };
        let offset = self.state.offsets[2];
        let offset = offset.map(|[factor, units]| [factor, units, slope_of(&triangle)]);
        let side = self.state.color_side(side) as u8;
        let shade = Shade::Triangle { corners, flat, side };
        self.put(Shape::Triangle(triangle), shade, offset, triangle.depth.high);
    }

    fn push_line(
        &mut self,
        ends: [u32; 2],
        (flat, side): (Option<u32>, u8),
        begins: bool,
        offset: Option<[f32; 3]>,
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
        let placed = corners.map(|corner| self.clipped_window(&corner, &ends));
        let [Some(from), Some(to)] = placed else { return };
        let mut line = LineEnds {
            places: [[from.x, from.y], [to.x, to.y]],
            depths: [from.z, to.z],
            weights: corners.map(|corner| [0, 1].map(|end| corner.weights[end] as f32)),
            w: corners.map(|corner| corner.clip[3]),
        };
        let counter = self.counter;
        let shape = if self.state.smooth[1] || self.has_samples() {
            Shape::Band { line, width: self.state.line_size, counter: Some(counter) }
        } else {
            // A wide line is shifted across by (width - 1) / 2 (section 3.4.2).
            let (width, minor) = (whole_size(self.state.line_size), 1 - line.walk().major);
            for place in &mut line.places {
                place[minor] -= (width - 1) * (SUBPIXELS / 2);
            }
            Shape::Line { line, width, counter }
        };
        self.put(shape, Shade::Ends { vertices: ends, flat, side }, offset, deepest(&[from, to]));
        self.counter = counter.wrapping_add(line.walk().count as u32);
    }

    fn put(&mut self, shape: Shape, shade: Shade, offset: Option<[f32; 3]>, largest: f32) {
        let offset = depth_offset(offset, self.state.scale.kind, largest);
        self.pieces.push(self.batch, shape, shade, offset);
    }

    fn push_point(
        &mut self,
        vertex: u32,
        (flat, color_side): (Option<u32>, u8),
        offset: Option<[f32; 3]>,
    ) {
        let code = self.codes(vertex);
        if code & (codes::OUTSIDE | codes::NOT_FINITE | codes::NOT_HELD) != 0 {
            return;
        }
        let shape = if self.state.smooth[0] || self.has_samples() {
            self.partial_point(vertex)
        } else {
            self.whole_point(vertex)
        };
        let shade = Shade::Ends { vertices: [vertex; 2], flat, side: color_side };
        self.put(shape, shade, offset, self.window(vertex).z);
    }

    /// A square of whole pixels.
    fn whole_point(&self, vertex: u32) -> Shape {
        let place = self.window(vertex);
        let side = whole_size(self.point_size(vertex));
        // Odd sizes are centred in a pixel, even ones between pixels (section 3.3.1).
        let first = |at: i32| {
            if side % 2 == 1 {
                at.div_euclid(SUBPIXELS) - side / 2
            } else {
                (at + SUBPIXELS / 2).div_euclid(SUBPIXELS) - side / 2
            }
        };
        Shape::Point { corner: [first(place.x), first(place.y)], side, depth: place.z }
    }

    /// Whether pixels have several samples, each of which is covered or not.
    fn has_samples(&self) -> bool {
        self.batch.pipeline.multisample.is_some()
    }

    /// A point that may end within pixels: a disc, or with several samples the square that it is unless it is smooth.
    fn partial_point(&self, vertex: u32) -> Shape {
        let WindowVertex { x, y, z } = self.window(vertex);
        let size = self.point_size(vertex).clamp(1.0, crate::limits::LARGEST_SIZE);
        if self.state.smooth[0] {
            return Shape::Disc { centre: [x, y], size, depth: z };
        }
        let half = (size * SUBPIXELS as f32 / 2.0).round_ties_even() as i32;
        let places = [[x - half, y], [x + half, y]];
        let line = LineEnds { places, depths: [z; 2], weights: [[1.0, 0.0]; 2], w: [1.0; 2] };
        Shape::Band { line, width: size, counter: None }
    }

    /// size / sqrt(a + b d + c d^2), within the limits (section 3.3); d is |z| in eye coordinates, as in Mesa.
    fn point_size(&self, vertex: u32) -> f32 {
        let [a, b, c] = self.state.attenuation;
        let mut size = self.state.point_size;
        if self.state.attenuation != [1.0, 0.0, 0.0]
            && let Some([_, _, z, w]) = self.batch.vertices.eye.get(vertex as usize)
        {
            let distance = z.abs() / if *w == 0.0 { 1.0 } else { w.abs() };
            let divisor = a + b * distance + c * distance * distance;
            if divisor > 0.0 {
                size /= divisor.sqrt();
            }
        }
        let [least, largest] = self.state.point_limits;
        if size < least { least } else { size.min(largest) }
    }

    /// The border of a polygon as lines or points, each with the polygon's offset.
    fn outline(&mut self, corners: &[u32], flat: Option<u32>, flagged: bool, side: usize) {
        let lines = self.state.mode(side) == gl::LINE;
        let shade = (flat, self.state.color_side(side) as u8);
        let offset = self.state.offsets[usize::from(lines)]
            .map(|[factor, units]| [factor, units, self.slope(corners)]);
        let mut begins = true;
        for (number, &vertex) in corners.iter().enumerate() {
            if flagged && !self.batch.vertices.edge_flag(vertex as usize) {
                continue;
            }
            if lines {
                let next = corners[(number + 1) % corners.len()];
                self.push_line([vertex, next], shade, begins, offset);
                begins = false;
            } else {
                self.push_point(vertex, shade, offset);
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

impl Visitor for PieceBuilder<'_> {
    fn point(&mut self, vertex: u32) {
        self.push_point(vertex, (None, 0), None);
    }

    fn line(&mut self, ends: [u32; 2], begins: bool) {
        let flat = self.state.flat.then_some(ends[1]);
        self.push_line(ends, (flat, 0), begins, None);
    }

    fn polygon(&mut self, corners: &[u32], provoking: u32, flagged: bool) {
        let state = self.state;
        let flat = state.flat.then_some(provoking);
        if state.culled == [true; 2] {
            return;
        }
        let filled = state.modes == [gl::FILL; 2];
        if let (true, &[a, b, c]) = (filled, corners) {
            self.triangle([a, b, c], flat, None);
            return;
        }
        let side = state.side(polygon_area(&self.batch.vertices, &state.scale, corners));
        if state.is_culled(side) {
            return;
        }
        if state.mode(side) != gl::FILL {
            self.outline(corners, flat, flagged, side);
            return;
        }
        let count = corners.len();
        let about = if state.splits_at_provoking { provoking } else { corners[0] };
        let first = corners.iter().position(|corner| *corner == about).unwrap_or(0);
        for second in first + 1..first + count - 1 {
            let fan = [first, second, second + 1].map(|at| corners[at % count]);
            self.triangle(fan, flat, Some(side));
        }
    }
}
