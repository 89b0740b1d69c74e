//! Which primitives are hits, and how deep they lie (OpenGL 1.5, section 5.2).
//!
//! A primitive that reaches into the clip volume and in front of the user's planes is one, unless its face is culled. Depths
//! are those of the part inside, clipped in f64 by [`luxel_pick::depths_in_volume`].

use super::SelectionMode;
use crate::primitive::{ClipCorner, Visitor, clip_polygon};
use crate::raster::{DrawState, polygon_area};
use crate::state::attributes::Viewport;
use crate::vertex::{Processed, codes};
use glam::DVec4;
use luxel_pick::depths_in_volume;

/// Records primitives.
pub(crate) struct HitVisitor<'a> {
    state: &'a DrawState,
    vertices: &'a Processed,
    viewport: &'a Viewport,
    selection: &'a mut SelectionMode,
    /// The depths of everything so far: names don't change between vertices.
    depths: Option<[f64; 2]>,
}

/// Where clip coordinates lie in the window, in pixels, with their depth.
pub(crate) fn window_place(viewport: &Viewport, [x, y, z, w]: [f64; 4]) -> [f64; 3] {
    let area = viewport.area;
    let place = |value: f64, first: i32, length: i32| {
        f64::from(first) + (value / w + 1.0) * 0.5 * f64::from(length)
    };
    let depth = window_depth(viewport, ((z / w + 1.0) * 0.5).clamp(0.0, 1.0));
    [place(x, area.x, area.width), place(y, area.y, area.height), depth]
}

/// A depth from 0 to 1 in the range of `glDepthRange`.
fn window_depth(viewport: &Viewport, unit: f64) -> f64 {
    viewport.near + (viewport.far - viewport.near) * unit
}

impl<'a> HitVisitor<'a> {
    pub(crate) fn new(
        state: &'a DrawState,
        vertices: &'a Processed,
        viewport: &'a Viewport,
        selection: &'a mut SelectionMode,
    ) -> Self {
        Self { state, vertices, viewport, selection, depths: None }
    }

    /// A point, a line or a triangle.
    fn primitive(&mut self, corners: &[u32]) {
        let code = |corner: &u32| self.vertices.codes[*corner as usize];
        let all = corners.iter().map(code).fold(u16::MAX, |all, code| all & code);
        let any = corners.iter().map(code).fold(0, |any, code| any | code);
        if all & codes::OUTSIDE != 0 || any & codes::NOT_FINITE != 0 {
            return;
        }
        let planes = self.state.planes();
        let beyond = planes.iter().any(|(number, _)| any >> (codes::FIRST_PLANE + number) & 1 == 1);
        let mut polygon: Vec<ClipCorner> = corners
            .iter()
            .enumerate()
            .map(|(at, corner)| ClipCorner::new(self.vertices.clip[*corner as usize], at, false))
            .collect();
        if beyond {
            let distance = |(_, plane): &(u32, [f64; 4]), corner: &ClipCorner| {
                let of_vertex = |vertex: &u32| -> f64 {
                    let eye = self.vertices.eye[*vertex as usize];
                    plane.iter().zip(eye).map(|(p, e)| p * f64::from(e)).sum()
                };
                corners.iter().zip(corner.weights).map(|(v, weight)| of_vertex(v) * weight).sum()
            };
            clip_polygon(&mut polygon, planes, distance);
        }
        let clip: Vec<DVec4> =
            polygon.iter().map(|corner| DVec4::from_array(corner.clip)).collect();
        match *clip.as_slice() {
            [] => {}
            [_] | [_, _] => self.part(&clip),
            [first, ..] => {
                for pair in clip[1..].windows(2) {
                    self.part(&[first, pair[0], pair[1]]);
                }
            }
        }
    }

    fn part(&mut self, corners: &[DVec4]) {
        let Some(depths) = depths_in_volume(corners) else { return };
        let [a, b] = depths.map(|depth| window_depth(self.viewport, depth));
        let [low, high] = self.depths.unwrap_or([f64::INFINITY, f64::NEG_INFINITY]);
        self.depths = Some([low.min(a).min(b), high.max(a).max(b)]);
    }
}

impl Drop for HitVisitor<'_> {
    /// Hands the depths over.
    fn drop(&mut self) {
        if let Some(depths) = self.depths {
            self.selection.hit(depths);
        }
    }
}

impl Visitor for HitVisitor<'_> {
    fn point(&mut self, vertex: u32) {
        self.primitive(&[vertex]);
    }

    fn line(&mut self, ends: [u32; 2], _: bool) {
        self.primitive(&ends);
    }

    fn polygon(&mut self, corners: &[u32], _: u32, _: bool) {
        let area = polygon_area(self.vertices, self.state.scale(), corners);
        if self.state.is_culled(self.state.side(area)) {
            return;
        }
        for pair in corners[1..].windows(2) {
            self.primitive(&[corners[0], pair[0], pair[1]]);
        }
    }
}
