//! Points, lines and triangles in the window: transformed and clipped to what the camera sees.
//!
//! Clipping goes by the six planes of the view volume in homogeneous coordinates of f64 (Sutherland
//! and Hodgman 1974), from the inside end of an edge to its outside end, so that two triangles get
//! the same bits where a shared edge leaves. What interpolates linearly over a triangle interpolates
//! linearly in clip coordinates: a new corner brings the weights of the triangle's own corners.

use glam::{DMat4, DVec3, DVec4};
use luxel_scene::{CLIP_VOLUME, Projection, Size};
use luxel_visibility::CullFaces;

/// A corner of what is left of a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InWindow {
    /// In pixels from the upper left.
    pub(crate) place: [f64; 2],
    /// Window depth, 0 near to 1 far.
    pub(crate) depth: f64,
    /// The fourth clip coordinate: the distance along the viewing axis, or 1 for parallel rays.
    pub(crate) w: f64,
    /// The weights of the primitive's own corners, which sum to 1.
    pub(crate) weights: [f64; 3],
}

/// A corner that is being clipped.
#[derive(Clone, Copy, Debug)]
struct InClip {
    clip: DVec4,
    weights: DVec3,
}

/// The way from view space into the window.
pub(crate) struct Clipper {
    clip_from_view: DMat4,
    size: [f64; 2],
    source: Vec<InClip>,
    target: Vec<InClip>,
}

impl Clipper {
    pub(crate) fn new(projection: &Projection, size: Size) -> Self {
        Self {
            clip_from_view: projection.clip_from_view(size),
            size: [f64::from(size.width), f64::from(size.height)],
            source: Vec::new(),
            target: Vec::new(),
        }
    }

    /// What is left of a point (one corner), a line (two) or a triangle (three), given in view
    /// space: as many corners, or a convex polygon of three to nine; nothing if it lies outside.
    pub(crate) fn clipped(&mut self, corners: &[DVec3], out: &mut Vec<InWindow>) {
        const WEIGHTS: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];
        out.clear();
        self.source.clear();
        for (corner, weights) in corners.iter().zip(WEIGHTS) {
            let clip = self.clip_from_view * corner.extend(1.0);
            self.source.push(InClip { clip, weights });
        }
        if !self.source.iter().all(|corner| corner.clip.is_finite()) {
            return;
        }
        for plane in CLIP_VOLUME {
            let distance = |corner: &InClip| plane.dot(corner.clip);
            if self.source.iter().all(|corner| distance(corner) >= 0.0) {
                continue;
            }
            self.target.clear();
            let count = self.source.len();
            // A line has one edge, and no way back.
            let edges = if corners.len() == 3 { count } else { count - 1 };
            for at in 0..count {
                let here = self.source[at];
                let from = distance(&here);
                if from >= 0.0 {
                    self.target.push(here);
                }
                if at < edges {
                    let next = self.source[(at + 1) % count];
                    let to = distance(&next);
                    if from >= 0.0 && to < 0.0 {
                        self.target.push(here.towards(&next, from / (from - to)));
                    } else if from < 0.0 && to >= 0.0 {
                        self.target.push(next.towards(&here, to / (to - from)));
                    }
                }
            }
            std::mem::swap(&mut self.source, &mut self.target);
            if self.source.len() < corners.len() {
                return;
            }
        }
        // A corner in the eye itself has no place in the window.
        if self.source.iter().all(|corner| corner.clip.w > 0.0) {
            out.extend(self.source.iter().map(|corner| corner.in_window(self.size)));
        }
    }
}

impl InClip {
    fn towards(&self, outside: &Self, t: f64) -> Self {
        Self {
            clip: self.clip + (outside.clip - self.clip) * t,
            weights: self.weights + (outside.weights - self.weights) * t,
        }
    }

    fn in_window(&self, [width, height]: [f64; 2]) -> InWindow {
        let DVec4 { x, y, z, w } = self.clip;
        // Rounding must not carry what is inside beyond the window's sides.
        let [x, y, z] = [x / w, y / w, z / w].map(|side| side.clamp(-1.0, 1.0));
        InWindow {
            place: [(x + 1.0) * 0.5 * width, (1.0 - y) * 0.5 * height],
            depth: (z + 1.0) * 0.5,
            w,
            weights: self.weights.to_array(),
        }
    }
}

/// Twice the area of a polygon in the window; positive if it runs clockwise to the eye.
pub(crate) fn twice_area(places: impl Iterator<Item = [f64; 2]> + Clone) -> f64 {
    let Some([x0, y0]) = places.clone().next() else { return 0.0 };
    let next = places.clone().skip(1);
    places.zip(next).map(|([ax, ay], [bx, by])| (ax - x0) * (by - y0) - (bx - x0) * (ay - y0)).sum()
}

/// Whether faces of this kind are left out.
pub(crate) fn is_culled(polygon: &[InWindow], cull: CullFaces) -> bool {
    let area = twice_area(polygon.iter().map(|corner| corner.place));
    match cull {
        CullFaces::None => false,
        CullFaces::Clockwise => area >= 0.0,
        CullFaces::CounterClockwise => area <= 0.0,
    }
}
