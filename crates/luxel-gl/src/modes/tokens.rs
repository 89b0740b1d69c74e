//! Primitives as tokens of the feedback buffer (OpenGL 1.5, section 5.3): after lighting, culling and clipping, before
//! rasterization.

use crate::enums as gl;
use crate::primitive::{Cut, Visitor, clip_polygon, clip_segment};
use crate::raster::{DrawState, polygon_area};
use crate::state::window::WindowTransform;
use crate::vertex::{Processed, UsedVertices, codes};
use luxel_pick::{Feedback, FeedbackBuffer, FeedbackVertex};

/// Writes primitives to the buffer.
pub(crate) struct FeedbackVisitor<'a> {
    state: &'a DrawState,
    vertices: &'a Processed,
    window: WindowTransform,
    buffer: FeedbackBuffer,
    /// What clipping leaves of a polygon, and where that lies in the window.
    polygon: Vec<Corner>,
    placed: Vec<FeedbackVertex>,
}

/// A vertex that is being clipped, with all that the buffer takes of it.
#[derive(Clone, Copy, Debug)]
struct Corner {
    clip: [f64; 4],
    eye: [f64; 4],
    color: [f64; 4],
    texture: [f64; 4],
}

impl Cut for Corner {
    fn between(inside: &Self, outside: &Self, t: f64) -> Self {
        let mix = |inside: [f64; 4], outside: [f64; 4]| {
            std::array::from_fn(|at| inside[at] + (outside[at] - inside[at]) * t)
        };
        Self {
            clip: mix(inside.clip, outside.clip),
            eye: mix(inside.eye, outside.eye),
            color: mix(inside.color, outside.color),
            texture: mix(inside.texture, outside.texture),
        }
    }
}

/// A plane with the coordinates that it is one of.
#[derive(Clone, Copy, Debug)]
enum Plane {
    Clip([f64; 4]),
    Eye([f64; 4]),
}

impl Plane {
    fn distance(&self, corner: &Corner) -> f64 {
        let (plane, of) = match self {
            Self::Clip(plane) => (plane, corner.clip),
            Self::Eye(plane) => (plane, corner.eye),
        };
        plane.iter().zip(of).map(|(p, c)| p * c).sum()
    }
}

/// What a list has for a vertex; zeros where the buffer takes nothing of that kind, and there is no list.
#[inline]
fn value_of(list: &[[f32; 4]], vertex: usize) -> [f32; 4] {
    list.get(vertex).copied().unwrap_or_default()
}

/// What the corners of a polygon lie beyond, together, and the side that it shows; `None` if it is culled or out of sight.
#[inline]
fn shown(state: &DrawState, vertices: &Processed, corners: &[u32]) -> Option<(u16, usize)> {
    let any = vertices.codes_if_seen(corners)?;
    let side = state.side(polygon_area(vertices, state.scale(), corners));
    (!state.is_culled(side)).then_some((any, side))
}

impl<'a> FeedbackVisitor<'a> {
    pub(crate) fn new(
        state: &'a DrawState,
        vertices: &'a Processed,
        window: WindowTransform,
        buffer: FeedbackBuffer,
    ) -> Self {
        let (polygon, placed) = (Vec::new(), Vec::new());
        Self { state, vertices, window, buffer, polygon, placed }
    }

    /// The buffer, with what has been written to it.
    pub(crate) fn finish(self) -> FeedbackBuffer {
        self.buffer
    }

    fn code(&self, vertex: u32) -> u16 {
        self.vertices.codes[vertex as usize]
    }

    fn corner(&self, vertex: u32, color_of: u32, side: usize) -> Corner {
        let at = vertex as usize;
        let wide = |values: [f32; 4]| values.map(f64::from);
        Corner {
            clip: wide(self.vertices.clip[at]),
            eye: wide(value_of(&self.vertices.eye, at)),
            color: wide(self.vertices.color(side, color_of as usize)),
            texture: wide(value_of(&self.vertices.tex_coords[0], at)),
        }
    }

    /// What clipping has left of a vertex.
    fn placed(&self, corner: &Corner) -> FeedbackVertex {
        let narrow = |values: [f64; 4]| values.map(|value| value as f32);
        self.in_window(corner.clip, narrow(corner.color), narrow(corner.texture))
    }

    /// A vertex that isn't clipped.
    #[inline]
    fn whole(&self, vertex: u32, color_of: u32, side: usize) -> FeedbackVertex {
        let at = vertex as usize;
        let color = self.vertices.color(side, color_of as usize);
        let clip = self.vertices.clip[at].map(f64::from);
        self.in_window(clip, color, value_of(&self.vertices.tex_coords[0], at))
    }

    #[inline]
    fn in_window(&self, clip: [f64; 4], color: [f32; 4], texture: [f32; 4]) -> FeedbackVertex {
        let [x, y, depth] = self.window.place(clip);
        FeedbackVertex { x, y, depth, w: clip[3], color, texture }
    }

    /// The planes that some vertices lie beyond.
    fn planes(&self, any: u16) -> Vec<Plane> {
        let volume = [
            [1.0, 0.0, 0.0, 1.0],
            [-1.0, 0.0, 0.0, 1.0],
            [0.0, 1.0, 0.0, 1.0],
            [0.0, -1.0, 0.0, 1.0],
            self.state.scale().near_plane(),
            [0.0, 0.0, -1.0, 1.0],
        ];
        let beyond = |bit: u32| any >> bit & 1 == 1;
        let volume = (0..6).filter(|bit| beyond(*bit)).map(|bit| Plane::Clip(volume[bit as usize]));
        let user = self.state.planes().iter();
        let user = user.filter(|(number, _)| beyond(codes::FIRST_PLANE + number));
        volume.chain(user.map(|(_, plane)| Plane::Eye(*plane))).collect()
    }

    fn put_point(&mut self, vertex: u32, color_of: u32, side: usize) {
        if self.code(vertex) & (codes::OUTSIDE | codes::NOT_FINITE) == 0 {
            let placed = self.whole(vertex, color_of, side);
            self.buffer.put(&Feedback::Point(&placed));
        }
    }

    fn put_line(&mut self, ends: [u32; 2], colors_of: [u32; 2], side: usize, begins: bool) {
        let [a, b] = ends.map(|end| self.code(end));
        if a & b & codes::OUTSIDE != 0 || (a | b) & codes::NOT_FINITE != 0 {
            return;
        }
        let corners = [0, 1].map(|at| self.corner(ends[at], colors_of[at], side));
        let planes = self.planes(a | b);
        let Some(left) = clip_segment(corners, &planes, Plane::distance) else { return };
        let ends = left.map(|corner| self.placed(&corner));
        self.buffer.put(&if begins {
            Feedback::Line(&ends)
        } else {
            Feedback::ContinuedLine(&ends)
        });
    }

    /// A filled polygon in the colours of vertices on a side; what any of its corners lies beyond.
    fn fill(&mut self, corners: &[u32], any: u16, color_of: impl Fn(u32) -> (u32, usize)) {
        let (mut placed, mut polygon) =
            (std::mem::take(&mut self.placed), std::mem::take(&mut self.polygon));
        placed.clear();
        if any & codes::OUTSIDE == 0 {
            placed.extend(corners.iter().map(|&vertex| {
                let (color_of, side) = color_of(vertex);
                self.whole(vertex, color_of, side)
            }));
        } else {
            polygon.clear();
            polygon.extend(corners.iter().map(|&vertex| {
                let (color_of, side) = color_of(vertex);
                self.corner(vertex, color_of, side)
            }));
            clip_polygon(&mut polygon, &self.planes(any), Plane::distance);
            placed.extend(polygon.iter().map(|corner| self.placed(corner)));
        }
        if placed.len() >= 3 {
            self.buffer.put(&Feedback::Polygon(&placed));
        }
        (self.placed, self.polygon) = (placed, polygon);
    }
}

impl Visitor for FeedbackVisitor<'_> {
    fn point(&mut self, vertex: u32) {
        self.put_point(vertex, vertex, 0);
    }

    fn line(&mut self, ends: [u32; 2], begins: bool) {
        let colors_of = if self.state.is_flat() { [ends[1]; 2] } else { ends };
        self.put_line(ends, colors_of, 0, begins);
    }

    fn polygon(&mut self, corners: &[u32], provoking: u32, flagged: bool) {
        let Some((any, facing)) = shown(self.state, self.vertices, corners) else { return };
        let side = self.state.color_side(facing);
        let flat = self.state.is_flat();
        let color_of = |vertex: u32| if flat { provoking } else { vertex };
        let mode = self.state.mode(facing);
        if mode == gl::FILL {
            self.fill(corners, any, |vertex| (color_of(vertex), side));
            return;
        }
        let mut begins = true;
        for (number, &vertex) in corners.iter().enumerate() {
            if flagged && !self.vertices.edge_flag(vertex as usize) {
                continue;
            }
            if mode == gl::POINT {
                self.put_point(vertex, color_of(vertex), side);
            } else {
                let next = corners[(number + 1) % corners.len()];
                let colors_of = [color_of(vertex), color_of(next)];
                self.put_line([vertex, next], colors_of, side, begins);
                begins = false;
            }
        }
    }
}

/// Notes the vertices whose colours a [`FeedbackVisitor`] writes.
pub(crate) struct UsedVisitor<'a> {
    pub(crate) state: &'a DrawState,
    pub(crate) vertices: &'a Processed,
    pub(crate) used: &'a UsedVertices,
}

impl Visitor for UsedVisitor<'_> {
    fn point(&mut self, vertex: u32) {
        self.used.note(vertex);
    }

    fn line(&mut self, ends: [u32; 2], _begins: bool) {
        ends.into_iter().for_each(|end| self.used.note(end));
    }

    fn polygon(&mut self, corners: &[u32], provoking: u32, _flagged: bool) {
        if shown(self.state, self.vertices, corners).is_some() {
            corners.iter().for_each(|&vertex| self.used.note(vertex));
            self.used.note(provoking);
        }
    }
}
