//! Which primitives are hits, and how deep they lie (OpenGL 1.5, section 5.2).
//!
//! A primitive that reaches into the clip volume and in front of the user's planes is one, unless its face is culled. Depths
//! are those of the part inside, clipped in f64 by [`luxel_pick::depths_in_volume`].

use super::{NameChange, SelectionMode};
use crate::primitive::{ClipCorner, Visitor, clip_polygon};
use crate::raster::{DrawState, polygon_area};
use crate::state::window::WindowTransform;
use crate::vertex::{Processed, codes};
use glam::DVec4;
use luxel_pick::depths_in_volume;

/// Records primitives, and changes names between them.
pub(crate) struct HitVisitor<'a> {
    state: &'a DrawState,
    vertices: &'a Processed,
    window: WindowTransform,
    selection: &'a mut SelectionMode,
    changes: std::iter::Peekable<std::vec::IntoIter<(u32, NameChange)>>,
    polygon: Vec<ClipCorner>,
}

impl<'a> HitVisitor<'a> {
    pub(crate) fn new(
        state: &'a DrawState,
        vertices: &'a Processed,
        window: WindowTransform,
        selection: &'a mut SelectionMode,
    ) -> Self {
        let changes = selection.take_waiting().into_iter().peekable();
        Self { state, vertices, window, selection, changes, polygon: Vec::new() }
    }

    /// Changes names after the last primitive.
    pub(crate) fn finish(mut self) {
        self.change_names(u32::MAX);
    }

    /// Changes names as they are at a vertex.
    #[inline]
    fn change_names(&mut self, vertex: u32) {
        while let Some((_, change)) = self.changes.next_if(|(before, _)| *before <= vertex) {
            self.selection.carry_out_waiting(change);
        }
    }

    /// A point, a line or a triangle.
    fn primitive(&mut self, corners: &[u32]) {
        let Some(any) = self.vertices.codes_if_seen(corners) else { return };
        let clip = |corner: &u32| self.vertices.clip[*corner as usize];
        let planes = self.state.planes();
        let beyond = planes.iter().any(|(number, _)| any >> (codes::FIRST_PLANE + number) & 1 == 1);
        if !beyond {
            let mut whole = [DVec4::ZERO; 3];
            for (whole, corner) in whole.iter_mut().zip(corners) {
                *whole = DVec4::from_array(clip(corner).map(f64::from));
            }
            self.part(&whole[..corners.len()]);
            return;
        }
        let mut polygon = std::mem::take(&mut self.polygon);
        polygon.clear();
        polygon.extend(
            corners.iter().enumerate().map(|(at, corner)| ClipCorner::new(clip(corner), at, false)),
        );
        let distance = |(_, plane): &(u32, [f64; 4]), corner: &ClipCorner| {
            let of_vertex = |vertex: &u32| -> f64 {
                let eye = self.vertices.eye[*vertex as usize];
                plane.iter().zip(eye).map(|(p, e)| p * f64::from(e)).sum()
            };
            corners.iter().zip(corner.weights).map(|(v, weight)| of_vertex(v) * weight).sum()
        };
        clip_polygon(&mut polygon, planes, distance);
        let place = |at: usize| DVec4::from_array(polygon[at].clip);
        match polygon.len() {
            0 => {}
            1 => self.part(&[place(0)]),
            2 => self.part(&[place(0), place(1)]),
            count => {
                for last in 2..count {
                    self.part(&[place(0), place(last - 1), place(last)]);
                }
            }
        }
        self.polygon = polygon;
    }

    fn part(&mut self, corners: &[DVec4]) {
        let mut volume = [DVec4::ZERO; 3];
        for (own, corner) in volume.iter_mut().zip(corners) {
            *own = corner.with_z(self.window.z_from_minus_w(corner.z, corner.w));
        }
        if let Some(depths) = depths_in_volume(&volume[..corners.len()]) {
            // The range of depths may run backwards.
            let [a, b] = depths.map(|depth| self.window.depth(depth));
            self.selection.hit([a.min(b), a.max(b)]);
        }
    }

    /// A polygon that may reach into the clip volume.
    #[inline(never)]
    fn filled(&mut self, corners: &[u32]) {
        let area = polygon_area(self.vertices, self.state.scale(), corners);
        if self.state.is_culled(self.state.side(area)) {
            return;
        }
        for pair in corners[1..].windows(2) {
            self.primitive(&[corners[0], pair[0], pair[1]]);
        }
    }
}

impl Visitor for HitVisitor<'_> {
    fn point(&mut self, vertex: u32) {
        self.change_names(vertex);
        self.primitive(&[vertex]);
    }

    fn line(&mut self, ends: [u32; 2], _: bool) {
        self.change_names(ends[0]);
        self.primitive(&ends);
    }

    #[inline]
    fn polygon(&mut self, corners: &[u32], _: u32, _: bool) {
        self.change_names(corners[0]);
        let code = |corner: &u32| self.vertices.codes[*corner as usize];
        let all = corners.iter().fold(u16::MAX, |all, corner| all & code(corner));
        if all & codes::OUTSIDE == 0 {
            self.filled(corners);
        }
    }
}
