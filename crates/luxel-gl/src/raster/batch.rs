//! The primitives of one draw, set up.

use super::bitmap::Bitmap;
use super::framebuffer::Uses;
use super::image::PlacedImage;
use super::pieces::{Piece, Pieces, Shade};
use super::pipeline::Pipeline;
use super::shape::{LineEnds, Shape};
use crate::fragment::TextureStages;
use crate::texture::Target;
use crate::vertex::{Processed, WindowScale};
use luxel_math::SUBPIXELS;
use luxel_visibility::{LinearForms, PackedForms, ProjectiveForms};
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

/// What shades the fragments of a primitive: weights over the window, and the colours that they weigh.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prepared {
    pub(crate) forms: PackedForms,
    /// Red, green, blue, alpha of three corners.
    pub(crate) colors: [[f32; 4]; 3],
    /// Their fog coordinates.
    pub(crate) fog: [f32; 3],
    /// The first of its rows for textures, if the pipeline has any: secondary colours, then the coordinates of each
    /// stage.
    pub(crate) rows: u32,
    /// Whether nothing that its fragments take changes from corner to corner.
    pub(crate) is_even: bool,
}

/// One draw.
#[derive(Debug)]
pub(crate) struct Batch {
    pub(crate) pipeline: Arc<Pipeline>,
    /// Pixels of polygons: the pipeline's, within the viewport.
    pub(crate) polygon_region: [i32; 4],
    pub(crate) scale: WindowScale,
    pub(crate) vertices: Box<Processed>,
    pub(crate) bitmap: Option<Arc<Bitmap>>,
    pub(crate) image: Option<Box<PlacedImage>>,
    /// Counts the samples that pass.
    pub(crate) samples: Option<Arc<AtomicU64>>,
}

impl Batch {
    pub(crate) fn new(
        pipeline: Arc<Pipeline>,
        viewport: [i32; 4],
        scale: WindowScale,
        vertices: Box<Processed>,
    ) -> Self {
        let [l, b, r, t] = pipeline.region;
        let [left, bottom, right, top] = viewport;
        Self {
            polygon_region: [l.max(left), b.max(bottom), r.min(right), t.min(top)],
            pipeline,
            scale,
            vertices,
            bitmap: None,
            image: None,
            samples: None,
        }
    }

    /// Whether of all tests that of depth alone decides what is drawn; of polygons, or of others.
    pub(super) fn is_tested_by_depth_alone(&self, of_polygon: bool) -> bool {
        let pipeline = &*self.pipeline;
        pipeline.stencil.is_none()
            && self.samples.is_none()
            && !pipeline.is_mixing()
            && (pipeline.polygon_stipple.is_none() || !of_polygon)
    }

    /// Whether its fragments may be deferred: they mix with what is there, and none is counted. Without textures, shading
    /// costs no more than deferring.
    pub(super) fn may_defer(&self) -> bool {
        let pipeline = &*self.pipeline;
        pipeline.textures.is_some() && pipeline.is_mixing() && self.samples.is_none()
    }

    /// The planes that its fragments are tested by or written to.
    #[inline(always)]
    pub(super) fn uses(&self) -> Uses {
        // Images of depths and of stencil values are written whatever the tests are.
        let all = self.image.is_some();
        let Uses { color, depth, stencil } = self.pipeline.uses();
        Uses { color, depth: all || depth, stencil: all || stencil }
    }

    /// Takes a bitmap with its lower left corner at a pixel, in the colours of the batch's first vertex.
    pub(crate) fn put_bitmap(
        &mut self,
        bitmap: Arc<Bitmap>,
        corner: [i32; 2],
        depth: f32,
    ) -> Pieces {
        self.bitmap = Some(bitmap);
        Pieces::of_raster(self, Shape::Bitmap { corner, depth })
    }

    /// Takes an image, with what it lacks of colours and depth from the batch's first vertex.
    pub(crate) fn put_image(&mut self, image: PlacedImage, depth: f32) -> Pieces {
        self.image = Some(Box::new(image));
        Pieces::of_raster(self, Shape::Image { depth })
    }

    /// What the least and the greatest coordinates of a triangle are moved by, in steps of 1/256 pixel, so that its samples
    /// lie in the pixels from one to the other: with one sample those whose centres lie in its box.
    pub(super) fn reach_of_centres(&self) -> [i32; 2] {
        let centre = SUBPIXELS / 2;
        if self.pipeline.multisample.is_some() { [0, 0] } else { [centre - 1, -centre] }
    }

    /// The pixels that a shape may reach: left, bottom, right, top, the last two beyond.
    pub(super) fn bounds(&self, shape: &Shape) -> [i32; 4] {
        let (low, high, region) = match *shape {
            Shape::Triangle(triangle) => {
                let [low, high] = triangle.bounds();
                (low, high, self.polygon_region)
            }
            Shape::Line { line: LineEnds { places: [a, b], .. }, width, .. } => {
                // Columns of a wide line go up from it, or to the right.
                let wide = (width + 1) * SUBPIXELS;
                let low = [a[0].min(b[0]) - SUBPIXELS, a[1].min(b[1]) - SUBPIXELS];
                let high = [a[0].max(b[0]) + wide, a[1].max(b[1]) + wide];
                (low, high, self.pipeline.region)
            }
            // Pieces know the outline.
            Shape::Smooth { .. } => return self.polygon_region,
            Shape::Band { .. } | Shape::Disc { .. } => {
                let [l, b, r, t] = self.pipeline.region;
                let bounds = shape.figure().map(|figure| figure.bounds());
                let [left, bottom, right, top] = bounds.unwrap_or_default();
                return [left.max(l), bottom.max(b), right.min(r), top.min(t)];
            }
            Shape::Bitmap { corner, .. } => {
                let region = self.pipeline.region;
                let size = self.bitmap.as_ref().map_or([0; 2], |bitmap| bitmap.size());
                let reach = |axis: usize| {
                    let end = corner[axis].saturating_add(size[axis]).min(region[axis + 2]);
                    [corner[axis].max(region[axis]), end]
                };
                let ([left, right], [bottom, top]) = (reach(0), reach(1));
                return [left, bottom, right, top];
            }
            Shape::Image { .. } => {
                return self.image.as_ref().map_or([0; 4], |image| image.bounds());
            }
            Shape::Point { corner, side, .. } => {
                let low = corner.map(|at| at * SUBPIXELS);
                (low, low.map(|at| at + side * SUBPIXELS - 1), self.pipeline.region)
            }
        };
        let pixel = |steps: i32| steps.div_euclid(SUBPIXELS);
        [
            pixel(low[0]).max(region[0]),
            pixel(low[1]).max(region[1]),
            (pixel(high[0]) + 1).min(region[2]),
            (pixel(high[1]) + 1).min(region[3]),
        ]
    }

    /// Prepares what shades the fragments of a piece with its shape, in the place where it stays; its rows for textures are
    /// appended.
    pub(super) fn prepare(
        &self,
        piece: &Piece,
        shape: Option<&Shape>,
        rows: &mut Vec<PackedForms>,
        prepared: &mut Prepared,
    ) {
        let Shade { corners, flat, side } = piece.shade;
        let colors = corners.map(|corner| self.color(flat.unwrap_or(corner), side));
        let fog = corners.map(|corner| self.fog(corner));
        let row_values = |row: usize| corners.map(|corner| self.row_value(row, corner, flat, side));
        let of_both = |weights: &[[f32; 3]; 2]| {
            let [a, b] = weights.map(|weights| mixed(weights, colors));
            let [from, to] = weights.map(|[u, v, t]| fog[0] * u + fog[1] * v + fog[2] * t);
            ([a, b, b], [from, to, to])
        };
        match shape {
            None | Some(Shape::Triangle(_) | Shape::Smooth { .. }) => {
                if self.put_colors(prepared, colors, fog) {
                    let places = corners.map(|corner| self.homogeneous(corner));
                    prepared.weigh(&LinearForms::from_homogeneous(places));
                    self.put_rows(prepared, rows, row_values);
                }
            }
            Some(shape @ (Shape::Line { line, .. } | Shape::Band { line, .. })) => {
                let (colors, fog) = of_both(&line.weights);
                if !self.put_colors(prepared, colors, fog) {
                    return;
                }
                let places =
                    line.places.map(|end| end.map(|at| f64::from(at) / f64::from(SUBPIXELS)));
                let mut way = [places[1][0] - places[0][0], places[1][1] - places[0][1]];
                if matches!(shape, Shape::Line { .. }) {
                    way[1 - line.major()] = 0.0;
                }
                prepared.weigh_along(places[0], way, line.w);
                self.put_rows(prepared, rows, |row| {
                    let values = row_values(row);
                    let [from, to] = line.weights.map(|weights| mixed(weights, values));
                    [from, to, to]
                });
            }
            Some(shape) => {
                let weights = match shape {
                    Shape::Point { weights, .. } | Shape::Disc { weights, .. } => *weights,
                    _ => [1.0, 0.0, 0.0],
                };
                let (colors, fog) = of_both(&[weights; 2]);
                if self.put_colors(prepared, colors, fog) {
                    prepared.weigh_along([0.0; 2], [0.0; 2], [1.0; 2]);
                    self.put_rows(prepared, rows, |row| [mixed(weights, row_values(row)); 3]);
                }
            }
        }
    }

    /// Takes colours and fog coordinates of three corners; whether fragments interpolate any of their values.
    ///
    /// Differences are compared as they are interpolated, so that infinities aren't even.
    fn put_colors(&self, prepared: &mut Prepared, colors: [[f32; 4]; 3], fog: [f32; 3]) -> bool {
        (prepared.colors, prepared.fog) = (colors, fog);
        let is_even = |[a, b, c]: [f32; 3]| b - a == 0.0 && c - a == 0.0;
        let has_rows = self.pipeline.textures.is_some();
        prepared.is_even = !has_rows
            && (0..4).all(|channel| is_even(colors.map(|color| color[channel])))
            && (self.pipeline.fog.is_none() || is_even(fog));
        !prepared.is_even
    }

    /// Appends the rows for textures, of values at three corners.
    fn put_rows(
        &self,
        prepared: &mut Prepared,
        rows: &mut Vec<PackedForms>,
        values: impl Fn(usize) -> [[f32; 4]; 3],
    ) {
        prepared.rows = rows.len() as u32;
        let count = self.pipeline.textures.as_ref().map_or(0, TextureStages::rows);
        rows.extend((0..count).map(|row| ProjectiveForms::pack(&prepared.forms, values(row))));
    }

    /// What a vertex has in row `number`: its secondary colour, or texture coordinates, and what divides them.
    fn row_value(&self, number: usize, vertex: u32, flat: Option<u32>, side: u8) -> [f32; 4] {
        let mut stages = self.pipeline.textures.iter().flat_map(|textures| &textures.stages);
        match number.checked_sub(1) {
            None => {
                let [r, g, b, _] =
                    self.vertices.secondary(usize::from(side), flat.unwrap_or(vertex) as usize);
                [r, g, b, 1.0]
            }
            Some(place) => stages.nth(place).map_or([0.0; 4], |stage| {
                let [s, t, r, q] = self.vertices.tex_coords[stage.unit][vertex as usize];
                // Directions into a cube have no q.
                let is_cube = stage.texture.target == Target::Cube;
                [s, t, r, if is_cube { 1.0 } else { q }]
            }),
        }
    }

    /// Primary and secondary colour of a vertex together, which fragments clamp; with textures the primary one alone.
    pub(crate) fn color(&self, vertex: u32, side: u8) -> [f32; 4] {
        let (vertex, side) = (vertex as usize, usize::from(side));
        let primary = self.vertices.color(side, vertex);
        if self.pipeline.textures.is_some() {
            return primary;
        }
        let secondary = self.vertices.secondary(side, vertex);
        std::array::from_fn(|channel| primary[channel] + secondary[channel])
    }

    /// The fog coordinate of a vertex.
    pub(crate) fn fog(&self, vertex: u32) -> f32 {
        self.vertices.fog_coord.get(vertex as usize).copied().unwrap_or(0.0)
    }

    /// (x w, y w, w) of a vertex, in pixels of the window.
    fn homogeneous(&self, vertex: u32) -> [f64; 3] {
        let [x, y, _, w] = self.vertices.clip[vertex as usize].map(f64::from);
        let scaled = |value: f64, axis: usize| {
            let [half, centre] = [self.scale.half, self.scale.centre]
                .map(|of| f64::from(of[axis]) / f64::from(SUBPIXELS));
            value * half + centre * w
        };
        [scaled(x, 0), scaled(y, 1), w]
    }

    /// Bytes that it takes without pieces, about.
    pub(crate) fn bytes(&self) -> usize {
        size_of_val(self)
            + self.bitmap.as_ref().map_or(0, |bitmap| bitmap.bytes())
            + self.image.as_ref().map_or(0, |image| image.bytes())
            + self.vertices.bytes()
    }
}

/// The values of three vertices by weights.
fn mixed([u, v, t]: [f32; 3], [a, b, c]: [[f32; 4]; 3]) -> [f32; 4] {
    std::array::from_fn(|at| a[at] * u + b[at] * v + c[at] * t)
}

impl Prepared {
    /// Takes the weights of a triangle's corners.
    fn weigh(&mut self, forms: &LinearForms) {
        forms.pack(|_, row, values| self.forms[row] = values);
    }

    /// Takes the weights from a place of the window on a way, whatever lies across it: perspective between the values of w
    /// at both ends.
    fn weigh_along(&mut self, from: [f64; 2], way: [f64; 2], [w_from, w_to]: [f64; 2]) {
        let squared = way[0] * way[0] + way[1] * way[1];
        self.forms = PackedForms::default();
        if squared == 0.0 {
            self.forms[2][0] = 1.0;
        } else {
            // (1 - s) w_to and s w_from, which are (1 - s) / w_from and s / w_to but for a factor; s rises by `rise` a pixel.
            let rise = way.map(|part| part / squared);
            let before = from[0] * rise[0] + from[1] * rise[1];
            for axis in 0..2 {
                self.forms[axis] = [-w_to * rise[axis], w_from * rise[axis], 0.0, 0.0];
            }
            self.forms[2] = [w_to * (1.0 + before), -w_from * before, 0.0, 0.0];
        }
    }
}
