//! Primitives to pieces: faces, culling, clipping (OpenGL 1.5, sections 2.11 and 3.5). `border` makes them of lines and
//! points.

use super::batch::Batch;
use super::draw_state::DrawState;
use super::pieces::{Pieces, Shade};
use super::placement::{Plane, area, depth_offset, polygon_area, slope_of, window_of};
use super::shape::Shape;
use super::triangle_group::TriangleGroup;
use crate::enums as gl;
use crate::primitive::{ClipCorner, Visitor, clip_polygon};
use crate::vertex::codes;
use luxel_math::{Level, SUBPIXELS, dispatch_long, lanes_of};
use luxel_visibility::{CullFaces, GUARD_BAND, Triangle, WindowVertex};

/// Primitives that one thread makes pieces of at a time.
pub(crate) const PIECES_RUN: usize = 2048;

/// Makes pieces of the primitives of a batch that it is shown.
pub(crate) struct PieceBuilder<'a> {
    pub(super) state: &'a DrawState,
    pub(super) batch: &'a Batch,
    pub(super) pieces: Pieces,
    /// The counter of line stipples (section 3.4.2).
    pub(super) counter: u32,
    polygon: Vec<ClipCorner>,
    /// Filled triangles that wait: pieces are made in the order of primitives.
    waiting: TriangleGroup,
    level: Level,
    /// Whether filled polygons are smooth.
    is_smooth: bool,
    /// Whether all polygons are filled, and not smooth.
    is_filled: bool,
}

impl<'a> PieceBuilder<'a> {
    /// Appends to `pieces`.
    pub(crate) fn new(
        state: &'a DrawState,
        batch: &'a Batch,
        pieces: Pieces,
        level: Level,
    ) -> Self {
        let is_smooth = state.smooth[2] && batch.pipeline.multisample.is_none();
        Self {
            state,
            batch,
            pieces,
            counter: 0,
            polygon: Vec::new(),
            waiting: TriangleGroup::default(),
            level,
            is_smooth,
            is_filled: state.modes == [gl::FILL; 2] && !is_smooth,
        }
    }

    pub(crate) fn finish(mut self) -> Pieces {
        self.make_waiting();
        self.pieces
    }

    pub(super) fn codes(&self, vertex: u32) -> u16 {
        self.batch.vertices.codes[vertex as usize]
    }

    pub(super) fn window(&self, vertex: u32) -> WindowVertex {
        self.batch.vertices.window[vertex as usize]
    }

    pub(super) fn corner(&self, vertex: u32, number: usize) -> ClipCorner {
        let held = self.codes(vertex) & codes::NOT_HELD == 0;
        ClipCorner::new(self.batch.vertices.clip[vertex as usize], number, held)
    }

    /// The planes that some vertices lie beyond. Sides of the clip volume are left to the pixels of the viewport
    /// where `guarded`, as far as the guard band reaches.
    pub(super) fn planes(&self, any: u16, vertices: &[u32], guarded: bool) -> Vec<Plane> {
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
    pub(super) fn clipped_window(
        &self,
        corner: &ClipCorner,
        vertices: &[u32],
    ) -> Option<WindowVertex> {
        if corner.own && corner.held {
            let number = corner.weights.iter().position(|weight| *weight == 1.0)?;
            return Some(self.window(vertices[number]));
        }
        window_of(&self.state.scale, corner.clip)
    }

    /// A filled triangle; its side, if that is known.
    #[inline]
    fn fill(&mut self, corners: [u32; 3], provoking: u32, facing: Option<usize>) {
        if self.waiting.push(corners, provoking, facing) {
            self.make_waiting();
        }
    }

    /// Makes pieces of the triangles that wait.
    #[inline(never)]
    fn make_waiting(&mut self) {
        if self.waiting.is_empty() {
            return;
        }
        let (state, batch) = (self.state, self.batch);
        let placed = dispatch_long!(self.level, simd => self.waiting.placed(simd, state, batch));
        for lane in lanes_of(placed.drawn) {
            let (corners, provoking) = self.waiting.triangle(lane);
            let flat = state.flat.then_some(provoking);
            if placed.clipped >> lane & 1 == 1 {
                self.clip_filled(corners, flat, self.waiting.facing(lane));
                continue;
            }
            let side = self.state.color_side(placed.side(lane)) as u8;
            let offset = self.offset_of_whole(corners);
            self.pieces.push_triangle(placed.tiles(lane), Shade { corners, flat, side }, offset);
        }
        self.waiting.clear();
    }

    /// A filled triangle that planes cut.
    fn clip_filled(&mut self, corners: [u32; 3], flat: Option<u32>, facing: Option<usize>) {
        let placed = self.clipped(corners);
        for pair in placed.get(1..).unwrap_or_default().windows(2) {
            self.piece([placed[0], pair[0], pair[1]], corners, flat, facing);
        }
    }

    /// Whether all corners of a triangle lie beyond one plane, or one of them is nowhere.
    #[inline(always)]
    pub(super) fn is_out_of_sight(&self, corners: [u32; 3]) -> bool {
        let [a, b, c] = corners.map(|corner| self.codes(corner));
        a & b & c & codes::OUTSIDE != 0 || (a | b | c) & codes::NOT_FINITE != 0
    }

    /// What clipping leaves of a triangle, in the window.
    pub(super) fn clipped(&mut self, corners: [u32; 3]) -> Vec<WindowVertex> {
        let codes = corners.map(|corner| self.codes(corner));
        let planes = self.planes(codes[0] | codes[1] | codes[2], &corners, true);
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend([0, 1, 2].map(|number| self.corner(corners[number], number)));
        clip_polygon(&mut polygon, &planes, Plane::distance);
        let place = |corner: &ClipCorner| self.clipped_window(corner, &corners);
        let placed = polygon.iter().filter_map(place).collect();
        self.polygon = polygon;
        placed
    }

    /// What the depths of a filled triangle are moved by, as its corners lie in the window.
    #[inline(always)]
    fn offset_of_whole(&self, corners: [u32; 3]) -> f32 {
        self.state.offsets[2].map_or(0.0, |[factor, units]| {
            let window = corners.map(|corner| self.window(corner));
            let triangle = Triangle::new(window, CullFaces::None);
            triangle.map_or(0.0, |of| {
                let by = Some([factor, units, slope_of(&of)]);
                depth_offset(by, self.state.scale.kind, of.depth.high)
            })
        })
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
        let shade = Shade { corners, flat, side };
        self.put(Shape::Triangle(triangle), shade, offset, triangle.depth.high);
    }

    pub(super) fn put(
        &mut self,
        shape: Shape,
        shade: Shade,
        offset: Option<[f32; 3]>,
        largest: f32,
    ) {
        let offset = depth_offset(offset, self.state.scale.kind, largest);
        self.pieces.push(self.batch, shape, shade, offset);
    }

    /// Whether pixels have several samples, each of which is covered or not.
    pub(super) fn has_samples(&self) -> bool {
        self.batch.pipeline.multisample.is_some()
    }
}

impl Visitor for PieceBuilder<'_> {
    fn point(&mut self, vertex: u32) {
        self.make_waiting();
        self.push_point(vertex, (None, 0), None);
    }

    fn line(&mut self, ends: [u32; 2], begins: bool) {
        self.make_waiting();
        let flat = self.state.flat.then_some(ends[1]);
        self.push_line(ends, (flat, 0), begins, None);
    }

    fn polygon(&mut self, corners: &[u32], provoking: u32, flagged: bool) {
        let state = self.state;
        let flat = state.flat.then_some(provoking);
        if state.culled == [true; 2] {
            return;
        }
        let side = state.side(polygon_area(&self.batch.vertices, &state.scale, corners));
        if state.is_culled(side) {
            return;
        }
        if !self.is_filled {
            self.make_waiting();
            if state.mode(side) != gl::FILL {
                self.outline(corners, (flat, flagged), provoking, side);
                return;
            }
            if self.is_smooth && self.smooth_polygon(corners, (flat, side), provoking) {
                return;
            }
        }
        for fan in state.fans(&self.batch.vertices, corners, provoking) {
            self.fill(fan.map(|at| corners[at]), provoking, Some(side));
        }
    }

    #[inline]
    fn triangle(&mut self, corners: [u32; 3], provoking: u32, flagged: bool) {
        if self.is_filled {
            self.fill(corners, provoking, None);
        } else {
            self.polygon(&corners, provoking, flagged);
        }
    }
}
