//! Feedback: a view as a stream of points, lines and polygons in the window, lit and clipped, as
//! feedback mode of OpenGL gives it (version 2.1, section 5.3).
//!
//! Colours are those that leave lighting at the corners (Gouraud), or for a polygon as a whole
//! (flat), through the view's exposure and tone curve: before texture and fog, which OpenGL applies to
//! fragments. A polygon that clipping cut
//! keeps its corners' colours interpolated in clip coordinates, that is, with perspective.

use super::primitives::{Clipper, InWindow, is_culled};
use crate::context::ShadingContext;
use crate::frame::{FrameNeeds, RenderError, Renderer};
use crate::material::Corner;
use crate::shade::{LitTriangle, displayed};
use glam::DVec3;
use luxel_pick::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
use luxel_scene::{AlphaMode, Points};
use luxel_view::{Interpolation, Shading, ShadingMode, View};
use luxel_visibility::{CoveragePolicy, Samples, TriangleOf};
use std::ops::Range;

impl Renderer {
    /// Gives the primitives of a view, lit and clipped, in the order of the scene: for each object
    /// its marker, its triangles in the file's order, then its points and lines. Nothing is hidden
    /// by anything; faces that the view culls are left out.
    ///
    /// Light is computed at the corners, in flat shading ([`ShadingMode::Flat`]) once a polygon.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn feedback(
        &self,
        view: &View,
        mut take: impl FnMut(&Feedback<'_>) + Send,
    ) -> Result<(), RenderError> {
        let mode = match view.shading.mode {
            ShadingMode::Flat => ShadingMode::Flat,
            _ => ShadingMode::Gouraud,
        };
        let shading = Shading { mode, interpolation: Interpolation::Perspective, ..view.shading };
        let view = view.clone().with_shading(shading).with_edges(None);
        let needs = FrameNeeds {
            coverage: CoveragePolicy::SOLID,
            samples: Some(Samples::ONE),
            ..FrameNeeds::PICTURE
        };
        self.with_scene(&view, &needs, |scene, _| {
            Stream::new(scene, &view).tell(&mut take);
        })
    }

    /// [`Renderer::feedback`], into a buffer with room for `room` values.
    ///
    /// # Errors
    /// [`RenderError`] if the view asks for something impossible.
    pub fn feedback_buffer(
        &self,
        view: &View,
        of: FeedbackType,
        room: usize,
    ) -> Result<FeedbackBuffer, RenderError> {
        let mut buffer = FeedbackBuffer::new(of, room, view.size);
        self.feedback(view, |item| buffer.put(item))?;
        Ok(buffer)
    }
}

/// What turns a frame's instances into items.
struct Stream<'a> {
    scene: &'a ShadingContext<'a>,
    clipper: Clipper,
    clipped: Vec<InWindow>,
    vertices: Vec<FeedbackVertex>,
}

impl<'a> Stream<'a> {
    fn new(scene: &'a ShadingContext<'a>, view: &View) -> Self {
        Self {
            scene,
            clipper: Clipper::new(&view.camera.projection, view.size),
            clipped: Vec::new(),
            vertices: Vec::new(),
        }
    }

    fn tell(&mut self, take: &mut dyn FnMut(&Feedback<'_>)) {
        let ShadingContext { placed, frame, .. } = *self.scene;
        // Triangles come first; points and lines of some objects come after them all.
        let (faces, strokes): (Vec<_>, Vec<_>) =
            (0..).zip(placed.instances()).partition(|(_, of)| of.strokes.is_none());
        for (instance, of) in faces {
            let mesh = frame.instances()[instance].mesh;
            for object in of.objects() {
                take(&Feedback::PassThrough(object as f32));
                let section = mesh.range_of(placed.objects()[object].section);
                self.triangles(instance, &section.triangles, take);
                for (stroke, _) in strokes.iter().filter(|(_, of)| of.first_object() == object) {
                    self.strokes(*stroke, &mesh.points, take);
                }
            }
        }
    }

    fn triangles(
        &mut self,
        instance: usize,
        of_object: &Range<u32>,
        take: &mut dyn FnMut(&Feedback<'_>),
    ) {
        let frame = self.scene.frame;
        let mesh = frame.instances()[instance].mesh;
        let part = mesh.parts.partition_point(|run| run.first + run.count <= of_object.start);
        for (part, run) in (part..).zip(&mesh.parts[part..]) {
            let (first, end) = (run.first, run.first + run.count);
            if first >= of_object.end {
                break;
            }
            for triangle in first.max(of_object.start)..end.min(of_object.end) {
                let of = TriangleOf { instance, triangle, part };
                self.clipper.clipped(&frame.corners_in_view(of), &mut self.clipped);
                if self.clipped.is_empty() || is_culled(&self.clipped, frame.use_of(of).cull) {
                    continue;
                }
                self.light(of, None);
                take(&Feedback::Polygon(&self.vertices));
            }
        }
    }

    /// Points and lines, which the frame holds as two triangles each, facing the eye: their middle
    /// lines, lit as the triangles are.
    fn strokes(&mut self, instance: usize, points: &[Points], take: &mut dyn FnMut(&Feedback<'_>)) {
        let frame = self.scene.frame;
        let mesh = frame.instances()[instance].mesh;
        for (part, run) in mesh.parts.iter().enumerate() {
            for triangle in (run.first..run.first + run.count).step_by(2) {
                let of = TriangleOf { instance, triangle, part };
                let [a, b, c] = frame.corners_in_view(of);
                let [.., d] = frame.corners_in_view(TriangleOf { triangle: triangle + 1, ..of });
                let middle = |p: DVec3, q: DVec3| (p + q) * 0.5;
                // The parts of points come before those of lines.
                let [from, to] = [middle(a, d), middle(b, c)];
                let places = if part < points.len() {
                    let place = middle(from, to);
                    self.clipper.clipped(&[place], &mut self.clipped);
                    [place; 3]
                } else {
                    self.clipper.clipped(&[from, to], &mut self.clipped);
                    [from, to, to]
                };
                if self.clipped.is_empty() {
                    continue;
                }
                self.light(of, Some(places));
                match self.vertices.as_slice() {
                    [point] => take(&Feedback::Point(point)),
                    &[from, to] => take(&Feedback::Line(&[from, to])),
                    _ => {}
                }
            }
        }
    }

    /// Lights the corners that are left of a triangle, or of what it stands for, at its places.
    fn light(&mut self, of: TriangleOf, places: Option<[DVec3; 3]>) {
        let corners = LitTriangle::lit_corners(self.scene, of, places);
        let mesh = self.scene.frame.instances()[of.instance].mesh;
        let material = &self.scene.scene.materials[mesh.parts[of.part].material.index()];
        let has_color = !mesh.colors.is_empty() && material.vertex_colors;
        let alpha = |corner: &Corner| match material.alpha_mode {
            AlphaMode::Blend if has_color => material.opacity * corner.color[3],
            AlphaMode::Blend => material.opacity,
            _ => 1.0,
        };
        self.vertices.clear();
        for &InWindow { place: [x, y], depth, w, weights } in &self.clipped {
            let mixed = |value: &dyn Fn(&Corner) -> f32| -> f32 {
                let parts = weights.iter().zip(&corners);
                parts.map(|(weight, corner)| weight * f64::from(value(corner))).sum::<f64>() as f32
            };
            let [r, g, b] = [0, 1, 2].map(|channel| mixed(&|corner| corner.light[channel]));
            let mut color = [r, g, b, mixed(&alpha)];
            if let Some(display) = &self.scene.display {
                color = displayed(display, &color);
            }
            let [s, t] = [0, 1].map(|axis| mixed(&|corner| corner.uv[0][axis]));
            self.vertices.push(FeedbackVertex { x, y, depth, w, color, texture: [s, t, 0.0, 1.0] });
        }
    }
}
