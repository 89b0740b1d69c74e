//! Feedback: a view as a stream of points, lines and polygons in the window, lit and clipped, as
//! feedback mode of OpenGL gives it (version 2.1, section 5.3).
//!
//! Colours are those that leave lighting at the corners (Gouraud), or for a polygon as a whole
//! (flat), through the view's exposure and tone curve: before texture and fog, which OpenGL applies to
//! fragments. A polygon that clipping cut
//! keeps its corners' colours interpolated in clip coordinates, that is, with perspective.

use super::primitives::{Clipper, InWindow, is_culled};
use crate::context::{Heard, ShadingContext};
use crate::frame::{RenderError, Renderer};
use crate::material::Corner;
use crate::shade::{LitTriangle, displayed};
use glam::DVec3;
use luxel_scene::{AlphaMode, Points, Size};
use luxel_view::{Interpolation, Shading, ShadingMode, View};
use luxel_visibility::{CoveragePolicy, Samples, TriangleOf};
use std::ops::Range;

/// A corner in the window, lit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedbackVertex {
    /// Pixels from the window's left.
    pub x: f64,
    /// Pixels from the window's top.
    pub y: f64,
    /// Window depth, 0 near to 1 far.
    pub depth: f64,
    /// The fourth clip coordinate: the distance along the viewing axis; 1 for parallel rays.
    pub w: f64,
    /// Linear red, green, blue, clamped to 0..1 unless the view says otherwise, and alpha.
    pub color: [f32; 4],
    /// Texture coordinates s, t, r, q of the first set; (0, 0, 0, 1) where there are none.
    pub texture: [f32; 4],
}

/// One item of the stream.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Feedback<'a> {
    /// A marker (`glPassThrough`). [`Renderer::feedback`] puts one before the primitives of each
    /// object: its number.
    PassThrough(f32),
    /// A point.
    Point(&'a FeedbackVertex),
    /// A line by itself, which begins a stipple pattern anew.
    Line(&'a [FeedbackVertex; 2]),
    /// A convex polygon: what clipping left of a triangle, in the order of its corners.
    Polygon(&'a [FeedbackVertex]),
}

/// What a feedback buffer holds of each corner: the `type` of `glFeedbackBuffer`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedbackType {
    /// `GL_2D`: x, y.
    TwoD,
    /// `GL_3D`: x, y, z.
    ThreeD,
    /// `GL_3D_COLOR`: x, y, z, and red, green, blue, alpha.
    ThreeDColor,
    /// `GL_3D_COLOR_TEXTURE`: these, and s, t, r, q.
    ThreeDColorTexture,
    /// `GL_4D_COLOR_TEXTURE`: x, y, z, w, red, green, blue, alpha, s, t, r, q.
    FourDColorTexture,
}

/// A buffer as `glFeedbackBuffer` fills it: tokens and values as `f32`, y from the window's bottom.
///
/// A polygon is the token 1795, the number of its corners, and the corners. Lines stand by
/// themselves, and so have the token 1799 (`GL_LINE_RESET_TOKEN`).
///
/// ```
/// use luxel_render::{Feedback, FeedbackBuffer, FeedbackType, FeedbackVertex};
/// use luxel_scene::Size;
///
/// let vertex =
///     FeedbackVertex { x: 3.0, y: 2.0, depth: 0.5, w: 1.0, color: [1.0; 4], texture: [0.0; 4] };
/// let size = Size { width: 10, height: 10 };
/// let mut buffer = FeedbackBuffer::new(FeedbackType::ThreeD, 100, size);
/// buffer.put(&Feedback::PassThrough(7.0));
/// buffer.put(&Feedback::Point(&vertex));
/// assert_eq!(buffer.values(), [1792.0, 7.0, 1793.0, 3.0, 8.0, 0.5]);
/// assert_eq!(buffer.count(), 6);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FeedbackBuffer {
    of: FeedbackType,
    room: usize,
    height: f64,
    values: Vec<f32>,
    overflowed: bool,
}

impl FeedbackBuffer {
    /// `GL_PASS_THROUGH_TOKEN`
    pub const PASS_THROUGH_TOKEN: f32 = 1792.0;
    /// `GL_POINT_TOKEN`
    pub const POINT_TOKEN: f32 = 1793.0;
    /// `GL_POLYGON_TOKEN`
    pub const POLYGON_TOKEN: f32 = 1795.0;
    /// `GL_LINE_RESET_TOKEN`
    pub const LINE_RESET_TOKEN: f32 = 1799.0;

    /// An empty buffer with room for `room` values, about a window of this size.
    #[must_use]
    pub fn new(of: FeedbackType, room: usize, window: Size) -> Self {
        let height = f64::from(window.height);
        Self { of, room, height, values: Vec::new(), overflowed: false }
    }

    /// Writes an item down; what there is no room for is lost, and [`FeedbackBuffer::count`] tells.
    pub fn put(&mut self, item: &Feedback<'_>) {
        match *item {
            Feedback::PassThrough(mark) => self.write(&[Self::PASS_THROUGH_TOKEN, mark]),
            Feedback::Point(vertex) => {
                self.write(&[Self::POINT_TOKEN]);
                self.vertex(vertex);
            }
            Feedback::Line(ends) => {
                self.write(&[Self::LINE_RESET_TOKEN]);
                ends.iter().for_each(|end| self.vertex(end));
            }
            Feedback::Polygon(corners) => {
                self.write(&[Self::POLYGON_TOKEN, corners.len() as f32]);
                corners.iter().for_each(|corner| self.vertex(corner));
            }
        }
    }

    fn vertex(&mut self, vertex: &FeedbackVertex) {
        let FeedbackVertex { x, y, depth, w, color, texture } = vertex;
        let place = [*x, self.height - y, *depth, *w].map(|value| value as f32);
        match self.of {
            FeedbackType::TwoD => self.write(&place[..2]),
            FeedbackType::ThreeD => self.write(&place[..3]),
            FeedbackType::ThreeDColor => {
                self.write(&place[..3]);
                self.write(color);
            }
            FeedbackType::ThreeDColorTexture => {
                self.write(&place[..3]);
                self.write(color);
                self.write(texture);
            }
            FeedbackType::FourDColorTexture => {
                self.write(&place);
                self.write(color);
                self.write(texture);
            }
        }
    }

    fn write(&mut self, values: &[f32]) {
        let fits = values.len().min(self.room - self.values.len());
        self.values.extend_from_slice(&values[..fits]);
        self.overflowed |= fits < values.len();
    }

    /// The values that had room.
    #[must_use]
    pub fn values(&self) -> &[f32] {
        &self.values
    }

    /// How many values there are, or -1 if there was no room for all: what `glRenderMode` gives.
    #[must_use]
    pub fn count(&self) -> i64 {
        if self.overflowed { -1 } else { self.values.len() as i64 }
    }
}

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
        self.with_scene(
            &view,
            CoveragePolicy::SOLID,
            Some(Samples::ONE),
            Heard::NOTHING,
            |scene, _| {
                Stream::new(scene, &view).tell(&mut take);
            },
        )
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
            for object in of.objects.clone() {
                take(&Feedback::PassThrough(object as f32));
                let section = mesh.range_of(placed.objects()[object].section);
                self.triangles(instance, &section.triangles, take);
                for (stroke, _) in strokes.iter().filter(|(_, of)| of.objects.start == object) {
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
