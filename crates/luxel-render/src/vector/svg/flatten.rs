//! Shaded faces into pieces of one colour.
//!
//! A piece's colours are looked at where the picture would look: its corners, the middles of its
//! edges and its own middle are lit as pixels there are. Where they are not what interpolating
//! between the corners gives, the piece is halved; then it is cut along lines of equal intensity, the
//! same levels everywhere, so that the bands of neighbours meet.

use super::web::{Color, Corner, Place, Polygon, Web};
use crate::context::ShadingContext;
use crate::interpolate::Batch;
use crate::shade::{ThreadCache, shade};
use crate::subdivision::encoded;
use crate::vector::primitives::twice_area;
use luxel_lighting::Silent;
use luxel_math::{LANES, Level, SUBPIXELS, Simd, dispatch_long, f32x16, prelude::*};
use luxel_scene::AlphaMode;
use luxel_visibility::{TILE, TriangleId, TriangleOf};

/// Pieces narrower than this, in pixels, are lit once, in their middle, if they are short.
const NARROW: f64 = 0.5;
/// How long a narrow piece may be.
const SHORT: f64 = 3.0;
/// How often a piece is halved at most.
const DEEPEST: u32 = 24;

/// The part of the tolerance that interpolation may take; the rest is for what is painted in one
/// colour.
const INTERPOLATED: f32 = 0.25;

/// How far apart the colours of what is painted in one may be: twice what the tolerance leaves.
pub(super) fn largest_range(tolerance: f32) -> f32 {
    2.0 * (1.0 - INTERPOLATED) * tolerance
}

/// A convex polygon of nearly one colour.
pub(super) struct Piece {
    pub(super) polygon: Polygon,
    /// The least and the greatest of each channel at its corners.
    pub(super) low: Color,
    pub(super) high: Color,
    /// The face that it is part of.
    pub(super) face: u32,
}

/// Lights places of triangles as pixels there would be lit.
pub(super) struct Sampler<'a> {
    scene: &'a ShadingContext<'a>,
    level: Level,
    kept: ThreadCache,
}

impl<'a> Sampler<'a> {
    pub(super) fn new(scene: &'a ShadingContext<'a>, level: Level) -> Self {
        Self { scene, level, kept: ThreadCache::new() }
    }

    /// Colours at up to sixteen places of a triangle, in steps of 8 bits.
    fn colors(&mut self, id: TriangleId, places: &[Place]) -> [Color; LANES] {
        let tile = |side: f64| (side / f64::from(TILE)).floor() as i32 * TILE;
        let mut batch = Batch::nothing(places.first().map_or([0; 2], |place| place.map(tile)));
        for (lane, place) in places.iter().enumerate().take(LANES) {
            batch.ids[lane] = id.0;
            batch.x[lane] = (place[0] - f64::from(batch.tile[0])) as f32;
            batch.y[lane] = (place[1] - f64::from(batch.tile[1])) as f32;
        }
        let Self { scene, level, kept } = self;
        let lit = dispatch_long!(*level, simd => lit(simd, scene, &batch, kept));
        let encoding = scene.encoding;
        let mut colors = [[0.0; 4]; LANES];
        for (lane, color) in colors.iter_mut().enumerate().take(places.len()) {
            let [r, g, b, alpha] = [0, 1, 2, 3].map(|channel| lit[channel][lane]);
            let [r, g, b] = [r, g, b].map(|light| 255.0 * encoded(encoding, light));
            *color = [r, g, b, 255.0 * alpha.clamp(0.0, 1.0)];
        }
        colors
    }

    /// Whether the surface isn't there: cut away by a texture's alpha.
    fn is_hole(&self, of: TriangleOf, place: Place) -> bool {
        let frame = self.scene.frame;
        let mesh = frame.instances()[of.instance].mesh;
        let material = &self.scene.scene.materials[mesh.parts[of.part].material.index()];
        let steps = place.map(|side| (side * f64::from(SUBPIXELS)).round() as i32);
        let barycentric = frame.forms(of).exact_barycentric(frame.rays(), steps);
        self.scene.scene.is_hole(mesh, of.triangle, barycentric, material)
    }
}

#[inline(always)]
fn lit<S: Simd>(
    simd: S,
    scene: &ShadingContext<'_>,
    batch: &Batch,
    kept: &mut ThreadCache,
) -> [[f32; LANES]; 4] {
    let lit = shade(f32x16::splat(simd, 0.0), scene, batch, kept, &mut Silent);
    let mut stored = [[0.0; LANES]; 4];
    for (stored, channel) in stored.iter_mut().zip(lit) {
        channel.store_slice(stored);
    }
    stored
}

/// Cuts faces into pieces.
pub(super) struct Flattener<'a, 'w> {
    pub(super) web: &'w mut Web,
    pub(super) sampler: Sampler<'a>,
    pub(super) tolerance: f32,
    pub(super) pieces: Vec<Piece>,
    /// The most pieces.
    pub(super) limit: usize,
}

/// The triangle that is being cut.
#[derive(Clone, Copy)]
struct Source {
    id: TriangleId,
    of: TriangleOf,
    face: u32,
    masked: bool,
}

impl Flattener<'_, '_> {
    /// Cuts a polygon of a face; whether there was room for all of its pieces.
    pub(super) fn flatten(&mut self, face: u32, id: TriangleId, polygon: Polygon) -> bool {
        let frame = self.sampler.scene.frame;
        let Some(of) = frame.triangle(id) else { return true };
        let mesh = frame.instances()[of.instance].mesh;
        let material = &self.sampler.scene.scene.materials[mesh.parts[of.part].material.index()];
        let masked = matches!(material.alpha_mode, AlphaMode::Mask { .. });
        self.divide(Source { id, of, face, masked }, polygon, 0);
        self.pieces.len() < self.limit
    }

    fn middle(&self, polygon: &[Corner]) -> Place {
        let share = 1.0 / polygon.len() as f64;
        self.web
            .places(polygon)
            .fold([0.0; 2], |[x, y], place| [x + place[0] * share, y + place[1] * share])
    }

    fn divide(&mut self, source: Source, mut polygon: Polygon, depth: u32) {
        if self.pieces.len() >= self.limit {
            return;
        }
        let [left, top, right, bottom] = super::convex::bounds(self.web.places(&polygon));
        let middle = self.middle(&polygon);
        let (across, down) = (right - left, bottom - top);
        let length = (across * across + down * down).sqrt();
        let width = twice_area(self.web.places(&polygon)) / length;
        let narrow = width < NARROW;
        if narrow && length > SHORT && depth < DEEPEST {
            self.halve_longest(source, &polygon, depth);
            return;
        }
        if narrow {
            let [color, ..] = self.sampler.colors(source.id, &[middle]);
            for corner in &mut polygon {
                corner.color = color;
            }
            if !(source.masked && self.sampler.is_hole(source.of, middle)) {
                self.keep(source.face, polygon);
            }
            return;
        }
        // Corners, middles of edges and the middle take sixteen lanes at seven corners.
        let count = polygon.len();
        if count > 7 {
            self.fan(source, &polygon, depth);
            return;
        }
        let mut places: Vec<Place> = self.web.places(&polygon).collect();
        for at in 0..count {
            let ([ax, ay], [bx, by]) = (places[at], places[(at + 1) % count]);
            places.push([(ax + bx) * 0.5, (ay + by) * 0.5]);
        }
        places.push(middle);
        let colors = self.sampler.colors(source.id, &places);
        for (corner, color) in polygon.iter_mut().zip(colors) {
            corner.color = color;
        }
        let may = depth < DEEPEST;
        if source.masked {
            let holes = places.iter().filter(|&&place| self.sampler.is_hole(source.of, place));
            let holes = holes.count();
            if holes == places.len() {
                return;
            }
            if holes > 0 && may {
                self.halve_longest(source, &polygon, depth);
                return;
            }
            if holes * 2 > places.len() {
                return;
            }
        }
        let apart = |color: &Color, [a, b]: [&Color; 2]| {
            (0..4).fold(0.0_f32, |most, channel| {
                most.max((color[channel] - (a[channel] + b[channel]) * 0.5).abs())
            })
        };
        let mut worst = (0.0_f32, 0);
        for at in 0..count {
            let ends = [&colors[at], &colors[(at + 1) % count]];
            let error = apart(&colors[count + at], ends);
            if error > worst.0 {
                worst = (error, at);
            }
        }
        let share = 1.0 / count as f32;
        let mean: Color =
            std::array::from_fn(|at| colors[..count].iter().map(|color| color[at] * share).sum());
        let inside = apart(&colors[2 * count], [&mean, &mean]);
        let allowed = self.tolerance * INTERPOLATED;
        if worst.0.max(inside) <= allowed || !may {
            self.cut_at_levels(source, polygon, 0);
        } else if count > 3 {
            self.fan(source, &polygon, depth);
        } else if worst.0 > allowed {
            self.halve(source, &polygon, worst.1, depth);
        } else {
            self.halve_longest(source, &polygon, depth);
        }
    }

    /// Into triangles around the first corner.
    fn fan(&mut self, source: Source, polygon: &[Corner], depth: u32) {
        for at in 2..polygon.len() {
            let corners = [polygon[0], polygon[at - 1], polygon[at]];
            let points = corners.map(|corner| corner.point);
            let mut triangle =
                self.web.between_points(&points, &corners.map(|corner| corner.color));
            triangle[1].line = corners[1].line;
            if at == 2 {
                triangle[0].line = polygon[0].line;
            }
            if at == polygon.len() - 1 {
                triangle[2].line = polygon[at].line;
            }
            self.divide(source, triangle, depth);
        }
    }

    fn halve_longest(&mut self, source: Source, polygon: &[Corner], depth: u32) {
        let places: Vec<Place> = self.web.places(polygon).collect();
        let length = |at: usize| {
            let ([ax, ay], [bx, by]) = (places[at], places[(at + 1) % places.len()]);
            (bx - ax) * (bx - ax) + (by - ay) * (by - ay)
        };
        let longest = (0..places.len()).max_by(|&a, &b| length(a).total_cmp(&length(b)));
        self.halve(source, polygon, longest.unwrap_or(0), depth);
    }

    /// At the middle of an edge.
    fn halve(&mut self, source: Source, polygon: &[Corner], edge: usize, depth: u32) {
        let places: Vec<Place> = self.web.places(polygon).collect();
        let count = places.len();
        let ([ax, ay], [bx, by]) = (places[edge], places[(edge + 1) % count]);
        let [mx, my] = [(ax + bx) * 0.5, (ay + by) * 0.5];
        // Towards the corner across, or straight across where there are several.
        let (dx, dy) = if count == 3 {
            let [cx, cy] = places[(edge + 2) % 3];
            (cx - mx, cy - my)
        } else {
            (ay - by, bx - ax)
        };
        let values: Vec<f64> = places
            .iter()
            .enumerate()
            .map(|(at, &[x, y])| {
                let across = count == 3 && at == (edge + 2) % 3;
                if across { 0.0 } else { dx * (y - my) - dy * (x - mx) }
            })
            .collect();
        let parts = self.web.cut(polygon, &values);
        if parts.iter().any(Vec::is_empty) {
            self.keep(source.face, polygon.to_vec());
            return;
        }
        for part in parts {
            self.divide(source, part, depth + 1);
        }
    }

    /// Cuts a polygon, over which colours are linear, at levels of the channel that differs most.
    fn cut_at_levels(&mut self, source: Source, polygon: Polygon, depth: u32) {
        // Half of what may be painted in one, so that there is room for joining neighbours.
        let step = largest_range(self.tolerance) * 0.5;
        let (low, high) = range(&polygon);
        let channel =
            (0..4).max_by(|&a, &b| (high[a] - low[a]).total_cmp(&(high[b] - low[b]))).unwrap_or(0);
        if high[channel] - low[channel] <= step || depth >= 64 {
            self.keep(source.face, polygon);
            return;
        }
        let level = ((low[channel] + high[channel]) * 0.5 / step).round() * step;
        let values: Vec<f64> =
            polygon.iter().map(|corner| f64::from(corner.color[channel] - level)).collect();
        let parts = self.web.cut(&polygon, &values);
        if parts.iter().any(Vec::is_empty) {
            self.keep(source.face, polygon);
            return;
        }
        for part in parts {
            self.cut_at_levels(source, part, depth + 1);
        }
    }

    fn keep(&mut self, face: u32, polygon: Polygon) {
        let (low, high) = range(&polygon);
        // What is wholly transparent isn't there.
        if high[3] >= 0.5 {
            self.pieces.push(Piece { polygon, low, high, face });
        }
    }
}

/// The least and the greatest of each channel.
fn range(polygon: &[Corner]) -> (Color, Color) {
    let nothing = ([f32::INFINITY; 4], [f32::NEG_INFINITY; 4]);
    polygon.iter().fold(nothing, |(low, high), corner| {
        (
            std::array::from_fn(|at| low[at].min(corner.color[at])),
            std::array::from_fn(|at| high[at].max(corner.color[at])),
        )
    })
}
