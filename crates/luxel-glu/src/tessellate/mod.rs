//! Polygons of any shape as triangles, or as the outlines of what is inside (GLU 1.3, chapter 5).
//!
//! Contours may cross themselves and each other; a rule says which winding numbers are inside. The steps, each a module:
//!
//! 1. `plane` projects the vertices along the polygon's normal onto a grid of whole numbers, so that all that follows is
//!    decided exactly.
//! 2. `arrangement` splits edges where they cross or touch, until they meet at ends only.
//! 3. `winding` finds the winding number on both sides of each edge, and keeps the edges between inside and outside.
//! 4. `triangles` cuts the inside into monotone pieces and these into triangles, in one sweep; `outlines` walks around
//!    it instead.
//!
//! The grid is 2^40 wide, much finer than floats: a vertex keeps the coordinates that it came with.

mod arrangement;
mod outlines;
mod plane;
mod triangles;
mod winding;

pub use winding::WindingRule;

use arrangement::Arrangement;

/// The callbacks of a tessellator (`gluTessCallback`). Handles are the caller's, of its own vertices.
pub trait Listener {
    /// Begins primitives of OpenGL's mode: triangles or line loops.
    fn begin(&mut self, mode: u32);
    /// Whether the edges that follow are of the outline; called only if [`wants_edge_flags`](Self::wants_edge_flags) is true.
    fn edge_flag(&mut self, is_outline: bool);
    /// Whether [`edge_flag`](Self::edge_flag) is of interest.
    fn wants_edge_flags(&self) -> bool;
    /// A vertex.
    fn vertex(&mut self, handle: usize);
    /// Ends what [`begin`](Self::begin) began.
    fn end(&mut self);
    /// An error, by GLU's number.
    fn error(&mut self, error: u32);
    /// The handle of a new vertex, where edges between four vertices cross: its coordinates, and how much it has of each
    /// vertex. `None` if there can't be one.
    fn combine(
        &mut self,
        coordinates: [f64; 3],
        vertices: [usize; 4],
        weights: [f32; 4],
    ) -> Option<usize>;
}

/// A vertex of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vertex {
    pub(crate) coordinates: [f64; 3],
    pub(crate) handle: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum State {
    Dormant,
    InPolygon,
    InContour,
}

/// Largest coordinate: `GLU_TESS_MAX_COORD`.
const MOST: f64 = 1.0e150;
const INVALID_ENUM: u32 = 100_900;
const INVALID_VALUE: u32 = 100_901;
const OUT_OF_MEMORY: u32 = 100_902;
const MISSING_BEGIN_POLYGON: u32 = 100_151;
const MISSING_BEGIN_CONTOUR: u32 = 100_152;
const MISSING_END_POLYGON: u32 = 100_153;
const MISSING_END_CONTOUR: u32 = 100_154;
const COORD_TOO_LARGE: u32 = 100_155;
const NEED_COMBINE_CALLBACK: u32 = 100_156;
const PROPERTY_WINDING_RULE: u32 = 100_140;
const PROPERTY_BOUNDARY_ONLY: u32 = 100_141;
const PROPERTY_TOLERANCE: u32 = 100_142;
const LINE_LOOP: u32 = 2;
const TRIANGLES: u32 = 4;

/// Why there is no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Failure {
    /// Edges cross, and the listener makes no vertices.
    NoCombine,
    /// So many crossings that memory doesn't hold them.
    TooMany,
}

/// A tessellator (`GLUtesselator`).
#[derive(Clone, Debug)]
pub struct Tessellator {
    rule: WindingRule,
    boundary_only: bool,
    tolerance: f64,
    normal: [f64; 3],
    state: State,
    contours: Vec<Vec<Vertex>>,
}

impl Default for Tessellator {
    fn default() -> Self {
        Self {
            rule: WindingRule::Odd,
            boundary_only: false,
            tolerance: 0.0,
            normal: [0.0; 3],
            state: State::Dormant,
            contours: Vec::new(),
        }
    }
}

impl Tessellator {
    /// `gluTessProperty`.
    pub fn set_property(&mut self, property: u32, value: f64, listener: &mut impl Listener) {
        match property {
            PROPERTY_WINDING_RULE => match WindingRule::from_number(value) {
                Some(rule) => self.rule = rule,
                None => listener.error(INVALID_VALUE),
            },
            PROPERTY_BOUNDARY_ONLY => self.boundary_only = value != 0.0,
            // There is none: vertices that are not equal are kept apart.
            PROPERTY_TOLERANCE if (0.0..=1.0).contains(&value) => self.tolerance = value,
            PROPERTY_TOLERANCE => listener.error(INVALID_VALUE),
            _ => listener.error(INVALID_ENUM),
        }
    }

    /// `gluGetTessProperty`; `None`, with an error, for properties that there are not.
    pub fn property(&self, property: u32, listener: &mut impl Listener) -> Option<f64> {
        match property {
            PROPERTY_WINDING_RULE => Some(self.rule.number()),
            PROPERTY_BOUNDARY_ONLY => Some(f64::from(self.boundary_only)),
            PROPERTY_TOLERANCE => Some(self.tolerance),
            _ => {
                listener.error(INVALID_ENUM);
                None
            }
        }
    }

    /// `gluTessNormal`: the direction that polygons are seen from; zeros to let it be found.
    pub fn set_normal(&mut self, normal: [f64; 3]) {
        self.normal = normal;
    }

    /// `gluTessBeginPolygon`.
    pub fn begin_polygon(&mut self, listener: &mut impl Listener) {
        self.go_to(State::Dormant, listener);
        self.contours.clear();
        self.state = State::InPolygon;
    }

    /// `gluTessBeginContour`.
    pub fn begin_contour(&mut self, listener: &mut impl Listener) {
        self.go_to(State::InPolygon, listener);
        self.contours.push(Vec::new());
        self.state = State::InContour;
    }

    /// `gluTessVertex`.
    pub fn vertex(&mut self, coordinates: [f64; 3], handle: usize, listener: &mut impl Listener) {
        self.go_to(State::InContour, listener);
        let bounded = coordinates.map(|x| if x.is_nan() { 0.0 } else { x.clamp(-MOST, MOST) });
        if bounded != coordinates {
            listener.error(COORD_TOO_LARGE);
        }
        if let Some(contour) = self.contours.last_mut() {
            contour.push(Vertex { coordinates: bounded, handle });
        }
    }

    /// `gluTessEndContour`.
    pub fn end_contour(&mut self, listener: &mut impl Listener) {
        self.go_to(State::InContour, listener);
        self.state = State::InPolygon;
    }

    /// `gluTessEndPolygon`: all output comes now.
    pub fn end_polygon(&mut self, listener: &mut impl Listener) {
        self.go_to(State::InPolygon, listener);
        self.state = State::Dormant;
        let contours = std::mem::take(&mut self.contours);
        if let Err(failure) = self.tessellate(&contours, listener) {
            listener.error(match failure {
                Failure::NoCombine => NEED_COMBINE_CALLBACK,
                Failure::TooMany => OUT_OF_MEMORY,
            });
        }
    }

    /// Closes or opens what the caller forgot, with an error for each.
    fn go_to(&mut self, wanted: State, listener: &mut impl Listener) {
        while self.state != wanted {
            let (next, error) = match (self.state, self.state < wanted) {
                (State::Dormant, _) => (State::InPolygon, MISSING_BEGIN_POLYGON),
                (State::InPolygon, true) => (State::InContour, MISSING_BEGIN_CONTOUR),
                (State::InPolygon, false) => (State::Dormant, MISSING_END_POLYGON),
                (State::InContour, _) => (State::InPolygon, MISSING_END_CONTOUR),
            };
            listener.error(error);
            match next {
                State::InPolygon if self.state == State::Dormant => self.contours.clear(),
                State::InContour => self.contours.push(Vec::new()),
                _ => {}
            }
            self.state = next;
        }
    }

    fn tessellate(
        &self,
        contours: &[Vec<Vertex>],
        listener: &mut impl Listener,
    ) -> Result<(), Failure> {
        let Some(plane) = plane::Plane::of(contours, self.normal) else { return Ok(()) };
        let arrangement = Arrangement::new(contours, &plane, listener)?;
        let boundary = winding::boundary(&arrangement, self.rule);
        if self.boundary_only {
            for outline in outlines::outlines(&arrangement, &boundary) {
                listener.begin(LINE_LOOP);
                for vertex in outline {
                    listener.vertex(arrangement.handle(vertex));
                }
                listener.end();
            }
            return Ok(());
        }
        let triangles = triangles::triangles(&arrangement, &boundary);
        if triangles.is_empty() {
            return Ok(());
        }
        let outline = outlines::edge_set(&boundary);
        let mut flag = None;
        listener.begin(TRIANGLES);
        for triangle in triangles {
            for corner in 0..3 {
                let (vertex, next) = (triangle[corner], triangle[(corner + 1) % 3]);
                let is_outline = outline.contains(&(vertex.min(next), vertex.max(next)));
                if listener.wants_edge_flags() && flag != Some(is_outline) {
                    listener.edge_flag(is_outline);
                    flag = Some(is_outline);
                }
                listener.vertex(arrangement.handle(vertex));
            }
        }
        listener.end();
        Ok(())
    }
}
